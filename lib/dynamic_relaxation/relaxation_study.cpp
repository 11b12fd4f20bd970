#include "dynamic_relaxation/relaxation_study.hpp"

#include "dynamic_relaxation/scene_check.hpp"

#include <cmath>
#include <limits>

namespace delabole {

namespace {

constexpr std::uint64_t steps_between_reports = 500;
constexpr double standard_tolerance = degrees(0.005);

SceneFault check(const RelaxationScene& scene, const RelaxationSettings& settings) {
    SceneFault fault = check_settings(settings);
    if (fault.check == SceneCheck::valid) {
        fault = check_scene(scene);
    }
    return fault.check == SceneCheck::valid ? check_start(scene) : fault;
}

// The settings of a search: what happens after onset does not matter to it.
RelaxationSettings search_settings(const RelaxationStudy& study) {
    RelaxationSettings settings = relaxation_settings(study);
    settings.stop_at_onset = true;
    settings.stop_at_equilibrium = true;
    return settings;
}

RelaxationScene scene_at(RelaxationScene scene, CriticalParameter parameter, double value) {
    if (parameter == CriticalParameter::tilt) {
        scene.gravity.tilt = scene.gravity.final_tilt = value;
        scene.gravity.rate = 0;
        return scene;
    }
    for (JointMaterial& material : scene.material) {
        material.friction_angle = value;
        material.residual_friction_angle.reset();
    }
    return scene;
}

Quantity critical_quantity(CriticalParameter parameter) {
    return {std::string(name_of_critical(parameter)), Dimension::angle, "between standing and failing"};
}

Prediction predict(RelaxationStudy study, std::span<const Assignment> assignments) {
    assign(study.model, assignments);
    if (!in_range(study.model)) {
        return {"input_out_of_range", {}, {}};
    }
    const RelaxationRun run_at = run(study);
    switch (run_at.result.outcome) {
    case RelaxationOutcome::equilibrium:
    case RelaxationOutcome::onset:
    case RelaxationOutcome::collapse:
        break;
    case RelaxationOutcome::undecided:
        if (!run_at.settings.stop_at_equilibrium) {
            break;  // told to run for so long
        }
        return {word_of(run_at.result.outcome), {}, {}};
    case RelaxationOutcome::scene_not_valid:
        return {word_of(run_at.result.fault.check), {}, {}};
    default:
        return {word_of(run_at.result.outcome), {}, {}};
    }
    std::vector<double> outputs = output_values(answer_of(run_at.result));
    if (study.critical) {
        const CriticalValue critical = find_critical(study);
        if (critical.status != CriticalStatus::found) {
            return {word_of(critical.status), {}, {}};
        }
        outputs.push_back(critical.value());
    }
    return {{}, std::move(outputs), {}};
}

}  // namespace

SceneFault check(const RelaxationStudy& study) {
    return check(relaxation_scene(study), relaxation_settings(study));
}

RelaxationRun run(const RelaxationStudy& study, const RelaxationWatch& watch, KeepFrames frames) {
    RelaxationRun made{relaxation_scene(study), relaxation_settings(study), {}, {}};
    MotionRecord record;
    made.result.fault = check(made.scene, made.settings);
    if (made.result.fault.check != SceneCheck::valid) {
        return made;
    }
    Simulation simulation(made.scene, made.settings);
    double next_line = 0;
    bool interrupted = false;
    while (simulation.running() && !interrupted) {
        const RelaxationState& state = simulation.state();
        if (study.history && state.time >= next_line) {
            made.history.push_back(history_line(*study.history, simulation));
            next_line = (std::floor(state.time / study.history->interval) + 1) * study.history->interval;
        }
        if (frames == KeepFrames::yes) {
            record.look(simulation);
        }
        if (watch && state.steps % steps_between_reports == 0) {
            interrupted = !watch(state.time / made.settings.duration);
        }
        if (!interrupted) {
            simulation.step();
        }
    }
    if (study.history) {
        made.history.push_back(history_line(*study.history, simulation));
    }
    if (frames == KeepFrames::yes) {
        record.add_last(simulation);
        made.frames = record.frames();
    }
    made.result = simulation.result();
    if (interrupted) {
        made.result.outcome = RelaxationOutcome::interrupted;
    }
    made.end = simulation.state();
    return made;
}

RelaxationAnswer answer_of(const RelaxationResult& result) {
    const EnergyLedger& ledger = result.ledger;
    const double turnover = ledger.turnover();
    RelaxationAnswer answer{result.outcome,
                            result.onset_time.value_or(std::numeric_limits<double>::infinity()),
                            result.time,
                            result.tilt,
                            result.unbalanced_ratio,
                            result.deepest ? result.deepest->overlap : 0,
                            {ledger.applied, ledger.prescribed, ledger.kinetic, ledger.elastic, ledger.friction,
                             ledger.dashpots, ledger.local_damping, ledger.kinetic_damping, ledger.residual(),
                             turnover > 0 ? ledger.residual() / turnover : 0},
                            static_cast<double>(result.cost.steps),
                            result.cost.step,
                            static_cast<double>(result.cost.contacts_evaluated),
                            {}};
    for (const BlockOutcome& block : result.block) {
        answer.block.push_back({block.movement, block.rotation, block.displacement, block.base_slip});
    }
    return answer;
}

double bracket_width(const CriticalRequest& request) {
    return request.tolerance.value_or(standard_tolerance);
}

CriticalValue find_critical(const RelaxationStudy& study, const RelaxationWatch& watch) {
    const CriticalRequest& request = *study.critical;
    const RelaxationScene scene = relaxation_scene(study);
    const RelaxationSettings settings = search_settings(study);
    const double tolerance = bracket_width(request);
    const double expected_runs = 2 + std::ceil(std::log2(std::max(2.0, (request.upper - request.lower) / tolerance)));
    double runs = 0;
    const auto probe = [&](double value) -> CriticalProbe {
        const RelaxationResult result =
            relax(scene_at(scene, request.parameter, value), settings, [&](const Simulation& simulation) {
                const RelaxationState& state = simulation.state();
                return !watch || state.steps % steps_between_reports != 0 ||
                       watch((runs + state.time / settings.duration) / expected_runs);
            });
        ++runs;
        return {result.outcome, result.cost.steps, result.cost.contacts_evaluated};
    };
    const bool stands_low = request.parameter == CriticalParameter::tilt;
    return find_critical(probe, stands_low ? request.lower : request.upper, stands_low ? request.upper : request.lower,
                         tolerance);
}

std::string_view name_of_critical(CriticalParameter parameter) {
    return parameter == CriticalParameter::tilt ? "critical_tilt" : "limiting_friction_angle";
}

ModelInterface model_interface(const RelaxationStudy& study) {
    ModelInterface model;
    model.inputs = inputs_of(study.model);
    RelaxationAnswer shape{};
    shape.block.resize(relaxation_scene(study).block.size());
    model.outputs = outputs_of(shape);
    if (study.critical) {
        model.outputs.push_back(critical_quantity(study.critical->parameter));
    }
    model.predict = [study](std::span<const Assignment> assignments) { return predict(study, assignments); };
    return model;
}

}  // namespace delabole
