// The text of cases/chapter_2/*.csv and cases/chapter_3/*.csv, as it was when the program was built.
#pragma once

#include <string_view>

namespace delabole {

extern const std::string_view thesis_features;
extern const std::string_view thesis_groundwater_tests;
extern const std::string_view thesis_mechanisms;
extern const std::string_view thesis_trends;
extern const std::string_view thesis_table_3_1;
extern const std::string_view thesis_table_3_2;
extern const std::string_view thesis_table_3_3;
extern const std::string_view thesis_tilting_frame;

}  // namespace delabole
