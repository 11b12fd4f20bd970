// A slope cut by joints as the reader knows it.
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

// Why the slope cannot be cut; nothing where it can.
std::optional<SlopeComplaint> complaint_of(const RelaxationSlope& slope);

// Names, numbers that are whole, and what cutting says. The joints are checked by the caller.
void check_slope(Checker& checker, const RelaxationSlope& slope);

// Puts the corners of scene.outline_file, beside the case, in the place of its name. `prefix` is what the keys of the
// model begin with.
void take_outline_file(Reading& reading, RelaxationStudy& study, const std::filesystem::path& folder,
                       const std::string& prefix);

}  // namespace delabole
