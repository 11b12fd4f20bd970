// The search for the least stable stepped base, and what it leaves standing.
#include "limit_equilibrium/stepped_base/critical_base.hpp"
#include "limit_equilibrium/columns/base_profile.hpp"
#include "tests/lib/limit_equilibrium/columns/reference_recursion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace delabole;

// 60 m at 65 deg, joints 70 deg into the slope, level ground behind.
ColumnScene<> scene_of_base(double inclination, std::optional<double> end_height) {
    return {
        .slope =
            SlopeSection<>{
                .height = 60, .face_dip = degrees(65), .upper_surface_dip = 0, .bench = {}, .toe_elevation = {}},
        .columns =
            ContinuousColumns<>{
                .joint_dip = degrees(70), .spacing = 4, .base_inclination = inclination, .base_end_height = end_height},
        .rock = {.unit_weight = 26e3},
        .water = Dry{},
        .seismic = {},
        .surcharge = {},
        .line_load = {},
        .point_load = {},
        .bolt = {},
        .support = {},
        .slide_head = {}};
}

double safety(const ColumnScene<>& scene) {
    const ColumnSlope<> slope = make_columns(scene);
    const double friction = std::tan(degrees(38));
    return slope.check == ColumnCheck::valid ? test::factor_of_safety(slope, friction, friction)
                                             : std::numeric_limits<double>::infinity();
}

CriticalBaseSearch<> search_for(CriticalBaseFeature feature) {
    return {.find = feature,
            .under = SearchCondition::given_water,
            .lower_inclination = {},
            .upper_inclination = {},
            .lower_end_height = {},
            .upper_end_height = {}};
}

const ContinuousColumns<>& layout(const CriticalBase& critical) {
    return std::get<ContinuousColumns<>>(critical.scene.columns);
}

TEST(CriticalBase, NoInclinationOfAFineScanIsLessStable) {
    const CriticalBase critical =
        find_critical_base(scene_of_base(degrees(30), {}), search_for(CriticalBaseFeature::base_inclination), safety);
    ASSERT_EQ(critical.check, ColumnCheck::valid);
    EXPECT_EQ(safety(critical.scene), critical.factor_of_safety);
    double least = std::numeric_limits<double>::infinity();
    for (double inclination = degrees(20.01); inclination < degrees(64.9); inclination += degrees(0.05)) {
        least = std::min(least, safety(scene_of_base(inclination, {})));
    }
    EXPECT_LE(critical.factor_of_safety, least * (1 + 1e-9));
}

TEST(CriticalBase, NoExtentOfAFineScanIsLessStable) {
    const CriticalBase critical =
        find_critical_base(scene_of_base(degrees(40), {}), search_for(CriticalBaseFeature::extent), safety);
    ASSERT_EQ(critical.check, ColumnCheck::valid);
    ASSERT_TRUE(layout(critical).base_end_height);
    EXPECT_FALSE(critical.at_boundary);
    EXPECT_EQ(safety(critical.scene), critical.factor_of_safety);
    EXPECT_GT(safety(scene_of_base(degrees(40), {})), critical.factor_of_safety);
    for (double height = 1; height < 59; height += 0.1) {
        // The search stops where the slope of the factor of safety changes sign; the factor itself is flat there.
        EXPECT_GE(safety(scene_of_base(degrees(40), height)), critical.factor_of_safety * (1 - 1e-8)) << height;
    }
}

// If the search is for the dry slope, its result has the water of the scene again.
TEST(CriticalBase, DrySearchKeepsTheWaterOfTheScene) {
    ColumnScene<> scene = scene_of_base(degrees(40), {});
    CriticalBaseSearch<> request = search_for(CriticalBaseFeature::extent);
    request.under = SearchCondition::dry_slope;
    const CriticalBase dry = find_critical_base(scene, request, safety);
    scene.water = FilledJointsWater<>{.unit_weight = 9810, .filled_ratio = 0.3};
    const CriticalBase wet = find_critical_base(scene, request, safety);
    EXPECT_EQ(wet.factor_of_safety, dry.factor_of_safety);
    EXPECT_EQ(layout(wet).base_end_height, layout(dry).base_end_height);
    EXPECT_TRUE(std::holds_alternative<FilledJointsWater<>>(wet.scene.water));
    EXPECT_LT(safety(wet.scene), dry.factor_of_safety);
}

TEST(CriticalBase, BothTogetherAreNoMoreStableThanEither) {
    const ColumnScene<> scene = scene_of_base(degrees(40), {});
    const double both = find_critical_base(scene, search_for(CriticalBaseFeature::both), safety).factor_of_safety;
    const double inclination =
        find_critical_base(scene, search_for(CriticalBaseFeature::base_inclination), safety).factor_of_safety;
    const double extent = find_critical_base(scene, search_for(CriticalBaseFeature::extent), safety).factor_of_safety;
    EXPECT_LE(both, extent * (1 + 1e-8));
    EXPECT_LE(both, inclination * (1 + 1e-8));
}

TEST(CriticalBase, RangeThatExcludesTheMinimumIsReported) {
    CriticalBaseSearch<> request = search_for(CriticalBaseFeature::base_inclination);
    const double free = layout(find_critical_base(scene_of_base(degrees(30), {}), request, safety)).base_inclination;
    request.lower_inclination = free + degrees(3);
    request.upper_inclination = free + degrees(5);
    const CriticalBase bounded = find_critical_base(scene_of_base(degrees(30), {}), request, safety);
    EXPECT_TRUE(bounded.at_boundary);
    request.lower_inclination = degrees(50);
    request.upper_inclination = degrees(40);
    EXPECT_EQ(find_critical_base(scene_of_base(degrees(30), {}), request, safety).check,
              ColumnCheck::base_does_not_daylight);
}

TEST(CriticalBase, BlocksOneByOneHaveNoBaseToSearchFor) {
    ColumnScene<> scene = scene_of_base(degrees(40), {});
    scene.columns = BlockColumns<>{degrees(60), {{2, 1, 0, {}}}};
    EXPECT_EQ(find_critical_base(scene, search_for(CriticalBaseFeature::extent), safety).check,
              ColumnCheck::slope_needed);
}

// Area between the old ground and the one left is the area of the columns that went, and of the wedge.
TEST(GroundAfterToppling, LosesTheColumnsThatMove) {
    ColumnScene<> scene = scene_of_base(degrees(40), 25.0);
    scene.slide_head = SlideHead<>{.joint_dip = degrees(72), .friction_angle = degrees(30), .cohesion = 0, .water = {}};
    const ColumnSlope<> slope = make_columns(scene);
    ASSERT_EQ(slope.check, ColumnCheck::valid);
    const std::size_t all = slope.columns.size();
    for (const std::size_t moving : {std::size_t{1}, std::size_t{3}, all}) {
        double area = moving == all ? slope.slide_head->weight / 26e3 : 0;
        for (std::size_t index = 0; index < moving; ++index) {
            area += slope.columns[index].weight / 26e3;
        }
        Polyline left = ground_after_toppling(scene, moving, BaseOutline::steps);
        ASSERT_GT(left.size(), 3U);
        const double crest_x = 60 / std::tan(degrees(65));
        if (left.back().x() > crest_x) {
            left.emplace_back(crest_x, 60);
        }
        EXPECT_NEAR(area_properties<double>(left).area, area, 1e-9 * area) << moving;
    }
    EXPECT_TRUE(ground_after_toppling(scene, 0, BaseOutline::steps).empty());
}

TEST(GroundAfterToppling, EnvelopeHasTheInclinationOfTheBase) {
    const Polyline left = ground_after_toppling(scene_of_base(degrees(40), {}), 3, BaseOutline::envelope);
    ASSERT_GT(left.size(), 2U);
    EXPECT_NEAR(std::atan2(left[1].y(), left[1].x()), degrees(40), 1e-12);
}

TEST(ColumnOutlines, HaveTheWeightsOfTheColumns) {
    ColumnScene<> scene = scene_of_base(degrees(40), 25.0);
    scene.slide_head = SlideHead<>{.joint_dip = degrees(72), .friction_angle = degrees(30), .cohesion = 0, .water = {}};
    const ColumnSlope<> slope = make_columns(scene);
    const std::vector<Polyline> outlines = column_outlines(scene);
    ASSERT_EQ(outlines.size(), slope.columns.size() + 1);
    for (std::size_t index = 0; index < slope.columns.size(); ++index) {
        const double weight = slope.columns[index].weight;
        EXPECT_NEAR(area_properties<double>(outlines[index]).area * 26e3, weight, 1e-9 * weight);
    }
    const double wedge = slope.slide_head->weight;
    EXPECT_NEAR(area_properties<double>(outlines.back()).area * 26e3, wedge, 1e-9 * wedge);
}

}  // namespace
