// Which edge a corner bears on.
#include "dynamic_relaxation/contact/contacts.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace delabole {
namespace {

using relaxation_scenes::density;
using relaxation_scenes::fixed_block;
using relaxation_scenes::joint;

// A tip of 21 deg that points upwards, its right side short, and a corner that stands on the left side, beside the
// middle of the right one and a tenth of a millimetre deep.
RelaxationScene corner_beside_tip(double level) {
    RelaxationScene scene;
    const PlanePoint<> on_left(level * 0.3 + 1e-4, level);
    scene.block.push_back({{on_left, on_left + PlanePoint<>(0.2, 1.98), on_left + PlanePoint<>(-0.6, 1.9)}, density});
    scene.block.push_back(fixed_block({{0, 0}, {-0.9, -3}, {0.2, -3}, {0.02, -0.23}}));
    scene.material = {joint(1e9, degrees(30))};
    return scene;
}

double weight_on(const RelaxationScene& scene, std::uint32_t corner, std::uint32_t edge) {
    const Bodies bodies = make_bodies(scene);
    const std::vector<Motion> motion(bodies.size());
    const ContactList list =
        find_contacts(scene, bodies, motion, std::vector<char>(bodies.size(), 0), {0.002, 0.2, false, {}}, {});
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const RelaxationContact contact = list.contact[index];
        if (contact.corner == corner && contact.edge == edge) {
            return list.memory[index].yields
                       ? 0
                       : contact_weight(list.law_of(contact), contact, locate(contact, motion[0], motion[1]), false);
        }
    }
    return 0;
}

TEST(Contacts, CornerBearsOnTheSideOfATipThatItIsLessDeepInWhicheverEndIsNearer) {
    // The tip is 4 cm thick there: on the far side the corner would be four hundred times as deep.
    for (const double level : {-0.11, -0.114, -0.116, -0.12}) {
        const RelaxationScene scene = corner_beside_tip(level);
        EXPECT_EQ(weight_on(scene, 0, 3), 1) << level;
        EXPECT_LE(weight_on(scene, 0, 6), 0) << level;
    }
}

// A flat triangle on a block that ends in the triangle's obtuse corner, as where a joint daylights in a face at an
// acute angle. As the triangle slides and turns, the block's corner stays on that side of it.
RelaxationScene flat_triangle() {
    RelaxationScene scene;
    scene.block.push_back({{{112.3, 194.5}, {133.0, 219.1}, {144.0, 249.4}}, density});
    scene.block.push_back(fixed_block({{0, 0}, {94.0, 112.0}, {133.0, 219.1}, {112.3, 194.5}}));
    scene.material = {joint(1e9, degrees(30))};
    return scene;
}

TEST(Contacts, BearOnNoEdgeOnTheOtherSideOfAThinBlock) {
    const RelaxationScene scene = flat_triangle();
    const Bodies bodies = make_bodies(scene);
    for (const double slides : {0.0, 0.005, 0.02, 0.05}) {
        for (const double turns : {-0.02, -0.005, -1e-4, 0.0, 1e-4, 0.005, 0.02}) {
            std::vector<Motion> motion(bodies.size());
            const PlanePoint<> down = PlanePoint<>(-20.7, -24.6).normalized();
            motion[0].x = slides * down.x();
            motion[0].y = slides * down.y();
            motion[0].set_angle(turns);
            const ContactList list = find_contacts(scene, bodies, motion, {0, 0}, {0.1, 0.2, false, {}}, {});
            for (std::size_t index = 0; index < list.contact.size(); ++index) {
                const RelaxationContact contact = list.contact[index];
                const double gap = locate(contact, motion[contact.block], motion[contact.other]).gap;
                // A turn by 0.02 lets the triangle, 30 m from its centroid to its tip, overlap by 0.6 m; it is 5.6 m
                // thick.
                EXPECT_TRUE(gap > -1 || list.memory[index].beneath)
                    << slides << " m, " << turns << ": corner " << contact.corner << " on edge " << contact.edge;
            }
        }
    }
}

// A corner that begins to bear, half its weight on the twin's, on a joint with cohesion.
double shear_energy_of_new_contact(const PlanePoint<>& velocity) {
    RelaxationContact contact{};
    contact.along_x = -1;
    contact.from_start = contact.to_end = 1;
    ContactLaw law{};
    law.start_weight = law.end_weight = 0.5;
    law.inverse_blend = 100;
    law.normal_stiffness = law.shear_stiffness = 1e9;
    law.cohesion = law.residual_cohesion = 1e6;
    constexpr double step = 1e-4;
    Motion block;
    block.y = -1e-9;
    block.vx = velocity.x();
    block.vy = velocity.y();
    ContactMemory memory{};
    double open_by = 0;
    advance_contact(law, contact, TwinThatTouches{1e-9, 1e-5}, block, Motion{}, step, memory, open_by);
    EXPECT_TRUE(memory.touching);
    return elastic_energy(law, contact, memory, locate(contact, block, Motion{}));
}

TEST(Contacts, TakeOverTheShearOfATwinWhereTheyComeAlongTheEdgeAlone) {
    const double of_twin = 1e9 * 1e-5 * 1e-5 / 2;
    EXPECT_NEAR(shear_energy_of_new_contact({0.01, 0}), of_twin, 1e-6 * of_twin);
    EXPECT_LT(shear_energy_of_new_contact({0, -1e-4}), 1e-6 * of_twin);
}

// A slab that is drawn above a base by `left` and `right` at its ends, or into it; the base is the lower block or the
// other one.
RelaxationScene slab_above(double left, double right, bool base_first, double width = 2) {
    RelaxationScene scene;
    scene.block.push_back({{{0, left}, {width, right}, {width, width / 2}, {0, width / 2}}, density});
    scene.block.push_back(fixed_block({{-1, -1}, {4, -1}, {4, 0}, {-1, 0}}));
    if (base_first) {
        std::swap(scene.block[0], scene.block[1]);
    }
    scene.material = {joint(1e9, degrees(30))};
    return scene;
}

TEST(Contacts, TouchWhereAClosedJointIsDrawnOpenOrOverlapping) {
    for (const bool base_first : {false, true}) {
        for (const auto& [left, right] :
             {std::pair(3e-4, 3e-4), std::pair(9e-4, 1e-5), std::pair(0.0, 9e-4), std::pair(-3e-4, -3e-4),
              std::pair(-9e-4, -1e-5), std::pair(0.0, -9e-4), std::pair(-3e-4, 5e-4)}) {
            const Bodies bodies = make_bodies(slab_above(left, right, base_first));
            const std::vector<ShiftedPair> shifts = closing_shifts(bodies);
            ASSERT_EQ(shifts.size(), 1U) << left << ' ' << right;
            // Less than a margin of the search is left to the gap.
            const ContactList list = find_contacts(slab_above(left, right, base_first), bodies, std::vector<Motion>(2),
                                                   {0, 0}, {1e-6, 0.2, true, {}, shifts}, {});
            ASSERT_EQ(list.contact.size(), 2U);
            for (std::size_t index = 0; index < 2; ++index) {
                EXPECT_NEAR(list.contact[index].gap, 0, 1e-6 * std::max(std::abs(left), std::abs(right)));
            }
        }
        // The turn of a long block by so much as a small one is drawn open displaces its ends to third order as well.
        EXPECT_EQ(closing_shifts(make_bodies(slab_above(0, 9e-6, base_first, 0.02))).size(), 1U);
    }
}

TEST(Contacts, StayApartWhereAJointIsOpenOrExact) {
    for (const auto& [left, right] : {std::pair(0.0, 0.0), std::pair(-2e-3, -2e-3), std::pair(2e-3, 2e-3)}) {
        EXPECT_TRUE(closing_shifts(make_bodies(slab_above(left, right, false))).empty()) << left << ' ' << right;
    }
}

// A step of the slab rests on a step of the base: turned until the long face is closed, the slab would gape at the
// short one.
TEST(Contacts, AreLeftWhereClosingOneFaceOpensAnother) {
    RelaxationScene scene;
    scene.block.push_back({{{0, 0}, {1, 0}, {1, 0.5}, {3, 0.5003}, {3, 1}, {0, 1}}, density});
    scene.block.push_back(fixed_block({{-1, -1}, {4, -1}, {4, 0.5}, {1, 0.5}, {1, 0}, {-1, 0}}));
    scene.material = {joint(1e9, degrees(30))};
    const Bodies bodies = make_bodies(scene);
    const std::vector<SharedFace> faces = find_shared_faces(bodies);
    ASSERT_EQ(std::ranges::count_if(faces, [](const SharedFace& face) { return face.length > 0.9; }), 2);
    EXPECT_TRUE(closing_shifts(bodies).empty());
}

}  // namespace
}  // namespace delabole
