// Conversion of Python's dictionaries, lists, numbers and texts to the tree of a case, and back.
#pragma once

#include "cases/program/reader/document.hpp"

#include <pybind11/pybind11.h>

namespace delabole {

// Raises TypeError for a value that a case file cannot hold.
Node tree_of(const pybind11::handle& object);
pybind11::object object_of(const Node& node);

}  // namespace delabole
