// Newton's law for one block after the other, four at a time where they are free: a kick by the forces, then motion
// with the new velocity. The sweep also notes whether the contacts of a block have to be evaluated again.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace delabole {

// Constant numbers of all blocks of a scene, besides their bodies.
struct BlockScales {
    std::vector<double> inverse_radius = {};  // 1/m
    std::vector<double> inverse_weight = {};  // m/N
    std::vector<double> rest_speed = {};      // m/s, below which a block may be at rest
    std::vector<double> unnoticed = {};       // m, motion that its contacts may ignore
};

// Notes for each block whether it has moved by more than its contacts may ignore. The motion is measured from the pose
// at the last note, so that even the slowest motion is noticed as soon as it matters.
struct NoticedMotion {
    std::vector<char> moved = {};  // 1: its contacts are to be evaluated again, because it has moved that far or has
                                   // new ones
    std::vector<double> x = {};    // pose when its motion was last noticed
    std::vector<double> y = {};
    std::vector<double> angle = {};

    void resize(std::size_t blocks) {
        moved.resize(blocks);
        x.resize(blocks);
        y.resize(blocks);
        angle.resize(blocks);
    }
    void notice(std::size_t block, const Motion& motion) {
        moved[block] = 1;
        x[block] = motion.x;
        y[block] = motion.y;
        angle[block] = motion.angle;
    }
};

// The arrays of the blocks that a sweep reads and changes.
struct BlockSweep {
    const Bodies& bodies;
    const BlockScales& scales;
    const char* held;
    const BlockForce* of_contacts;
    const BlockForce* of_bonds;  // null: none
    const BlockForce* load;
    double local_damping;
    double kick;  // s, over which forces change the velocities
    double step;  // s, over which the velocities move the blocks
    // A block whose `checks_at_rest` has reached `checks_before_rest` is at rest until the unbalanced force on it
    // exceeds four times this share of its weight.
    double rest_ratio;
    std::uint32_t checks_before_rest;
    Motion* motion;
    double* travelled;
    std::uint32_t* checks_at_rest;  // set to zero for a block that is not at rest
    NoticedMotion& noticed;
    // Motion, before the step, of a base that rotates and carries blocks along, so that the order of moving does not
    // matter.
    Motion base = {};
};

struct StepSums {
    double unbalanced = 0;  // share of the weight
    double applied = 0;     // J/m
    double prescribed = 0;  // J/m
    double damped = 0;      // J/m
    double fastest = 0;     // m/s, no point of any block is faster
};

// Moves blocks `begin` to `end`. Their motion does not depend on which blocks are swept together, but the last digits
// of the sums do.
StepSums move_blocks(const BlockSweep& sweep, std::size_t begin, std::size_t end);

}  // namespace delabole
