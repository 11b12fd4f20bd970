#include "cases/program/results/problems_of_case.hpp"

#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/data_table.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"
#include "cases/program/terminal/options.hpp"
#include "fitting/back_analysis/check_problem.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

namespace delabole {

void require_section(bool given, const CaseFile& file, const std::string& section) {
    if (!given) {
        throw CaseError({problem_at(
            file, section, "the case has no [" + section + "] section; delabole init " + section + " shows one")});
    }
}

FitProblem fit_problem_of(const CaseFile& file, int threads, std::optional<std::uint64_t> seed) {
    const CaseFit& fit = *file.fit;
    FitProblem problem{fit, {}};
    problem.settings.threads = threads;
    problem.settings.seed = seed.value_or(fit.settings.seed);
    for (const FitMechanism& mechanism : fit.mechanisms) {
        Mechanism& made = problem.mechanisms.emplace_back(Mechanism{mechanism, interface_of(mechanism.model)});
        if (mechanism.coarse) {
            made.coarse = interface_of(*mechanism.coarse);
        }
    }
    std::vector<Problem> problems;
    for (const std::string& sentence : check_problem(problem)) {
        problems.push_back(problem_at(file, "fit", sentence));
    }
    if (!problems.empty()) {
        throw CaseError(std::move(problems));
    }
    return problem;
}

std::vector<std::string> leave_out_costly(CaseFit& fit) {
    std::vector<FitMechanism> others;
    std::vector<std::string> names;
    for (const FitMechanism& mechanism : fit.mechanisms) {
        if (interface_of(mechanism.model).costly) {
            names.push_back(mechanism.name);
        } else {
            others.push_back(mechanism);
        }
    }
    if (others.empty()) {
        return {};
    }
    fit.mechanisms = std::move(others);
    return names;
}

void leave_mechanisms(CaseFit& fit, const std::vector<std::string>& names) {
    std::vector<std::string> known;
    for (const FitMechanism& mechanism : fit.mechanisms) {
        known.push_back(mechanism.name);
    }
    for (const std::string& name : names) {
        if (std::ranges::find(known, name) == known.end()) {
            throw UsageError("the case has no mechanism '" + name + "'" + suggestion(name, known) + "; there are " +
                             list_in_words(known));
        }
    }
    std::erase_if(fit.mechanisms, [&](const FitMechanism& mechanism) {
        return std::ranges::find(names, mechanism.name) == names.end();
    });
}

namespace {

// The key itself if the case has it, otherwise the nearest section around it that the case has.
std::string written_key(const CaseFile& file, std::string key) {
    while (!file.places.contains(key) && key.find('.') != std::string::npos) {
        key.erase(key.rfind('.'));
    }
    return key;
}

}  // namespace

SensitivityProblem sensitivity_problem_of(const CaseFile& file, int threads, std::optional<std::uint64_t> seed) {
    SensitivityProblem problem{interface_of(file.model), *file.sensitivity, threads};
    problem.study.seed = seed.value_or(problem.study.seed);
    std::vector<Problem> problems;
    for (const StudyFault& fault : check_study(problem)) {
        const std::string key = "sensitivity" + (fault.key.empty() ? "" : "." + fault.key);
        problems.push_back(problem_at(file, written_key(file, key), fault.message));
    }
    if (!problems.empty()) {
        throw CaseError(std::move(problems));
    }
    return problem;
}

namespace {

struct StatedImpossibility {
    std::string model;
    std::string check;
    std::string keys;  // separated by blanks
    std::string words;
    static constexpr auto fields() {
        using S = StatedImpossibility;
        return FieldTable{section<&S::model>("word of the model"), section<&S::check>("name of the check that failed"),
                          with_default(section<&S::keys>("keys that may be to blame")),
                          section<&S::words>("what is wrong")};
    }
};

}  // namespace

Impossibility stated_impossibility(std::string_view model, std::string_view failure) {
    static const auto all = parse_table<StatedImpossibility>(impossible_cases, "impossible_cases.csv");
    const auto found = std::ranges::find_if(
        all, [&](const StatedImpossibility& one) { return one.model == model && one.check == failure; });
    if (found == all.end()) {
        return {{}, "a number is outside its allowed range"};
    }
    std::istringstream keys(found->keys);
    return {{std::istream_iterator<std::string>(keys), {}}, found->words};
}

Problem impossible(const CaseFile& file, std::string_view failure) {
    return std::visit(
        [&](const auto& parameters) {
            const Impossibility found = impossibility(parameters, failure);
            const std::vector<std::string>& keys = found.keys;
            const auto blamed =
                std::ranges::find_if(keys, [&](const std::string& key) { return file.places.contains(key); });
            if (blamed == keys.end()) {
                return problem_at(file, keys.empty() ? "" : keys.front(), found.words);
            }
            const std::string limit = found.limit ? found.limit(*blamed) : "";
            return problem_at(file, *blamed, limit.empty() ? found.words : limit);
        },
        file.model);
}

void refuse_impossible(const CaseFile& file) {
    const std::string failure = failure_of(file.model);
    if (!failure.empty()) {
        throw CaseError({impossible(file, failure)});
    }
    if (file.fit) {
        fit_problem_of(file, 1, std::nullopt);
    }
    if (file.sensitivity) {
        sensitivity_problem_of(file, 1, std::nullopt);
    }
}

}  // namespace delabole
