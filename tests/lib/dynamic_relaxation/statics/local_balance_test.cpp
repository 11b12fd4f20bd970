// A block that hangs above its base is brought down onto it; blocks in balance stay where they are.
#include "dynamic_relaxation/statics/local_balance.hpp"
#include "parameters/fields.hpp"
#include "tests/support/brick_pack.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace delabole {
namespace {

TEST(LocalBalance, MovesWhatLacksBalanceAndNothingElse) {
    // Bricks beside each other, of which one hangs; the base and the toe are the last two blocks.
    constexpr std::size_t bricks = 12;
    constexpr std::size_t hanging = 5;
    const RelaxationScene scene = brick_pack_scene({1, bricks, 1e5, degrees(40), 0});
    const Bodies bodies = make_bodies(scene);
    constexpr double weight = 2700 * 2 * 9.80665;
    constexpr double sunk = 0.5e-5;  // m: half a weight over the stiffness of each of two corners, 1e5 weights a metre
    std::vector<Motion> motion(bodies.size());
    for (std::size_t brick = 0; brick < bricks; ++brick) {
        motion[brick].y = brick == hanging ? 100 * sunk : -sunk;
    }
    const std::vector<char> removed(bodies.size(), 0);
    ContactList list = find_contacts(scene, bodies, motion, removed, {1e-2, 0.2, true, {}, {}}, {});
    Team team(1);
    const Bonds bonds(scene, bodies, 0.2, team);
    const std::vector<BondMemory> no_bonds;
    const std::vector<Eigen::Vector3d> loads(bodies.size(), {0, -weight, 0});
    StaticEquations equations(bodies, bodies.fixed, loads, bonds, no_bonds, {}, list);
    const MemoryArray before = list.memory;
    equations.evaluate(motion, before, list);
    EXPECT_NEAR(equations.unbalanced_ratio(), 1, 1e-9);  // rounding of overlaps of 1e-5 of a brick
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(equations.unbalanced().size());

    // Where nothing touches, a block moves by its weight over the pseudo-viscosity: less than the gap with 1e-2 of a
    // joint, through it with 1e-4.
    for (const double resists : {1e-2, 1e-4}) {
        const PseudoViscosity resisting{resists, resists};
        const Eigen::VectorXd lacking = equations.unbalanced() - equations.resistance(resisting, moved);
        balance_one_by_one(resisting, lacking, before, equations, moved, motion, list);
        equations.evaluate(motion, before, list);
        const Eigen::VectorXd left = equations.unbalanced() - equations.resistance(resisting, moved);
        EXPECT_LE(left.segment<3>(3 * hanging).norm(), 0.1 * weight) << resists;
        for (std::size_t brick = 0; brick < bricks; ++brick) {
            if (brick != hanging) {
                EXPECT_EQ(motion[brick].y, -sunk) << brick;
                EXPECT_EQ(moved.segment<3>(3 * static_cast<Eigen::Index>(brick)).norm(), 0) << brick;
            }
        }
    }
    EXPECT_LE(motion[hanging].y,
              -0.8 * sunk);  // on the base, within the tenth of the weight that is left and what resists

    // After a block was balanced alone, contacts need to be evaluated only around it.
    equations.let_contacts_resist();
    equations.evaluate(motion, before, list);
    const PseudoViscosity resisting{1e-3, 1e-3};
    balance_one_by_one(resisting, equations.unbalanced(), before, equations, moved, motion, list);
    equations.evaluate_again(motion, before, list);
    const Eigen::VectorXd unbalanced = equations.unbalanced();
    const Eigen::VectorXd resistance = equations.resistance(resisting, moved);
    const MemoryArray memory = list.memory;
    equations.evaluate(motion, before, list);
    EXPECT_EQ(unbalanced, equations.unbalanced());
    EXPECT_EQ(resistance, equations.resistance(resisting, moved));
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        EXPECT_EQ(memory[index].touching, list.memory[index].touching) << index;
        EXPECT_EQ(memory[index].shear, list.memory[index].shear) << index;
        EXPECT_EQ(memory[index].place, list.memory[index].place) << index;
    }
}

}  // namespace
}  // namespace delabole
