// A checkpoint on the disk: taken up again, replaced, and refused by name.
#include "cases/program/models/relaxation/checkpoint_file.hpp"

#include "dynamic_relaxation/checkpoint/study_checkpoint.hpp"
#include "plots/drawing/atomic_file.hpp"
#include "tests/plots/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace delabole {
namespace {

RelaxationStudy two_blocks(double tilt) {
    RelaxationRow row{};
    row.tilt = degrees(tilt);
    row.density = 2700;
    row.interface.friction_angle = row.base.friction_angle = degrees(30);
    row.block = {{1, 3, {}}, {1, 3, {}}};
    RelaxationStudy study{};
    study.model.scene = row;
    return study;
}

StudyProgress progress_of(const RelaxationStudy& study) {
    StudyProgress progress;
    run(study, {}, progress);
    return progress;
}

class CheckpointFile : public ::testing::Test {
  protected:
    std::string refusal(const RelaxationStudy& other) const {
        const KeptProgress kept = read_checkpoint(path, other, KeepFrames::no);
        EXPECT_FALSE(kept.found);
        // Only progress of another case or version is marked as such, so that it is not overwritten.
        EXPECT_EQ(kept.of_other, kept.refusal.starts_with("belongs to") || kept.refusal.starts_with("was written by"));
        return kept.refusal;
    }

    const RelaxationStudy study = two_blocks(10);
    const ScratchFolder folder;
    const std::filesystem::path path = folder.path() / "checkpoint";
};

TEST_F(CheckpointFile, IsTakenUpAgainAndReplaced) {
    StudyProgress progress = progress_of(study);
    for (const double next : {0.0, 1.0}) {
        progress.next_line = next;
        write_checkpoint(path, study, KeepFrames::no, progress);
        const KeptProgress kept = read_checkpoint(path, study, KeepFrames::no);
        EXPECT_TRUE(kept.found);
        EXPECT_EQ(kept.refusal, "");
        EXPECT_EQ(checkpoint_of(study, KeepFrames::no, kept.progress), content_of(path));
        EXPECT_EQ(kept.progress.next_line, next);
        EXPECT_EQ(folder.names(), std::vector<std::string>{"checkpoint"});
    }
}

TEST_F(CheckpointFile, IsRefusedByName) {
    EXPECT_EQ(refusal(study), "");
    write_file_atomically(path, "schema = 1\n");
    EXPECT_EQ(refusal(study), "is not a checkpoint of dynamic relaxation");
    write_checkpoint(path, study, KeepFrames::no, progress_of(study));
    EXPECT_EQ(refusal(two_blocks(11)), "belongs to another case, or to this one with other values");
    const std::string bytes = content_of(path);
    write_file_atomically(path, bytes.substr(0, bytes.size() / 2));
    EXPECT_EQ(refusal(study), "is damaged");
    std::string later = bytes;
    ++later[8];
    write_file_atomically(path, later);
    EXPECT_EQ(refusal(study), "was written by another version of delabole");
}

// The files are sparse: only their sizes are so large.
TEST_F(CheckpointFile, LargerThanTheMemoryIsRefusedByName) {
    constexpr std::uintmax_t hundred_gigabytes = 100'000'000'000;
    write_file_atomically(path, "");
    std::filesystem::resize_file(path, hundred_gigabytes);
    EXPECT_EQ(refusal(study), "is not a checkpoint of dynamic relaxation");
    write_checkpoint(path, study, KeepFrames::no, progress_of(study));
    const std::string bytes = content_of(path);
    std::filesystem::resize_file(path, hundred_gigabytes);
    EXPECT_EQ(refusal(study), "is damaged");
    // The length in the file now agrees with its size.
    constexpr std::size_t place_of_length = 24;
    constexpr std::size_t around_the_body = 40;
    std::string beginning = bytes;
    for (std::size_t index = 0; index < 8; ++index) {
        beginning[place_of_length + index] = static_cast<char>((hundred_gigabytes - around_the_body) >> (8 * index));
    }
    write_file_atomically(path, beginning);
    std::filesystem::resize_file(path, hundred_gigabytes);
    EXPECT_EQ(refusal(study), "is larger than 65536 MiB, the limit for a checkpoint");
}

TEST_F(CheckpointFile, IsNoFolderAndMakesItsOwn) {
    std::filesystem::create_directory(path);
    EXPECT_EQ(refusal(study), "is a folder, not a checkpoint");
    const StudyProgress progress = progress_of(study);
    EXPECT_THROW(write_checkpoint(path, study, KeepFrames::no, progress), OutputError);
    const std::filesystem::path inside = folder.path() / "new" / "checkpoint";
    write_checkpoint(inside, study, KeepFrames::no, progress);
    EXPECT_TRUE(read_checkpoint(inside, study, KeepFrames::no).found);
}

}  // namespace
}  // namespace delabole
