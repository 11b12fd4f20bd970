// A checkpoint on the disk: taken up again, replaced, and refused by name.
#include "cases/checkpoint_file.hpp"

#include "cases/case_error.hpp"
#include "dynamic_relaxation/checkpoint.hpp"
#include "dynamic_relaxation/scenes.hpp"
#include "dynamic_relaxation/simulation.hpp"
#include "plots/atomic_file.hpp"
#include "tests/plots/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace delabole {
namespace {

class CheckpointFile : public testing::Test {
  protected:
    std::string complaint_about(const RelaxationScene& other) const {
        try {
            read_checkpoint(path, other, settings);
        } catch (const CaseError& error) {
            return error.what();
        }
        return "none";
    }

    const JointMaterial joint{1e9, 1e9, 0.5};
    const RelaxationScene scene = row_scene({{{1, 3}, {1, 3}}, 2700, joint, joint, 0.4});
    const RelaxationSettings settings = {};
    const ScratchFolder folder;
    const std::filesystem::path path = folder.path() / "checkpoint";
};

TEST_F(CheckpointFile, IsTakenUpAgainAndReplaced) {
    Simulation run(scene, settings);
    for (int write = 0; write < 3; ++write) {
        for (int step = 0; step < 50; ++step) {
            run.step();
        }
        write_checkpoint(path, scene, settings, run.state());
        const RelaxationState state = read_checkpoint(path, scene, settings);
        EXPECT_EQ(state.steps, run.state().steps);
        EXPECT_EQ(checkpoint_of(scene, settings, state), checkpoint_of(scene, settings, run.state()));
        EXPECT_EQ(folder.names(), std::vector<std::string>{"checkpoint"});
    }
}

TEST_F(CheckpointFile, IsRefusedByName) {
    EXPECT_EQ(complaint_about(scene), path.string() + ": there is no such file");
    write_file_atomically(path, "schema = 1\n");
    EXPECT_EQ(complaint_about(scene), path.string() + ": is not a checkpoint of dynamic relaxation");
    write_checkpoint(path, scene, settings, Simulation(scene, settings).state());
    EXPECT_EQ(complaint_about(scene), "none");
    RelaxationScene other = scene;
    other.gravity.tilt = 0.3;
    EXPECT_EQ(complaint_about(other), path.string() +
                                          ": belongs to another case, or to this one with other values: a run can only "
                                          "go on as it began");
    const std::string bytes = content_of(path);
    write_file_atomically(path, bytes.substr(0, bytes.size() / 2));
    EXPECT_EQ(complaint_about(scene), path.string() + ": is damaged: the run has to start anew");
    std::string later = bytes;
    ++later[8];
    write_file_atomically(path, later);
    EXPECT_EQ(complaint_about(scene),
              path.string() + ": was written by another version of delabole: the run has to start anew");
}

TEST_F(CheckpointFile, IsNoFolderAndGoesIntoOne) {
    std::filesystem::create_directory(path);
    EXPECT_EQ(complaint_about(scene), path.string() + ": is a folder, not a checkpoint");
    const RelaxationState state = Simulation(scene, settings).state();
    EXPECT_THROW(write_checkpoint(path, scene, settings, state), OutputError);
    EXPECT_THROW(write_checkpoint(folder.path() / "missing" / "checkpoint", scene, settings, state), OutputError);
}

}  // namespace
}  // namespace delabole
