// Tests what `delabole reproduce chapter4` prints: the numbers of the verification deck.
#include "cases/program/models/single_block/chart.hpp"
#include "limit_equilibrium/block_row/single_block.hpp"
#include "tests/cases/thesis/reproduction_fixture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

namespace delabole {
namespace {

class Chapter4 : public testing::ReproductionTest {
  protected:
    Chapter4() : ReproductionTest(chapter_4()) {}
};

// The boundaries are given to two decimals, the back-analysed ratios to four.
TEST_F(Chapter4, BoundaryAtNine) {
    const Json json = reproduce("fig4.7").json;
    EXPECT_NEAR(json["phi_35"]["boundary_psi_equal_weights_deg"].get<double>(), 24.60, 0.005);
    EXPECT_NEAR(json["phi_20"]["boundary_psi_equal_weights_deg"].get<double>(), 31.42, 0.005);
    const auto high = json["phi_35"]["weight_ratio"].get<double>();
    const auto low = json["phi_20"]["weight_ratio"].get<double>();
    EXPECT_NEAR(std::min(low, high), 0.9614, 0.00005);
    EXPECT_NEAR(std::max(low, high), 0.9620, 0.00005);
    EXPECT_NEAR(json["weight_ratio_least_squares"].get<double>(), 0.9618, 0.00005);
}

// Printed and computed are one closed form each, the limit comes from a bisection to 1e-9 deg.
TEST_F(Chapter4, TwoBlocksPressOnOneAnother) {
    const Reproduction result = reproduce("eq12-13");
    for (const std::string_view mode : {"(12) forward", "(13) backward"}) {
        const Json& row = result.json[std::string(mode)];
        EXPECT_GT(row["computed"].get<double>(), 0.1) << mode;
        EXPECT_NEAR(row["computed"].get<double>(), row["printed"].get<double>(), 1e-12) << mode;
    }
    EXPECT_NEAR(result.json["greatest_equal_friction_deg"].get<double>(), 45, 1e-8);
    EXPECT_EQ(count_rows(result.rows).met, 4);
    EXPECT_EQ(count_rows(result.rows).not_met, 0);
}

// Three blocks have five modes, all but FBB and FFB with a pivot.
TEST_F(Chapter4, DrawsWhichWayToesSlide) {
    reproduce("fig4.9");
    std::ifstream script(path() / "figures" / "fig_4_9_three.gp");
    const std::string text{std::istreambuf_iterator<char>(script), {}};
    for (const std::string_view words : {"F: toe slides forward", "B: toe slides backward", "P: toe does not slide"}) {
        EXPECT_NE(text.find(words), std::string::npos) << words;
    }
    // The letters of 4.3.1 stand above the roles of their blocks.
    std::string labels;
    for (std::size_t at = 0; (at = text.find("set label '", at)) != std::string::npos; ++at) {
        const std::size_t begin = text.find('\'', at) + 1;
        labels += text.substr(begin, text.find('\'', begin) - begin);
    }
    EXPECT_NE(labels.find("FFP(a)FPB(b)PBB(c)FBB(d)FFB(e)"), std::string::npos) << labels;
}

TEST_F(Chapter4, ThreeRatiosOfAFigureHaveOneScale) {
    reproduce("fig4.10");
    EXPECT_NE(scale_of("fig_4_10_ratio_3"), "");
    EXPECT_EQ(scale_of("fig_4_10_ratio_3"), scale_of("fig_4_10_ratio_5"));
    EXPECT_EQ(scale_of("fig_4_10_ratio_3"), scale_of("fig_4_10_ratio_7"));
}

TEST_F(Chapter4, SingleBlock) {
    const Reproduction result = reproduce("fig4.1");
    EXPECT_EQ(result.rows.size(), 7U);
    EXPECT_EQ(count_rows(result.rows).not_met, 0);
}

TEST_F(Chapter4, CountsOfTheLostFigure) {
    const Json json = reproduce("fig4.9").json;
    EXPECT_EQ(json["modes_of_2_blocks"].size(), 3U);
    EXPECT_EQ(json["modes_of_3_blocks"].size(), 5U);
    EXPECT_EQ(json["modes_of_4_blocks"].size(), 7U);
}

TEST_F(Chapter4, AThirdBlockAddsStabilityInContactOnly) {
    const Reproduction result = reproduce("eq14-19");
    const Json& rows = result.json["tilt_by_blocks"];
    const auto free = [&](int blocks) { return rows[static_cast<std::size_t>(blocks) - 1]["free_deg"].get<double>(); };
    const auto pressed = [&](int blocks) {
        return rows[static_cast<std::size_t>(blocks) - 1]["in_contact_deg"].get<double>();
    };
    const auto ceiling = result.json["ceiling_deg"].get<double>();
    constexpr double rounding = 1e-10;
    for (int blocks = 2; blocks <= 5; ++blocks) {
        EXPECT_NEAR(free(blocks), free(1), rounding);
        EXPECT_GE(pressed(blocks), pressed(blocks - 1) - rounding);
        EXPECT_LE(pressed(blocks), ceiling + rounding);
    }
    EXPECT_GT(pressed(3), pressed(2) + 0.1);
    EXPECT_NEAR(pressed(5), ceiling, rounding);
    const auto derived_equals_printed = [&](const std::string& name) {
        const Json& row = result.json[name];
        return std::abs(row["printed_deg"].get<double>() - row["derived_deg"].get<double>()) < rounding;
    };
    EXPECT_TRUE(derived_equals_printed("(15) FPB"));
    EXPECT_TRUE(derived_equals_printed("(17) FBB, equal thrusts"));
    EXPECT_FALSE(derived_equals_printed("(14) FFP"));
    EXPECT_FALSE(derived_equals_printed("(18) FFPB"));
    EXPECT_FALSE(derived_equals_printed("(19) FFPB, μ = c = tan 30"));
}

// An item that is data has its text, its table and its figures (sweep_run_test.cpp tests its numbers).
TEST_F(Chapter4, DataItemsAreDrawn) {
    const Reproduction result = reproduce("fig4.4");
    ASSERT_EQ(result.rows.size(), 1U);
    EXPECT_EQ(result.rows.front().computed, "below by up to 3.41 deg");
    for (const std::string_view file : {"fig_4_4.csv", "figures/fig_4_4.gp"}) {
        EXPECT_TRUE(std::filesystem::exists(path() / file)) << file;
    }
}

// Counts the crossings of a ray along +x.
bool lies_inside(const Polyline& outline, const Point& point) {
    bool inside = false;
    for (std::size_t index = 0; index < outline.size(); ++index) {
        const Point& from = outline[index];
        const Point& to = outline[(index + 1) % outline.size()];
        if ((from.y() > point.y()) != (to.y() > point.y()) &&
            point.x() < from.x() + (to.x() - from.x()) * (point.y() - from.y()) / (to.y() - from.y())) {
            inside = !inside;
        }
    }
    return inside;
}

std::string_view mode_in_chart(const ModeChart& chart, const Point& point) {
    std::string_view found = "none";
    for (const ModeRegion& region : chart.regions) {
        if (lies_inside(region.outline, point)) {
            EXPECT_EQ(found, "none") << "regions overlap";
            found = word_of(region.mode);
        }
    }
    return found;
}

// Every region says what the model says, on a grid that misses all straight boundaries. Points nearer than 0.1 deg to
// the curved one are decided by its polyline, and left out.
TEST(SingleBlockChart, SaysWhatTheModelSays) {
    constexpr std::array<std::string_view, 4> words{"stays", "slides", "topples", "slides and topples"};
    for (const double friction : {10.0, 35.0, 60.0}) {
        for (const BlockCriteria criteria : {BlockCriteria::superposed_static, BlockCriteria::onset_of_motion}) {
            const ModeChart chart = single_block_chart(degrees(friction), criteria, "");
            for (double inclination = 1.3; inclination < 90; inclination += 3) {
                for (double slenderness = 0.7; slenderness < 90; slenderness += 3) {
                    const auto answer = [&](double shift) {
                        SingleBlock block{};
                        block.block = {1, std::tan(degrees(slenderness)), 1e4};
                        block.base = {degrees(inclination + shift), degrees(friction), 0};
                        const SingleBlockResult result = analyse(block);
                        return criteria == BlockCriteria::onset_of_motion ? result.onset_mode : result.static_mode;
                    };
                    const BlockMotion motion = answer(0);
                    if (answer(0.1) == motion && answer(-0.1) == motion) {
                        EXPECT_EQ(mode_in_chart(chart, Point(degrees(inclination), degrees(slenderness))),
                                  words.at(static_cast<std::size_t>(motion)))
                            << friction << ' ' << inclination << ' ' << slenderness;
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace delabole
