// Measured planes from a CSV file, as compasses and other programs write them.
//
// Lines that begin with # are comments; the first other line names the columns, of which these are read, whatever the
// case of their letters and with or without "(deg)":
//   dip and dip direction (or dip_dir, dip azimuth),
//   trend and plunge of the poles,
//   strike (right-hand rule: the plane dips to the right of it) and dip.
// Numbers are degrees with a decimal point; columns are parted by commas, semicolons or tabs. Others are passed over.
#pragma once

#include "cases/program/reader/section.hpp"
#include "kinematics/parameters.hpp"

#include <string_view>
#include <vector>

namespace delabole {

// Throws CaseError with all that is wrong, each with its line and column; `name` names the text in messages.
std::vector<Orientation> planes_of_csv(std::string_view text, std::string_view name);

}  // namespace delabole
