// A slope cut by joints: checks of its case for the reader.
#pragma once

#include "cases/program/case/model_cases.hpp"
#include "dynamic_relaxation/scene/relaxation_parameters.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace delabole {

struct SlopeComplaint {
    std::string key;
    std::string message;
};

// Why the slope cannot be cut; nothing if it can.
std::optional<SlopeComplaint> complaint_of(const RelaxationSlope& slope);

// Checks names, whole numbers, and the faults found while cutting. The caller checks the joints.
void check_slope(Checker& checker, const RelaxationSlope& slope);

// Replaces scene.outline_file by the corners in that file, which is beside the case. `prefix` is the beginning of the
// model's keys.
void take_outline_file(Reading& reading, RelaxationStudy& study, const std::filesystem::path& folder,
                       const std::string& prefix);

}  // namespace delabole
