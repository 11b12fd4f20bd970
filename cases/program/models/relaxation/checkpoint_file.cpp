#include "cases/program/models/relaxation/checkpoint_file.hpp"

#include "cases/program/reader/ordinary_file.hpp"
#include "dynamic_relaxation/checkpoint/study_checkpoint.hpp"
#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/text.hpp"

#include <string>
#include <system_error>
#include <utility>

namespace delabole {

namespace {

constexpr std::size_t largest_checkpoint = std::size_t{64} << 30U;

std::string fault_of(CheckpointCheck check) {
    return words_for(check,
                     {"", "is not a checkpoint of dynamic relaxation", "was written by another version of delabole",
                      "belongs to another case, or to this one with other values", "is damaged"});
}

KeptProgress refused(CheckpointCheck check) {
    return {
        {}, false, fault_of(check), check == CheckpointCheck::other_scene || check == CheckpointCheck::other_version};
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const RelaxationStudy& study, KeepFrames frames,
                      const StudyProgress& progress) {
    create_output_folder(path.parent_path());
    write_file_atomically(path, checkpoint_of(study, frames, progress));
}

void remove_checkpoint(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) {
        std::filesystem::remove(path, ignored);
    }
    remove_abandoned_parts(path);
}

KeptProgress read_checkpoint(const std::filesystem::path& path, const RelaxationStudy& study, KeepFrames frames) {
    std::error_code error;
    if (!std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
        return {};
    }
    // Only the header is read first: another file may have any size, and a damaged checkpoint may claim more than the
    // memory.
    FileContent content = read_beginning(path, "a checkpoint", checkpoint_header_size);
    if (content.fault.empty()) {
        const CheckpointCheck beginning = check_beginning(content.bytes, content.size);
        if (beginning != CheckpointCheck::ok) {
            return refused(beginning);
        }
        content = read_ordinary_file(path, "a checkpoint", largest_checkpoint);
    }
    if (!content.fault.empty()) {
        return {{}, false, std::move(content.fault)};
    }
    RestoredProgress restored = restore_checkpoint(content.bytes, study, frames);
    if (restored.check != CheckpointCheck::ok) {
        return refused(restored.check);
    }
    return {std::move(restored.progress), true, {}};
}

}  // namespace delabole
