#include "cases/checkpoint_file.hpp"

#include "cases/case_error.hpp"
#include "dynamic_relaxation/checkpoint.hpp"
#include "plots/atomic_file.hpp"

#include <cerrno>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace delabole {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, std::string message) {
    throw CaseError({Problem{
        .file = path.string(), .line = 0, .column = 0, .key = {}, .value = {}, .message = std::move(message)}});
}

std::string read_bytes(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        refuse(path, error && error != std::errc::no_such_file_or_directory ? "cannot be read: " + error.message()
                                                                            : "there is no such file");
    }
    // A pipe or a device has no size and may never end.
    if (!std::filesystem::is_regular_file(status)) {
        refuse(path,
               std::filesystem::is_directory(status) ? "is a folder, not a checkpoint" : "is not an ordinary file");
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (error || !stream) {
        refuse(path, "cannot be read: " + (error ? error : std::error_code(errno, std::generic_category())).message());
    }
    std::string bytes(size, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(size));
    if (stream.bad()) {
        refuse(path, "cannot be read to its end");
    }
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

std::string_view complaint(CheckpointCheck check) {
    switch (check) {
    case CheckpointCheck::ok:
        break;
    case CheckpointCheck::not_a_checkpoint:
        return "is not a checkpoint of dynamic relaxation";
    case CheckpointCheck::other_version:
        return "was written by another version of delabole: the run has to start anew";
    case CheckpointCheck::other_scene:
        return "belongs to another case, or to this one with other values: a run can only go on as it began";
    case CheckpointCheck::damaged:
        return "is damaged: the run has to start anew";
    }
    return "";
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const RelaxationScene& scene,
                      const RelaxationSettings& settings, const RelaxationState& state) {
    write_file_atomically(path, checkpoint_of(scene, settings, state));
}

RelaxationState read_checkpoint(const std::filesystem::path& path, const RelaxationScene& scene,
                                const RelaxationSettings& settings) {
    RestoredState restored = restore_checkpoint(read_bytes(path), scene, settings);
    if (restored.check != CheckpointCheck::ok) {
        refuse(path, std::string(complaint(restored.check)));
    }
    return std::move(restored.state);
}

}  // namespace delabole
