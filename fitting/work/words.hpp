// Numbers in the form that people read in sentences.
#pragma once

#include "parameters/fields.hpp"

#include <string>
#include <vector>

namespace delabole {

enum class UnitSystem { metric, imperial };

// Sets the units of sentences, tables and figures for the whole process; call it before a report is begun. Files for
// other programs, such as CSV and JSON, are always metric.
void show_units_in(UnitSystem system);
DisplayUnit shown_unit(Dimension dimension);

// Three significant digits, "0.0432", "27", "1.2e-05"; the same in every locale.
std::string number_in_words(double value);

// An SI value converted to its shown unit, with the unit's symbol: "12.5 deg", "0.043".
std::string value_in_words(double value, Dimension dimension);

// "from 1 to 9", "between 0 and 1 (ends excluded)", "at least 0"; empty if all numbers are allowed.
std::string range_in_words(const Interval& range);

// "a", "a and b", "a, b and c".
std::string list_in_words(const std::vector<std::string>& items, const std::string& before_last = " and ");

}  // namespace delabole
