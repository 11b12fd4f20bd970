// Reads files that a user names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace delabole {

struct FileContent {
    std::string bytes = {};
    std::string fault = {};   // "is not an ordinary file"; empty if everything was read
    std::uintmax_t size = 0;  // of the whole file, bytes
};

// The whole of a file. `what` describes it in the fault: "a case file". `largest` is a multiple of 1 MiB. If the file
// grows meanwhile, it is read up to its former size.
FileContent read_ordinary_file(const std::filesystem::path& path, std::string_view what, std::size_t largest);

// The first bytes of a file of any size; the whole file if it has no more.
FileContent read_beginning(const std::filesystem::path& path, std::string_view what, std::size_t most);

}  // namespace delabole
