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

    // Outlines and centroids in the section, which blocks are fixed, the words for outcomes, and the tilt of gravity.
    Json blocks() const;

    // Goes on until the run ends, `most_steps` are made, or the time is up.
    void go_on(std::uint64_t most_steps, std::chrono::milliseconds time);

    // Strength and loads are those of another study of the same blocks from now on; contacts keep what they have
    // endured. False, and nothing changes, where the blocks are not the same.
    bool change(const RelaxationStudy& study);

    // Where everything is, as little-endian 32-bit floats: time in s, steps, number of the outcome among
    // enum_names(RelaxationOutcome), applied work, kinetic, elastic, friction, damping and residual energy in J/m,
    // unbalanced ratio, numbers of blocks, of forces and of bolts; then x, y and angle of each block since the start
    // (m, rad), of each contact force its place (m) and components (N/m), and of each bolt that pulls, at every joint
    // where it does, its ends (m), its force (N/m), and by how much it has yielded (m).
    std::string picture() const;

  private:
    std::optional<Simulation> simulation_;
};

}  // namespace delabole
