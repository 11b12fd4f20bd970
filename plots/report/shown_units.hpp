// Converts figures and tables, which are made in metric units, to the units in which the report shows them
// (fitting/work/words.hpp).
//
// An axis, or a column of a table, is converted if its unit is the one in which metric reports show a dimension; others
// do not change.
#pragma once

#include "plots/drawing/figure.hpp"
#include "plots/report/report.hpp"

namespace delabole {

Figure in_shown_units(Figure figure);
Report in_shown_units(Report report);

}  // namespace delabole
