// The only file that sees gnuplot-iostream, which is slow to compile: it formats the data rows, into a string instead
// of a pipe, because a broken pipe would kill the process and a script can be reviewed.
#include "plots/drawing/gnuplot_words.hpp"

#include <gnuplot-iostream.h>

#include <cmath>
#include <locale>
#include <sstream>

namespace delabole {

std::string_view rgb(Colour colour) {
    switch (colour) {
    case Colour::black:
        return "'#000000'";
    case Colour::blue:
        return "'#0072B2'";
    case Colour::vermilion:
        return "'#D55E00'";
    case Colour::green:
        return "'#009E73'";
    case Colour::orange:
        return "'#E69F00'";
    case Colour::purple:
        return "'#CC79A7'";
    case Colour::sky:
        return "'#56B4E9'";
    case Colour::grey:
        return "'#666666'";
    case Colour::light_grey:
        return "'#BDBDBD'";
    case Colour::rock:
        return "'#C8B99A'";
    case Colour::white:
        return "'#FFFFFF'";
    }
    return "'#000000'";
}

std::string_view dash_type(Dash dash) {
    switch (dash) {
    case Dash::dashed:
        return "(12,6)";
    case Dash::dotted:
        return "(3,5)";
    case Dash::solid:
        break;
    }
    return "solid";
}

int point_type(Marker marker) {
    switch (marker) {
    case Marker::circle:
        return 6;
    case Marker::filled_circle:
        return 7;
    case Marker::filled_square:
        return 5;
    case Marker::filled_triangle:
        return 9;
    case Marker::filled_diamond:
        return 13;
    case Marker::cross:
        return 2;
    }
    return 7;
}

// Single quotes, within which gnuplot expands neither back-quoted commands nor macros. A line break has to be joined
// on, and so has a single quote: doubled, as gnuplot documents it, it is a syntax error at the beginning of a text.
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

// A tick's text is a format to gnuplot.
std::string quote_tick(std::string_view text) {
    std::string doubled;
    for (const char letter : text) {
        doubled += letter == '%' ? "%%" : std::string(1, letter);
    }
    return quote(doubled);
}

std::string legend_of(std::string_view legend) {
    return legend.empty() ? "notitle" : "title " + quote(legend);
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
    // Not send1d, which appends an "e" that has no place in a named data block.
    gnuplotio::top_level_array_sender(stream, rows, gnuplotio::Mode1D(), gnuplotio::ModeText());
    return stream.str();
}

}  // namespace delabole
