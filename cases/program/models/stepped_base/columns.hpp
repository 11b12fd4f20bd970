// Columns on a stepped base one by one: as named answers, as a table of the report and as CSV.
#pragma once

#include "cases/program/results/analysis.hpp"
#include "cases/program/results/result_folder.hpp"
#include "limit_equilibrium/stepped_base/stepped_base.hpp"

#include <string>
#include <vector>

namespace delabole {

// "column[3].lower_force", "column[3].mode", ...: for slopes of up to 200 columns, nothing for more.
void append_column_outputs(Analysis& analysis, const std::vector<ColumnResult>& columns);

// Up to 60 rows; of more columns, every second, fifth, tenth, ...
Table column_table(const std::string& caption, const std::vector<ColumnResult>& columns);

// All columns at the given strength and, where it exists, in limiting equilibrium.
std::string columns_csv(const std::vector<ColumnResult>& as_given, const std::vector<ColumnResult>& limiting);

}  // namespace delabole
