#include "cases/program/results/folder_claim.hpp"

#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/figure.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <map>
#include <set>
#include <system_error>
#include <utility>

namespace delabole {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view heading =
    "# Files that delabole has written here. The next result in this folder takes their place; all others stay.\n";
constexpr std::array<std::string_view, 2> subfolders{"figures", "frames"};
constexpr std::size_t largest_list = 64U << 20U;  // bytes; a million names of frames
constexpr std::string_view no_list = "it is not a list of delabole's files: move it away, or name another folder";

std::vector<fs::path> missing_folders(const fs::path& folder) {
    std::vector<fs::path> missing;
    std::error_code ignored;
    for (fs::path path = folder; !path.empty() && !fs::exists(fs::symlink_status(path, ignored));
         path = path.parent_path()) {
        missing.insert(missing.begin(), path);
    }
    return missing;
}

// Whether this program can have written the file: it lies in the folder itself or in one of its subfolders. A list may
// come from another user and name any file there is.
bool may_be_own(const fs::path& name) {
    const fs::path parent = name.parent_path();
    const std::string file = name.filename().string();
    const bool within =
        parent.empty() || std::ranges::find(subfolders, std::string_view(parent.native())) != subfolders.end();
    return within && !name.is_absolute() && !file.empty() && file != "." && file != "..";
}

}  // namespace

FolderClaim::FolderClaim(fs::path folder)
    : folder_(std::move(folder)), list_(folder_ / "files.txt"), created_(missing_folders(folder_)) {
    create_output_folder(folder_);
    refuse_link(list_);
    try {
        open_list();
        const std::string found = read_list();
        if (!std::string_view(found).starts_with(heading.substr(0, found.size()))) {
            throw OutputError(list_, std::string(no_list));
        }
        refuse_files_of_others(found);
    } catch (...) {
        if (new_list_) {
            ::unlink(list_.c_str());
        }
        ::close(descriptor_);
        throw;
    }
}

void FolderClaim::refuse_files_of_others(const std::string& list) const {
    for (const std::string name : {"result.json", "report.html", "resolved.toml", "results.csv"}) {
        std::error_code ignored;
        if (list.find('\n' + name + '\n') == std::string::npos &&
            fs::is_regular_file(fs::symlink_status(folder_ / name, ignored))) {
            throw OutputError(folder_ / name,
                              "it was not written by delabole, which would replace it: move it away, or "
                              "name another folder (--out)");
        }
    }
}

FolderClaim::~FolderClaim() {
    if (!begun_) {
        if (new_list_) {
            ::unlink(list_.c_str());
        }
        for (auto folder = created_.rbegin(); folder != created_.rend(); ++folder) {
            ::rmdir(folder->c_str());  // fails if the folder holds anything
        }
    }
    ::close(descriptor_);
}

void FolderClaim::open_list() {
    for (;;) {
        constexpr int flags = O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
        descriptor_ = ::open(list_.c_str(), flags | O_CREAT | O_EXCL, 0666);
        new_list_ = descriptor_ >= 0;
        if (descriptor_ < 0 && errno == EEXIST) {
            descriptor_ = ::open(list_.c_str(), flags);
        }
        if (descriptor_ < 0 && errno == ENOENT) {
            continue;  // another process removed it between the two calls
        }
        if (descriptor_ < 0) {
            throw OutputError(list_, reason_of(errno));
        }
        if (is_locked_list()) {
            return;
        }
        ::close(std::exchange(descriptor_, -1));
    }
}

// False if the process that had the claim removed the list before it was locked here.
bool FolderClaim::is_locked_list() {
    struct stat opened {};
    struct stat named {};
    if (::fstat(descriptor_, &opened) != 0 || !S_ISREG(opened.st_mode)) {
        throw OutputError(list_, "it is not a regular file");
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        throw OutputError(folder_,
                          "another delabole is writing a result there: wait for it, or name another folder (--out)");
    }
    return ::stat(list_.c_str(), &named) == 0 && named.st_ino == opened.st_ino;
}

std::string FolderClaim::read_list() const {
    std::string text;
    std::array<char, 65'536> buffer;
    for (;;) {
        const ssize_t count = ::pread(descriptor_, buffer.data(), buffer.size(), static_cast<off_t>(text.size()));
        if (count < 0 && errno != EINTR) {
            throw OutputError(list_, reason_of(errno));
        }
        if (count == 0) {
            return text;
        }
        if (text.size() > largest_list) {
            throw OutputError(list_, std::string(no_list));
        }
        text.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
}

void FolderClaim::append(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor_, text.data(), text.size());
        if (written < 0 && errno != EINTR) {
            throw OutputError(list_, reason_of(errno));
        }
        text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
}

void FolderClaim::remove_earlier() {
    const std::string list = read_list();
    std::error_code error;
    fs::remove(folder_ / "result.json", error);
    if (error) {
        throw OutputError(folder_ / "result.json", error.message());
    }
    std::string_view rest = list;
    rest.remove_prefix(std::min(heading.size(), rest.size()));
    std::map<fs::path, std::set<std::string>> listed;  // file names by subfolder
    // A name without its line end was not written completely, so its file was not begun.
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
        const fs::path name(rest.substr(0, end));
        rest.remove_prefix(end + 1);
        const fs::path file = folder_ / name;
        listed[name.parent_path()].insert(name.filename().string());
        const bool through_link = fs::is_symlink(file.parent_path(), error) && name.has_parent_path();
        if (may_be_own(name) && !through_link && fs::is_regular_file(fs::symlink_status(file, error)) &&
            !fs::remove(file, error)) {
            throw OutputError(file, error.message());
        }
    }
    for (const std::string_view subfolder : subfolders) {
        if (!fs::is_symlink(folder_ / subfolder, error)) {
            remove_abandoned_parts(folder_ / subfolder, listed[subfolder]);
            remove_abandoned_drawings(folder_ / subfolder);
        }
        ::rmdir((folder_ / subfolder).c_str());  // fails if the folder holds anything
    }
    remove_abandoned_parts(folder_, listed[""]);
    if (::ftruncate(descriptor_, 0) != 0 || ::lseek(descriptor_, 0, SEEK_SET) != 0) {
        throw OutputError(list_, reason_of(errno));
    }
}

void FolderClaim::enter(const std::vector<std::string>& names) {
    std::string lines;
    if (!std::exchange(begun_, true)) {
        remove_earlier();
        lines = heading;
    }
    for (const std::string& name : names) {
        if (entered_.insert(name).second) {
            lines += name + '\n';
        }
    }
    append(lines);
}

}  // namespace delabole
