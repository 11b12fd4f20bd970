#include "cases/program/results/fit_problem_of_case.hpp"

#include "cases/program/results/analysis.hpp"
#include "fitting/back_analysis/check_problem.hpp"

#include <utility>

namespace delabole {

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

}  // namespace delabole
