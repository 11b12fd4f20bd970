#include "dynamic_relaxation/study/runs_ahead.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <system_error>
#include <utility>
#include <vector>

namespace delabole {

namespace {

bool has_ended(const std::future<SearchRun>& run, std::chrono::milliseconds after) {
    return run.wait_for(after) == std::future_status::ready;
}

}  // namespace

std::vector<double> asked_next(const std::function<CriticalValue(const CriticalSearchProbe& probe)>& search,
                               const std::vector<CriticalProbe>& verdicts, std::size_t most) {
    const auto value_after = [&](const std::vector<CriticalProbe>& supposed) {
        std::optional<double> asked;
        std::size_t number = 0;
        search([&](double at) {
            if (number < supposed.size()) {
                return supposed[number++];
            }
            asked = at;
            return CriticalProbe{RelaxationOutcome::interrupted, 0};
        });
        return asked;
    };
    std::vector<double> values;
    std::deque<std::vector<CriticalProbe>> supposed{verdicts};
    while (!supposed.empty() && values.size() < most) {
        const std::optional<double> asked = value_after(supposed.front());
        if (asked && supposed.front().size() > verdicts.size() && std::ranges::find(values, *asked) == values.end()) {
            values.push_back(*asked);
        }
        for (const RelaxationOutcome outcome : {RelaxationOutcome::equilibrium, RelaxationOutcome::onset}) {
            if (asked) {
                supposed.push_back(supposed.front());
                supposed.back().push_back({outcome, 0});
            }
        }
        supposed.pop_front();
    }
    return values;
}

void RunsAhead::keep_only(std::span<const double> values) {
    for (Run& run : runs_) {
        run.stop = run.stop || std::ranges::find(values, run.value) == values.end();
    }
    std::erase_if(runs_, [](const Run& run) { return run.stop && has_ended(run.made, std::chrono::milliseconds(0)); });
}

void RunsAhead::stop() {
    keep_only({});
    runs_.clear();
}

void RunsAhead::make(double present, std::span<const double> next) {
    std::vector<double> kept(next.begin(), next.end());
    kept.push_back(present);
    keep_only(kept);
    const auto is_made = [&](double value) {
        return std::ranges::any_of(runs_, [&](const Run& run) { return run.value == value && !run.stop; });
    };
    // The caller waits for a run at the present value: its own thread is free.
    const std::size_t most = most_ + (is_made(present) ? 1 : 0);
    for (const double value : next) {
        if (!is_made(value) && runs_.size() < most) {
            Run& run = runs_.emplace_back(value);
            try {
                run.made =
                    std::async(std::launch::async, [this, value, &stop = run.stop] { return make_(value, stop); });
            } catch (const std::system_error&) {
                runs_.pop_back();  // no more threads: the search makes the run when it asks for it
                return;
            }
        }
    }
}

std::optional<SearchRun> RunsAhead::take(double value, const std::function<bool()>& goes_on) {
    const auto run = std::ranges::find_if(runs_, [&](const Run& one) { return one.value == value && !one.stop; });
    if (run == runs_.end()) {
        return std::nullopt;
    }
    while (!has_ended(run->made, std::chrono::milliseconds(100))) {
        if (!goes_on()) {
            run->stop = true;
            return SearchRun{{RelaxationOutcome::interrupted, 0}};
        }
    }
    std::future<SearchRun> made = std::move(run->made);
    runs_.erase(run);
    return made.get();
}

}  // namespace delabole
