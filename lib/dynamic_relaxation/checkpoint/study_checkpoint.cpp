#include "dynamic_relaxation/checkpoint/study_checkpoint.hpp"

#include "dynamic_relaxation/checkpoint/checkpoint.hpp"

#include <algorithm>
#include <utility>

namespace delabole {

namespace {

std::uint64_t hash_of(const RelaxationStudy& study, KeepFrames frames) {
    const RelaxationScene scene = relaxation_scene(study);
    ArchiveWriter writer;
    writer.put(scene);
    writer.put(relaxation_settings(study, scene));
    writer.put(study.critical ? std::optional(critical_plan(study)) : std::nullopt);
    writer.put(study.history);
    writer.put(frames == KeepFrames::yes);
    writer.put(study.retrogression.has_value());
    return fnv_1a(writer.bytes());
}

bool fits(const HistoryLine& line, const RelaxationStudy& study, std::size_t blocks) {
    return study.history && line.block.size() == study.history->block.size() &&
           line.contact.size() == study.history->contact.size() && line.base_slip.size() == blocks &&
           line.rotation.size() == blocks;
}

bool fits(const MotionFrame& frame, const RelaxationScene& scene) {
    const std::size_t blocks = scene.block.size();
    return frame.motion.size() == blocks && frame.outcome.size() == blocks && frame.bolt.size() == scene.bolt.size() &&
           std::ranges::all_of(frame.force,
                               [&](const CornerForce& force) { return force.block < blocks && force.other < blocks; });
}

bool fits(const StudyProgress& progress, const RelaxationStudy& study) {
    const RelaxationScene scene = relaxation_scene(study);
    const std::size_t blocks = scene.block.size();
    const auto frames_fit = [&](const MotionRecord& record) {
        return std::ranges::all_of(record.frame, [&](const MotionFrame& frame) { return fits(frame, scene); });
    };
    const auto state_fits = [&](const std::optional<RelaxationState>& state) { return !state || fits(*state, scene); };
    const std::size_t paths = study.critical ? critical_plan(study).path.size() : 0;
    return state_fits(progress.state) && progress.search.size() <= paths &&
           std::ranges::all_of(progress.search,
                               [&](const SearchProgress& search) {
                                   return state_fits(search.probe_state) && state_fits(search.consolidated) &&
                                          state_fits(search.failed);
                               }) &&
           std::ranges::all_of(progress.history, [&](const HistoryLine& line) { return fits(line, study, blocks); }) &&
           frames_fit(progress.record) && frames_fit(progress.slope) &&
           std::ranges::all_of(progress.stage, [&](const FailureStage& stage) {
               return stage.start.size() == blocks && stage.onset.size() == blocks &&
                      std::ranges::all_of(stage.block, [&](std::uint64_t block) { return block < blocks; });
           });
}

}  // namespace

std::string checkpoint_of(const RelaxationStudy& study, KeepFrames frames, const StudyProgress& progress) {
    ArchiveWriter body;
    body.put(progress);
    return seal_checkpoint(hash_of(study, frames), body.bytes());
}

RestoredProgress restore_checkpoint(std::string_view bytes, const RelaxationStudy& study, KeepFrames frames) {
    const OpenedCheckpoint opened = open_checkpoint(bytes, hash_of(study, frames));
    if (opened.check != CheckpointCheck::ok) {
        return {opened.check};
    }
    ArchiveReader body(opened.body);
    StudyProgress progress;
    body.get(progress);
    if (!body.whole() || !fits(progress, study)) {
        return {CheckpointCheck::damaged};
    }
    return {CheckpointCheck::ok, std::move(progress)};
}

}  // namespace delabole
