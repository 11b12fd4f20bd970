#include "fitting/sensitivity/sensitivity.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace delabole {

namespace {

std::size_t demanded_place(const std::vector<Quantity>& quantities, const std::string& name) {
    const auto place = place_of(quantities, name);
    if (!place) {
        throw std::invalid_argument("sensitivity: the model has no " + name);
    }
    return *place;
}

// Number of evaluations of each method, used only for the progress report.
struct Expected {
    long tornado = 0;
    long sweep = 0;  // of each quantity
    long sweeps = 0;
    long morris = 0;
    long sobol_indices = 0;
    long propagation = 0;
    long reliability = 0;

    explicit Expected(const SensitivityStudy& study) {
        const auto dimension = static_cast<long>(study.parameters.size());
        if (study.tornado) {
            tornado = 1 + 2 * dimension;
        }
        if (study.sweep) {
            sweep = study.sweep->samples > 0 ? study.sweep->samples : 1 + (study.sweep->points - 1) * dimension;
            sweeps = sweep * static_cast<long>(1 + study.sweep->further.size());
        }
        if (study.morris) {
            morris = study.morris->trajectories * (dimension + 1);
        }
        if (study.sobol_indices) {
            sobol_indices = study.sobol_indices->samples * (dimension + 2);
        }
        if (study.propagation) {
            propagation = static_cast<long>(plan_size(*study.propagation).total());
        }
        if (study.reliability) {
            constexpr long usual_iterations = 8;
            reliability = study.reliability->starts * usual_iterations * (2 * dimension + 1);
        }
    }
    long total() const { return tornado + sweeps + morris + sobol_indices + propagation + reliability; }
};

// Whether some method varied a parameter alone, and whether that changed the quantity.
struct Effect {
    bool looked = false;
    bool any = false;

    void add(bool changed) {
        looked = true;
        any = any || changed;
    }
};

std::vector<std::size_t> without_effect(const SensitivityResult& result, std::size_t parameters) {
    std::vector<Effect> effects(parameters);
    for (std::size_t parameter = 0; parameter < parameters; ++parameter) {
        Effect& effect = effects[parameter];
        if (result.tornado) {
            if (const auto swing = result.tornado->bars[parameter].swing(result.tornado->at_medians)) {
                effect.add(*swing != 0);
            }
        }
        if (!result.sweeps.empty() &&
            result.sweeps.front().parameters[parameter].course != SweepCourse::too_few_answers) {
            effect.add(result.sweeps.front().parameters[parameter].course != SweepCourse::constant);
        }
        if (result.morris && result.morris->parameters[parameter].effects >= 2) {
            effect.add(result.morris->parameters[parameter].mean_absolute.value != 0);
        }
        if (result.sobol_indices && result.sobol_indices->status == SobolIndicesStatus::found) {
            effect.add(result.sobol_indices->parameters[parameter].total.value != 0);
        }
    }
    std::vector<std::size_t> without;
    for (std::size_t parameter = 0; parameter < parameters; ++parameter) {
        if (effects[parameter].looked && !effects[parameter].any) {
            without.push_back(parameter);
        }
    }
    return without;
}

bool found_nothing(const SensitivityResult& result) {
    const auto nothing = [](const EvaluationCount& count) { return count.total > 0 && count.failed() == count.total; };
    return (result.tornado && nothing(result.tornado->evaluations)) ||
           std::ranges::any_of(result.sweeps, nothing, &SweepResult::evaluations) ||
           (result.morris && nothing(result.morris->evaluations)) ||
           (result.sobol_indices && nothing(result.sobol_indices->evaluations)) ||
           (result.propagation && result.propagation->status == PropagationStatus::no_answer) ||
           (result.reliability && result.reliability->status == ReliabilityStatus::no_answer_at_medians);
}

}  // namespace

Objective quantity_of(const ModelInterface& model, const SensitivityStudy& study, const std::string& name) {
    std::vector<Assignment> assigned;
    std::vector<std::size_t> parameter_of;  // parameter to which each of them belongs
    for (std::size_t index = 0; index < study.parameters.size(); ++index) {
        std::vector<std::string> names{study.parameters[index].name};
        names.insert(names.end(), study.parameters[index].also.begin(), study.parameters[index].also.end());
        for (const std::string& input : names) {
            assigned.push_back({demanded_place(model.inputs, input), 0});
            parameter_of.push_back(index);
        }
    }
    const std::size_t output = demanded_place(model.outputs, name);
    const std::optional<FailureCriterion> criterion = name == study.quantity ? study.failure : std::nullopt;
    return [&model, assigned, parameter_of, output, criterion](std::span<const double> parameters) -> Evaluation {
        std::vector<Assignment> assignments = assigned;
        for (std::size_t index = 0; index < assignments.size(); ++index) {
            assignments[index].value = parameters[parameter_of[index]];
        }
        const Prediction prediction = model.predict(assignments);
        if (!prediction.failure.empty()) {
            return {0, prediction.failure};
        }
        const auto bounded = std::ranges::find(model.bounded_outputs, output, &BoundedOutput::output);
        if (criterion && bounded != model.bounded_outputs.end() && !criterion->failed(bounded->range(prediction))) {
            return {0, known_as_bound};
        }
        return {prediction.outputs[output], {}};
    };
}

SensitivityResult sensitivity(const SensitivityProblem& problem, FitProgressCallback progress, StopFlag stop) {
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<StudyFault> faults = check_study(problem);
    if (!faults.empty()) {
        throw std::invalid_argument("sensitivity: " + faults.front().key + " " + faults.front().message);
    }
    const SensitivityStudy& study = problem.study;
    const InputSpace space = input_space(study);
    const Objective quantity = quantity_of(problem.model, study, study.quantity);
    const std::optional<FailureCriterion> criterion = criterion_of(problem);
    const Expected expected(study);
    ProgressMeter meter(std::move(progress), expected.total());
    const Evaluator evaluator{quantity, meter, stop, problem.threads, problem.ranks};

    SensitivityResult result;
    if (study.tornado && !evaluator.stopped()) {
        meter.begin_stage(study.quantity, "tornado", expected.tornado);
        result.tornado = tornado(evaluator, space, *study.tornado);
    }
    if (study.sweep) {
        std::vector<SweptQuantity> swept{{study.quantity, study.sweep->scatter}};
        swept.insert(swept.end(), study.sweep->further.begin(), study.sweep->further.end());
        for (const SweptQuantity& each : swept) {
            if (evaluator.stopped()) {
                break;
            }
            meter.begin_stage(each.name, "sweep", expected.sweep);
            const Objective objective = quantity_of(problem.model, study, each.name);
            const Evaluator of_this{objective, meter, stop, problem.threads, problem.ranks};
            if (auto found = sweep(of_this, space, *study.sweep, each.scatter, study.seed)) {
                found->quantity = each.name;
                result.sweeps.push_back(std::move(*found));
            }
        }
    }
    if (study.morris && !evaluator.stopped()) {
        meter.begin_stage(study.quantity, "Morris screening", expected.morris);
        result.morris = morris(evaluator, space, *study.morris, study.seed);
    }
    // The design point is found before the many samples are evaluated, so that it is known if these are interrupted.
    if (study.reliability && !evaluator.stopped()) {
        meter.begin_stage(study.quantity, "design point", expected.reliability);
        result.reliability = reliability(evaluator, space, *study.reliability, *criterion, study.seed);
    }
    if (study.propagation && !evaluator.stopped()) {
        meter.begin_stage(study.quantity, "samples", expected.propagation);
        result.propagation = propagate(evaluator, space, *study.propagation, criterion, study.seed);
    }
    if (study.sobol_indices && !evaluator.stopped()) {
        meter.begin_stage(study.quantity, "Sobol indices", expected.sobol_indices);
        result.sobol_indices = sobol_indices(evaluator, space, *study.sobol_indices, study.seed);
    }
    meter.finish();
    result.without_effect = without_effect(result, space.size());
    if (evaluator.stopped()) {
        result.status = SensitivityStatus::interrupted;
    } else if (found_nothing(result)) {
        result.status = SensitivityStatus::no_answer;
    } else if (result.reliability && result.reliability->status == ReliabilityStatus::not_converged) {
        result.status = SensitivityStatus::not_converged;
    }
    result.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace delabole
