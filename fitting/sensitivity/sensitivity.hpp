// A sensitivity study, from the cheapest method to the dearest.
#pragma once

#include "fitting/sensitivity/sensitivity_problem.hpp"
#include "fitting/work/progress.hpp"

#include <optional>
#include <vector>

namespace delabole {

enum class SensitivityStatus {
    finished,
    interrupted,    // what was finished is given
    no_answer,      // some method found no value of the quantity anywhere
    not_converged,  // the search for the design point
};

struct SensitivityResult {
    SensitivityStatus status = SensitivityStatus::finished;
    std::optional<TornadoResult> tornado;
    std::vector<SweepResult> sweeps;  // of the quantity, then of the further ones, each with its evaluations
    std::optional<MorrisResult> morris;
    std::optional<SobolIndicesResult> sobol_indices;
    std::optional<PropagationResult> propagation;
    std::optional<ReliabilityResult> reliability;
    // Indices of parameters that no method saw move the quantity at all, where one looked at them alone.
    std::vector<std::size_t> without_effect;
    double wall_seconds = 0;
};

// An output as a function of the uncertain parameters. The names have to exist.
Objective quantity_of(const ModelInterface& model, const SensitivityStudy& study, const std::string& name);

// Throws std::invalid_argument for a problem that check_study() refuses. The same numbers for any number of threads.
SensitivityResult sensitivity(const SensitivityProblem& problem, FitProgressCallback progress = {},
                              StopFlag stop = nullptr);

}  // namespace delabole
