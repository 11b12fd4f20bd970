// The tilting frame of chapter 3 in motion.
#include "cases/program/thesis/chapter_3/tilting_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

// The frame turns by less than this while a column begins to fall: half a degree a second, some tenths of a second.
constexpr double late = degrees(0.3);

TEST(TiltingRuns, WornEdgesMakeAColumnNarrower) {
    constexpr double wear = 0.05;
    const double tilt = critical_tilt(WornColumn{3, false, wear, 0, 1}).value();
    const double narrower = std::atan((1 - 2 * wear) / 3);
    EXPECT_GT(tilt, narrower - degrees(0.01));  // springs of a draft give way by 1e-4 rad
    EXPECT_LT(tilt, narrower + late);
    // Cubes stacked in line act as one column.
    EXPECT_NEAR(critical_tilt(WornColumn{3, true, wear, 0, 1}).value(), narrower + late / 2, late);
}

TEST(TiltingRuns, NeighboursHelpAndNineColumnsCrackBehindTheSixth) {
    const auto tilt_of = [](std::size_t columns) {
        const FrameRow row{std::vector<double>(columns, 5), {degrees(15), degrees(33), 0}, 1};
        return tilt_until_failure(row).value().tilt;
    };
    EXPECT_NEAR(tilt_of(1), std::atan(0.2) + late / 2, late);
    EXPECT_GT(tilt_of(2), tilt_of(1) + degrees(1));
    // Limit equilibrium with 20 deg of friction everywhere gives the same.
    const FrameRow nine{{1, 2, 3, 4, 5, 4, 3, 2, 1}, {degrees(20), degrees(20), 0}, 1};
    const FrameFailure failure = tilt_until_failure(nine).value();
    EXPECT_NEAR(failure.crack_tilt, degrees(16), late);
    EXPECT_EQ(failure.crack_after, 6U);
}

}  // namespace
}  // namespace delabole
