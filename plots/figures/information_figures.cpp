#include "plots/figures/study_figures.hpp"

#include "plots/drawing/text.hpp"
#include "plots/figures/figures.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>

namespace delabole {

namespace {

constexpr std::size_t letters_of_candidate = 26;  // in one line beside a bar
constexpr std::array input_colours{Colour::blue, Colour::orange,    Colour::green, Colour::purple,
                                   Colour::sky,  Colour::vermilion, Colour::grey,  Colour::rock};

double greatest_reduction(const CandidateInformation& candidate) {
    double greatest = 0;
    for (const ParameterInformation& parameter : candidate.over_mechanisms) {
        greatest = std::max(greatest, parameter.standard_deviation.value);
    }
    return greatest;
}

// Bounds that hold, with 95 % probability, the number of `count` uniform ranks in one of ten bars.
std::pair<double, double> usual_bar(int count) {
    const auto quantile = [&](double probability) {
        unsigned hits = 0;
        while (gsl_cdf_binomial_P(hits, 0.1, static_cast<unsigned>(count)) < probability) {
            ++hits;
        }
        return static_cast<double>(hits);
    };
    return {quantile(0.025), quantile(0.975)};
}

}  // namespace

Figure information_figure(const std::vector<CandidateInformation>& candidates) {
    Figure figure{.title = "What a next measurement would tell",
                  .x = {.title = "standard deviation falls by", .unit = "%"}};
    std::vector<const CandidateInformation*> order;
    std::vector<std::string> parameters;
    for (const CandidateInformation& candidate : candidates) {
        order.push_back(&candidate);
        for (const ParameterInformation& parameter : candidate.over_mechanisms) {
            if (std::find(parameters.begin(), parameters.end(), parameter.parameter) == parameters.end()) {
                parameters.push_back(parameter.parameter);
            }
        }
    }
    std::stable_sort(order.begin(), order.end(), [](const auto* one, const auto* other) {
        return greatest_reduction(*one) > greatest_reduction(*other);
    });
    const double thickness = 0.8 / static_cast<double>(std::max<std::size_t>(parameters.size(), 1));
    std::vector<Line> errors;
    double highest = 10;
    for (std::size_t number = 0; number < parameters.size(); ++number) {
        Boxes boxes{.legend = human_name(parameters[number]), .colour = input_colours[number % input_colours.size()]};
        for (std::size_t row = 0; row < order.size(); ++row) {
            const double top = static_cast<double>(order.size() - row) + 0.4 - thickness * static_cast<double>(number);
            for (const ParameterInformation& parameter : order[row]->over_mechanisms) {
                if (parameter.parameter != parameters[number]) {
                    continue;
                }
                const ExpectedReduction& share = parameter.standard_deviation;
                const double value = 100 * std::max(share.value, 0.0);
                boxes.boxes.push_back({{0, top - 0.9 * thickness}, {value, top}});
                const double middle = top - 0.45 * thickness;
                const double end = std::min(value + 200 * share.error, 100.0);
                errors.push_back({.points = {{std::max(value - 200 * share.error, 0.0), middle}, {end, middle}},
                                  .legend = errors.empty() ? "two standard errors" : "",
                                  .width = 1.5});
                highest = std::max({highest, value, end});
            }
        }
        figure.series.emplace_back(std::move(boxes));
    }
    figure.series.insert(figure.series.end(), errors.begin(), errors.end());
    for (std::size_t row = 0; row < order.size(); ++row) {
        figure.y.ticks.emplace_back(static_cast<double>(order.size() - row),
                                    wrapped(order[row]->label, letters_of_candidate));
    }
    figure.x.range = std::pair{0.0, std::min(1.05 * highest, 100.0)};
    set_rows(figure, order.size(), 170, std::max(60, 20 * static_cast<int>(parameters.size())));
    return figure;
}

Figure rank_figure(const MechanismRecovery& recovery, const ParameterRecovery& parameter) {
    Figure figure{.title = "Ranks of the truth: " + human_name(parameter.name),
                  .x = {.title = "rank among " + std::to_string(ranked_draws) + " draws",
                        .range = std::pair{-0.5, ranked_draws + 0.5}},
                  .y = {.title = "repetitions"}};
    Boxes boxes{.legend = human_name(recovery.name), .colour = Colour::blue};
    const double width = (ranked_draws + 1.0) / static_cast<double>(parameter.histogram.size());
    const auto [few, many] = usual_bar(recovery.counted);
    double highest = many;
    for (std::size_t bin = 0; bin < parameter.histogram.size(); ++bin) {
        const double left = static_cast<double>(bin) * width - 0.5;
        boxes.boxes.push_back({{left, 0}, {left + width, static_cast<double>(parameter.histogram[bin])}});
        highest = std::max(highest, static_cast<double>(parameter.histogram[bin]));
    }
    figure.series.emplace_back(std::move(boxes));
    figure.series.emplace_back(
        level_line(-0.5, ranked_draws + 0.5, few, "95 % of the bars of uniform ranks", Colour::vermilion));
    figure.series.emplace_back(level_line(-0.5, ranked_draws + 0.5, many, "", Colour::vermilion));
    figure.y.range = std::pair{0.0, 1.15 * highest};
    return figure;
}

Figure coverage_figure(const MechanismRecovery& recovery) {
    Figure figure{.title = "Intervals that hold the truth",
                  .x = {.title = "share of the repetitions", .unit = "%", .range = std::pair{0.0, 100.0}}};
    const auto count = recovery.parameters.size();
    const double top = static_cast<double>(count) + 0.6;
    for (const auto& [member, nominal, colour, shift, name] :
         {std::tuple{&ParameterRecovery::coverage_68, 68.3, Colour::blue, 0.15, "68 % intervals"},
          std::tuple{&ParameterRecovery::coverage_95, 95.0, Colour::orange, -0.15, "95 % intervals"}}) {
        Points points{.legend = name, .colour = colour};
        std::vector<Line> errors;
        for (std::size_t row = 0; row < count; ++row) {
            const Estimate& share = recovery.parameters[row].*member;
            const double height = static_cast<double>(count - row) + shift;
            points.points.emplace_back(100 * share.value, height);
            errors.push_back(
                {.points = {{100 * share.interval_95.lower, height}, {100 * share.interval_95.upper, height}},
                 .colour = colour,
                 .width = 2});
        }
        figure.series.emplace_back(Line{.points = {{nominal, 0.4}, {nominal, top}},
                                        .legend = std::string(name) + " as they should be",
                                        .colour = colour,
                                        .dash = Dash::dashed,
                                        .width = 2});
        figure.series.insert(figure.series.end(), errors.begin(), errors.end());
        figure.series.emplace_back(std::move(points));
    }
    for (std::size_t row = 0; row < count; ++row) {
        figure.y.ticks.emplace_back(static_cast<double>(count - row),
                                    wrapped(human_name(recovery.parameters[row].name), letters_of_candidate));
    }
    set_rows(figure, count, 190, 70);
    return figure;
}

}  // namespace delabole
