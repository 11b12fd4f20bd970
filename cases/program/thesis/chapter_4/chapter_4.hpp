// The items of the thesis's chapter 4: rows of two blocks, and of three and four.
#pragma once

#include "cases/program/thesis/reproduction.hpp"
#include "limit_equilibrium/block_row/block_row.hpp"
#include "plots/drawing/figure.hpp"

#include <functional>
#include <string>

namespace delabole {

Reproduction reproduce_fig_4_7(const Sheet& sheet);
Reproduction reproduce_force_between_two_blocks(const Sheet& sheet);

Reproduction reproduce_fig_4_9(const Sheet& sheet);
Reproduction reproduce_fig_4_10(const Sheet& sheet);
Reproduction reproduce_equations_14_to_19(const Sheet& sheet);

// Makes blocks of width 1 m and equal weight; angles of friction are in degrees.
BlockRow equal_row(int count, double slenderness, double interface_friction, double base_friction);

// A printed angle beside the computed one, degrees.
PrintedRow angle_row(const std::string& what, double printed, double computed, const std::string& remark);

// A figure of a tilt over an angle or a ratio.
Figure tilt_figure(const std::string& title, const std::string& x, const std::string& x_unit);

double tangent(double angle_in_degrees);

double in_degrees(double tangent_of_angle);

// Returns the tilt in degrees. If it does not lie between 0 and 90 deg, returns NaN, which leaves a gap in a curve.
double tilt_or_gap(double tangent_of_tilt);

// The curve of a function in `steps` equal steps.
Line curve(double from, double to, const std::string& legend, Colour colour, Dash dash,
           const std::function<double(double)>& value, int steps = 100);

}  // namespace delabole
