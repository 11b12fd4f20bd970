// Starts creep to the threshold of onset in searches, which ask whether blocks stand and not how they move.
#include "dynamic_relaxation/scene/scenes.hpp"
#include "dynamic_relaxation/study/critical.hpp"
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace delabole {
namespace {

using relaxation_scenes::density;
using relaxation_scenes::gravity;
using relaxation_scenes::until_onset;

using SceneAt = std::function<RelaxationScene(double)>;

JointMaterial joint_of(double stiffness_ratio, const StandingBlock& block, double weight_per_volume, double friction) {
    const double stiffness = stiffness_of_ratio(stiffness_ratio, block, weight_per_volume / gravity, gravity);
    return {stiffness, stiffness, friction};
}

SceneAt two_blocks(double height, double stiffness_ratio) {
    const StandingBlock block{1, height};
    const JointMaterial joint = joint_of(stiffness_ratio, block, density * gravity, degrees(20));
    return [=](double tilt) { return row_scene({{block, block}, density, joint, joint, tilt}); };
}

SceneAt columns_on_steps(const StandingBlocks& columns, double stiffness_ratio) {
    const StandingBlock highest =
        *std::max_element(columns.block.begin(), columns.block.end(),
                          [](const StandingBlock& one, const StandingBlock& two) { return one.height < two.height; });
    return [=](double friction) {
        StandingBlocks at = columns;
        at.interface = at.base = joint_of(stiffness_ratio, highest, columns.density * gravity, friction);
        return column_scene(at);
    };
}

StandingBlocks appendix_a() {
    StandingBlocks columns;
    for (const double height : {1.0, 2.0, 3.0, 4.0, 3.1, 2.2, 1.3, 0.4}) {
        columns.block.push_back({1, height, 0.5});
    }
    columns.density = density;
    columns.tilt = degrees(21.8);
    return columns;
}

StandingBlocks goodman_bray() {
    StandingBlocks columns;
    for (int number = 1; number <= 16; ++number) {
        columns.block.push_back({10, number <= 10 ? 4.0 * number : 40 - 6.0 * (number - 10), 1});
    }
    columns.density = 25e3 / gravity;
    columns.tilt = degrees(30);
    return columns;
}

RelaxationSettings for_searches(bool creep) {
    RelaxationSettings settings = until_onset();
    settings.mass_scaling = true;
    settings.creep = creep;
    return settings;
}

CriticalValue critical_of(const SceneAt& scene_at, double stands, double fails, const RelaxationSettings& settings) {
    const auto probe = [&](double value) {
        const RelaxationResult result = relax(scene_at(value), settings);
        return CriticalProbe{result.outcome, result.cost.steps};
    };
    return find_critical(probe, stands, fails, degrees(0.002));
}

TEST(Creep, FindsTheBracketThatWholeMotionsFind) {
    struct Search {
        SceneAt scene_at;
        double stands;
        double fails;
    };
    for (const Search& search :
         {Search{two_blocks(3, 1e6), degrees(18), degrees(19)}, Search{two_blocks(10, 1e6), degrees(6), degrees(6.5)},
          Search{columns_on_steps(appendix_a(), 1e6), degrees(42), degrees(40)},
          Search{columns_on_steps(goodman_bray(), 1e5), degrees(39), degrees(37)}}) {
        const CriticalValue crept = critical_of(search.scene_at, search.stands, search.fails, for_searches(true));
        const CriticalValue moved = critical_of(search.scene_at, search.stands, search.fails, for_searches(false));
        ASSERT_EQ(crept.status, CriticalStatus::found);
        // Each run agrees, even at a thousandth of a degree from the critical value.
        EXPECT_EQ(crept.stands, moved.stands);
        EXPECT_EQ(crept.fails, moved.fails);
        EXPECT_LT(10 * crept.steps, moved.steps);
    }
}

// Soft columns on steps lean some way before they jam, and inertia carries them past where they could: the less, the
// more they are damped.
TEST(Creep, IsTheLimitOfHeavyDamping) {
    const SceneAt scene_at = columns_on_steps(appendix_a(), 1e5);
    const auto limit = [&](const RelaxationSettings& settings) {
        return critical_of(scene_at, degrees(42), degrees(41), settings).value();
    };
    const double crept = limit(for_searches(true));
    RelaxationSettings damped = for_searches(false);
    const double by_inertia = limit(damped) - crept;
    EXPECT_GT(by_inertia, degrees(0.1));
    damped.local_damping = 0.95;
    // A tenth of what inertia makes is left, by which run it is somewhat more or less (0.8 to 0.98 of damping leave 9
    // to 24 % of it): onset is counted from the most balanced state met so far, and runs meet theirs at the start.
    EXPECT_NEAR(limit(damped), crept, 0.25 * by_inertia);
}

// Stiff joints lead the search for equilibrium to long leaps. One of them once left friction behind that held the
// columns a tenth of a degree below the limit.
TEST(Creep, LeavesNoFrictionBehindThatHoldsWhatFails) {
    constexpr double limit = 38.1512;  // deg, limiting equilibrium
    const SceneAt scene_at = columns_on_steps(goodman_bray(), 1e8);
    const RelaxationSettings settings = for_searches(true);
    for (const double below : {0.005, 0.03, 0.0575, 0.08, 0.104}) {
        EXPECT_EQ(relax(scene_at(degrees(limit - below)), settings).outcome, RelaxationOutcome::onset) << below;
        EXPECT_EQ(relax(scene_at(degrees(limit + below)), settings).outcome, RelaxationOutcome::equilibrium) << below;
    }
}

TEST(Creep, EndsShortOfOnsetAndOnlyWhereThereIsNoEquilibrium) {
    RelaxationSettings settings = until_onset();
    settings.creep = true;
    const auto leans_at_start = [&](double tilt) {
        const Simulation simulation(two_blocks(5, 1e6)(degrees(tilt)), settings);
        const RelaxationState& state = simulation.state();
        return std::max(std::abs(state.motion[0].angle - state.origin[0].angle),
                        std::abs(state.motion[1].angle - state.origin[1].angle));
    };
    // The pair begins to fail at 12.0 deg.
    EXPECT_EQ(leans_at_start(11.9), 0);
    for (const double tilt : {12.1, 13.0}) {
        EXPECT_LT(leans_at_start(tilt), settings.onset_rotation);
        EXPECT_GT(leans_at_start(tilt), 0.5 * settings.onset_rotation);
    }
}

}  // namespace
}  // namespace delabole
