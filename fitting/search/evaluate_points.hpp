// One quantity evaluated at many points, on several threads of several ranks.
#pragma once

#include "fitting/search/minimise.hpp"
#include "fitting/search/share.hpp"
#include "fitting/work/progress.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace delabole {

// Sets the parameters of the point of that index. Safe to call from several threads. Each rank calls it for its own
// points only, so anything else that it stores is unknown to the other ranks.
using PointOf = std::function<void(std::size_t index, std::span<double> parameters)>;

// A sum of squares that may be left unfinished once it exceeds `most`: its value is then some number above that.
using BoundedObjective = std::function<Evaluation(std::span<const double> parameters, double most)>;

struct Evaluator {
    const Objective& quantity;  // pure, safe to call from several threads
    ProgressMeter& progress;
    StopFlag stop = nullptr;
    int threads = 1;
    const Ranks* ranks = nullptr;               // null: this process alone
    const BoundedObjective* bounded = nullptr;  // the same quantity; null: it is always finished

    Workers workers() const { return {threads, ranks}; }
    bool stopped() const { return stop_requested(stop); }
    Evaluation value(std::span<const double> parameters, double most) const {
        return bounded != nullptr ? (*bounded)(parameters, most) : quantity(parameters);
    }

    // Evaluations of points 0 ... count - 1 in order; if the work was stopped, of those before the first point left
    // out. Every rank has to call this, from the thread that made Ranks.
    std::vector<Evaluation> evaluate(std::size_t dimension, std::size_t count, const PointOf& point) const;
};

}  // namespace delabole
