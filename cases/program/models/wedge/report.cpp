// Wedge failure: answers, warnings and figures for reports.
#include "cases/program/reports/sensitivity_step.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/figures.hpp"
#include "plots/figures/stereonet.hpp"
#include "plots/figures/wedge_figure.hpp"
#include "wedge_failure/wedge_failure.hpp"

#include <cmath>

namespace delabole {

namespace {

void warn(Analysis& analysis, const WedgeFailureResult& result) {
    if (result.contact == SlidingContact::none) {
        analysis.warnings.emplace_back("water and loads lift the wedge off both planes: nothing resists");
    } else if (std::isinf(result.factor_of_safety)) {
        analysis.warnings.emplace_back("nothing drives the wedge down: the factor of safety is infinite");
    } else if (result.sliding_plunge < 0) {
        analysis.warnings.emplace_back("the loads push the wedge upwards");
    }
    if (result.normal_force_1 < 0 || result.normal_force_2 < 0) {
        analysis.warnings.emplace_back("passive bolts pull the wedge off a plane: its normal force is negative");
    }
}

// NaN if there is no wedge.
double factor_of(const WedgeFailure& problem) {
    const WedgeFailureResult result = analyse(problem);
    return result.check == WedgeFailureCheck::valid ? result.factor_of_safety : std::nan("");
}

WedgeDrawing wedge_drawing(const WedgeFailure& problem, const std::string& title) {
    const WedgeEquilibrium forces = evaluate(problem);
    const WedgeGeometry& wedge = forces.wedge;
    const WedgeSlope& slope = problem.slope;
    return {.title = title,
            .face_dip_direction = slope.face_dip_direction,
            .face_normal = upward_normal({slope.face_dip, slope.face_dip_direction}),
            .upper_normal = upward_normal({slope.upper_surface_dip, slope.upper_surface_dip_direction}),
            .crest_1 = wedge.crest_1,
            .crest_2 = wedge.crest_2,
            .crack_1 = wedge.crack_1,
            .crack_2 = wedge.crack_2,
            .line_end = wedge.line_end,
            .cracked = problem.tension_crack.has_value(),
            .sliding = forces.stability.sliding};
}

WedgeNet wedge_net(const WedgeFailure& problem, const WedgeFailureResult& result) {
    const WedgeSlope& slope = problem.slope;
    WedgeNet net{.title = "Stereonet",
                 .face = {slope.face_dip, slope.face_dip_direction},
                 .upper_surface = {slope.upper_surface_dip, slope.upper_surface_dip_direction},
                 .planes = {{"plane_1", {problem.plane_1.dip, problem.plane_1.dip_direction}},
                            {"plane_2", {problem.plane_2.dip, problem.plane_2.dip_direction}}},
                 .line = {result.line_plunge, result.line_trend}};
    if (problem.tension_crack) {
        net.planes.push_back({"tension_crack", {problem.tension_crack->dip, problem.tension_crack->dip_direction}});
    }
    if (result.contact != SlidingContact::none) {
        net.sliding = {result.sliding_plunge, result.sliding_trend};
    }
    return net;
}

// Factor of safety against the filled ratio of the fissures; nothing if the water is given in another form.
std::optional<WaterDepthCurves> filled_ratio_curve(const WedgeFailure& problem) {
    WedgeFailure varied = problem;
    auto* fissures = std::get_if<FilledFissures>(&varied.water);
    if (fissures == nullptr) {
        return std::nullopt;
    }
    WaterDepthCurves curves{.title = "Factor of safety against water in the fissures",
                            .ratio = "filled ratio of the fissures",
                            .curves = {{"as given", {}}}};
    constexpr int points = 101;
    for (int index = 0; index < points; ++index) {
        fissures->filled_ratio = static_cast<double>(index) / (points - 1);
        const double factor = factor_of(varied);
        if (std::isfinite(factor)) {
            curves.curves.front().points.emplace_back(fissures->filled_ratio, factor);
        }
    }
    return curves;
}

void append_drawings(const WedgeFailure& problem, const WedgeFailureResult& result, const std::string& prefix,
                     const InputDeviations& known, const Sheet& sheet) {
    sheet.draw(
        wedge_figure(wedge_drawing(problem, "The wedge in the slope")), prefix + "wedge",
        "The wedge, to scale, seen from above and from in front of the face; 1 and 2 mark the traces of the planes.");
    if (result.contact != SlidingContact::none) {
        sheet.draw(slid_wedge_figure(wedge_drawing(problem, "The wedge slid out")), prefix + "slid_wedge",
                   "The same wedge moved along its direction of sliding, and the surfaces that it leaves.");
    }
    sheet.draw(wedge_net_figure(wedge_net(problem, result)), prefix + "stereonet",
               "The planes as great circles, and the line along which they meet.");
    if (const auto curve = filled_ratio_curve(problem)) {
        sheet.add(Heading{"Water"});
        sheet.draw(factor_of_safety_against_water(*curve), prefix + "water",
                   "Factor of safety against the greatest water pressure over that of fissures filled to the ground.");
    }
    const double height = problem.slope.height;
    sheet.draw(
        tornado_figure("Change of the factor of safety",
                       recalculated_bars(problem, factor_of(problem), height, problem.rock.unit_weight * height, known,
                                         [](const WedgeFailure& varied, bool) { return factor_of(varied); })),
        prefix + "sensitivity",
        "Each input changed by itself, by the step that stands beside it." + deviations_in_words(known));
}

}  // namespace

WedgeFailureAnswer analyse_case(const WedgeFailureStudy& study, const AnalysisWork&) {
    WedgeFailureAnswer answer{analyse(study.model)};
    if (answer.result.check == WedgeFailureCheck::valid) {
        answer.required = required_values(study.model, study.required);
    }
    return answer;
}

Analysis named_outputs(const WedgeFailureStudy& study, const WedgeFailureAnswer& answer) {
    Analysis analysis;
    append_outputs(analysis, answer.result);
    if (answer.result.contact == SlidingContact::none) {
        mark_none(analysis, "sliding_");
    }
    if (!study.model.tension_crack) {
        mark_none(analysis, "crack_");
    }
    append_required_values(analysis, study.required, answer.required);
    warn(analysis, answer.result);
    return analysis;
}

HeadCard head_card(const WedgeFailureStudy& study, const WedgeFailureAnswer& answer) {
    const WedgeFailureResult& result = answer.result;
    const bool stands = result.factor_of_safety >= 1;
    HeadCard head{stands ? AnswerTone::good : AnswerTone::bad, {}, {}};
    if (result.contact == SlidingContact::none) {
        head.sentences.emplace_back("Water and loads lift the wedge off both planes: nothing resists.");
    } else if (std::isinf(result.factor_of_safety)) {
        head.sentences.emplace_back("Nothing drives the wedge down: the factor of safety is infinite.");
    } else {
        head.sentences.push_back(factor_in_words(result.factor_of_safety) + (stands ? ": stands" : ": slides") +
                                 " on " + human_name(word_of(result.contact)) + ".");
    }
    if (!study.required.empty()) {
        head.sentences.push_back(required_in_words(study.required.front(), answer.required.front()));
    }
    head.sentences.push_back(value_in_words(result.weight, Dimension::force) + " of rock on a line that plunges " +
                             value_in_words(result.line_plunge, Dimension::angle) + " towards " +
                             value_in_words(result.line_trend, Dimension::angle) + ".");
    return head;
}

void append_case_figures(const WedgeFailureStudy& study, const WedgeFailureAnswer& answer, const Sheet& sheet,
                         const InputDeviations& known) {
    append_drawings(study.model, answer.result, "", known, sheet);
}

void append_mechanism_figures(const WedgeFailureStudy& at_best, const MechanismFit& fit, const FitProblem&,
                              const Sheet& sheet) {
    const WedgeFailureResult result = analyse(at_best.model);
    if (result.check == WedgeFailureCheck::valid) {
        append_drawings(at_best.model, result, fit.name + "_", deviations_of(fit.parameters), sheet);
    }
}

}  // namespace delabole
