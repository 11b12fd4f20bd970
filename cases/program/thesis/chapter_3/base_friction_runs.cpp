#include "cases/program/thesis/chapter_3/base_friction.hpp"

#include "fitting/search/minimise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

constexpr double least_strength = 0.02;  // kPa
constexpr double greatest_strength = 100;

struct ReadyScene {
    RelaxationScene scene;
    RelaxationSettings settings;
    StrengthReduction reduction;

    SceneNeed need(CriticalStrength critical) const {
        CrackPath path = crack_path(critical.end);
        return {std::move(critical), std::move(path)};
    }
};

ReadyScene ready(const BaseFrictionGeometry& geometry, const ModelMixture& mixture) {
    const RelaxationStudy study = base_friction_study(geometry, mixture);
    const RelaxationScene scene = relaxation_scene(study);
    return {scene, relaxation_settings(study, scene), strength_reduction_of(geometry)};
}

// Share of failed slopes that a state stands for.
double failed_share(SlopeBehaviour behaviour) {
    switch (behaviour) {
    case SlopeBehaviour::stable:
        return 0;
    case SlopeBehaviour::limiting:
        return 0.5;
    case SlopeBehaviour::unstable:
        break;
    }
    return 1;
}

}  // namespace

std::vector<BaseFrictionScene> base_friction_scenes(const std::vector<BaseFrictionState>& states,
                                                    const ModelMixture& mixture) {
    std::vector<BaseFrictionScene> scenes;
    for (std::size_t index = 0; index < states.size(); ++index) {
        const BaseFrictionGeometry geometry = geometry_of(states[index], mixture);
        const auto same = std::ranges::find(scenes, geometry, &BaseFrictionScene::geometry);
        if (same == scenes.end()) {
            scenes.push_back({geometry, {index}, scenes.size() % 2 == 0});
        } else {
            same->state.push_back(index);
        }
    }
    return scenes;
}

double SceneNeed::strength() const {
    switch (critical.status) {
    case StrengthStatus::fails_however_strong:
        return std::numeric_limits<double>::infinity();
    case StrengthStatus::stands_however_weak:
        return 0;
    default:
        return std::sqrt(critical.stands * critical.fails);
    }
}

SceneNeed needed_strength(const BaseFrictionGeometry& geometry, const ModelMixture& mixture,
                          const std::function<bool()>& watch) {
    const ReadyScene scene = ready(geometry, mixture);
    return scene.need(find_critical_strength(scene.scene, scene.settings, scene.reduction, watch));
}

SceneNeed run_with_strength(const BaseFrictionGeometry& geometry, const ModelMixture& mixture, double strength,
                            const std::function<bool()>& watch) {
    const ReadyScene scene = ready(geometry, mixture);
    return scene.need(run_at_strength(scene.scene, scene.settings, scene.reduction, strength, watch));
}

double failure_probability(double needed, double strength) {
    constexpr double spread = 0.25;   // of the logarithm of strength: slabs, and twins of one slab, differ by so much
    constexpr double against = 0.02;  // share of tests that nothing predicts
    const double beyond = needed > 0 ? std::log(needed / strength) : -std::numeric_limits<double>::infinity();
    return against + (1 - 2 * against) / (1 + std::exp(-beyond / spread));
}

StrengthFit fit_strength(const std::vector<BaseFrictionState>& states, const std::vector<BaseFrictionScene>& scenes,
                         const std::vector<SceneNeed>& needs) {
    const auto misfit = [&](double strength) {
        double sum = 0;
        for (std::size_t index = 0; index < scenes.size(); ++index) {
            if (!scenes[index].fitted || !needs[index].known()) {
                continue;
            }
            const double failure = failure_probability(needs[index].strength(), strength);
            for (const std::size_t state : scenes[index].state) {
                const double share = failed_share(states[state].behaviour);
                sum -= share * std::log(failure) + (1 - share) * std::log(1 - failure);
            }
        }
        return sum;
    };
    // The misfit has a step at every scene: searched for globally, then to the bottom.
    const std::array<Interval, 1> bounds{within(std::log(least_strength), std::log(greatest_strength))};
    const Objective objective = [&](std::span<const double> point) {
        return Evaluation{misfit(std::exp(point[0])), {}};
    };
    MinimiseSettings settings;
    settings.algorithm = Algorithm::direct_l;
    const std::array<double, 1> start{0};
    const MinimiseResult global = minimise(objective, bounds, start, settings);
    settings.algorithm = Algorithm::sbplx;
    settings.initial_step = 0.01;
    const MinimiseResult local = minimise(objective, bounds, global.point, settings);
    StrengthFit fit{std::exp(local.point[0]), local.value, std::exp(local.point[0]), std::exp(local.point[0]),
                    global.evaluations.total + local.evaluations.total};
    constexpr double step = 1.01;
    constexpr double of_95_percent = 1.92;  // half of chi squared with one degree of freedom
    const auto as_good = [&](double strength) { return misfit(strength) <= local.value + of_95_percent; };
    while (fit.lower > least_strength && as_good(fit.lower / step)) {
        fit.lower /= step;
    }
    while (fit.upper < greatest_strength && as_good(fit.upper * step)) {
        fit.upper *= step;
    }
    return fit;
}

}  // namespace delabole
