// Writing a result file so that a reader never meets half of one.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace delabole {

// A result could not be written. what() reads "cannot write <path>: <reason>".
class OutputError : public std::runtime_error {
  public:
    OutputError(std::filesystem::path path, std::string reason);

    const std::filesystem::path& path() const { return path_; }
    const std::string& reason() const { return reason_; }

  private:
    std::filesystem::path path_;
    std::string reason_;
};

// Writes `text` to a hidden temporary file beside `path`, forces it to the disk and renames it to `path`: afterwards
// either the whole new file is there or, after an OutputError, whatever was there before, without leftovers. A symbolic
// link is followed. Only regular files are replaced: a folder, device or pipe named `path` is refused.
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

// Removes what processes killed while they wrote `path` have left beside it; what another is writing just now stays.
void remove_abandoned_parts(const std::filesystem::path& path);

// Creates the folder and its parents where they are missing. OutputError if that is impossible.
void create_output_folder(const std::filesystem::path& folder);

}  // namespace delabole
