#include "plots/figures/study_figures.hpp"

#include "series_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace delabole {
namespace {

// Draws on a square lattice, so that every share is known: x from 0.2 to 0.4 rad, y twice as far.
MechanismFit sampled_fit(const std::string& name, double log_evidence) {
    MechanismFit fit;
    fit.name = name;
    fit.title = name;
    fit.parameters = {{"strength.friction_angle", 0, 1, Prior{0.3, 0.2, ""}}, {"water.filled_ratio", 0, 1, {}}};
    fit.dimensions = {Dimension::angle, Dimension::ratio};
    fit.best = {0.3, 0.6};
    MechanismPosterior posterior;
    constexpr int side = 20;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            posterior.posterior.draws.push_back({0, {0.2 + 0.2 * i / (side - 1), 0.4 + 0.4 * j / (side - 1)}, 0});
        }
    }
    for (const FreeParameter& parameter : fit.parameters) {
        ParameterPosterior described;
        described.name = parameter.name;
        described.median = 0.3;
        described.standard_deviation = 0.1;
        posterior.posterior.parameters.push_back(described);
        posterior.posterior.running.push_back({{50, 0.1, 0.4, 0.5, 1.2}, {100, 0.1, 0.3, 0.5, 1.005}});
    }
    posterior.posterior.status = PosteriorStatus::converged;
    posterior.posterior.steps = 100;
    Evidence evidence;
    evidence.status = EvidenceStatus::estimated;
    evidence.log_evidence = log_evidence;
    evidence.standard_error = 0.1;
    posterior.evidences = {{EvidenceVariant::as_given, evidence}, {EvidenceVariant::priors_flat, evidence}};
    posterior.evidences[1].evidence.log_evidence -= 1;
    posterior.least_misfit = 2;
    posterior.missing_data = 1;
    posterior.missing_field_evidence = 2;
    fit.posterior = posterior;
    return fit;
}

FitResult two_mechanisms() {
    FitResult result;
    result.mechanisms = {sampled_fit("toppling", -5), sampled_fit("sliding", -7), MechanismFit{}};
    return result;
}

TEST(PosteriorFigures, EvidenceIsTheSumOfItsParts) {
    const Figure figure = *evidence_figure(two_mechanisms());
    ASSERT_EQ(figure.y.ticks.size(), 2U);  // the third was not sampled
    EXPECT_EQ(figure.y.ticks[0].second, "toppling");
    EXPECT_GT(figure.y.ticks[0].first, figure.y.ticks[1].first);
    const auto length = [&](const std::string& legend) {
        const Boxes::Box box = with_legend<Boxes>(figure, legend).boxes[0];
        return box.upper_right.x() - box.lower_left.x();
    };
    EXPECT_NEAR(length("misfit of the best point"), 1, 1e-12);
    EXPECT_NEAR(length("share of the priors that the data leave"), 4, 1e-12);
    EXPECT_NEAR(length("data about which it says nothing"), 2, 1e-12);
    EXPECT_NEAR(length("field evidence about which it says nothing"), 4, 1e-12);
    const Line error = with_legend<Line>(figure, "95 % interval of the sum");
    EXPECT_NEAR(error.points[0].x(), -11 - 0.196, 1e-12);
    EXPECT_NEAR(error.points[1].x(), -11 + 0.196, 1e-12);
    EXPECT_FALSE(evidence_figure(FitResult{}));
}

TEST(PosteriorFigures, DependenceShowsEachVariant) {
    const Figure figure = *evidence_dependence_figure(two_mechanisms());
    ASSERT_EQ(figure.x.ticks.size(), 2U);
    const Points toppling = with_legend<Points>(figure, "toppling");
    EXPECT_NEAR(toppling.points[0].y(), -11, 1e-12);
    EXPECT_NEAR(toppling.points[1].y(), -12, 1e-12);
}

TEST(PosteriorFigures, AgreementShowsTheWorstParameterAndTheLimit) {
    const Figure figure = *chain_agreement_figure(two_mechanisms());
    const Line line = with_legend<Line>(figure, "sliding");
    EXPECT_NEAR(line.points[0].y(), std::log10(0.2), 1e-12);
    EXPECT_NEAR(line.points[1].y(), std::log10(0.005), 1e-9);
    EXPECT_NEAR(with_legend<Line>(figure, "limit, R-hat 1.01").points[0].y(), -2, 1e-9);
    EXPECT_FALSE(chain_agreement_figure(FitResult{}));
}

TEST(PosteriorFigures, RunningQuantilesAreScaledByTheFinalOnes) {
    const Figure figure = *running_quantiles_figure(sampled_fit("sliding", 0));
    const Line median = with_legend<Line>(figure, "strength: friction angle");
    EXPECT_NEAR(median.points[0].y(), 1, 1e-12);
    EXPECT_NEAR(median.points[1].y(), 0, 1e-12);
    EXPECT_FALSE(running_quantiles_figure(MechanismFit{}));
}

TEST(PosteriorFigures, CornerHasAPanelForEachPairAndRegionsOfTheRightSize) {
    MechanismFit fit = sampled_fit("sliding", 0);
    fit.loci = {{"strength.friction_angle", "water.filled_ratio", {{0.25, 0.5}, {0.35, 0.7}}, {0, 0}}};
    const Figure figure = *posterior_corner_figure(fit);
    EXPECT_EQ(all<Region>(figure).size(), 2U);  // two on the diagonal
    EXPECT_EQ(all<Points>(figure).size(), 2U);  // draws and best point of one pair
    // The locus runs through the middle of its panel as the lattice does.
    const Line locus = with_legend<Line>(figure, "factor of safety 1, the others at the best point");
    const Points best = with_legend<Points>(figure, "best point");
    ASSERT_GE(locus.points.size(), 3U);  // a gap first
    const Point middle = (locus.points[locus.points.size() - 2] + locus.points.back()) / 2;
    EXPECT_LT((middle - best.points[0]).norm(), 1e-9);
    // Draws of even density: the 68 % region is a square of 0.83 of the side, so well inside that of 95 %.
    const auto width = [](const Line& line) {
        double least = 1e9;
        double greatest = -1e9;
        for (const Point& point : line.points) {
            if (std::isfinite(point.x())) {
                least = std::min(least, point.x());
                greatest = std::max(greatest, point.x());
            }
        }
        return greatest - least;
    };
    const double share =
        width(with_legend<Line>(figure, "68 % region")) / width(with_legend<Line>(figure, "95 % region"));
    EXPECT_GT(share, 0.7);
    EXPECT_LT(share, 0.95);
    EXPECT_FALSE(posterior_corner_figure(MechanismFit{}));
}

TEST(PosteriorFigures, ProfilesShowTheBandOfPredictions) {
    FitProblem problem;
    problem.profile = ProfileObservation{{Point(0, 0), Point(10, 10)}, 1, ""};
    FitResult result;
    result.mechanisms = {sampled_fit("stepped_sliding", 0)};
    MechanismFit& fit = result.mechanisms[0];
    fit.prediction.profile = {Point(0, 0), Point(20, 20)};
    fit.posterior->profiles.clear();
    for (int index = 0; index <= 40; ++index) {
        fit.posterior->profiles.push_back({Point(0, 0), Point(20, 18 + 0.1 * index)});
    }
    const Region band =
        with_legend<Region>(*profiles_figure(problem, result, 0), "stepped sliding, 95 % of the posterior");
    double greatest = 0;
    for (const Point& point : band.outline) {
        greatest = std::max(greatest, point.y());
    }
    EXPECT_NEAR(greatest, 18 + 4 * 0.975, 1e-9);
}

}  // namespace
}  // namespace delabole
