// Contour lines of values on a grid.
#pragma once

#include "geometry/polyline.hpp"

#include <Eigen/Core>

#include <vector>

namespace delabole {

// Lines on which the values, interpolated linearly along the sides of the grid's cells, equal `level`. They are
// polylines joined from cell to cell; a closed one ends at its first point. values(row, column) belongs to
// (x_values[column], y_values[row]). A cell with a corner that is not finite has no line. In a saddle cell the mean of
// the corners decides which sides are connected. Empty if the sizes do not agree.
std::vector<Polyline> contour_lines(const std::vector<double>& x_values, const std::vector<double>& y_values,
                                    const Eigen::MatrixXd& values, double level);

// The polylines as a single Line, separated by points that are not finite.
Polyline broken_line(const std::vector<Polyline>& chains);

}  // namespace delabole
