#include "dynamic_relaxation/study/runs_ahead.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <new>
#include <optional>
#include <thread>
#include <vector>

namespace delabole {
namespace {

CriticalProbe verdict(bool stands) {
    return {stands ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset, 0};
}

TEST(RunsAhead, AreAtTheValuesThatABisectionAsksForNext) {
    const auto search = [](const CriticalSearchProbe& probe) { return find_critical(probe, 1, 3, 0.1); };
    EXPECT_EQ(asked_next(search, {}, 1), std::vector<double>{3});
    EXPECT_EQ(asked_next(search, {}, 4), (std::vector<double>{3, 2, 2.5, 1.5}));
    const std::vector<CriticalProbe> bounds{verdict(true), verdict(false)};
    EXPECT_EQ(asked_next(search, bounds, 2), (std::vector<double>{2.5, 1.5}));
    // Bounds nearer than the tolerance are the answer, whatever the verdict at the second one is.
    const auto wide = [](const CriticalSearchProbe& probe) { return find_critical(probe, 1, 3, 2.5); };
    EXPECT_TRUE(asked_next(wide, {verdict(true)}, 8).empty());
}

// Runs at negative values end only when they are stopped.
SearchRun made_at(double value, const std::atomic<bool>& stop) {
    while (value < 0 && !stop) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return {{RelaxationOutcome::equilibrium, static_cast<std::uint64_t>(std::abs(value))}};
}

bool goes_on() {
    return true;
}

TEST(RunsAhead, AreBegunInOrderWhereThreadsAreFreeAndStoppedWhereNotNeeded) {
    RunsAhead ahead(2, made_at);
    ahead.make(0, std::vector<double>{-1, 2, 3});
    EXPECT_FALSE(ahead.take(0, goes_on));
    EXPECT_FALSE(ahead.take(3, goes_on));
    const std::optional<SearchRun> two = ahead.take(2, goes_on);
    ASSERT_TRUE(two);
    EXPECT_EQ(two->probe.steps, 2U);
    EXPECT_FALSE(ahead.take(2, goes_on));
    // The run at -1 is the present one: the caller's thread is free for one more.
    ahead.make(-1, std::vector<double>{4, 5, 6});
    EXPECT_EQ(ahead.take(4, goes_on)->probe.steps, 4U);
    EXPECT_EQ(ahead.take(5, goes_on)->probe.steps, 5U);
    EXPECT_FALSE(ahead.take(6, goes_on));
    int asked = 0;
    EXPECT_EQ(ahead.take(-1, [&] { return ++asked < 2; })->probe.outcome, RelaxationOutcome::interrupted);
    EXPECT_EQ(asked, 2);
    EXPECT_FALSE(ahead.take(-1, goes_on));
    ahead.make(0, std::vector<double>{-7});
}

TEST(RunsAhead, PassOnExceptions) {
    RunsAhead ahead(1, [](double, const std::atomic<bool>&) -> SearchRun { throw std::bad_alloc(); });
    ahead.make(0, std::vector<double>{1});
    EXPECT_THROW(ahead.take(1, goes_on), std::bad_alloc);
}

}  // namespace
}  // namespace delabole
