// Case: a case after reading, as a Python object.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <pybind11/pybind11.h>

namespace delabole {

struct CaseObject {
    CaseFile file;
};

void bind_cases(pybind11::module_& module);

}  // namespace delabole
