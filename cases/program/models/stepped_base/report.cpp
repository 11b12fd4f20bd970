// Columns on a stepped base: answers and warnings for reports.
#include "cases/program/models/stepped_base/bound.hpp"
#include "cases/program/models/stepped_base/drawing.hpp"
#include "cases/program/models/stepped_base/sweeps.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/columns/base_profile.hpp"

#include <cmath>

namespace delabole {

namespace {

// Above this product of friction coefficients, a push from below hardly holds a sliding column, or not at all.
constexpr double nearly_locked = 0.9;

double friction_product_at_limit(const SteppedBase<>& problem, double factor) {
    const ColumnStrength<> strength = strength_of(problem).reduced_by(factor);
    return strength.joint_friction * strength.base_friction;
}

// "column 2", "columns 2, 3 and 4", "12 columns"
std::string columns_in_words(const std::vector<std::string>& numbers) {
    constexpr std::size_t most_named = 6;
    return numbers.size() == 1            ? "column " + numbers.front()
           : numbers.size() <= most_named ? "columns " + list_in_words(numbers)
                                          : std::to_string(numbers.size()) + " columns";
}

// Clauses that name the columns whose bases cannot give the reactions that are asked of them.
std::vector<std::string> what_the_recursion_does_not_see(const std::vector<ColumnResult>& columns) {
    std::vector<std::string> outside;
    std::vector<std::string> not_held;
    for (const ColumnResult& column : columns) {
        if (!column.base_friction_holds) {
            not_held.push_back(std::to_string(column.number));
        } else if (!column.reaction_inside_base) {
            outside.push_back(std::to_string(column.number));
        }
    }
    std::vector<std::string> clauses;
    if (!outside.empty()) {
        clauses.push_back(columns_in_words(outside) + " would turn as well, for the reaction falls outside the base");
    }
    if (!not_held.empty()) {
        clauses.push_back(columns_in_words(not_held) + " would lift off the base, or slip on it while toppling");
    }
    return clauses;
}

SteppedBase<> with_cable(SteppedBase<> problem, const RequiredCable<>& cable, double force) {
    problem.scene.bolt.push_back({cable.block, force, cable.plunge, cable.height});
    return problem;
}

SteppedBase<> with_value(SteppedBase<> problem, const RequiredValue<>& request, double required) {
    *find_input(problem, request.parameter) = required;
    for (const std::string& other : request.also) {
        *find_input(problem, other) = required;
    }
    return problem;
}

// Says what the recursion does not see once the slope has the factor of safety that was required of it.
std::string doubts_about(const SteppedBase<>& problem, double factor) {
    const ColumnSlope<> slope = make_columns(problem.scene);
    return slope.check == ColumnCheck::valid
               ? list_in_words(what_the_recursion_does_not_see(column_results(slope, strength_of(problem), factor)))
               : "";
}

// A sentence, continued by what the recursion does not see.
std::string doubted(std::string sentence, const std::string& doubts) {
    if (!doubts.empty()) {
        sentence.back() = ',';
        sentence += " but then " + doubts + ", which the recursion does not see.";
    }
    return sentence;
}

bool is_found(const Required& required) {
    return required.status == RequiredStatus::found || required.status == RequiredStatus::several;
}

void append_required(Analysis& analysis, const SteppedBaseStudy<>& study, const SteppedBaseAnswer& answer) {
    append_required_values(analysis, study.required, answer.required);
    const SteppedBase<>& problem = answer.resolved.problem;
    const auto warn_of = [&](const std::string& name, const std::string& doubts) {
        if (!doubts.empty()) {
            analysis.warnings.push_back(name + ": with it " + doubts + ", which the recursion does not see");
        }
    };
    for (std::size_t index = 0; index < study.required.size(); ++index) {
        const RequiredValue<>& request = study.required[index];
        if (const Required& found = answer.required[index]; is_found(found)) {
            warn_of("required." + request.parameter,
                    doubts_about(with_value(problem, request, found.value), request.factor_of_safety));
        }
    }
    for (std::size_t index = 0; index < study.required_cable.size(); ++index) {
        const RequiredCable<>& request = study.required_cable[index];
        const CableForce& cable = answer.required_cable[index];
        const std::string name = "required_cable[" + std::to_string(index + 1) + "].force";
        const std::string meaning = "tension in column " + number_in_words(request.block) +
                                    " for a factor of safety of " + number_in_words(request.factor_of_safety);
        if (cable.state == CableState::found) {
            analysis.outputs.push_back({name, meaning, Dimension::force_per_length, cable.force});
            warn_of(name, doubts_about(with_cable(problem, request, cable.force), request.factor_of_safety));
        } else {
            analysis.outputs.push_back({name, meaning, Dimension::force_per_length, std::string(word_of(cable.state))});
            analysis.warnings.push_back(name + ": " +
                                        (cable.state == CableState::not_needed
                                             ? "not_needed, for the slope has that factor of safety without it"
                                             : "cannot_hold, for other columns fail before any tension there would "
                                               "help: put the cable into a column nearer to the toe or higher up in "
                                               "it, ask for a smaller factor of safety, or drain the slope"));
        }
    }
}

std::string_view what_lifts(const SlideHeadWedge<>& wedge) {
    const double into_joint = wedge.force_x * std::sin(wedge.joint_dip) - wedge.force_y * std::cos(wedge.joint_dip);
    if (!(into_joint > 0)) {
        return "its loads lift";  // only an extreme earthquake does this
    }
    return into_joint < wedge.water_force ? "water lifts" : "the friction of the columns that it pushes lifts";
}

// Sets the numbers of an absent wedge to "none", and the limiting friction angle if no friction angle suffices.
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

void warn(Analysis& analysis, const SteppedBaseAnswer& answer) {
    const SteppedBase<>& problem = answer.resolved.problem;
    const SteppedBaseResult& result = answer.result;
    if (answer.resolved.critical_at_boundary) {
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
        analysis.warnings.push_back(std::string(what_lifts(*answer.slope.slide_head)) +
                                    " the wedge above off its joint: it rests on the columns alone");
    }
    for (const std::string& clause : what_the_recursion_does_not_see(answer.limiting.columns)) {
        analysis.warnings.push_back(clause + ", which the recursion does not see");
    }
    if (answer.slope.columns.size() > most_drawn_columns) {
        analysis.warnings.push_back("figures are left out: " + std::to_string(answer.slope.columns.size()) +
                                    " columns are too many to be told apart; columns.csv has their forces" +
                                    (can_sweep(problem, answer.slope)
                                         ? ""
                                         : ", and the dependence on geometry and inputs would take too long"));
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

std::string movement_in_words(const SteppedBaseResult& result) {
    const auto columns = [](double count, const std::string& verb) {
        return number_in_words(count) + (count == 1 ? " column " + verb + "s" : " columns " + verb);
    };
    std::string text = "In limiting equilibrium ";
    if (result.toppling_count > 0) {
        text += columns(result.toppling_count, "topple");
    }
    if (result.sliding_count > 0 || result.toppling_count == 0) {
        text += (result.toppling_count > 0 ? " and " : "") + columns(result.sliding_count, "slide");
    }
    return text + ", " + value_in_words(result.moving_area, Dimension::area) + " in all" +
           (result.slide_head_thrust > 0
                ? ", under the thrust of a wedge, " +
                      value_in_words(result.slide_head_thrust, Dimension::force_per_length) + "."
                : ".");
}

std::string limit_in_words(const SteppedBaseResult& result) {
    const std::string factor = factor_in_words(result.factor_of_safety);
    switch (result.limit) {
    case LimitState::found:
        return factor + (result.factor_of_safety >= 1                    ? ": stands."
                         : result.toppling_share >= result.sliding_share ? ": fails by toppling."
                                                                         : ": fails by sliding.");
    case LimitState::abrupt:
        return factor +
               (result.factor_of_safety >= 1 ? ": stands, but what is weaker fails abruptly." : ": fails abruptly.");
    case LimitState::holds_at_any_strength:
        return "Nothing moves even without strength: the factor of safety is infinite.";
    case LimitState::fails_at_any_strength:
        break;
    }
    return "Fails: no factor on the strength was found that holds the lowest column.";
}

}  // namespace

HeadCard head_card(const SteppedBaseStudy<>& study, const SteppedBaseAnswer& answer) {
    const SteppedBaseResult& result = answer.result;
    const bool stands = result.limit == LimitState::holds_at_any_strength ||
                        (result.limit != LimitState::fails_at_any_strength && result.factor_of_safety >= 1);
    HeadCard head{stands ? AnswerTone::good : AnswerTone::bad, {limit_in_words(result)}, {}};
    const SteppedBase<>& problem = answer.resolved.problem;
    std::string required;
    const auto add = [&](const std::string& sentence) { required += (required.empty() ? "" : " ") + sentence; };
    for (std::size_t index = 0; index < study.required.size(); ++index) {
        const RequiredValue<>& request = study.required[index];
        const Required& found = answer.required[index];
        add(doubted(
            required_in_words(request, found),
            is_found(found) ? doubts_about(with_value(problem, request, found.value), request.factor_of_safety) : ""));
    }
    for (std::size_t index = 0; index < study.required_cable.size(); ++index) {
        const RequiredCable<>& cable = study.required_cable[index];
        const CableForce& found = answer.required_cable[index];
        const std::string place = "a cable in column " + number_in_words(cable.block) + ", " +
                                  value_in_words(cable.height, Dimension::length) + " above its base, at " +
                                  value_in_words(cable.plunge, Dimension::angle);
        const std::string factor = factor_in_words(cable.factor_of_safety);
        if (found.state == CableState::found) {
            add(doubted(
                factor + " takes " + value_in_words(found.force, Dimension::force_per_length) + " in " + place + ".",
                doubts_about(with_cable(problem, cable, found.force), cable.factor_of_safety)));
        } else if (found.state == CableState::not_needed) {
            add(factor + " is reached without " + place + ".");
        } else {
            add("No force in " + place + " gives " + factor + ".");
        }
    }
    if (!required.empty()) {
        head.sentences.push_back(std::move(required));
    }
    if (result.limit == LimitState::found) {
        head.sentences.push_back(movement_in_words(result));
    }
    return head;
}

SteppedBaseAnswer analyse_case(const SteppedBaseStudy<>& study, const AnalysisWork&) {
    SteppedBaseAnswer answer{resolve(study)};
    const SteppedBase<>& problem = answer.resolved.problem;
    SteppedBaseResult& result = answer.result;
    if (answer.resolved.check != ColumnCheck::valid) {
        result.check = answer.resolved.check;
        return answer;
    }
    result = analyse(problem);
    if (result.check != ColumnCheck::valid) {
        return answer;
    }
    answer.required = required_values(problem, study.required);
    for (const RequiredCable<>& request : study.required_cable) {
        answer.required_cable.push_back(required_cable(problem, request));
        if (answer.required_cable.back().state == CableState::no_such_place) {
            result.check = ColumnCheck::load_outside_columns;
            return answer;
        }
    }
    answer.slope = make_columns(problem.scene);
    answer.as_given = {column_results(answer.slope, strength_of(problem)), 1, "with the strength as given"};
    answer.limiting = answer.as_given;
    if (const double factor = result.factor_of_safety; result.limit == LimitState::found) {
        answer.limiting = {column_results(answer.slope, strength_of(problem), factor), factor,
                           "in limiting equilibrium, strength divided by " + number_in_words(factor)};
    }
    if (study.linear_programming_bound) {
        find_bounds(answer, *study.linear_programming_bound);
    }
    return answer;
}

Analysis named_outputs(const SteppedBaseStudy<>& study, const SteppedBaseAnswer& answer) {
    Analysis analysis;
    append_outputs(analysis, answer.result);
    mark_what_is_not(analysis, answer.resolved.problem, answer.result);
    append_required(analysis, study, answer);
    append_support(analysis, support_rows(answer.resolved.problem.scene));
    append_column_outputs(analysis, answer.as_given.columns);
    warn(analysis, answer);
    if (study.linear_programming_bound) {
        append_bounds(analysis, answer, *study.linear_programming_bound);
    }
    return analysis;
}

}  // namespace delabole
