// The version of Delabole and its revision, which every result carries.
#pragma once

#include <string_view>

namespace delabole {

// "0.1.0", the version in the top CMakeLists.txt.
std::string_view version();

// Commit from which the library was built, twelve digits, with "-modified" appended if tracked files differed from it;
// "unknown" if it was not built in a git checkout of its own.
std::string_view revision();

// Hash of the sources of lib/, of the compiler and of its options, sixty-four digits: programs with the same
// fingerprint predict the same to the last bit. Unlike the revision it distinguishes uncommitted changes, and does not
// change with sources that compute no prediction.
std::string_view fingerprint();

}  // namespace delabole
