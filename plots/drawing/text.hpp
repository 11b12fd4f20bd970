// Plain UTF-8 text for pictures and pages.
#pragma once

#include "parameters/fields.hpp"

#include <string>
#include <string_view>

namespace delabole {

// Number of characters, not of bytes.
std::size_t letter_count(std::string_view text);

// Replaces spaces by line breaks, so that no line has more than `letters` characters, except for a longer single word.
std::string wrapped(std::string_view text, std::size_t letters);

// "strength.friction_angle" -> "strength: friction angle".
std::string human_name(std::string_view name);

// The text with its first letter capitalised, as at the beginning of a sentence.
std::string capitalised(std::string text);

// The words for a value of an enum, given for all of them in their order.
template <class Enum, std::size_t count>
std::string words_for(Enum value, const char* const (&words)[count]) {
    static_assert(count == enum_names(Enum{}).size());
    return words[static_cast<std::size_t>(value)];
}

// "kN/m3" -> "kN/m³".
std::string human_unit(std::string_view unit);

// A number in the classic locale with at most that many significant digits and no trailing zeros; "none" for NaN,
// "infinite".
std::string human_number(double value, int significant_digits);

}  // namespace delabole
