// Minimum and root of a function of one variable that may have no value (infinity or NaN) in parts of its range.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace delabole {

struct ScalarMinimum {
    double position;
    double value;      // not finite where no scanned point has a finite value, or where one is minus infinity
    bool at_boundary;  // at an end of the range, or where values end
};

// Equally spaced scan of `points` >= 3 values, then the root of the slope (Brent, GSL) in the interval beside the
// lowest value into which the function falls: the position is good to rounding, which values alone cannot give (they
// resolve only the square root of it). A kink is found as well as a smooth minimum; where values end, the end is found
// by bisection. Global only as far as the scan resolves it.
ScalarMinimum minimise_scalar(const std::function<double(double)>& value, const std::function<double(double)>& slope,
                              double lower, double upper, int points);

struct ScalarRoot {
    std::optional<double> position;  // absent where no change of sign was seen
    double lowest;                   // range of function values seen, for the message when there is no root
    double highest;
    int sign_changes;  // seen in the scan; the root nearest to the lower end is returned
};

// Scan at increasing `candidates`, bisection to the edge of the valid range where values are missing, then Brent's root
// (GSL) to full double precision.
ScalarRoot find_root(const std::function<double(double)>& function, const std::vector<double>& candidates);

}  // namespace delabole
