#include "plots/figures/study_figures.hpp"

#include "plots/drawing/extent.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace delabole {

namespace {

constexpr std::array colours = {Colour::vermilion, Colour::blue, Colour::green, Colour::purple, Colour::orange};
constexpr std::array markers = {Marker::filled_circle, Marker::filled_square, Marker::filled_triangle,
                                Marker::filled_diamond};
constexpr double normal_95 = 1.96;

bool has_evidence(const MechanismFit& fit) {
    return fit.posterior && fit.posterior->evidence().status == EvidenceStatus::estimated;
}

struct Part {
    const char* legend;
    Colour colour;
    double length;
};

std::array<Part, 4> parts_of(const MechanismPosterior& posterior) {
    return {{{"misfit of the best point", Colour::vermilion, posterior.least_misfit / 2},
             {"share of the priors that the data leave", Colour::sky, -posterior.log_occam_factor()},
             {"data about which it says nothing", Colour::grey, 2.0 * posterior.missing_data},
             {"field evidence about which it says nothing", Colour::orange, 2.0 * posterior.missing_field_evidence}}};
}

}  // namespace

std::string variant_in_words(EvidenceVariant variant) {
    return words_for(variant,
                     {"as given", "priors half as wide", "priors twice as wide", "flat priors", "prior means lower",
                      "prior means higher", "half the model error", "twice the model error"});
}

std::optional<Figure> evidence_figure(const FitResult& result) {
    std::vector<const MechanismFit*> fits;
    for (const MechanismFit& fit : result.mechanisms) {
        if (has_evidence(fit)) {
            fits.push_back(&fit);
        }
    }
    if (fits.empty()) {
        return std::nullopt;
    }
    Figure figure{.title = "Evidence and what takes from it", .x = {.title = "ln evidence"}};
    std::array<Boxes, 4> boxes;
    std::vector<Line> errors;
    Extent extent;
    extent.include(0);
    for (std::size_t row = 0; row < fits.size(); ++row) {
        const MechanismPosterior& posterior = *fits[row]->posterior;
        const auto height = static_cast<double>(fits.size() - row);
        double end = 0;
        const std::array<Part, 4> parts = parts_of(posterior);
        for (std::size_t index = 0; index < parts.size(); ++index) {
            boxes[index].legend = parts[index].length != 0 ? parts[index].legend : boxes[index].legend;
            boxes[index].colour = parts[index].colour;
            boxes[index].boxes.push_back({{end - parts[index].length, height - 0.3}, {end, height + 0.3}});
            end -= parts[index].length;
        }
        const double error = normal_95 * posterior.evidence().standard_error;
        errors.push_back({.points = {{end - error, height}, {end + error, height}},
                          .legend = errors.empty() ? "95 % interval of the sum" : "",
                          .width = 4});
        figure.labels.push_back({.at = {end, height},
                                 .text = "\u2212" + human_number(-end, 3) + "\u00a0",
                                 .align = Label::Align::right,
                                 .boxed = false});
        figure.y.ticks.emplace_back(height, wrapped(human_name(fits[row]->name), 18));
        extent.include(end - error);
    }
    for (Boxes& part : boxes) {
        figure.series.emplace_back(std::move(part));
    }
    figure.series.insert(figure.series.end(), errors.begin(), errors.end());
    figure.x.range = std::pair{1.22 * extent.lowest, 0.0};  // leaves room for the number at the end of the longest bar
    set_rows(figure, fits.size(), 130, 70);
    return figure;
}

std::optional<Figure> evidence_dependence_figure(const FitResult& result) {
    Figure figure{.title = "Evidence with other priors and model errors", .y = {.title = "ln evidence"}};
    std::size_t count = 0;
    std::size_t variants = 0;
    for (const MechanismFit& fit : result.mechanisms) {
        if (!has_evidence(fit) || fit.posterior->evidences.size() < 2) {
            continue;
        }
        Points points{.legend = human_name(fit.name),
                      .colour = colours[count % colours.size()],
                      .marker = markers[count % markers.size()],
                      .size = 1.8};
        for (std::size_t index = 0; index < fit.posterior->evidences.size(); ++index) {
            const VariantEvidence& variant = fit.posterior->evidences[index];
            // The marks are placed next to each other, because they often agree.
            constexpr double apart = 0.12;
            const double place = static_cast<double>(index) + apart * static_cast<double>(count);
            const double value = fit.posterior->log_evidence(variant.evidence, true);
            const double error = normal_95 * variant.evidence.standard_error;
            points.points.emplace_back(place, value);
            if (variant.evidence.status == EvidenceStatus::estimated) {
                figure.series.emplace_back(Line{
                    .points = {{place, value - error}, {place, value + error}}, .colour = points.colour, .width = 3});
            }
            if (count == 0) {
                figure.x.ticks.emplace_back(place, wrapped(variant_in_words(variant.variant), 8));
            }
        }
        variants = std::max(variants, fit.posterior->evidences.size());
        figure.series.emplace_back(std::move(points));
        ++count;
    }
    if (count == 0) {
        return std::nullopt;
    }
    figure.x.range = std::pair{-0.5, static_cast<double>(variants) - 0.5};
    figure.x.grid = false;
    figure.width = 760;
    figure.height = 520;
    return figure;
}

std::optional<Figure> chain_agreement_figure(const FitResult& result) {
    Figure figure{
        .title = "Agreement of the chains", .x = {.title = "steps of each chain"}, .y = {.title = "greatest R-hat"}};
    for (const double r_hat : {1.0001, 1.0003, 1.001, 1.003, 1.01, 1.03, 1.1, 1.3, 2.0, 4.0}) {
        figure.y.ticks.emplace_back(std::log10(r_hat - 1), human_number(r_hat, 5));
    }
    std::size_t count = 0;
    double longest = 0;
    for (const MechanismFit& fit : result.mechanisms) {
        if (!fit.posterior || fit.posterior->posterior.running.empty()) {
            continue;
        }
        const auto& running = fit.posterior->posterior.running;
        Line line{.legend = human_name(fit.name), .colour = colours[count % colours.size()], .width = 2.5};
        for (std::size_t length = 0; length < running.front().size(); ++length) {
            double worst = 1;
            for (const std::vector<RunningQuantiles>& parameter : running) {
                worst = std::max(worst, parameter[length].r_hat);
            }
            constexpr double least = 1e-4;  // smaller values of R-hat - 1 are chance
            line.points.emplace_back(running.front()[length].steps, std::log10(std::max(worst - 1, least)));
            longest = std::max(longest, line.points.back().x());
        }
        figure.series.emplace_back(std::move(line));
        ++count;
    }
    if (count == 0) {
        return std::nullopt;
    }
    const double limit = std::log10(greatest_r_hat - 1);
    figure.series.emplace_back(Line{.points = {{0, limit}, {longest, limit}},
                                    .legend = "limit, R-hat " + human_number(greatest_r_hat, 3),
                                    .colour = Colour::black,
                                    .dash = Dash::dashed,
                                    .width = 2});
    figure.x.range = std::pair{0.0, longest};
    return figure;
}

std::optional<Figure> running_quantiles_figure(const MechanismFit& fit) {
    if (!fit.posterior || fit.posterior->posterior.running.empty()) {
        return std::nullopt;
    }
    const Posterior& posterior = fit.posterior->posterior;
    Figure figure{
        .title = fit.title, .x = {.title = "steps of each chain"}, .y = {.title = "median and 95 % interval, scaled"}};
    for (std::size_t index = 0; index < posterior.running.size(); ++index) {
        const ParameterPosterior& parameter = posterior.parameters[index];
        const double scale = parameter.standard_deviation > 0 ? parameter.standard_deviation : 1;
        Line median{.legend = human_name(parameter.name), .colour = colours[index % colours.size()], .width = 3};
        Line lower{.colour = median.colour, .dash = Dash::dashed, .width = 1.8};
        Line upper = lower;
        for (const RunningQuantiles& at : posterior.running[index]) {
            median.points.emplace_back(at.steps, (at.median - parameter.median) / scale);
            lower.points.emplace_back(at.steps, (at.lower_95 - parameter.median) / scale);
            upper.points.emplace_back(at.steps, (at.upper_95 - parameter.median) / scale);
        }
        for (Line* line : {&median, &lower, &upper}) {
            figure.series.emplace_back(std::move(*line));
        }
    }
    figure.x.range = std::pair{0.0, static_cast<double>(posterior.steps)};
    return figure;
}

}  // namespace delabole
