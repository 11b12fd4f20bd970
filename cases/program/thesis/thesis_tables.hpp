// The text of cases/thesis/chapter_2/*.csv, cases/thesis/chapter_3/*.csv and cases/published/*.csv, and of
// cases/thesis/chapter_2/*.toml and cases/published/*.toml, as it was when the program was built.
#pragma once

#include <string_view>
#include <vector>

namespace delabole {

extern const std::string_view thesis_features;
extern const std::string_view thesis_groundwater_tests;
extern const std::string_view thesis_mechanisms;
extern const std::string_view thesis_trends;
extern const std::string_view thesis_table_3_1;
extern const std::string_view thesis_table_3_2;
extern const std::string_view thesis_table_3_3;
extern const std::string_view thesis_tilting_frame;
extern const std::string_view thesis_published_factors;

struct BuiltInCase {
    std::string_view name;  // of the file, without its ending
    std::string_view text;
};

const std::vector<BuiltInCase>& chapter_2_cases();
const std::vector<BuiltInCase>& published_cases();

}  // namespace delabole
