// The thesis's dynamic relaxation program (Appendix B), re-created to reproduce and explain its printed runs.
//
// It is not a scheme to compute with: its faults are kept on purpose. It shares nothing with the engine beside it.
// Kept from the listing, statement by statement of its main loop:
// - Corner-to-face contacts between a block and its listed neighbours. One slot of memory for each pair of corner and
//   neighbour, whatever face the corner is in: normal and shear position of the last cycle, and shear force.
// - The face a corner has entered is the one that the line from the corner's own centroid through the corner crosses,
//   of two such faces the one nearer to that centroid. Which faces are crossed is told from the bearings of the
//   crossing points as seen from the neighbour's centroid. A crossing point less than 1e-5 m to either side of the
//   vertical through that centroid is moved to 1e-5 m right of it, as a guard against a division that is not there.
// - Normal dashpot: difference of the stored positions over one cycle, although they may belong to different faces.
//   When a slot passes from a side to an end it jumps by half the difference of height and width, and the dashpot turns
//   that into a force of some ten thousand times the weight: the blocks blow out. Corners that meet exactly make it
//   pass; so does the guard, where a side is crossed just left of the vertical below the neighbour's centroid, as close
//   to the toe of a column on the point of toppling: moved past the toe, the crossing is taken to be beyond the side.
// - The stored shear force contains the dashpot's, so that damping piles up as stiffness. A sliding contact has the
//   residual friction force alone. The limit is the spring's normal force times the coefficient of friction; the normal
//   dashpot may pull.
// - Dashpot constant: damping * 2 sqrt(stiffness * mass of the corner's block); one stiffness, normal and shear.
// - Velocities first, then positions with the new velocities; velocities of fixed blocks are set to zero.
// Changed: rectangles only (DIPA + DIPB = 90 deg); the joints between free blocks and the bases may have different
// friction (the thesis reports such runs, the listing has one friction); tilting, which the listing lacks.
//
// Units: SI and radians, per metre run. x to the right, y up; blocks slide towards -x.
#pragma once

#include "geometry/polyline.hpp"

#include <array>
#include <optional>
#include <vector>

namespace delabole {

constexpr int no_block = -1;

// The blocks that may touch a block: indices into those of the run, `no_block` if there is none. They are given as
// data, as in the listing, and never updated. "Below" is the block it stands on, "downhill" is towards -x.
struct HockingNeighbours {
    int below = no_block;
    int below_uphill = no_block;
    int uphill = no_block;
    int above_uphill = no_block;
    int above = no_block;
    int above_downhill = no_block;
    int downhill = no_block;
    int below_downhill = no_block;
};

struct HockingBlock {
    double width = 0;   // m, along its base, > 0
    double height = 0;  // m, > 0
    Point centroid = Point::Zero();
    double dip = 0;  // rad, of its base at the start, rising towards +x
    bool fixed = false;
    HockingNeighbours neighbours = {};
};

struct HockingFriction {
    double peak = 0;      // rad, >= 0 (DMU)
    double residual = 0;  // rad, >= 0 (RSD)
};

enum class TiltedPart { gravity, base };

// Small increments of tilt at regular cycles. The thesis does not say what was turned: gravity, which amounts to
// turning the whole model, or the fixed blocks under the others, each about its own centroid, which takes one statement
// in the listing.
struct HockingTilting {
    TiltedPart part = TiltedPart::gravity;
    int begin = 0;         // first cycle after which the tilt may change
    int every = 1;         // cycles
    double increment = 0;  // rad
    double total = 0;      // rad, where it ends
};

// `per_face` is no part of the listing: a slot forgets what it holds when its corner passes to another face. It shows
// what the listing's memory causes.
enum class HockingSlotMemory { per_neighbour, per_face };

struct HockingSettings {
    double time_step = 0;         // s, > 0 (DT)
    double damping = 0;           // fraction of critical, >= 0 (FAC)
    double stiffness = 0;         // N/m per metre run, > 0 (SN = ST)
    double density = 0;           // kg/m3, > 0 (RHO)
    double gravity = 0;           // m/s2 (GRAV)
    HockingFriction joints = {};  // between free blocks
    HockingFriction bases = {};   // between a free and a fixed block
    std::optional<HockingTilting> tilting = {};
    HockingSlotMemory slot_memory = HockingSlotMemory::per_neighbour;
    double crossing_guard = 1e-5;  // m, >= 0; the listing's 1.E-5
    // Bits of the significands that are stored from cycle to cycle; further ones are cut off, not rounded. The
    // listing's words of ten characters held 48, words of single precision on other machines 24.
    int significand_bits = 53;
    int cycles = 0;            // to run (NCYLE)
    int print_interval = 100;  // cycles, >= 1 (IPRINT): histories, sliding, decision
    // Limits by which a run is judged; the listing has none.
    double failure_rotation = 0;    // rad; a free block turned by this, relative to its base, has failed
    double stop_rotation = 0;       // rad; and this ends the run
    double settled_speed = 0;       // m/s; settled where no corner of a free block is faster at the end
    double blow_out_force = 0;      // of the free blocks' total weight: a contact force above it is a blow-out
    int cycles_after_blow_out = 0;  // to show where the blocks fly
};

enum class HockingOutcome { undecided, stands, fails, blows_out, impossible_input };

// At a print edit, from the contacts between a free and a fixed block marked as sliding. `both`: corners of one base
// slide opposite ways.
enum class BaseSliding { none, forward, backward, both };

struct HockingBlockState {
    Point centroid = Point::Zero();
    double angle = 0;  // rad, rotation since the start, anticlockwise (toppling downhill) positive
    Point velocity = Point::Zero();
    double angular_velocity = 0;  // rad/s
    BaseSliding sliding = BaseSliding::none;
};

struct HockingPrint {
    int cycle = 0;
    double tilt = 0;           // rad, turned so far
    double largest_force = 0;  // N/m, normal, of any contact since the last print
    std::vector<HockingBlockState> blocks = {};
};

// Faces of a block as the listing searches them, in the block's own frame.
enum class HockingFace { positive_side, negative_side, positive_end, negative_end };

// A slot that served another face in the cycle before. Sides are the two longer faces of a block.
struct HockingFaceChange {
    int cycle = 0;
    int block = no_block;  // whose corner it is
    int corner = 0;        // 0 to 3, the listing's 1 to 4
    int neighbour = no_block;
    HockingFace from = HockingFace::positive_side;
    HockingFace to = HockingFace::positive_side;
    double stored_position = 0;  // m, distance of the corner from the neighbour's axis along the old face
    double new_position = 0;     // m, and along the new face: the dashpot takes their difference for a movement
    double spring_force = 0;     // N/m
    double dashpot_force = 0;    // N/m
};

struct HockingResult {
    HockingOutcome outcome = HockingOutcome::impossible_input;
    std::vector<HockingPrint> prints = {};  // the first is the start
    int face_change_count = 0;
    std::optional<int> blow_out_cycle = {};          // the first contact force above the limit
    std::optional<HockingFaceChange> blow_out = {};  // by which, where it was a change of face
};

HockingResult run_hocking(const std::vector<HockingBlock>& blocks, const HockingSettings& settings);

// Returns the blocks at rest where a print shows them, to go on with other fixed blocks or another friction. Slots
// start empty.
std::vector<HockingBlock> blocks_at(const std::vector<HockingBlock>& blocks, const HockingPrint& print);

// Corners in the listing's order for a column, of a block turned by `angle` since the start.
std::array<Point, 4> corners_of(const HockingBlock& block, const HockingBlockState& state);

}  // namespace delabole
