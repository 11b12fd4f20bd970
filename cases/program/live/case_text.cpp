#include "cases/program/live/case_text.hpp"

#include "cases/program/reader/document.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/results/analysis.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

namespace delabole {

namespace {

struct Token {
    std::size_t begin = 0;
    std::size_t size = 0;
};

// Columns count characters of UTF-8, not bytes.
std::size_t offset_of(std::string_view text, const Place& place) {
    std::size_t at = 0;
    for (int line = 1; line < place.line; ++line) {
        at = text.find('\n', at) + 1;
    }
    for (int column = 1; column < place.column; ++column) {
        ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) {
            ++at;
        }
    }
    return at;
}

Token token_at(std::string_view text, std::size_t begin) {
    const char quote = text.substr(begin, 1) == "\"" || text.substr(begin, 1) == "'" ? text[begin] : '\0';
    const std::size_t end = quote == '\0' ? text.find_first_of(",]} \t\r\n#", begin) : text.find(quote, begin + 1);
    if (end == std::string_view::npos) {
        return {begin, text.size() - begin};
    }
    return {begin, end - begin + (quote == '\0' ? 0 : 1)};
}

// Returns what follows the number of a quantity; empty for a bare number.
std::string_view unit_of(std::string_view token) {
    const std::string_view inside =
        token.size() > 1 && token.front() == token.back() && !token.empty() ? token.substr(1, token.size() - 2) : token;
    const std::size_t end = inside.find_first_not_of("+-0123456789.eE_ ");
    return end == std::string_view::npos ? std::string_view() : inside.substr(end);
}

std::string in_unit(double value, Dimension dimension, std::string_view token) {
    const bool in_quotes = token.starts_with('"') || token.starts_with('\'');
    const std::string unit(unit_of(token));
    const auto written = [&](const std::string& number) {
        return in_quotes ? number + (unit.empty() ? "" : " " + unit) : number;
    };
    const auto read = [&](const std::string& number) {
        if (in_quotes) {
            return parse_quantity(written(number), dimension);
        }
        double bare = 0;
        std::from_chars(number.data(), number.data() + number.size(), bare);
        return unitless_quantity(bare, dimension);
    };
    const ParsedQuantity one = read("1");
    if (one.status != QuantityStatus::ok || one.value == 0) {
        return written_quantity(value, dimension);
    }
    constexpr int most_digits = 17;
    for (int digits = 1; digits <= most_digits; ++digits) {
        std::array<char, 32> buffer{};
        const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value / one.value,
                                       std::chars_format::general, digits);
        double rounded = 0;
        std::from_chars(buffer.data(), end.ptr, rounded);
        const std::string number = shortest_number(rounded);  // 20, where one digit makes 2e+01
        const ParsedQuantity back = read(number);
        if (back.status == QuantityStatus::ok && back.value == value) {
            return in_quotes ? delabole::in_quotes(written(number)) : number;
        }
    }
    return written_quantity(value, dimension);
}

struct Replacement {
    Token token;
    std::string by;
};

// Replaces `outline_file = "..."`, with its key, by the points of the file: `outline = [...]`. Returns nothing if the
// input does not come from such a file.
std::optional<Replacement> points_instead_of_file(std::string_view text, const CaseFile& file,
                                                  const std::vector<Condition>& values, const std::string& input) {
    const std::string list = list_of(input);
    const auto place = list.empty() ? file.places.end() : file.places.find(list + "_file");
    if (place == file.places.end() || place->second.place.line == 0) {
        return std::nullopt;
    }
    const Token name = token_at(text, offset_of(text, place->second.place));
    const std::string key = list.substr(list.rfind('.') + 1);
    const std::size_t begin = text.rfind(key + "_file", name.begin);
    if (begin == std::string_view::npos) {
        return std::nullopt;
    }
    std::string points = key + " = [\n";
    const std::vector<Quantity> inputs = named_inputs(with_conditions(file.model, values));
    for (std::size_t number = 1;; ++number) {
        const std::string point = list + "[" + std::to_string(number) + "]";
        const Quantity* x = find_quantity(inputs, point + ".x");
        const Quantity* y = find_quantity(inputs, point + ".y");
        if (x == nullptr || y == nullptr) {
            break;
        }
        points += "    { x = " + written_quantity(x->value, x->dimension) +
                  ", y = " + written_quantity(y->value, y->dimension) + " },\n";
    }
    if (!points.ends_with(",\n")) {
        return std::nullopt;  // the file holds something else
    }
    return Replacement{{begin, name.begin + name.size - begin}, points + "]"};
}

}  // namespace

std::string with_values(std::string_view text, const CaseFile& file, const std::vector<Condition>& values) {
    const std::vector<Quantity> inputs = named_inputs(file.model);
    std::vector<Replacement> replacements;
    for (const Condition& value : values) {
        const Quantity* input = find_quantity(inputs, value.input);
        const auto place = file.places.find(value.input);
        if (input == nullptr || place == file.places.end() || place->second.place.line == 0) {
            const std::optional<Replacement> points = points_instead_of_file(text, file, values, value.input);
            if (input != nullptr && points) {
                const auto same = [&](const Replacement& other) { return other.token.begin == points->token.begin; };
                if (std::ranges::none_of(replacements, same)) {
                    replacements.push_back(*points);
                }
                continue;
            }
            throw std::invalid_argument(value.input + " does not stand in the case file");
        }
        if (input->value != value.value) {
            const Token token = token_at(text, offset_of(text, place->second.place));
            replacements.push_back(
                {token, in_unit(value.value, input->dimension, text.substr(token.begin, token.size))});
        }
    }
    std::ranges::sort(replacements, {}, [](const Replacement& one) { return one.token.begin; });
    std::string changed;
    std::size_t copied = 0;
    for (const Replacement& one : replacements) {
        changed += text.substr(copied, one.token.begin - copied);
        changed += one.by;
        copied = one.token.begin + one.token.size;
    }
    return changed.append(text.substr(copied));
}

}  // namespace delabole
