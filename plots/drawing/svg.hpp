// Putting several gnuplot SVG files into one page.
#pragma once

#include <string>
#include <string_view>

namespace delabole {

// The <svg> element of a file, fit to stand inside an HTML page beside others: without XML declaration, scripts, event
// handlers and gnuplot's own titles, every id (and every reference to it) preceded by `id_prefix`, as wide as its place
// allows, and named `description` to those who cannot see it. Empty when `file` holds no complete <svg> element.
std::string inline_svg(std::string_view file, std::string_view id_prefix, std::string_view description);

// & < > " ' as HTML entities; control characters, which no page may hold, as spaces (line breaks stay).
std::string escape_html(std::string_view text);

}  // namespace delabole
