#include "fitting/back_analysis/steps.hpp"

#include "fitting/probability/bracketed_root.hpp"
#include "fitting/probability/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace delabole {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double end_tolerance = 1e-4;     // of the range
constexpr double bound_tolerance = 1e-4;   // of sqrt(misfit), which is in standard deviations of a normal posterior
constexpr double misfit_tolerance = 1e-6;  // of each point's misfit; levels are 1 and more
constexpr double better = 1e-4;            // a misfit lower by less than this does not count as an improvement

struct Knot {
    double misfit = infinite;
    std::vector<double> point;  // empty if no point is valid
};

using Knots = std::map<double, Knot>;
using Place = Knots::const_iterator;

DELABOLE_MEMBERS(Knot, misfit, point)

// The result of tracing the profile of one parameter.
struct Traced {
    ProfileLikelihood profile;
    Knot lowest;
    EvaluationCount evaluations;
};

DELABOLE_MEMBERS(Traced, profile, lowest, evaluations)

struct IntervalEnd {
    double value;
    bool closed;
};

class Tracer {
  public:
    Tracer(const Search& search, Priors priors, std::size_t parameter, const MinimiseResult& best,
           std::span<const MinimumCluster> minima)
        : search_(search),
          priors_(priors),
          parameter_(parameter),
          bounds_(search.misfit.bounds()),
          range_(bounds_[parameter]),
          best_(best),
          others_(search.misfit.free_parameters().size() - 1) {
        for (const MinimumCluster& minimum : minima) {
            seeds_.emplace(minimum.parameters[parameter], minimum.parameters);
        }
    }

    ProfileLikelihood trace();
    // The point with the least misfit met so far.
    const Knot& lowest() const {
        const auto by_misfit = [](const auto& a, const auto& b) { return a.second.misfit < b.second.misfit; };
        return std::min_element(knots_.begin(), knots_.end(), by_misfit)->second;
    }
    const EvaluationCount& evaluations() const { return evaluations_; }

  private:
    void follow(const std::vector<double>& values);
    void sweep_inwards(Place outer, bool upwards);
    Knot solve(double value, const std::vector<Place>& neighbours);
    std::vector<double> best_start(double value, const std::vector<Place>& neighbours);
    std::vector<std::vector<double>> candidates(double value, const std::vector<Place>& neighbours) const;
    Knot minimise_others(std::vector<double> start);
    std::pair<Interval, std::pair<bool, bool>> interval(double rise);
    IntervalEnd find_end(double inside, double outside, double rise);
    std::vector<std::string> at_bounds(double value) const;
    double excess(double misfit, double rise) const;

    const Search& search_;
    Priors priors_;
    std::size_t parameter_;
    std::vector<Interval> bounds_;
    Interval range_;
    const MinimiseResult& best_;
    std::size_t others_;
    std::map<double, std::vector<double>> seeds_;  // further minima, by their value of the parameter
    Knots knots_;
    double least_ = infinite;
    EvaluationCount evaluations_;
};

// Starting points at the new value: the points of the neighbours, the straight line through two of them and a further
// minimum at this value; if there are none of these, the best point and the centre.
std::vector<std::vector<double>> Tracer::candidates(double value, const std::vector<Place>& neighbours) const {
    std::vector<std::vector<double>> points;
    for (const Place& neighbour : neighbours) {
        if (!neighbour->second.point.empty()) {
            points.push_back(neighbour->second.point);
        }
    }
    if (points.size() == 2) {
        const double from = points[0][parameter_];
        const double share = (value - from) / (points[1][parameter_] - from);
        std::vector<double> line(points[0].size());
        for (std::size_t index = 0; index < line.size(); ++index) {
            const double on_line = std::lerp(points[0][index], points[1][index], share);
            line[index] = std::clamp(on_line, bounds_[index].lower, bounds_[index].upper);
        }
        points.push_back(std::move(line));
    }
    if (const auto seed = seeds_.find(value); seed != seeds_.end()) {
        points.push_back(seed->second);
    }
    if (points.empty()) {
        points.push_back(best_.point);
        points.push_back(search_.misfit.centre());
    }
    for (std::vector<double>& point : points) {
        point[parameter_] = value;
    }
    return points;
}

std::vector<double> Tracer::best_start(double value, const std::vector<Place>& neighbours) {
    std::vector<double> start;
    double least = infinite;
    for (std::vector<double>& point : candidates(value, neighbours)) {
        const Evaluation evaluation = search_.evaluate(point, priors_, evaluations_);
        const double misfit = evaluation.valid() ? evaluation.value : infinite;
        if (start.empty() || misfit < least) {
            least = misfit;
            start = std::move(point);
        }
    }
    return start;
}

Knot Tracer::minimise_others(std::vector<double> start) {
    std::vector<Interval> bounds = bounds_;
    bounds[parameter_] = {.lower = start[parameter_], .upper = start[parameter_]};
    MinimiseSettings settings;
    settings.algorithm = Algorithm::bobyqa;
    settings.evaluations = 30 + 30 * static_cast<long>(others_);
    settings.relative_tolerance = 1e-6;
    settings.value_tolerance = misfit_tolerance;
    settings.initial_step = 0.02;
    // No misfit is below the least one, so a point that reaches it needs no further search.
    settings.stop_value = best_.value + misfit_tolerance;
    const Objective objective = search_.objective(priors_);
    MinimiseResult result = minimise(objective, bounds, start, settings, search_.stop);
    evaluations_.add(result.evaluations);
    if (others_ > 0 && result.evaluations.failed() > 0) {
        // Failures spoil a quadratic model; the simplex algorithm tolerates them.
        settings.algorithm = Algorithm::sbplx;
        settings.initial_step = result.found() ? 0.02 : 0.25;
        const MinimiseResult second =
            minimise(objective, bounds, result.found() ? result.point : start, settings, search_.stop);
        evaluations_.add(second.evaluations);
        if (second.value < result.value) {
            result = second;
        }
    }
    return {result.value, result.point};
}

Knot Tracer::solve(double value, const std::vector<Place>& neighbours) {
    return minimise_others(best_start(value, neighbours));
}

void Tracer::follow(const std::vector<double>& values) {
    const double start = best_.point[parameter_];
    Place best = knots_.insert_or_assign(start, Knot{best_.value, best_.point}).first;
    Place one = best;
    Place two = best;
    for (const double value : values) {
        if (search_.stopped()) {
            return;
        }
        const std::vector<Place> neighbours = one == two ? std::vector{one} : std::vector{one, two};
        two = one;
        one = knots_.insert_or_assign(value, solve(value, neighbours)).first;
    }
}

// Goes from the end towards the best value and solves a point again if its outer neighbour's point gives a lower misfit
// there.
void Tracer::sweep_inwards(Place outer, bool upwards) {
    const double stop_at = best_.point[parameter_];
    while (outer->first != stop_at && !search_.stopped()) {
        const auto inner = knots_.find((upwards ? std::next(outer) : std::prev(outer))->first);
        if (inner->first == stop_at) {
            return;
        }
        if (!outer->second.point.empty()) {
            std::vector<double> start = outer->second.point;
            start[parameter_] = inner->first;
            const Evaluation evaluation = search_.evaluate(start, priors_, evaluations_);
            if (evaluation.valid() && evaluation.value < inner->second.misfit - better) {
                inner->second = minimise_others(std::move(start));
            }
        }
        outer = inner;
    }
}

// Negative below the level of the interval, infinite without an answer.
double Tracer::excess(double misfit, double rise) const {
    return std::sqrt(std::max(misfit - least_, 0.0)) - std::sqrt(rise);
}

IntervalEnd Tracer::find_end(double inside, double outside, double rise) {
    const double tolerance = end_tolerance * (range_.upper - range_.lower);
    const auto function = [&](double value) {
        const Knot& knot =
            knots_.insert_or_assign(value, solve(value, {knots_.find(inside), knots_.find(outside)})).first->second;
        return excess(knot.misfit, rise);
    };
    double outside_excess = excess(knots_.at(outside).misfit, rise);
    while (std::isinf(outside_excess) && std::abs(outside - inside) > tolerance) {
        const double middle = 0.5 * (inside + outside);
        const double middle_excess = function(middle);
        if (middle_excess <= 0) {
            inside = middle;
        } else {
            outside = middle;
            outside_excess = middle_excess;
        }
    }
    if (std::isinf(outside_excess)) {
        return {inside, false};
    }
    const double inside_excess = excess(knots_.at(inside).misfit, rise);
    const auto root = inside_excess == 0 ? std::optional(inside)
                                         : bracketed_root(function, {inside, outside, inside_excess, outside_excess},
                                                          tolerance, bound_tolerance);
    // Without a root the model has a gap without answers inside the bracket; then the wider interval is given.
    return {root.value_or(outside), true};
}

// The other parameters that lie at a bound where this one has the value, or next to it.
std::vector<std::string> Tracer::at_bounds(double value) const {
    const auto& nearest =
        std::ranges::min_element(knots_, {}, [&](const auto& entry) { return std::abs(entry.first - value); })->second;
    std::vector<std::string> names;
    for (std::size_t index = 0; index < nearest.point.size(); ++index) {
        const Interval& bounds = bounds_[index];
        const double tolerance = end_tolerance * (bounds.upper - bounds.lower);
        const double inside = std::min(nearest.point[index] - bounds.lower, bounds.upper - nearest.point[index]);
        if (index != parameter_ && tolerance > 0 && inside <= tolerance) {
            names.push_back(search_.misfit.mechanism().parameters[index].name);
        }
    }
    return names;
}

std::pair<Interval, std::pair<bool, bool>> Tracer::interval(double rise) {
    const auto below = [&](const auto& entry) { return entry.second.misfit <= least_ + rise; };
    const auto first = std::find_if(knots_.begin(), knots_.end(), below);
    const auto last = std::find_if(knots_.rbegin(), knots_.rend(), below);
    IntervalEnd lower{range_.lower, false};
    IntervalEnd upper{range_.upper, false};
    const double last_inside = last->first;
    const bool reaches_upper = last == knots_.rbegin();
    const double beyond = reaches_upper ? last_inside : std::prev(last)->first;
    if (first != knots_.begin()) {
        lower = find_end(first->first, std::prev(first)->first, rise);
    }
    if (!reaches_upper) {
        upper = find_end(last_inside, beyond, rise);
    }
    return {{.lower = lower.value, .upper = upper.value}, {lower.closed, upper.closed}};
}

ProfileLikelihood Tracer::trace() {
    const double start = best_.point[parameter_];
    const double same = 1e-9 * (range_.upper - range_.lower);
    std::vector<double> above;
    std::vector<double> below;
    std::vector<double> values = grid(range_, search_.misfit.problem().settings.profile_points);
    for (const auto& [value, point] : seeds_) {
        values.push_back(value);
    }
    std::sort(values.begin(), values.end());
    for (const double value : values) {
        if (value > start + same) {
            above.push_back(value);
        } else if (value < start - same) {
            below.insert(below.begin(), value);
        }
    }
    follow(above);
    follow(below);
    sweep_inwards(knots_.begin(), true);
    sweep_inwards(std::prev(knots_.end()), false);
    least_ = lowest().misfit;

    ProfileLikelihood profile;
    profile.parameter = search_.misfit.mechanism().parameters[parameter_].name;
    profile.with_priors = priors_ == Priors::counted;
    profile.least_misfit = least_;
    profile.interval_68 = interval(chi_square_quantile(probability_68, 1)).first;
    const auto [interval_95, closed] = interval(chi_square_quantile(probability_95, 1));
    profile.interval_95 = interval_95;
    profile.determination = determination_of(closed.first, closed.second);
    profile.lower_bounded_by = closed.first ? at_bounds(interval_95.lower) : std::vector<std::string>{};
    profile.upper_bounded_by = closed.second ? at_bounds(interval_95.upper) : std::vector<std::string>{};
    for (const auto& [value, knot] : knots_) {
        profile.values.push_back(value);
        profile.misfits.push_back(knot.misfit);
    }
    return profile;
}

// Minima other than the best that matter to an interval. A flat valley can have many of them, so only a few are used.
std::vector<MinimumCluster> further_minima(const Search& search, Priors priors, std::span<const MinimumCluster> minima,
                                           const MinimiseResult& best, EvaluationCount& account) {
    constexpr std::size_t most = 4;
    std::vector<MinimumCluster> result;
    const double level = best.value + chi_square_quantile(probability_95, 1);
    for (const MinimumCluster& minimum : minima) {
        const Evaluation evaluation = search.evaluate(minimum.parameters, priors, account);
        if (result.size() < most && evaluation.valid() && evaluation.value < level) {
            result.push_back(minimum);
        }
    }
    return result;
}

}  // namespace

Determination determination_of(bool lower_closed, bool upper_closed) {
    if (lower_closed && upper_closed) {
        return Determination::determined;
    }
    if (lower_closed) {
        return Determination::bounded_below;
    }
    return upper_closed ? Determination::bounded_above : Determination::undetermined;
}

std::vector<ProfileLikelihood> trace_profiles(const Search& search, Priors priors,
                                              std::span<const MinimumCluster> minima, MinimiseResult& best) {
    const std::vector<std::size_t> free = search.misfit.free_parameters();
    std::vector<ProfileLikelihood> profiles(free.size());
    constexpr int most_passes = 3;
    for (int pass = 0; pass < most_passes && best.found() && !search.stopped(); ++pass) {
        const std::vector<MinimumCluster> further = further_minima(search, priors, minima, best, best.evaluations);
        const auto all = share_tasks<Traced>(free.size(), search.workers(), [&](std::size_t number) {
            Tracer tracer(search, priors, free[number], best, further);
            Traced traced;
            traced.profile = tracer.trace();
            traced.lowest = tracer.lowest();
            traced.evaluations = tracer.evaluations();
            return traced;
        });
        Knot better_point{best.value - better, {}};
        for (std::size_t number = 0; number < free.size(); ++number) {
            profiles[number] = all[number].profile;
            best.evaluations.add(all[number].evaluations);
            if (all[number].lowest.misfit < better_point.misfit) {
                better_point = all[number].lowest;
            }
        }
        if (better_point.point.empty()) {
            break;
        }
        MinimiseResult polished = polish_best_of(search, priors, {better_point.point});
        polished.evaluations.add(best.evaluations);
        best = std::move(polished);
    }
    return search.stopped() || !best.found() ? std::vector<ProfileLikelihood>{} : profiles;
}

}  // namespace delabole
