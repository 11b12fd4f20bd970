// Stepped surfaces along joint sets: answers, warnings and figures for reports.
#include "cases/program/models/stepped_base/drawing.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/stepped_path/stepped_path.hpp"
#include "plots/figures/block_figures.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace delabole {

namespace {

Figure section_figure(const SteppedPath& path, const SteppedPathResult& result) {
    BlockDrawing drawing{.title = "The surface that fails first, factor of safety " +
                                  number_in_words(result.factor_of_safety)};
    std::size_t number = 0;
    for (const SteppedPathResult::Part& part : result.parts) {
        const bool column = path.search.mechanism != SteppedPathMechanism::sliding && !part.wedge;
        drawing.blocks.push_back({part.outline,
                                  column       ? std::to_string(++number)
                                  : part.wedge ? "wedge"
                                               : "",
                                  part.wedge ? DrawnMode::plain : drawn(part.mode)});
    }
    const double end = 1.1 * (result.surface.back().x() + path.slope.height / 20);
    drawing.base = profile_after_failure(path, result);
    drawing.base.insert(drawing.base.begin(), Point(-path.slope.height / 4, 0));
    drawing.base.back() =
        result.surface.back() + (end - result.surface.back().x()) * Point(1, std::tan(path.slope.upper_surface_dip));
    const Point crest(path.slope.height / std::tan(path.slope.face_dip), path.slope.height);
    drawing.ground = {drawing.base.front(), Point(0, 0), crest, drawing.base.back()};
    for (const Point& point : water_surface(path)) {
        if (point.x() < end) {
            drawing.water.push_back(point);
        }
    }
    drawing.toe_elevation = path.slope.toe_elevation.value_or(0.0);
    Figure figure = block_figure(drawing);
    if (path.massive_rock) {
        // Only the part of the boundary that lies in the rock is drawn.
        const double slope = std::tan(path.massive_rock->boundary_dip);
        const double height = path.massive_rock->boundary_height;
        const Point at_face(height / std::tan(path.slope.face_dip), height);
        const auto at = [&](double y) {
            return Point(at_face.x() + (y - at_face.y()) / slope, y + drawing.toe_elevation);
        };
        const double low = std::max(0.0, height);
        const double high = std::min(path.slope.height, at_face.y() + (end - at_face.x()) * slope);
        if (slope > 0 && low < high) {
            figure.series.emplace_back(Line{.points = {at(low), at(high)},
                                            .legend = "boundary of massive rock",
                                            .colour = Colour::grey,
                                            .dash = Dash::dashed});
        }
    }
    return figure;
}

bool slides_on_riser(const SteppedPathResult& result) {
    return result.factor_on_riser < result.factor_of_safety;
}

// Dry columns that slide without cohesion have one factor of safety, at the toe and behind it, but for rounding.
bool toe_fails_before(const SteppedPathResult& result) {
    constexpr double weaker = 1 - 1e-9;
    return result.factor_of_toe < weaker * result.factor_of_safety;
}

}  // namespace

Analysis named_outputs(const SteppedPath&, const SteppedPathResult& result) {
    Analysis analysis;
    append_outputs(analysis, result);
    if (slides_on_riser(result)) {
        analysis.warnings.push_back(
            "rock on a single riser, which comes out in the face, slides at a factor of safety of " +
            number_in_words(result.factor_on_riser) +
            ", before the surface that is searched for moves: the model plane_failure draws it, with the dip of the "
            "risers");
    }
    if (toe_fails_before(result)) {
        analysis.warnings.push_back("columns at the toe move by themselves at a factor of safety of " +
                                    number_in_words(result.factor_of_toe) +
                                    ", before the surface that is searched for moves: they come out in front of where "
                                    "a surface counts, so that no figure shows them");
    }
    if (result.surface.empty()) {
        for (NamedOutput& output : analysis.outputs) {
            if (output.name != "limit" && output.name != "factor_of_safety" && output.name != "factor_on_riser" &&
                output.name != "factor_of_toe" && output.name != "searches") {
                output.value = "none";
            }
        }
        analysis.warnings.emplace_back(
            result.limit == LimitState::holds_at_any_strength
                ? "no surface along steps and risers moves, even without strength: the factor of safety is "
                  "infinite"
                : "a surface moves whatever the strength");
        return analysis;
    }
    if (result.limit == LimitState::abrupt) {
        analysis.warnings.emplace_back(
            "no limiting equilibrium: the mass as a whole stands down to the factor of safety, at which its upper part "
            "begins to push; its toe alone has failed before");
    }
    if (result.extent == PathExtent::least) {
        analysis.warnings.emplace_back(
            "the surface is the smallest that counts: search.least_width decides where it runs");
    } else if (result.extent == PathExtent::greatest) {
        analysis.warnings.emplace_back(
            "the surface is the largest that is searched: a larger search.greatest_retreat may lower the factor of "
            "safety");
    }
    return analysis;
}

HeadCard head_card(const SteppedPath&, const SteppedPathResult& result) {
    // These mechanisms move before the surface that is searched for, and without it.
    struct Other {
        double factor;
        std::string where;
    };
    std::vector<Other> others;
    if (slides_on_riser(result)) {
        others.push_back({result.factor_on_riser, ", on a single riser"});
    }
    if (toe_fails_before(result)) {
        others.push_back({result.factor_of_toe, ", columns at the toe alone"});
    }
    std::ranges::sort(others, {}, &Other::factor);
    const bool stands = (others.empty() ? result.factor_of_safety : others.front().factor) >= 1;
    // A sliver at the toe of a mass that fails abruptly may have failed at a factor that is not known.
    const bool open = stands && result.limit == LimitState::abrupt;
    HeadCard head{open ? AnswerTone::open : stands ? AnswerTone::good : AnswerTone::bad, {}, {}};
    const std::string verdict = open ? "." : stands ? ": stands." : ": fails.";
    for (const Other& other : others) {
        const bool first = head.sentences.empty();
        head.sentences.push_back(factor_in_words(other.factor) + other.where + (first ? verdict : "."));
    }
    if (result.surface.empty()) {
        head.sentences.emplace_back(result.limit == LimitState::holds_at_any_strength
                                        ? "No surface along steps and risers moves, even without strength."
                                        : "A surface along the joints moves whatever the strength.");
        return head;
    }
    const std::string factor = factor_in_words(result.factor_of_safety);
    head.sentences.push_back(open             ? factor + " for the mass as a whole; its toe alone fails before."
                             : others.empty() ? factor + verdict
                                              : "Along the surface that is searched for: " + factor + ".");
    head.sentences.push_back(value_in_words(result.failed_area, Dimension::area) +
                             " move, along a surface that comes out " +
                             value_in_words(result.retreat, Dimension::length) + " behind the crest.");
    if (result.column_count == 1) {
        head.sentences.emplace_back(result.toppling_count == 1 ? "1 column topples." : "1 column slides.");
    } else if (result.column_count > 1) {
        head.sentences.push_back(number_in_words(result.column_count) + " columns move, " +
                                 number_in_words(result.toppling_count) + " of them topple.");
    }
    return head;
}

void append_case_figures(const SteppedPath& path, const SteppedPathResult& result, const Sheet& sheet) {
    if (!result.surface.empty()) {
        sheet.draw(section_figure(path, result), "section",
                   "What moves at the factor of safety, along joints, and what stays.");
    }
}

void append_mechanism_figures(const SteppedPath& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const Sheet& sheet) {
    const SteppedPathResult result = analyse(at_best);
    if (result.check != SteppedPathCheck::valid || result.surface.empty()) {
        return;
    }
    Figure figure = section_figure(at_best, result);
    add_profiles(figure, problem.profile ? problem.profile->profile : Polyline{},
                 profile_after_failure(at_best, result), at_best.slope.toe_elevation.value_or(0.0));
    sheet.draw(figure, fit.name + "_section",
               "What moves at the best point, and the ground observed after the failure.");
    const std::vector<std::string> warnings = named_outputs(at_best, result).warnings;
    if (!warnings.empty()) {
        sheet.add(Notice{NoticeKind::warning, "The surface at the best point", warnings});
    }
}

}  // namespace delabole
