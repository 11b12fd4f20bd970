// A result folder holds one result, and one process at a time writes it.
//
// files.txt in the folder lists the files written there. It is locked while a process writes. The next result removes
// the files in the list before it writes its first own file, so that tables and frames of an earlier case do not remain
// beside those of another. Files that are not in the list belong to someone else and stay.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

class FolderClaim {
  public:
    // Creates the folder if it is missing. Throws OutputError if that is impossible, if another process has claimed it,
    // if files.txt is not such a list, or if the folder holds a result's file that is not in it. On file systems
    // without locks every process is admitted.
    explicit FolderClaim(std::filesystem::path folder);
    // Releases the folder, and removes it if it was created for a result that was then not written.
    ~FolderClaim();
    FolderClaim(const FolderClaim&) = delete;
    FolderClaim& operator=(const FolderClaim&) = delete;

    // Adds files, named relative to the folder, to the list before they are written. The first call removes the result
    // of an earlier claim that is in the list, result.json first. Throws OutputError if that fails.
    void enter(const std::vector<std::string>& names);

  private:
    void open_list();
    bool is_locked_list();
    std::string read_list() const;
    void refuse_files_of_others(const std::string& list) const;
    void remove_earlier();
    void append(std::string_view text);

    std::filesystem::path folder_;
    std::filesystem::path list_;
    std::vector<std::filesystem::path> created_ = {};  // folders, the innermost last; removed if no result is written
    int descriptor_ = -1;
    bool new_list_ = false;
    bool begun_ = false;
    std::set<std::string> entered_ = {};
};

}  // namespace delabole
