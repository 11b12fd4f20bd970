#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace delabole {

std::size_t letter_count(std::string_view text) {
    std::size_t count = 0;
    for (const char byte : text) {
        count += (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
    }
    return count;
}

std::string wrapped(std::string_view text, std::size_t letters) {
    std::string result;
    std::size_t used = 0;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string_view word = text.substr(begin, end - begin);
        const std::size_t length = letter_count(word);
        if (used > 0 && used + 1 + length > letters) {
            result += '\n';
            used = 0;
        } else if (begin > 0) {
            result += ' ';
            ++used;
        }
        result += word;
        used += length;
        begin = end + 1;
    }
    return result;
}

std::string human_name(std::string_view name) {
    std::string result;
    for (const char letter : name) {
        if (letter == '_') {
            result += ' ';
        } else if (letter == '.') {
            result += ": ";
        } else {
            result += letter;
        }
    }
    return result;
}

std::string human_unit(std::string_view unit) {
    std::string result;
    for (std::size_t index = 0; index < unit.size(); ++index) {
        const bool exponent = index > 0 && unit[index - 1] == 'm';
        if (exponent && unit[index] == '2') {
            result += "²";
        } else if (exponent && unit[index] == '3') {
            result += "³";
        } else {
            result += unit[index];
        }
    }
    return result;
}

std::string human_number(double value, int significant_digits) {
    if (std::isnan(value)) {
        return "none";
    }
    if (std::isinf(value)) {
        return value > 0 ? "infinite" : "-infinite";
    }
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream.precision(significant_digits);
    stream << value;
    return stream.str();
}

}  // namespace delabole
