// Numbers and points as numpy arrays that own their memory.
#pragma once

#include "geometry/polyline.hpp"

#include <pybind11/numpy.h>

#include <vector>

namespace delabole {

inline pybind11::array_t<double> array_of(const std::vector<double>& values) {
    return pybind11::array_t<double>(static_cast<pybind11::ssize_t>(values.size()), values.data());
}

// One row for each point: x, y.
inline pybind11::array_t<double> array_of(const std::vector<Point>& points) {
    pybind11::array_t<double> array({static_cast<pybind11::ssize_t>(points.size()), pybind11::ssize_t{2}});
    auto rows = array.mutable_unchecked<2>();
    for (std::size_t index = 0; index < points.size(); ++index) {
        rows(static_cast<pybind11::ssize_t>(index), 0) = points[index].x();
        rows(static_cast<pybind11::ssize_t>(index), 1) = points[index].y();
    }
    return array;
}

}  // namespace delabole
