// The only file that includes gnuplot-iostream, which is slow to compile. It formats the data rows into a string
// instead of a pipe: a broken pipe would end the process, and a script can be reviewed.
#include "plots/drawing/gnuplot_words.hpp"

#include <gnuplot-iostream.h>

#include "parameters/fields.hpp"

#include <cmath>
#include <locale>
#include <sstream>

namespace delabole {

std::string_view rgb(Colour colour) {
    static constexpr auto codes = std::to_array<std::string_view>(
        {"'#000000'", "'#0072B2'", "'#D55E00'", "'#009E73'", "'#E69F00'", "'#CC79A7'", "'#56B4E9'", "'#666666'",
         "'#BDBDBD'", "'#C8B99A'", "'#FFFFFF'", "'#A6CBE3'", "'#F0BE9B'"});
    static_assert(codes.size() == enum_names(Colour{}).size());
    return codes[static_cast<std::size_t>(colour)];
}

std::string_view dash_type(Dash dash) {
    return dash == Dash::dashed ? "(11,7)" : dash == Dash::dotted ? "(1,7)" : "solid";
}

int point_type(Marker marker) {
    static constexpr auto types = std::to_array({6, 7, 5, 9, 13, 2});
    static_assert(types.size() == enum_names(Marker{}).size());
    return types[static_cast<std::size_t>(marker)];
}

// In single quotes gnuplot expands neither back-quoted commands nor macros. Line breaks have to be added in double
// quotes. So do single quotes: doubled, as gnuplot documents it, they are a syntax error at the beginning of a text.
std::string quote(std::string_view text) {
    std::string result = "'";
    for (const char letter : text) {
        if (letter == '\n') {
            result += "'.\"\\n\".'";
        } else if (letter == '\'') {
            result += "'.\"'\".'";
        } else if (static_cast<unsigned char>(letter) >= 0x20 && letter != 0x7f) {
            result += letter;
        } else {
            result += ' ';
        }
    }
    return result + "'";
}

// gnuplot interprets the text of a tick as a format, in which a percent sign has to be doubled.
std::string quote_tick(std::string_view text) {
    std::string doubled;
    for (const char letter : text) {
        doubled += letter == '%' ? "%%" : std::string(1, letter);
    }
    return quote(doubled);
}

// 1, 2 or 5 times a power of ten, so that at most `most` steps lie within the size.
double tick_step(double size, int most) {
    const double power = std::pow(10.0, std::floor(std::log10(size / most)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power * most >= size * (1 - 1e-9)) {
            return factor * power;
        }
    }
    return 10 * power;
}

std::string data_lines(const Rows& rows) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream.precision(12);
    // send1d is not used, because it appends an "e" that a named data block must not have.
    gnuplotio::top_level_array_sender(stream, rows, gnuplotio::Mode1D(), gnuplotio::ModeText());
    return stream.str();
}

}  // namespace delabole
