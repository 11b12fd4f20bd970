// Equally spaced values of an input.
#pragma once

#include <cstdint>
#include <vector>

namespace delabole {

// Begins and ends exactly at the given values; a single value is the first of them.
inline std::vector<double> spaced_values(double from, double to, std::int64_t points) {
    std::vector<double> values;
    for (std::int64_t index = 0; index < points; ++index) {
        values.push_back(index == 0 ? from
                         : index + 1 < points
                             ? from + (to - from) * static_cast<double>(index) / static_cast<double>(points - 1)
                             : to);
    }
    return values;
}

}  // namespace delabole
