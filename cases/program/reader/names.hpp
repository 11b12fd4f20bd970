// Names of inputs, outputs and mechanisms in a case, and what is written in their terms.
#pragma once

#include "cases/program/reader/section.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

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
