// The items of the thesis's chapter 4: rows of two blocks, and of three and four.
#pragma once

#include "cases/reproduction.hpp"

namespace delabole {

Reproduction reproduce_fig_4_3(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_4_4(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_4_6(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_4_7(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_4_8(const ResultFolder& folder, Report& report);

Reproduction reproduce_fig_4_9(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_4_10(const ResultFolder& folder, Report& report);
Reproduction reproduce_equations_14_to_19(const ResultFolder& folder, Report& report);

// A printed angle beside the computed one, degrees.
PrintedRow angle_row(const std::string& what, double printed, double computed, const std::string& remark);

// A figure of a tilt over an angle or a ratio.
Figure tilt_figure(const std::string& title, const std::string& x, const std::string& x_unit);

}  // namespace delabole
