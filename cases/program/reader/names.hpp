// Reads names of inputs, outputs and mechanisms in a case and values that refer to them, and suggests the known word
// nearest to a mistyped one: "did you mean".
#pragma once

#include "cases/program/reader/section.hpp"
#include "fitting/work/words.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// The text without blanks, tabs and line ends at either end.
std::string_view trimmed(std::string_view text);

// Insertions, deletions, substitutions and swaps of neighbours that turn one word into the other (optimal string
// alignment).
std::size_t edit_distance(std::string_view first, std::string_view second);

// The nearest candidate within two edits (one for words of up to three letters), or one whose last part after a dot is
// the whole word; empty if there is none.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

// " (did you mean strength?)" or nothing.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

// "a, b or c"
inline std::string choices(const std::vector<std::string>& words) {
    return list_in_words(words, " or ");
}

// The texts of a list one behind the other, with `between` between them.
template <class List, class TextOf = std::identity>
std::string separated(const List& list, const std::string& between, const TextOf& text_of = {}) {
    std::string text;
    for (const auto& one : list) {
        text += (text.empty() ? "" : between) + std::string(std::invoke(text_of, one));
    }
    return text;
}

// "poles[1].plane" for "poles[1].plane[3].dip"; empty for a name outside any list.
std::string list_of(std::string_view name);

// Lists with more members than anyone would set one by one, such as measured poles, and the number of members of each.
using LongLists = std::map<std::string, std::size_t, std::less<>>;
LongLists long_lists(const std::vector<Quantity>& quantities);

std::vector<std::string> names_in(const std::vector<Quantity>& quantities);

// Calls visit(path, value) for all entries of a table, including those below tables made by unquoted dotted keys:
// slope.height = "..." means "slope.height" = "...".
void for_each_flat_entry(const Node& table,
                         const std::function<void(const std::string& path, const Node& value)>& visit);

// Reads a text that names something. The name of an input or output sets the quantity for numbers of Dimension::named;
// that of a mechanism sets the mechanism to whose inputs and outputs later names refer. Complains if nothing has that
// name.
std::string read_name(Section& section, std::string_view key, NameOf what, std::string_view meaning);
// Reads a list of such names, inputs and outputs of one dimension; empty if absent. For NameOf::measurable a list or a
// single name is required.
void read_names(Section& section, std::string_view key, NameOf what, std::string_view meaning,
                std::vector<std::string>& names);
// `with = { "water.filled_ratio" = 1.0 }`: values for inputs of any of the models. Empty if absent.
std::vector<Condition> read_conditions(Section& section, std::string_view key);

}  // namespace delabole
