// Names of inputs, outputs and mechanisms in a case, and what is written in their terms; the known word nearest to a
// mistyped one: "did you mean".
#pragma once

#include "cases/program/reader/section.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// Cuts off blanks, tabs and line ends at either end.
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

// "poles[1].plane" of "poles[1].plane[3].dip"; empty of a name that stands in no list.
std::string list_of(std::string_view name);

// Lists of more members than anyone would set one by one, as measured poles are, and how many each has.
using LongLists = std::map<std::string, std::size_t, std::less<>>;
LongLists long_lists(const std::vector<Quantity>& quantities);

std::vector<std::string> names_in(const std::vector<Quantity>& quantities);

// Calls visit(path, value) for all that a table holds, also below tables that unquoted dotted keys have made:
// slope.height = "..." is "slope.height" = "...".
void for_each_flat_entry(const Node& table,
                         const std::function<void(const std::string& path, const Node& value)>& visit);

// A text that names something. An input or output sets what numbers of Dimension::named are values of, a mechanism
// whose inputs and outputs further names mean. A complaint where there is nothing of that name.
std::string read_name(Section& section, std::string_view key, NameOf what, std::string_view meaning);
// A list of such names, inputs and outputs of one dimension, empty when absent. What is measurable is required; one
// name of it may stand by itself.
void read_names(Section& section, std::string_view key, NameOf what, std::string_view meaning,
                std::vector<std::string>& names);
// `with = { "water.filled_ratio" = 1.0 }`: inputs of any of the models. Empty when absent.
std::vector<Condition> read_conditions(Section& section, std::string_view key);

}  // namespace delabole
