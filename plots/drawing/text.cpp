#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
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

std::string capitalised(std::string text) {
    if (!text.empty()) {
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    }
    return text;
}

std::string human_unit(std::string_view unit) {
    std::string result;
    for (std::size_t index = 0; index < unit.size(); ++index) {
        const bool exponent = index > 0 && (unit[index - 1] == 'm' || unit[index - 1] == 't');
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
    // Where the stream would use an exponent, thousands are written out, rounded to the same number of digits.
    constexpr double most_written_out = 1e7;
    const double place = std::pow(10, std::floor(std::log10(std::max(std::abs(value), 1.0))) + 1 - significant_digits);
    const double rounded = std::round(value / place) * place;
    if (std::abs(rounded) >= std::pow(10, significant_digits) && std::abs(rounded) < most_written_out) {
        stream << std::fixed << std::setprecision(0) << rounded;
    } else {
        stream << value;
    }
    return stream.str();
}

}  // namespace delabole
