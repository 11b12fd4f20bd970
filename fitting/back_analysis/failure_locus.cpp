#include "fitting/back_analysis/steps.hpp"

#include "fitting/probability/bracketed_root.hpp"
#include "fitting/work/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <utility>

namespace delabole {

namespace {

constexpr int scan_points = 17;
constexpr double locus_tolerance = 1e-10;  // of the range
constexpr double node_root = 1e-12;        // |FS - 1| up to this is a root: rounding must not hide one at an end
constexpr double root_check = 1e-6;        // |FS - 1| above this at a sign change is a jump, not a root

// FS - 1 as a function in the plane of two parameters.
class Plane {
  public:
    Plane(const Search& search, std::span<const double> best, std::size_t output, EvaluationCount& account)
        : search_(search), point_(best.begin(), best.end()), output_(output), account_(account) {}

    void set(std::size_t parameter, double value) { point_[parameter] = value; }

    double operator()(std::size_t parameter, double value) {
        point_[parameter] = value;
        search_.progress.count();
        const Prediction prediction = search_.misfit.predict(point_);
        const double excess =
            prediction.failure.empty() ? prediction.outputs[output_] - 1 : std::numeric_limits<double>::quiet_NaN();
        account_.record({excess, prediction.failure});
        return std::isfinite(excess) ? excess : std::numeric_limits<double>::quiet_NaN();
    }

  private:
    const Search& search_;
    std::vector<double> point_;
    std::size_t output_;
    EvaluationCount& account_;
};

std::vector<double> roots_along(Plane& plane, std::size_t parameter, const Interval& range) {
    const std::vector<double> values = grid(range, scan_points);
    const auto function = [&](double value) { return plane(parameter, value); };
    const double tolerance = locus_tolerance * (range.upper - range.lower);
    std::vector<double> roots;
    double previous = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t index = 0; index < values.size(); ++index) {
        double current = function(values[index]);
        if (std::abs(current) <= node_root) {
            roots.push_back(values[index]);
            // already found: a change of sign must not count it again
            current = std::numeric_limits<double>::quiet_NaN();
        } else if (previous * current < 0) {  // false for NaN
            const auto root =
                bracketed_root(function, {values[index - 1], values[index], previous, current}, tolerance);
            if (root && std::abs(function(*root)) < root_check) {
                roots.push_back(*root);
            }
        }
        previous = current;
    }
    return roots;
}

// Follows branches from one column of roots to the next. If the number of roots changes, it is unknown which root
// continues which branch, so all branches begin anew.
class Branches {
  public:
    void add_column(const std::vector<double>& roots, double across, bool swapped) {
        if (roots.size() != open_.size()) {
            open_.resize(roots.size());
            for (std::vector<Point>*& branch : open_) {
                branch = &all_.emplace_back();
            }
        }
        for (std::size_t index = 0; index < roots.size(); ++index) {
            open_[index]->push_back(swapped ? Point(roots[index], across) : Point(across, roots[index]));
        }
    }

    void write(FailureLocus& locus) const {
        int number = 0;
        for (const std::vector<Point>& branch : all_) {
            locus.points.insert(locus.points.end(), branch.begin(), branch.end());
            locus.branch.insert(locus.branch.end(), branch.size(), number);
            ++number;
        }
    }

  private:
    std::list<std::vector<Point>> all_;
    std::vector<std::vector<Point>*> open_;
};

// Difference between the greatest and least factor of safety over the range of one parameter.
double spread_along(Plane plane, std::size_t parameter, const Interval& range) {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (const double value : grid(range, 5)) {
        const double excess = plane(parameter, value);
        if (!std::isnan(excess)) {
            least = std::min(least, excess);
            greatest = std::max(greatest, excess);
        }
    }
    return greatest > least ? greatest - least : 0;
}

struct Pair {
    std::size_t x;
    std::size_t y;
    bool scan_x;
};

FailureLocus trace(const Search& search, Plane plane, const Pair& pair) {
    const Misfit& misfit = search.misfit;
    FailureLocus locus{misfit.mechanism().parameters[pair.x].name, misfit.mechanism().parameters[pair.y].name, {}, {}};
    const std::size_t along = pair.scan_x ? pair.x : pair.y;
    const std::size_t across = pair.scan_x ? pair.y : pair.x;
    Branches branches;
    for (const double value : grid(misfit.bounds()[across], misfit.problem().settings.map_points)) {
        if (search.stopped()) {
            break;
        }
        plane.set(across, value);
        branches.add_column(roots_along(plane, along, misfit.bounds()[along]), value, pair.scan_x);
    }
    branches.write(locus);
    return locus;
}

}  // namespace

std::vector<FailureLocus> trace_failure_loci(const Search& search, std::span<const double> best,
                                             EvaluationCount& account) {
    const Misfit& misfit = search.misfit;
    const auto output = misfit.output("factor_of_safety");
    const std::vector<std::size_t> free = misfit.free_parameters();
    if (!output || free.size() < 2 || search.surrogate != nullptr) {
        return {};
    }
    std::vector<std::pair<std::size_t, double>> spreads;
    for (const std::size_t parameter : free) {
        const Plane plane(search, best, *output, account);
        const double spread = spread_along(plane, parameter, misfit.bounds()[parameter]);
        if (spread > 1e-12) {
            spreads.emplace_back(parameter, spread);
        }
    }
    std::vector<Pair> pairs;
    for (std::size_t first = 0; first < spreads.size(); ++first) {
        for (std::size_t second = first + 1; second < spreads.size(); ++second) {
            const bool scan_x = spreads[first].second > spreads[second].second;
            pairs.push_back({spreads[first].first, spreads[second].first, scan_x});
        }
    }
    using Traced = std::pair<FailureLocus, EvaluationCount>;
    const auto all = share_tasks<Traced>(pairs.size(), search.workers(), [&](std::size_t number) {
        Traced traced;
        traced.first = trace(search, Plane(search, best, *output, traced.second), pairs[number]);
        return traced;
    });
    std::vector<FailureLocus> loci;
    for (const auto& [locus, evaluations] : all) {
        loci.push_back(locus);
        account.add(evaluations);
    }
    return loci;
}

}  // namespace delabole
