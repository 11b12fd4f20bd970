// Quantities as people write them, "225 ft" or "30 lbf/in^2", turned into SI.
//
// A quantity is a decimal number followed by a unit. Angles take deg or rad, also over a time; every other unit is
// udunits2's, restricted to products and powers of named units, so that nothing hidden (an offset, a logarithm, a
// second number) can slip into a value. A ratio is a bare number, a percentage or a quotient of like units ("0.2 m/m").
#pragma once

#include "cases/program/reader/unit_system.hpp"
#include "parameters/fields.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <variant>

namespace delabole {

enum class QuantityStatus { ok, not_a_number, missing_unit, unknown_unit, wrong_dimension, not_finite };

struct ParsedQuantity {
    QuantityStatus status = QuantityStatus::not_a_number;
    double value = 0;     // SI, finite; 0 unless status is ok
    std::string message;  // what is wrong, what was expected and an example; empty when status is ok
};

// Safe to call from several threads. Throws std::runtime_error only when the unit database of udunits2 is not
// installed.
ParsedQuantity parse_quantity(std::string_view text, Dimension dimension);

// A number written without a unit: a value where the dimension is a ratio, otherwise missing_unit.
ParsedQuantity unitless_quantity(double number, Dimension dimension);

// True when the text starts like a number, so that it is meant as a quantity and not as a word.
bool looks_like_quantity(std::string_view text);

// A value whose dimension is known only later, as it was written: a bare number, a quantity or a word.
using WrittenValue = std::variant<double, std::string>;

ParsedQuantity parse_value(const WrittenValue& value, Dimension dimension);

inline bool is_whole(double number) {
    return number == std::floor(number);
}

// Shortest decimal number that reads back as the same double; "nan" and "inf" in words.
std::string shortest_number(double value);

// SI value as it has to stand in a case file to be read back as the identical double: quoted, in the display unit, or
// in the SI unit where no decimal number in the display unit would do. Ratios without quotes.
std::string written_quantity(double value, Dimension dimension);

// SI value for reading: up to ten digits in the display unit, "3.5 m".
std::string readable_quantity(double value, Dimension dimension);

// "more than 0 m", "from 0 to 89.9 deg", "between 0 and 90 deg (ends excluded)"; empty for any number.
std::string readable_range(const Interval& range, Dimension dimension);

}  // namespace delabole
