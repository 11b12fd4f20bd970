#include "cases/program/terminal/progress.hpp"

#include <gtest/gtest.h>

#include <string>

namespace delabole {
namespace {

TEST(TimeLeft, IsWhatAnEvenPaceLeaves) {
    TimeLeft time;
    EXPECT_EQ(time.in_words(1, 0.01), "time left not known") << "of a single pace";
    for (int second = 2; second < 100; ++second) {
        // Seconds are rounded up, even those that only a rounding error has made more than a whole number.
        EXPECT_NEAR(std::stoi(time.in_words(second, second / 100.0)), 100 - second, 1);
    }
    TimeLeft long_work;
    long_work.in_words(5e3, 0.25);
    EXPECT_EQ(long_work.in_words(1e4, 0.5), "3 h left");
}

TEST(TimeLeft, IsNotKnownWhereThePaceHasChanged) {
    TimeLeft time;
    time.in_words(1, 0.4);
    std::string words;
    for (int second = 2; second <= 40; ++second) {
        words = time.in_words(second, 0.4 + 0.001 * second);
    }
    EXPECT_EQ(words, "time left not known");
    for (int second = 41; second <= 1000; ++second) {
        words = time.in_words(second, 0.44 + 0.0001 * second);
        EXPECT_NE(words, "0 s left");
    }
}

// This search soon saw where the answer lies and was slow to find it: 65 % in 25 s, then 0.04 % a second.
TEST(TimeLeft, IsNotKnownAfterAJump) {
    TimeLeft time;
    for (int second = 5; second <= 25; second += 5) {
        time.in_words(second, 0.026 * second);
    }
    time.in_words(30, 0.652);  // too soon to be seen
    for (int second = 35; second <= 200; second += 5) {
        EXPECT_EQ(time.in_words(second, 0.65 + 0.0004 * (second - 25)), "time left not known") << second;
    }
}

TEST(TimeLeft, IsNotKnownOfWorkThatStandsStill) {
    TimeLeft time;
    for (int second = 1; second < 10; ++second) {
        time.in_words(second, 0.5);
    }
    EXPECT_EQ(time.in_words(10, 0.5), "time left not known");
}

}  // namespace
}  // namespace delabole
