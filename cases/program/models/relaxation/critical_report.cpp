#include "cases/program/models/relaxation/critical_report.hpp"

#include "cases/program/models/relaxation/ensemble_report.hpp"
#include "cases/program/models/relaxation/figures.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

std::string meaning_of(CriticalParameter parameter) {
    return words_for(parameter, {"tilt at which the blocks begin to fail",
                                 "friction angle of all joints below which the blocks fail",
                                 "factor by which strength has to be divided for the blocks to fail",
                                 "factor on gravity at which the blocks begin to fail"});
}

// An end of a bracket, with only as many digits as distinguish it from the other end.
std::string bracket_in_words(double value, double other, Dimension dimension) {
    constexpr int fewest = 3;
    constexpr int most = 6;
    const double apart = std::abs(value / (value - other));
    const int digits = std::isfinite(apart) ? static_cast<int>(std::ceil(std::log10(std::max(apart, 1.0)))) + 1 : most;
    return in_digits(value, dimension, std::clamp(digits, fewest, most));
}

// "stands", "fails" and the values found for them on one path.
std::string path_in_words(const CriticalPlan& plan, const PathValue& value) {
    const Dimension dimension = dimension_of(plan.parameter);
    const std::string last = value_in_words(value.last, dimension);
    const std::string more = plan.stands_low() ? ": raise critical.upper" : ": lower critical.lower";
    const std::string less = plan.stands_low() ? ": lower critical.lower" : ": raise critical.upper";
    const std::string known = value.seen_to_stand && value.seen_to_fail
                                  ? ". The blocks stand at " + bracket_in_words(value.stands, value.fails, dimension) +
                                        " and fail at " + bracket_in_words(value.fails, value.stands, dimension)
                                  : "";
    switch (value.status) {
    case CriticalStatus::found:
        return {};
    case CriticalStatus::stands_everywhere:
        return "the blocks stand even at " + last + more;
    case CriticalStatus::fails_everywhere:
        if (plan.has_two_limits()) {
            return "the blocks fail at " + value_in_words(plan.lower, dimension) + " and at " +
                   value_in_words(plan.upper, dimension) +
                   ": move critical.lower or critical.upper to where they stand";
        }
        return "the blocks fail" + std::string(value.held_by_corners ? ", or are held by corners alone," : "") +
               " even at " + last + less;
    case CriticalStatus::undecided:
        return "at " + last + " the blocks neither came to rest nor failed" +
               (value.path == LoadingPath::consolidated && !value.consolidated_at
                    ? ", so that there is no state at rest from which to begin"
                    : " within settings.duration: raise it") +
               known;
    case CriticalStatus::run_failed:
        return "the run at " + last +
               " was stopped: an overlap passed settings.overlap_limit, or its energy did not balance" + known;
    case CriticalStatus::interrupted:
        return "the search ended in the run at " + last;
    case CriticalStatus::not_valid:
        return "the scene is not valid at " + last;
    }
    return {};
}

Cell value_or_status(const PathValue& value) {
    if (value.status == CriticalStatus::found) {
        return value.value();
    }
    return std::string(word_of(value.status));
}

Cell value_or_none(const std::optional<double>& value) {
    return value ? Cell(*value) : Cell("none");
}

// How failure of the blocks was decided, with the path if there are several.
std::string decision_in_words(const CriticalPlan& plan, const PathValue& value) {
    const Dimension dimension = dimension_of(plan.parameter);
    const RelaxationRun& failed = *value.failed;
    const bool found = value.status == CriticalStatus::found;
    const double at = found ? value.fails : value.last;
    const std::string path(word_of(value.path));
    const std::string on_path = plan.path.size() > 1 ? "On the path " + path + ": at " : "At ";
    std::string text = on_path + bracket_in_words(at, found ? value.stands : at, dimension);
    if (value.held_by_corners) {
        text += " the blocks rest, but faces cannot take forces in equilibrium: corners on corners hold what is marked";
    } else if (!is_failure(failed.result.outcome)) {
        text +=
            " the blocks rest only beyond the thresholds of onset, or no forces on their faces hold them as drawn: "
            "they move, at most until they lean on others or jam";
    } else if (failed.result.start_balance) {
        const double ratio = failed.result.start_balance->unbalanced_ratio;
        const bool balanced = ratio <= failed.settings.equilibrium_ratio;
        text += balanced ? " the static solver found an equilibrium that the run did not keep"
                         : " the static solver found no equilibrium: in the most balanced state that it met, " +
                               number_in_words(100 * ratio) + " % of a block's load are out of balance";
    } else {
        text += ", with springs loaded at once";
    }
    text += !is_failure(failed.result.outcome)
                ? "."
                : "; in the run blocks passed the thresholds of onset, a rotation of " +
                      value_in_words(failed.settings.onset_rotation, Dimension::angle) + " or a displacement of " +
                      number_in_words(failed.settings.onset_slide) + " radii.";
    if (found) {
        text += " At " + bracket_in_words(value.stands, value.fails, dimension) +
                " they came to rest, out of balance by less than " +
                number_in_words(failed.settings.equilibrium_ratio) + " of a block's weight.";
    }
    return text;
}

// How failure was decided, which blocks fail, and their figure. If the value was found on several paths, the files are
// named after the path.
void append_failure(const CriticalPlan& plan, const PathValue& value, const Sheet& sheet) {
    if (!value.failed) {
        return;
    }
    const RelaxationRun& failed = *value.failed;
    const std::string path(word_of(value.path));
    const bool several = plan.path.size() > 1;
    const std::string suffix = several ? '_' + path : "";
    sheet.add(Paragraph{decision_in_words(plan, value)});
    CsvTable csv({"block", "movement", "rotation_deg", "displacement_m", "base_slip_m"});
    for (const std::size_t block : failing_blocks(failed).block) {
        const BlockOutcome& outcome = failed.result.block[block];
        csv.add_row({static_cast<double>(block + 1), std::string(word_of(outcome.movement)),
                     in_display_unit(outcome.rotation, Dimension::angle), outcome.displacement, outcome.base_slip});
    }
    sheet.write("failing_blocks" + suffix + ".csv", csv.text());
    std::string title = "At failure";
    if (several && value.status == CriticalStatus::found) {
        title += ", path " + path + ": " + human_name(name_of_critical(plan.parameter)) + ' ' +
                 value_in_words(value.value(), dimension_of(plan.parameter));
    }
    append_failure_figure(failed, title, "at_failure" + suffix, sheet);
}

void append_paths(const CriticalPlan& plan, const CriticalAnswer& critical, const Sheet& sheet) {
    const Dimension dimension = dimension_of(plan.parameter);
    const std::string name = human_name(name_of_critical(plan.parameter));
    Table table{
        capitalised(name) + " on each loading path; stands and fails are the nearest values that were found to.",
        {"path", {name, true}, "stands"_number, "fails"_number, "failing blocks"_number, "runs"_number}};
    CsvTable csv({"path", "status", column_name(name_of_critical(plan.parameter), dimension),
                  column_name("stands", dimension), column_name("fails", dimension), "failing_blocks", "runs"});
    const auto add = [&](const PathValue& value) {
        const bool found = value.status == CriticalStatus::found;
        const double failing = value.failed ? static_cast<double>(failing_blocks(*value.failed).block.size()) : 0;
        table.rows.push_back({std::string(word_of(value.path)),
                              found ? in_six_digits(value.value(), dimension) : human_name(word_of(value.status)),
                              value.seen_to_stand ? in_six_digits(value.stands, dimension) : "none",
                              value.seen_to_fail ? in_six_digits(value.fails, dimension) : "none",
                              human_number(failing, 6), std::to_string(value.runs)});
        csv.add_row({std::string(word_of(value.path)), std::string(word_of(value.status)),
                     found ? Cell(in_display_unit(value.value(), dimension)) : Cell(std::string()),
                     value.seen_to_stand ? Cell(in_display_unit(value.stands, dimension)) : Cell(std::string()),
                     value.seen_to_fail ? Cell(in_display_unit(value.fails, dimension)) : Cell(std::string()), failing,
                     static_cast<double>(value.runs)});
    };
    add(critical);
    std::ranges::for_each(critical.other, add);
    sheet.write("paths.csv", csv.text());
    sheet.add(std::move(table));
    if (!critical.other.empty() && critical.worst_status() == CriticalStatus::found) {
        const std::vector<double> values = critical.values();
        sheet.add(Paragraph{"The paths spread by " + in_six_digits(values[values.size() - 2], dimension) +
                            ": none of them is wrong, so that this is error of the model, beside that of its inputs. A "
                            "fit adds the deviation of the others from the first, " +
                            in_six_digits(values.back(), dimension) + ", in quadrature to that of what was observed."});
    }
}

// Sentences on the result of a search, with its bracket. `as_drawn`: " as drawn" where an ensemble has other slopes.
std::vector<std::string> search_sentences(const CriticalPlan& plan, const CriticalAnswer& critical, bool fails_as_given,
                                          const std::string& as_drawn) {
    const Dimension dimension = dimension_of(plan.parameter);
    const bool is_factor = plan.parameter == CriticalParameter::strength_reduction;
    const std::string name = is_factor ? "factor of safety" : human_name(name_of_critical(plan.parameter));
    const double value = critical.value();
    if (critical.status != CriticalStatus::found) {
        return {"No " + name + " found" + as_drawn + ": " + path_in_words(plan, critical) + "."};
    }
    return {is_factor ? factor_in_words(value) + as_drawn +
                            (value < 1        ? ": fails."
                             : fails_as_given ? ", by strength reduction."
                                              : ", by strength reduction: stands.")
                      : capitalised(name + " " + value_in_words(value, dimension)) + as_drawn + ".",
            "At " + bracket_in_words(critical.stands, critical.fails, dimension) + " the blocks stand, at " +
                bracket_in_words(critical.fails, critical.stands, dimension) + " they fail."};
}

// How a run ended, in a sentence for readers of the verdict alone.
std::string end_in_words(const RelaxationRun& made) {
    const RelaxationResult& result = made.result;
    const std::string after = " after " + value_in_words(result.time, Dimension::time);
    // At onset blocks have hardly moved, and have next to no share in the area that has failed.
    const bool has_moved = made.post_failure && result.outcome != RelaxationOutcome::onset;
    const std::string area =
        value_in_words(has_moved ? made.post_failure->answer.failed_area : failing_blocks(made).area, Dimension::area);
    if (made.in_stages) {
        return made.stage.empty()
                   ? "Stands: no block fails."
                   : "Fails: it retreats in " + std::to_string(made.stage.size()) +
                         (made.stage.size() == 1 ? " stage" : " stages") + ", in which " + area + " fall.";
    }
    switch (result.outcome) {
    case RelaxationOutcome::equilibrium:
        return result.failed_at_rest() ? "Fails: at rest" + after + ", but not as drawn: " + area + " begin to move."
               : result.onset_time     ? "Failed, and came to rest: " + area + " had moved" + after + "."
                                       : "Stands: at rest" + after + ".";
    case RelaxationOutcome::held_by_corners:
        return "Held by corners alone: at rest" + after + ", but without corners on corners blocks would move.";
    case RelaxationOutcome::onset:
        return "Fails: " + area + " had begun to move" + after + ".";
    case RelaxationOutcome::collapse:
        return "Collapsed: " + area + " had moved" + after + ", some of it beyond the limits of collapse.";
    case RelaxationOutcome::undecided:
        return "Not decided: the blocks neither came to rest nor failed" + after + ".";
    case RelaxationOutcome::interrupted:
        return "Interrupted" + after + " of model time.";
    default:
        return "No answer: the run was stopped" + after + ", " + human_name(word_of(result.outcome)) + ".";
    }
}

// Changes a sentence so that it can follow a colon: "Collapsed: 12 m2" becomes "collapsed, 12 m2".
std::string continued(std::string sentence) {
    sentence.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence.front())));
    const std::size_t colon = sentence.find(": ");
    return colon == std::string::npos ? sentence : sentence.replace(colon, 1, ",");
}

// "Bolt 2 pulls most at the end, 66 kN/m of the 100 kN/m at which it yields; the"
std::string greatest_pull(const RelaxationRun& made) {
    if (made.result.bolt.empty()) {
        return "The";
    }
    const auto most = std::ranges::max_element(made.result.bolt, {}, &BoltOutcome::force);
    const auto index = static_cast<std::size_t>(most - made.result.bolt.begin());
    return "Bolt " + std::to_string(index + 1) + " pulls most at the end, " +
           value_in_words(most->force, Dimension::force_per_length) + " of the " +
           value_in_words(std::ranges::find(made.scene.bolt, index, &BoltSegment::bolt)->capacity,
                          Dimension::force_per_length) +
           " at which it yields; the";
}

AnswerTone tone_of(const RelaxationRun& made) {
    if (made.in_stages) {
        return made.stage.empty() ? AnswerTone::good : AnswerTone::bad;
    }
    switch (made.result.outcome) {
    case RelaxationOutcome::equilibrium:
        return made.result.onset_time ? AnswerTone::bad : AnswerTone::good;
    case RelaxationOutcome::onset:
    case RelaxationOutcome::collapse:
        return AnswerTone::bad;
    default:
        return AnswerTone::open;
    }
}

}  // namespace

FailingBlocks failing_blocks(const RelaxationRun& failed) {
    FailingBlocks failing;
    for (std::size_t block = 0; block < failed.result.block.size(); ++block) {
        if (has_failed(failed.result.block[block].movement)) {
            failing.block.push_back(block);
            failing.area += area_properties(failed.scene.block[block].outline).area;
        }
    }
    return failing;
}

HeadCard head_card(const RelaxationStudy& study, const RelaxationStudyAnswer& answer) {
    const RelaxationRun& made = answer.run;
    const RelaxationResult& result = made.result;
    if (answer.critical) {
        const CriticalAnswer& critical = *answer.critical;
        const bool found = critical.status == CriticalStatus::found;
        const bool is_factor = answer.plan->parameter == CriticalParameter::strength_reduction;
        const bool fails_as_given = found && answer.plan->is_ratio() && critical.value() >= 1 &&
                                    (is_failure(result.outcome) || result.failed_at_rest() ||
                                     result.outcome == RelaxationOutcome::held_by_corners);
        HeadCard head{!found || fails_as_given            ? AnswerTone::open
                      : is_factor && critical.value() < 1 ? AnswerTone::bad
                                                          : AnswerTone::good,
                      search_sentences(*answer.plan, critical, fails_as_given, study.ensemble ? " as drawn" : ""),
                      {}};
        if (answer.has_means()) {
            head.sentences.insert(head.sentences.begin() + 1, ensemble_in_words(study, answer));
            const bool fails = is_factor && *mean_critical(study, answer) < 1;
            head.tone = fails ? AnswerTone::bad : answer.ensemble->failing > 0 ? AnswerTone::open : head.tone;
        }
        const Dimension dimension = dimension_of(answer.plan->parameter);
        const std::size_t answers = head.sentences.size();
        if (answer.other_path && !answer.other_path->stands) {
            head.sentences.push_back("It depends on the loading path: with all loads at once the blocks fail at " +
                                     value_in_words(answer.other_path->value, dimension) + " already.");
        }
        if (answer.fails_if_softer) {
            head.sentences.push_back(
                "It depends on the stiffness of the joints: with a tenth of it the blocks fail at " +
                value_in_words(*answer.fails_if_softer, dimension) + " already.");
        }
        if (fails_as_given || head.sentences.size() == answers) {
            head.sentences.push_back("With the strength and loads as given: " + continued(end_in_words(made)));
        }
        return head;
    }
    HeadCard head{tone_of(made), {end_in_words(made)}, {}};
    if (answer.has_means()) {
        head.sentences.push_back(ensemble_in_words(study, answer));
    }
    if (result.failed_at_rest()) {
        head.sentences.emplace_back(
            "No forces on their faces hold the blocks where they are drawn, or they moved beyond the thresholds of "
            "failure before they rested.");
    } else if (result.onset_time) {
        // A crack long before anything can be seen to move belongs to the settling of the first steps.
        constexpr double settled = 0.01;  // of the time to onset
        const bool crack = result.first_crack && result.first_crack->time >= settled * *result.onset_time;
        head.sentences.push_back(
            "The first block passed the thresholds of failure at " +
            value_in_words(*result.onset_time, Dimension::time) +
            (crack ? ", the first crack opened at " + value_in_words(result.first_crack->time, Dimension::time) + "."
                   : "."));
    }
    const bool watched = study.settings && study.settings->watch;
    head.sentences.push_back((watched ? "Followed past the verdict, as settings.watch asks. " : "") +
                             greatest_pull(made) + " energy balance closes to " +
                             number_in_words(100 * std::abs(result.energy_balance.residual_share())) + " % in " +
                             number_in_words(static_cast<double>(result.cost.steps)) + " steps.");
    return head;
}

void append_critical(Analysis& analysis, const RelaxationStudyAnswer& answer) {
    const CriticalPlan& plan = *answer.plan;
    const CriticalAnswer& critical = *answer.critical;
    const std::optional<OtherPath>& other_path = answer.other_path;
    const bool found = critical.status == CriticalStatus::found;
    const std::vector<Quantity> names = outputs_of_search(plan);
    const Dimension dimension = dimension_of(plan.parameter);
    const auto append = [&](const std::string& key, const std::string& meaning, Dimension of, auto value, bool detail) {
        analysis.outputs.push_back({key, meaning, of, value, detail});
    };
    append(names.front().name, meaning_of(plan.parameter), dimension, value_or_status(critical), false);
    append("critical.stands", "nearest value found to stand", dimension,
           critical.seen_to_stand ? Cell(critical.stands) : Cell("none"), !found);
    append("critical.fails", "nearest value found to fail", dimension,
           critical.seen_to_fail ? Cell(critical.fails) : Cell("none"), !found);
    append("critical.path", "loading path on which the value was found", Dimension::ratio,
           std::string(word_of(critical.path)), false);
    append("critical.consolidated_at", "value at which the blocks came to rest first", dimension,
           value_or_none(critical.consolidated_at), true);
    std::optional<FailingBlocks> failing;
    if (critical.failed) {
        failing = failing_blocks(*critical.failed);
    }
    append("critical.failing_blocks",
           "blocks that have begun to move at the nearest value found to fail, or that only corners hold",
           Dimension::ratio, failing ? Cell(static_cast<double>(failing->block.size())) : Cell("none"), !found);
    append("critical.failing_area", "their area", Dimension::area, failing ? Cell(failing->area) : Cell("none"), true);
    append("critical.stands_again", "value at which the blocks stand although they fail at a less demanding one",
           dimension, value_or_none(critical.stands_again), true);
    if (found && critical.held_by_corners) {
        analysis.warnings.push_back("at " + in_six_digits(critical.fails, dimension) +
                                    " the blocks rest only because corners bear on corners, which is not taken for "
                                    "standing: settings.corners_bear = \"on\" finds where they move in spite of that");
    }
    if (critical.stands_again) {
        const std::string again = in_six_digits(*critical.stands_again, dimension);
        analysis.warnings.push_back(
            "the blocks stand again at " + again + ", although they fail at " +
            in_six_digits(critical.fails, dimension) +
            ": whether blocks jam while they move depends on details such as rounding; the answer is "
            "the least demanding value at which they were found to fail");
    }
    append("critical.runs", "runs made", Dimension::ratio, static_cast<double>(critical.runs), true);
    append("critical.steps", "time steps of all runs", Dimension::ratio, static_cast<double>(critical.steps), true);
    const auto values = critical.worst_status() == CriticalStatus::found ? critical.values() : std::vector<double>();
    for (std::size_t index = 1; index < names.size(); ++index) {
        const Cell value = index - 1 < critical.other.size() ? value_or_status(critical.other[index - 1])
                           : !values.empty()                 ? Cell(values[index])
                                                             : Cell("none");
        append(names[index].name, names[index].meaning, dimension, value, false);
    }
    if (other_path && !other_path->stands) {
        analysis.warnings.push_back("with all loads at once the blocks fail at " +
                                    value_in_words(other_path->value, dimension) +
                                    ", at which they stand after they were consolidated: the value found depends on "
                                    "the loading path; critical.paths = \"all\" tells how much");
    } else if (critical.consolidated_at && plan.is_ratio() && *critical.consolidated_at != 1 && plan.lower <= 1 &&
               plan.upper >= 1 && !other_path) {
        analysis.warnings.push_back(
            "the blocks do not stand, or not soon, as the case has them: they were consolidated at a factor of " +
            number_in_words(*critical.consolidated_at) +
            ", on which the value found may depend; critical.paths = \"all\" tells how much");
    }
    const auto is_later = [](const Removal& removal) { return removal.time >= 0; };
    if (plan.path.size() == 1 && critical.path == LoadingPath::consolidated &&
        std::ranges::any_of(answer.run.scene.removal, is_later)) {
        analysis.warnings.emplace_back(
            "the value is that after all stages of excavation; critical.path = \"stages\" "
            "also counts what fails before them");
    }
    if (answer.fails_if_softer) {
        analysis.warnings.push_back("with joints of a tenth of their stiffness the blocks fail at " +
                                    value_in_words(*answer.fails_if_softer, dimension) +
                                    " already, and perhaps far below: what holds them depends on a stiffness that is "
                                    "seldom known");
    }
}

std::string search_in_words(const CriticalPlan& plan, const CriticalAnswer& critical) {
    if (critical.status != CriticalStatus::found) {
        return path_in_words(plan, critical);
    }
    for (const PathValue& other : critical.other) {
        if (other.status != CriticalStatus::found) {
            return "on the path " + std::string(word_of(other.path)) + ' ' + path_in_words(plan, other);
        }
    }
    return {};
}

void append_critical_figures(const CriticalPlan& plan, const CriticalAnswer& critical, const Sheet& sheet) {
    sheet.add(Heading{capitalised(human_name(name_of_critical(plan.parameter)))});
    append_paths(plan, critical, sheet);
    append_failure(plan, critical, sheet);
    for (const PathValue& other : critical.other) {
        append_failure(plan, other, sheet);
    }
}

}  // namespace delabole
