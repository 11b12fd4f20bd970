// The range that finite numbers span.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

struct Extent {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    // Numbers that are not finite are passed over.
    void include(double value) {
        if (std::isfinite(value)) {
            lowest = std::min(lowest, value);
            highest = std::max(highest, value);
        }
    }
    bool empty() const { return lowest > highest; }
    double size() const { return highest - lowest; }
};

}  // namespace delabole
