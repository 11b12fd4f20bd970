#include "fitting/sensitivity/screening.hpp"

#include "fitting/probability/moments.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

constexpr int bootstrap_repetitions = 1000;

// A trajectory through the grid: the level at which every parameter starts, and the order and direction in which they
// move.
struct Trajectory {
    std::vector<int> start;
    std::vector<int> step;           // of each parameter, in levels
    std::vector<std::size_t> order;  // in which they move
};

Trajectory make_trajectory(const CountedRandom& random, std::size_t number, std::size_t dimension, int levels) {
    Trajectory trajectory;
    const int step = levels / 2;
    for (std::size_t parameter = 0; parameter < dimension; ++parameter) {
        const int level = static_cast<int>(
            random.below(static_cast<std::size_t>(levels), number, static_cast<std::uint32_t>(parameter)));
        trajectory.start.push_back(level);
        // From each level exactly one of the two directions stays on the grid.
        trajectory.step.push_back(level < step ? step : -step);
        trajectory.order.push_back(parameter);
    }
    for (std::size_t last = dimension; last-- > 1;) {
        const auto draw = static_cast<std::uint32_t>(dimension + last);
        std::swap(trajectory.order[last], trajectory.order[random.below(last + 1, number, draw)]);
    }
    return trajectory;
}

MorrisEffect effect_of(const std::vector<double>& effects, const CountedRandom& random, int threads) {
    MorrisEffect effect;
    effect.effects = static_cast<long>(effects.size());
    if (effects.size() < 2) {
        return effect;
    }
    std::vector<double> absolute;
    std::transform(effects.begin(), effects.end(), std::back_inserter(absolute),
                   [](double value) { return std::abs(value); });
    effect.mean = mean_of(effects);
    effect.mean_absolute.value = mean_of(absolute);
    effect.standard_deviation.value = deviation_of(effects);
    const auto count = static_cast<double>(effects.size());
    const std::vector<Interval> intervals = bootstrap_intervals(
        effects.size(), 2, bootstrap_repetitions, random, threads, [&](std::span<const unsigned> times) {
            double sum = 0;
            double sum_absolute = 0;
            for (std::size_t index = 0; index < effects.size(); ++index) {
                sum += times[index] * effects[index];
                sum_absolute += times[index] * absolute[index];
            }
            double squares = 0;
            for (std::size_t index = 0; index < effects.size(); ++index) {
                squares += times[index] * (effects[index] - sum / count) * (effects[index] - sum / count);
            }
            return std::vector<double>{sum_absolute / count, std::sqrt(squares / (count - 1))};
        });
    effect.mean_absolute.interval_95 = intervals[0];
    effect.standard_deviation.interval_95 = intervals[1];
    return effect;
}

}  // namespace

std::optional<double> TornadoBar::swing(const Evaluation& at_medians) const {
    if (!low.answer.valid() || !high.answer.valid() || !at_medians.valid()) {
        return std::nullopt;
    }
    const auto [least, greatest] = std::minmax({low.answer.value, high.answer.value, at_medians.value});
    return greatest - least;
}

std::optional<TornadoResult> tornado(const Evaluator& evaluator, const InputSpace& space,
                                     const TornadoSettings& settings) {
    const std::size_t dimension = space.size();
    // Point 0 has all medians; two points for each parameter follow.
    const auto point = [&](std::size_t index, std::span<double> parameters) {
        for (std::size_t parameter = 0; parameter < dimension; ++parameter) {
            parameters[parameter] = space.marginal(parameter).value(0);
        }
        if (index > 0) {
            const std::size_t moved = (index - 1) / 2;
            parameters[moved] = space.marginal(moved).quantile(index % 2 == 1 ? settings.lower_probability
                                                                              : settings.upper_probability);
        }
    };
    const std::size_t count = 1 + 2 * dimension;
    const std::vector<Evaluation> answers = evaluator.evaluate(dimension, count, point);
    if (answers.size() < count) {
        return std::nullopt;
    }
    TornadoResult result;
    result.at_medians = answers.front();
    for (std::size_t parameter = 0; parameter < dimension; ++parameter) {
        const Marginal& marginal = space.marginal(parameter);
        result.bars.push_back({{marginal.quantile(settings.lower_probability), answers[1 + 2 * parameter]},
                               {marginal.quantile(settings.upper_probability), answers[2 + 2 * parameter]}});
    }
    for (const Evaluation& answer : answers) {
        result.evaluations.record(answer);
    }
    return result;
}

std::optional<MorrisResult> morris(const Evaluator& evaluator, const InputSpace& space, const MorrisSettings& settings,
                                   std::uint64_t seed) {
    const std::size_t dimension = space.size();
    const CountedRandom random(seed, RandomPurpose::trajectory);
    std::vector<Trajectory> trajectories;
    for (std::size_t number = 0; number < static_cast<std::size_t>(settings.trajectories); ++number) {
        trajectories.push_back(make_trajectory(random, number, dimension, settings.levels));
    }
    const double last_level = settings.levels - 1;
    const auto point = [&](std::size_t index, std::span<double> parameters) {
        const Trajectory& trajectory = trajectories[index / (dimension + 1)];
        const std::size_t moves = index % (dimension + 1);
        for (std::size_t place = 0; place < dimension; ++place) {
            const std::size_t parameter = trajectory.order[place];
            const int level = trajectory.start[parameter] + (place < moves ? trajectory.step[parameter] : 0);
            parameters[parameter] = space.marginal(parameter).quantile(
                std::lerp(settings.lower_probability, settings.upper_probability, level / last_level));
        }
    };
    const std::size_t count = trajectories.size() * (dimension + 1);
    const std::vector<Evaluation> answers = evaluator.evaluate(dimension, count, point);
    if (answers.size() < count) {
        return std::nullopt;
    }
    std::vector<std::vector<double>> effects(dimension);
    for (std::size_t number = 0; number < trajectories.size(); ++number) {
        const Trajectory& trajectory = trajectories[number];
        for (std::size_t move = 0; move < dimension; ++move) {
            const Evaluation& before = answers[number * (dimension + 1) + move];
            const Evaluation& after = answers[number * (dimension + 1) + move + 1];
            const std::size_t parameter = trajectory.order[move];
            if (before.valid() && after.valid()) {
                effects[parameter].push_back((after.value - before.value) / (trajectory.step[parameter] / last_level));
            }
        }
    }
    MorrisResult result;
    const CountedRandom resampling(seed, RandomPurpose::bootstrap);
    for (const std::vector<double>& of_parameter : effects) {
        result.parameters.push_back(effect_of(of_parameter, resampling, evaluator.threads));
    }
    for (const Evaluation& answer : answers) {
        result.evaluations.record(answer);
    }
    return result;
}

}  // namespace delabole
