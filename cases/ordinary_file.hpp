// The whole of a file that a user names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

namespace delabole {

struct FileContent {
    std::string bytes = {};
    std::string fault = {};  // "is not an ordinary file"; empty where everything has been read
};

// `what` it is to be, for the fault: "a case file". A limit is a multiple of 1 MiB. What grows meanwhile is read up to the
// size it had.
FileContent read_ordinary_file(const std::filesystem::path& path, std::string_view what,
                               std::size_t largest = std::numeric_limits<std::size_t>::max());

}  // namespace delabole
