#include "cases/checkpoint_file.hpp"

#include "dynamic_relaxation/study_checkpoint.hpp"
#include "plots/atomic_file.hpp"

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace delabole {

namespace {

struct Content {
    std::string bytes = {};
    std::string fault = {};
};

Content read_bytes(const std::filesystem::path& path) {
    std::error_code error;
    // A pipe or a device has no size and may never end.
    if (!std::filesystem::is_regular_file(std::filesystem::status(path, error))) {
        return {
            {},
            std::filesystem::is_directory(path, error) ? "is a folder, not a checkpoint" : "is not an ordinary file"};
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (error || !stream) {
        return {{}, "cannot be read: " + (error ? error : std::error_code(errno, std::generic_category())).message()};
    }
    std::string bytes(size, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(size));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return {std::move(bytes), stream.bad() ? "cannot be read to its end" : ""};
}

std::string_view fault_of(CheckpointCheck check) {
    switch (check) {
    case CheckpointCheck::ok:
        break;
    case CheckpointCheck::not_a_checkpoint:
        return "is not a checkpoint of dynamic relaxation";
    case CheckpointCheck::other_version:
        return "was written by another version of delabole";
    case CheckpointCheck::other_scene:
        return "belongs to another case, or to this one with other values";
    case CheckpointCheck::damaged:
        return "is damaged";
    }
    return "";
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const RelaxationStudy& study, KeepFrames frames,
                      const StudyProgress& progress) {
    create_output_folder(path.parent_path());
    write_file_atomically(path, checkpoint_of(study, frames, progress));
}

KeptProgress read_checkpoint(const std::filesystem::path& path, const RelaxationStudy& study, KeepFrames frames) {
    std::error_code error;
    if (!std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
        return {};
    }
    const Content content = read_bytes(path);
    if (!content.fault.empty()) {
        return {{}, false, content.fault};
    }
    RestoredProgress restored = restore_checkpoint(content.bytes, study, frames);
    if (restored.check != CheckpointCheck::ok) {
        return {{}, false, std::string(fault_of(restored.check))};
    }
    return {std::move(restored.progress), true, {}};
}

}  // namespace delabole
