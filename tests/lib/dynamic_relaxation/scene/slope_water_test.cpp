// Water on the faces of blocks that joints cut: the pressure below a table of any shape, integrated along each face.
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "dynamic_relaxation/scene/water_table.hpp"
#include "dynamic_relaxation/step/loads.hpp"
#include "dynamic_relaxation/step/state.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"
#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace delabole {
namespace {

using testing::cut;
using testing::joint_of_friction;
using testing::joint_set;
using testing::line;
using testing::square;

constexpr double water_weight = 9810;
constexpr double gravity = 9.80665;
constexpr double density = 2650;

RelaxationSlope wet_slope_of(std::vector<SectionPoint> outline, std::vector<SlopeCut> cuts) {
    RelaxationSlope slope{};
    slope.geometry = testing::section(std::move(outline), std::move(cuts));
    slope.rock = {{"rock", density}};
    slope.joint = {{"joint", {}, joint_of_friction(30)}, {"other", {}, joint_of_friction(30)}};
    slope.geometry.intact_joint = "joint";
    return slope;
}

RelaxationSlope cut_by_three_sets() {
    return wet_slope_of({{0, 0}, {20, 0}, {20, 12}, {12, 12}},
                        {cut("a", joint_set(degrees(70), 2)), cut("b", joint_set(degrees(-15), 1.3)),
                         cut("c", joint_set(degrees(-88), 3))});
}

struct Resultant {
    PlanePoint<> force{0, 0};
    double moment = 0;  // about the centroid
};

std::vector<Resultant> resultants(const SlopeScene& made) {
    RelaxationScene scene;
    scene.block = made.block;
    const Bodies bodies = make_bodies(scene);
    std::vector<Resultant> sums(bodies.size());
    for (const FacePressure& pressure : made.pressure) {
        const FaceForce force = force_of(pressure, bodies, Motion{});
        sums[pressure.block].force += force.force;
        sums[pressure.block].moment += cross(force.arm, force.force);
    }
    return sums;
}

TEST(SlopeWater, LiftsEachBlockByWhatItDisplaces) {
    RelaxationSlope slope = cut_by_three_sets();
    // A pond in front of the slope presses on the face too.
    slope.water = SlopeWater{water_weight, {{-5, 6.3}, {30, 6.3}}};
    const SlopeScene scene = slope_scene(slope);
    ASSERT_EQ(scene.check, SlopeCheck::valid) << word_of(scene.check);
    const std::vector<Resultant> sums = resultants(scene);
    const HalfPlane<> wet{{30, 6.3}, {-5, 6.3}};
    std::size_t partly = 0;
    for (std::size_t block = 0; block < scene.block.size(); ++block) {
        const Polygon<> below = clip(scene.block[block].outline, wet);
        const PlanePoint<> centroid = area_properties(scene.block[block].outline).centroid;
        const double whole = area_properties(scene.block[block].outline).area;
        const double displaced = below.size() < 3 ? 0 : area_properties(below).area;
        partly += displaced > 0.01 * whole && displaced < 0.99 * whole ? 1 : 0;
        // Blocks put a corner that is off a straight face by 1e-9 of its length on it; forces of some 1e5 N/m.
        constexpr double rounding = 1e-3;
        EXPECT_NEAR(sums[block].force.x(), 0, rounding);
        EXPECT_NEAR(sums[block].force.y(), water_weight * displaced, rounding);
        if (displaced > 0) {
            const double arm = area_properties(below).centroid.x() - centroid.x();
            EXPECT_NEAR(sums[block].moment, arm * water_weight * displaced, rounding);
        }
    }
    EXPECT_GT(partly, 10U);
}

TEST(SlopeWater, ActsByTheShareOfTheJoint) {
    RelaxationSlope slope =
        wet_slope_of(square(6), {cut("upright", joint_set(degrees(90), 2, 1)), cut("level", joint_set(0, 2, 1))});
    slope.water = SlopeWater{water_weight, {{-1, 10}, {10, 10}}};
    const auto total = [](const RelaxationSlope& of) {
        double sum = 0;
        for (const FacePressure& pressure : slope_scene(of).pressure) {
            sum += pressure.at_first + pressure.at_second;
        }
        return sum;
    };
    RelaxationSlope dry = slope;
    dry.joint[0].water_share = 0;
    RelaxationSlope half = slope;
    half.joint[0].water_share = 0.5;
    // The surface, which is under water too, keeps its whole pressure.
    EXPECT_GT(total(dry), 0);
    EXPECT_NEAR(total(half), (total(dry) + total(slope)) / 2, 1e-9 * total(slope));
}

// Kinks above, on and below faces of every direction, two of them over one point of a face's ends, and a table that
// comes out of a face and goes back into it.
const std::vector<std::vector<SectionPoint>> tables{
    {{-5, 6.3}, {30, 6.3}},
    {{0, 1}, {4, 2.5}, {7.3, 6}, {11, 5}, {20, 11}},
    {{2, -1}, {6, 9}, {6.001, 2}, {12, 12}, {13, 0.5}, {14, 12}},
    {{5, -3}, {9, 6.5}, {9.7, 6.5}, {25, -3}},
};

TEST(SlopeWater, IsIntegratedBetweenAllKinks) {
    for (std::size_t number = 0; number < tables.size(); ++number) {
        RelaxationSlope slope = cut_by_three_sets();
        slope.water = SlopeWater{water_weight, tables[number]};
        const SlopeScene scene = slope_scene(slope);
        ASSERT_EQ(scene.check, SlopeCheck::valid) << word_of(scene.check);
        RelaxationStudy study{};
        study.model.scene = slope;
        EXPECT_EQ(check(study).check, SceneCheck::valid) << number;
        const std::vector<Resultant> sums = resultants(scene);
        double greatest = 0;
        for (std::size_t block = 0; block < scene.block.size(); ++block) {
            const Polygon<>& outline = scene.block[block].outline;
            const PlanePoint<> centroid = area_properties(outline).centroid;
            Resultant sum;
            constexpr int parts = 4000;
            for (std::size_t edge = 0; edge < outline.size(); ++edge) {
                const PlanePoint<> along = outline[(edge + 1) % outline.size()] - outline[edge];
                for (int part = 0; part < parts; ++part) {
                    const PlanePoint<> at = outline[edge] + (part + 0.5) / parts * along;
                    const double depth = water_table_height(tables[number], at.x()) - at.y();
                    const PlanePoint<> force =
                        water_weight * std::max(0.0, depth) / parts * PlanePoint<>(-along.y(), along.x());
                    sum.force += force;
                    sum.moment += cross(at - centroid, force);
                }
            }
            // The middle rule errs, in the part with a kink, by half the jump of slope, here up to 7000, times the
            // square of the part, of up to 5 m / 4000.
            const double error = water_weight * 7000 / 2 * std::pow(5.0 / parts, 2) * 3;
            EXPECT_NEAR((sums[block].force - sum.force).norm(), 0, error) << number << ' ' << block;
            EXPECT_NEAR(sums[block].moment, sum.moment, 3 * error) << number << ' ' << block;
            greatest = std::max(greatest, sum.force.norm());
        }
        EXPECT_GT(greatest, 1e4) << number;
    }
}

TEST(SlopeWater, DepthsAlongAFaceAreThoseOfTheTable) {
    const std::vector<SectionPoint> table{{0, 0}, {1, 4}, {2, 0}, {3, 4}, {4, 0}};
    const auto expect_depths = [&](PlanePoint<> from, PlanePoint<> to, const std::vector<FaceDepth>& expected) {
        for (const bool back : {false, true}) {
            const std::vector<FaceDepth> depths = back ? depths_along(table, to, from) : depths_along(table, from, to);
            ASSERT_EQ(depths.size(), expected.size());
            const double length = (to - from).norm();
            for (std::size_t index = 0; index < depths.size(); ++index) {
                const FaceDepth& known = expected[back ? expected.size() - 1 - index : index];
                EXPECT_NEAR(depths[index].place, back ? length - known.place : known.place, 1e-14);
                EXPECT_NEAR(depths[index].depth, known.depth, 1e-14);
            }
        }
    };
    expect_depths({0, 2}, {4, 2}, {{0, 0}, {0.5, 0}, {1, 2}, {1.5, 0}, {2, 0}, {2.5, 0}, {3, 2}, {3.5, 0}, {4, 0}});
    expect_depths({1, -1}, {1, 6}, {{0, 5}, {5, 0}, {7, 0}});  // upright, at a kink
    expect_depths({1, -1}, {3, -1}, {{0, 5}, {1, 1}, {2, 5}});
    expect_depths({1, 4}, {3, 4}, {{0, 0}, {1, 0}, {2, 0}});
    expect_depths({-5, -1}, {-3, -1}, {{0, 1}, {2, 1}});  // level beyond the table's end
    expect_depths({0, 0}, {1, 4}, {{0, 0}, {std::sqrt(17.0), 0}});
}

// A slope of 12 m, two to one, with a plane of three to four from half a metre above its toe to an upright crack behind
// the crest. Doubles hold all points of the plane that are used.
const double dip = std::atan(0.75);
PlanePoint<> toe_of_plane() {
    return {0.25, 0.5};
}
constexpr double crack_x = 12.25;
constexpr double crest_x = 6;
constexpr double depth_in_crack = 2;
constexpr double kink_x = 6.25;

double plane_y(double x) {
    return toe_of_plane().y() + (x - toe_of_plane().x()) * 0.75;
}

// The water stands 2 m high in the crack and comes out at the plane's toe, whatever its depth between them.
RelaxationStudy sliding_on_water(double depth_at_kink) {
    const PlanePoint<> toe = toe_of_plane();
    RelaxationSlope slope =
        wet_slope_of({{-10, -6}, {30, -6}, {30, 12}, {crest_x, 12}, {0, 0}, {-10, 0}},
                     {cut("plane", line({{toe.x(), toe.y()}, {crack_x, plane_y(crack_x)}, {crack_x, 12}}))});
    slope.frame = SlopeFrame{FrameSides::all_around, 3, {}, "joint"};
    slope.fixed = {
        {{{-11, -7}, {31, -7}, {31, 13}, {crack_x, 13}, {crack_x, plane_y(crack_x)}, {toe.x(), toe.y()}, {-11, 0.5}}}};
    slope.water = SlopeWater{
        water_weight,
        {{toe.x(), toe.y()}, {kink_x, plane_y(kink_x) + depth_at_kink}, {crack_x, plane_y(crack_x) + depth_in_crack}}};
    RelaxationStudy study{};
    study.model.scene = slope;
    study.settings = RelaxationNumerics{};
    study.settings->stop = RelaxationStop::onset;
    FrictionSearch search{};
    search.lower = degrees(30);
    search.upper = degrees(60);
    study.critical = search;
    return study;
}

// tan(phi) = (W sin + V cos) / (W cos - U - V sin), with the piezometric line over the plane in U.
double friction_by_hand(double depth_at_kink) {
    const PlanePoint<> toe = toe_of_plane();
    const Polygon<> wedge{toe, {crack_x, plane_y(crack_x)}, {crack_x, 12}, {crest_x, 12}};
    const double weight = density * gravity * area_properties(wedge).area;
    const double below = (kink_x - toe.x()) * depth_at_kink / 2;
    const double above = (crack_x - kink_x) * (depth_at_kink + depth_in_crack) / 2;
    const double uplift = water_weight * (below + above) / std::cos(dip);
    const double thrust = water_weight * depth_in_crack * depth_in_crack / 2;
    return std::atan((weight * std::sin(dip) + thrust * std::cos(dip)) /
                     (weight * std::cos(dip) - uplift - thrust * std::sin(dip)));
}

// Half the bracket of 0.005 deg; springs and the frame's rounding add next to nothing.
const double bracket = degrees(0.003);
const double straight = depth_in_crack * (kink_x - toe_of_plane().x()) / (crack_x - toe_of_plane().x());

TEST(SlopeWater, KinksBetweenTheEndsOfAFaceDecideWhetherItSlides) {
    for (const double depth : {0.2, straight, 4.0}) {
        const CriticalAnswer found = find_critical(sliding_on_water(depth));
        ASSERT_EQ(found.status, CriticalStatus::found) << depth;
        EXPECT_NEAR(found.value(), friction_by_hand(depth), bracket) << depth;
    }
    // 40.19, 41.98 and 50.01 deg: far apart.
    EXPECT_GT(friction_by_hand(straight) - friction_by_hand(0.2), degrees(1.5));
    EXPECT_GT(friction_by_hand(4.0) - friction_by_hand(straight), degrees(7));
}

TEST(SlopeWater, VerticesOnAFaceChangeNothing) {
    const double depth = 4;
    const RelaxationStudy study = sliding_on_water(depth);
    const PlanePoint<> toe = toe_of_plane();
    // The added vertices lie on the outline, on the trace, and at corners of the blocks below on the plane.
    RelaxationStudy more = study;
    auto& cornered = std::get<RelaxationSlope>(more.model.scene);
    cornered.geometry.outline = {{-10, -6}, {30, -6}, {30, 12}, {9, 12}, {crest_x, 12}, {3, 6}, {0, 0}, {-10, 0}};
    std::get<LineCut>(cornered.geometry.cut[0].trace).vertex = {
        {toe.x(), toe.y()}, {kink_x, plane_y(kink_x)}, {crack_x, plane_y(crack_x)}, {crack_x, 12}};
    cornered.geometry.cut.push_back(cut("below", line({{4.25, -6}, {4.25, plane_y(4.25)}})));
    const auto on_wedge = [](const RelaxationStudy& of) {
        const SlopeScene scene = slope_scene(std::get<RelaxationSlope>(of.model.scene));
        EXPECT_EQ(scene.check, SlopeCheck::valid) << word_of(scene.check);
        EXPECT_FALSE(scene.block[0].fixed);
        EXPECT_TRUE(scene.block[1].fixed);
        return resultants(scene)[0];
    };
    const Resultant expected = on_wedge(study);
    const Resultant sum = on_wedge(more);
    const double rounding = 1e-8 * expected.force.norm();  // of a vertex that is put on the face
    EXPECT_NEAR((sum.force - expected.force).norm(), 0, rounding);
    EXPECT_NEAR(sum.moment, expected.moment, 10 * rounding);
    const CriticalAnswer found = find_critical(more);
    ASSERT_EQ(found.status, CriticalStatus::found);
    EXPECT_NEAR(found.value(), friction_by_hand(depth), bracket);
}

// A face in two pieces, wherever it is divided, has the force and moment of the whole.
TEST(SlopeWater, OfAFaceIsThatOfItsPieces) {
    const auto integral = [](const std::vector<FaceDepth>& depths, double from) {
        PlanePoint<> sum(0, 0);
        for (std::size_t piece = 1; piece < depths.size(); ++piece) {
            const FaceDepth& one = depths[piece - 1];
            const FaceDepth& two = depths[piece];
            const double length = two.place - one.place;
            const double moment = one.depth * (one.place + length / 3) + two.depth * (two.place - length / 3);
            sum += length / 2 * PlanePoint<>(one.depth + two.depth, moment + from * (one.depth + two.depth));
        }
        return sum;
    };
    const PlanePoint<> start(1, -0.5);
    const PlanePoint<> end(15, 8);
    const double length = (end - start).norm();
    for (const std::vector<SectionPoint>& table : tables) {
        const PlanePoint<> whole = integral(depths_along(table, start, end), 0);
        EXPECT_GT(whole.x(), 1);
        for (const double share : {0.01, 0.2, 0.5, 0.71, 0.99}) {
            const PlanePoint<> middle = start + share * (end - start);
            const PlanePoint<> sum = integral(depths_along(table, start, middle), 0) +
                                     integral(depths_along(table, middle, end), share * length);
            EXPECT_NEAR((sum - whole).norm(), 0, 1e-12 * whole.norm()) << share;
        }
    }
}

// The lower half of the right side of a block stands against a lower block.
TEST(PressuresLeft, LackWhatDrainsBesideABlockTakenAway) {
    using relaxation_scenes::rectangle;
    RelaxationScene scene;
    scene.block = {{rectangle(0, 0, 1, 2), density}, {rectangle(1, 0, 1, 1), density}};
    scene.pressure = {{0, 1, 2e3, 0, {}, true}, {0, 1, 3e3, 1e3, {}, false}, {1, 1, 5e2, 0, {}, true}};
    const Bodies bodies = make_bodies(scene);
    const std::vector<FacePressure> left = pressures_left(scene, bodies, {0, taken_away});
    ASSERT_EQ(left.size(), 3U);
    ASSERT_TRUE(left[0].part);
    EXPECT_NEAR(left[0].part->begin, 1, 1e-12);
    EXPECT_NEAR(left[0].part->end, 2, 1e-12);
    EXPECT_NEAR(left[0].at_first, 1e3, 1e-9);
    EXPECT_EQ(left[0].at_second, 0);
    EXPECT_FALSE(left[1].part) << "does not drain";
    EXPECT_FALSE(left[2].part) << "shared with no block";
    for (const std::vector<char>& removed : {std::vector<char>{0, 0}, std::vector<char>{0, has_left}}) {
        EXPECT_FALSE(pressures_left(scene, bodies, removed)[0].part);
    }
}

}  // namespace
}  // namespace delabole
