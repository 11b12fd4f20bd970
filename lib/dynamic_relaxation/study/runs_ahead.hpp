// Runs of a search that are made before the search asks for them, on threads that would be idle.
#pragma once

#include "dynamic_relaxation/step/state.hpp"
#include "dynamic_relaxation/study/critical.hpp"

#include <atomic>
#include <cstddef>
#include <functional>
#include <future>
#include <list>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace delabole {

// The verdict of a run, and the state in which its blocks failed or came to rest.
struct SearchRun {
    CriticalProbe probe;
    std::optional<RelaxationState> end = {};
};

using CriticalSearchProbe = std::function<CriticalProbe(double value)>;

// The values for which a search asks after its present one, whichever way the verdicts turn out, the next ones first;
// at most so many. `search` calls find_critical with the probe given; `verdicts`: those before the present one.
std::vector<double> asked_next(const std::function<CriticalValue(const CriticalSearchProbe& probe)>& search,
                               const std::vector<CriticalProbe>& verdicts, std::size_t most);

class RunsAhead {
  public:
    // Must give the same run whenever and wherever it is called; once `stop` is set, its run is not needed any more.
    using Make = std::function<SearchRun(double value, const std::atomic<bool>& stop)>;

    // At most so many runs at once.
    RunsAhead(std::size_t most, Make make) : most_(most), make_(std::move(make)) {}
    ~RunsAhead() { stop(); }
    RunsAhead(const RunsAhead&) = delete;
    RunsAhead& operator=(const RunsAhead&) = delete;

    std::size_t most() const { return most_; }

    // Begins the runs at the next values as far as threads are free, in their order, and stops those at all values but
    // these and the present one. The caller makes the run at the present value, unless it was begun before.
    void make(double present, std::span<const double> next);

    // Stops all runs and waits until they have ended.
    void stop();

    // The run at this value; empty if none was begun. It is waited for as long as `goes_on`, which is called ten times
    // a second, returns true, and stopped then: its outcome is `interrupted`.
    std::optional<SearchRun> take(double value, const std::function<bool()>& goes_on);

  private:
    struct Run {
        explicit Run(double at) : value(at) {}

        double value;
        std::atomic<bool> stop = false;
        std::future<SearchRun> made = {};  // destroyed first, which waits until the thread has ended
    };

    void keep_only(std::span<const double> values);

    std::size_t most_;
    Make make_;
    std::list<Run> runs_ = {};
};

}  // namespace delabole
