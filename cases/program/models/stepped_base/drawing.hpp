// The data of the figures of columns on a stepped base, from the model.
#pragma once

#include "limit_equilibrium/stepped_base/stepped_base.hpp"
#include "plots/figures/block_figures.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace delabole {

constexpr std::size_t most_drawn_columns = 1000;  // more are no picture

DrawnMode drawn(ColumnMode mode);

// Columns with their modes and forces, the wedge above them, ground and water. Of more than 30 columns the forces of
// one in so many are drawn. `slope` is the problem's, and valid; `columns` as column_results gives them for the
// strength divided by `factor`.
BlockDrawing column_drawing(const SteppedBase<>& problem, const ColumnSlope<>& slope,
                            const std::vector<ColumnResult>& columns, double factor, const std::string& title);

// Force that each column needs from the one below it.
// A cable whose force was solved for.
DrawnForce required_force(const ColumnSlope<>& slope, const RequiredCable<>& cable, double force);

ForceAlongSlope force_along_columns(const std::vector<ColumnResult>& columns, const std::string& title);

// Observed and predicted ground after the failure, over a section.
void add_profiles(Figure& figure, const Polyline& observed, const Polyline& predicted, double toe_elevation);

}  // namespace delabole
