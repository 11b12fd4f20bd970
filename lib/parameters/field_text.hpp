// The text of a described number: its meaning and the value that its absence stands for.
#pragma once

#include "parameters/fields.hpp"

#include <array>
#include <charconv>
#include <string>

namespace delabole {

namespace detail {

// A number as a person writes it: 0.005, 60, 1e6.
inline std::string plain_number(double value) {
    constexpr int digits = 6;
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.begin(), text.end(), value, std::chars_format::general, digits).ptr;
    std::string number(text.begin(), end);
    const std::size_t exponent = number.find('e');
    if (exponent == std::string::npos) {
        return number;
    }
    const std::size_t first = number.find_first_not_of("+-0", exponent + 1);
    return number.substr(0, exponent + 1) + (number[exponent + 1] == '-' ? "-" : "") + number.substr(first);
}

}  // namespace detail

// The meaning of a field, and what its absence stands for: "share of the greatest stable step; absent: 0.6".
inline std::string text_of(const FieldInfo& info) {
    std::string text(info.meaning);
    if (info.absent) {
        const DisplayUnit unit = display_unit(info.dimension);
        text += "; absent: " + detail::plain_number(*info.absent / unit.si_per_unit);
        text += unit.symbol.empty() ? "" : " " + std::string(unit.symbol);
    }
    return text;
}

}  // namespace delabole
