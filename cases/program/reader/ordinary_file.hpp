// The whole of a file that a user names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace delabole {

struct FileContent {
    std::string bytes = {};
    std::string fault = {};   // "is not an ordinary file"; empty where everything has been read
    std::uintmax_t size = 0;  // of the whole file, bytes
};

// `what` it is to be, for the fault: "a case file". A limit is a multiple of 1 MiB. What grows meanwhile is read up to
// the size it had.
FileContent read_ordinary_file(const std::filesystem::path& path, std::string_view what, std::size_t largest);

// The first bytes of a file of any size; all of it where it has no more.
FileContent read_beginning(const std::filesystem::path& path, std::string_view what, std::size_t most);

}  // namespace delabole
