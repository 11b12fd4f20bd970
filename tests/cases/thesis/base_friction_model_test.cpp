// The base friction models of chapter 3 as they were cut: as the tables have them.
#include "cases/program/thesis/chapter_3/base_friction_model.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "geometry/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace delabole {
namespace {

constexpr double inch = 0.0254;

const BaseFrictionState& state_of(const std::vector<BaseFrictionState>& states, const std::string& test,
                                  ToeChange toe = ToeChange::as_built) {
    return *std::ranges::find_if(
        states, [&](const BaseFrictionState& state) { return state.test == test && state.toe == toe; });
}

// Returns whether the block has an edge on that level line.
bool touches(const RelaxationBlock& block, double level) {
    return std::ranges::count_if(block.outline, [&](const PlanePoint<>& corner) {
               return std::abs(corner.y() - level) < 1e-9;  // m, rounding
           }) > 1;
}

TEST(BaseFrictionModel, EveryStateIsCutIntoItsColumns) {
    for (const BaseFrictionState& state : rows_of<BaseFrictionState>()) {
        const BaseFrictionGeometry g = geometry_of(state);
        const SlopeScene made = slope_scene(model_as_cut(g));
        EXPECT_EQ(made.check, SlopeCheck::valid) << state.test;
        // The bottom of an uncut model consists of whole columns, but for a triangle in a corner that was merged with
        // its neighbour.
        if (!g.cross_joint_spacing && !g.horizontal_cut && !g.saw_tooth) {
            const double bottom = -g.vertical_cut - g.depth;
            const double along = g.slope_surface + (g.slope_height - g.vertical_cut) / std::tan(g.slope_angle) +
                                 (g.depth > 0 ? g.front : 0);
            const double columns = along * std::sin(g.joint_dip) / g.joint_spacing;
            EXPECT_NEAR(
                static_cast<double>(std::ranges::count_if(
                    made.block, [&](const RelaxationBlock& block) { return !block.fixed && touches(block, bottom); })),
                columns, 2)
                << state.test;
        }
        double area = 0;
        for (const RelaxationBlock& block : made.block) {
            area += block.fixed ? 0 : area_properties(block.outline).area;
        }
        // The area by hand is that of the slope with its face, and of the ground that reaches in front of it.
        const double face_height = g.slope_height - g.vertical_cut;
        const double run = face_height / std::tan(g.slope_angle);
        const double expected = run * face_height / 2 + g.slope_surface * face_height +
                                (run + g.slope_surface) * (g.vertical_cut + g.depth) + g.front * g.depth;
        EXPECT_NEAR(area, expected, 1e-9 * expected) << state.test;
    }
}

TEST(BaseFrictionModel, StatesAreBuiltAsTold) {
    const std::vector<BaseFrictionState> states = rows_of<BaseFrictionState>();
    const auto geometry = [&](const std::string& test, ToeChange toe = ToeChange::as_built) {
        return geometry_of(state_of(states, test, toe));
    };
    EXPECT_FALSE(geometry("1(R)").horizontal_cut);
    EXPECT_TRUE(geometry("3(R)").horizontal_cut) << "without the restraint of the toe";
    EXPECT_TRUE(geometry("5(L)", ToeChange::horizontal_cut).horizontal_cut);
    EXPECT_TRUE(geometry("4(L)", ToeChange::horizontal_cut).horizontal_cut);
    EXPECT_NEAR(geometry("1(R)", ToeChange::vertical_cut).vertical_cut, 3 * inch, 1e-12);
    EXPECT_NEAR(geometry("2'_R(L)").depth, 6 * inch, 1e-12);
    EXPECT_NEAR(geometry("2'(L)").depth, 12 * inch, 1e-12);
    EXPECT_TRUE(geometry("14D(L)").saw_tooth);
}

}  // namespace
}  // namespace delabole
