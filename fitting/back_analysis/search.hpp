// The problem and its work that every step of a back-analysis takes.
#pragma once

#include "fitting/mechanism/misfit.hpp"
#include "fitting/mechanism/surrogate.hpp"
#include "fitting/search/minimise.hpp"
#include "fitting/search/share.hpp"
#include "fitting/work/progress.hpp"

#include <span>

namespace delabole {

struct Search {
    const Misfit& misfit;
    ProgressMeter& progress;
    StopFlag stop = nullptr;
    const Surrogate* surrogate = nullptr;  // asked in place of a costly model

    bool stopped() const { return stop_requested(stop); }

    Workers workers() const {
        const FitSettings& settings = misfit.problem().settings;
        return {settings.threads, settings.ranks};
    }

    Evaluation evaluate(std::span<const double> parameters, Priors priors) const {
        progress.count();
        return surrogate != nullptr ? surrogate->value(parameters, priors) : misfit.value(parameters, priors);
    }

    Residuals residuals(std::span<const double> parameters) const {
        progress.count();
        return surrogate != nullptr ? surrogate->residuals(parameters) : misfit.residuals(parameters);
    }

    // The same, entered in an account.
    Evaluation evaluate(std::span<const double> parameters, Priors priors, EvaluationCount& account) const {
        const Evaluation evaluation = evaluate(parameters, priors);
        account.record(evaluation);
        return evaluation;
    }

    Objective objective(Priors priors) const {
        return [this, priors](std::span<const double> parameters) { return evaluate(parameters, priors); };
    }
};

}  // namespace delabole
