// The version of Delabole and its revision, which every result carries.
#pragma once

#include <string_view>

namespace delabole {

// "0.1.0", the version in the top CMakeLists.txt.
std::string_view version();

// Commit the library was built from, twelve digits, with "-modified" appended where tracked files differed from it;
// "unknown" where it was not built in a git checkout of its own.
std::string_view revision();

// Hash of the sources of lib/, of the compiler and of its options, sixty-four digits: programs of one fingerprint
// predict the same to the last bit. Unlike the revision it tells uncommitted changes apart, and does not change with
// sources that compute no prediction.
std::string_view fingerprint();

}  // namespace delabole
