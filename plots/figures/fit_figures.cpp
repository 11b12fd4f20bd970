#include "plots/figures/study_figures.hpp"

#include "fitting/probability/estimate.hpp"
#include "plots/drawing/contour.hpp"
#include "plots/drawing/polygon.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace delabole {

namespace {

// Quantiles of chi-square with one degree of freedom.
constexpr double level_68 = 0.988946481478023;
constexpr double level_95 = 3.841458820694124;

std::optional<std::size_t> parameter_index(const MechanismFit& fit, std::string_view name) {
    for (std::size_t index = 0; index < fit.parameters.size(); ++index) {
        if (fit.parameters[index].name == name) {
            return index;
        }
    }
    return std::nullopt;
}

Dimension parameter_dimension(const MechanismFit& fit, std::string_view name) {
    const std::optional<std::size_t> index = parameter_index(fit, name);
    return index && *index < fit.dimensions.size() ? fit.dimensions[*index] : Dimension::ratio;
}

double unit_of(Dimension dimension) {
    return display_unit(dimension).si_per_unit;
}

double least(const Eigen::MatrixXd& values) {
    double result = std::numeric_limits<double>::infinity();
    for (const double value : values.reshaped()) {
        result = std::isfinite(value) ? std::min(result, value) : result;
    }
    return result;
}

std::vector<double> scaled(std::vector<double> values, double unit) {
    for (double& value : values) {
        value /= unit;
    }
    return values;
}

// Points of the locus in the axes of the map, which may be exchanged with respect to those of the locus.
std::optional<Polyline> locus_in_map(const FailureLocus& locus, const MisfitMap& map, const Point& unit) {
    const bool same = locus.x == map.x && locus.y == map.y;
    const bool swapped = locus.x == map.y && locus.y == map.x;
    if (!same && !swapped) {
        return std::nullopt;
    }
    Polyline line;
    for (std::size_t index = 0; index < locus.points.size(); ++index) {
        const Point& point = locus.points[index];
        if (index > 0 && locus.branch[index] != locus.branch[index - 1]) {
            constexpr double gap = std::numeric_limits<double>::quiet_NaN();
            line.emplace_back(gap, gap);
        }
        const Point turned = same ? point : Point(point.y(), point.x());
        line.push_back(turned.cwiseQuotient(unit));
    }
    return line;
}

void add_minima(const MechanismFit& fit, const MisfitMap& map, const Point& unit, Figure& figure) {
    const std::optional<std::size_t> x = parameter_index(fit, map.x);
    const std::optional<std::size_t> y = parameter_index(fit, map.y);
    if (!x || !y) {
        return;
    }
    Points others{.legend = "other minima of the starts", .marker = Marker::filled_circle, .size = 1.2};
    Points best{.legend = "least misfit", .marker = Marker::filled_diamond, .size = 2.0};
    for (const MinimumCluster& cluster : fit.minima) {
        if (std::max(*x, *y) < cluster.parameters.size()) {
            Points& points = best.points.empty() ? best : others;
            points.points.push_back(Point(cluster.parameters[*x], cluster.parameters[*y]).cwiseQuotient(unit));
        }
    }
    // The marks have a white rim, because they lie on both light and dark ground.
    for (const Points* points : {&others, &best}) {
        figure.series.emplace_back(Points{.points = points->points,
                                          .colour = Colour::white,
                                          .marker = Marker::filled_circle,
                                          .size = points->size + 0.5});
    }
    figure.series.emplace_back(std::move(others));
    figure.series.emplace_back(std::move(best));
}

// Height of a profile at a place along the ground; NaN beyond its ends.
double height_at(const Polyline& profile, double x) {
    for (std::size_t index = 1; index < profile.size(); ++index) {
        const Point& left = profile[index - 1];
        const Point& right = profile[index];
        if (x >= left.x() && x <= right.x()) {
            return right.x() > left.x() ? std::lerp(left.y(), right.y(), (x - left.x()) / (right.x() - left.x()))
                                        : right.y();
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

// Band between the 2.5 and 97.5 % quantiles of the heights that the posterior's draws predict; empty if it would be too
// narrow to see.
Polyline prediction_band(const MechanismPosterior& posterior, double end) {
    constexpr int places = 120;
    constexpr double seen = 0.05;  // m, the least visible width
    Polyline lower;
    Polyline upper;
    double widest = 0;
    for (int place = 0; place <= places; ++place) {
        const double x = end * place / places;
        std::vector<double> heights;
        for (const Polyline& profile : posterior.profiles) {
            const double height = height_at(profile, x);
            if (std::isfinite(height)) {
                heights.push_back(height);
            }
        }
        if (heights.size() < posterior.profiles.size()) {
            continue;
        }
        std::sort(heights.begin(), heights.end());
        lower.emplace_back(x, sorted_quantile(heights, 0.025));
        upper.emplace_back(x, sorted_quantile(heights, 0.975));
        widest = std::max(widest, upper.back().y() - lower.back().y());
    }
    if (widest < seen) {
        return {};
    }
    lower.insert(lower.end(), upper.rbegin(), upper.rend());
    return lower;
}

}  // namespace

std::optional<Figure> misfit_map_figure(const MechanismFit& fit) {
    if (!fit.map) {
        return std::nullopt;
    }
    const MisfitMap& map = *fit.map;
    const Dimension x_dimension = parameter_dimension(fit, map.x);
    const Dimension y_dimension = parameter_dimension(fit, map.y);
    const Point unit{unit_of(x_dimension), unit_of(y_dimension)};
    Figure figure{.title = fit.title, .x = axis_of(map.x, x_dimension), .y = axis_of(map.y, y_dimension)};
    figure.x.grid = false;
    figure.y.grid = false;
    figure.height = 500;

    const double lowest = std::min(least(map.misfit), fit.minima.empty() ? least(map.misfit) : fit.minima[0].misfit);
    const std::vector<double> x_values = scaled(map.x_values, unit.x());
    const std::vector<double> y_values = scaled(map.y_values, unit.y());
    // The colour scale ends at three times the 95 % level, which shows enough of the surroundings and leaves a third of
    // the colours to the region itself.
    figure.series.emplace_back(HeatMap{.x_values = x_values,
                                       .y_values = y_values,
                                       .values = map.misfit.array() - lowest,
                                       .scale_title = "misfit above the least",
                                       .ceiling = std::max(3 * (map.level_95 - lowest), 1e-12),
                                       .no_answer_legend = "no answer"});
    figure.series.emplace_back(Line{.points = broken_line(contour_lines(x_values, y_values, map.misfit, map.level_95)),
                                    .legend = "95 % region",
                                    .dash = Dash::dashed});
    figure.series.emplace_back(Line{.points = broken_line(contour_lines(x_values, y_values, map.misfit, map.level_68)),
                                    .legend = "68 % region"});
    for (const FailureLocus& locus : fit.loci) {
        if (const std::optional<Polyline> line = locus_in_map(locus, map, unit)) {
            figure.series.emplace_back(
                Line{.points = *line, .legend = "factor of safety 1", .colour = Colour::vermilion, .width = 3.5});
        }
    }
    add_minima(fit, map, unit, figure);
    // The locus may extend beyond the map.
    if (x_values.size() > 1 && y_values.size() > 1) {
        const double half_column = 0.5 * (x_values[1] - x_values[0]);
        const double half_line = 0.5 * (y_values[1] - y_values[0]);
        figure.x.range = std::pair{x_values.front() - half_column, x_values.back() + half_column};
        figure.y.range = std::pair{y_values.front() - half_line, y_values.back() + half_line};
    }
    return figure;
}

std::optional<Figure> profile_likelihood_figure(const MechanismFit& fit, std::string_view parameter) {
    const Dimension dimension = parameter_dimension(fit, parameter);
    const double unit = unit_of(dimension);
    Figure figure{.title = fit.title, .x = axis_of(parameter, dimension), .y = {.title = "misfit above its least"}};

    // The axis ends here, because only the ends of the interval matter and not the misfit far from them.
    constexpr double top = 3 * level_95;
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    Points ends{.legend = "ends of the 95 % interval", .marker = Marker::filled_triangle, .size = 1.8};
    for (const ProfileLikelihood& profile : fit.profiles) {
        if (profile.parameter != parameter) {
            continue;
        }
        double lowest = std::numeric_limits<double>::infinity();
        for (const double misfit : profile.misfits) {
            lowest = std::isfinite(misfit) ? std::min(lowest, misfit) : lowest;
        }
        Line line{.legend = profile.with_priors ? "with priors" : "data alone",
                  .colour = profile.with_priors ? Colour::blue : Colour::vermilion,
                  .dash = profile.with_priors ? Dash::solid : Dash::dashed,
                  .width = 3};
        for (std::size_t index = 0; index < std::min(profile.values.size(), profile.misfits.size()); ++index) {
            line.points.emplace_back(profile.values[index] / unit, profile.misfits[index] - lowest);
            left = std::min(left, profile.values[index] / unit);
            right = std::max(right, profile.values[index] / unit);
        }
        // An interval that is cut off by the bound of the parameter has no end there.
        for (const double end : {profile.interval_95.lower, profile.interval_95.upper}) {
            if (!profile.values.empty() && end > profile.values.front() && end < profile.values.back()) {
                ends.points.emplace_back(end / unit, level_95);
            }
        }
        figure.series.emplace_back(std::move(line));
    }
    if (figure.series.empty()) {
        return std::nullopt;
    }
    if (left < right) {
        for (const auto& [level, text] : {std::pair{level_68, "68 %"}, std::pair{level_95, "95 %"}}) {
            figure.series.emplace_back(Line{
                .points = {{left, level}, {right, level}}, .colour = Colour::grey, .dash = Dash::dotted, .width = 2});
            figure.labels.push_back({.at = {right - 0.02 * (right - left), level},
                                     .text = text,
                                     .align = Label::Align::right,
                                     .raise = 0.6});
        }
        figure.x.range = std::pair{left, right};
    }
    figure.series.emplace_back(std::move(ends));
    figure.y.range = std::pair{0.0, top};
    return figure;
}

std::optional<Figure> profiles_figure(const FitProblem& problem, const FitResult& result, double toe_elevation) {
    if (!problem.profile) {
        return std::nullopt;
    }
    Figure figure;
    figure.title = "Profile left standing, observed and predicted";
    figure.x = {.title = "distance from the toe", .unit = "m"};
    figure.y = {.title = toe_elevation == 0 ? "height above the toe" : "elevation", .unit = "m"};
    figure.equal_scales = true;
    constexpr std::array colours = {Colour::vermilion, Colour::blue, Colour::green, Colour::purple, Colour::orange};
    constexpr std::array dashes = {Dash::solid, Dash::dashed, Dash::dotted};
    std::size_t count = 0;
    const double end = problem.profile->profile.back().x();
    for (const MechanismFit& fit : result.mechanisms) {
        if (fit.prediction.profile.empty()) {
            continue;
        }
        Polyline points = raised(fit.prediction.profile, toe_elevation);
        // The level ground far behind the crest shows nothing and is left out.
        while (points.size() > 2 && points[points.size() - 2].x() > 2 * end) {
            points.pop_back();
        }
        if (points.back().x() > 2 * end) {
            const Point& before = points[points.size() - 2];
            const double share = (2 * end - before.x()) / (points.back().x() - before.x());
            points.back() = before + share * (points.back() - before);
        }
        if (fit.posterior && fit.posterior->profiles.size() > 1) {
            Polyline band = prediction_band(*fit.posterior, 2 * end);
            if (!band.empty()) {
                figure.series.emplace_back(Region{.outline = raised(band, toe_elevation),
                                                  .legend = human_name(fit.name) + ", 95 % of the posterior",
                                                  .colour = colours[count % colours.size()],
                                                  .opacity = 0.2});
            }
        }
        figure.series.emplace_back(Line{.points = std::move(points),
                                        .legend = human_name(fit.name),
                                        .colour = colours[count % colours.size()],
                                        .dash = dashes[count % dashes.size()],
                                        .width = 4.0 - 0.5 * static_cast<double>(std::min<std::size_t>(count, 4))});
        ++count;
    }
    if (count == 0) {
        return std::nullopt;
    }
    figure.series.emplace_back(Points{.points = raised(problem.profile->profile, toe_elevation),
                                      .legend = "observed",
                                      .colour = Colour::black,
                                      .marker = Marker::circle,
                                      .size = 1.6});
    return figure;
}

}  // namespace delabole
