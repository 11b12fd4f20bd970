#include "fitting/mechanism/mechanism_posterior.hpp"

#include "fitting/mechanism/costly_runs.hpp"
#include "fitting/mechanism/input_binding.hpp"
#include "fitting/mechanism/misfit.hpp"
#include "fitting/probability/sampling.hpp"
#include "fitting/search/share.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace delabole {

namespace {

constexpr std::string_view safety = "factor_of_safety";
constexpr std::size_t most_profiles = 200;
constexpr std::size_t most_costly_profiles = 16;

void scale_priors(FitProblem& problem, double factor) {
    for (Mechanism& mechanism : problem.mechanisms) {
        for (FreeParameter& parameter : mechanism.parameters) {
            if (parameter.prior) {
                parameter.prior->standard_deviation *= factor;
            }
        }
    }
}

// Moves all prior means by this number of standard deviations.
void move_prior_means(FitProblem& problem, double deviations) {
    for (Mechanism& mechanism : problem.mechanisms) {
        for (FreeParameter& parameter : mechanism.parameters) {
            if (parameter.prior) {
                parameter.prior->mean += deviations * parameter.prior->standard_deviation;
            }
        }
    }
}

void drop_priors(FitProblem& problem) {
    for (Mechanism& mechanism : problem.mechanisms) {
        for (FreeParameter& parameter : mechanism.parameters) {
            parameter.prior.reset();
        }
    }
}

// Scales the model error also where a mechanism states the same observation in terms of its own.
void scale_model_error(FitProblem& problem, double factor) {
    for (QuantityObservation& observation : problem.observations) {
        if (observation.quantity != safety) {
            continue;
        }
        observation.standard_deviation *= factor;
        for (Mechanism& mechanism : problem.mechanisms) {
            for (QuantityObservation& own : mechanism.own_observations) {
                own.standard_deviation *= own.label == observation.label ? factor : 1;
            }
        }
    }
}

// A surrogate of the same runs for data whose standard deviations differ from those with which the first surrogate was
// made. Priors do not enter a surrogate.
std::unique_ptr<Surrogate> judged_anew(const Misfit& misfit, const CostlyRuns* costly) {
    if (costly == nullptr || misfit.data() == costly->surrogate->misfit().data()) {
        return nullptr;
    }
    return std::make_unique<Surrogate>(misfit, judged_by(misfit, costly->surrogate->misfit(), costly->runs));
}

// Misfit, evaluator and prior of one mechanism under one variant. They refer to each other, so they are kept together.
class Target {
  public:
    Target(const FitProblem& problem, std::size_t mechanism, const CostlyRuns* costly, ProgressMeter& progress,
           StopFlag stop)
        : misfit_(problem.mechanisms[mechanism], problem),
          judged_anew_(judged_anew(misfit_, costly)),
          surrogate_(judged_anew_        ? judged_anew_.get()
                     : costly != nullptr ? costly->surrogate.get()
                                         : nullptr),
          without_runs_(surrogate_ == nullptr && misfit_.mechanism().model.costly &&
                        !misfit_.free_parameters().empty()),
          quantity_([this](std::span<const double> parameters) {
              return without_runs_           ? Evaluation{0, "too_few_runs_have_an_answer"}
                     : surrogate_ != nullptr ? surrogate_->value(parameters, Priors::ignored)
                                             : misfit_.value(parameters, Priors::ignored);
          }),
          bounded_([this](std::span<const double> parameters, double most) {
              return misfit_.value_of_data(parameters, most);
          }),
          evaluator_{quantity_, progress,
                     stop,      problem.settings.threads,
                     nullptr,   surrogate_ == nullptr && !without_runs_ ? &bounded_ : nullptr},
          prior_(problem.mechanisms[mechanism].parameters) {}
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    // Whether a costly model has too few runs with an answer for a surrogate. It is not run any more.
    bool without_runs() const { return without_runs_; }
    const Misfit& misfit() const { return misfit_; }
    const Evaluator& evaluator() const { return evaluator_; }
    const PriorSpace& prior() const { return prior_; }

  private:
    Misfit misfit_;
    std::unique_ptr<Surrogate> judged_anew_;  // refers to the misfit
    const Surrogate* surrogate_;
    bool without_runs_;
    Objective quantity_;
    BoundedObjective bounded_;
    Evaluator evaluator_;
    PriorSpace prior_;
};

PosteriorSettings posterior_settings(const FitProblem& problem) {
    const PosteriorStudy& study = *problem.posterior;
    return {study.chains, study.draws, study.evaluations_per_chain, problem.settings.seed};
}

EvidenceSettings evidence_settings(const FitProblem& problem) {
    EvidenceSettings settings;
    settings.points = problem.posterior->evidence_points;
    settings.seed = problem.settings.seed;
    return settings;
}

// Draws of the posterior as given guide the sampling: of the 21 evidences of the failure of 1967, 16 had smaller
// errors by them than by short chains of their own, which took a sixth of the time of the fit.
Evidence evidence_of_variant(const FitProblem& problem, std::size_t mechanism, const CostlyRuns* costly,
                             EvidenceVariant variant, const std::vector<Draw>& draws, ProgressMeter& progress,
                             StopFlag stop) {
    const FitProblem changed = varied(problem, variant);
    const Target target(changed, mechanism, costly, progress, stop);
    // Half of the points suffices, since only the shift of the evidence matters and not its third digit.
    EvidenceSettings settings = evidence_settings(changed);
    settings.points = std::max(settings.points / 2, 16);
    return estimate_evidence(target.evaluator(), target.prior(), draws, settings);
}

std::vector<Polyline> profiles_of(const Misfit& misfit, const std::vector<Draw>& draws, bool costly,
                                  ProgressMeter& progress, StopFlag stop) {
    const FitSettings& settings = misfit.problem().settings;
    std::vector<Polyline> profiles =
        share_tasks<Polyline>(draws.size(), {settings.threads, settings.ranks}, [&](std::size_t index) {
            Prediction prediction = stop_requested(stop) ? Prediction{} : misfit.predict(draws[index].parameters);
            progress.count(1, costly ? weight_of_run : 1);
            return prediction.failure.empty() ? std::move(prediction.profile) : Polyline();
        });
    std::erase_if(profiles, [](const Polyline& profile) { return profile.empty(); });
    return profiles;
}

// Least distance of each datum, in standard deviations, over draws of the prior; infinite if none has an answer. For a
// costly mechanism its runs replace the draws.
struct Reach {
    std::vector<double> residuals;
    std::vector<std::string> labels;
};

Reach reach_of_priors(const Target& target, std::uint64_t seed) {
    constexpr std::size_t draws = 512;
    Reach reach;
    for (const QuantityObservation& observation : target.misfit().problem().observations) {
        reach.labels.push_back(observation.label);
    }
    reach.labels.emplace_back("post-failure profile");
    reach.residuals.assign(reach.labels.size(), std::numeric_limits<double>::infinity());
    if (target.prior().size() == 0) {
        return reach;
    }
    const SamplePlan plan(SamplingMethod::sobol_sequence, target.prior().size(), draws, 1, seed);
    std::vector<double> normal(target.prior().size());
    std::vector<double> parameters(target.prior().parameters().size());
    for (std::size_t index = 0; index < draws && !target.evaluator().stopped(); ++index) {
        plan.point(index, normal);
        std::transform(normal.begin(), normal.end(), normal.begin(), normal_quantile);
        target.prior().values(normal, parameters);
        const std::vector<ObservationFit> rows = target.misfit().compare(parameters);
        for (std::size_t row = 0; row < rows.size(); ++row) {
            if (rows[row].predicted) {
                reach.residuals[row] = std::min(reach.residuals[row], std::abs(rows[row].residual));
            }
        }
        if (const auto profile = target.misfit().compare_profile(parameters)) {
            reach.residuals.back() = std::min(reach.residuals.back(), profile->residual());
        }
    }
    target.evaluator().progress.count(static_cast<long>(draws));
    return reach;
}

// The samples of a profile share a label and are combined by their root mean square.
Reach reach_of_runs(const Misfit& misfit, const std::vector<KnownRun>& runs) {
    Reach reach;
    std::vector<std::size_t> place;  // of each datum's label
    std::vector<double> data;        // of each label
    for (const Datum& datum : misfit.data()) {
        const auto known = std::ranges::find(reach.labels, datum.label);
        place.push_back(static_cast<std::size_t>(known - reach.labels.begin()));
        if (known == reach.labels.end()) {
            reach.labels.push_back(datum.label);
            data.push_back(0);
        }
        data[place.back()] += datum.share;
    }
    reach.residuals.assign(reach.labels.size(), std::numeric_limits<double>::infinity());
    for (const KnownRun& run : runs) {
        if (run.residuals.values.empty()) {
            continue;
        }
        std::vector<double> squares(reach.labels.size(), 0.0);
        for (std::size_t row = 0; row < run.residuals.values.size(); ++row) {
            const double residual = run.residuals.idle[row] ? 0 : run.residuals.values[row];
            squares[place[row]] += residual * residual;
        }
        for (std::size_t label = 0; label < squares.size(); ++label) {
            reach.residuals[label] = std::min(reach.residuals[label], std::sqrt(squares[label] / data[label]));
        }
    }
    return reach;
}

void warn_of_reach(const Reach& reach, const std::string& tried, std::vector<std::string>& warnings) {
    constexpr double far = 5;
    for (std::size_t row = 0; row < reach.residuals.size(); ++row) {
        if (std::isfinite(reach.residuals[row]) && reach.residuals[row] > far) {
            warnings.push_back("The priors exclude what was observed: of " + tried + " none comes nearer than " +
                               number_in_words(reach.residuals[row]) + " standard deviations to \"" +
                               reach.labels[row] + "\". Priors, standard deviation or mechanism is wrong.");
        }
    }
}

void warn_of_counts(const Target& target, std::vector<std::string>& warnings) {
    const std::size_t parameters = target.prior().size();
    const int data = target.misfit().data_count();
    if (parameters > static_cast<std::size_t>(data)) {
        warnings.push_back("More parameters than data: " + std::to_string(parameters) + " free parameters, " +
                           std::to_string(data) + (data == 1 ? " datum" : " data") +
                           ". What the data leave open is the prior's.");
    }
}

void warn_of_sampling(const MechanismPosterior& result, std::vector<std::string>& warnings) {
    if (result.posterior.status == PosteriorStatus::not_converged) {
        warnings.emplace_back(
            "The chains did not converge (R-hat below 1.01, effective sizes above 400): the intervals are unreliable. "
            "fit.posterior.evaluations_per_chain sets the limit.");
    }
    if (result.posterior.status == PosteriorStatus::no_valid_point) {
        std::string causes;
        for (const auto& [cause, number] : result.posterior.evaluations.failed_by_cause) {
            causes += (causes.empty() ? "" : ", ") + cause + " (" + std::to_string(number) + ")";
        }
        warnings.push_back("No draw of the priors has an answer: " + causes + ".");
    }
}

}  // namespace

std::vector<EvidenceVariant> variants_of(const FitProblem& problem) {
    const bool priors = std::any_of(problem.mechanisms.begin(), problem.mechanisms.end(), [](const Mechanism& one) {
        return std::any_of(one.parameters.begin(), one.parameters.end(),
                           [](const FreeParameter& parameter) { return parameter.prior.has_value(); });
    });
    const bool model_error =
        std::any_of(problem.observations.begin(), problem.observations.end(),
                    [](const QuantityObservation& observation) { return observation.quantity == safety; });
    std::vector<EvidenceVariant> variants = {EvidenceVariant::as_given};
    if (priors) {
        variants.insert(variants.end(),
                        {EvidenceVariant::priors_halved, EvidenceVariant::priors_doubled, EvidenceVariant::priors_flat,
                         EvidenceVariant::prior_means_lower, EvidenceVariant::prior_means_higher});
    }
    if (model_error) {
        variants.insert(variants.end(), {EvidenceVariant::model_error_halved, EvidenceVariant::model_error_doubled});
    }
    return variants;
}

FitProblem varied(const FitProblem& problem, EvidenceVariant variant) {
    FitProblem result = problem;
    switch (variant) {
    case EvidenceVariant::as_given:
        break;
    case EvidenceVariant::priors_halved:
        scale_priors(result, 0.5);
        break;
    case EvidenceVariant::priors_doubled:
        scale_priors(result, 2);
        break;
    case EvidenceVariant::priors_flat:
        drop_priors(result);
        break;
    case EvidenceVariant::prior_means_lower:
        move_prior_means(result, -1);
        break;
    case EvidenceVariant::prior_means_higher:
        move_prior_means(result, 1);
        break;
    case EvidenceVariant::model_error_halved:
        scale_model_error(result, 0.5);
        break;
    case EvidenceVariant::model_error_doubled:
        scale_model_error(result, 2);
        break;
    }
    return result;
}

MechanismPosterior study_posterior(const FitProblem& problem, std::size_t mechanism, const CostlyRuns* costly,
                                   ProgressMeter& progress, StopFlag stop) {
    const Target target(problem, mechanism, costly, progress, stop);
    const PosteriorSettings settings = posterior_settings(problem);
    MechanismPosterior result;
    result.missing_data = target.misfit().missing_count();
    result.log_own_precision = target.misfit().log_own_precision();
    result.posterior = sample_posterior(target.evaluator(), target.prior(), settings);
    for (const EvidenceVariant variant : variants_of(problem)) {
        const Evidence evidence =
            target.without_runs() && !result.evidences.empty() ? result.evidence()
            : variant == EvidenceVariant::as_given
                ? estimate_evidence(target.evaluator(), target.prior(), result.posterior.draws,
                                    evidence_settings(problem))
                : evidence_of_variant(problem, mechanism, costly, variant, result.posterior.draws, progress, stop);
        result.evidences.push_back({variant, evidence});
    }
    const Evidence& evidence = result.evidence();
    result.least_misfit =
        evidence.status == EvidenceStatus::estimated ? evidence.least_misfit : std::numeric_limits<double>::infinity();
    for (const Draw& draw : result.posterior.draws) {
        result.least_misfit = std::min(result.least_misfit, draw.misfit);
    }
    result.profiles = profiles_of(
        target.misfit(), thinned(result.posterior.draws, costly != nullptr ? most_costly_profiles : most_profiles),
        costly != nullptr, progress, stop);
    warn_of_counts(target, result.warnings);
    if (costly != nullptr) {
        warn_of_reach(reach_of_runs(target.misfit(), costly->runs), std::to_string(costly->runs.size()) + " runs",
                      result.warnings);
    } else if (!target.without_runs()) {
        warn_of_reach(reach_of_priors(target, settings.seed), "512 draws of them", result.warnings);
    }
    warn_of_sampling(result, result.warnings);
    return result;
}

long expected_posterior_evaluations(const FitProblem& problem, std::size_t mechanism) {
    const PosteriorStudy& study = *problem.posterior;
    const auto parameters = static_cast<long>(problem.mechanisms[mechanism].parameters.size());
    const long begin = 31 * std::clamp(10 * parameters, 20L, 80L);
    const long evidence = static_cast<long>(EvidenceSettings{}.replicates) * study.evidence_points;
    const auto variants = static_cast<long>(variants_of(problem).size()) - 1;
    const bool costly = problem.mechanisms[mechanism].model.costly;
    const long profiles = costly ? static_cast<long>(most_costly_profiles) * weight_of_run : 0;
    return study.chains * begin + 3L * study.draws + evidence + profiles + variants * evidence / 2;
}

}  // namespace delabole
