// Single words and lines of a gnuplot script.
#pragma once

#include "plots/drawing/figure.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

std::string_view rgb(Colour colour);
std::string_view dash_type(Dash dash);
int point_type(Marker marker);

// A string that gnuplot uses unchanged.
std::string quote(std::string_view text);

// The same for the text of a tick, which gnuplot interprets as a format.
std::string quote_tick(std::string_view text);

// 1, 2 or 5 times a power of ten, so that at most `most` steps lie within `size`. size > 0, most > 0.
double tick_step(double size, int most);

using Rows = std::vector<std::vector<double>>;

// One line for each row, 12 significant digits, "nan" for NaN, whatever the locale.
std::string data_lines(const Rows& rows);

}  // namespace delabole
