// Reads a record of ground acceleration from a file.
//
// CSV: a line that names the columns with their units, "time_s,horizontal_m_per_s2,vertical_m_per_s2", then one line
// for each moment, with increasing times (cases/program/reader/data_table.hpp).
#pragma once

#include "cases/program/case/model_cases.hpp"
#include "dynamic_relaxation/scene/relaxation_parameters.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// Throws CaseError with all problems, each with its line; `name` names the text in messages.
std::vector<ShakingPoint> shaking_of_csv(std::string_view text, std::string_view name);

// Replaces shaking_file by the record in that file, which is beside the case. `prefix` is the beginning of the model's
// keys.
void take_shaking_file(Reading& reading, RelaxationStudy& study, const std::filesystem::path& folder,
                       const std::string& prefix);

}  // namespace delabole
