// A record of the ground's acceleration from a file.
//
// CSV: a line that names the columns with their units, "time_s,horizontal_m_per_s2,vertical_m_per_s2", then one line
// for each moment, times increasing (cases/program/reader/data_table.hpp).
#pragma once

#include "cases/program/case/model_cases.hpp"
#include "dynamic_relaxation/scene/relaxation_parameters.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// Throws CaseError with all that is wrong, each with its line; `name` names the text in messages.
std::vector<ShakingPoint> shaking_of_csv(std::string_view text, std::string_view name);

// Puts the record of shaking_file, beside the case, in the place of its name. `prefix` is what the keys of the model
// begin with.
void take_shaking_file(Reading& reading, RelaxationStudy& study, const std::filesystem::path& folder,
                       const std::string& prefix);

}  // namespace delabole
