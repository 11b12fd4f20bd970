// Items of `delabole reproduce` that are data alone: cases whose texts, [[expect]] and [[sweep]] say what is printed
// and drawn.
#pragma once

#include "cases/program/thesis/reproduction.hpp"

#include <string>
#include <vector>

namespace delabole {

// `cases` are built-in ones of a folder (thesis_tables.hpp), in the order of the report.
ReproductionItem data_item(const std::string& name, const std::string& meaning, const std::string& folder,
                           const std::vector<std::string>& cases);

}  // namespace delabole
