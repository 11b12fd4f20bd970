#include "plots/figures/sensitivity_figures.hpp"
#include "fitting/work/words.hpp"

#include "plots/drawing/extent.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace delabole {

namespace {

constexpr std::size_t letters_of_name = 22;  // in one line beside a bar

double unit_of(const StudiedQuantity& quantity) {
    return display_unit(quantity.dimension).si_per_unit;
}

std::string with_unit(double value, Dimension dimension) {
    const DisplayUnit unit = shown_unit(dimension);
    const std::string number = human_number(value / unit.si_per_unit, 3);
    return unit.symbol.empty() ? number : number + "\u00a0" + human_unit(unit.symbol);
}

// Indices of the items with a value, the largest first.
template <class Value>
std::vector<std::size_t> largest_first(std::size_t count, const Value& value) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t index) { return !value(index).has_value(); });
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t one, std::size_t other) { return *value(one) > *value(other); });
    return order;
}

// Position of the bar of a parameter; the first row is at the top.
double row_position(std::size_t rows, std::size_t row) {
    return static_cast<double>(rows - row);
}

void include_interval(const Interval& interval, Extent& extent) {
    extent.include(interval.lower);
    extent.include(interval.upper);
}

std::pair<double, double> widened(const Extent& extent, double share) {
    const double margin = extent.size() > 0 ? share * extent.size() : std::max(std::abs(extent.lowest), 1.0) * share;
    return {extent.lowest - margin, extent.highest + margin};
}

// Labels powers of ten; for few decades also 2 and 5 of each, or all digits. `from` and `to` are logarithms.
void set_sample_ticks(Axis& axis, double from, double to) {
    constexpr double some_decades = 2.5;
    constexpr double part_of_a_decade = 0.8;
    for (int decade = static_cast<int>(std::floor(from)); decade <= static_cast<int>(std::ceil(to)); ++decade) {
        for (const int mantissa : {1, 2, 3, 4, 5, 6, 8}) {
            const bool round = mantissa == 1 || mantissa == 2 || mantissa == 5;
            const bool shown = mantissa == 1 || (round && to - from < some_decades) || to - from < part_of_a_decade;
            const double at = decade + std::log10(mantissa);
            if (shown && at >= from - 1e-9 && at <= to + 1e-9) {
                axis.ticks.emplace_back(at, std::to_string(std::llround(mantissa * std::pow(10.0, decade))));
            }
        }
    }
}

std::string limit_legend(const StudiedQuantity& quantity, const FailureCriterion& criterion) {
    return "fails " + std::string(word_of(criterion.side)) + " " + with_unit(criterion.limit, quantity.dimension);
}

}  // namespace

Figure tornado_range_figure(const StudiedQuantity& quantity, const TornadoResult& result,
                            const TornadoSettings& settings, const std::vector<UncertainParameter>& parameters,
                            const std::vector<Dimension>& dimensions, std::optional<double> limit) {
    const double unit = unit_of(quantity);
    Figure figure{.title = "One parameter at a time", .x = axis_of(quantity.name, quantity.dimension)};
    const auto percent = [](double probability) { return human_number(100 * probability, 3) + " %"; };
    Boxes low{.legend = "parameter at its " + percent(settings.lower_probability) + " quantile", .colour = Colour::sky};
    Boxes high{.legend = "parameter at its " + percent(settings.upper_probability) + " quantile",
               .colour = Colour::orange};
    std::vector<std::size_t> order = largest_first(
        result.bars.size(), [&](std::size_t index) { return result.bars[index].swing(result.at_medians); });
    constexpr std::size_t most_bars = 8;
    if (order.size() > most_bars) {
        order.resize(most_bars);
        figure.title += ": the eight that matter most";
    }
    Extent extent;
    const double middle = result.at_medians.value / unit;
    for (std::size_t row = 0; row < order.size(); ++row) {
        const TornadoBar& bar = result.bars[order[row]];
        const double position = row_position(order.size(), row);
        // Both ends lie on one side of the middle, for example at a maximum of the quantity: the bars are drawn one
        // above the other.
        const double at_low = bar.low.answer.value / unit;
        const double at_high = bar.high.answer.value / unit;
        const bool same_side = (at_low - middle) * (at_high - middle) > 0;
        for (auto [boxes, value, below, above] : {std::tuple{&low, at_low, same_side ? 0.02 : -0.32, 0.32},
                                                  std::tuple{&high, at_high, -0.32, same_side ? -0.02 : 0.32}}) {
            boxes->boxes.push_back(
                {{std::min(middle, value), position + below}, {std::max(middle, value), position + above}});
            extent.include(value);
        }
        const UncertainParameter& parameter = parameters[order[row]];
        const Dimension dimension = dimensions[order[row]];
        figure.y.ticks.emplace_back(
            position, wrapped(human_name(parameter.name) + ", " + with_unit(bar.low.parameter, dimension) + " to " +
                                  with_unit(bar.high.parameter, dimension),
                              letters_of_name));
    }
    constexpr int row_of_three_lines = 92;
    set_rows(figure, order.size(), 130, row_of_three_lines);
    figure.series.emplace_back(std::move(low));
    figure.series.emplace_back(std::move(high));
    if (!order.empty()) {
        extent.include(middle);
        if (limit) {
            extent.include(*limit / unit);
        }
        figure.x.range = widened(extent, 0.05);
        const auto [bottom, top] = *figure.y.range;
        figure.series.emplace_back(
            Line{.points = {{middle, bottom}, {middle, top}}, .legend = "all at their medians", .width = 1.5});
        if (limit) {
            figure.series.emplace_back(Line{.points = {{*limit / unit, bottom}, {*limit / unit, top}},
                                            .legend = "limit of failure",
                                            .colour = Colour::vermilion,
                                            .dash = Dash::dashed,
                                            .width = 2.5});
        }
    }
    return figure;
}

Figure morris_figure(const StudiedQuantity& quantity, const MorrisResult& result, const ParameterNames& names) {
    const double unit = unit_of(quantity);
    const std::string symbol = human_unit(display_unit(quantity.dimension).symbol);
    Figure figure{.title = "Screening of " + human_name(quantity.name),
                  .x = {.title = "mean absolute effect of the whole range", .unit = symbol},
                  .y = {.title = "standard deviation of the effects", .unit = symbol}};
    constexpr std::array colours{Colour::blue,   Colour::vermilion, Colour::green, Colour::orange,
                                 Colour::purple, Colour::black,     Colour::sky};
    constexpr std::array markers{Marker::filled_circle, Marker::filled_square, Marker::filled_triangle,
                                 Marker::filled_diamond, Marker::circle};
    Extent x;
    Extent y;
    x.include(0);
    y.include(0);
    const std::vector<std::size_t> order = largest_first(result.parameters.size(), [&](std::size_t index) {
        const MorrisEffect& effect = result.parameters[index];
        return effect.effects >= 2 ? std::optional(effect.mean_absolute.value) : std::nullopt;
    });
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        const MorrisEffect& effect = result.parameters[order[rank]];
        const Interval& across = effect.mean_absolute.interval_95;
        const Interval& along = effect.standard_deviation.interval_95;
        const Point at{effect.mean_absolute.value / unit, effect.standard_deviation.value / unit};
        const Colour colour = colours[rank % colours.size()];
        figure.series.emplace_back(Line{
            .points = {{across.lower / unit, at.y()}, {across.upper / unit, at.y()}}, .colour = colour, .width = 1.5});
        figure.series.emplace_back(Line{
            .points = {{at.x(), along.lower / unit}, {at.x(), along.upper / unit}}, .colour = colour, .width = 1.5});
        figure.series.emplace_back(Points{.points = {at},
                                          .legend = human_name(names[order[rank]]),
                                          .colour = colour,
                                          .marker = markers[rank % markers.size()],
                                          .size = 1.8});
        include_interval({across.lower / unit, across.upper / unit}, x);
        include_interval({along.lower / unit, along.upper / unit}, y);
    }
    if (!order.empty() && x.size() > 0) {
        const double end = std::min(x.highest, y.highest);
        if (end > 0) {
            figure.series.emplace_back(Line{.points = {{0, 0}, {end, end}},
                                            .legend = "above: what it does depends on the other values",
                                            .colour = Colour::grey,
                                            .dash = Dash::dotted,
                                            .width = 2});
        }
        figure.x.range = std::pair{0.0, 1.05 * x.highest};
        figure.y.range =
            std::pair{-0.03 * std::max(y.highest, 1e-3 * x.highest), 1.05 * std::max(y.highest, 1e-3 * x.highest)};
    }
    figure.width = 720;
    figure.height = 500;
    return figure;
}

Figure sobol_indices_figure(const StudiedQuantity& quantity, const SobolIndicesResult& result,
                            const ParameterNames& names) {
    Figure figure{.title = "Shares of the variance of " + human_name(quantity.name), .x = {.title = "Sobol index"}};
    Boxes first{.legend = "alone (first order)", .colour = Colour::blue};
    Boxes total{.legend = "with its interactions (total)", .colour = Colour::orange};
    const std::vector<std::size_t> order = largest_first(result.parameters.size(), [&](std::size_t index) {
        return std::optional(result.parameters[index].total.value);
    });
    std::vector<Line> errors;
    Extent extent;
    extent.include(0);
    for (std::size_t row = 0; row < order.size(); ++row) {
        const double position = row_position(order.size(), row);
        const SobolIndex& index = result.parameters[order[row]];
        for (auto [boxes, estimate, middle] :
             {std::tuple{&first, &index.first, position + 0.17}, std::tuple{&total, &index.total, position - 0.17}}) {
            boxes->boxes.push_back(
                {{std::min(0.0, estimate->value), middle - 0.15}, {std::max(0.0, estimate->value), middle + 0.15}});
            errors.push_back({.points = {{estimate->interval_95.lower, middle}, {estimate->interval_95.upper, middle}},
                              .legend = errors.empty() ? "95 % interval" : "",
                              .width = 2});
            include_interval(estimate->interval_95, extent);
            extent.include(estimate->value);
        }
        figure.y.ticks.emplace_back(position, wrapped(human_name(names[order[row]]), letters_of_name));
    }
    constexpr int row_of_two_lines = 74;
    set_rows(figure, order.size(), 130, row_of_two_lines);
    figure.series.emplace_back(std::move(first));
    figure.series.emplace_back(std::move(total));
    figure.series.insert(figure.series.end(), errors.begin(), errors.end());
    if (!order.empty()) {
        figure.x.range =
            std::pair{extent.lowest < 0 ? 1.05 * extent.lowest : 0.0, std::max(1.05 * extent.highest, 0.1)};
    }
    return figure;
}

Figure histogram_figure(const StudiedQuantity& quantity, const PropagationResult& result,
                        const std::optional<FailureCriterion>& criterion) {
    const double unit = unit_of(quantity);
    Figure figure{.title = "Distribution of " + human_name(quantity.name),
                  .x = axis_of(quantity.name, quantity.dimension),
                  .y = {.title = "share of the samples", .unit = "%"}};
    Boxes stands{.legend = criterion ? "stands" : "samples", .colour = Colour::blue};
    Boxes fails{.legend = criterion ? limit_legend(quantity, *criterion) : "", .colour = Colour::vermilion};
    double highest = 0;
    for (const HistogramBin& bin : result.histogram) {
        // A bin of a single value still needs a bar of some width.
        const double half = bin.lower == bin.upper ? std::max(std::abs(bin.lower), unit) * 0.01 : 0;
        const double share = 100 * static_cast<double>(bin.samples) / static_cast<double>(result.with_value);
        const bool failed = criterion && criterion->failed((bin.lower + bin.upper) / 2);
        (failed ? fails : stands).boxes.push_back({{(bin.lower - half) / unit, 0}, {(bin.upper + half) / unit, share}});
        highest = std::max(highest, share);
    }
    const bool any_failed = !fails.boxes.empty();
    if (!stands.boxes.empty()) {
        figure.series.emplace_back(std::move(stands));
    }
    if (any_failed) {
        figure.series.emplace_back(std::move(fails));
    }
    figure.y.range = std::pair{0.0, std::max(1.08 * highest, 1e-3)};
    return figure;
}

Figure cumulative_figure(const StudiedQuantity& quantity, const PropagationResult& result,
                         const std::optional<FailureCriterion>& criterion) {
    const double unit = unit_of(quantity);
    Figure figure{.title = "Cumulative distribution of " + human_name(quantity.name),
                  .x = axis_of(quantity.name, quantity.dimension),
                  .y = {.title = "share of the samples not above", .unit = "%", .range = std::pair{0.0, 100.0}}};
    Line curve{.legend = "samples with a value", .colour = Colour::blue, .width = 3};
    Extent extent;
    for (const auto& [value, share] : result.cumulative) {
        curve.points.emplace_back(value / unit, 100 * share);
        extent.include(value / unit);
    }
    if (extent.empty()) {
        return figure;
    }
    if (criterion) {
        extent.include(criterion->limit / unit);
    }
    figure.x.range = widened(extent, 0.03);
    if (criterion && result.failure) {
        const auto [left, right] = *figure.x.range;
        const double limit = criterion->limit / unit;
        const bool below = criterion->side == FailureSide::below;
        std::string legend = limit_legend(quantity, *criterion);
        if (const auto& probability = result.failure->probability) {
            legend += ": " + human_number(100 * probability->value, 3) + " % of the samples";
            legend += result.failure->decided < result.samples ? " that are decided" : "";
        }
        figure.series.emplace_back(Region{.outline = below
                                                         ? Polyline{{left, 0}, {limit, 0}, {limit, 100}, {left, 100}}
                                                         : Polyline{{limit, 0}, {right, 0}, {right, 100}, {limit, 100}},
                                          .legend = std::move(legend),
                                          .colour = Colour::vermilion,
                                          .opacity = 0.15});
    }
    figure.series.emplace_back(std::move(curve));
    return figure;
}

Figure sampling_convergence_figure(const StudiedQuantity& quantity, const PropagationResult& result,
                                   std::optional<double> first_order_probability) {
    const bool of_failure = result.failure && result.failure->probability;
    const double unit = of_failure ? 0.01 : unit_of(quantity);
    Figure figure{.title = "Convergence of the sampling",
                  .x = {.title = "samples"},
                  .y = of_failure ? Axis{.title = "probability of failure", .unit = "%"}
                                  : Axis{.title = "mean of " + human_name(quantity.name),
                                         .unit = human_unit(display_unit(quantity.dimension).symbol)}};
    Line line{.legend = of_failure ? "estimate" : "mean", .colour = Colour::blue, .width = 3};
    Region band{.legend = "95 % interval", .colour = Colour::sky, .opacity = 0.35};
    Polyline back;
    Extent heights;
    for (const ConvergenceStep& step : result.convergence) {
        const std::optional<Estimate> estimate = of_failure ? step.probability : std::optional(step.mean);
        if (!estimate) {
            continue;
        }
        const double x = std::log10(static_cast<double>(step.samples));
        line.points.emplace_back(x, estimate->value / unit);
        band.outline.emplace_back(x, estimate->interval_95.lower / unit);
        back.emplace_back(x, estimate->interval_95.upper / unit);
        include_interval({estimate->interval_95.lower / unit, estimate->interval_95.upper / unit}, heights);
    }
    if (line.points.empty()) {
        return figure;
    }
    const double left = line.points.front().x();
    const double right = line.points.back().x();
    band.outline.insert(band.outline.end(), back.rbegin(), back.rend());
    set_sample_ticks(figure.x, left, right);
    if (line.points.size() > 1) {
        figure.x.range = std::pair{left, right};
        figure.series.emplace_back(std::move(band));
    }
    figure.series.emplace_back(std::move(line));
    if (of_failure && first_order_probability) {
        figure.series.emplace_back(
            level_line(left, right, *first_order_probability / unit, "first-order reliability", Colour::vermilion));
        heights.include(*first_order_probability / unit);
    }
    const auto [lowest, highest] = widened(heights, 0.05);
    figure.y.range = std::pair{of_failure ? std::max(lowest, 0.0) : lowest, highest};
    return figure;
}

}  // namespace delabole
