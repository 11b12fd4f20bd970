// Contour lines of values on a grid.
#pragma once

#include "geometry/polyline.hpp"

#include <Eigen/Core>

#include <vector>

namespace delabole {

// Where the values, interpolated linearly along the sides of the grid's cells, equal `level`: chains, joined from cell
// to cell, closed ones ending at their first point. values(row, column) stands at (x_values[column], y_values[row]). A
// cell with a corner that is not finite has no line. In a saddle cell the mean of the corners decides which way the
// lines part. Empty when sizes do not agree.
std::vector<Polyline> contour_lines(const std::vector<double>& x_values, const std::vector<double>& y_values,
                                    const Eigen::MatrixXd& values, double level);

// The chains one after another, parted by a point that is not finite, as a single broken Line wants them.
Polyline broken_line(const std::vector<Polyline>& chains);

}  // namespace delabole
