// The models of chapter 3 as scenes: cut as the tables have them, and failing where they must.
#include "cases/program/thesis/chapter_3/base_friction.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace delabole {
namespace {

constexpr double inch = 0.0254;

const BaseFrictionState& state_of(const std::vector<BaseFrictionState>& states, const std::string& test,
                                  ToeChange toe = ToeChange::as_built) {
    return *std::ranges::find_if(
        states, [&](const BaseFrictionState& state) { return state.test == test && state.toe == toe; });
}

TEST(BaseFrictionScene, EveryStateIsCutIntoBlocksThatRun) {
    const std::vector<BaseFrictionState> states = base_friction_states();
    const ModelMixture mixture = model_mixture();
    for (const BaseFrictionScene& scene : base_friction_scenes(states, mixture)) {
        const std::string& test = states[scene.state.front()].test;
        const RelaxationStudy study = base_friction_study(scene.geometry, mixture);
        EXPECT_EQ(check(study).check, SceneCheck::valid) << test;
        const RelaxationScene made = relaxation_scene(study);
        // Enough blocks to break into, not too many to run in seconds.
        EXPECT_GT(made.block.size(), 150U) << test;
        EXPECT_LT(made.block.size(), 3000U) << test;
        EXPECT_GT(made.bond.size(), made.block.size() / 4) << test;
        double area = 0;
        for (const RelaxationBlock& block : made.block) {
            area += block.fixed ? 0 : area_properties(block.outline).area;
        }
        // By hand: the slope with its face, on the ground that reaches in front of it.
        const BaseFrictionGeometry& g = scene.geometry;
        const double face_height = g.slope_height - g.vertical_cut;
        const double run = face_height / std::tan(g.slope_angle);
        const double expected = run * face_height / 2 + g.slope_surface * face_height +
                                (run + g.slope_surface) * (g.vertical_cut + g.depth) + g.front * g.depth;
        EXPECT_NEAR(area, expected, 1e-9 * expected) << test;
    }
}

TEST(BaseFrictionScene, StatesAreBuiltAsTold) {
    const std::vector<BaseFrictionState> states = base_friction_states();
    const ModelMixture mixture = model_mixture();
    const auto geometry = [&](const std::string& test, ToeChange toe = ToeChange::as_built) {
        return geometry_of(state_of(states, test, toe), mixture);
    };
    EXPECT_EQ(geometry("3(L)"), geometry("4(R)"));
    EXPECT_NE(geometry("1(R)"), geometry("3(R)")) << "without the restraint of the toe";
    EXPECT_EQ(geometry("5(L)", ToeChange::horizontal_cut).cut_friction, mixture.friction);
    EXPECT_EQ(geometry("4(L)", ToeChange::horizontal_cut).cut_friction, mixture.tin_friction);
    EXPECT_NEAR(geometry("1(R)", ToeChange::vertical_cut).vertical_cut, 3 * inch, 1e-12);
    EXPECT_NEAR(geometry("2'_R(L)").depth, 6 * inch, 1e-12);
    EXPECT_NEAR(geometry("2'(L)").depth, 12 * inch, 1e-12);
    EXPECT_EQ(geometry("6(R)", ToeChange::blocks_removed).columns_removed, 2U);
    EXPECT_TRUE(geometry("14D(L)").saw_tooth);
}

TEST(BaseFrictionScene, TwinsStayInOneHalf) {
    const std::vector<BaseFrictionState> states = base_friction_states();
    const std::vector<BaseFrictionScene> scenes = base_friction_scenes(states, model_mixture());
    std::set<std::size_t> seen;
    for (const BaseFrictionScene& scene : scenes) {
        for (const std::size_t state : scene.state) {
            EXPECT_TRUE(seen.insert(state).second);
        }
    }
    EXPECT_EQ(seen.size(), states.size());
    const auto fitted = std::ranges::count_if(scenes, &BaseFrictionScene::fitted);
    EXPECT_LE(std::abs(2 * fitted - static_cast<long>(scenes.size())), 1);
}

// Needs made so that every state is right at 2 kPa and wrong far from it.
TEST(StrengthFit, FindsTheStrengthThatTheNeedsWereMadeWith) {
    const std::vector<BaseFrictionState> states = base_friction_states();
    const std::vector<BaseFrictionScene> scenes = base_friction_scenes(states, model_mixture());
    std::vector<SceneNeed> needs(scenes.size());
    for (std::size_t index = 0; index < scenes.size(); ++index) {
        const bool fails = states[scenes[index].state.front()].behaviour == SlopeBehaviour::unstable;
        CriticalStrength& critical = needs[index].critical;
        critical.status = StrengthStatus::found;
        critical.stands = critical.fails = fails ? 4 : 1;
    }
    const StrengthFit fit = fit_strength(states, scenes, needs);
    // Between the two needs; where, depends on how many there are of each.
    EXPECT_GT(fit.strength, 1.2);
    EXPECT_LT(fit.strength, 3.4);
    EXPECT_GT(failure_probability(4, fit.strength), 0.8);
    EXPECT_LT(failure_probability(1, fit.strength), 0.2);
    EXPECT_LT(failure_probability(0, fit.strength), 0.03);
}

}  // namespace
}  // namespace delabole
