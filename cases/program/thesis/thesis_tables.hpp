// The text of tables and cases below cases/thesis/ and cases/published/, and of the case of Appendix A, as it was when
// the program was built.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/reader/data_table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// The text of a table by its path below cases/. Throws std::out_of_range where there is none.
std::string_view built_in_table(std::string_view file);

// The rows of the table Row::file.
template <Described Row>
std::vector<Row> rows_of() {
    return parse_table<Row>(built_in_table(Row::file), "cases/" + std::string(Row::file));
}

struct BuiltInCase {
    std::string_view folder;  // below cases/
    std::string_view name;    // of the file, without its ending
    std::string_view text;
};

const std::vector<BuiltInCase>& built_in_cases();

// Throws std::logic_error where there is none of that name.
CaseFile built_in_case(std::string_view folder, std::string_view name, const std::vector<Setting>& settings = {});

}  // namespace delabole
