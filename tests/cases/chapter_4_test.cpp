// What `delabole reproduce chapter4` says: the numbers of the verification deck.
#include "cases/reproduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace delabole {
namespace {

class Chapter4 : public ::testing::Test {
  protected:
    Chapter4() { std::filesystem::remove_all(path_); }
    ~Chapter4() override { std::filesystem::remove_all(path_); }
    Chapter4(const Chapter4&) = delete;
    Chapter4& operator=(const Chapter4&) = delete;

    Reproduction reproduce(const std::string& name) const {
        const ReproductionChapter chapter = chapter_4();
        const auto item = std::ranges::find(chapter.items, name, &ReproductionItem::name);
        Options options;
        options.out = path_.string();
        options.quiet = true;
        const ResultFolder folder(options, name);
        Report report;
        return item->reproduce(folder, report);
    }

  private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() /
        ("chapter_4_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
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

// Given to three decimals.
TEST_F(Chapter4, SingleBlock) {
    const Json json = reproduce("fig4.1").json;
    EXPECT_NEAR(json["topples_above_friction_deg"]["25"].get<double>(), 20.083, 5e-4);
    EXPECT_NEAR(json["topples_above_friction_deg"]["30"].get<double>(), 21.364, 5e-4);
    EXPECT_NEAR(json["topples_above_friction_deg"]["45"].get<double>(), 25.560, 5e-4);
    EXPECT_EQ(json["friction_below_slenderness_angle"], "slides");
    EXPECT_NEAR(reproduce("fig3.4").json["critical_tilt_deg"].get<double>(), 18.435, 5e-4);
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

TEST_F(Chapter4, StatementsOnTwoBlocks) {
    EXPECT_TRUE(reproduce("fig4.8").json["falls_with_slenderness"].get<bool>());
    // Rounding of a closed form, in degrees.
    EXPECT_LT(reproduce("fig4.3").json["spread_at_slenderness_angle_deg"].get<double>(), 1e-10);
    const Json tilts = reproduce("fig4.4").json["tilt_deg_by_height_in"];
    for (int height = 2; height <= 9; ++height) {
        const Json& tilt = tilts[std::to_string(height)];
        EXPECT_LT(tilt["phi_20"].get<double>(), tilt["phi_35"].get<double>());
    }
}

}  // namespace
}  // namespace delabole
