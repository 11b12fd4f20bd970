// Loads on the ground behind the crest: every one is carried, once, by the column on which it stands.
#include "limit_equilibrium/stepped_base/stepped_base.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

const double base_dip = degrees(30);

ColumnScene<> slope_with(const ColumnLayout<>& columns, const SlopeSection<>& slope) {
    ColumnScene<> scene{};
    scene.slope = slope;
    scene.columns = columns;
    scene.rock = {25e3};
    scene.water = Dry{};
    return scene;
}

// Goodman & Bray (1976): columns of 10 m on 30 deg bases.
ColumnScene<> flat_tops(double upper_surface_dip, std::optional<double> base_end_height) {
    return slope_with(ClassicalColumns<>{.joint_dip = degrees(60),
                                         .spacing = 10,
                                         .base_inclination = base_dip + std::atan(0.1),
                                         .base_end_height = base_end_height},
                      SlopeSection<>{92.5, base_dip + std::atan(0.5), upper_surface_dip, std::nullopt, std::nullopt});
}

ColumnScene<> with_line_load(ColumnScene<> scene, double distance, double plunge) {
    scene.line_load = {{.force = 1e6, .plunge = plunge, .distance_behind_crest = distance}};
    return scene;
}

double weight_on_columns(const ColumnSlope<>& slope) {
    double down = 0;
    for (const Column<>& column : slope.columns) {
        down += column.down_dip_force * std::sin(slope.base_dip) + column.normal_force * std::cos(slope.base_dip);
    }
    return down - (slope.slide_head ? slope.slide_head->force_y : 0);
}

// Rounding of a weight of 6e7 N and its moments.
constexpr double rounding = 1e-3;

// In plan the tops overlap on ground steeper than the bases, and lie apart on flatter ground.
TEST(GroundLoads, AreCarriedOnceByFlatTops) {
    for (const double upper_surface_dip : {-5.0, 4.0, 29.0, 33.0}) {
        for (const bool head : {false, true}) {
            ColumnScene<> scene = flat_tops(degrees(upper_surface_dip), 75);
            if (head) {
                scene.slide_head = SlideHead<>{degrees(70), degrees(30), 0, std::nullopt};
            }
            const ColumnSlope<> bare = make_columns(scene);
            ASSERT_EQ(bare.check, ColumnCheck::valid) << upper_surface_dip;
            ColumnScene<> loaded = scene;
            loaded.surcharge = {{.pressure = 1e5, .from_distance = 1, .to_distance = 21}};
            EXPECT_NEAR(weight_on_columns(make_columns(loaded)) - weight_on_columns(bare), 20e5, rounding)
                << upper_surface_dip;
            for (double distance = 0; distance < 21; distance += 0.25) {
                const ColumnSlope<> under = make_columns(with_line_load(scene, distance, degrees(90)));
                EXPECT_NEAR(weight_on_columns(under) - weight_on_columns(bare), 1e6, rounding)
                    << upper_surface_dip << ' ' << distance;
            }
        }
    }
}

// The crest column is the tenth, 40 m high, the eleventh 6 m lower and on a base 1 m higher: between their tops the
// upper side of the tenth lies open over 5 m x sin 30 deg in plan.
TEST(GroundLoads, BetweenTwoFlatTopsLoadTheUpperColumn) {
    const ColumnScene<> scene = flat_tops(base_dip - std::atan(0.5), std::nullopt);
    const ColumnSlope<> bare = make_columns(scene);
    const Column<>& tenth = bare.columns[9];
    const Column<>& eleventh = bare.columns[10];
    ASSERT_NEAR(tenth.height, 40, 1e-9);
    const double below_top = 2;  // along that side
    const double v = tenth.base_v + tenth.height - below_top;
    const double x = eleventh.base_u * std::cos(base_dip) - v * std::sin(base_dip);
    const double distance = x - 92.5 / std::tan(scene.slope->face_dip);
    ASSERT_GT(distance, 0);
    const double plunge = degrees(70);
    const ColumnSlope<> loaded = make_columns(with_line_load(scene, distance, plunge));
    // The load is steep, and the base rises at 30 deg into the slope.
    const double along = 1e6 * std::sin(plunge - degrees(90) + base_dip);  // down the base
    const double into = 1e6 * std::cos(plunge - degrees(90) + base_dip);
    EXPECT_NEAR(loaded.columns[9].down_dip_force, tenth.down_dip_force, rounding);
    EXPECT_NEAR(loaded.columns[10].down_dip_force - eleventh.down_dip_force, along, rounding);
    EXPECT_NEAR(loaded.columns[10].normal_force - eleventh.normal_force, into, rounding);
    // It stands over the toe corner of the base, in the turned axes.
    EXPECT_NEAR(loaded.columns[10].overturning_moment - eleventh.overturning_moment, along * (v - eleventh.base_v),
                10 * rounding);
}

// On a vertical face the tops of columns have extents of rounding, and so has the distance of the crest.
TEST(GroundLoads, AtTheCrestOfAVerticalFaceStandOnTheColumnOfTheCrest) {
    for (const double joint_dip : {55.0, 65.0, 75.0, 85.0}) {
        for (const double spacing : {1.0, 1.7, 2.5, 3.0, 7.0}) {
            const auto with_face = [&](double face_dip, double distance) {
                const ContinuousColumns<> columns{degrees(joint_dip), spacing, degrees(90 - joint_dip + 3),
                                                  std::nullopt};
                return make_columns(
                    with_line_load(slope_with(columns, SlopeSection<>{10, face_dip, 0, std::nullopt, std::nullopt}),
                                   distance, degrees(60)));
            };
            const ColumnSlope<> at_crest = with_face(degrees(90), 0);
            const ColumnSlope<> behind = with_face(degrees(90), 1e-7);
            const ColumnSlope<> steep = with_face(degrees(90 - 1e-7), 0);
            ASSERT_EQ(at_crest.columns.size(), behind.columns.size());
            ASSERT_EQ(at_crest.columns.size(), steep.columns.size());
            for (std::size_t index = 0; index < behind.columns.size(); ++index) {
                for (const ColumnSlope<>* near : {&behind, &steep}) {
                    // A load of 1e6 N/m moves by 1e-7 m or less, and turns by 2e-9.
                    EXPECT_NEAR(at_crest.columns[index].down_dip_force, near->columns[index].down_dip_force, 0.1)
                        << joint_dip << ' ' << spacing << ' ' << index;
                    EXPECT_NEAR(at_crest.columns[index].overturning_moment, near->columns[index].overturning_moment, 1)
                        << joint_dip << ' ' << spacing << ' ' << index;
                }
            }
        }
    }
}

// The load on its own column pushes the slope over.
TEST(GroundLoads, AtTheCrestOfAVerticalFaceDecideItsFactorOfSafety) {
    const auto factor = [](double distance) {
        const ContinuousColumns<> columns{degrees(65), 3, degrees(28), std::nullopt};
        SteppedBase<> problem{};
        problem.scene = slope_with(columns, SlopeSection<>{10, degrees(90), 0, std::nullopt, std::nullopt});
        problem.scene.rock = {26e3};
        problem.scene.line_load = {{.force = 500e3, .plunge = degrees(90), .distance_behind_crest = distance}};
        problem.joints = {degrees(45)};
        problem.bases = {degrees(45), 0};
        return analyse(problem).factor_of_safety;
    };
    EXPECT_NEAR(factor(0), 0.5428, 5e-5);        // printed digits of a recursion written apart from the library
    EXPECT_NEAR(factor(0), factor(1e-6), 1e-6);  // the load moves by a micrometre
}

}  // namespace
}  // namespace delabole
