// Shapes of columns, their loads, and the wedge above them.
#include "tests/lib/limit_equilibrium/columns/reference_recursion.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_dec_float.hpp>

#include <cmath>
#include <limits>

namespace {

using namespace delabole;
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Goodman & Bray (1976): 92.5 m at 56.6 deg, columns of 10 m on 30 deg bases, a1 = a2 = 5 m, b = 1 m.
ColumnScene<> goodman_bray() {
    const double base_dip = degrees(30);
    return {.slope = SlopeSection<>{.height = 92.5,
                                    .face_dip = base_dip + std::atan(0.5),
                                    .upper_surface_dip = base_dip - std::atan(0.5),
                                    .bench = {},
                                    .toe_elevation = {}},
            .columns = ClassicalColumns<>{.joint_dip = degrees(60),
                                          .spacing = 10,
                                          .base_inclination = base_dip + std::atan(0.1),
                                          .base_end_height = {}},
            .rock = {.unit_weight = 25e3},
            .water = Dry{},
            .seismic = {},
            .surcharge = {},
            .line_load = {},
            .point_load = {},
            .bolt = {},
            .support = {},
            .slide_head = {}};
}

ColumnScene<> continuous(double height, double spacing) {
    ColumnScene<> scene = goodman_bray();
    scene.slope->height = height;
    scene.columns = ContinuousColumns<>{.joint_dip = degrees(60),
                                        .spacing = spacing,
                                        .base_inclination = degrees(30) + std::atan(0.1),
                                        .base_end_height = {}};
    return scene;
}

// West face of Old Delabole, 1967: toe at 350 ft, end of the stepped base at 425 ft, crest at 575 ft.
ColumnScene<> slide_head_scene(double base_inclination, double head_dip) {
    ColumnScene<> scene = goodman_bray();
    scene.slope = SlopeSection<>{.height = 225 * 0.3048,
                                 .face_dip = degrees(70),
                                 .upper_surface_dip = 0,
                                 .bench = {},
                                 .toe_elevation = 350 * 0.3048};
    scene.columns = ContinuousColumns<>{
        .joint_dip = degrees(85), .spacing = 2, .base_inclination = base_inclination, .base_end_height = 75 * 0.3048};
    scene.rock.unit_weight = 27e3;
    scene.slide_head = SlideHead<>{.joint_dip = head_dip, .friction_angle = degrees(30), .cohesion = 0, .water = {}};
    return scene;
}

TEST(ClassicalColumns, AreThoseOfGoodmanAndBray) {
    const ColumnSlope<> slope = make_columns(goodman_bray());
    ASSERT_EQ(slope.check, ColumnCheck::valid);
    ASSERT_EQ(slope.columns.size(), 16U);
    for (std::size_t index = 0; index < 16; ++index) {
        const Column<>& column = slope.columns[index];
        const int number = static_cast<int>(index) + 1;
        const double height = number <= 10 ? 4.0 * number : 40 - 6.0 * (number - 10);
        // Tangents of sums of angles: some roundings of heights up to 50 m.
        EXPECT_NEAR(column.height, height, 1e3 * epsilon) << number;
        EXPECT_NEAR(column.weight, height * 10 * 25e3, 1e8 * epsilon) << number;
        EXPECT_NEAR(column.upper_contact, number < 10 ? height : number < 16 ? height - 5 : 0, 1e3 * epsilon);
        EXPECT_NEAR(column.lower_contact, number == 1 ? 0 : number <= 10 ? height - 5 : height, 1e3 * epsilon);
        const double overturning = column.weight * (height / 2 * std::sin(degrees(30)) - 5 * std::cos(degrees(30)));
        EXPECT_NEAR(column.overturning_moment, overturning, 1e9 * epsilon);
    }
    // The friction of limiting equilibrium, tan 38.1512 deg, printed to four decimals of a degree.
    const double friction = std::tan(degrees(38.1512));
    EXPECT_NEAR(test::factor_of_safety(slope, friction, friction), 1, 3e-6);
}

TEST(ClassicalColumns, JumpWhereTheCrestColumnChanges) {
    const ColumnScene<> scene = goodman_bray();
    const ClassicalJump jump = classical_jump(*scene.slope, std::get<ClassicalColumns<>>(scene.columns));
    EXPECT_LT(jump.lower_height, 92.5);
    EXPECT_GT(jump.upper_height, 92.5);
    const auto safety = [&](double height) {
        ColumnScene<> changed = scene;
        changed.slope->height = height;
        return test::factor_of_safety(make_columns(changed), 0.8, 0.8);
    };
    EXPECT_EQ(safety(jump.lower_height * (1 + 1e-9)), safety(jump.upper_height * (1 - 1e-9)));
    // One column more or less under the crest is seen in the second decimal.
    EXPECT_GT(std::abs(safety(jump.upper_height * (1 + 1e-9)) - safety(jump.upper_height * (1 - 1e-9))), 1e-3);
}

// The factor of safety may have kinks (a column changes its mode) but no jumps: over a step of 1e-5 of the range it may
// change by no more than its own slope allows; the steepest slope of the coarse sweep is some units per range.
template <class Scene>
double largest_change(const Scene& scene_at, double from, double to, int points, double water_ratio) {
    double largest = 0;
    for (int index = 0; index < points; ++index) {
        const double at = from + (to - from) * index / points;
        double pair[2];
        for (int side = 0; side < 2; ++side) {
            ColumnScene<> scene = scene_at(at + side * (to - from) / points);
            if (water_ratio > 0) {
                scene.water = FilledJointsWater<>{.unit_weight = 9810, .filled_ratio = water_ratio};
            }
            const ColumnSlope<> slope = make_columns(scene);
            EXPECT_EQ(slope.check, ColumnCheck::valid);
            pair[side] = test::factor_of_safety(slope, 0.8, 0.8);
        }
        largest = std::max(largest, std::abs(pair[1] - pair[0]));
    }
    return largest;
}

TEST(ContinuousColumns, FactorOfSafetyHasNoJumpsInHeightOrSpacing) {
    const auto by_height = [](double height) { return continuous(height, 10); };
    const auto by_spacing = [](double spacing) { return continuous(92.5, spacing); };
    for (const double water : {0.0, 0.3}) {
        // If continuous, the largest change falls in proportion to the step; a jump would stay. Ten times finer steps
        // must leave at most a quarter (kinks and coarse sampling take their share of the ten).
        const double coarse_height = largest_change(by_height, 70, 120, 200, water);
        EXPECT_LT(largest_change(by_height, 70, 120, 2000, water), coarse_height / 4);
        const double coarse_spacing = largest_change(by_spacing, 6, 12, 200, water);
        EXPECT_LT(largest_change(by_spacing, 6, 12, 2000, water), coarse_spacing / 4);
    }
}

TEST(ContinuousColumns, ColumnsAppearWithNoWeight) {
    // By hand, the area between base and ground: however many columns there are, no rock is lost or counted twice.
    for (double height = 80; height < 100; height += 0.37) {
        const ColumnScene<> scene = continuous(height, 7);
        const ColumnSlope<> slope = make_columns(scene);
        ASSERT_EQ(slope.check, ColumnCheck::valid);
        const Column<>& last = slope.columns.back();
        EXPECT_LE(last.upper_contact, 0);
        double area = 0;
        for (const Column<>& column : slope.columns) {
            area += column.weight / 25e3;
        }
        // Triangle toe, crest, end of the stepped base, plus the steps below the line through the toe corners.
        const ColumnShapes<> shapes = make_shapes(scene.slope, scene.columns);
        Polygon<> outline{{0, 0}};
        for (const ColumnShape<>& shape : shapes.columns) {
            outline.emplace_back(shape.base_u, shape.base_v);
            outline.emplace_back(shape.base_u + shape.width, shape.base_v);
        }
        for (auto shape = shapes.columns.rbegin(); shape != shapes.columns.rend(); ++shape) {
            outline.insert(outline.end(), shape->top.rbegin(), shape->top.rend());
        }
        EXPECT_NEAR(area, area_properties(outline).area, 1e-9 * area);
    }
}

TEST(Columns, WeightsAndMomentsAgreeWithFiftyDigits) {
    ColumnScene<> scene = slide_head_scene(degrees(43), degrees(72));
    scene.water = WaterTable<>{.unit_weight = 9810, .level = WaterElevation<>{475 * 0.3048}};
    scene.seismic = SeismicLoad<>{.horizontal_coefficient = 0.1, .vertical_coefficient = 0.05};
    scene.surcharge = {{.pressure = 5e4, .from_distance = 1, .to_distance = 9}};
    scene.bolt = {{.block = 3, .force = 1e5, .plunge = degrees(10), .height = 1}};
    const ColumnSlope<> slope = make_columns(scene);
    const ColumnSlope<Wide> exact = make_columns(with_scalar<ColumnScene<Wide>>(scene));
    ASSERT_EQ(slope.check, ColumnCheck::valid);
    ASSERT_EQ(exact.columns.size(), slope.columns.size());
    const auto near = [](double value, const Wide& reference, double scale) {
        // Some tens of roundings of numbers of the size `scale`.
        EXPECT_NEAR(value, static_cast<double>(reference), 100 * epsilon * scale);
    };
    for (std::size_t index = 0; index < slope.columns.size(); ++index) {
        const Column<>& column = slope.columns[index];
        const double weight = 27e3 * 2 * 70;  // of the highest column
        near(column.weight, exact.columns[index].weight, weight);
        near(column.down_dip_force, exact.columns[index].down_dip_force, weight);
        near(column.normal_force, exact.columns[index].normal_force, weight);
        near(column.overturning_moment, exact.columns[index].overturning_moment, weight * 70);
    }
    const SlideHeadThrust<> thrust = slide_head_thrust(*slope.slide_head, slope.base_dip, 0.6, 1.3);
    const SlideHeadThrust<Wide> wide = slide_head_thrust(*exact.slide_head, exact.base_dip, Wide(0.6), Wide(1.3));
    near(thrust.force, wide.force, slope.slide_head->weight);
    near(thrust.height, wide.height, 70);
}

// Wyllie & Mah (2004), ch. 9, for a block between two joints.
TEST(ColumnWater, HasTheForcesAndMomentsOfWyllieAndMah) {
    ColumnScene<> scene = goodman_bray();
    const ColumnSlope<> dry = make_columns(scene);
    scene.water = FilledJointsWater<>{.unit_weight = 9810, .filled_ratio = 0.4};
    const ColumnSlope<> wet = make_columns(scene);
    const std::size_t index = 6;  // the seventh: 28 m high, 24 m before it, steps of 1 m
    const double y = 0.4 * 28;
    const double z = 0.4 * 24 - 1;
    const double gradient = 9810 * std::cos(degrees(30));
    const double v1 = gradient * y * y / 2;
    const double v2 = gradient * (y + z) * 10 / 2;
    const double v3 = gradient * z * z / 2;
    const double lift_arm = 10 * (2 * y + z) / (3 * (y + z));
    const Column<>& a = dry.columns[index];
    const Column<>& b = wet.columns[index];
    // Differences of forces of 1e7 N and moments of 1e8 N.
    EXPECT_NEAR(b.down_dip_force - a.down_dip_force, v1 - v3, 1e-7);
    EXPECT_NEAR(a.normal_force - b.normal_force, v2, 1e-7);
    EXPECT_NEAR(b.overturning_moment - a.overturning_moment, v1 * y / 3 + v2 * lift_arm - v3 * z / 3, 1e-5);
}

TEST(ColumnWater, AtNoDepthIsDry) {
    ColumnScene<> scene = continuous(92.5, 10);
    const ColumnSlope<> dry = make_columns(scene);
    for (const ColumnWater<>& water :
         {ColumnWater<>{FilledJointsWater<>{9810, 0}}, ColumnWater<>{WaterTable<>{9810, WaterDepth<>{0}}},
          ColumnWater<>{PiezometricLineWater<>{9810, {{0, 0}, {50, -10}}}}}) {
        scene.water = water;
        const ColumnSlope<> wet = make_columns(scene);
        for (std::size_t index = 0; index < dry.columns.size(); ++index) {
            EXPECT_EQ(wet.columns[index].normal_force, dry.columns[index].normal_force);
            EXPECT_EQ(wet.columns[index].overturning_moment, dry.columns[index].overturning_moment);
        }
    }
}

// Archimedes: level water all around a column that stands out of it lifts it by the weight of water displaced. Only the
// first column is different: its face drains.
TEST(ColumnWater, LevelTableGivesBuoyancy) {
    ColumnScene<> scene = slide_head_scene(degrees(42), degrees(70));
    scene.slide_head.reset();
    const double depth = 30;
    const ColumnSlope<> dry = make_columns(scene);
    scene.water = WaterTable<>{.unit_weight = 9810, .level = WaterDepth<>{depth}};
    const ColumnSlope<> wet = make_columns(scene);
    const ColumnShapes<> shapes = make_shapes(scene.slope, scene.columns);
    const PlanePoint<> left = detail::turned(shapes.base, -100.0, depth);
    const PlanePoint<> right = detail::turned(shapes.base, 200.0, depth);
    int compared = 0;
    for (std::size_t index = 1; index < shapes.columns.size(); ++index) {
        const ColumnShape<>& shape = shapes.columns[index];
        if (detail::turned_back(shapes.base, shape.top.front()).y() < depth) {
            continue;  // overtopped on its toe side: there is no water in front of the face
        }
        const Polygon<> below = clip(shape.outline(), HalfPlane<>{right, left});
        const AreaProperties<> displaced = area_properties(below);
        const double lift = 9810 * displaced.area;
        const Column<>& a = dry.columns[index];
        const Column<>& b = wet.columns[index];
        EXPECT_NEAR(a.normal_force - b.normal_force, lift * shapes.base.cosine, 1e-9 * lift);
        EXPECT_NEAR(a.down_dip_force - b.down_dip_force, lift * shapes.base.sine, 1e-9 * lift);
        ++compared;
    }
    EXPECT_GT(compared, 3);
}

TEST(ColumnLoads, ActWhereTheyAre) {
    ColumnScene<> scene = goodman_bray();
    const ColumnSlope<> bare = make_columns(scene);
    scene.point_load = {{.block = 4, .force = 1e6, .plunge = degrees(90), .height = 16}};
    scene.bolt = {{.block = 1, .force = 2e6, .plunge = 0, .height = 3}};
    const ColumnSlope<> loaded = make_columns(scene);
    const double sine = std::sin(degrees(30));
    const double cosine = std::cos(degrees(30));
    EXPECT_NEAR(loaded.columns[3].down_dip_force - bare.columns[3].down_dip_force, 1e6 * sine, 1e-6);
    EXPECT_NEAR(loaded.columns[3].overturning_moment - bare.columns[3].overturning_moment,
                1e6 * (16 * sine - 5 * cosine), 1e-5);
    EXPECT_NEAR(loaded.columns[0].down_dip_force - bare.columns[0].down_dip_force, -2e6 * cosine, 1e-6);
    EXPECT_NEAR(loaded.columns[0].normal_force - bare.columns[0].normal_force, 2e6 * sine, 1e-6);
    EXPECT_NEAR(loaded.columns[0].overturning_moment - bare.columns[0].overturning_moment, -2e6 * 3 * cosine, 1e-5);
}

TEST(ColumnLoads, SurchargeOnTheGroundIsSharedOutWhole) {
    ColumnScene<> scene = continuous(92.5, 10);
    const auto total = [](const ColumnSlope<>& slope) {
        double down = 0;
        for (const Column<>& column : slope.columns) {
            down += column.down_dip_force * std::sin(slope.base_dip) + column.normal_force * std::cos(slope.base_dip);
        }
        return down;
    };
    const double bare = total(make_columns(scene));
    scene.surcharge = {{.pressure = 1e5, .from_distance = 2, .to_distance = 19}};
    scene.line_load = {{.force = 3e5, .plunge = degrees(90), .distance_behind_crest = 7}};
    EXPECT_NEAR(total(make_columns(scene)) - bare, 17e5 + 3e5, 1e-3);  // of a weight of 6e7 N
}

TEST(SlideHead, WedgeThatStandsByItselfGivesNoThrust) {
    const ColumnSlope<> slope = make_columns(slide_head_scene(degrees(42), degrees(72)));
    ASSERT_EQ(slope.check, ColumnCheck::valid);
    SlideHeadWedge<> wedge = *slope.slide_head;
    wedge.friction_angle = degrees(73);
    const SlideHeadThrust<> stands = slide_head_thrust(wedge, slope.base_dip, 0.5, 1.0);
    EXPECT_EQ(stands.state, SlideHeadState::stands);
    EXPECT_EQ(stands.force, 0);
    EXPECT_NEAR(stands.own_factor_of_safety, std::tan(degrees(73)) / std::tan(degrees(72)), 1e-13);
    wedge.friction_angle = 0;
    wedge.cohesion = wedge.weight * std::sin(degrees(72)) / wedge.joint_length * 1.0001;
    EXPECT_EQ(slide_head_thrust(wedge, slope.base_dip, 0.5, 1.0).state, SlideHeadState::stands);
    wedge.cohesion *= 0.999;
    EXPECT_EQ(slide_head_thrust(wedge, slope.base_dip, 0.5, 1.0).state, SlideHeadState::pushes);
}

// Frictionless: three forces, the weight, one normal to the joint, one normal to the columns.
TEST(SlideHead, FrictionlessThrustIsThatOfThreeForces) {
    const ColumnSlope<> slope = make_columns(slide_head_scene(degrees(42), degrees(72)));
    SlideHeadWedge<> wedge = *slope.slide_head;
    wedge.friction_angle = 0;
    const SlideHeadThrust<> thrust = slide_head_thrust(wedge, slope.base_dip, 0.0, 1.0);
    EXPECT_NEAR(thrust.force, wedge.weight * std::sin(degrees(72)) / std::cos(degrees(72 - 5)), 1e-12 * thrust.force);
    EXPECT_EQ(thrust.shear, 0);
}

// A vertical joint carries no weight: the columns' face has to, less what friction carries there and on the joint.
TEST(SlideHead, VerticalJointLeansOnTheColumnsOnly) {
    const ColumnSlope<> slope = make_columns(slide_head_scene(degrees(42), degrees(90)));
    SlideHeadWedge<> wedge = *slope.slide_head;
    wedge.friction_angle = 0;
    const double friction = 0.3;
    const SlideHeadThrust<> thrust = slide_head_thrust(wedge, slope.base_dip, friction, 1.0);
    const double lifted = thrust.force * std::sin(degrees(5)) + thrust.shear * std::cos(degrees(5));
    EXPECT_NEAR(lifted, wedge.weight, 1e-12 * wedge.weight);
}

// Lifted off its joint by water, or by columns that drag more than it weighs, a wedge still leans on the last of them.
TEST(SlideHead, WedgeThatIsLiftedOffLeansOnTheColumns) {
    ColumnScene<> scene = slide_head_scene(degrees(42), degrees(72));
    const double weight = make_columns(scene).slide_head->weight;
    int lifted = 0;
    double last = -1;
    for (const double water_weight : {0.0, 10e3, 20e3, 30e3, 60e3, 120e3}) {
        for (const double friction : {0.1, 0.6, 40.0}) {
            scene.slide_head->cohesion = 0;
            scene.slide_head->water = HeadWater<>{.unit_weight = 1 + water_weight, .filled_ratio = 1};
            const ColumnSlope<> slope = make_columns(scene);
            const SlideHeadWedge<>& wedge = *slope.slide_head;
            const SlideHeadThrust<> thrust = slide_head_thrust(wedge, slope.base_dip, friction, 1.0);
            ASSERT_GE(thrust.normal_force, 0);
            if (thrust.state != SlideHeadState::lifts_off) {
                continue;
            }
            ++lifted;
            EXPECT_GT(thrust.force, 0);
            EXPECT_LE(std::abs(thrust.shear), friction * thrust.force * (1 + 1e-12));
            if (std::abs(thrust.shear) < friction * thrust.force) {
                const double into = wedge.force_x * std::sin(degrees(72)) - wedge.force_y * std::cos(degrees(72));
                const double along = -wedge.force_x * std::cos(degrees(72)) - wedge.force_y * std::sin(degrees(72));
                const double opening = degrees(72) - slope.base_dip;
                // Only water acts on the joint: loads and reaction of the column along it and normal to it.
                EXPECT_NEAR(thrust.force * std::cos(opening) + thrust.shear * std::sin(opening), along, 1e-9 * weight);
                EXPECT_NEAR(thrust.force * std::sin(opening) - thrust.shear * std::cos(opening),
                            wedge.water_force - into, 1e-9 * weight);
            }
        }
    }
    EXPECT_GT(lifted, 5);
    // There is no jump where the joint's normal force vanishes.
    int transitions = 0;
    SlideHeadState state = SlideHeadState::pushes;
    for (double water_weight = 1; water_weight < 60e3; water_weight += 10) {
        scene.slide_head->water = HeadWater<>{.unit_weight = water_weight, .filled_ratio = 1};
        const ColumnSlope<> slope = make_columns(scene);
        const SlideHeadThrust<> thrust = slide_head_thrust(*slope.slide_head, slope.base_dip, 0.6, 1.0);
        if (last >= 0) {
            EXPECT_NEAR(thrust.force, last, 2e-3 * weight) << water_weight;
        }
        transitions += thrust.state != state ? 1 : 0;
        state = thrust.state;
        last = thrust.force;
    }
    EXPECT_EQ(transitions, 1);
    EXPECT_EQ(state, SlideHeadState::lifts_off);
}

// All forces on the pushing wedge, and their moments about the end of the base, sum to nothing.
TEST(SlideHead, WedgeIsInEquilibrium) {
    ColumnScene<> scene = slide_head_scene(degrees(42), degrees(70));
    scene.seismic = SeismicLoad<>{.horizontal_coefficient = 0.05, .vertical_coefficient = 0};
    scene.slide_head->water = HeadWater<>{.unit_weight = 9810, .filled_ratio = 0.3};
    scene.slide_head->cohesion = 2e4;
    const ColumnSlope<> slope = make_columns(scene);
    const SlideHeadWedge<>& wedge = *slope.slide_head;
    const double reduction = 1.2;
    const SlideHeadThrust<> thrust = slide_head_thrust(wedge, slope.base_dip, 0.6, reduction);
    ASSERT_EQ(thrust.state, SlideHeadState::pushes);
    const auto direction = [](double angle) { return PlanePoint<>(std::cos(angle), std::sin(angle)); };
    const PlanePoint<> along = direction(degrees(70));
    const PlanePoint<> normal = direction(degrees(160));
    const double shear = (thrust.normal_force * std::tan(degrees(30)) + 2e4 * wedge.joint_length) / reduction;
    const PlanePoint<> reaction = (thrust.normal_force + wedge.water_force) * normal + shear * along;
    const PlanePoint<> push =
        thrust.force * direction(slope.base_dip) + thrust.shear * direction(slope.base_dip + degrees(90));
    const PlanePoint<> sum = PlanePoint<>(wedge.force_x, wedge.force_y) + reaction + push;
    EXPECT_NEAR(sum.norm(), 0, 1e-12 * wedge.weight);
    // Loads and the joint's reaction meet on the joint, so the thrust must pass there, too.
    const double height = thrust.height - wedge.face_base;
    ASSERT_GT(height, 0);
    ASSERT_LT(height, wedge.face_length);
    const PlanePoint<> from_thrust = wedge.reaction_position * along - height * direction(slope.base_dip + degrees(90));
    EXPECT_NEAR(detail::cross<double>(from_thrust, push), 0, 1e-10 * wedge.weight * wedge.joint_length);
}

TEST(SlideHead, AreaOfWedgeAndColumnsIsThatOfTheSlopeAboveTheBase) {
    const ColumnScene<> scene = slide_head_scene(degrees(45), degrees(72));
    const ColumnSlope<> slope = make_columns(scene);
    double area = slope.slide_head->weight / 27e3;
    for (const Column<>& column : slope.columns) {
        area += column.weight / 27e3;
    }
    const double h = 225 * 0.3048;
    const double e = 75 * 0.3048;
    const double end = e / std::tan(degrees(45));
    const double above_line =
        area_properties<double>(
            {{0, 0}, {end, e}, {end + (h - e) / std::tan(degrees(72)), h}, {h / std::tan(degrees(70)), h}})
            .area;
    double below_line = 0;  // triangles between the bases and the line through their toe corners
    for (const Column<>& column : slope.columns) {
        below_line += column.width * column.width * std::tan(degrees(40)) / 2;
    }
    EXPECT_NEAR(area, above_line + below_line, 1e-10 * area);
}

TEST(ColumnChecks, NameWhatIsWrong) {
    const auto check_after = [](const auto& change) {
        ColumnScene<> scene = slide_head_scene(degrees(42), degrees(72));
        change(scene);
        return make_columns(scene).check;
    };
    const auto layout = [](ColumnScene<>& scene) -> ContinuousColumns<>& {
        return std::get<ContinuousColumns<>>(scene.columns);
    };
    EXPECT_EQ(check_after([](ColumnScene<>&) {}), ColumnCheck::valid);
    EXPECT_EQ(check_after([&](ColumnScene<>& s) { layout(s).base_inclination = degrees(4); }),
              ColumnCheck::base_flatter_than_joints_allow);
    EXPECT_EQ(check_after([&](ColumnScene<>& s) { layout(s).base_inclination = degrees(70); }),
              ColumnCheck::base_does_not_daylight);
    EXPECT_EQ(check_after([&](ColumnScene<>& s) { layout(s).base_end_height = 80; }),
              ColumnCheck::base_end_outside_slope);
    EXPECT_EQ(check_after([&](ColumnScene<>& s) { layout(s).base_end_height.reset(); }),
              ColumnCheck::slide_head_needs_base_end);
    EXPECT_EQ(check_after([&](ColumnScene<>& s) { layout(s).spacing = 1e-6; }), ColumnCheck::too_many_columns);
    EXPECT_EQ(check_after([](ColumnScene<>& s) { s.slope->upper_surface_dip = degrees(73); }),
              ColumnCheck::head_joint_never_surfaces);
    EXPECT_EQ(check_after([](ColumnScene<>& s) { s.rock.unit_weight = -1; }), ColumnCheck::input_out_of_range);
    EXPECT_EQ(check_after([](ColumnScene<>& s) { s.bolt = {{400, 1, 0, 0}}; }), ColumnCheck::load_outside_columns);
    EXPECT_EQ(check_after([](ColumnScene<>& s) { s.bolt = {{1, 1, 0, 40}}; }), ColumnCheck::load_outside_columns);
    EXPECT_EQ(check_after([](ColumnScene<>& s) {
                  s.slope->toe_elevation.reset();
                  s.water = WaterTable<>{9810, WaterElevation<>{100}};
              }),
              ColumnCheck::elevation_without_datum);
    EXPECT_EQ(check_after([](ColumnScene<>& s) {
                  s.water = PiezometricLineWater<>{9810, {{3, 1}, {3, 2}}};
              }),
              ColumnCheck::water_points_not_increasing);
    EXPECT_EQ(check_after([](ColumnScene<>& s) {
                  s.columns = BlockColumns<>{degrees(60), {{1, 1, 2, {}}, {1, 1, 0, {}}}};
              }),
              ColumnCheck::step_larger_than_block);
    EXPECT_EQ(check_after([](ColumnScene<>& s) {
                  s.columns = BlockColumns<>{degrees(60), {}};
              }),
              ColumnCheck::no_columns);
    EXPECT_EQ(check_after([](ColumnScene<>& s) { s.slope.reset(); }), ColumnCheck::slope_needed);
}

}  // namespace
