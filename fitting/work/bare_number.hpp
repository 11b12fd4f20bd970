#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace delabole {

// The number that makes up the whole text; nothing if the text holds anything else.
template <class Number = double>
std::optional<Number> bare_number(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

}  // namespace delabole
