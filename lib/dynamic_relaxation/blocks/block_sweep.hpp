// Newton's law for one block after the other, four at a time where they are free: a kick by the forces, then motion
// with the new velocity. Whether the contacts of a block have to be evaluated again is noticed on the way.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace delabole {

// Numbers that all blocks of a scene keep, besides their bodies.
struct BlockScales {
    std::vector<double> inverse_radius = {};  // 1/m
    std::vector<double> inverse_weight = {};  // m/N
    std::vector<double> rest_speed = {};      // m/s, below which a block may be at rest
    std::vector<double> unnoticed = {};       // m, motion that its contacts may disregard
};

// Says of each block whether it has moved by more than its contacts may disregard, measured from where that was last
// noticed: the slowest motion is noticed as soon as it matters.
struct NoticedMotion {
    std::vector<char> moved = {};  // 1: its contacts are to be evaluated again, for it has come so far or has new ones
    std::vector<double> x = {};    // pose when that was last noticed
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
    double step;  // s, over which these move the blocks
    // A block whose `checks_at_rest` has reached `checks_before_rest` is at rest until the forces on it are out of
    // balance by four times this share of its weight.
    double rest_ratio;
    std::uint32_t checks_before_rest;
    Motion* motion;
    double* travelled;
    std::uint32_t* checks_at_rest;  // set to zero where a block is not
    NoticedMotion& noticed;
    // The motion before the step of a base that turns and carries blocks along, whichever is moved first.
    Motion base = {};
};

struct StepSums {
    double unbalanced = 0;  // share of the weight
    double applied = 0;     // J/m
    double prescribed = 0;  // J/m
    double damped = 0;      // J/m
    double fastest = 0;     // m/s, no point of any block is faster
};

// Moves blocks `begin` to `end`. Their motion does not depend on which blocks are swept together, the last digits of
// the sums do.
StepSums move_blocks(const BlockSweep& sweep, std::size_t begin, std::size_t end);

}  // namespace delabole
