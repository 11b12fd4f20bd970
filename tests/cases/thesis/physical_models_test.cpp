// The tables of the thesis, typed in, agree with each other and with what the text says of them.
#include "cases/program/thesis/physical_models.hpp"

#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/data_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace delabole {
namespace {

// Tables that only say what the others are checked against.
// A row of Table 3.1: a base friction model from its start to its failure.
struct BaseFrictionTest {
    std::string test;
    double slope_angle;
    double slope_height;
    double joint_dip;
    double joint_spacing;
    std::optional<double> cross_joint_spacing;
    std::optional<double> crack_time_from;
    std::optional<double> crack_time_to;
    std::optional<double> crack_angle_from;
    std::optional<double> crack_angle_to;
    std::string remark;
    std::string doubt;
    static constexpr auto fields() {
        using T = BaseFrictionTest;
        using D = Dimension;
        return joined(
            table_columns<&T::test, &T::remark, &T::doubt>(),
            table_columns<&T::slope_angle, &T::joint_dip, &T::crack_angle_from, &T::crack_angle_to>(
                D::angle, detail::slope_angles),
            table_columns<&T::slope_height, &T::joint_spacing, &T::cross_joint_spacing>(D::length, more_than(0)),
            table_columns<&T::crack_time_from, &T::crack_time_to>(D::time, at_least(0)));
    }
};

// A dip or a spacing of the models of the Delabole face (2.3.3).
struct ModelFeature {
    std::string feature;
    std::string dips_into;
    std::optional<double> dip;
    std::optional<double> spacing;
    std::string doubt;
    static constexpr auto fields() {
        using F = ModelFeature;
        return joined(table_columns<&F::feature, &F::dips_into, &F::doubt>(),
                      table_columns<&F::dip>(Dimension::angle, within(0, degrees(90))),
                      table_columns<&F::spacing>(Dimension::length, more_than(0)));
    }
};

template <class Row>
std::vector<Row> table_of(const std::string& file) {
    std::ifstream stream(std::string(DELABOLE_CASES) + "/thesis/" + file);
    std::ostringstream text;
    text << stream.rdbuf();
    return parse_table<Row>(text.str(), file);
}

std::vector<BaseFrictionTest> base_friction_tests() {
    return table_of<BaseFrictionTest>("chapter_3/table_3_1.csv");
}

std::vector<ModelFeature> model_features() {
    return table_of<ModelFeature>("chapter_2/features.csv");
}

constexpr double inch = 0.0254;
// Numbers are printed to half a degree, a quarter of an inch and a quarter of a minute.
constexpr double rounding = 1e-9;

std::map<std::string, BaseFrictionTest> tests_by_name() {
    std::map<std::string, BaseFrictionTest> tests;
    for (const BaseFrictionTest& test : base_friction_tests()) {
        EXPECT_TRUE(tests.emplace(test.test, test).second) << test.test << " stands there twice";
    }
    return tests;
}

TEST(PhysicalModels, EveryTableIsRead) {
    EXPECT_EQ(base_friction_tests().size(), 45U);
    EXPECT_GT(rows_of<BaseFrictionState>().size(), 50U);  // "over 50 base friction tests were run" (3.1)
    EXPECT_EQ(rows_of<SlopeHeightVariation>().size(), 5U);
    EXPECT_FALSE(rows_of<TiltingFrameAngle>().empty());
    EXPECT_FALSE(model_features().empty());
    EXPECT_EQ(rows_of<PrintedTrend>().size(), 8U);
    EXPECT_EQ(rows_of<GroundwaterTest>().size(), 10U);
    EXPECT_EQ(rows_of<MechanismVerdict>().size(), 10U);
}

// Section 3.2.1 lists the values that were varied.
TEST(PhysicalModels, OnlyTheParametersOfTheText) {
    const auto is_one_of = [](double value, double unit, std::initializer_list<double> values) {
        return std::ranges::any_of(values, [&](double one) { return std::abs(value / unit - one) < rounding; });
    };
    for (const BaseFrictionState& state : rows_of<BaseFrictionState>()) {
        EXPECT_TRUE(is_one_of(state.slope_angle, degrees(1), {60, 65, 70, 80})) << state.test;
        EXPECT_TRUE(is_one_of(state.joint_dip, degrees(1), {70, 80})) << state.test;
        EXPECT_TRUE(is_one_of(state.height_over_spacing, 1, {12, 15, 18, 21, 24})) << state.test;
        EXPECT_TRUE(is_one_of(state.joint_spacing, inch, {1, 0.75, 0.5})) << state.test;
    }
}

// Table 3.2 gives height over spacing, Table 3.1 both; a cut of 3 inches in front of the toe adds to the height.
TEST(PhysicalModels, BothTablesHaveTheSameSlopes) {
    const std::map<std::string, BaseFrictionTest> tests = tests_by_name();
    std::set<std::string> seen;
    for (const BaseFrictionState& state : rows_of<BaseFrictionState>()) {
        SCOPED_TRACE(state.test);
        seen.insert(state.test);
        ASSERT_TRUE(tests.contains(state.test));
        const BaseFrictionTest& test = tests.at(state.test);
        EXPECT_EQ(state.slope_angle, test.slope_angle);
        EXPECT_EQ(state.joint_dip, test.joint_dip);
        EXPECT_EQ(state.joint_spacing, test.joint_spacing);
        EXPECT_EQ(state.cross_joint_spacing, test.cross_joint_spacing);
        // Table 3.1 prints 2(R), which began with its toe cut, with the height that this gives.
        const double cut = state.toe == ToeChange::vertical_cut && state.test != "2(R)" ? 3 * inch : 0;
        EXPECT_NEAR(state.slope_height(), test.slope_height + cut, rounding);
        EXPECT_EQ(state.cross_joint_spacing.has_value(), state.columns == ColumnKind::cross_jointed);
        // The first path of the failed state is the one that Table 3.1 gives.
        if (state.crack_angle_from) {
            EXPECT_EQ(state.crack_angle_from, test.crack_angle_from);
            EXPECT_EQ(state.crack_angle_to, test.crack_angle_to);
        }
    }
    EXPECT_EQ(seen.size(), tests.size());
}

// Where no toe was changed the times of both tables are those of one clock; every difference is marked as doubtful.
TEST(PhysicalModels, TimesThatDifferAreMarked) {
    const std::map<std::string, BaseFrictionTest> tests = tests_by_name();
    for (const BaseFrictionState& state : rows_of<BaseFrictionState>()) {
        const BaseFrictionTest& test = tests.at(state.test);
        if (!state.crack_time_from) {
            continue;
        }
        if (state.toe == ToeChange::as_built && test.crack_time_from != state.crack_time_from) {
            EXPECT_FALSE(state.doubt.empty() && test.doubt.empty()) << state.test;
        }
        // The change is made during the test, so that what follows it is shorter than the whole.
        EXPECT_TRUE(!test.crack_time_to || *state.crack_time_from <= *test.crack_time_to || !state.doubt.empty())
            << state.test;
    }
    for (const SlopeHeightVariation& row : rows_of<SlopeHeightVariation>()) {
        const std::string model = std::to_string(static_cast<int>(row.model));
        const BaseFrictionTest& right = tests.at(model + "(R)");
        EXPECT_EQ(right.slope_height, row.slope_height);
        const bool same =
            right.crack_time_from == row.right_crack_time && right.crack_angle_from == row.right_crack_angle;
        const auto left = tests.find(model + "(L)");
        const bool left_same = left == tests.end() || (left->second.crack_time_from == row.left_crack_time &&
                                                       left->second.crack_angle_from == row.left_crack_angle);
        EXPECT_EQ(row.doubt.empty(), same && left_same) << model;
    }
}

TEST(PhysicalModels, StableStatesHaveNoCrackPath) {
    for (const BaseFrictionState& state : rows_of<BaseFrictionState>()) {
        if (state.behaviour == SlopeBehaviour::stable) {
            EXPECT_FALSE(state.crack_time_from || state.crack_angle_from) << state.test;
        }
        if (state.behaviour == SlopeBehaviour::unstable) {
            EXPECT_TRUE(state.crack_time_from) << state.test;
        }
        EXPECT_EQ(state.crack_time_from.has_value(), state.crack_time_to.has_value()) << state.test;
        EXPECT_TRUE(!state.crack_time_from || *state.crack_time_from <= *state.crack_time_to) << state.test;
        EXPECT_EQ(state.crack_angle_from.has_value(), state.crack_angle_to.has_value()) << state.test;
        EXPECT_TRUE(!state.crack_angle_from || *state.crack_angle_from <= *state.crack_angle_to) << state.test;
    }
}

// "The slopes of 70 deg or more all failed"; "the stability of the slopes was very sensitive to slope angle".
TEST(PhysicalModels, SteeperSlopesAreNeverMoreStable) {
    struct Sequence {
        std::set<std::string> tests;
        std::vector<SlopeBehaviour> behaviour;
    };
    const std::vector<Sequence> sequences = {
        {{"4''(L)", "4''_1(L)", "4''_2(L)"}, {}},
        {{"10'(L)", "10'_1(L)", "11'(L)"}, {}},
        {{"11''_1(L)", "11''(L)"}, {}},
        {{"4'(L)", "2'(L)"}, {}},
    };
    for (Sequence sequence : sequences) {
        std::vector<BaseFrictionState> states;
        for (const BaseFrictionState& state : rows_of<BaseFrictionState>()) {
            if (sequence.tests.contains(state.test)) {
                states.push_back(state);
            }
        }
        ASSERT_EQ(states.size(), sequence.tests.size());
        std::ranges::sort(states, {}, &BaseFrictionState::slope_angle);
        for (const BaseFrictionState& state : states) {
            EXPECT_EQ(state.height_over_spacing, states.front().height_over_spacing);
            EXPECT_EQ(state.joint_dip, states.front().joint_dip);
        }
        EXPECT_TRUE(std::ranges::is_sorted(states, {}, &BaseFrictionState::behaviour)) << states.front().test;
        EXPECT_LT(states.front().behaviour, states.back().behaviour) << states.front().test;
    }
    for (const BaseFrictionState& state : rows_of<BaseFrictionState>()) {
        if (state.slope_angle > degrees(69.5)) {
            EXPECT_EQ(state.behaviour, SlopeBehaviour::unstable) << state.test;
        }
    }
}

// "hardly exceeded 41", "never less than 20" (3.4.1).
TEST(PhysicalModels, CrackPathsLieInThePrintedRange) {
    for (const BaseFrictionState& state : rows_of<BaseFrictionState>()) {
        if (state.crack_angle_from) {
            EXPECT_GE(*state.crack_angle_from, degrees(20)) << state.test;
            EXPECT_LE(*state.crack_angle_to, degrees(41) + rounding) << state.test;
        }
    }
}

// A model free of boundary effects has a prime in its name, a cross-jointed one two.
TEST(PhysicalModels, NamesSayWhatTheModelsAre) {
    for (const BaseFrictionState& state : rows_of<BaseFrictionState>()) {
        const bool cross_jointed = state.test.find("''") != std::string::npos;
        EXPECT_EQ(state.columns == ColumnKind::cross_jointed, cross_jointed) << state.test;
        if (!cross_jointed) {
            EXPECT_EQ(state.surroundings == ModelSurroundings::boundary_free,
                      state.test.find('\'') != std::string::npos)
                << state.test;
        }
    }
}

TEST(PhysicalModels, DelaboleModelsUseTheListedFeatures) {
    const std::vector<ModelFeature> features = model_features();
    const auto lists = [&](const std::string& name, std::optional<double> dip, std::optional<double> spacing) {
        return std::ranges::any_of(features, [&](const ModelFeature& feature) {
            return feature.feature == name && ((dip && feature.dip == dip) || (spacing && feature.spacing == spacing));
        });
    };
    for (const MechanismVerdict& verdict : rows_of<MechanismVerdict>()) {
        SCOPED_TRACE(verdict.plate);
        EXPECT_TRUE(lists("joint_a", verdict.joint_a_dip, {}));
        EXPECT_TRUE(!verdict.joint_a_spacing || lists("joint_a", {}, verdict.joint_a_spacing));
        EXPECT_TRUE(!verdict.joint_b_dip || lists("joint_b", verdict.joint_b_dip, {}));
        EXPECT_TRUE(!verdict.joint_c_dip || lists("joint_c", verdict.joint_c_dip, {}));
        EXPECT_TRUE(!verdict.cleavage_dip || lists("cleavage", verdict.cleavage_dip, {}));
        EXPECT_TRUE(!verdict.cleavage_spacing || lists("cleavage", {}, verdict.cleavage_spacing));
        EXPECT_TRUE(!verdict.fault_dip || lists("fault", verdict.fault_dip, {}));
        EXPECT_TRUE(!verdict.fault_thickness || lists("fault", {}, verdict.fault_thickness));
        EXPECT_TRUE(!verdict.slope_angle || lists("slope", verdict.slope_angle, {}));
        // The thesis's conclusion: only models with joint B, which topple, reproduce the crest.
        if (verdict.cracks == FieldVerdict::yes || verdict.movements == FieldVerdict::yes) {
            EXPECT_TRUE(verdict.joint_b_dip);
        }
    }
}

// "less than the quarter of that of the deformable mixture"; half and fully saturated are 12 and 47.5 deg.
TEST(PhysicalModels, GroundwaterTests) {
    double mixture = 0;
    double cork = 0;
    for (const GroundwaterTest& test : rows_of<GroundwaterTest>()) {
        (test.material == "cork" ? cork : mixture) = test.density;
        EXPECT_LT(test.friction_least, test.friction_most);
        const double expected = test.filled_ratio == 0 ? 0 : test.filled_ratio == 0.5 ? 12 : 47.5;
        EXPECT_EQ(test.rotation, degrees(expected));
    }
    EXPECT_EQ(mixture, 1330);
    EXPECT_LT(cork, mixture / 4);
}

}  // namespace
}  // namespace delabole
