#include "fitting/back_analysis/back_analysis.hpp"

#include "fitting/back_analysis/check_problem.hpp"
#include "fitting/back_analysis/steps.hpp"
#include "fitting/back_analysis/verdict.hpp"
#include "fitting/mechanism/costly_runs.hpp"
#include "fitting/mechanism/misfit.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace delabole {

namespace {

// Number of evaluations to expect, used only for the progress report.
struct Expected {
    long starts = 0;
    long profiles = 0;
    long loci = 0;
    long map = 0;
    long runs = 0;

    long total() const { return runs + starts + profiles + loci + map; }
};

Expected expected_evaluations(const Mechanism& mechanism, const FitSettings& settings) {
    const auto count = static_cast<long>(mechanism.parameters.size());
    const long usual_start = std::min(settings.evaluations_per_start, 150);
    Expected expected;
    expected.starts = count == 0 ? 1
                                 : (is_global(settings.algorithm) ? settings.evaluations_per_start : usual_start) *
                                       static_cast<long>(settings.starts);
    expected.profiles = 2 * count * (settings.profile_points + 12) * (count > 1 ? 12 * count : 2);
    expected.loci = mechanism.model.costly ? 0 : count * (count - 1) / 2 * settings.map_points * 24;
    expected.runs = mechanism.model.costly ? settings.surrogate.runs * weight_of_run : 0;
    expected.map = count < 2 ? 0 : static_cast<long>(settings.map_points) * settings.map_points;
    return expected;
}

FitStatus status_of(MinimiseStatus status) {
    switch (status) {
    case MinimiseStatus::converged:
    case MinimiseStatus::roundoff_limited:
        return FitStatus::converged;
    case MinimiseStatus::evaluation_limit:
    case MinimiseStatus::algorithm_failure:
        return FitStatus::evaluation_limit;
    case MinimiseStatus::interrupted:
        return FitStatus::interrupted;
    case MinimiseStatus::no_valid_point:
        break;
    }
    return FitStatus::no_valid_point;
}

// The least misfit of the data alone may lie elsewhere than that of data and priors together.
std::vector<ProfileLikelihood> profiles_of_data(const Search& search, const MechanismFit& fit,
                                                EvaluationCount& account) {
    std::vector<std::vector<double>> starts = {fit.best};
    constexpr std::size_t further_minima = 3;
    for (std::size_t index = 1; index < fit.minima.size() && index <= further_minima; ++index) {
        starts.push_back(fit.minima[index].parameters);
    }
    MinimiseResult best = polish_best_of(search, Priors::ignored, starts);
    std::vector<ProfileLikelihood> profiles = trace_profiles(search, Priors::ignored, fit.minima, best);
    account.add(best.evaluations);
    return profiles;
}

void add_profiles(const Search& search, MultiStartResult& found, MechanismFit& fit) {
    MinimiseResult& best = found.best;
    fit.profiles = trace_profiles(search, Priors::counted, found.minima, best);
    fit.minima = found.minima;
    if (best.value < fit.minima.front().misfit) {
        add_minimum(fit.minima, best.point, best.value, search.misfit.bounds());
    }
    fit.best = best.point;
    std::vector<ProfileLikelihood> data_only;
    if (search.misfit.has_priors()) {
        data_only = profiles_of_data(search, fit, fit.evaluations);
    } else {
        data_only = fit.profiles;
        for (ProfileLikelihood& profile : data_only) {
            profile.with_priors = false;
        }
    }
    fit.profiles.insert(fit.profiles.end(), data_only.begin(), data_only.end());
}

// Leaves the names of parameters with which this one can be exchanged; an end at one of their bounds is no evidence.
void judge_bounds(ProfileLikelihood& profile, const std::vector<std::string>& exchangeable) {
    const auto among = [&](const std::string& name) {
        return std::ranges::find(exchangeable, name) != exchangeable.end();
    };
    const bool own = !profile.with_priors && among(profile.parameter);
    for (std::vector<std::string>* names : {&profile.lower_bounded_by, &profile.upper_bounded_by}) {
        std::erase_if(*names, [&](const std::string& name) { return !own || !among(name); });
    }
    const Determination is = profile.determination;
    const bool lower = is == Determination::determined || is == Determination::bounded_below;
    const bool upper = is == Determination::determined || is == Determination::bounded_above;
    profile.determination =
        determination_of(lower && profile.lower_bounded_by.empty(), upper && profile.upper_bounded_by.empty());
}

void analyse_best(const Search& search, const Expected& expected, double scatter, MultiStartResult& found,
                  MechanismFit& fit) {
    search.progress.begin_stage(fit.name, "profiles", expected.profiles);
    add_profiles(search, found, fit);
    if (!search.stopped()) {
        fit.identifiability = identify(search, fit.best, fit.evaluations, scatter);
        const std::vector<std::string> combined = exchangeable(fit.identifiability);
        for (ProfileLikelihood& profile : fit.profiles) {
            judge_bounds(profile, combined);
        }
        fit.identifiability.verdict += doubt_from_profiles(fit.identifiability, fit.profiles);
        for (ProfileLikelihood& profile : fit.profiles) {
            if (profile.determination != Determination::undetermined &&
                in_doubt(fit.identifiability, profile.parameter)) {
                profile.determination = Determination::doubtful;
            }
        }
    }
    search.progress.begin_stage(fit.name, "failure loci", expected.loci);
    if (!search.stopped()) {
        fit.loci = trace_failure_loci(search, fit.best, fit.evaluations);
    }
    search.progress.begin_stage(fit.name, "map", expected.map);
    if (!search.stopped()) {
        fit.map = map_misfit(search, fit.best, found.best.value, fit.evaluations);
    }
}

SurrogateFit account_of(const CostlyRuns& costly) {
    const Surrogate::Check check = costly.surrogate->leave_one_out();
    SurrogateFit account{{},
                         costly.coarse_evaluations.total,
                         costly.surrogate->components(),
                         check.error,
                         check.within_95,
                         costly.surrogate->scatter(),
                         costly.evidence_error,
                         costly.given_up};
    for (const KnownRun& run : costly.runs) {
        account.runs.push_back(
            {run.parameters, data_misfit(run.residuals), std::string(run.residuals.failure), run.coarse});
    }
    return account;
}

Mechanism coarse_of(Mechanism mechanism) {
    mechanism.model = mechanism.coarse.value_or(mechanism.model);
    return mechanism;
}

// `misfit` has to outlive `costly`, whose surrogate refers to it.
MechanismFit fit_mechanism(const Mechanism& mechanism, const FitProblem& problem, const Misfit& misfit,
                           double log_evidence_to_beat, CostlyRuns& costly, ProgressMeter& progress, StopFlag stop) {
    const Expected expected = expected_evaluations(mechanism, problem.settings);
    MechanismFit fit;
    fit.name = mechanism.name;
    fit.title = mechanism.title;
    fit.parameters = mechanism.parameters;
    fit.dimensions = misfit.dimensions();

    const bool by_surrogate = mechanism.model.costly && !misfit.free_parameters().empty();
    if (by_surrogate) {
        progress.begin_stage(mechanism.name, "runs", expected.runs);
        const Mechanism cheaper = coarse_of(mechanism);
        const auto coarse = mechanism.coarse ? std::make_unique<Misfit>(cheaper, problem) : nullptr;
        costly = make_costly_runs(misfit, coarse.get(), problem.settings.surrogate, problem.settings.seed,
                                  log_evidence_to_beat + 2 * misfit.missing_count() - misfit.log_own_precision(),
                                  {problem.settings.threads, problem.settings.ranks}, progress, stop);
        if (!costly.surrogate) {
            fit.evaluations = costly.evaluations;
            fit.status = costly.stopped ? FitStatus::interrupted : FitStatus::no_valid_point;
            summarise(misfit, nullptr, false, fit);
            return fit;
        }
    }
    const Search search{misfit, progress, stop, costly.surrogate.get()};
    const std::optional<Jump> jump = by_surrogate ? steepest_jump(costly) : std::nullopt;

    progress.begin_stage(mechanism.name, "starts", expected.starts);
    MultiStartResult found = search_from_many_starts(search, Priors::counted);
    const bool valid = found.best.found();
    if (valid) {
        fit.minima = found.minima;
        fit.best = found.best.point;
        // A surrogate may mistake a jump for scatter, so its scatter is not used if there is one.
        analyse_best(search, expected, by_surrogate && !jump ? costly.surrogate->scatter() : 0, found, fit);
    }
    fit.status = search.stopped() ? FitStatus::interrupted : status_of(found.best.status);
    fit.evaluations.add(found.best.evaluations);
    if (by_surrogate) {
        // Surrogate calls are not counted as model evaluations.
        fit.evaluations = costly.evaluations;
        fit.surrogate = account_of(costly);
        fit.surrogate->jump = jump;
    }
    summarise(misfit, costly.surrogate.get(), valid, fit);
    return fit;
}

void add_posterior(const FitProblem& problem, std::size_t mechanism, const CostlyRuns& costly, ProgressMeter& progress,
                   StopFlag stop, MechanismFit& fit) {
    progress.begin_stage(fit.name, "posterior", expected_posterior_evaluations(problem, mechanism));
    const bool by_surrogate = costly.surrogate != nullptr;
    fit.posterior = study_posterior(problem, mechanism, by_surrogate ? &costly : nullptr, progress, stop);
    fit.posterior->missing_field_evidence = static_cast<int>(problem.evidence.size() - fit.explained.size());
    fit.posterior->least_misfit = std::min(fit.posterior->least_misfit, fit.data_misfit);
    if (costly.runs.empty()) {
        fit.evaluations.add(fit.posterior->posterior.evaluations);
        for (const VariantEvidence& variant : fit.posterior->evidences) {
            fit.evaluations.add(variant.evidence.evaluations);
        }
    }
    if (fit.posterior->posterior.status == PosteriorStatus::interrupted) {
        fit.status = FitStatus::interrupted;
        fit.posterior.reset();
    }
}

// Evidence above which a costly mechanism deserves more runs; -infinity if no other mechanism has been sampled.
double log_evidence_to_beat(const FitProblem& problem, const FitResult& result) {
    double best = -std::numeric_limits<double>::infinity();
    for (const MechanismFit& fit : result.mechanisms) {
        best = fit.posterior ? std::max(best, fit.posterior->log_evidence()) : best;
    }
    return best + std::log(problem.settings.surrogate.give_up_below);
}

bool have_evidence(const FitResult& result) {
    return std::all_of(result.mechanisms.begin(), result.mechanisms.end(),
                       [](const MechanismFit& fit) { return fit.posterior.has_value(); });
}

void rank(FitResult& result) {
    if (have_evidence(result)) {
        std::stable_sort(result.mechanisms.begin(), result.mechanisms.end(), [](const auto& left, const auto& right) {
            return left.posterior->log_evidence() > right.posterior->log_evidence();
        });
    } else {
        std::stable_sort(result.mechanisms.begin(), result.mechanisms.end(),
                         [](const auto& left, const auto& right) { return left.ranking_score < right.ranking_score; });
    }
}

}  // namespace

FitResult fit(const FitProblem& problem, const FitProgressCallback& progress, StopFlag stop) {
    const auto started = std::chrono::steady_clock::now();
    std::string faults;
    for (const std::string& fault : check_problem(problem)) {
        faults += (faults.empty() ? "" : "\n") + fault;
    }
    if (!faults.empty()) {
        throw std::invalid_argument(faults);
    }
    long expected = 0;
    for (const Mechanism& mechanism : problem.mechanisms) {
        expected += expected_evaluations(mechanism, problem.settings).total();
    }
    for (std::size_t index = 0; problem.posterior && index < problem.mechanisms.size(); ++index) {
        expected += expected_posterior_evaluations(problem, index);
    }
    ProgressMeter meter(progress, expected);
    FitResult result;
    result.mechanisms.resize(problem.mechanisms.size());
    std::vector<std::unique_ptr<Misfit>> misfits(problem.mechanisms.size());
    std::vector<CostlyRuns> runs(problem.mechanisms.size());
    for (const bool costly : {false, true}) {
        const double to_beat = log_evidence_to_beat(problem, result);
        for (std::size_t index = 0; index < problem.mechanisms.size(); ++index) {
            const Mechanism& mechanism = problem.mechanisms[index];
            if (mechanism.model.costly == costly) {
                misfits[index] = std::make_unique<Misfit>(mechanism, problem);
                result.mechanisms[index] =
                    fit_mechanism(mechanism, problem, *misfits[index], to_beat, runs[index], meter, stop);
            }
        }
        for (std::size_t index = 0; problem.posterior && index < problem.mechanisms.size(); ++index) {
            if (problem.mechanisms[index].model.costly == costly && !stop_requested(stop)) {
                add_posterior(problem, index, runs[index], meter, stop, result.mechanisms[index]);
            }
        }
    }
    meter.finish();
    rank(result);
    result.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return result;
}

}  // namespace delabole
