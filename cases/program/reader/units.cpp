#include "cases/program/reader/units.hpp"

#include "cases/program/reader/names.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace delabole {
namespace {

constexpr std::size_t longest_unit = 48;

bool is_space(char character) {
    return character == ' ' || character == '\t';
}
bool is_digit(char character) {
    return character >= '0' && character <= '9';
}
bool is_letter(char character) {
    return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z');
}
// The bytes of UTF-8 characters such as the degree and micro signs, superscripts and the raised dot.
bool is_beyond_ascii(char character) {
    return static_cast<unsigned char>(character) >= 0x80;
}

// Spellings of units that udunits2 does not know.
std::string_view usual_spelling(std::string_view unit) {
    struct Spelling {
        std::string_view as_written;
        std::string_view meant;
    };
    constexpr std::array<Spelling, 8> spellings{{{"psf", "lbf/ft2"},
                                                 {"ksf", "klbf/ft2"},
                                                 {"ksi", "klbf/in2"},
                                                 {"pcf", "lbf/ft3"},
                                                 {"kcf", "klbf/ft3"},
                                                 {"KPa", "kPa"},
                                                 {"KN", "kN"},
                                                 {"KN/m3", "kN/m3"}}};
    const auto* const found = std::ranges::find(spellings, unit, &Spelling::as_written);
    return found == spellings.end() ? unit : found->meant;
}

// Allows only named units, products, quotients and one-digit exponents: udunits2 itself would take "kN/m3 2" for a
// factor of two and "degC @ 3" for an offset.
bool is_plain_unit(std::string_view unit) {
    if (unit.size() > longest_unit ||
        !(is_letter(unit.front()) || unit.front() == '%' || is_beyond_ascii(unit.front()))) {
        return false;
    }
    for (std::size_t index = 1; index < unit.size(); ++index) {
        const char before = unit[index - 1];
        const char here = unit[index];
        const char after = index + 1 < unit.size() ? unit[index + 1] : '\0';
        if (is_digit(here)) {
            const bool double_star = before == '*' && index > 1 && unit[index - 2] == '*';
            if (!(is_letter(before) || before == '^' || before == '-' || double_star)) {
                return false;
            }
        } else if (here == '-') {
            if (!(is_letter(before) || before == '^' || before == '*') || !is_digit(after)) {
                return false;
            }
        } else if (here == '^') {
            if (!is_digit(after) && after != '-') {
                return false;
            }
        } else if (!is_letter(here) && !is_space(here) && !is_beyond_ascii(here) && here != '/' && here != '*' &&
                   here != '.' && here != '(' && here != ')' && here != '%') {
            return false;
        }
    }
    return true;
}

// udunits2 treats a radian as the number 1, so that "kPa deg" would be a stress.
bool mentions_angle(std::string_view unit) {
    constexpr std::array<std::string_view, 10> angles = {"rad",     "radian",    "radians", "deg",   "degree",
                                                         "degrees", "arcdegree", "sr",      "grade", "arcminute"};
    for (std::size_t start = 0; start < unit.size();) {
        if (!is_letter(unit[start])) {
            ++start;
            continue;
        }
        std::size_t end = start;
        while (end < unit.size() && (is_letter(unit[end]) || unit[end] == '_')) {
            ++end;
        }
        const std::string_view word = unit.substr(start, end - start);
        if (std::ranges::find(angles, word) != angles.end()) {
            return true;
        }
        start = end;
    }
    return unit.find("°") != std::string_view::npos;
}

std::optional<double> angle_factor(std::string_view unit) {
    constexpr std::array<std::string_view, 4> in_degrees = {"deg", "degree", "degrees", "°"};
    constexpr std::array<std::string_view, 3> in_radians = {"rad", "radian", "radians"};
    if (std::ranges::find(in_degrees, unit) != in_degrees.end()) {
        return display_unit(Dimension::angle).si_per_unit;
    }
    if (std::ranges::find(in_radians, unit) != in_radians.end()) {
        return 1.0;
    }
    return std::nullopt;
}

// "deg/s", "rad/min": an angle divided by a time, each with a unit of its own.
std::optional<double> angular_speed_factor(std::string_view unit) {
    const std::size_t slash = unit.find('/');
    if (slash == std::string_view::npos) {
        return std::nullopt;
    }
    const std::optional<double> angle = angle_factor(trimmed(unit.substr(0, slash)));
    const std::string_view time = trimmed(unit.substr(slash + 1));
    if (!angle || time.empty() || !is_plain_unit(time)) {
        return std::nullopt;
    }
    const UnitFactor seconds = unit_factor(time, Dimension::time);
    return seconds.known && seconds.si_per_unit ? std::optional(*angle / *seconds.si_per_unit) : std::nullopt;
}

ParsedQuantity failure(QuantityStatus status, std::string message) {
    return {.status = status, .value = 0, .message = std::move(message)};
}

std::string expectation(Dimension dimension) {
    return std::string(dimension_words(dimension).phrase) + " is expected, e.g. " +
           std::string(dimension_words(dimension).example);
}

std::string in_marks(std::string_view text) {
    std::string result(1, '"');
    return result.append(text).append(1, '"');
}

ParsedQuantity wrong_dimension(std::string_view unit, Dimension dimension) {
    return failure(QuantityStatus::wrong_dimension,
                   in_marks(unit) + " is the wrong kind of unit: " + expectation(dimension));
}

ParsedQuantity unknown_unit(std::string_view unit, Dimension dimension) {
    std::string message = in_marks(unit.substr(0, longest_unit)) + " is not a known unit";
    if (unit.front() == ',') {
        message += " (the decimal sign is a point)";
    } else {
        message += " (capitals matter: kN, kPa, MPa)";
    }
    return failure(QuantityStatus::unknown_unit, message + ": " + expectation(dimension));
}

ParsedQuantity scaled(double number, double factor) {
    const double value = number * factor;
    if (!std::isfinite(value) || (value == 0 && number != 0)) {
        return failure(QuantityStatus::not_finite, "must be a finite number that a double can hold");
    }
    return {.status = QuantityStatus::ok, .value = value, .message = {}};
}

struct NumberAndUnit {
    std::errc error{};
    double number = 0;
    std::string_view unit;
};

NumberAndUnit split(std::string_view text) {
    text = trimmed(text);
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') {
        text.remove_prefix(1);
    }
    NumberAndUnit result;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.number);
    result.error = error;
    result.unit = usual_spelling(trimmed(text.substr(static_cast<std::size_t>(end - text.data()))));
    return result;
}

std::string number_with_digits(double value, int digits) {
    std::array<char, 64> buffer{};
    const auto result =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
    return {buffer.data(), result.ptr};
}

std::string with_unit(const std::string& number, std::string_view unit) {
    return unit.empty() ? number : number + " " + std::string(unit);
}

}  // namespace

ParsedQuantity parse_quantity(std::string_view text, Dimension dimension) {
    const NumberAndUnit parts = split(text);
    if (parts.error == std::errc::invalid_argument) {
        return failure(QuantityStatus::not_a_number, "is not a number with a unit: " + expectation(dimension));
    }
    if (parts.error == std::errc::result_out_of_range || !std::isfinite(parts.number)) {
        return failure(QuantityStatus::not_finite, "must be a finite number that a double can hold");
    }
    if (parts.unit.empty()) {
        if (dimension == Dimension::ratio) {
            return failure(QuantityStatus::missing_unit,
                           "a ratio is written without quotes, e.g. 0.5, or as a percentage, e.g. \"50 %\"");
        }
        return unitless_quantity(parts.number, dimension);
    }
    const std::optional<double> angle = angle_factor(parts.unit);
    if (angle) {
        return dimension == Dimension::angle ? scaled(parts.number, *angle) : wrong_dimension(parts.unit, dimension);
    }
    if (dimension == Dimension::angular_speed) {
        const std::optional<double> speed = angular_speed_factor(parts.unit);
        return speed ? scaled(parts.number, *speed) : wrong_dimension(parts.unit, dimension);
    }
    if (!is_plain_unit(parts.unit)) {
        return unknown_unit(parts.unit, dimension);
    }
    const UnitFactor factor = unit_factor(parts.unit, dimension);
    if (!factor.known) {
        return unknown_unit(parts.unit, dimension);
    }
    if (!factor.si_per_unit || dimension == Dimension::angle || mentions_angle(parts.unit)) {
        return wrong_dimension(parts.unit, dimension);
    }
    return scaled(parts.number, *factor.si_per_unit);
}

ParsedQuantity unitless_quantity(double number, Dimension dimension) {
    if (!std::isfinite(number)) {
        return failure(QuantityStatus::not_finite, "must be a finite number that a double can hold");
    }
    if (dimension != Dimension::ratio) {
        return failure(QuantityStatus::missing_unit, "has no unit: " + expectation(dimension));
    }
    return {.status = QuantityStatus::ok, .value = number, .message = {}};
}

bool looks_like_quantity(std::string_view text) {
    text = trimmed(text);
    if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
        text.remove_prefix(1);
    }
    if (!text.empty() && text.front() == '.') {
        text.remove_prefix(1);
    }
    return !text.empty() && is_digit(text.front());
}

ParsedQuantity parse_value(const WrittenValue& value, Dimension dimension) {
    if (const auto* number = std::get_if<double>(&value)) {
        return unitless_quantity(*number, dimension);
    }
    return parse_quantity(std::get<std::string>(value), dimension);
}

std::string shortest_number(double value) {
    std::array<char, 64> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

std::string written_quantity(double value, Dimension dimension) {
    if (dimension == Dimension::ratio) {
        const std::string text = shortest_number(value);
        // A long whole number would not fit the integers of TOML, so it is written as a real number.
        return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
    }
    const DisplayUnit unit = display_unit(dimension);
    const double displayed = value / unit.si_per_unit;
    constexpr int most_digits = 17;
    for (int digits = 1; digits <= most_digits; ++digits) {
        const double rounded = split(number_with_digits(displayed, digits)).number;
        const std::string text = with_unit(shortest_number(rounded), unit.symbol);
        const ParsedQuantity read = parse_quantity(text, dimension);
        if (read.status == QuantityStatus::ok && read.value == value) {
            return in_marks(text);
        }
    }
    return in_marks(with_unit(shortest_number(value), dimension_words(dimension).si_symbol));
}

std::string readable_quantity(double value, Dimension dimension) {
    constexpr int digits = 10;
    const DisplayUnit unit = display_unit(dimension);
    return with_unit(number_with_digits(value / unit.si_per_unit, digits), unit.symbol);
}

std::string readable_range(const Interval& range, Dimension dimension) {
    const bool has_lower = std::isfinite(range.lower);
    const bool has_upper = std::isfinite(range.upper);
    constexpr int digits = 10;
    const DisplayUnit unit = display_unit(dimension);
    const std::string lower = number_with_digits(range.lower / unit.si_per_unit, digits);
    const std::string upper = readable_quantity(range.upper, dimension);
    if (has_lower && has_upper) {
        if (range.lower_open && range.upper_open) {
            return "between " + lower + " and " + upper + " (ends excluded)";
        }
        if (!range.lower_open && !range.upper_open) {
            return "from " + lower + " to " + upper;
        }
        return (range.lower_open ? "more than " : "at least ") + lower + " and " +
               (range.upper_open ? "less than " : "at most ") + upper;
    }
    if (has_lower) {
        return (range.lower_open ? "more than " : "at least ") + with_unit(lower, unit.symbol);
    }
    if (has_upper) {
        return (range.upper_open ? "less than " : "at most ") + upper;
    }
    return {};
}

}  // namespace delabole
