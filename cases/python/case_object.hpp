// Case: a case after reading, as a Python object.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <pybind11/pybind11.h>

#include <optional>

namespace delabole {

struct CaseObject {
    CaseFile file;
    // The model with the support that [support_design] finds, once it has been requested; see supported_model.
    mutable std::optional<CaseModel> supported{};
};

void bind_cases(pybind11::module_& module);

}  // namespace delabole
