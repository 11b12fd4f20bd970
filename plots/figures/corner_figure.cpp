// All panels stand in one drawing whose unit is the distance from panel to panel: the lower left corner of the panel in
// row i and column j is at (j, rows - 1 - i).
#include "fitting/work/words.hpp"
#include "plots/drawing/contour.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/study_figures.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace delabole {

namespace {

constexpr double panel = 0.74;  // side of a panel; the rest of the unit holds titles and numbers
constexpr std::size_t most_parameters_drawn = 6;

struct Shown {
    const FreeParameter* parameter;
    std::size_t index;  // among the parameters of the fit
    Dimension dimension;
    Interval range;              // SI, of the axes of its panels
    std::vector<double> values;  // of the draws

    double scaled(double value) const { return panel * (value - range.lower) / (range.upper - range.lower); }
};

std::vector<Shown> shown_parameters(const MechanismFit& fit) {
    std::vector<Shown> shown;
    for (std::size_t index = 0; index < fit.parameters.size() && shown.size() < most_parameters_drawn; ++index) {
        const FreeParameter& parameter = fit.parameters[index];
        if (!(parameter.lower < parameter.upper)) {
            continue;
        }
        Shown entry{&parameter, index, fit.dimensions[index], {}, {}};
        for (const Draw& draw : fit.posterior->posterior.draws) {
            entry.values.push_back(draw.parameters[index]);
        }
        const auto [least, greatest] = std::minmax_element(entry.values.begin(), entry.values.end());
        const double margin = 0.06 * (*greatest - *least) + 1e-12 * (parameter.upper - parameter.lower);
        entry.range.lower = std::max(parameter.lower, *least - margin);
        entry.range.upper = std::min(parameter.upper, *greatest + margin);
        shown.push_back(std::move(entry));
    }
    return shown;
}

// Two to four round numbers within a range.
std::vector<double> round_numbers(double lower, double upper) {
    const double decade = std::pow(10.0, std::floor(std::log10(upper - lower)));
    for (const double step : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0}) {
        const double first = std::ceil(lower / (step * decade));
        const double last = std::floor(upper / (step * decade));
        if (last - first < 4) {
            std::vector<double> numbers;
            for (double number = first; number <= last; ++number) {
                numbers.push_back(number * step * decade);
            }
            return numbers;
        }
    }
    return {};
}

Point corner_of(std::size_t rows, std::size_t row, std::size_t column) {
    return {static_cast<double>(column), static_cast<double>(rows - 1 - row)};
}

std::string title_of(const Shown& shown) {
    const std::string unit = human_unit(shown_unit(shown.dimension).symbol);
    return wrapped(human_name(shown.parameter->name) + (unit.empty() ? "" : " (" + unit + ")"), 20);
}

void add_frame(const Point& corner, Figure& figure) {
    figure.series.emplace_back(Line{
        .points = {corner, corner + Point(panel, 0), corner + Point(panel, panel), corner + Point(0, panel), corner},
        .colour = Colour::black,
        .width = 1.2});
}

// Numbers below the lowest panel of the column, or beside the first panel of the row.
void add_ticks(const Shown& shown, const Point& corner, bool below, Figure& figure) {
    const double unit = shown_unit(shown.dimension).si_per_unit;
    for (const double number : round_numbers(shown.range.lower / unit, shown.range.upper / unit)) {
        const double place = shown.scaled(number * unit);
        const Point at = corner + (below ? Point(place, 0) : Point(0, place));
        const Point out = below ? Point(0, -0.03) : Point(-0.03, 0);
        figure.series.emplace_back(Line{.points = {at, at + out}, .width = 1.2});
        figure.labels.push_back({.at = at + (below ? Point(0, -0.09) : Point(-0.05, 0)),
                                 .text = human_number(number, 4),
                                 .align = below ? Label::Align::centre : Label::Align::right,
                                 .boxed = false,
                                 .size = 0.72});
    }
}

// Density of the prior up to a constant; flat without a prior.
double prior_density(const FreeParameter& parameter, double value) {
    if (!parameter.prior) {
        return 1;
    }
    const double z = (value - parameter.prior->mean) / parameter.prior->standard_deviation;
    return std::exp(-z * z / 2);
}

// Integral of prior_density() over the range, for values in SI.
double prior_integral(const FreeParameter& parameter) {
    if (!parameter.prior) {
        return parameter.upper - parameter.lower;
    }
    const double root = std::sqrt(2.0) * parameter.prior->standard_deviation;
    const double share = (std::erf((parameter.upper - parameter.prior->mean) / root) -
                          std::erf((parameter.lower - parameter.prior->mean) / root)) /
                         2;
    return share * parameter.prior->standard_deviation * std::sqrt(2 * std::numbers::pi);
}

void add_marginal(const Shown& shown, const Point& corner, double best, Figure& figure) {
    constexpr std::size_t bins = 30;
    std::vector<double> density(bins, 0);
    const double width = (shown.range.upper - shown.range.lower) / bins;
    for (const double value : shown.values) {
        const auto bin = static_cast<std::size_t>(std::clamp((value - shown.range.lower) / width, 0.0, bins - 1.0));
        density[bin] += 1 / (width * static_cast<double>(shown.values.size()));
    }
    double top = *std::max_element(density.begin(), density.end());
    Line prior{.legend = "prior", .colour = Colour::grey, .width = 1.6};
    constexpr int points = 80;
    std::vector<Point> curve;
    const double integral = prior_integral(*shown.parameter);
    for (int index = 0; index <= points; ++index) {
        const double value = std::lerp(shown.range.lower, shown.range.upper, static_cast<double>(index) / points);
        curve.emplace_back(shown.scaled(value), prior_density(*shown.parameter, value) / integral);
        top = std::max(top, curve.back().y());
    }
    const double scale = 0.92 * panel / top;
    Polyline outline = {corner};
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const double left = panel * static_cast<double>(bin) / bins;
        const double right = panel * static_cast<double>(bin + 1) / bins;
        outline.push_back(corner + Point(left, scale * density[bin]));
        outline.push_back(corner + Point(right, scale * density[bin]));
    }
    outline.push_back(corner + Point(panel, 0));
    figure.series.emplace_back(
        Region{.outline = outline, .legend = "posterior", .colour = Colour::blue, .opacity = 0.4});
    for (const Point& point : curve) {
        prior.points.push_back(corner + Point(point.x(), scale * point.y()));
    }
    figure.series.emplace_back(std::move(prior));
    figure.series.emplace_back(Line{
        .points = {corner + Point(shown.scaled(best), 0), corner + Point(shown.scaled(best), panel)}, .width = 1.5});
}

struct Density {
    std::vector<double> places;  // of both axes, in the panel
    Eigen::MatrixXd values;      // values(row, column) at y(row), x(column)
};

// Kernel density estimate with the covariance of the draws, so that a ridge is smoothed along its own direction and not
// across it.
Density density_of(const Shown& x, const Shown& y) {
    constexpr int side = 56;
    constexpr std::size_t most = 1200;
    const std::size_t count = std::min(x.values.size(), most);
    Eigen::MatrixXd points(2, static_cast<Eigen::Index>(count));
    for (std::size_t index = 0; index < count; ++index) {
        const std::size_t draw = index * x.values.size() / count;
        points.col(static_cast<Eigen::Index>(index)) << x.scaled(x.values[draw]), y.scaled(y.values[draw]);
    }
    const Eigen::Vector2d mean = points.rowwise().mean();
    const Eigen::MatrixXd centred = points.colwise() - mean;
    // Scott's rule, n^(-1/6), made narrower because it is meant for normal distributions, which are not curved.
    const double narrowing = 0.7 * std::pow(static_cast<double>(count), -1.0 / 6);
    Eigen::Matrix2d kernel = narrowing * narrowing * (centred * centred.transpose()) / static_cast<double>(count);
    kernel.diagonal().array() += 1e-5;  // not narrower than the grid can show
    const Eigen::Matrix2d factor = Eigen::LLT<Eigen::Matrix2d>(kernel).matrixL();
    const Eigen::Matrix2d inverse = factor.inverse();
    const Eigen::MatrixXd whitened = inverse * points;
    Density density{{}, Eigen::MatrixXd::Zero(side, side)};
    for (int index = 0; index < side; ++index) {
        density.places.push_back(panel * (index + 0.5) / side);
    }
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const Eigen::Vector2d at = inverse * Eigen::Vector2d(density.places[static_cast<std::size_t>(column)],
                                                                 density.places[static_cast<std::size_t>(row)]);
            density.values(row, column) = (-(whitened.colwise() - at).colwise().squaredNorm().array() / 2).exp().sum();
        }
    }
    return density;
}

// The level that encloses the given share of the whole.
double level_of(const Eigen::MatrixXd& values, double share) {
    std::vector<double> sorted(values.reshaped().begin(), values.reshaped().end());
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    double sum = 0;
    for (const double value : sorted) {
        sum += value;
        if (sum >= share * values.sum()) {
            return value;
        }
    }
    return 0;
}

void add_loci(const MechanismFit& fit, const Shown& x, const Shown& y, const Point& corner, Figure& figure) {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    for (const FailureLocus& locus : fit.loci) {
        const bool same = locus.x == x.parameter->name && locus.y == y.parameter->name;
        const bool swapped = locus.x == y.parameter->name && locus.y == x.parameter->name;
        if (!same && !swapped) {
            continue;
        }
        Line line{
            .legend = "factor of safety 1, the others at the best point", .colour = Colour::vermilion, .width = 2.5};
        for (std::size_t index = 0; index < locus.points.size(); ++index) {
            const Point& point = locus.points[index];
            const Point place(x.scaled(same ? point.x() : point.y()), y.scaled(same ? point.y() : point.x()));
            const bool inside = place.minCoeff() >= 0 && place.maxCoeff() <= panel;
            const bool joined = index > 0 && locus.branch[index] == locus.branch[index - 1];
            if (!joined || !inside) {
                line.points.emplace_back(gap, gap);
            }
            if (inside) {
                line.points.push_back(corner + place);
            }
        }
        figure.series.emplace_back(std::move(line));
    }
}

void add_pair(const MechanismFit& fit, const Shown& x, const Shown& y, const Point& corner, Figure& figure) {
    constexpr std::size_t dots = 250;
    Points cloud{.colour = Colour::light_grey, .marker = Marker::filled_circle, .size = 0.35};
    for (std::size_t index = 0; index < std::min(dots, x.values.size()); ++index) {
        const std::size_t draw = index * x.values.size() / std::min(dots, x.values.size());
        cloud.points.push_back(corner + Point(x.scaled(x.values[draw]), y.scaled(y.values[draw])));
    }
    figure.series.emplace_back(std::move(cloud));
    add_loci(fit, x, y, corner, figure);
    const Density density = density_of(x, y);
    for (const auto& [share, legend, dash] :
         {std::tuple{0.95, "95 % region", Dash::dashed}, std::tuple{0.6827, "68 % region", Dash::solid}}) {
        Polyline line =
            broken_line(contour_lines(density.places, density.places, density.values, level_of(density.values, share)));
        for (Point& point : line) {
            point += corner;
        }
        figure.series.emplace_back(
            Line{.points = std::move(line), .legend = legend, .colour = Colour::blue, .dash = dash, .width = 2});
    }
    const Point best(x.scaled(fit.best[x.index]), y.scaled(fit.best[y.index]));
    if (best.minCoeff() >= 0 && best.maxCoeff() <= panel) {
        figure.series.emplace_back(
            Points{.points = {corner + best}, .legend = "best point", .marker = Marker::filled_diamond, .size = 1.4});
    }
}

// Keeps each legend once, although every panel adds it.
void drop_repeated_legends(Figure& figure) {
    std::vector<std::string> seen;
    for (Series& series : figure.series) {
        std::visit(
            [&seen](auto& content) {
                if constexpr (requires { content.legend; }) {
                    if (std::find(seen.begin(), seen.end(), content.legend) != seen.end()) {
                        content.legend.clear();
                    } else if (!content.legend.empty()) {
                        seen.push_back(content.legend);
                    }
                }
            },
            series);
    }
}

}  // namespace

std::optional<Figure> posterior_corner_figure(const MechanismFit& fit) {
    if (!fit.posterior || fit.best.empty() || fit.posterior->posterior.draws.size() < 2) {
        return std::nullopt;
    }
    const std::vector<Shown> shown = shown_parameters(fit);
    if (shown.empty()) {
        return std::nullopt;
    }
    const std::size_t rows = shown.size();
    Figure figure{.title = fit.title};
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < row; ++column) {
            add_pair(fit, shown[column], shown[row], corner_of(rows, row, column), figure);
            add_frame(corner_of(rows, row, column), figure);
        }
        const Point diagonal = corner_of(rows, row, row);
        add_marginal(shown[row], diagonal, fit.best[shown[row].index], figure);
        add_frame(diagonal, figure);
        const std::string title = title_of(shown[row]);
        // A text of several lines extends downwards from its position.
        const auto lines = static_cast<double>(1 + std::count(title.begin(), title.end(), '\n'));
        figure.labels.push_back({.at = diagonal + Point(panel / 2, panel - 0.03 + 0.085 * lines),
                                 .text = title,
                                 .align = Label::Align::centre,
                                 .boxed = false,
                                 .size = 0.75});
        add_ticks(shown[row], corner_of(rows, rows - 1, row), true, figure);
        if (row > 0) {
            add_ticks(shown[row], corner_of(rows, row, 0), false, figure);
        }
    }
    drop_repeated_legends(figure);
    figure.frame = false;
    figure.x.range = std::pair{-0.28, static_cast<double>(rows) - 0.1};
    figure.y.range = std::pair{-0.2, static_cast<double>(rows)};
    figure.width = std::max(560, 110 + 215 * static_cast<int>(rows));
    figure.height = std::max(450, 70 + 215 * static_cast<int>(rows));
    return figure;
}

}  // namespace delabole
