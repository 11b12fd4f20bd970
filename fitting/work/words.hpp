// Numbers as people read them in sentences.
#pragma once

#include "parameters/fields.hpp"

#include <string>
#include <vector>

namespace delabole {

enum class UnitSystem { metric, imperial };

// In which sentences, tables and figures give numbers, for the whole process: set before a report is begun. What
// programs read, as CSV and JSON, is metric whatever it is.
void show_units_in(UnitSystem system);
DisplayUnit shown_unit(Dimension dimension);

// Three significant digits, "0.0432", "27", "1.2e-05"; the same in every locale.
std::string number_in_words(double value);

// An SI value in its shown unit with the unit's symbol, "12.5 deg", "0.043".
std::string value_in_words(double value, Dimension dimension);

// "from 1 to 9", "between 0 and 1 (ends excluded)", "at least 0"; empty where all numbers are allowed.
std::string range_in_words(const Interval& range);

// "a", "a and b", "a, b and c".
std::string list_in_words(const std::vector<std::string>& items);

}  // namespace delabole
