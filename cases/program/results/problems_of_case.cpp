#include "cases/program/results/problems_of_case.hpp"

#include "cases/program/reader/names.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/terminal/options.hpp"
#include "fitting/back_analysis/check_problem.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
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

}  // namespace delabole
