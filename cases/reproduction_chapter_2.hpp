// The items of the thesis's chapter 2 that stand in files of their own.
#pragma once

#include "cases/reproduction.hpp"

namespace delabole {

Reproduction reproduce_mechanisms(const ResultFolder& folder, Report& report);
Reproduction reproduce_groundwater(const ResultFolder& folder, Report& report);
// Independent runs on so many threads.
Reproduction reproduce_plates(const ResultFolder& folder, Report& report, int threads);

}  // namespace delabole
