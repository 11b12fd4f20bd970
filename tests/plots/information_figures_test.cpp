#include "plots/figures/study_figures.hpp"

#include "series_of.hpp"

#include <gtest/gtest.h>

#include <set>

namespace delabole {
namespace {

ParameterInformation reduces(const std::string& parameter, double share) {
    return {parameter, {share, 0.01}, {share, 0.01}};
}

TEST(InformationFigures, TheMeasurementThatTellsMostStandsOnTop) {
    CandidateInformation little{"survey", {}, {reduces("friction", 0.02), reduces("water", 0.01)}, std::nullopt};
    CandidateInformation much{"piezometer", {}, {reduces("friction", 0.1), reduces("water", 0.6)}, std::nullopt};
    const Figure figure = information_figure({little, much});
    ASSERT_EQ(figure.y.ticks.size(), 2U);
    EXPECT_EQ(figure.y.ticks[0].second, "piezometer");
    EXPECT_GT(figure.y.ticks[0].first, figure.y.ticks[1].first);
    const Boxes water = with_legend<Boxes>(figure, "water");
    ASSERT_EQ(water.boxes.size(), 2U);
    EXPECT_NEAR(water.boxes[0].upper_right.x(), 60, 1e-12);
    EXPECT_GT(water.boxes[0].upper_right.y(), water.boxes[1].upper_right.y());
    const Line error = with_legend<Line>(figure, "two standard errors");
    EXPECT_NEAR(error.points[1].x() - error.points[0].x(), 4, 1e-12);
    EXPECT_GE(figure.x.range->second, 62);
}

TEST(InformationFigures, EightInputsHaveColoursOfTheirOwn) {
    CandidateInformation survey{"survey", {}, {}, std::nullopt};
    for (const char* input : {"a", "b", "c", "d", "e", "f", "g", "h"}) {
        survey.over_mechanisms.push_back(reduces(input, 0.1));
    }
    std::set<Colour> colours;
    for (const Boxes& boxes : all<Boxes>(information_figure({survey}))) {
        colours.insert(boxes.colour);
    }
    EXPECT_EQ(colours.size(), 8U);
}

TEST(InformationFigures, RanksStandBesideWhatIsUsual) {
    MechanismRecovery recovery;
    recovery.name = "sliding";
    recovery.counted = 100;
    ParameterRecovery parameter{};
    parameter.name = "strength.friction_angle";
    parameter.histogram = {10, 12, 8, 10, 9, 11, 10, 10, 10, 10};
    const Figure figure = rank_figure(recovery, parameter);
    const Boxes bars = with_legend<Boxes>(figure, "sliding");
    ASSERT_EQ(bars.boxes.size(), 10U);
    EXPECT_EQ(bars.boxes[1].upper_right, Point(19.5, 12));
    // Of 100 trials with a chance of 0.1, from 5 to 16 succeed with 95 % (binomial quantiles).
    std::vector<double> levels;
    for (const Line& line : all<Line>(figure)) {
        levels.push_back(line.points[0].y());
    }
    EXPECT_EQ(levels, (std::vector<double>{5, 16}));
}

TEST(InformationFigures, CoverageStandsBesideItsNominalShare) {
    MechanismRecovery recovery;
    ParameterRecovery parameter{};
    parameter.name = "water_depth";
    parameter.coverage_68 = {0.7, {0.6, 0.8}};
    parameter.coverage_95 = {0.9, {0.85, 0.97}};
    recovery.parameters = {parameter, parameter};
    const Figure figure = coverage_figure(recovery);
    EXPECT_EQ(figure.y.ticks.size(), 2U);
    EXPECT_NEAR(with_legend<Points>(figure, "95 % intervals").points[0].x(), 90, 1e-12);
    EXPECT_NEAR(with_legend<Line>(figure, "68 % intervals as they should be").points[0].x(), 68.3, 1e-12);
}

}  // namespace
}  // namespace delabole
