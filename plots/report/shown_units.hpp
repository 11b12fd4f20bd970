// Figures and tables, made in metric units, in those in which the report is to show them (fitting/work/words.hpp).
//
// An axis, and a column of a table, is converted where its unit is one in which metric reports show a dimension;
// others stay as they are.
#pragma once

#include "plots/drawing/figure.hpp"
#include "plots/report/report.hpp"

namespace delabole {

Figure in_shown_units(Figure figure);
Report in_shown_units(Report report);

}  // namespace delabole
