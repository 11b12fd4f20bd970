// Mean and standard deviation of a sample.
#pragma once

#include <cmath>
#include <numeric>
#include <span>

namespace delabole {

// NaN of no value.
inline double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Divides by one less than the number of values; NaN of fewer than two.
inline double deviation_of(std::span<const double> values) {
    const double mean = mean_of(values);
    double squares = 0;
    for (const double value : values) {
        squares += (value - mean) * (value - mean);
    }
    return std::sqrt(squares / (static_cast<double>(values.size()) - 1));
}

}  // namespace delabole
