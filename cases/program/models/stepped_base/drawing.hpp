// The single columns on a stepped base as named outputs, as a table of the report, as CSV and in figures.
#pragma once

#include "cases/program/results/analysis.hpp"
#include "cases/program/results/result_folder.hpp"
#include "limit_equilibrium/stepped_base/stepped_base.hpp"
#include "plots/figures/block_figures.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace delabole {

// "column[3].lower_force", "column[3].mode", ... for up to 200 columns; nothing for more.
void append_column_outputs(Analysis& analysis, const std::vector<ColumnResult>& columns);

// At most 60 rows; for more columns every second, fifth, tenth, ... is listed.
Table column_table(const std::string& caption, const std::vector<ColumnResult>& columns);

// All columns at the given strength and, if it exists, in limiting equilibrium.
std::string columns_csv(const std::vector<ColumnResult>& as_given, const std::vector<ColumnResult>& limiting);

constexpr std::size_t most_drawn_columns = 1000;  // the picture of more columns would be illegible

DrawnMode drawn(ColumnMode mode);

// Columns with their modes and forces, the wedge above them, ground and water. If there are more than 30 columns,
// forces are drawn only for some of them at equal intervals. `slope` is that of the problem and valid; `columns` is
// from column_results for the strength divided by `factor`.
BlockDrawing column_drawing(const SteppedBase<>& problem, const ColumnSlope<>& slope,
                            const std::vector<ColumnResult>& columns, double factor, const std::string& title);

// The required force of a cable, from where its line enters the column.
DrawnForce required_force(const ColumnScene<>& scene, const ColumnSlope<>& slope, const RequiredCable<>& cable,
                          double force);

// Force that each column needs from the one below it.
ForceAlongSlope force_along_columns(const std::vector<ColumnResult>& columns, const std::string& title);

// Adds the observed and predicted ground after the failure to a section.
void add_profiles(Figure& figure, const Polyline& observed, const Polyline& predicted, double toe_elevation);

}  // namespace delabole
