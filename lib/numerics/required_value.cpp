#include "numerics/required_value.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

constexpr int linear_points = 257;
constexpr int points_per_decade = 12;
constexpr int decades = 12;  // above and below one SI unit
// Bounds beyond this only exclude absurd values (parameters/lengths.hpp): evenly spaced points would be too far apart.
constexpr double no_bound = 1e5;

double near_or_infinite(double bound) {
    return std::abs(bound) < no_bound ? bound : std::copysign(std::numeric_limits<double>::infinity(), bound);
}

}  // namespace

std::vector<double> search_points(const Interval& range, double present) {
    std::vector<double> values;
    const double lower = near_or_infinite(range.lower);
    const double upper = near_or_infinite(range.upper);
    if (std::isfinite(lower) && std::isfinite(upper)) {
        for (int index = 0; index < linear_points; ++index) {
            values.push_back(lower + (upper - lower) * index / (linear_points - 1));
        }
    } else {
        const double bound = std::isfinite(lower) ? lower : std::isfinite(upper) ? upper : 0;
        // Without bounds the present value is an origin as well: an elevation has answers only in a short interval far
        // from zero.
        std::vector<double> origins = {bound};
        if (std::isinf(lower) && std::isinf(upper)) {
            origins.push_back(present);
        }
        for (const double origin : origins) {
            values.push_back(origin);
            for (int step = -decades * points_per_decade; step <= decades * points_per_decade; ++step) {
                const double distance = std::pow(10.0, static_cast<double>(step) / points_per_decade);
                values.push_back(origin + distance);
                values.push_back(origin - distance);
            }
        }
    }
    values.push_back(present);
    std::erase_if(values, [&](double value) { return !range.contains(value); });
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

}  // namespace delabole
