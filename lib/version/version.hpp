// Which Delabole this is; every result carries both words.
#pragma once

#include <string_view>

namespace delabole {

// "0.1.0", the version in the top CMakeLists.txt.
std::string_view version();

// Commit the library was built from, twelve digits, with "-modified" appended where tracked files differed from it;
// "unknown" where it was not built in a git checkout of its own.
std::string_view revision();

}  // namespace delabole
