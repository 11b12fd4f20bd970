#include "cases/program/reader/nesting.hpp"

namespace delabole {
namespace {

// Index just after the string that starts at `start`. A string on one line ends with that line at the latest: TOML
// allows no line break in it, so the parser stops there with an error of its own.
std::size_t behind_string(std::string_view text, std::size_t start) {
    const char quote = text[start];
    const bool escapes = quote == '"';
    const std::string_view triple = quote == '"' ? "\"\"\"" : "'''";
    const bool several_lines = text.substr(start, 3) == triple;
    std::size_t index = start + (several_lines ? 3 : 1);
    while (index < text.size()) {
        if (escapes && text[index] == '\\') {
            index += 2;
        } else if (several_lines && text.substr(index, 3) == triple) {
            index += 3;
            // Up to two quotes may stand directly before the closing three.
            for (int extra = 0; extra < 2 && index < text.size() && text[index] == quote; ++extra) {
                ++index;
            }
            return index;
        } else if (!several_lines && (text[index] == quote || text[index] == '\n')) {
            return text[index] == quote ? index + 1 : index;
        } else {
            ++index;
        }
    }
    return text.size();
}

}  // namespace

std::optional<NestingExcess> excessive_nesting(std::string_view text, int limit) {
    int line = 1;
    std::size_t line_start = 0;
    int brackets = 0;
    int dots = 0;
    const auto pass = [&](std::size_t from, std::size_t to) {
        for (std::size_t index = from; index < to; ++index) {
            if (text[index] == '\n') {
                ++line;
                line_start = index + 1;
            }
        }
    };
    for (std::size_t index = 0; index < text.size();) {
        const char character = text[index];
        std::size_t next = index + 1;
        switch (character) {
        case '"':
        case '\'':
            next = behind_string(text, index);
            break;
        case '#':
            next = text.find('\n', index);
            next = next == std::string_view::npos ? text.size() : next;
            break;
        case '[':
        case '{':
            ++brackets;
            dots = 0;
            break;
        case ']':
        case '}':
            brackets = brackets > 0 ? brackets - 1 : 0;
            dots = 0;
            break;
        case '.':
            ++dots;
            break;
        case '=':
        case ',':
        case '\n':
            dots = 0;
            break;
        default:
            break;
        }
        if (brackets > limit || dots > limit) {
            return NestingExcess{.line = line, .column = static_cast<int>(index - line_start) + 1};
        }
        pass(index, next);
        index = next;
    }
    return std::nullopt;
}

}  // namespace delabole
