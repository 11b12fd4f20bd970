#include "cases/program/results/sensitivity_problem_of_case.hpp"

#include "cases/program/results/analysis.hpp"

namespace delabole {

namespace {

// The key itself, or the nearest section around it that the case has.
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
