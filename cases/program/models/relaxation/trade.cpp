#include "cases/program/models/relaxation/trade.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>
#include <utility>

namespace delabole {

namespace {

constexpr std::string_view step_fraction = "step_fraction";
constexpr std::string_view stiffness_ratio = "stiffness_ratio";
constexpr std::string_view local_damping = "local_damping";
constexpr std::string_view viscous_damping = "viscous_damping";
constexpr std::string_view kinetic_damping = "kinetic_damping";
constexpr std::string_view mass_scaling = "mass_scaling";
constexpr std::string_view start = "start";
constexpr std::string_view equilibrium_ratio = "equilibrium_ratio";
constexpr std::string_view onset_threshold = "onset_threshold";

constexpr double number_of(RelaxationStart value) {
    return static_cast<double>(value);
}

constexpr double number_of(OffOn value) {
    return static_cast<double>(value);
}

constexpr double preloaded = number_of(RelaxationStart::preloaded);
constexpr double dropped = number_of(RelaxationStart::dropped);
constexpr double ramped = number_of(RelaxationStart::ramped);
constexpr double off = number_of(OffOn::off);
constexpr double on = number_of(OffOn::on);

template <class Enum>
std::vector<std::string> words_of(Enum value) {
    const auto names = enum_names(value);
    return {names.begin(), names.end()};
}

RelaxationNumerics numerics_of(const RelaxationStudy& study) {
    return study.settings.value_or(RelaxationNumerics{});
}

bool gives_stiffness(const RelaxationJoint& joint) {
    return joint.normal_stiffness.has_value();
}

bool gives_stiffness(const SlopeJoint& joint) {
    return gives_stiffness(joint.strength);
}

bool joints_give_stiffness(const RelaxationStudy& study) {
    return std::visit(
        [](const auto& scene) {
            if constexpr (requires { scene.joint; }) {
                return std::any_of(scene.joint.begin(), scene.joint.end(),
                                   [](const auto& joint) { return gives_stiffness(joint); });
            } else {
                return gives_stiffness(scene.interface) || gives_stiffness(scene.base);
            }
        },
        study.model.scene);
}

// Ten times the time in which a block, of the area of the largest free block, falls by its own size: slow for every
// block.
double slow_ramp(const RelaxationStudy& study) {
    const RelaxationScene scene = relaxation_scene(study);
    double area = 0;
    for (const RelaxationBlock& block : scene.block) {
        area = block.fixed ? area : std::max(area, area_properties(block.outline).area);
    }
    const double gravity = scene.gravity.acceleration;
    return gravity > 0 && area > 0 ? 10 * std::sqrt(2 * std::sqrt(area) / gravity) : 1;
}

using Corner = std::vector<std::pair<std::string_view, double>>;

// Combinations of settings: cheap and fine runs at each stiffness, each damping alone, unfavourable starts where they
// matter most and least, and thresholds of onset at both ends of the stiffness range.
std::vector<Corner> corners() {
    std::vector<Corner> list;
    for (const double ratio : {1e4, 1e5, 1e6, 1e7}) {
        list.push_back({{stiffness_ratio, ratio}, {step_fraction, 0.6}, {equilibrium_ratio, 1e-4}});
    }
    for (const double ratio : {1e5, 1e6, 1e8}) {
        list.push_back({{stiffness_ratio, ratio}, {step_fraction, 0.2}, {equilibrium_ratio, 1e-7}});
    }
    for (const double viscous : {0.0, 0.2}) {
        list.push_back({{kinetic_damping, on}, {local_damping, 0}, {viscous_damping, viscous}});
    }
    for (const double local : {0.3, 0.8}) {
        list.push_back({{local_damping, local}, {viscous_damping, 0}});
    }
    for (const double ratio : {1e5, 1e7}) {
        list.push_back({{stiffness_ratio, ratio}, {mass_scaling, on}});
    }
    // Only low stiffnesses are combined with dropped or ramped starts and high thresholds: with stiff blocks these runs
    // would take longer than all others together.
    for (const double ratio : {1e4, 1e6}) {
        list.push_back({{stiffness_ratio, ratio}, {start, dropped}});
        list.push_back({{stiffness_ratio, ratio}, {onset_threshold, 0.1}});
    }
    for (const double ratio : {1e4, 1e6, 1e8}) {
        list.push_back({{stiffness_ratio, ratio}, {onset_threshold, 1e-3}});
    }
    list.push_back({{stiffness_ratio, 1e4}, {start, ramped}});
    list.push_back({{start, dropped}, {local_damping, 0.8}});
    list.push_back({{start, dropped}, {kinetic_damping, on}});
    return list;
}

// The threshold without the part that a rotating base adds.
double own_threshold(const RelaxationStudy& study) {
    return numerics_of(study).onset_rotation.value_or(RelaxationSettings{}.onset_rotation);
}

RelaxationStudy of_quality(RelaxationStudy study, RelaxationQuality quality) {
    RelaxationNumerics numerics = numerics_of(study);
    numerics.quality = quality;
    numerics.step_fraction.reset();
    numerics.stiffness_ratio.reset();
    numerics.equilibrium_ratio.reset();
    study.settings = numerics;
    return study;
}

std::vector<TradeSetting> trade_settings(const RelaxationStudy& study, const std::vector<TradeParameter>& parameters) {
    std::vector<TradeSetting> settings = {own_setting(parameters)};
    for (std::size_t index = 0; index < enum_names(RelaxationQuality{}).size(); ++index) {
        const auto quality = static_cast<RelaxationQuality>(index);
        const RelaxationStudy preset = of_quality(study, quality);
        const RelaxationSettings numbers = relaxation_settings(preset);
        add_setting(settings, parameters, std::string(enum_names(quality)[index]),
                    {{step_fraction, numbers.step_fraction},
                     {stiffness_ratio, stiffness_ratio_of(preset)},
                     {equilibrium_ratio, numbers.equilibrium_ratio}});
    }
    add_levels(settings, parameters);
    for (const Corner& corner : corners()) {
        add_setting(settings, parameters, "corner", corner);
    }
    return settings;
}

double value_of_parameter(const std::vector<TradeParameter>& parameters, std::span<const double> values,
                          std::string_view name, double absent) {
    for (std::size_t index = 0; index < parameters.size(); ++index) {
        if (parameters[index].name == name) {
            return values[index];
        }
    }
    return absent;
}

TradeAnswer answer_at(const RelaxationStudy& study, const TradeWatch& watch) {
    const auto begin = std::chrono::steady_clock::now();
    StudyWork work;
    work.watch = watch;
    const CriticalValue critical = find_critical(study, work);
    TradeAnswer answer;
    if (critical.status != CriticalStatus::found) {
        answer.failure = word_of(critical.status);
    }
    answer.stands = critical.stands;
    answer.fails = critical.fails;
    answer.cost = static_cast<double>(critical.contacts_evaluated);
    answer.steps = static_cast<double>(critical.steps);
    answer.runs = static_cast<double>(critical.runs);
    answer.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return answer;
}

}  // namespace

std::vector<TradeParameter> trade_parameters(const RelaxationStudy& study) {
    const RelaxationSettings own = relaxation_settings(study);
    std::vector<TradeParameter> parameters = {
        {std::string(step_fraction), {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, own.step_fraction, {}},
        {std::string(stiffness_ratio), {1e4, 1e5, 1e6, 1e7, 1e8}, stiffness_ratio_of(study), {}},
        {std::string(local_damping), {0, 0.1, 0.2, 0.3, 0.5, 0.8}, own.local_damping, {}},
        {std::string(viscous_damping), {0, 0.1, 0.2, 0.5, 1}, own.viscous_damping, {}},
        {std::string(kinetic_damping), {off, on}, own.kinetic_damping ? on : off, words_of(OffOn{})},
        {std::string(mass_scaling), {off, on}, own.mass_scaling ? on : off, words_of(OffOn{})},
        {std::string(start), {preloaded, dropped, ramped}, number_of(own.start), words_of(RelaxationStart{})},
        {std::string(equilibrium_ratio), {1e-3, 1e-4, 1e-5, 1e-6, 1e-7}, own.equilibrium_ratio, {}},
        {std::string(onset_threshold), {1e-3, 3e-3, 0.01, 0.03, 0.1}, own_threshold(study), {}}};
    if (joints_give_stiffness(study)) {
        parameters.erase(parameters.begin() + 1);
    }
    return parameters;
}

RelaxationStudy with_parameters(const RelaxationStudy& study, const std::vector<TradeParameter>& parameters,
                                std::span<const double> values) {
    const RelaxationSettings own = relaxation_settings(study);
    RelaxationNumerics numerics = numerics_of(study);
    const auto number = [&](std::string_view name, double absent) {
        return value_of_parameter(parameters, values, name, absent);
    };
    numerics.time_step.reset();
    numerics.step_fraction = number(step_fraction, own.step_fraction);
    numerics.stiffness_ratio = number(stiffness_ratio, stiffness_ratio_of(study));
    numerics.local_damping = number(local_damping, own.local_damping);
    numerics.viscous_damping = number(viscous_damping, own.viscous_damping);
    numerics.kinetic_damping = number(kinetic_damping, off) > 0 ? OffOn::on : OffOn::off;
    numerics.mass_scaling = number(mass_scaling, off) > 0 ? OffOn::on : OffOn::off;
    numerics.equilibrium_ratio = number(equilibrium_ratio, own.equilibrium_ratio);
    const double threshold = number(onset_threshold, own_threshold(study));
    numerics.onset_rotation = threshold;
    numerics.onset_slide =
        numerics.onset_slide.value_or(RelaxationSettings{}.onset_slide) * threshold / own_threshold(study);
    numerics.start = static_cast<RelaxationStart>(number(start, number_of(own.start)));
    numerics.ramp_time = 0;
    if (numerics.start == RelaxationStart::ramped) {
        numerics.ramp_time = own.ramp_time > 0 ? own.ramp_time : slow_ramp(study);
    }
    RelaxationStudy changed = study;
    changed.settings = numerics;
    return changed;
}

TradeProblem trade_problem(const RelaxationStudy& study, std::optional<double> truth, int threads) {
    TradeProblem problem;
    problem.parameters = trade_parameters(study);
    problem.settings = trade_settings(study, problem.parameters);
    problem.finest = add_setting(problem.settings, problem.parameters, "corner",
                                 {{stiffness_ratio, 1e8}, {step_fraction, 0.2}, {equilibrium_ratio, 1e-7}});
    problem.truth = truth;
    problem.answer = [study, parameters = problem.parameters](std::span<const double> values, const TradeWatch& watch) {
        return answer_at(with_parameters(study, parameters, values), watch);
    };
    // The critical time step is proportional to the square root of the stiffness.
    problem.expected_cost = [parameters = problem.parameters](std::span<const double> values) {
        return std::sqrt(value_of_parameter(parameters, values, stiffness_ratio, 1)) /
               value_of_parameter(parameters, values, step_fraction, 1);
    };
    problem.threads = threads;
    return problem;
}

std::vector<std::string> trade_remarks(const RelaxationStudy& study) {
    std::vector<std::string> remarks;
    if (joints_give_stiffness(study)) {
        remarks.emplace_back("joints of the case give their own stiffness: the stiffness ratio is not varied");
    }
    if (numerics_of(study).time_step) {
        remarks.emplace_back("settings.time_step is ignored: the step fraction is varied instead");
    }
    return remarks;
}

}  // namespace delabole
