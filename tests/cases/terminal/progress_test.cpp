#include "cases/program/terminal/progress.hpp"

#include <gtest/gtest.h>

#include <string>

namespace delabole {
namespace {

TEST(TimeLeft, IsWhatAnEvenPaceLeaves) {
    TimeLeft time;
    for (int second = 1; second < 100; ++second) {
        // Seconds are rounded up, what is a whole one but for rounding too.
        EXPECT_NEAR(std::stoi(time.in_words(second, second / 100.0)), 100 - second, 1);
    }
    EXPECT_EQ(TimeLeft().in_words(1e4, 0.5), "3 h left");
}

TEST(TimeLeft, IsNotKnownWhereThePaceHasChanged) {
    TimeLeft time;
    EXPECT_EQ(time.in_words(1, 0.4), "2 s left");
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

TEST(TimeLeft, IsNotKnownOfWorkThatStandsStill) {
    TimeLeft time;
    for (int second = 1; second < 10; ++second) {
        time.in_words(second, 0.5);
    }
    EXPECT_EQ(time.in_words(10, 0.5), "time left not known");
}

}  // namespace
}  // namespace delabole
