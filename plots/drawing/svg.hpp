// Puts several SVG files of gnuplot into one page.
#pragma once

#include <string>
#include <string_view>

namespace delabole {

// The <svg> element of a file, changed so that it can stand beside others in an HTML page: without XML declaration,
// scripts, event handlers and gnuplot's own titles; with `id_prefix` before every id and every reference to it; as wide
// as its place allows; and with `description` as its name for screen readers. Empty if `file` holds no complete <svg>
// element.
std::string inline_svg(std::string_view file, std::string_view id_prefix, std::string_view description);

// Replaces & < > " ' by HTML entities, and control characters, which no page may hold, by spaces (line breaks stay).
std::string escape_html(std::string_view text);

}  // namespace delabole
