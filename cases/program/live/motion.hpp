// Blocks in motion, a few milliseconds at a time.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace delabole {

class LiveMotion {
  public:
    // The scene must be valid: see check() of relaxation_study.hpp.
    explicit LiveMotion(const RelaxationStudy& study);

    // Outlines and centroids in the section, which blocks are fixed, and the tilt of gravity.
    Json blocks() const;

    // Continues until the blocks cannot be followed further, `most_steps` are made, or the time is up. When a run of
    // the study would end, its verdict is recorded, and the blocks move on.
    void go_on(std::uint64_t most_steps, std::chrono::milliseconds time);

    // {verdict, sentences, over}: how the run of the study ended, in the words of its report, and whether the blocks
    // cannot be followed further. An empty object if it has not ended yet.
    Json verdict() const;

    // From now on strength and loads are those of another study of the same blocks. Contacts keep their memory, and
    // unless the blocks have collapsed a new verdict is found, within the duration of the study. Returns false, and
    // changes nothing, if the blocks are not the same.
    bool change(const RelaxationStudy& study);

    // Returns the positions of all blocks and the forces, as little-endian 32-bit floats: time in s, steps, the number
    // of verdicts so far (0 where it is open), the time in s at which a block passed the thresholds of failure
    // (negative: none), applied work, kinetic, elastic, friction, damping and residual energy in J/m, unbalanced ratio,
    // numbers of blocks, of forces and of bolts; then x, y and angle of each block since the start (m, rad), of each
    // contact force its place (m) and components (N/m), and of each bolt that pulls, at every joint where it does, its
    // ends (m), its force (N/m), and by how much it has yielded (m).
    std::string picture() const;

  private:
    void decide();

    RelaxationStudy study_;
    std::optional<Simulation> simulation_;
    std::optional<HeadCard> verdict_;
    bool collapsed_ = false;
    std::size_t decisions_ = 0;
};

}  // namespace delabole
