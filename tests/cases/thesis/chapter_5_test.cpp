// Tests what `delabole reproduce chapter5` prints about the thesis's dynamic relaxation.
#include "cases/program/thesis/chapter_5/sliding.hpp"
#include "tests/cases/thesis/reproduction_fixture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace delabole {
namespace {

class Chapter5 : public testing::ReproductionTest {
  protected:
    Chapter5() : ReproductionTest(chapter_5()) {}
};

bool all_agree(const Json& outcomes) {
    return std::ranges::all_of(outcomes, [](const Json& one) { return one["agrees"].get<bool>(); });
}

TEST_F(Chapter5, LawsOfContact) {
    const std::vector<PrintedRow> rows = reproduce("fig5.4").rows;
    EXPECT_EQ(rows.size(), 5U);
    for (const PrintedRow& row : rows) {
        EXPECT_EQ(row.remark.verdict, RowVerdict::met) << row.what;
    }
}

TEST_F(Chapter5, SingleBlocks) {
    const Json json = reproduce("single_blocks").json;
    EXPECT_TRUE(all_agree(json["outcomes"]["single block"]));
    EXPECT_TRUE(all_agree(json["outcomes"]["single block, base turned"]));
    // Counts of 800 to 5000 cycles, read off prints 100 cycles apart.
    EXPECT_LE(json["largest_difference_of_settled_cycles"]["single block"].get<int>(), 300);
    // "Almost twice" for the period; the amplitude grows less.
    EXPECT_NEAR(json["period_ratio_18.15_to_18.1"].get<double>(), 2, 0.25);
    EXPECT_GT(json["amplitude_ratio_18.15_to_18.1"].get<double>(), 1.3);
    EXPECT_LT(json["greatest_amplitude_ratio"].get<double>(), 1.75);
    // With the clean engine a dropped block rocks past its limit from 18.12 deg on, so that only the run at 18.15 deg
    // differs from the printed one; a consolidated block stands below 18.43 deg, whatever fails there in the thesis.
    const Json& dropped = json["outcomes_by_scheme"]["clean engine, dropped"]["single block"];
    for (const auto& [name, outcome] : dropped.items()) {
        EXPECT_EQ(outcome["agrees"].get<bool>(), name != "18.15 deg") << name;
    }
    for (const Json& outcome : json["outcomes_by_scheme"]["clean engine, preloaded"]["single block"]) {
        EXPECT_EQ(outcome["computed"].get<std::string>(), "stands");
    }
    // Turning the base, which lifts the block, gives every printed outcome.
    EXPECT_TRUE(all_agree(json["outcomes_by_scheme"]["clean engine, preloaded"]["single block, base turned"]));
}

TEST_F(Chapter5, CleanThresholds) {
    const Json json = reproduce("thresholds").json;
    // Bisected to 0.002 deg.
    EXPECT_LT(json["farthest_from_law_deg"].get<double>(), 0.002);
    // No integration setting changes where a consolidated block fails, nor does the step where a dropped one fails.
    EXPECT_LT(json["preloaded_spread_deg"].get<double>(), 0.002);
    EXPECT_LT(json["dropped_spread_by_step_deg"].get<double>(), 0.004);
    const Json& by_stiffness = json["threshold_deg"];
    // The loss by dropping decreases with the root of the stiffness: by a factor of 10 from 1e6 to 100e6 N/m; each is
    // bisected to 0.002 deg of 0.08 deg.
    const auto lost = [&](const std::string& stiffness) {
        return std::atan(1.0 / 3) * 180 / std::numbers::pi - by_stiffness[stiffness]["one_dropped"].get<double>();
    };
    EXPECT_NEAR(lost("1e6") / lost("100e6"), 10, 0.5);
    // Two blocks help each other only on stiff joints: 18.629 deg by equilibrium.
    EXPECT_NEAR(by_stiffness["6e6"]["two_preloaded"].get<double>(), by_stiffness["6e6"]["law"].get<double>(), 0.01);
    EXPECT_NEAR(by_stiffness["1000e6"]["two_preloaded"].get<double>(), 18.629, 0.03);
    double last = 0;
    for (const Json& one : by_stiffness) {
        EXPECT_GT(one["two_dropped"].get<double>(), last);  // stiffer blocks stand longer
        last = one["two_dropped"].get<double>();
    }
}

TEST_F(Chapter5, TwoBlocks) {
    const Json json = reproduce("double_blocks").json;
    EXPECT_TRUE(all_agree(json["outcomes"]["two blocks"]));
    const Json tilted = json["outcomes"]["two blocks, base turned"];
    EXPECT_EQ(tilted.size(), 6U);
    EXPECT_TRUE(all_agree(tilted));
    EXPECT_LT(json["gravity_turned"]["two blocks"]["agree"].get<int>(), 6);
    // "A micro crack was discovered": it closes almost completely, and the blocks part all the same.
    const Json gap = json["closed_gap"];
    EXPECT_LT(std::abs(gap["opening_after_in"].get<double>()), 0.01 * gap["opening_before_in"].get<double>());
    EXPECT_GT(gap["parted_in"].get<double>(), gap["opening_before_in"].get<double>());
}

// This is what the remarks to the tilted runs say.
TEST_F(Chapter5, TheThicknessOfTheBaseDecidesTiltedRuns) {
    const Json json = reproduce("tilted_blocks").json;
    EXPECT_EQ(json["complete"]["base turned"],
              (Json{"as chosen", "base 1.15 in thick", "damping 0.6", "consolidated for 5500 cycles"}));
    EXPECT_TRUE(json["complete"]["gravity turned"].empty());
    const Json& base = json["base turned"];
    EXPECT_EQ(base["as chosen"]["one"].get<int>(), 5);
    EXPECT_EQ(base["as chosen"]["two"].get<int>(), 6);
    EXPECT_EQ(base["base 1 in thick"]["two"].get<int>(), 5);
    for (const std::string thickness : {"1.15", "1.2", "2"}) {
        EXPECT_EQ(base["base " + thickness + " in thick"]["last_of_two"].get<std::string>(), "fails") << thickness;
    }
    EXPECT_LT(base["base 2 in thick"]["one"].get<int>(), 5) << "thicker: one block fails too early";
    for (const auto& [ingredient, counts] : json["gravity turned"].items()) {
        EXPECT_LT(counts["one"].get<int>(), 5) << ingredient;
        EXPECT_EQ(counts["last_of_two"].get<std::string>() == "fails", ingredient == "stiffness 2e6 N/m") << ingredient;
    }
    // Printed: 700, 1800 and 1500 cycles.
    for (const auto& [ingredient, counts] : base.items()) {
        EXPECT_LE(counts["x_behind_y"].get<int>(), 900) << ingredient;
    }
    const Json& exact = json["gravity turned"]["exact coordinates"];
    EXPECT_EQ(exact["every_10"].get<std::string>(), "fails");
    EXPECT_EQ(exact["every_20"].get<std::string>(), "stands");
    const Json& gap = json["gravity turned"]["gap 0.01 mm"];
    EXPECT_EQ(gap["every_10"].get<std::string>(), "fails");
    EXPECT_EQ(gap["every_20"].get<std::string>(), "fails");
}

TEST_F(Chapter5, ObservationsOnTwoBlocks) {
    const Json json = reproduce("observations").json;
    EXPECT_TRUE(all_agree(json["outcomes"]["stiffness at 18.3 deg"]));
    const Json shifted = json["shifted"];
    for (const Json& one : shifted) {
        EXPECT_GE(one["usable"].get<int>(), 10);
    }
    // Half the step takes more than twice the cycles from most starts; no start gives the order of the dampings.
    EXPECT_GT(2 * shifted["half_step"]["held"].get<int>(), shifted["half_step"]["usable"].get<int>());
    EXPECT_EQ(shifted["damping"]["held"].get<int>(), 0);
    // The printed 7000 cycles are far outside what starts give.
    EXPECT_LT(json["spread"]["6e6 N/m, step 1e-4 s"][1].get<int>(), 3500);
}

TEST_F(Chapter5, BlowOut) {
    const Json json = reproduce("fig5.13").json;
    // The blocks pass their critical inclination then; the start moves it by some cycles.
    EXPECT_NEAR(json["cycle"].get<double>(), 677, 10);
    // The jump is half of the difference between 7 in and 1 in, but for the rise of the foot, 0.002 in at 0.13 deg.
    EXPECT_NEAR(std::abs(json["jump_in"].get<double>()), 3, 0.005);
    EXPECT_TRUE(json["blows_out"]["as listed"].get<bool>());
    EXPECT_FALSE(json["blows_out"]["without the guard"].get<bool>());
    EXPECT_FALSE(json["blows_out"]["slots per face"].get<bool>());
    for (const Json& starts : json["shifted_starts"]) {
        EXPECT_GT(starts["as listed"].get<int>(), 0);
        EXPECT_EQ(starts["without the guard"].get<int>(), 0);
        EXPECT_EQ(starts["slots per face"].get<int>(), 0);
    }
    ASSERT_EQ(json["random_starts"].size(), 4U);
    for (const Json& starts : json["random_starts"]) {
        EXPECT_GT(starts["re-created"].get<int>(), 0);
        EXPECT_EQ(starts["clean"].get<int>(), 0);
        // The energy of a run that does not blow out balances to 2 %.
        EXPECT_LT(starts["energy_error"].get<double>(), 0.02);
        EXPECT_LT(starts["largest_speed_m_per_s"].get<double>(), starts["speed_of_fall_m_per_s"].get<double>());
    }
}

// From half a degree below atan(b/a) to half a degree above.
TEST(Chapter5BlowOut, NoneWithSlotsPerFaceAtAnyInclination) {
    const Chapter5Run printed = chapter_5_runs("blow_out").front();
    for (const double slenderness : {3.0, 5.0, 7.0, 10.0}) {
        Chapter5Run run = printed;
        run.settings.slot_memory = HockingSlotMemory::per_face;
        run.columns.heights.assign(2, slenderness * inch);
        run.columns.base_height = slenderness * inch;
        run.settings.stiffness *= slenderness * printed.columns.width / printed.columns.heights[0];
        for (const double unit : {typed_digit / 10, 0.0}) {
            run.columns.coordinate_unit = unit;
            for (int step = -25; step <= 25; ++step) {
                run.columns.dip = std::atan(1 / slenderness) + degrees(0.02) * step;
                EXPECT_FALSE(compute(run, Engine::recreated).blow_out_cycle)
                    << slenderness << ", " << unit << ", " << step;
            }
        }
    }
}

TEST(Chapter5Tables, PrintedRowsAddUpToPrintedTotals) {
    for (const Chapter5Run& run : chapter_5_runs("quadruple")) {
        std::vector<SlidingTotals> sums(4);
        for (const auto& [cycle, blocks] : printed_history(run)) {
            const bool any = std::ranges::any_of(blocks, [](BaseSliding one) { return one != BaseSliding::none; });
            for (std::size_t block = 0; any && block < blocks.size(); ++block) {
                sums[block].forward += blocks[block] == BaseSliding::forward ? 1 : 0;
                sums[block].backward += blocks[block] == BaseSliding::backward ? 1 : 0;
            }
        }
        for (std::size_t block = 0; block < sums.size(); ++block) {
            // The thesis's own total there is one less than the sum of its rows.
            const int misprint = run.name == "Table 5.3" && block == 2 ? 1 : 0;
            EXPECT_EQ(sums[block].forward, run.printed_totals[block].forward + misprint) << run.name << ' ' << block;
            EXPECT_EQ(sums[block].backward, run.printed_totals[block].backward) << run.name << ' ' << block;
        }
    }
}

TEST_F(Chapter5, FourBlocks) {
    const Json json = reproduce("quadruple_blocks").json;
    EXPECT_EQ(json["printed_totals"].get<int>(), 60);
    // Forty starts do not span all that a chaotic history can do.
    EXPECT_GE(json["printed_totals_within_range"].get<int>(), 55);
    EXPECT_GE(json["senses_as_printed"].get<int>(), 16);
    ASSERT_EQ(json["first_different_print"].size(), 5U);
    ASSERT_EQ(json["first_different_print_of_clean"].size(), 5U);
    for (const Json& cycle : json["first_different_print"]) {
        EXPECT_GT(cycle.get<int>(), 0);
    }
    // The clean engine's histories do not depend on the last bit, so its senses are its answer: nineteen of twenty.
    for (const Json& cycle : json["first_different_print_of_clean"]) {
        EXPECT_EQ(cycle.get<int>(), 0);
    }
    EXPECT_GE(json["clean_senses_as_printed"].get<int>(), 18);
    // Printed rows agree with those of many starts more than by chance and, except in Table 5.3, as well as these agree
    // with one another.
    ASSERT_EQ(json["histories"].size(), 5U);
    for (const auto& [table, history] : json["histories"].items()) {
        EXPECT_GT(history["mean"].get<double>(), history["by_chance"].get<double>() + 0.05) << table;
        EXPECT_EQ(history["mean"].get<double>() >= history["least_of_starts"].get<double>(), table != "Table 5.3");
        EXPECT_GT(history["nearest"].get<double>(), history["mean"].get<double>()) << table;
    }
}

TEST_F(Chapter5, ThreeBlocksByTheCleanEngine) {
    const Json json = reproduce("triple_blocks").json["clean"];
    ASSERT_EQ(json.size(), 4U);
    for (const Json& run : json) {
        // "Block (1) always slid forward. Block (3) preferred backward sliding."
        EXPECT_GT(run[0]["forward"].get<int>(), 0);
        EXPECT_EQ(run[0]["backward"].get<int>(), 0);
        EXPECT_GT(run[2]["backward"].get<int>(), run[2]["forward"].get<int>());
    }
}

TEST_F(Chapter5, Slopes) {
    const Json plane = reproduce("fig5.16").json;
    EXPECT_TRUE(plane["behaves_as_printed"]["nine columns"].get<bool>());
    EXPECT_TRUE(plane["crack_at_16_deg"].get<bool>());
    for (const std::string figure : {"fig_5_16_1000", "fig_5_16_2000", "fig_5_16_clean"}) {
        EXPECT_EQ(scale_of(figure), scale_of("fig_5_16_0")) << figure;
    }
    const Json stepped = reproduce("fig5.17").json;
    EXPECT_EQ(scale_of("fig_5_17_clean"), scale_of("fig_5_17_0"));
    EXPECT_TRUE(all_agree(stepped["outcomes"]["stepped base, friction"]));
    EXPECT_TRUE(std::ranges::all_of(stepped["behaves_as_printed"], [](const Json& one) { return one.get<bool>(); }));
    ASSERT_EQ(stepped["crack"].size(), 5U);
    for (const auto& [friction, crack] : stepped["crack"].items()) {
        EXPECT_TRUE(crack["as_printed"].get<bool>()) << friction;
        EXPECT_TRUE(crack["clean_as_printed"].get<bool>()) << friction;
        // "A slight opening" where the columns stand; there the joint is a tenth of that of those that fail.
        EXPECT_EQ(crack["width_in"].get<double>() < 0.05, friction == "44 deg" || friction == "46 deg") << friction;
    }
    EXPECT_TRUE(plane["clean_behaves_as_printed"]["nine columns"].get<bool>());
    EXPECT_TRUE(plane["clean_crack_at_16_deg"].get<bool>());
    // All five printed outcomes where columns are dropped; none thrown off the steps as they climb the risers.
    EXPECT_TRUE(all_agree(stepped["outcomes_by_scheme"]["clean engine, dropped"]["stepped base, friction"]));
    for (const Json& one : stepped["clean_behaves_as_printed"]) {
        EXPECT_TRUE(one.get<bool>());
    }
}

TEST_F(Chapter5, OnsetConvergesToEquilibrium) {
    const Json json = reproduce("onset").json;
    const Json& onset = json["onset_deg"];
    for (std::size_t index = 1; index < onset.size(); ++index) {
        EXPECT_LE(onset[index].get<double>(), onset[index - 1].get<double>() + 0.005);  // bisected to 0.005 deg
    }
    // Appendix A: 41.14 deg. At k b/W = 1e7 compliance is left with some hundredths of a degree.
    EXPECT_NEAR(onset.back().get<double>(), 41.14, 0.05);
    // The thesis's soft blocks have its bracket if they are dropped, and less if they are consolidated.
    EXPECT_GT(json["inches_dropped_deg"].get<double>(), 42);
    EXPECT_LT(json["inches_dropped_deg"].get<double>(), 44);
    EXPECT_LT(json["inches_preloaded_deg"].get<double>(), 42);
}

TEST_F(Chapter5, BackwardSlidingBeginsEarlierInTallColumns) {
    const Json shares = reproduce("fig5.12").json["rotation_over_slenderness_angle"];
    ASSERT_EQ(shares.size(), 3U);
    EXPECT_GT(shares[0].get<double>(), shares[1].get<double>());
    EXPECT_GT(shares[1].get<double>(), shares[2].get<double>());
}

}  // namespace
}  // namespace delabole
