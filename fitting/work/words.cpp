#include "fitting/work/words.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace delabole {

std::string number_in_words(double value) {
    std::array<char, 64> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 3);
    std::string text(buffer.data(), end);
    // general format switches to an exponent from 1000 on, where people still expect plain digits
    if (std::abs(value) >= 999.5 && std::abs(value) < 1e7) {
        text = std::to_string(std::llround(value));
    }
    return text;
}

std::string value_in_words(double value, Dimension dimension) {
    const DisplayUnit unit = display_unit(dimension);
    const std::string number = number_in_words(value / unit.si_per_unit);
    return unit.symbol.empty() ? number : number + " " + std::string(unit.symbol);
}

std::string range_in_words(const Interval& range) {
    const bool has_lower = std::isfinite(range.lower);
    const bool has_upper = std::isfinite(range.upper);
    const std::string lower = number_in_words(range.lower);
    const std::string upper = number_in_words(range.upper);
    if (has_lower && has_upper && range.lower_open == range.upper_open) {
        return range.lower_open ? "between " + lower + " and " + upper + " (ends excluded)"
                                : "from " + lower + " to " + upper;
    }
    const std::string from = has_lower ? (range.lower_open ? "more than " : "at least ") + lower : "";
    const std::string to = has_upper ? (range.upper_open ? "less than " : "at most ") + upper : "";
    return from + (has_lower && has_upper ? " and " : "") + to;
}

std::string list_in_words(const std::vector<std::string>& items) {
    std::string text;
    for (std::size_t index = 0; index < items.size(); ++index) {
        const bool last = index + 1 == items.size();
        text += index == 0 ? "" : (last ? " and " : ", ");
        text += items[index];
    }
    return text;
}

}  // namespace delabole
