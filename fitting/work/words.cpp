#include "fitting/work/words.hpp"

#include <array>
#include <atomic>
#include <charconv>
#include <cmath>

namespace delabole {

namespace {

std::atomic<UnitSystem> system_shown{UnitSystem::metric};

// Feet, kips and pounds.
DisplayUnit imperial_unit(Dimension dimension) {
    constexpr double foot = 0.3048;
    constexpr double pound_mass = 0.45359237;
    constexpr double pound = pound_mass * 9.80665;
    constexpr double kip = 1000 * pound;
    switch (dimension) {
    case Dimension::length:
        return {"ft", "_ft", foot};
    case Dimension::area:
        return {"ft2", "_ft2", foot * foot};
    case Dimension::volume:
        return {"ft3", "_ft3", foot * foot * foot};
    case Dimension::stress:
        return {"ksf", "_ksf", kip / (foot * foot)};
    case Dimension::unit_weight:
        return {"pcf", "_pcf", pound / (foot * foot * foot)};
    case Dimension::force:
        return {"kip", "_kip", kip};
    case Dimension::force_per_length:
        return {"kip/ft", "_kip_per_ft", kip / foot};
    case Dimension::moment_per_length:
        return {"kip ft/ft", "_kip_ft_per_ft", kip};
    case Dimension::energy_per_length:
        return {"ft lbf/ft", "_ft_lbf_per_ft", pound};
    case Dimension::density:
        return {"lb/ft3", "_lb_per_ft3", pound_mass / (foot * foot * foot)};
    case Dimension::stiffness:
        return {"kip/ft/ft", "_kip_per_ft_per_ft", kip / (foot * foot)};
    case Dimension::speed:
        return {"ft/s", "_ft_per_s", foot};
    case Dimension::acceleration:
        return {"ft/s2", "_ft_per_s2", foot};
    default:
        return display_unit(dimension);
    }
}

}  // namespace

void show_units_in(UnitSystem system) {
    system_shown = system;
}

DisplayUnit shown_unit(Dimension dimension) {
    return system_shown == UnitSystem::imperial ? imperial_unit(dimension) : display_unit(dimension);
}

std::string number_in_words(double value) {
    std::array<char, 64> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 3);
    std::string text(buffer.data(), end);
    // The general format switches to an exponent from 1000 on, where people still expect plain digits.
    if (std::abs(value) >= 999.5 && std::abs(value) < 1e7) {
        text = std::to_string(std::llround(value));
    }
    return text;
}

std::string value_in_words(double value, Dimension dimension) {
    const DisplayUnit unit = shown_unit(dimension);
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

std::string list_in_words(const std::vector<std::string>& items, const std::string& before_last) {
    std::string text;
    for (std::size_t index = 0; index < items.size(); ++index) {
        const bool last = index + 1 == items.size();
        text += index == 0 ? "" : (last ? before_last : ", ");
        text += items[index];
    }
    return text;
}

}  // namespace delabole
