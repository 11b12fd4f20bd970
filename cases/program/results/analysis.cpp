#include "cases/program/results/analysis.hpp"

#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

namespace delabole {

namespace {

template <class Study>
const AnswerTo<Study>& own_answer(const Study&, const CaseAnswer& answer) {
    return std::get<AnswerTo<Study>>(answer);
}

std::string factor_or_infinite(double factor_of_safety) {
    return std::isinf(factor_of_safety) ? "infinite" : number_in_words(factor_of_safety);
}

void append_required_value(Analysis& analysis, const std::string& parameter, double target, const Required& required) {
    const std::string name = "required." + parameter;
    const std::string meaning = parameter + " at a factor of safety of " + number_in_words(target);
    switch (required.status) {
    case RequiredStatus::several:
        analysis.warnings.push_back(name + ": several values give this factor of safety; the smallest is shown");
        [[fallthrough]];
    case RequiredStatus::found:
        analysis.outputs.push_back({name, meaning, required.dimension, required.value});
        if (required.jump) {
            analysis.warnings.push_back(name + ": the factor of safety also jumps over it, at " +
                                        value_in_words(*required.jump, required.dimension));
        }
        break;
    case RequiredStatus::never_reached:
        analysis.outputs.push_back({name, meaning, required.dimension, std::string("never_reached")});
        analysis.warnings.push_back(
            name +
            (required.jump ? ": the factor of safety jumps over it at " +
                                 value_in_words(*required.jump, required.dimension) + ", and lies between "
                           : ": the factor of safety stays between ") +
            factor_or_infinite(required.lowest_factor_of_safety) + " and " +
            factor_or_infinite(required.highest_factor_of_safety) + " over the allowed range of " + parameter +
            ": ask for less, or change another input as well");
        break;
    case RequiredStatus::always_exceeded:
        analysis.outputs.push_back({name, meaning, required.dimension, std::string("always_exceeded")});
        analysis.warnings.push_back(name + ": the factor of safety is at least " +
                                    factor_or_infinite(required.lowest_factor_of_safety) +
                                    " whatever its value: nothing is required of it");
        break;
    case RequiredStatus::unknown_parameter:
        throw std::invalid_argument("required: the case has no input '" + parameter + "'");
    }
}

}  // namespace

const NamedOutput* Analysis::find(std::string_view name) const {
    const auto found =
        std::find_if(outputs.begin(), outputs.end(), [&](const NamedOutput& output) { return output.name == name; });
    return found == outputs.end() ? nullptr : &*found;
}

void mark_none(Analysis& analysis, std::string_view prefix) {
    for (NamedOutput& output : analysis.outputs) {
        if (output.name.starts_with(prefix)) {
            output.value = "none";
            output.detail = true;
        }
    }
}

namespace {

// Words about a left side of the outline that nothing supports although the slope seems to continue there; empty if
// there is no such side.
std::string free_side_in_words(const RelaxationSlope& slope) {
    if (slope.frame && slope.frame->sides == FrameSides::all_around) {
        return {};
    }
    const std::vector<SectionPoint>& outline = slope.geometry.outline;
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    double top = right;
    for (const SectionPoint& point : outline) {
        left = std::min(left, point.x);
        right = std::max(right, point.x);
        top = std::max(top, point.y);
    }
    constexpr double rounding = 1e-9;  // of the section's width
    const double at_left = left + rounding * (right - left);
    for (std::size_t index = 0; index < outline.size(); ++index) {
        const SectionPoint& from = outline[index];
        const SectionPoint& to = outline[(index + 1) % outline.size()];
        const double higher = std::max(from.y, to.y);
        if (from.x <= at_left && to.x <= at_left && higher != std::min(from.y, to.y) && higher < top) {
            return "nothing holds the left side of scene.outline, below " + value_in_words(higher, Dimension::length) +
                   " at x = " + value_in_words(left, Dimension::length) +
                   ": blocks may slide out there; scene.frame.sides = \"all_around\" puts fixed rock in front of it";
        }
    }
    return {};
}

}  // namespace

std::vector<std::string> questions_about(const CaseModel& model) {
    std::vector<std::string> questions;
    const auto ask = [&](const std::string& key, double height) {
        constexpr double highest = 5000;  // m; greater than the height of any mountain above its foot
        if (height > highest) {
            questions.push_back(key + " is " + value_in_words(height, Dimension::length) + " high: is that meant?");
        }
    };
    // Rock and water lie well within these; units were mistaken by a thousand where a value does not.
    constexpr Interval densities = within(100, 30e3);        // kg/m3
    constexpr Interval unit_weights = within(0.9e3, 300e3);  // N/m3
    bool asked_of_weight = false;
    for (const Quantity& input : named_inputs(model)) {
        if (input.name == "slope.height" || input.name == "scene.slope.height") {
            ask(input.name, input.value);
        }
        const bool is_odd = (input.dimension == Dimension::density && !densities.contains(input.value)) ||
                            (input.dimension == Dimension::unit_weight && !unit_weights.contains(input.value));
        if (is_odd && !std::exchange(asked_of_weight, true)) {
            questions.push_back(input.name + " is " + value_in_words(input.value, input.dimension) +
                                ": is that meant?");
        }
    }
    const auto* relaxation = std::get_if<RelaxationStudy>(&model);
    const auto* slope = relaxation != nullptr ? std::get_if<RelaxationSlope>(&relaxation->model.scene) : nullptr;
    if (slope != nullptr && !slope->geometry.outline.empty()) {
        const auto [lowest, highest] = std::ranges::minmax(slope->geometry.outline, {}, &SectionPoint::y);
        ask("scene.outline", highest.y - lowest.y);
        if (std::string side = free_side_in_words(*slope); !side.empty()) {
            questions.push_back(std::move(side));
        }
    }
    return questions;
}

void append_required_values(Analysis& analysis, const std::vector<RequiredValue<>>& requests,
                            const std::vector<Required>& values) {
    for (std::size_t index = 0; index < requests.size(); ++index) {
        append_required_value(analysis, requests[index].parameter, requests[index].factor_of_safety, values[index]);
    }
}

void append_support(Analysis& analysis, const std::vector<std::vector<BoltRow>>& patterns) {
    for (std::size_t index = 0; index < patterns.size(); ++index) {
        const std::string pattern = indexed("support", index);
        double force = 0;
        std::size_t idle = 0;
        for (const BoltRow& row : patterns[index]) {
            force += row.force;
            idle += row.force > 0 ? 0 : 1;
        }
        analysis.outputs.push_back(
            {pattern + ".force", "what its rows hold together", Dimension::force_per_length, force});
        if (idle > 0) {
            analysis.warnings.push_back(pattern + ": " + std::to_string(idle) + " of " +
                                        std::to_string(patterns[index].size()) +
                                        " rows hold nothing, for their bolts do not reach the rock that stays, or do "
                                        "not cross what moves: make them longer, or put them elsewhere");
        }
    }
}

std::string factor_in_words(double factor_of_safety) {
    std::string number = number_in_words(factor_of_safety);
    for (int digits = 4; number == "1" && factor_of_safety != 1; ++digits) {
        number = human_number(factor_of_safety, digits);
    }
    return "FS " + number;
}

std::string required_in_words(const RequiredValue<>& request, const Required& required) {
    const std::string factor = factor_in_words(request.factor_of_safety);
    // "bolt[1].force" is the force of bolt 1, "strength.cohesion" the cohesion.
    const auto spoken = [](const std::string& name) {
        const std::size_t bracket = name.find('[');
        const std::string one = "the " + human_name(name.substr(name.rfind('.') + 1));
        return bracket == std::string::npos ? one
                                            : one + " of " + human_name(name.substr(0, bracket)) + " " +
                                                  name.substr(bracket + 1, name.find(']') - bracket - 1);
    };
    std::vector<std::string> inputs{spoken(request.parameter)};
    std::ranges::transform(request.also, std::back_inserter(inputs), spoken);
    const std::string parameter = list_in_words(inputs);
    switch (required.status) {
    case RequiredStatus::found:
    case RequiredStatus::several:
        return "For " + factor + " " + parameter + (inputs.size() == 1 ? " has" : " have") + " to be " +
               (required.status == RequiredStatus::several || required.jump ? ""
                : required.rises                                            ? "at least "
                                                                            : "at most ") +
               value_in_words(required.value, required.dimension) + ".";
    case RequiredStatus::never_reached:
        return required.jump ? "With " + parameter + " at " + value_in_words(*required.jump, required.dimension) +
                                   " the factor of safety jumps over " + number_in_words(request.factor_of_safety) + "."
                             : "No value of " + parameter + " gives " + factor + ".";
    case RequiredStatus::always_exceeded:
        return factor + " is exceeded whatever " + parameter + " is.";
    case RequiredStatus::unknown_parameter:
        break;
    }
    return {};
}

CaseModel with_conditions(const CaseModel& model, const std::vector<Condition>& conditions) {
    CaseModel changed = model;
    for (const Condition& condition : conditions) {
        bool found = false;
        std::visit(
            [&](auto& parameters) {
                for_each_named_number(parameters, [&](const std::string& path, const FieldInfo&, double& value) {
                    if (path == condition.input) {
                        value = condition.value;
                        found = true;
                    }
                });
            },
            changed);
        if (!found) {
            throw std::invalid_argument("the case has no input '" + condition.input + "'");
        }
    }
    return changed;
}

ModelInterface interface_of(const CaseModel& model) {
    return std::visit([](const auto& parameters) { return model_interface(parameters); }, model);
}

CaseAnswer analyse_case(const CaseModel& model, const AnalysisWork& work) {
    return std::visit([&](const auto& study) -> CaseAnswer { return analyse_case(study, work); }, model);
}

Analysis named_outputs(const CaseModel& model, const CaseAnswer& answer) {
    Analysis analysis = std::visit(
        [&](const auto& study) {
            const auto& own = own_answer(study, answer);
            Analysis without_answer;
            without_answer.failure = failure_in(own);
            return without_answer.failure.empty() ? named_outputs(study, own) : without_answer;
        },
        model);
    std::ranges::move(questions_about(model), std::back_inserter(analysis.warnings));
    return analysis;
}

HeadCard head_card(const CaseModel& model, const CaseAnswer& answer) {
    return std::visit([&](const auto& study) { return head_card(study, own_answer(study, answer)); }, model);
}

void append_case_figures(const CaseModel& model, const CaseAnswer& answer, const Sheet& sheet,
                         const InputDeviations& known) {
    std::visit(
        [&](const auto& study) {
            const auto& own = own_answer(study, answer);
            using Study = std::remove_cvref_t<decltype(study)>;
            if constexpr (std::is_same_v<Study, PlaneFailureStudy<>> || std::is_same_v<Study, SteppedBaseStudy<>> ||
                          std::is_same_v<Study, WedgeFailureStudy>) {
                append_case_figures(study, own, sheet, known);
            } else {
                append_case_figures(study, own, sheet);
            }
        },
        model);
}

std::optional<CaseFigure> first_case_figure(const CaseModel& model, const CaseAnswer& answer) {
    struct Found {
        CaseFigure first;
    };
    const ResultFolder taken([](const Figure& figure, const std::string& caption) { throw Found{{figure, caption}}; });
    Report ignored;
    try {
        append_case_figures(model, answer, {taken, ignored});
    } catch (Found& found) {
        return std::move(found.first);
    }
    return std::nullopt;
}

Analysis analyse_model(const CaseModel& model, const AnalysisWork& work) {
    return named_outputs(model, analyse_case(model, work));
}

std::string failure_of(const CaseModel& model) {
    if (const auto* study = std::get_if<RelaxationStudy>(&model)) {
        const SceneFault fault = check(*study);
        return fault.check == SceneCheck::valid ? "" : std::string(word_of(fault.check));
    }
    // Inputs that are solved for do not decide whether there is a result, and may take a hundred times as long.
    CaseModel bare = model;
    std::visit(
        [](auto& study) {
            if constexpr (requires { study.required; }) {
                study.required.clear();
            }
        },
        bare);
    return std::visit([](const auto& answer) { return failure_in(answer); }, analyse_case(bare));
}

}  // namespace delabole
