// The items of the thesis's chapter 3: base friction tests and the tilting frame.
#pragma once

#include "cases/program/thesis/reproduction.hpp"

namespace delabole {

Reproduction reproduce_base_friction_run(const ResultFolder& folder, Report& report);
Reproduction reproduce_table_3_2(const ResultFolder& folder, Report& report);
Reproduction reproduce_base_friction_plates(const ResultFolder& folder, Report& report);
Reproduction reproduce_tilting_runs(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_3_2(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_3_6(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_3_7(const ResultFolder& folder, Report& report);

}  // namespace delabole
