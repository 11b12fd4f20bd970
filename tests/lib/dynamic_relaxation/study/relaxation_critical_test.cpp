#include "dynamic_relaxation/study/critical.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

constexpr std::uint64_t steps_of_a_run = 10;

CriticalProbe stands_if(bool stands) {
    return {stands ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset, steps_of_a_run};
}

TEST(FindCritical, BracketsTheChangeFromEitherSide) {
    constexpr double change = 0.3217;
    constexpr double tolerance = 1e-4;
    for (const bool stands_low : {true, false}) {
        const auto probe = [&](double value) { return stands_if((value < change) == stands_low); };
        const CriticalValue critical = find_critical(probe, stands_low ? 0 : 1, stands_low ? 1 : 0, tolerance);
        ASSERT_EQ(critical.status, CriticalStatus::found);
        EXPECT_LE(std::abs(critical.stands - critical.fails), tolerance);
        EXPECT_TRUE(probe(critical.stands).outcome == RelaxationOutcome::equilibrium);
        EXPECT_TRUE(probe(critical.fails).outcome == RelaxationOutcome::onset);
        EXPECT_NEAR(critical.value(), change, tolerance);
        // The search runs both ends, then 14 halvings of 1 to below 1e-4.
        EXPECT_EQ(critical.runs, 16U);
        EXPECT_EQ(critical.steps, critical.runs * steps_of_a_run);
    }
}

// Bisection of 1 to 4 goes 2, 1.41, 1.68, 1.54, 1.47 and would end between 1.47 and 1.51, beyond the values from 1.40
// to 1.46 at which it fails.
TEST(FindCritical, RatiosAtWhichItStandsAgainAreNoAnswer) {
    const auto probe = [](double value) { return stands_if(value < 1.34 || (value > 1.405 && value < 1.5)); };
    const auto in_motion = [](CriticalProbe run) {
        run.rested_in_motion = true;
        return run;
    };
    for (const bool stands_low : {true, false}) {
        const auto turned = [&](double value) { return in_motion(probe(stands_low ? value : 4 / value)); };
        const double mild = stands_low ? 1 : 4;
        const double strong = stands_low ? 4 : 1;
        const CriticalValue critical = find_critical(turned, mild, strong, 0.01, BracketMean::geometric);
        ASSERT_EQ(critical.status, CriticalStatus::found);
        ASSERT_TRUE(critical.stands_again);
        EXPECT_NEAR(stands_low ? *critical.stands_again : 4 / *critical.stands_again, 1.5, 0.01);
        EXPECT_NEAR(stands_low ? critical.value() : 4 / critical.value(), 1.34, 0.01);
    }
    const CriticalValue in_balance = find_critical(probe, 1, 4, 0.01, BracketMean::geometric);
    EXPECT_FALSE(in_balance.stands_again);
    EXPECT_NEAR(in_balance.value(), 1.5, 0.01);
    const CriticalValue once = find_critical([&](double value) { return in_motion(stands_if(value < 1.38)); }, 1, 4,
                                             0.01, BracketMean::geometric);
    EXPECT_FALSE(once.stands_again);
    EXPECT_NEAR(once.value(), 1.38, 0.01);
}

TEST(FindCritical, CollapseCountsAsFailure) {
    const auto probe = [](double value) {
        return CriticalProbe{value < 0.5 ? RelaxationOutcome::equilibrium : RelaxationOutcome::collapse, 1};
    };
    EXPECT_EQ(find_critical(probe, 0, 1, 0.1).status, CriticalStatus::found);
}

TEST(FindCritical, SaysWhichBoundIsWrong) {
    EXPECT_EQ(find_critical([](double) { return stands_if(true); }, 0, 1, 0.1).status,
              CriticalStatus::stands_everywhere);
    const CriticalValue fails = find_critical([](double) { return stands_if(false); }, 0, 1, 0.1);
    EXPECT_EQ(fails.status, CriticalStatus::fails_everywhere);
    EXPECT_EQ(fails.runs, 1U);
}

TEST(FindCritical, EndsWithTheBracketSoFarWhereARunHasNoAnswer) {
    const auto end_at_a_quarter = [](RelaxationOutcome outcome) {
        return find_critical(
            [&](double value) {
                return value == 0.25 ? CriticalProbe{outcome, 1} : stands_if(value < 0.3);
            },
            0, 1, 1e-3);
    };
    const CriticalValue undecided = end_at_a_quarter(RelaxationOutcome::undecided);
    EXPECT_EQ(undecided.status, CriticalStatus::undecided);
    EXPECT_EQ(undecided.stands, 0);
    EXPECT_EQ(undecided.fails, 0.5);
    EXPECT_EQ(undecided.last, 0.25);
    EXPECT_EQ(end_at_a_quarter(RelaxationOutcome::interrupted).status, CriticalStatus::interrupted);
    EXPECT_EQ(end_at_a_quarter(RelaxationOutcome::overlap_too_large).status, CriticalStatus::run_failed);
    EXPECT_EQ(end_at_a_quarter(RelaxationOutcome::scene_not_valid).status, CriticalStatus::not_valid);
}

TEST(FindCritical, EndsWhereDoublesEnd) {
    const CriticalValue critical = find_critical([](double value) { return stands_if(value < 0.3); }, 0, 1, 1e-300);
    EXPECT_EQ(critical.status, CriticalStatus::found);
    EXPECT_EQ(std::nextafter(critical.stands, 1), critical.fails);
}

}  // namespace
}  // namespace delabole
