// Back-analyses and sensitivity studies as dictionaries of numbers, texts and arrays.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

struct FitRequest {
    int threads = 1;
    std::optional<std::uint64_t> seed;    // replaces the seed of the case
    std::vector<std::string> mechanisms;  // only these are fitted; empty: all that are not costly
    bool with_costly = false;             // the costly ones as well
};

pybind11::dict fit_of(const CaseFile& file, const pybind11::object& progress, const FitRequest& request);

// The case needs a [sensitivity] section.
pybind11::dict study_of(CaseFile file, const pybind11::object& progress, int threads,
                        std::optional<std::uint64_t> seed);

}  // namespace delabole
