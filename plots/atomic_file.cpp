#include "plots/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

namespace delabole {

namespace {

namespace fs = std::filesystem;

std::string reason_of(int error) {
    return std::generic_category().message(error);
}

// Where a link leads to, whether something is there or not.
fs::path target_of(const fs::path& path) {
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

// Open file that is removed again unless it was committed to its final name.
class TemporaryFile {
  public:
    explicit TemporaryFile(const fs::path& target) : target_(target) {
        // Unique within the process by the counter, between processes by the id; O_EXCL catches what an earlier process
        // of the same id left behind.
        static std::atomic<unsigned> counter = 0;
        constexpr int attempts = 100;
        for (int attempt = 0; attempt < attempts && descriptor_ < 0; ++attempt) {
            std::string name = ".";
            name.append(target.filename().string()).append(".").append(std::to_string(::getpid()));
            name.append(".").append(std::to_string(counter++)).append(".part");
            path_ = target.parent_path() / name;
            descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (descriptor_ < 0 && errno != EEXIST) {
                break;
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
        // Some file systems notice only here that the disk is full; EINVAL means that they cannot synchronise at all.
        if (::fsync(descriptor_) != 0 && errno != EINVAL) {
            throw OutputError(target_, reason_of(errno));
        }
        if (::close(std::exchange(descriptor_, -1)) != 0) {
            throw OutputError(target_, reason_of(errno));
        }
        if (::rename(path_.c_str(), target_.c_str()) != 0) {
            throw OutputError(target_, reason_of(errno));
        }
        committed_ = true;
    }

  private:
    fs::path target_;
    fs::path path_;
    int descriptor_ = -1;
    bool committed_ = false;
};

}  // namespace

OutputError::OutputError(std::filesystem::path path, std::string reason)
    : std::runtime_error("cannot write " + path.string() + ": " + reason),
      path_(std::move(path)),
      reason_(std::move(reason)) {}

void write_file_atomically(const std::filesystem::path& path, std::string_view text) {
    const fs::path target = target_of(path);
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        throw OutputError(path, fs::is_directory(status) ? "it is a folder" : "it is not a regular file");
    }
    TemporaryFile file(target);
    file.write(text);
    file.commit();
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

}  // namespace delabole
