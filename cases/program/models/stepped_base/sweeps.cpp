#include "cases/program/models/stepped_base/sweeps.hpp"

#include "cases/program/reports/sensitivity_step.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace delabole {

namespace {

constexpr int curve_points = 81;
constexpr double most_swept_columns = 5000;
constexpr double most_work = 2e6;  // inputs times columns
constexpr double most_bisected_columns = 500;

// Nothing if the columns are impossible or have no limiting equilibrium.
std::optional<double> safety_of(const SteppedBase<>& problem) {
    const ColumnSlope<> slope = make_columns(problem.scene);
    if (slope.check != ColumnCheck::valid) {
        return std::nullopt;
    }
    const Limit limit = factor_of_safety(slope, strength_of(problem));
    return limit.state == LimitState::found ? std::optional(limit.value) : std::nullopt;
}

std::optional<double> limiting_friction_of(const SteppedBase<>& problem) {
    const ColumnSlope<> slope = make_columns(problem.scene);
    if (slope.check != ColumnCheck::valid) {
        return std::nullopt;
    }
    const Limit limit = limiting_friction_angle(slope, problem.bases.cohesion);
    return limit.state == LimitState::found ? std::optional(limit.value) : std::nullopt;
}

template <class To>
SteppedBase<> with_layout(SteppedBase<> problem) {
    std::visit(
        [&](auto& layout) {
            if constexpr (requires { layout.base_inclination; }) {
                const auto cut = layout;
                problem.scene.columns = To{cut.joint_dip, cut.spacing, cut.base_inclination, cut.base_end_height};
            }
        },
        problem.scene.columns);
    return problem;
}

// Both sides of a jump between two points of a curve, or nothing if the curve is continuous there. Bisection follows
// the half with the greater difference, which on a continuous curve becomes small within a few steps.
template <class Function>
std::optional<std::pair<Point, Point>> jump_between(const Function& function, Point left, Point right) {
    const double whole = std::abs(right.y() - left.y());
    if (!(whole > 1e-4 * std::abs(left.y()))) {
        return std::nullopt;
    }
    constexpr int halvings = 20;
    for (int step = 0; step < halvings; ++step) {
        const double x = (left.x() + right.x()) / 2;
        const std::optional<double> y = function(x);
        if (!y) {
            return std::nullopt;
        }
        (std::abs(*y - left.y()) > std::abs(right.y() - *y) ? right : left) = Point(x, *y);
        if (std::abs(right.y() - left.y()) < 0.1 * whole) {
            return std::nullopt;
        }
    }
    return std::pair(left, right);
}

// An answer against one input, interrupted where there is no answer and where it jumps.
template <class Answer>
Line curve(SteppedBase<> problem, const std::string& input, Dimension x, const Interval& range, const Answer& answer) {
    Line line;
    double* value = find_input(problem, input);
    if (value == nullptr) {
        return line;
    }
    const auto at = [&](double varied) {
        stop_if_interrupted();
        *value = varied;
        return answer(problem);
    };
    const bool few = static_cast<double>(make_columns(problem.scene).columns.size()) <= most_bisected_columns;
    const auto add = [&](const Point& point) { line.points.emplace_back(in_display_unit(point.x(), x), point.y()); };
    bool any = false;
    Point last(0, std::nan(""));
    for (int index = 0; index < curve_points; ++index) {
        const double varied = range.lower + (range.upper - range.lower) * index / (curve_points - 1);
        const Point here(varied, at(varied).value_or(std::nan("")));
        any = any || std::isfinite(here.y());
        if (few && std::isfinite(last.y()) && std::isfinite(here.y())) {
            if (const auto jump = jump_between(at, last, here)) {
                add(jump->first);
                add(Point(jump->first.x(), std::nan("")));
                add(jump->second);
            }
        }
        add(here);
        last = here;
    }
    if (!any) {
        line.points.clear();
    }
    return line;
}

void mark_given(Figure& figure, double x, double y) {
    figure.series.emplace_back(
        Points{.points = {Point(x, y)}, .legend = "as given", .marker = Marker::circle, .size = 1.8});
}

struct Varied {
    std::string input;
    Dimension dimension;
    Interval range;
    std::string file;
    std::string title;
};

std::vector<Varied> varied_inputs(const SteppedBase<>& problem) {
    if (const auto* blocks = std::get_if<BlockColumns<>>(&problem.scene.columns)) {
        const double dip = blocks->joint_dip;
        return {{"columns.joint_dip", Dimension::angle,
                 within(std::max(degrees(1), dip - degrees(20)), std::min(degrees(90), dip + degrees(20))),
                 "safety_joint_dip", "Factor of safety against the dip of the joints"}};
    }
    std::vector<Varied> varied;
    std::visit(
        [&](const auto& layout) {
            if constexpr (requires { layout.base_inclination; }) {
                const SlopeSection<>& slope = problem.scene.slope.value();
                varied = {{"columns.base_inclination", Dimension::angle,
                           within(std::max(degrees(90) - layout.joint_dip, degrees(1)), slope.face_dip - degrees(0.5)),
                           "safety_base_inclination", "Factor of safety against the inclination of the base"},
                          {"columns.spacing", Dimension::length, within(0.3 * layout.spacing, 3 * layout.spacing),
                           "safety_spacing", "Factor of safety against the spacing of the joints"},
                          {"slope.height", Dimension::length, within(0.5 * slope.height, 1.5 * slope.height),
                           "safety_height", "Factor of safety against the height of the slope"}};
            }
        },
        problem.scene.columns);
    return varied;
}

// Removes values far above that of the case, beside which all others would look flat.
void cut_off(Line& line, double ceiling) {
    for (Point& point : line.points) {
        point.y() = point.y() <= ceiling ? point.y() : std::nan("");
    }
}

std::optional<GeometrySweep> safety_sweep(const SteppedBase<>& problem, const Varied& varied, double given) {
    GeometrySweep sweep{varied.file,
                        "Columns cut by the ground change with nothing but geometry; flat-topped columns after Goodman "
                        "& Bray jump wherever their number or the place of the crest changes. A curve is broken where "
                        "it jumps, and has a gap where there is no limiting equilibrium.",
                        {}};
    sweep.figure.title = varied.title;
    sweep.figure.x = axis_of(varied.input, varied.dimension);
    sweep.figure.y.title = "factor of safety";
    SteppedBase<> original = problem;
    const double x = in_display_unit(*find_input(original, varied.input), varied.dimension);
    const auto add = [&](const SteppedBase<>& scene, const std::string& legend, Colour colour, Dash dash) {
        Line line = curve(scene, varied.input, varied.dimension, varied.range, safety_of);
        cut_off(line, 3 * given);
        if (!line.points.empty()) {
            line.legend = legend;
            line.colour = colour;
            line.dash = dash;
            line.width = 4;
            sweep.figure.series.emplace_back(line);
        }
    };
    if (!problem.scene.bolt.empty() || !problem.scene.point_load.empty()) {
        sweep.caption +=
            " Bolts and point loads keep the number of their column, so that here columns cut by the ground jump too, "
            "where one is added or lost; there are gaps where they would lie above its top.";
    }
    if (std::holds_alternative<BlockColumns<>>(problem.scene.columns)) {
        sweep.caption = "The blocks turn with their joints; their sizes are kept.";
        add(problem, "", Colour::blue, Dash::solid);
    } else {
        add(with_layout<ContinuousColumns<>>(problem), "cut by the ground", Colour::blue, Dash::solid);
        add(with_layout<ClassicalColumns<>>(problem), "flat-topped", Colour::vermilion, Dash::dashed);
    }
    if (sweep.figure.series.empty()) {
        return std::nullopt;
    }
    mark_given(sweep.figure, x, given);
    return sweep;
}

// The limiting friction angle against one input, with one curve for each dip of the joints.
std::optional<GeometrySweep> friction_sweep(const SteppedBase<>& problem, const std::vector<Varied>& varied) {
    const Varied& along = varied.front();
    GeometrySweep sweep{
        "limiting_friction", "One friction angle on joints and bases at which the slope just fails.", {}};
    sweep.figure.title = "Limiting friction angle against geometry";
    sweep.figure.x = axis_of(along.input, along.dimension);
    sweep.figure.y = axis_of("limiting_friction_angle", Dimension::angle);
    const auto answer = [](const SteppedBase<>& scene) -> std::optional<double> {
        const std::optional<double> angle = limiting_friction_of(scene);
        return angle ? std::optional(*angle / degrees(1)) : std::nullopt;
    };
    constexpr std::array colours{Colour::sky, Colour::green, Colour::black, Colour::orange, Colour::vermilion};
    const bool blocks = std::holds_alternative<BlockColumns<>>(problem.scene.columns);
    for (std::size_t index = 0; index < colours.size(); ++index) {
        SteppedBase<> scene = problem;
        double& dip = *find_input(scene, "columns.joint_dip");
        const double change = degrees(5) * (static_cast<double>(index) - 2);
        if ((blocks && change != 0) || dip + change > degrees(90)) {
            continue;
        }
        dip += change;
        Line line = curve(scene, along.input, along.dimension, along.range, answer);
        if (!line.points.empty()) {
            line.legend = blocks ? "" : "joints dip " + value_in_words(dip, Dimension::angle);
            line.colour = colours[index];
            line.width = change == 0 ? 4 : 2.5;
            sweep.figure.series.emplace_back(line);
        }
    }
    const std::optional<double> given = limiting_friction_of(problem);
    if (sweep.figure.series.empty() || !given) {
        return std::nullopt;
    }
    SteppedBase<> original = problem;
    mark_given(sweep.figure, in_display_unit(*find_input(original, along.input), along.dimension), *given / degrees(1));
    return sweep;
}

}  // namespace

double* find_input(SteppedBase<>& problem, const std::string& name) {
    double* found = nullptr;
    for_each_named_number(problem, [&](const std::string& path, const FieldInfo&, double& value) {
        found = path == name ? &value : found;
    });
    return found;
}

bool can_sweep(const SteppedBase<>& problem, const ColumnSlope<>& slope) {
    double inputs = 0;
    for_each_number(problem, [&](double, const FieldInfo&) { ++inputs; });
    const auto columns = static_cast<double>(slope.columns.size());
    return columns <= most_swept_columns && inputs * columns <= most_work;
}

std::vector<GeometrySweep> geometry_sweeps(const SteppedBase<>& problem, double factor_of_safety) {
    const std::vector<Varied> varied = varied_inputs(problem);
    std::vector<GeometrySweep> sweeps;
    for (const Varied& input : varied) {
        if (auto sweep = safety_sweep(problem, input, factor_of_safety)) {
            sweeps.push_back(std::move(*sweep));
        }
    }
    if (auto sweep = friction_sweep(problem, varied)) {
        sweeps.push_back(std::move(*sweep));
    }
    return sweeps;
}

std::vector<SensitivityBar> sensitivity_bars(const SteppedBase<>& problem, double factor_of_safety,
                                             const InputDeviations& known) {
    double height = 0;
    if (problem.scene.slope) {
        height = problem.scene.slope->height;
    } else {
        for (const Column<>& column : make_columns(problem.scene).columns) {
            height = std::max(height, column.height);
        }
    }
    return recalculated_bars(problem, factor_of_safety, height, problem.scene.rock.unit_weight * height, known,
                             [](const SteppedBase<>& varied, bool in_range) {
                                 return (in_range ? safety_of(varied) : std::nullopt).value_or(std::nan(""));
                             });
}

}  // namespace delabole
