// The text of tables and cases below cases/thesis/ and cases/published/, and of the case of Appendix A, as it was when
// the program was built.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <string_view>
#include <vector>

namespace delabole {

extern const std::string_view thesis_groundwater_tests;
extern const std::string_view thesis_mechanisms;
extern const std::string_view thesis_trends;
extern const std::string_view thesis_plates;
extern const std::string_view thesis_table_3_2;
extern const std::string_view thesis_table_3_3;
extern const std::string_view thesis_tilting_frame;
extern const std::string_view thesis_report;
extern const std::string_view thesis_runs;
extern const std::string_view thesis_histories;
extern const std::string_view thesis_published_factors;

struct BuiltInCase {
    std::string_view folder;  // below cases/
    std::string_view name;    // of the file, without its ending
    std::string_view text;
};

const std::vector<BuiltInCase>& built_in_cases();

// Throws std::logic_error where there is none of that name.
CaseFile built_in_case(std::string_view folder, std::string_view name, const std::vector<Setting>& settings = {});

}  // namespace delabole
