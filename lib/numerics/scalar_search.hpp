// Minimum and root of a function of one variable that may have no value (infinity or NaN) in parts of its range.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace delabole {

struct ScalarMinimum {
    double position;
    double value;      // not finite if no scanned point has a finite value, or if one is minus infinity
    bool at_boundary;  // at an end of the range, or where values end
};

// Equally spaced scan of `points` >= 3 values, then the root of the derivative (Brent, GSL) in the interval beside the
// lowest value into which the function decreases: the position is accurate to rounding, whereas values alone resolve
// only its square root. A kink is found as well as a smooth minimum; where values end, bisection finds the end. Global
// only as far as the scan resolves it.
ScalarMinimum minimise_scalar(const std::function<double(double)>& value, const std::function<double(double)>& slope,
                              double lower, double upper, int points);

struct ScalarRoot {
    std::optional<double> position;  // absent if the function passes through zero nowhere
    double lowest;                   // range of function values found, for the message if there is no root
    double highest;
    int sign_changes;            // found in the scan; the root nearest to the lower end is returned
    bool rises;                  // with increasing argument, through this root
    std::optional<double> jump;  // the first place where the function jumps over zero
};

// Scan at increasing `candidates`, bisection to the edge of the valid range where values are missing, then Brent's root
// (GSL) to full double precision.
ScalarRoot find_root(const std::function<double(double)>& function, const std::vector<double>& candidates);

}  // namespace delabole
