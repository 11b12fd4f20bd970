// A state in balance passes the check; the same state with anything changed that no joint holds does not.
#include "dynamic_relaxation/statics/static_check.hpp"
#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/step/simulation.hpp"
#include "parameters/fields.hpp"
#include "tests/support/brick_pack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace delabole {
namespace {

constexpr double tolerance = 1e-6;  // equilibrium_ratio

struct AtRest {
    RelaxationScene scene = brick_pack_scene({6, 8, 1e5, degrees(40), degrees(20)});
    Bodies bodies = make_bodies(scene);
    RelaxationState state = {};
    std::vector<BlockForce> loads = {};
    std::vector<double> inverse_weight = {};

    AtRest() {
        Simulation simulation(scene, {});
        while (simulation.running()) {
            simulation.step();
        }
        EXPECT_EQ(simulation.outcome(), RelaxationOutcome::equilibrium);
        state = simulation.state();
        for (const double mass : bodies.mass) {
            const double weight = mass * scene.gravity.acceleration;
            loads.push_back({-weight * std::sin(scene.gravity.tilt), -weight * std::cos(scene.gravity.tilt)});
            inverse_weight.push_back(1 / weight);
        }
    }

    StaticCheck check() const {
        return check_statics(bodies, bodies.fixed, loads, inverse_weight, {}, {}, state.motion, state.contacts);
    }

    // Returns the index of the contact that bears most.
    std::size_t hardest_pressed() const {
        std::size_t hardest = 0;
        double least = 0;
        for (std::size_t index = 0; index < state.contacts.contact.size(); ++index) {
            const RelaxationContact contact = state.contacts.contact[index];
            const double gap = locate(contact, state.motion[contact.block], state.motion[contact.other]).gap;
            if (state.contacts.memory[index].touching && gap < least) {
                least = gap;
                hardest = index;
            }
        }
        return hardest;
    }
};

TEST(StaticCheck, HoldsForBricksAtRest) {
    const AtRest bricks;
    EXPECT_TRUE(bricks.check().holds(tolerance));
    EXPECT_GT(bricks.state.contacts.contact.size(), 50U);
}

TEST(StaticCheck, FindsALoadThatNothingHolds) {
    AtRest bricks;
    std::size_t free = 0;
    while (bricks.bodies.fixed[free] != 0) {
        ++free;
    }
    bricks.loads[free].x += 1e-3 / bricks.inverse_weight[free];
    EXPECT_NEAR(bricks.check().unbalanced, 1e-3, 2e-6);  // but for what is left of the run
    EXPECT_FALSE(bricks.check().holds(tolerance));
}

TEST(StaticCheck, FindsABlockLiftedOffItsNeighbours) {
    AtRest bricks;
    const RelaxationContact contact = bricks.state.contacts.contact[bricks.hardest_pressed()];
    const std::size_t lifted = bricks.bodies.fixed[contact.block] != 0 ? contact.other : contact.block;
    bricks.state.motion[lifted].y += 1e-3 * bricks.bodies.shortest_edge[lifted];
    EXPECT_GT(bricks.check().unbalanced, 1e-3);
    EXPECT_GT(bricks.check().beyond_tension, 1e-3);
}

TEST(StaticCheck, FindsMoreShearThanFrictionHolds) {
    AtRest bricks;
    const std::size_t index = bricks.hardest_pressed();
    ContactMemory memory = bricks.state.contacts.memory[index];
    const RelaxationContact contact = bricks.state.contacts.contact[index];
    const double gap = locate(contact, bricks.state.motion[contact.block], bricks.state.motion[contact.other]).gap;
    const ContactLaw law = bricks.state.contacts.law_of(contact);
    memory.shear = 1.1 * law.friction * law.normal_stiffness * -gap / law.shear_stiffness;
    bricks.state.contacts.memory.set(index, memory);
    EXPECT_GT(bricks.check().beyond_shear, tolerance);
}

// The check adds up the same as the run's own sweep of contacts, so that both agree if nothing is tampered with.
TEST(StaticCheck, AgreesWithTheRunAboutWhatIsOutOfBalance) {
    AtRest bricks;
    EXPECT_LT(bricks.check().unbalanced, tolerance);
    EXPECT_EQ(bricks.check().beyond_tension, 0);
    EXPECT_LT(bricks.check().beyond_shear, 1e-9);  // rounding of forces at the limit of friction
}

}  // namespace
}  // namespace delabole
