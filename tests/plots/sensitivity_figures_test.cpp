#include "plots/figures/sensitivity_figures.hpp"

#include "series_of.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

const StudiedQuantity tilt{"critical_tilt", Dimension::angle};
const FailureCriterion below_sixteen{degrees(16), FailureSide::below, {}, {}};

Evaluation answer(double value_deg) {
    return {degrees(value_deg), {}};
}

TEST(SensitivityFigures, TornadoHasItsWidestBarOnTopInDisplayUnits) {
    const std::vector<UncertainParameter> parameters{{"height", {Normal{3, 0.2}}, ""},
                                                     {"friction_angle", {Normal{0.4, 0.05}}, ""},
                                                     {"cohesion", {Normal{1, 1}}, ""}};
    TornadoResult result;
    result.at_medians = answer(18);
    result.bars = {{{2.7, answer(19)}, {3.3, answer(17)}},
                   {{0.3, answer(14)}, {0.5, answer(18)}},
                   {{0, answer(18)}, {2, Evaluation{0, "impossible"}}}};
    const Figure figure = tornado_range_figure(tilt, result, {}, parameters,
                                               {Dimension::length, Dimension::angle, Dimension::stress}, degrees(16));
    ASSERT_EQ(figure.y.ticks.size(), 2U);  // the third has no answer at one end
    EXPECT_EQ(figure.y.ticks[0].second.substr(0, 8), "friction");
    const Boxes low = with_legend<Boxes>(figure, "parameter at its 5 % quantile");
    EXPECT_NEAR(low.boxes[0].lower_left.x(), 14, 1e-12);
    EXPECT_NEAR(low.boxes[0].upper_right.x(), 18, 1e-12);
    EXPECT_NEAR(with_legend<Line>(figure, "limit of failure").points[0].x(), 16, 1e-12);
    EXPECT_LT(figure.x.range->first, 14);
}

TEST(SensitivityFigures, HistogramColoursWhatFailed) {
    PropagationResult result;
    result.with_value = 100;
    result.histogram = {{degrees(14), degrees(16), 10}, {degrees(16), degrees(18), 60}, {degrees(18), degrees(20), 30}};
    const Figure figure = histogram_figure(tilt, result, below_sixteen);
    const Boxes failed = with_legend<Boxes>(figure, "fails below 16\u00a0deg");
    ASSERT_EQ(failed.boxes.size(), 1U);
    EXPECT_NEAR(failed.boxes[0].upper_right.x(), 16, 1e-12);
    EXPECT_NEAR(failed.boxes[0].upper_right.y(), 10, 1e-12);
    EXPECT_EQ(with_legend<Boxes>(figure, "stands").boxes.size(), 2U);
    EXPECT_EQ(all<Boxes>(histogram_figure(tilt, result, std::nullopt)).size(), 1U);
}

TEST(SensitivityFigures, IndicesShowTheirIntervals) {
    SobolIndicesResult result;
    result.status = SobolIndicesStatus::found;
    result.parameters = {{{0.2, {0.15, 0.25}}, {0.3, {0.25, 0.35}}}, {{0.6, {0.5, 0.7}}, {0.8, {0.7, 0.9}}}};
    const Figure figure = sobol_indices_figure(tilt, result, {"height", "friction_angle"});
    EXPECT_EQ(figure.y.ticks[0].second, "friction angle");
    EXPECT_EQ(all<Line>(figure).size(), 4U);
    EXPECT_EQ(with_legend<Boxes>(figure, "alone (first order)").boxes[0].upper_right.x(), 0.6);
}

TEST(SensitivityFigures, ConvergenceStandsOnALogarithmicAxis) {
    PropagationResult result;
    result.failure = FailureProbability{.probability = Estimate{0.05, {0.04, 0.06}}};
    for (const long samples : {100L, 1000L, 10'000L}) {
        result.convergence.push_back({samples, {1, {0.9, 1.1}}, Estimate{0.05, {0.04, 0.06}}});
    }
    const Figure figure = sampling_convergence_figure(tilt, result, 0.03);
    EXPECT_EQ(with_legend<Line>(figure, "estimate").points[1], Point(3, 5));
    EXPECT_EQ(with_legend<Line>(figure, "first-order reliability").points[0].y(), 3);
    ASSERT_EQ(figure.x.ticks.back().second, "10000");
}

TEST(SensitivityFigures, WithoutAProbabilityTheMeanConverges) {
    PropagationResult result;
    result.failure = FailureProbability{};
    result.cumulative = {{degrees(15), 0.5}, {degrees(17), 1}};
    result.convergence = {{100, {1, {0.9, 1.1}}, std::nullopt}, {1000, {1, {0.9, 1.1}}, std::nullopt}};
    EXPECT_EQ(sampling_convergence_figure(tilt, result, 0.03).y.title, "mean of critical tilt");
    EXPECT_EQ(all<Region>(cumulative_figure(tilt, result, below_sixteen))[0].legend, "fails below 16\u00a0deg");
    result.failure->probability = Estimate{0.05, {0.04, 0.06}};
    result.failure->decided = 60;
    result.samples = 64;
    EXPECT_EQ(all<Region>(cumulative_figure(tilt, result, below_sixteen))[0].legend,
              "fails below 16\u00a0deg: 5 % of the samples that are decided");
}

TEST(SensitivityFigures, NothingToDrawIsNoFault) {
    for (const Figure& figure :
         {tornado_range_figure(tilt, {}, {}, {}, {}, std::nullopt), morris_figure(tilt, {}, {}),
          sobol_indices_figure(tilt, {}, {}), histogram_figure(tilt, {}, below_sixteen),
          cumulative_figure(tilt, {}, below_sixteen), sampling_convergence_figure(tilt, {}, std::nullopt)}) {
        EXPECT_FALSE(gnuplot_script(figure, "empty").empty());
    }
}

}  // namespace
}  // namespace delabole
