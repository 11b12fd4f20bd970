// A sensitivity study, which runs its methods in order of their cost.
#pragma once

#include "fitting/sensitivity/sensitivity_problem.hpp"
#include "fitting/work/progress.hpp"

#include <optional>
#include <vector>

namespace delabole {

enum class SensitivityStatus {
    finished,
    interrupted,    // the result holds what was finished
    no_answer,      // some method found no value of the quantity anywhere
    not_converged,  // the search for the design point did not converge
};

struct SensitivityResult {
    SensitivityStatus status = SensitivityStatus::finished;
    std::optional<TornadoResult> tornado;
    std::vector<SweepResult> sweeps;  // of the quantity, then of the further quantities, each with its evaluations
    std::optional<MorrisResult> morris;
    std::optional<SobolIndicesResult> sobol_indices;
    std::optional<PropagationResult> propagation;
    std::optional<ReliabilityResult> reliability;
    // Indices of parameters that were varied alone by some method and never changed the quantity.
    std::vector<std::size_t> without_effect;
    double wall_seconds = 0;
};

// An output as a function of the uncertain parameters. The model must have an output of that name and the inputs.
Objective quantity_of(const ModelInterface& model, const SensitivityStudy& study, const std::string& name);

// Throws std::invalid_argument for a problem in which check_study() finds a fault. The result does not depend on the
// number of threads.
SensitivityResult sensitivity(const SensitivityProblem& problem, FitProgressCallback progress = {},
                              StopFlag stop = nullptr);

}  // namespace delabole
