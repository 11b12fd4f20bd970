// Converts quantities as people write them, "225 ft" or "30 lbf/in^2", to SI.
//
// A quantity is a decimal number followed by a unit. Angles, also in angular speeds, take deg or rad; all other units
// are those of udunits2, restricted to products and powers of named units, so that no offset, logarithm or second
// number can change the value. A ratio is a bare number, a percentage or a quotient of like units ("0.2 m/m").
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
    std::string message;  // the fault, what was expected and an example; empty if the status is ok
};

// Safe to call from several threads. Throws std::runtime_error only if the unit database of udunits2 is not installed.
ParsedQuantity parse_quantity(std::string_view text, Dimension dimension);

// A number written without a unit: valid if the dimension is a ratio, otherwise missing_unit.
ParsedQuantity unitless_quantity(double number, Dimension dimension);

// Whether the text starts like a number, so that it is meant as a quantity and not as a word.
bool looks_like_quantity(std::string_view text);

// A value as it was written, whose dimension becomes known later: a bare number, a quantity or a word.
using WrittenValue = std::variant<double, std::string>;

ParsedQuantity parse_value(const WrittenValue& value, Dimension dimension);

inline bool is_whole(double number) {
    return number == std::floor(number);
}

// Shortest decimal number that reads back as the same double; "nan" and "inf" in words.
std::string shortest_number(double value);

// An SI value as written in a case file, so that reading gives the identical double: quoted, in the display unit, or in
// the SI unit if no decimal number in the display unit gives it. Ratios have no quotes.
std::string written_quantity(double value, Dimension dimension);

// An SI value for people: up to ten digits in the display unit, "3.5 m".
std::string readable_quantity(double value, Dimension dimension);

// "more than 0 m", "from 0 to 89.9 deg", "between 0 and 90 deg (ends excluded)"; empty for any number.
std::string readable_range(const Interval& range, Dimension dimension);

}  // namespace delabole
