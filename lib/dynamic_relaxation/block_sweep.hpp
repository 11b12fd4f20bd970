// Newton's law for one block after the other, four at a time where they are free: a kick by the forces, then motion
// with the new velocity.
#pragma once

#include "dynamic_relaxation/bodies.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace delabole {

// What all blocks of a scene keep, besides their bodies.
struct BlockScales {
    std::vector<double> inverse_radius = {};  // 1/m
    std::vector<double> inverse_weight = {};  // m/N
    std::vector<double> calm_speed = {};      // m/s, below which a block may be calm
};

// What a sweep reads and changes: arrays of the blocks.
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
    // A block whose `calm` has reached `calm_enough` is at rest until the forces on it are out of balance by four times
    // this share of its weight.
    double rest_ratio;
    std::uint32_t calm_enough;
    Motion* motion;
    double* way;
    std::uint32_t* calm;  // set to zero where a block is not
    // Where blocks are carried along by a base that turns: its motion before the step, whichever is moved first.
    Motion base = {};
};

struct StepSums {
    double unbalanced = 0;  // share of the weight
    double applied = 0;     // J/m
    double prescribed = 0;  // J/m
    double damped = 0;      // J/m
};

// Of blocks `begin` to `end`. Their motion does not depend on which blocks are swept together, the last digits of the
// sums do.
StepSums move_blocks(const BlockSweep& sweep, std::size_t begin, std::size_t end);

}  // namespace delabole
