#include "plots/drawing/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <system_error>
#include <utility>

namespace delabole {

namespace {

namespace fs = std::filesystem;

// A temporary file is locked as long as its writer runs, so one without a lock is abandoned. File systems without locks
// refuse the lock of remove_abandoned_parts() as well, so there the files stay.
bool lock(int descriptor) {
    return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

// ".<file name>.<process>.<number>.part"
std::string beginning_of_part(const fs::path& target) {
    return "." + target.filename().string() + ".";
}

constexpr std::string_view end_of_part = ".part";

// The final name of a temporary file; empty if the name is not that of a temporary file.
std::string target_of_part(std::string_view name) {
    if (!name.starts_with('.') || !name.ends_with(end_of_part)) {
        return {};
    }
    name.remove_prefix(1);
    name.remove_suffix(std::min(name.size(), end_of_part.size()));
    for (int number = 0; number < 2; ++number) {
        const std::size_t dot = name.rfind('.');
        if (dot == std::string_view::npos || dot + 1 == name.size() ||
            !std::ranges::all_of(name.substr(dot + 1),
                                 [](unsigned char letter) { return std::isdigit(letter) != 0; })) {
            return {};
        }
        name = name.substr(0, dot);
    }
    return std::string(name);
}

// An open file that is removed again unless it was committed to its final name.
class TemporaryFile {
  public:
    explicit TemporaryFile(const fs::path& target) : target_(target) {
        // The counter makes the name unique within the process, the process id between processes; O_EXCL detects a file
        // that an earlier process with the same id left.
        static std::atomic<unsigned> counter = 0;
        constexpr int attempts = 100;
        for (int attempt = 0; attempt < attempts && descriptor_ < 0; ++attempt) {
            std::string name = beginning_of_part(target);
            name.append(std::to_string(::getpid())).append(".").append(std::to_string(counter++)).append(end_of_part);
            path_ = target.parent_path() / name;
            descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (descriptor_ < 0 && errno != EEXIST) {
                break;
            }
            if (descriptor_ >= 0 && taken_for_abandoned()) {
                ::unlink(path_.c_str());
                ::close(std::exchange(descriptor_, -1));
                errno = EEXIST;
            }
        }
        if (descriptor_ < 0) {
            throw OutputError(target_, reason_of(errno));
        }
    }

    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    ~TemporaryFile() {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
        if (!committed_) {
            ::unlink(path_.c_str());
        }
    }

    void write(std::string_view text) {
        while (!text.empty()) {
            const ssize_t written = ::write(descriptor_, text.data(), text.size());
            if (written < 0) {
                if (errno == EINTR) {
                    continue;
                }
                throw OutputError(target_, reason_of(errno));
            }
            text.remove_prefix(static_cast<std::size_t>(written));
        }
    }

    void commit() {
        // Some file systems report only here that the disk is full; EINVAL means that they cannot synchronise at all.
        if (::fsync(descriptor_) != 0 && errno != EINVAL) {
            throw OutputError(target_, reason_of(errno));
        }
        // The duplicate descriptor keeps the lock until the file has its final name.
        const int lock_holder = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
        const bool closed = ::close(std::exchange(descriptor_, lock_holder)) == 0;
        if (!closed || ::rename(path_.c_str(), target_.c_str()) != 0) {
            throw OutputError(target_, reason_of(errno));
        }
        committed_ = true;
    }

  private:
    // Whether another process removed the file between its creation and its lock.
    bool taken_for_abandoned() const {
        if (!lock(descriptor_) && errno == EWOULDBLOCK) {
            return true;
        }
        struct stat status {};
        return ::fstat(descriptor_, &status) == 0 && status.st_nlink == 0;
    }

    fs::path target_;
    fs::path path_;
    int descriptor_ = -1;
    bool committed_ = false;
};

}  // namespace

std::string reason_of(int error) {
    return std::generic_category().message(error);
}

OutputError::OutputError(std::filesystem::path path, std::string reason)
    : std::runtime_error("cannot write " + path.string() + ": " + reason),
      path_(std::move(path)),
      reason_(std::move(reason)) {}

void refuse_link(const std::filesystem::path& path) {
    std::error_code ignored;
    if (fs::is_symlink(path, ignored)) {
        throw OutputError(path, "it is a symbolic link, and none is followed out of the result folder: remove it");
    }
}

std::filesystem::path end_of_links(const std::filesystem::path& path) {
    constexpr int most_links = 40;
    fs::path target = path;
    std::error_code error;
    for (int links = 0; fs::is_symlink(target, error); ++links) {
        const fs::path next = fs::read_symlink(target, error);
        if (error || links == most_links) {
            throw OutputError(path, reason_of(error ? error.value() : ELOOP));
        }
        target = next.is_absolute() ? next : target.parent_path() / next;
    }
    return target;
}

void write_file_atomically(const std::filesystem::path& path, std::string_view text) {
    refuse_link(path);
    std::error_code error;
    const fs::file_status status = fs::symlink_status(path, error);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        throw OutputError(path, fs::is_directory(status) ? "it is a folder" : "it is not a regular file");
    }
    // If a link takes the place of the file after this check, the final renaming replaces the link and does not follow
    // it.
    TemporaryFile file(path);
    file.write(text);
    file.commit();
}

void remove_abandoned_parts(const fs::path& path) {
    remove_abandoned_parts(path.has_parent_path() ? path.parent_path() : fs::path("."), {path.filename().string()});
}

void remove_abandoned_parts(const fs::path& folder, const std::set<std::string>& files) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const std::string target = target_of_part(entry->path().filename().string());
        if (target.empty() || !files.contains(target)) {
            continue;
        }
        const int descriptor = ::open(entry->path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor >= 0) {
            if (lock(descriptor)) {
                ::unlink(entry->path().c_str());
            }
            ::close(descriptor);
        }
    }
}

void create_output_folder(const std::filesystem::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw OutputError(folder, error.message());
    }
    if (!fs::is_directory(folder, error)) {
        throw OutputError(folder, "it is not a folder");
    }
}

void create_output_subfolder(const std::filesystem::path& folder) {
    refuse_link(folder);
    create_output_folder(folder);
}

}  // namespace delabole
