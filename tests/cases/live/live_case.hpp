// Cases of the repository as the page of `delabole live` has them.
#pragma once

#include "cases/program/live/session.hpp"

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace delabole {

inline std::string text_of(const std::string& name) {
    std::ifstream file(DELABOLE_CASES "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline LiveSession session_of(const std::string& name) {
    const std::string path = DELABOLE_CASES "/" + name;
    return {read_case(path), text_of(name), [](const std::vector<std::string>&) { return "results"; }};
}

}  // namespace delabole
