#include "fitting/sensitivity/sweep.hpp"

#include "fitting/probability/sampling.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

constexpr double least_share = 0.01;
constexpr double rounding = 1e-9;

// 95 % quantile of the range of this many independent standard normal numbers, for 3 to 19 of them.
double range_quantile(std::size_t count) {
    constexpr std::array quantiles{3.314, 3.633, 3.858, 4.030, 4.170, 4.286, 4.387, 4.474, 4.552,
                                   4.622, 4.685, 4.743, 4.796, 4.845, 4.891, 4.934, 4.974};
    return quantiles[count - 3];
}

struct Changes {
    SweepChange rise;
    SweepChange fall;
};

Changes greatest_changes(const std::vector<SweepPoint>& points) {
    Changes found;
    for (std::size_t last = 1; last < points.size(); ++last) {
        for (std::size_t first = 0; first < last; ++first) {
            const SweepChange change{points[first].parameter, points[last].parameter,
                                     points[last].answer.value - points[first].answer.value};
            if (change.change > found.rise.change) {
                found.rise = change;
            }
            if (change.change < found.fall.change) {
                found.fall = change;
            }
        }
    }
    return found;
}

SweepCourse course_of(double main, double reversal, double resolved, double greatest_value) {
    if (std::abs(main) <= rounding * greatest_value) {
        return SweepCourse::constant;
    }
    if (std::abs(main) <= resolved) {
        return SweepCourse::within_scatter;
    }
    if (std::abs(reversal) > std::max(least_share * std::abs(main), resolved)) {
        return SweepCourse::not_monotone;
    }
    return main > 0 ? SweepCourse::rises : SweepCourse::falls;
}

}  // namespace

ParameterSweep judge_sweep(std::vector<SweepPoint> points, double scatter) {
    ParameterSweep result;
    std::vector<SweepPoint> answered;
    double greatest_value = 0;
    for (const SweepPoint& point : points) {
        if (point.answer.valid()) {
            answered.push_back(point);
            greatest_value = std::max(greatest_value, std::abs(point.answer.value));
        }
    }
    result.points = std::move(points);
    result.scatter = scatter;
    if (answered.size() < 3) {
        return result;
    }
    const Changes changes = greatest_changes(answered);
    const bool rises = changes.rise.change >= -changes.fall.change;
    result.main = rises ? changes.rise : changes.fall;
    result.reversal = rises ? changes.fall : changes.rise;
    result.course = course_of(result.main.change, result.reversal.change, range_quantile(answered.size()) * scatter,
                              greatest_value);
    return result;
}

namespace {

std::optional<SweepResult> from_medians(const Evaluator& evaluator, const InputSpace& space,
                                        const SweepSettings& settings, double scatter) {
    const std::size_t dimension = space.size();
    const auto half = static_cast<std::size_t>(settings.points / 2);
    const auto value_at = [&](std::size_t parameter, std::size_t place) {
        const Marginal& marginal = space.marginal(parameter);
        const double median = marginal.value(0);
        const double end = marginal.quantile(place < half ? settings.lower_probability : settings.upper_probability);
        const std::size_t steps = place < half ? half - place : place - half;
        return std::lerp(median, end, static_cast<double>(steps) / static_cast<double>(half));
    };
    // Point 0 has all medians and serves every sweep. The other points of each parameter follow, its median left out.
    const auto point = [&](std::size_t index, std::span<double> parameters) {
        for (std::size_t parameter = 0; parameter < dimension; ++parameter) {
            parameters[parameter] = space.marginal(parameter).value(0);
        }
        if (index > 0) {
            const std::size_t moved = (index - 1) / (2 * half);
            const std::size_t place = (index - 1) % (2 * half);
            parameters[moved] = value_at(moved, place < half ? place : place + 1);
        }
    };
    const std::size_t count = 1 + 2 * half * dimension;
    const std::vector<Evaluation> answers = evaluator.evaluate(dimension, count, point);
    if (answers.size() < count) {
        return std::nullopt;
    }
    SweepResult result;
    for (std::size_t parameter = 0; parameter < dimension; ++parameter) {
        std::vector<SweepPoint> points;
        for (std::size_t place = 0; place <= 2 * half; ++place) {
            const std::size_t before = 1 + 2 * half * parameter;
            const Evaluation& answer = place == half ? answers.front() : answers[before + place - (place > half)];
            points.push_back({value_at(parameter, place), answer});
        }
        result.parameters.push_back(judge_sweep(std::move(points), scatter));
    }
    for (const Evaluation& answer : answers) {
        result.evaluations.record(answer);
    }
    return result;
}

// The sweep over the classes of one parameter. `order` lists the samples with an answer by increasing value of it.
ParameterSweep of_classes(const std::vector<std::size_t>& order, std::span<const double> parameter,
                          const std::vector<Evaluation>& answers, std::size_t classes) {
    std::vector<SweepPoint> points;
    double squares = 0;
    std::size_t freedom = 0;
    for (std::size_t number = 0; number < classes; ++number) {
        const std::size_t first = number * order.size() / classes;
        const std::size_t last = (number + 1) * order.size() / classes;
        const auto count = static_cast<double>(last - first);
        if (last - first < 2) {
            continue;
        }
        SweepPoint mean;
        for (std::size_t place = first; place < last; ++place) {
            mean.parameter += parameter[order[place]] / count;
            mean.answer.value += answers[order[place]].value / count;
        }
        for (std::size_t place = first; place < last; ++place) {
            const double apart = answers[order[place]].value - mean.answer.value;
            squares += apart * apart;
        }
        freedom += last - first - 1;
        points.push_back(mean);
    }
    const double size = static_cast<double>(order.size()) / static_cast<double>(classes);
    return judge_sweep(std::move(points), freedom > 0 ? std::sqrt(squares / static_cast<double>(freedom) / size) : 0);
}

std::optional<SweepResult> from_samples(const Evaluator& evaluator, const InputSpace& space,
                                        const SweepSettings& settings, std::uint64_t seed) {
    const std::size_t dimension = space.size();
    const auto count = static_cast<std::size_t>(settings.samples);
    const SamplePlan plan(SamplingMethod::latin_hypercube, dimension, count, 1, seed);
    const auto point = [&](std::size_t index, std::span<double> parameters) {
        std::array<double, most_parameters> unit{};
        plan.point(index, std::span(unit).first(dimension));
        space.values_of_unit(std::span(unit).first(dimension), parameters);
    };
    const std::vector<Evaluation> answers = evaluator.evaluate(dimension, count, point);
    if (answers.size() < count) {
        return std::nullopt;
    }
    SweepResult result;
    std::vector<std::size_t> answered;
    for (std::size_t index = 0; index < count; ++index) {
        result.evaluations.record(answers[index]);
        if (answers[index].valid()) {
            answered.push_back(index);
        }
    }
    std::vector<double> values(count);
    std::array<double, most_parameters> parameters{};
    for (std::size_t parameter = 0; parameter < dimension; ++parameter) {
        for (std::size_t index = 0; index < count; ++index) {
            point(index, std::span(parameters).first(dimension));
            values[index] = parameters[parameter];
        }
        std::ranges::stable_sort(answered, {}, [&](std::size_t index) { return values[index]; });
        result.parameters.push_back(of_classes(answered, values, answers, static_cast<std::size_t>(settings.points)));
    }
    return result;
}

}  // namespace

std::optional<SweepResult> sweep(const Evaluator& evaluator, const InputSpace& space, const SweepSettings& settings,
                                 double scatter, std::uint64_t seed) {
    return settings.samples > 0 ? from_samples(evaluator, space, settings, seed)
                                : from_medians(evaluator, space, settings, scatter);
}

}  // namespace delabole
