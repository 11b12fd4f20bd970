// A case's text with other values, everything else as it was written: comments, order, blanks, units.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// `text` is what `file` was read from. Each value is replaced in place, in the unit in which it was written, by a
// number that is read back as the identical double, or in SI units if no number in that unit would do. Values that do
// not change keep their digits. Throws std::invalid_argument for an input that is not in the text.
std::string with_values(std::string_view text, const CaseFile& file, const std::vector<Condition>& values);

}  // namespace delabole
