// Words as people write them: "did you mean", the known word nearest to a mistyped one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// Without blanks, tabs and line ends at either end.
std::string_view trimmed(std::string_view text);

// Insertions, deletions, substitutions and swaps of neighbours that turn one word into the other (optimal string
// alignment).
std::size_t edit_distance(std::string_view first, std::string_view second);

// The nearest candidate within two edits (one for words of up to three letters), or one whose last part after a dot is
// the whole word; empty when there is none.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

// " (did you mean strength?)" or nothing.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

// "a, b or c"
std::string choices(const std::vector<std::string>& words);

}  // namespace delabole
