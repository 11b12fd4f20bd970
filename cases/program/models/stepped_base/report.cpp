// Columns on a stepped base as the program reports them: answers and warnings.
#include "cases/program/models/stepped_base/bound.hpp"
#include "cases/program/models/stepped_base/columns.hpp"
#include "cases/program/models/stepped_base/drawing.hpp"
#include "cases/program/models/stepped_base/sweeps.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"

#include <cmath>
#include <stdexcept>

namespace delabole {

namespace {

// From here on a push from below no longer holds a column that slides, or hardly.
constexpr double nearly_locked = 0.9;

double friction_product_at_limit(const SteppedBase<>& problem, double factor) {
    const ColumnStrength<> strength = strength_of(problem).reduced_by(factor);
    return strength.joint_friction * strength.base_friction;
}

// No where a cable names a place that does not exist.
bool append_required(Analysis& analysis, const SteppedBase<>& problem, const SteppedBaseStudy<>& study) {
    for (const RequiredValue<>& request : study.required) {
        append_required_value(analysis, request.parameter, request.factor_of_safety,
                              required_value(problem, request.parameter, request.factor_of_safety));
    }
    for (std::size_t index = 0; index < study.required_cable.size(); ++index) {
        const RequiredCable<>& request = study.required_cable[index];
        const CableForce cable = required_cable(problem, request);
        if (cable.state == CableState::no_such_place) {
            return false;
        }
        const std::string name = "required_cable[" + std::to_string(index + 1) + "].force";
        const std::string meaning = "tension in column " + number_in_words(request.block) +
                                    " for a factor of safety of " + number_in_words(request.factor_of_safety);
        if (cable.state == CableState::found) {
            analysis.outputs.push_back({name, meaning, Dimension::force_per_length, cable.force});
        } else {
            analysis.outputs.push_back({name, meaning, Dimension::force_per_length, std::string(word_of(cable.state))});
        }
    }
    return true;
}

std::string_view what_lifts(const SlideHeadWedge<>& wedge) {
    const double into_joint = wedge.force_x * std::sin(wedge.joint_dip) - wedge.force_y * std::cos(wedge.joint_dip);
    if (!(into_joint > 0)) {
        return "its loads lift";  // an earthquake more than any
    }
    return into_joint < wedge.water_force ? "water lifts" : "the friction of the columns that it pushes lifts";
}

// A wedge that is not there has no numbers, nor has a friction angle that none is.
void mark_what_is_not(Analysis& analysis, const SteppedBase<>& problem, const SteppedBaseResult& result) {
    if (!problem.scene.slide_head) {
        mark_none(analysis, "slide_head");
    }
    for (NamedOutput& output : analysis.outputs) {
        if (output.name == "limiting_friction_angle" && result.friction_limit == LimitState::fails_at_any_strength) {
            output.value = "none";
        }
    }
}

void warn(Analysis& analysis, const SteppedBase<>& problem, const SteppedBaseResult& result, bool at_boundary) {
    const ColumnSlope<> slope = make_columns(problem.scene);
    if (at_boundary) {
        analysis.warnings.emplace_back(
            "the least factor of safety lies at the edge of the searched range: a limit, not a balance");
    }
    if (result.limit == LimitState::fails_at_any_strength) {
        std::string warning = "no factor on the strength as given, however large, keeps the lowest column from moving";
        if (result.friction_limit == LimitState::found) {
            warning += "; one friction angle of " + value_in_words(result.limiting_friction_angle, Dimension::angle) +
                       " on joints and bases would";
        }
        analysis.warnings.push_back(warning);
    } else if (result.limit == LimitState::abrupt) {
        analysis.warnings.push_back(
            "no limiting equilibrium: the slope stands with its strength divided by " +
            number_in_words(result.factor_of_safety) + " and fails past that, but " +
            (friction_product_at_limit(problem, result.factor_of_safety) >= nearly_locked
                 ? "the friction angles of joints and bases there add to nearly 90 deg or more, so that a column which "
                   "begins to slide is held by no push from below: the answer depends on the least change of the inputs"
                 : "a column that moves there has none below it to lean on"));
    } else if (result.limit == LimitState::holds_at_any_strength) {
        analysis.warnings.emplace_back("nothing moves even without strength: the factor of safety is infinite");
    }
    if (result.slide_head == SlideHeadState::jams) {
        analysis.warnings.emplace_back(
            "the wedge above jams between its joint and the columns: its thrust is not counted");
    } else if (result.slide_head == SlideHeadState::lifts_off) {
        analysis.warnings.push_back(std::string(what_lifts(*slope.slide_head)) +
                                    " the wedge above off its joint: its thrust is not counted");
    }
    const double factor = result.limit == LimitState::found ? result.factor_of_safety : 1;
    int outside = 0;
    int lifted_or_slipping = 0;
    for (const ColumnResult& column : column_results(slope, strength_of(problem), factor)) {
        if (!column.base_friction_holds) {
            ++lifted_or_slipping;
        } else if (!column.reaction_inside_base) {
            ++outside;
        }
    }
    if (outside > 0) {
        analysis.warnings.emplace_back(
            "column(s) that would turn as well, for the reaction falls outside their base, "
            "which the recursion does not see: " +
            std::to_string(outside));
    }
    if (lifted_or_slipping > 0) {
        analysis.warnings.emplace_back(
            "column(s) whose base would be in tension, or would slip while they topple, "
            "which the recursion does not see: " +
            std::to_string(lifted_or_slipping));
    }
    if (slope.columns.size() > most_drawn_columns) {
        analysis.warnings.push_back(
            "figures are left out: " + std::to_string(slope.columns.size()) +
            " columns are too many to be told apart; columns.csv has their forces" +
            (can_sweep(problem) ? "" : ", and the dependence on geometry and inputs would take too long"));
    }
    const bool cut = !std::holds_alternative<BlockColumns<>>(problem.scene.columns);
    if (cut && !(problem.scene.bolt.empty() && problem.scene.point_load.empty())) {
        analysis.warnings.emplace_back(
            "bolts and point loads keep the number of their column: where a change of geometry adds or takes away a "
            "column at the toe they move, and every result jumps");
    }
    if (const auto* classical = std::get_if<ClassicalColumns<>>(&problem.scene.columns)) {
        const ClassicalJump jump = classical_jump(*problem.scene.slope, *classical);
        analysis.warnings.push_back(
            "flat-topped columns: at slope heights of " + value_in_words(jump.lower_height, Dimension::length) +
            " and " + value_in_words(jump.upper_height, Dimension::length) +
            " the crest moves to another column and every result jumps; columns.kind = \"continuous\" does not");
    }
}

}  // namespace

Analysis analyse_case(const SteppedBaseStudy<>& study) {
    Analysis analysis;
    const ResolvedSteppedBase resolved = resolve(study);
    const SteppedBaseResult result =
        resolved.check == ColumnCheck::valid ? analyse(resolved.problem) : SteppedBaseResult{};
    const ColumnCheck check = resolved.check == ColumnCheck::valid ? result.check : resolved.check;
    if (check != ColumnCheck::valid) {
        analysis.failure = word_of(check);
        return analysis;
    }
    append_outputs(analysis, result);
    mark_what_is_not(analysis, resolved.problem, result);
    if (!append_required(analysis, resolved.problem, study)) {
        analysis.failure = word_of(ColumnCheck::load_outside_columns);
        return analysis;
    }
    append_column_outputs(analysis,
                          column_results(make_columns(resolved.problem.scene), strength_of(resolved.problem)));
    warn(analysis, resolved.problem, result, resolved.critical_at_boundary);
    if (study.linear_programming_bound) {
        append_bound(analysis, resolved.problem, *study.linear_programming_bound);
    }
    return analysis;
}

}  // namespace delabole
