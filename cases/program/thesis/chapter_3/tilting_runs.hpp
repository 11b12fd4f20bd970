// The tilting frame of section 3.3 as runs: columns an inch thick on a base that turns until the first of them fails.
#pragma once

#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace delabole {

// Friction of plaster: means, and the standard deviation of every joint; heights scatter as the saw cuts them.
struct PlasterFriction {
    double interface;  // rad, between columns
    double base;
    double deviation;
};

// in, of the columns of the tests
inline constexpr int least_height = 2;
inline constexpr int most_height = 9;

// Heights grow from 1 by 1 inch and fall again; the greatest stands twice if the number of columns is even (3.3.2.2).
std::vector<double> growing_and_falling(int count);

struct FrameRow {
    std::vector<double> heights;  // in
    PlasterFriction friction;
    std::uint64_t seed;
};

struct FrameFailure {
    double tilt = 0;              // rad, at which the first column has turned or slid beyond a threshold
    double crack_tilt = 0;        // rad, of the first tension crack; infinite: none before
    std::size_t crack_after = 0;  // number of the column below it; 0: none
};

// Tilts the row evenly from below any failure up to 40 deg, or until a column fails. Absent if the run broke off.
std::optional<FrameFailure> tilt_until_failure(const FrameRow& row);

// One column, in one piece or of cubes, with worn edges: each corner lacks `wear` inches, and every cube lies out of
// line with the one below by up to `offset` inches.
struct WornColumn {
    int height;  // in
    bool cubes;
    double wear;
    double offset;
    std::uint64_t seed;
};

std::optional<double> critical_tilt(const WornColumn& column);

// Tilts a row to 40 deg, whatever happens, to show how it stands at given tilts.
RelaxationRun tilt_all_the_way(const FrameRow& row);

}  // namespace delabole
