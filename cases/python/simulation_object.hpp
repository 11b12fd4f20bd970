// Simulation: moving blocks as a Python object.
#pragma once

#include <pybind11/pybind11.h>

namespace delabole {

void bind_simulation(pybind11::module_& module);

}  // namespace delabole
