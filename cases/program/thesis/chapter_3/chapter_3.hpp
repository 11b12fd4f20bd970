// The items of the thesis's chapter 3: base friction tests and the tilting frame.
#pragma once

#include "cases/program/thesis/reproduction.hpp"

#include <utility>

namespace delabole {

// deg, for figures of one thing by limit equilibrium and by runs; Fig 3.4 is a case, whose axis takes this range.
inline constexpr std::pair tilts_of_single_columns{4.5, 27.5};
inline constexpr std::pair heights_of_equal_columns{1.5, 9.5};  // in
inline constexpr std::pair tilts_of_equal_columns{5.0, 31.0};
inline constexpr std::pair tilts_of_rows{5.0, 39.0};

Reproduction reproduce_base_friction_run(const Sheet& sheet);
Reproduction reproduce_table_3_2(const Sheet& sheet);
Reproduction reproduce_base_friction_plates(const Sheet& sheet);
Reproduction reproduce_tilting_runs(const Sheet& sheet);
Reproduction reproduce_fig_3_2(const Sheet& sheet);
Reproduction reproduce_fig_3_6(const Sheet& sheet);
Reproduction reproduce_fig_3_7(const Sheet& sheet);

}  // namespace delabole
