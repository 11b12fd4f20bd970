// A result folder holds one result, and one process at a time writes it.
//
// files.txt in the folder lists what has been written there. It is locked while a process writes, and the next result
// removes what it names before its own first file is written: tables and frames of an earlier case do not stay beside
// those of another. What it does not name is somebody else's and stays.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

class FolderClaim {
  public:
    // Creates the folder where it is missing. OutputError where that is impossible, where another process has claimed
    // it, or where files.txt is something else. File systems that cannot lock let every process in.
    explicit FolderClaim(std::filesystem::path folder);
    // Gives the folder up; removes it again where it was created for a result that then was not written.
    ~FolderClaim();
    FolderClaim(const FolderClaim&) = delete;
    FolderClaim& operator=(const FolderClaim&) = delete;

    // Lists files, named from the folder, before they are written. The first call removes the result that the list has
    // from an earlier claim, result.json first. OutputError where that fails.
    void enter(const std::vector<std::string>& names);

  private:
    void open_list();
    bool is_locked_list();
    std::string read_list() const;
    void remove_earlier();
    void append(std::string_view text);

    std::filesystem::path folder_;
    std::filesystem::path list_;
    std::vector<std::filesystem::path> created_ = {};  // folders, the innermost last
    int descriptor_ = -1;
    bool new_list_ = false;
    bool begun_ = false;
    std::set<std::string> entered_ = {};
};

}  // namespace delabole
