// Writes a result file so that a reader never sees an incomplete one.
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

// Writes `text` to a hidden temporary file beside `path`, forces it to the disk and renames it to `path`. Afterwards
// either the complete new file is there or, after an OutputError, the file that was there before, without leftovers.
// Only regular files are replaced: a symbolic link, folder, device or pipe named `path` is rejected.
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

// Throws OutputError if `path` is a symbolic link. A result folder may come from another user, and a link in it could
// make the results overwrite any file of this user.
void refuse_link(const std::filesystem::path& path);

// The target of a link that the user has named, whether it exists or not; `path` itself if it is not a link. Throws
// OutputError for links that lead in a circle.
std::filesystem::path end_of_links(const std::filesystem::path& path);

// Removes what processes that were killed while writing `path` have left beside it; a file that another process is
// still writing stays.
void remove_abandoned_parts(const std::filesystem::path& path);
// The same for several files of one folder, given by their names.
void remove_abandoned_parts(const std::filesystem::path& folder, const std::set<std::string>& files);

// Creates the folder and its parents if they are missing; links are followed. Throws OutputError if that is impossible.
void create_output_folder(const std::filesystem::path& folder);

// Creates a folder within a result folder; it must not be a link.
void create_output_subfolder(const std::filesystem::path& folder);

}  // namespace delabole
