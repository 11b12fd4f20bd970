// The bound by linear programming for columns on a stepped base: answers, warnings and figures.
#pragma once

#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"

#include <string>
#include <string_view>

namespace delabole {

struct Analysis;
struct Sheet;
struct SteppedBaseAnswer;

// "bound.factor_of_safety", "bound.blocks.factor_of_safety"
constexpr std::string_view bound_prefix = "bound";
constexpr std::string_view bound_of_blocks_prefix = "bound.blocks";

// A notice for the user before a bound that takes long; otherwise empty.
std::string announcement(const SteppedBaseStudy<>& study);

// Adds the bounds to an answer that already has its columns. This and append_bound_figures throw Interrupted.
void find_bounds(SteppedBaseAnswer& answer, const LinearProgrammingBound& request);

void append_bounds(Analysis& analysis, const SteppedBaseAnswer& answer, const LinearProgrammingBound& request);

// Forces and mechanism of columns and of blocks, and the transition from the bound to the recursion.
void append_bound_figures(const SteppedBaseAnswer& answer, const LinearProgrammingBound& request, const Sheet& sheet);

}  // namespace delabole
