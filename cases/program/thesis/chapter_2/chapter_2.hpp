// The items of the thesis's chapter 2 that stand in files of their own.
#pragma once

#include "cases/program/thesis/reproduction.hpp"

namespace delabole {

Reproduction reproduce_mechanisms(const ResultFolder& folder, Report& report);
Reproduction reproduce_groundwater(const ResultFolder& folder, Report& report);
Reproduction reproduce_slope_drawings(const ResultFolder& folder, Report& report);
Reproduction reproduce_column_motion(const ResultFolder& folder, Report& report);
Reproduction reproduce_trends(const ResultFolder& folder, Report& report);
Reproduction reproduce_plates(const ResultFolder& folder, Report& report);

}  // namespace delabole
