// Plane failure: answers, warnings and figures for reports.
#include "cases/program/models/plane_failure/figures.hpp"
#include "cases/program/reports/sensitivity_step.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

// A bolt without force has no optimum plunge.
void append_optimum_bolt(Analysis& analysis, const OptimumBolt& optimum, double force) {
    analysis.outputs.push_back({"optimum_bolt_plunge", "plunge of bolt[1] that makes the factor of safety largest",
                                Dimension::angle, optimum.plunge});
    analysis.outputs.push_back({"optimum_bolt_factor_of_safety", "factor of safety at that plunge", Dimension::ratio,
                                optimum.factor_of_safety});
    if (!(optimum.factor_of_safety > 0) || force == 0) {
        mark_none(analysis, "optimum_bolt");
    }
}

void warn(Analysis& analysis, const PlaneFailureResult& result, bool critical_at_boundary) {
    if (critical_at_boundary) {
        analysis.warnings.emplace_back(
            "the least factor of safety lies at the edge of the searched range: a limit, not a balance");
    }
    if (result.overturning_factor < 1 && result.factor_of_safety >= 1) {
        analysis.warnings.emplace_back("the mass overturns about the toe before it slides");
    }
    if (result.outcome == PlaneFailureOutcome::lifts_off) {
        analysis.warnings.emplace_back(
            "the loads lift the mass off its base, which bears no such tension: the factor of safety is 0");
    } else if (result.normal_force < 0) {
        analysis.warnings.emplace_back(
            "the mass stays on its base only by the tensile strength given in [tension_cutoff]: the normal force is "
            "negative");
    } else if (result.normal_force_position < 0 || result.normal_force_position > 1) {
        analysis.warnings.emplace_back(
            "no pressure on the base balances the moments: the normal force would act beyond its " +
            std::string(result.normal_force_position < 0 ? "lower" : "upper") +
            " end. The mass must rotate, or lean on the crack, which a balance of forces does not see");
    } else if (result.normal_force_position < 1.0 / 3 || result.normal_force_position > 2.0 / 3) {
        analysis.warnings.emplace_back(
            "the normal force acts outside the middle third of the base: part of the base is in tension");
    }
    if (std::isinf(result.factor_of_safety)) {
        analysis.warnings.emplace_back("nothing drives the mass down the plane: the factor of safety is infinite");
    }
}

Table sensitivity_table(const SensitivityResult& sensitivities, CsvTable& csv) {
    Table table{"Exact derivatives of the factor of safety", {"input", "value"_number, "change of FS"_number, "per"}};
    const auto in_unit = [](const Sensitivity& input) {
        return std::abs(input.derivative) * display_unit(input.dimension).si_per_unit;
    };
    const double greatest = sensitivities.derivatives.empty()
                                ? 0
                                : in_unit(*std::ranges::max_element(sensitivities.derivatives, {}, in_unit));
    constexpr double rounding = 1e-12;  // of the greatest derivative
    for (const Sensitivity& input : sensitivities.derivatives) {
        if (input.parameter.ends_with(".rows")) {
            continue;  // a whole number, with no derivative
        }
        const DisplayUnit unit = display_unit(input.dimension);
        const double derivative = in_unit(input) < rounding * greatest ? 0 : input.derivative;
        const DisplayUnit shown = shown_unit(input.dimension);
        table.rows.push_back({input.parameter, in_table_digits(input.value, input.dimension),
                              in_table_digits(derivative * shown.si_per_unit, Dimension::ratio),
                              shown.symbol.empty() ? "1" : std::string(shown.symbol)});
        csv.add_row({input.parameter, in_display_unit(input.value, input.dimension), std::string(unit.symbol),
                     derivative * unit.si_per_unit});
    }
    return table;
}

// "FS 1.3 takes 4376 kN/m in a bolt at 15 deg.": the force of a bolt is stated with its plunge.
std::string required_in_words(const PlaneFailure<>& problem, const RequiredValue<>& request, const Required& required) {
    const bool found = required.status == RequiredStatus::found || required.status == RequiredStatus::several;
    for (std::size_t index = 0; index < problem.bolt.size(); ++index) {
        if (found && request.parameter == "bolt[" + std::to_string(index + 1) + "].force") {
            return factor_in_words(request.factor_of_safety) + " takes " +
                   value_in_words(required.value, required.dimension) + " in " +
                   (request.also.empty() ? "bolt " + std::to_string(index + 1)
                                         : "each of " + std::to_string(1 + request.also.size()) + " bolts") +
                   " at " + value_in_words(problem.bolt[index].plunge, Dimension::angle) + ".";
        }
    }
    return required_in_words(request, required);
}

// "The crack was searched for: it opens 13.4 m behind the crest." What was given in its place does not count.
std::string searched_in_words(const CriticalSearch<>& search, const PlaneFailureResult& result) {
    const double behind = result.crack_distance_behind_crest;
    const std::string crack = "opens " + value_in_words(std::abs(behind), Dimension::length) +
                              (behind < 0 ? " in front of the crest" : " behind the crest");
    const std::string plane = "dips at " + value_in_words(result.plane_dip, Dimension::angle);
    const std::string where = search.under == SearchCondition::dry_slope ? " in the dry slope" : "";
    switch (search.find) {
    case CriticalFeature::tension_crack:
        return "The crack was searched for" + where + ": it " + crack + ".";
    case CriticalFeature::failure_plane:
        return "The plane was searched for" + where + ": it " + plane + ".";
    case CriticalFeature::both:
        break;
    }
    return "The plane and the crack were searched for" + where + ": the plane " + plane + ", the crack " + crack + ".";
}

std::string outcome_in_words(PlaneFailureOutcome outcome) {
    return words_for(outcome, {"stands", "fails by sliding", "overturns before it slides",
                               "fails by sliding and overturning", "the loads lift the mass off its base"});
}

// Friction angle and cohesion within two standard deviations of their priors; the friction angle is that of the mean
// plane.
LaboratoryRange prior_range(const MechanismFit& fit, const PlaneFailure<>& slope) {
    LaboratoryRange range;
    range.legend = "priors, 2 standard deviations";
    const auto* stepped = std::get_if<SteppedSurface<>>(&slope.strength);
    for (const FreeParameter& parameter : fit.parameters) {
        if (!parameter.prior) {
            continue;
        }
        const double spread = 2 * parameter.prior->standard_deviation;
        if (parameter.name == "strength.friction_angle") {
            const double mean = parameter.prior->mean + (stepped != nullptr ? stepped->roughness_angle : 0.0);
            range.friction_angle = within(mean - spread, std::min(mean + spread, degrees(89.9)));
        } else if (parameter.name == "strength.cohesion") {
            range.cohesion = within(std::max(0.0, parameter.prior->mean - spread), parameter.prior->mean + spread);
        }
    }
    return range;
}

}  // namespace

PlaneFailureAnswer analyse_case(const PlaneFailureStudy<>& study, const AnalysisWork&) {
    PlaneFailureAnswer answer{resolve(study)};
    const PlaneFailure<>& problem = answer.resolved.problem;
    if (answer.resolved.check != PlaneFailureCheck::valid) {
        answer.result.check = answer.resolved.check;
        return answer;
    }
    answer.result = analyse(problem);
    if (answer.result.check != PlaneFailureCheck::valid) {
        return answer;
    }
    answer.required = required_values(study, study.required);
    if (!problem.bolt.empty()) {
        answer.optimum_bolt = optimum_bolt_plunge(problem);
    }
    return answer;
}

Analysis named_outputs(const PlaneFailureStudy<>& study, const PlaneFailureAnswer& answer) {
    Analysis analysis;
    append_outputs(analysis, answer.result);
    append_required_values(analysis, study.required, answer.required);
    append_support(analysis, support_rows(answer.resolved.problem));
    if (answer.optimum_bolt) {
        append_optimum_bolt(analysis, *answer.optimum_bolt, answer.resolved.problem.bolt.front().force);
    }
    for (const std::size_t bolt : bolts_that_hold_nothing(answer.resolved.problem)) {
        analysis.warnings.push_back(indexed("bolt", bolt) +
                                    " holds nothing: it does not run from the moving mass into the rock behind it");
    }
    warn(analysis, answer.result, answer.resolved.critical_at_boundary);
    return analysis;
}

HeadCard head_card(const PlaneFailureStudy<>& study, const PlaneFailureAnswer& answer) {
    const PlaneFailureResult& result = answer.result;
    const bool stands = result.outcome == PlaneFailureOutcome::stable;
    HeadCard head{stands ? AnswerTone::good : AnswerTone::bad, {}, {}};
    head.sentences.push_back(std::isinf(result.factor_of_safety)
                                 ? "Nothing drives the mass down the plane: the factor of safety is infinite."
                                 : factor_in_words(result.factor_of_safety) + ": " + outcome_in_words(result.outcome) +
                                       ".");
    std::string required;
    for (std::size_t index = 0; index < study.required.size(); ++index) {
        required += (index == 0 ? "" : " ") +
                    required_in_words(answer.resolved.problem, study.required[index], answer.required[index]);
    }
    if (!required.empty()) {
        head.sentences.push_back(std::move(required));
    }
    const double water = result.base_water_force + result.crack_water_force;
    const double seismic = study.model.seismic ? study.model.seismic->horizontal_coefficient : 0;
    head.sentences.push_back(
        value_in_words(result.section_area, Dimension::area) + " of rock, " +
        value_in_words(result.weight, Dimension::force_per_length) + ", on a plane at " +
        value_in_words(result.plane_dip, Dimension::angle) + ": " +
        value_in_words(result.driving_force, Dimension::force_per_length) + " drive, " +
        value_in_words(result.resisting_force, Dimension::force_per_length) + " resist" +
        (water > 0 ? "; water takes part with " + value_in_words(result.base_water_force, Dimension::force_per_length) +
                         " on the base and " + value_in_words(result.crack_water_force, Dimension::force_per_length) +
                         " in the crack"
                   : "; the slope is dry") +
        (seismic == 0 ? "."
                      : "; the earthquake pushes " + std::string(seismic > 0 ? "outwards" : "inwards") + " with " +
                            value_in_words(std::abs(seismic) * result.weight, Dimension::force_per_length) + "."));
    if (study.critical) {
        head.sentences.push_back(searched_in_words(*study.critical, result));
    }
    return head;
}

void append_case_figures(const PlaneFailureStudy<>& study, const PlaneFailureAnswer& answer, const Sheet& sheet,
                         const InputDeviations& known) {
    const PlaneFailure<>& problem = answer.resolved.problem;
    SectionDrawing section = section_drawing(problem, "");
    std::vector<std::string> drawn{"Slope", "failure plane"};
    if (!section.tension_crack.empty()) {
        drawn.emplace_back("crack");
    }
    if (!section.water_pressure.empty()) {
        drawn.emplace_back("water");
    }
    section.title = list_in_words(drawn);
    annotate(problem, answer.result, section);
    sheet.draw(section_figure(section), "section",
               std::string("The slope and what slides. Lengths of arrows") +
                   (section.water_pressure.empty() ? "" : " and water pressures") + " are not to scale.");
    if (const auto critical = critical_plane_drawing(study, answer.resolved)) {
        sheet.draw(critical_figure(*critical), "critical_plane",
                   "Least factor of safety for each dip of the failure plane.");
    }
    sheet.add(Heading{"Water and strength"});
    if (const auto curves = water_depth_curves(problem)) {
        sheet.draw(factor_of_safety_against_water(*curves), "water",
                   "Factor of safety against the filled ratio of the water level.");
    }
    sheet.draw(failure_locus_figure(failure_loci(problem)), "failure_loci",
               "Pairs of friction angle and cohesion at which the slope just fails.");
    const SensitivityResult derivatives = sensitivities(problem);
    CsvTable csv({"input", "value", "unit", "derivative_per_unit"});
    sheet.add(Heading{"Sensitivity"});
    sheet.draw(
        tornado_figure("Change of the factor of safety", sensitivity_bars(problem, derivatives, known)), "sensitivity",
        "Each input changed by itself, by the step that stands beside it; to first order, from exact derivatives. The "
        "eight greatest." +
            deviations_in_words(known));
    sheet.add(sensitivity_table(derivatives, csv));
    sheet.write("sensitivities.csv", csv.text());
}

// Section, loci and sensitivities at the best point.
void append_mechanism_figures(const PlaneFailureStudy<>& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const Sheet& sheet) {
    const PlaneFailureStudy<> best{resolve(at_best).problem, std::nullopt, {}};
    const PlaneFailure<>& slope = best.model;
    const PlaneFailureAnswer answer = analyse_case(best);
    const std::vector<std::string> warnings =
        failure_in(answer).empty() ? named_outputs(best, answer).warnings : std::vector<std::string>{};
    if (!warnings.empty()) {
        sheet.add(Notice{NoticeKind::warning, "The mass at the best point", warnings});
    }
    SectionDrawing section =
        section_drawing(slope, problem.profile ? "Observed and predicted profile" : "The slope at the best point");
    section.predicted_profile = profile_after_failure(slope);
    if (problem.profile) {
        section.observed_profile = problem.profile->profile;
    }
    sheet.draw(section_figure(section), fit.name + "_section",
               std::string("Section before the failure and the profile left standing, ") +
                   (problem.profile ? "as observed and as " : "") + "predicted at the best point" +
                   (section.water_pressure.empty() ? "." : ", with water pressures."));
    FailureLoci loci = failure_loci(slope);
    loci.laboratory = {prior_range(fit, slope)};
    sheet.draw(failure_locus_figure(loci), fit.name + "_failure_loci",
               "Friction angle (of the mean plane) and cohesion at FS = 1 for the geometry of the best point and "
               "several water levels, with what was known of the strength beforehand.");
    if (const auto curves = water_depth_curves(slope)) {
        sheet.draw(factor_of_safety_against_water(*curves), fit.name + "_water",
                   "Factor of safety against the filled ratio of the crack.");
    }
    sheet.draw(tornado_figure("Change of the factor of safety",
                              sensitivity_bars(slope, sensitivities(slope), deviations_of(fit.parameters))),
               fit.name + "_sensitivity",
               "To first order, from exact derivatives at the best point, the geometry held; fitted inputs by one "
               "standard deviation of their priors. The eight greatest.");
}

}  // namespace delabole
