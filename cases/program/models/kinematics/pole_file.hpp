// Reads measured planes from a CSV file, as written by digital compasses and other programs.
//
// Lines that begin with # are comments; the first other line names the columns. These columns are read, with names in
// upper or lower case and with or without "(deg)":
//   dip and dip direction (or dip_dir, dip azimuth),
//   trend and plunge of the poles,
//   strike (right-hand rule: the plane dips to the right of it) and dip,
//   quantity, where it is given: the plane counts as that number of poles.
// Angles are degrees with a decimal point; columns are separated by commas, semicolons or tabs. Other columns are
// ignored.
#pragma once

#include "cases/program/reader/section.hpp"
#include "kinematics/parameters.hpp"

#include <string_view>
#include <vector>

namespace delabole {

// Throws CaseError with all problems, each with its line and column; `name` names the text in messages.
std::vector<Orientation> planes_of_csv(std::string_view text, std::string_view name);

}  // namespace delabole
