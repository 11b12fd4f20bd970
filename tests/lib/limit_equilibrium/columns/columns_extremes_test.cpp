// Columns at the ends of every range have finite numbers or a named reason, and no jumps where none belong.
#include "tests/lib/limit_equilibrium/columns/reference_recursion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace {

using namespace delabole;

void expect_sound(const ColumnScene<>& scene, const ColumnSlope<>& slope) {
    ASSERT_EQ(slope.check, ColumnCheck::valid);
    ASSERT_FALSE(slope.columns.empty());
    for (const Column<>& column : slope.columns) {
        for (const double number : {column.width, column.base_u, column.base_v, column.height, column.lower_contact,
                                    column.upper_contact, column.joint_length, column.weight, column.down_dip_force,
                                    column.normal_force, column.overturning_moment}) {
            ASSERT_TRUE(std::isfinite(number));
        }
        ASSERT_GE(column.width, 0);
        ASSERT_GE(column.lower_contact, 0);
        ASSERT_GE(column.joint_length, 0);
        // A column that is all but nothing may lose its area to rounding of coordinates.
        ASSERT_GE(column.weight, -1e-10 * scene.rock.unit_weight * (1 + column.base_u * column.base_u));
    }
    if (slope.slide_head) {
        for (const double friction : {0.0, 0.5, 60.0}) {
            const SlideHeadThrust<> thrust = slide_head_thrust(*slope.slide_head, slope.base_dip, friction, 1.0);
            ASSERT_TRUE(std::isfinite(thrust.force) && std::isfinite(thrust.height) && std::isfinite(thrust.shear));
            ASSERT_GE(thrust.force, 0);
            ASSERT_FALSE(std::isnan(thrust.own_factor_of_safety));
        }
    }
}

TEST(ColumnExtremes, RandomScenesGiveNumbersOrReasons) {
    std::mt19937 generator(1967);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto between = [&](double lower, double upper) { return lower + (upper - lower) * unit(generator); };
    // The two ends of a range are drawn in a fifth of all cases.
    const auto angle = [&](double lower, double upper) {
        const double drawn = unit(generator);
        return degrees(drawn < 0.1 ? lower : drawn < 0.2 ? upper : between(lower, upper));
    };
    int valid = 0;
    for (int repeat = 0; repeat < 4000; ++repeat) {
        ColumnScene<> scene{};
        const double height = std::pow(10, between(-3, 3.7));  // 1 mm to 5 km
        SlopeSection<>& slope = scene.slope.emplace();
        slope.height = height;
        slope.face_dip = angle(20, 90);
        slope.upper_surface_dip = angle(-30, 60);
        slope.toe_elevation = 100;
        if (unit(generator) < 0.3) {
            slope.bench = Bench<>{height * between(0, 2), angle(-30, 60)};
        }
        const double joint_dip = angle(20, 90);
        const double spacing = height * std::pow(10, between(-2, 1));
        const double inclination = std::clamp(degrees(90) - joint_dip + angle(0, 30), degrees(0.1), degrees(89.9));
        const std::optional<double> end =
            unit(generator) < 0.5 ? std::optional<double>(height * between(0.01, 1.2)) : std::nullopt;
        if (unit(generator) < 0.7) {
            scene.columns = ContinuousColumns<>{joint_dip, spacing, inclination, end};
        } else {
            scene.columns = ClassicalColumns<>{joint_dip, spacing, inclination, end};
        }
        scene.rock.unit_weight = std::pow(10, between(2, 5));
        const double kind = unit(generator);
        if (kind < 0.3) {
            scene.water = FilledJointsWater<>{9810, unit(generator)};
        } else if (kind < 0.6) {
            scene.water = WaterTable<>{9810, WaterDepth<>{height * between(0, 2)}};
        } else if (kind < 0.8) {
            scene.water = PiezometricLineWater<>{
                9810, {{-height, between(-1, 1) * height}, {0, 0}, {0.01 * height, height}, {2 * height, 0}}};
        }
        if (end && unit(generator) < 0.6) {
            scene.slide_head = SlideHead<>{angle(30, 90), angle(0, 89.9), 1e4 * unit(generator), {}};
        }
        scene.surcharge = {{1e4, 0, height}};
        const ColumnSlope<> columns = make_columns(scene);
        if (columns.check == ColumnCheck::valid) {
            ++valid;
            expect_sound(scene, columns);
            if (HasFatalFailure()) {
                FAIL() << "scene " << repeat;
            }
        } else {
            EXPECT_NE(columns.check, ColumnCheck::input_out_of_range) << repeat;
        }
    }
    EXPECT_GT(valid, 1000);
}

// 85 deg columns of the Delabole face with the wedge above them.
ColumnScene<> slide_head_scene(double spacing, double end_height) {
    ColumnScene<> scene{};
    scene.slope = SlopeSection<>{68.58, degrees(70), 0, {}, {}};
    scene.columns = ContinuousColumns<>{degrees(85), spacing, degrees(43), end_height};
    scene.rock = {27e3};
    scene.slide_head = SlideHead<>{degrees(72), degrees(30), 0, {}};
    return scene;
}

double largest_change(const std::function<ColumnScene<>(double)>& scene_at, double from, double to, int steps) {
    double largest = 0;
    double before = 0;
    for (int index = 0; index <= steps; ++index) {
        const ColumnSlope<> slope = make_columns(scene_at(from + (to - from) * index / steps));
        EXPECT_EQ(slope.check, ColumnCheck::valid);
        const double safety = test::factor_of_safety(slope, 0.6, 0.6);
        largest = index > 0 ? std::max(largest, std::abs(safety - before)) : 0;
        before = safety;
    }
    return largest;
}

// A jump would keep its size however fine the steps; what is continuous changes in proportion, and kinks take their
// share of the ten.
TEST(ColumnExtremes, BelowAWedgeNothingJumpsInSpacingOrExtent) {
    const auto by_spacing = [](double spacing) { return slide_head_scene(spacing, 22.86); };
    EXPECT_LT(largest_change(by_spacing, 4, 9, 3000), largest_change(by_spacing, 4, 9, 300) / 4);
    const auto by_extent = [](double end_height) { return slide_head_scene(6, end_height); };
    EXPECT_LT(largest_change(by_extent, 15, 35, 3000), largest_change(by_extent, 15, 35, 300) / 4);
}

TEST(ColumnExtremes, VerticalJointsInAVerticalFace) {
    ColumnScene<> scene{};
    scene.slope = SlopeSection<>{10, degrees(90), 0, {}, {}};
    scene.columns = ContinuousColumns<>{degrees(90), 1, degrees(45), 5.0};
    scene.rock = {25e3};
    const ColumnSlope<> slope = make_columns(scene);
    ASSERT_EQ(slope.check, ColumnCheck::valid);
    ASSERT_EQ(slope.columns.size(), 5U);
    for (std::size_t index = 0; index < 5; ++index) {
        const double height = 10 - static_cast<double>(index);
        EXPECT_NEAR(slope.columns[index].weight, 25e3 * height, 1e-9);
        EXPECT_NEAR(slope.columns[index].overturning_moment, -25e3 * height / 2, 1e-9);
    }
}

TEST(ColumnExtremes, AHundredThousandColumnsWeighWhatFewDo) {
    const auto total = [](double spacing) {
        const ColumnSlope<> slope = make_columns(slide_head_scene(spacing, 22.86));
        double weight = 0;
        for (const Column<>& column : slope.columns) {
            weight += column.weight;
        }
        return weight;
    };
    // The steps below the line through the toe corners, half a step on average, are what differs: they vanish with the
    // spacing.
    const double width = 22.86 / std::sin(degrees(43)) * std::cos(degrees(38));
    const double steps_at_one_metre = 27e3 * width * std::tan(degrees(38)) / 2;
    const double fine = total(width / 1e5);
    EXPECT_GT(total(1), fine);
    EXPECT_NEAR(total(1) - fine, steps_at_one_metre, 0.05 * steps_at_one_metre);  // the first column is narrower
}

}  // namespace
