// The analysis of one case as names and numbers. Every model has the same few functions, so that verify and the loops
// need not know which model it is. The model's own answer, from which its figures are drawn, is in model_reports.hpp.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "numerics/required_value.hpp"
#include "parameters/model_interface.hpp"
#include "plane_failure/study.hpp"
#include "support/bolt_pattern.hpp"

#include <chrono>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace delabole {

// A number in SI or a word, with the name that it has in [[expect]], JSON and CSV. A quantity without a value keeps its
// name and has a word instead: "infinite" and "-infinite" are values, "none" means that the quantity does not exist,
// and other words tell why no number was found ("never_reached").
struct NamedOutput {
    std::string name;
    std::string meaning;
    Dimension dimension = Dimension::ratio;
    std::variant<double, std::string> value;
    bool detail = false;  // one of many similar outputs: in the result files, but not in the short table of answers
};

struct Analysis {
    std::string failure;  // name of the check that failed; empty if there is an answer
    std::vector<NamedOutput> outputs;
    std::vector<std::string> warnings;
    std::string status = "ok";  // otherwise the word for what ended the work before it had a final answer,
    std::string unfinished;     // and why, in words

    const NamedOutput* find(std::string_view name) const;
};

// Sets every output whose name begins with `prefix` to "none"; these outputs are then details.
void mark_none(Analysis& analysis, std::string_view prefix);

// Questions about values that are possible but probably a mistake, such as a height beyond that of any slope. They are
// among the warnings of an analysis.
std::vector<std::string> questions_about(const CaseModel& model);

// The requested values in order, each computed by the problem's own required_value.
template <class Problem>
std::vector<Required> required_values(const Problem& problem, const std::vector<RequiredValue<>>& requests) {
    std::vector<Required> values;
    for (const RequiredValue<>& request : requests) {
        values.push_back(required_value(problem, request.parameter, request.factor_of_safety, request.also));
    }
    return values;
}

// The values of named inputs at which the factor of safety takes a given value, as "required.<input>".
void append_required_values(Analysis& analysis, const std::vector<RequiredValue<>>& requests,
                            const std::vector<Required>& values);

// Such a value in a sentence.
std::string required_in_words(const RequiredValue<>& request, const Required& required);

// "FS 1.32", in three digits, or in as many more as it takes to tell it from 1: "FS 0.9999" fails.
std::string factor_in_words(double factor_of_safety);

// Appends the force of each pattern of bolts as "support[1].force"; warns of rows that hold nothing.
void append_support(Analysis& analysis, const std::vector<std::vector<BoltRow>>& patterns);

// The model with other values for some named numbers. Throws std::invalid_argument for unknown names.
CaseModel with_conditions(const CaseModel& model, const std::vector<Condition>& conditions);

// Called repeatedly with the share of the work done, 0 to 1, what is being done, and whether a verdict may end the work
// sooner; if it returns false the work ends.
using AnalysisWatch = std::function<bool(double share, const std::string& what, bool may_end_sooner)>;

// How a model is analysed. The answer does not depend on it, unless `watch` ends the work.
struct AnalysisWork {
    AnalysisWatch watch = {};
    std::function<void(const std::string&)> say = {};  // receives messages for the user before the answer
    unsigned threads = 1;
    // File in which long work saves its state and from which it continues; OutputError if the file there belongs to
    // other work. If empty, nothing is saved.
    std::filesystem::path checkpoint = {};
    std::chrono::duration<double> between_checkpoints{60};
};

Analysis analyse_model(const CaseModel& model, const AnalysisWork& work = {});

// Analysis::failure alone, which some models find faster.
std::string failure_of(const CaseModel& model);

// The model in the form that fits, sensitivity studies and other loops use.
ModelInterface interface_of(const CaseModel& model);

// Appends every number, word and text of a described result under its name. Members of lists are details. An empty text
// becomes the word "none".
template <Described Result>
void append_outputs(Analysis& analysis, const Result& result, const std::string& path = {}, bool detail = false) {
    visit_fields(result, [&](const FieldInfo& info, const auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        const std::string name = path + (path.empty() ? "" : ".") + std::string(info.key);
        const auto append = [&](std::variant<double, std::string> value, Dimension dimension = Dimension::ratio) {
            analysis.outputs.push_back({name, std::string(info.meaning), dimension, std::move(value), detail});
        };
        if constexpr (std::is_enum_v<Member>) {
            append(std::string(word_of(member)));
        } else if constexpr (std::same_as<Member, std::string>) {
            append(member.empty() ? std::string("none") : member);
        } else if constexpr (NumberType<Member>) {
            append(static_cast<double>(member), info.dimension);
        } else if constexpr (Described<Member>) {
            append_outputs(analysis, member, name, detail);
        } else if constexpr (is_optional<Member>) {
            if (member) {
                append_outputs(analysis, *member, name, detail);
            }
        } else if constexpr (is_vector<Member>) {
            for (std::size_t index = 0; index < member.size(); ++index) {
                append_outputs(analysis, member[index], name + "[" + std::to_string(index + 1) + "]", true);
            }
        }
    });
}

}  // namespace delabole
