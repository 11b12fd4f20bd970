// Independent tasks, shared among the threads of all ranks.
#pragma once

#include "fitting/search/minimise.hpp"
#include "fitting/work/parallel.hpp"
#include "fitting/work/ranks.hpp"
#include "numerics/archive.hpp"

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace delabole {

// Ranks exchange their results as archives, for which each struct needs its DELABOLE_MEMBERS.
DELABOLE_MEMBERS(EvaluationCount, total, optimiser_rejections, failed_by_cause)
DELABOLE_MEMBERS(MinimiseResult, status, point, value, evaluations)
DELABOLE_MEMBERS(Interval, lower, upper, lower_open, upper_open)

// Throws std::runtime_error where the data from another rank do not match what this rank expects.
inline void demand_whole(const ArchiveReader& reader) {
    if (!reader.whole()) {
        throw std::runtime_error("the ranks do not agree on what they work at: do all run the same program?");
    }
}

// The threads of this rank and the other ranks; no result depends on the number of either.
struct Workers {
    int threads = 1;
    const Ranks* ranks = nullptr;  // null: this process alone

    bool alone() const { return ranks == nullptr || ranks->alone(); }
};

// Runs task(0) ... task(count - 1), each once, and returns the results in this order on every rank. Rank number %
// (number of ranks) runs task `number`, because neighbouring tasks often cost about the same. Every rank has to call
// this, and not from within another task.
template <class Result>
std::vector<Result> share_tasks(std::size_t count, const Workers& workers,
                                const std::function<Result(std::size_t)>& task) {
    const auto ranks = static_cast<std::size_t>(workers.alone() ? 1 : workers.ranks->count());
    const auto own = static_cast<std::size_t>(workers.alone() ? 0 : workers.ranks->number());
    std::vector<Result> results(count);
    const std::size_t own_count = (count + ranks - 1 - own) / ranks;
    run_tasks(own_count, workers.threads, [&](std::size_t place) {
        const std::size_t number = own + place * ranks;
        results[number] = task(number);
    });
    if (workers.alone()) {
        return results;
    }
    ArchiveWriter writer;
    for (std::size_t number = own; number < count; number += ranks) {
        writer.put(results[number]);
    }
    const std::vector<std::string> all = workers.ranks->exchange(writer.bytes());
    for (std::size_t rank = 0; rank < ranks; ++rank) {
        ArchiveReader reader(all[rank]);
        for (std::size_t number = rank; number < count; number += ranks) {
            reader.get(results[number]);
        }
        demand_whole(reader);
    }
    return results;
}

}  // namespace delabole
