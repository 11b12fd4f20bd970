// Tests what `delabole reproduce chapter3` prints, and `chapter2` for its models.
#include "cases/program/commands/commands.hpp"
#include "cases/program/thesis/physical_models.hpp"
#include "tests/cases/thesis/reproduction_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

namespace delabole {
namespace {

class Chapter3 : public testing::ReproductionTest {
  protected:
    Chapter3() : ReproductionTest(chapter_3()) {}
};

class Models : public testing::ReproductionTest {
  protected:
    Models() : ReproductionTest(chapter_2()) {}
};

bool all_met(const Json& score) {
    return score["met"] == score["of"] && score["of"] > 0;
}

// Returns whether the gnuplot script of a figure contains the text.
bool holds(const std::filesystem::path& folder, const std::string& file, const std::string& text) {
    std::ifstream stream(folder / "figures" / (file + ".gp"));
    std::ostringstream script;
    script << stream.rdbuf();
    return script.str().find(text) != std::string::npos;
}

// Fig 3.4 is an item of two chapters.
TEST_F(Chapter3, EveryNameIsListedOnce) {
    std::set<std::string> names;
    for (const auto& [name, meaning] : reproducible()) {
        EXPECT_TRUE(names.insert(name).second) << name;
    }
    EXPECT_TRUE(names.contains("fig3.4"));
}

// Sections 3.2 and 3.4.1.
TEST_F(Chapter3, TablesMeetTheText) {
    const Reproduction result = reproduce("table3.2");
    for (const PrintedRow& row : result.rows) {
        // Runs of the models do no better than a guess; and Table 3.2 has a slope of 70 deg that took 14 minutes, where
        // the text says that all failed very quickly.
        const bool missed = row.what.starts_with("base friction models in motion") ||
                            row.what == "those that failed within five minutes";
        EXPECT_EQ(row.remark.verdict == RowVerdict::not_met, missed) << row.what;
    }
    const Json& behaviour = result.json["behaviour"];
    EXPECT_EQ(behaviour["S"].get<int>() + behaviour["L.E."].get<int>() + behaviour["U"].get<int>(), 52);
    EXPECT_EQ(result.json["steep"]["failed"], result.json["steep"]["of"]);
    const std::vector<BaseFrictionState> states = rows_of<BaseFrictionState>();
    EXPECT_EQ(states.size(), 52U);
    const auto at_80 = [](const BaseFrictionState& state) { return std::abs(state.slope_angle - degrees(80)) < 1e-9; };
    EXPECT_EQ(std::ranges::count_if(states, at_80), 6);
    EXPECT_TRUE(std::ranges::all_of(states, [&](const BaseFrictionState& state) {
        return !at_80(state) || state.behaviour == SlopeBehaviour::unstable;
    }));
}

TEST_F(Chapter3, CrackPathOfARunBesideThePrintedOne) {
    const Reproduction result = reproduce("base_friction");
    // The run is chaotic: half an inch more or less in one column turns the path by 4 deg.
    EXPECT_NEAR(result.json["crack_path_deg"]["15(L)"].get<double>(), 24, 5);
    EXPECT_EQ((result.rows.end() - 5)->remark.verdict, RowVerdict::not_met);
    EXPECT_TRUE(holds(path(), "end", "Table 3.2, 15(L): After"));
    EXPECT_TRUE(holds(path(), "left_standing", "its foot and top"));
}

TEST_F(Chapter3, OneModelHasASawToothJoint) {
    reproduce("plates3");
    EXPECT_TRUE(holds(path(), "plate_3_XIII", "saw-tooth joint"));
    EXPECT_FALSE(holds(path(), "plate_3_X", "saw-tooth joint"));
}

TEST_F(Chapter3, SlopeHeight) {
    const Json json = reproduce("fig3.2").json;
    EXPECT_TRUE(json["higher_fails_later"].get<bool>());
    EXPECT_EQ(json["right_earlier"]["pairs"], 4);
    EXPECT_EQ(json["left_steeper"]["pairs"], 4);
}

TEST_F(Chapter3, EqualColumns) {
    const Json json = reproduce("fig3.6").json;
    // A column is added three times at each of eight heights; none of these steps loses stability.
    EXPECT_EQ(json["one_column_more"]["steps"], 24);
    EXPECT_EQ(json["one_column_more"]["less_stable"], 0);
    EXPECT_GE(json["one_column_more"]["stabler"].get<int>(), 22);
    // The closed forms are rounded, in degrees.
    EXPECT_LT(json["parted_spread_deg"].get<double>(), 1e-10);
    // Columns of 2 and 3 inches topple at 26.6 and 18.4 deg, both beyond the friction of tin.
    EXPECT_EQ(json["heights_that_slide_on_tin"], 2);
}

TEST_F(Chapter3, NineColumnsCrackWhereTheyDid) {
    const Json json = reproduce("fig3.7").json;
    EXPECT_TRUE(json["friction_found"].get<bool>());
    EXPECT_EQ(json["crack"], "6 and 7");
    // The friction is a root to full precision, the tilt a closed form of it.
    EXPECT_NEAR(json["tilt_deg"]["9"].get<double>(), 16, 1e-9);
    // The friction is among those that the thesis measured as short slips (8 to 22 deg).
    EXPECT_GT(json["friction_deg"].get<double>(), 16);
    EXPECT_LT(json["friction_deg"].get<double>(), 22);
    EXPECT_TRUE(all_met(json["one column more"]));
    // The crack lies in front of the highest column that stands by itself: as printed up to 12 columns.
    for (const auto& [columns, mode] : json["mode"].items()) {
        const auto standing = mode.get<std::string>().find('0');
        const double tilt = degrees(json["tilt_deg"][columns].get<double>());
        if (standing != std::string::npos) {
            const auto height = static_cast<double>(std::stoi(columns)) - static_cast<double>(standing);
            EXPECT_LT(std::tan(tilt), 1 / height) << columns;
        }
    }
}

TEST_F(Models, ModesThatHappenedCanHappen) {
    const Reproduction result = reproduce("mechanisms");
    EXPECT_EQ(result.rows.size(), 8U);  // the face of Plate 2.VI is not printed
    for (const PrintedRow& row : result.rows) {
        EXPECT_NE(row.remark.verdict, RowVerdict::not_met) << row.what;
    }
    // tan 40.5 / tan 50, by hand.
    EXPECT_NEAR(result.json["sliding"]["2.I"].get<double>(), 0.7167, 5e-5);
    EXPECT_NEAR(result.json["toppling_least_face_deg"]["2.III"].get<double>(), 45.5, 1e-12);
}

TEST_F(Models, DrawingsNameFaultsAndForces) {
    reproduce("drawings");
    EXPECT_TRUE(holds(path(), "fig_2_6", "large tension crack"));
    EXPECT_TRUE(holds(path(), "fig_2_7", "fault, 45°, gouge 10 mm"));
    EXPECT_TRUE(holds(path(), "fig_2_10_b", "discontinuity, 0°"));
    EXPECT_TRUE(holds(path(), "fig_2_15", "half saturated: 11.9°"));
    EXPECT_TRUE(holds(path(), "fig_2_4", "617.3 ft"));
}

TEST_F(Models, Groundwater) {
    const Json json = reproduce("groundwater").json;
    EXPECT_GT(json["mixture_over_cork"].get<double>(), 0);
    for (const std::string material : {"mixture", "cork"}) {
        const Json& force = json["driving_force"][material];
        EXPECT_GT(force["half_saturated"].get<double>(), force["dry"].get<double>());
    }
    // By hand: tan 47.5 / (sin 70 + tan 47.5 cos 70) and the root of cos 70 over it, to four digits.
    EXPECT_NEAR(json["water_force_over_weight"].get<double>(), 0.8312, 5e-5);
    EXPECT_NEAR(json["leaves_joint_at_filled_ratio"].get<double>(), 0.6415, 5e-5);
    EXPECT_EQ(json["toppling_order"]["exceptions"], 0);
    EXPECT_GT(json["toppling_order"]["changes"].get<int>(), 0);
    // By hand: sin 70 - cos 70 tan 43.
    EXPECT_NEAR(json["driving_force"]["cork"]["dry"].get<double>(), 0.6208, 5e-5);
}

}  // namespace
}  // namespace delabole
