// A case's text with other values, everything else as it was written: comments, order, blanks, units.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// `text` is what `file` was read from. Each value is replaced where it stands, in the unit in which it was written, by
// a number that is read back as the identical double; in SI units where no number in that unit would do. What does not
// change keeps its digits. std::invalid_argument for an input that does not stand in the text.
std::string with_values(std::string_view text, const CaseFile& file, const std::vector<Condition>& values);

}  // namespace delabole
