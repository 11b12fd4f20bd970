// How a quantity changes with one parameter over its range, and whether it is monotone. It is found in two ways:
//
//   the others at their medians   one evaluation at each of some points between two quantiles; exact, or with the
//                                 scatter that the study states
//   the others varied as well     samples of all parameters, sorted by one of them into classes of equal size; each
//                                 point is the mean of a class, and its scatter is the pooled standard deviation within
//                                 classes over the root of their size. The same samples serve every parameter, and a
//                                 model with a scatter of its own costs no more.
//
// A tornado diagram knows only the two ends of each range and cannot show a turn between them; elementary effects of
// both signs may come from a turn or from another parameter.
//
// The greatest rise is the most by which any point lies above an earlier one, and the greatest fall the most by which
// any point lies below an earlier one. The greater of the two is the main change. The other is a reversal, which makes
// the quantity not monotone, if it exceeds both
//   a hundredth of the main change, since a smaller reversal is negligible beside it, and
//   the scatter times the 95 % quantile of the range of as many independent standard normal numbers as there are points
//   (Tukey's studentized range, 3.9 for five points), so that scatter alone is seldom taken for a reversal, whatever
//   the order of the points.
// A main change smaller than that multiple of the scatter shows nothing: the course is within_scatter.
#pragma once

#include "fitting/probability/dependence.hpp"
#include "fitting/search/evaluate_points.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

// An output beside the quantity of the study.
struct SweptQuantity {
    std::string name;
    double scatter = 0;
    Dimension dimension = Dimension::ratio;  // of the scatter, used when the study is written
    static constexpr auto fields() {
        return FieldTable{
            refers_to(NameOf::output, section<&SweptQuantity::name>("an output that is swept too, e.g. weight")),
            with_default(number<&SweptQuantity::scatter>(
                Dimension::named, at_least(0), "standard deviation at unchanged parameters; 0 where it is exact")),
        };
    }
};

struct SweepSettings {
    int points = 9;  // odd, half of them on either side of the median
    double lower_probability = 0.05;
    double upper_probability = 0.95;
    int samples = 0;  // 0, or at least 8 for each point
    double scatter = 0;
    std::vector<SweptQuantity> further = {};
    static constexpr auto fields() {
        using S = SweepSettings;
        return FieldTable{
            with_default(
                number<&S::points>(within(3, 19), "values of each parameter, with the others at their medians; odd")),
            with_default(number<&S::lower_probability>(lower_quantile, "probability of the lower end")),
            with_default(number<&S::upper_probability>(upper_quantile, "probability of the upper end")),
            with_default(number<&S::samples>(within(0, 10'000'000),
                                             "points of a Latin hypercube; 0: the others stay at their medians")),
            with_default(number<&S::scatter>(Dimension::named, at_least(0),
                                             "standard deviation of the quantity at unchanged parameters, used without "
                                             "samples; 0 where it is exact")),
            section("quantity", &S::further, "a further output that is swept"),
        };
    }
};

struct SweepPoint {
    double parameter = 0;
    Evaluation answer;
};

enum class SweepCourse { constant, within_scatter, rises, falls, not_monotone, too_few_answers };

// The change between two points of a sweep, from the lesser to the greater value of the parameter.
struct SweepChange {
    double from = 0;
    double to = 0;
    double change = 0;  // of the quantity
};

struct ParameterSweep {
    std::vector<SweepPoint> points;  // by increasing parameter
    double scatter = 0;              // of each point
    SweepCourse course = SweepCourse::too_few_answers;
    SweepChange main;
    SweepChange reversal;  // the greatest change of the other sign; zero where there is none
};

// The course of the points in the order given. Points without an answer are left out; at least three others are needed.
// A change of less than 1e-9 of the greatest value counts as rounding.
ParameterSweep judge_sweep(std::vector<SweepPoint> points, double scatter);

struct SweepResult {
    std::string quantity;
    std::vector<ParameterSweep> parameters;
    EvaluationCount evaluations;
};

// Without samples the points are equally spaced between the lower quantile and the median, and between the median and
// the upper quantile; correlations play no part. With samples a point's parameter is the mean of its class; samples
// without an answer are left out, and a class with fewer than two answers gives no point. The evaluator evaluates the
// quantity. Returns nothing if the work was stopped.
std::optional<SweepResult> sweep(const Evaluator& evaluator, const InputSpace& space, const SweepSettings& settings,
                                 double scatter, std::uint64_t seed);

}  // namespace delabole
