// Columns on a stepped base one by one: as named answers, as a table of the report, as CSV and in figures.
#pragma once

#include "cases/program/results/analysis.hpp"
#include "cases/program/results/result_folder.hpp"
#include "limit_equilibrium/stepped_base/stepped_base.hpp"
#include "plots/figures/block_figures.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace delabole {

// "column[3].lower_force", "column[3].mode", ...: for slopes of up to 200 columns, nothing for more.
void append_column_outputs(Analysis& analysis, const std::vector<ColumnResult>& columns);

// Up to 60 rows; of more columns, every second, fifth, tenth, ...
Table column_table(const std::string& caption, const std::vector<ColumnResult>& columns);

// All columns at the given strength and, where it exists, in limiting equilibrium.
std::string columns_csv(const std::vector<ColumnResult>& as_given, const std::vector<ColumnResult>& limiting);

constexpr std::size_t most_drawn_columns = 1000;  // more are no picture

DrawnMode drawn(ColumnMode mode);

// Columns with their modes and forces, the wedge above them, ground and water. Of more than 30 columns the forces of
// one in so many are drawn. `slope` is the problem's, and valid; `columns` as column_results gives them for the
// strength divided by `factor`.
BlockDrawing column_drawing(const SteppedBase<>& problem, const ColumnSlope<>& slope,
                            const std::vector<ColumnResult>& columns, double factor, const std::string& title);

// A cable whose force was solved for.
DrawnForce required_force(const ColumnSlope<>& slope, const RequiredCable<>& cable, double force);

// Force that each column needs from the one below it.
ForceAlongSlope force_along_columns(const std::vector<ColumnResult>& columns, const std::string& title);

// Observed and predicted ground after the failure, over a section.
void add_profiles(Figure& figure, const Polyline& observed, const Polyline& predicted, double toe_elevation);

}  // namespace delabole
