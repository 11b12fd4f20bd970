// A study stopped anywhere, in its run or in its search, ends with the same answers to the last bit.
#include "dynamic_relaxation/checkpoint/study_checkpoint.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace delabole {
namespace {

// The study's run collapses, and its search both stands and fails: every part of the progress is used.
RelaxationStudy study_of_everything() {
    RelaxationRow row{};
    row.tilt = degrees(22);
    row.density = 2700;
    row.interface.friction_angle = row.base.friction_angle = degrees(20);
    row.block = {{1, 3, {}}, {1, 3, {}}};
    RelaxationStudy study{};
    study.model.scene = row;
    study.settings.emplace().stiffness_ratio = 1e5;
    study.critical = TiltSearch{degrees(15), degrees(25), degrees(1), LoadingPath::consolidated, PathChoice::all};
    study.history = HistoryRequest{0.05, {{1}, {2}}, {{1, 2}}};
    return study;
}

struct Answers {
    std::string progress;  // all that was found, as bytes
    std::size_t frames = 0;
    std::size_t lines = 0;
    double stands = 0;
    double fails = 0;
    double spread = 0;
    bool operator==(const Answers&) const = default;
};

Answers answers_from(const RelaxationStudy& study, StudyProgress progress, StudyWork work) {
    work.frames = KeepFrames::yes;
    const RelaxationRun made = run(study, work, progress);
    const CriticalAnswer critical = find_critical(study, work, progress);
    EXPECT_EQ(critical.worst_status(), CriticalStatus::found);
    EXPECT_EQ(critical.other.size(), 3U);
    return {checkpoint_of(study, KeepFrames::yes, progress),
            made.frames.size(),
            made.history.size(),
            critical.stands,
            critical.fails,
            critical.values().back()};
}

StudyWork work_on(unsigned threads) {
    StudyWork work;
    work.threads = threads;
    return work;
}

TEST(StudyCheckpoint, GoesOnFromAnyLookToTheLastBit) {
    const RelaxationStudy study = study_of_everything();
    std::vector<std::string> kept;
    bool shows_failure = false;  // in the run that is made where statics gave the last verdict
    StudyWork keeping;
    keeping.keep_due = [] { return true; };
    keeping.keep = [&](const StudyProgress& progress) {
        for (const SearchProgress& search : progress.search) {
            shows_failure =
                shows_failure || (search.probe_state && search.consolidated && search.probe.back().without_run);
        }
        kept.push_back(checkpoint_of(study, KeepFrames::yes, progress));
    };
    const Answers whole = answers_from(study, {}, keeping);
    EXPECT_TRUE(shows_failure);
    EXPECT_GT(whole.frames, 20U);
    EXPECT_GT(whole.lines, 5U);
    ASSERT_GT(kept.size(), 20U);
    EXPECT_TRUE(answers_from(study, {}, {}) == whole);
    for (std::size_t index = 0; index < kept.size(); index += 1 + kept.size() / 20) {
        RestoredProgress restored = restore_checkpoint(kept[index], study, KeepFrames::yes);
        ASSERT_EQ(restored.check, CheckpointCheck::ok);
        EXPECT_TRUE(answers_from(study, restored.progress, work_on(2)) == whole) << index;
    }
    // A finished study has nothing left to do.
    StudyWork idle;
    idle.watch = [](double) {
        ADD_FAILURE() << "a finished run was begun again";
        return true;
    };
    EXPECT_TRUE(answers_from(study, restore_checkpoint(whole.progress, study, KeepFrames::yes).progress, idle) ==
                whole);
}

// Runs made ahead are not kept: they are made again.
TEST(StudyCheckpoint, GoesOnWhereItWasInterruptedWithRunsAhead) {
    const RelaxationStudy study = study_of_everything();
    const Answers whole = answers_from(study, {}, {});
    for (const int looks : {1, 2, 5, 10, 20, 40, 80}) {
        std::string kept = checkpoint_of(study, KeepFrames::yes, {});
        int looked = 0;
        StudyWork work;
        work.threads = 4;
        work.frames = KeepFrames::yes;
        work.watch = [&](double) { return ++looked < looks; };
        work.keep_due = [&] { return looked >= looks; };
        work.keep = [&](const StudyProgress& progress) { kept = checkpoint_of(study, KeepFrames::yes, progress); };
        StudyProgress progress;
        if (run(study, work, progress).result.outcome != RelaxationOutcome::interrupted) {
            find_critical(study, work, progress);
        }
        const RestoredProgress restored = restore_checkpoint(kept, study, KeepFrames::yes);
        ASSERT_EQ(restored.check, CheckpointCheck::ok);
        EXPECT_TRUE(answers_from(study, restored.progress, work_on(4)) == whole) << looks;
    }
}

TEST(StudyCheckpoint, RefusesWhatAsksForSomethingElse) {
    const RelaxationStudy study = study_of_everything();
    const std::string bytes = checkpoint_of(study, KeepFrames::yes, {});
    const auto check = [&](const auto& change) {
        RelaxationStudy other = study;
        change(other);
        return restore_checkpoint(bytes, other, KeepFrames::yes).check;
    };
    EXPECT_EQ(check([](RelaxationStudy&) {}), CheckpointCheck::ok);
    EXPECT_EQ(restore_checkpoint(bytes, study, KeepFrames::no).check, CheckpointCheck::other_scene);
    constexpr CheckpointCheck refused = CheckpointCheck::other_scene;
    EXPECT_EQ(check([](RelaxationStudy& other) { other.critical.reset(); }), refused);
    EXPECT_EQ(check([](RelaxationStudy& other) { std::get<TiltSearch>(*other.critical).upper *= 1.1; }), refused);
    EXPECT_EQ(check([](RelaxationStudy& other) { other.history->interval *= 2; }), refused);
    EXPECT_EQ(check([](RelaxationStudy& other) { other.history->contact.clear(); }), refused);
    EXPECT_EQ(check([](RelaxationStudy& other) { other.settings->duration = 59; }), refused);
    EXPECT_EQ(check([](RelaxationStudy& other) { other.model.gravity = 9; }), refused);
}

// The envelope is right, but the lists are not those of the study.
TEST(StudyCheckpoint, RefusesListsOfAnotherLength) {
    const RelaxationStudy study = study_of_everything();
    StudyProgress progress;
    StudyWork work;
    work.frames = KeepFrames::yes;
    run(study, work, progress);
    const auto check = [&](const auto& change) {
        StudyProgress forged = progress;
        change(forged);
        return restore_checkpoint(checkpoint_of(study, KeepFrames::yes, forged), study, KeepFrames::yes).check;
    };
    EXPECT_EQ(check([](StudyProgress&) {}), CheckpointCheck::ok);
    constexpr CheckpointCheck refused = CheckpointCheck::damaged;
    EXPECT_EQ(check([](StudyProgress& forged) { forged.state->motion.pop_back(); }), refused);
    EXPECT_EQ(check([](StudyProgress& forged) { forged.search.emplace_back().probe_state.emplace(); }), refused);
    EXPECT_EQ(check([](StudyProgress& forged) { forged.history.front().base_slip.clear(); }), refused);
    EXPECT_EQ(check([](StudyProgress& forged) { forged.history.front().block.pop_back(); }), refused);
    EXPECT_EQ(check([](StudyProgress& forged) { forged.record.frame.front().motion.clear(); }), refused);
    EXPECT_EQ(check([](StudyProgress& forged) { forged.record.frame.front().force.front().block = 99; }), refused);
    const std::string bytes = checkpoint_of(study, KeepFrames::yes, progress);
    EXPECT_EQ(restore_checkpoint(bytes.substr(0, bytes.size() - 9), study, KeepFrames::yes).check, refused);
}

}  // namespace
}  // namespace delabole
