// Writing a result file so that a reader never meets half of one.
#pragma once

#include <filesystem>
#include <set>
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

// The meaning of a value of errno, in words.
std::string reason_of(int error);

// Writes `text` to a hidden temporary file beside `path`, forces it to the disk and renames it to `path`: afterwards
// either the whole new file is there or, after an OutputError, whatever was there before, without leftovers. Only
// regular files are replaced: a symbolic link, folder, device or pipe named `path` is refused.
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

// OutputError where `path` is a symbolic link: a result folder may come from somebody else, and a link in it would lead
// the results to any file of the user's.
void refuse_link(const std::filesystem::path& path);

// Where a link that the user has named leads to, whether something is there or not; `path` itself where it is no link.
// OutputError for links that lead in a circle.
std::filesystem::path end_of_links(const std::filesystem::path& path);

// Removes what processes killed while they wrote `path` have left beside it; what another is writing just now stays.
void remove_abandoned_parts(const std::filesystem::path& path);
// The same for several files of one folder, by their names.
void remove_abandoned_parts(const std::filesystem::path& folder, const std::set<std::string>& files);

// Creates the folder and its parents where they are missing; links are followed. OutputError if that is impossible.
void create_output_folder(const std::filesystem::path& folder);

// The same for a folder within a result folder, which must not be a link.
void create_output_subfolder(const std::filesystem::path& folder);

}  // namespace delabole
