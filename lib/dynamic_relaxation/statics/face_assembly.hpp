// Blocks and their faces as input of the linear programmes of limit equilibrium (limit_equilibrium/bound).
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"
#include "dynamic_relaxation/scene/scene.hpp"
#include "limit_equilibrium/bound/assembly.hpp"
#include "numerics/constants.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace delabole {

struct BlocksUnderLoad {
    const RelaxationScene& scene;
    const Bodies& bodies;
    const std::vector<char>& held;     // blocks that are fixed at present: the base of the assembly
    const std::vector<char>& removed;  // not 0: the block is not there
    const std::vector<Motion>& motion;
    std::span<const BlockForce> load;  // load of each block, including its weight
};

struct FaceAssembly {
    Assembly assembly;
    std::vector<std::size_t> block_of;  // of each body: the blocks neither held nor removed, in their order
};

// The memory of joints and bonds; bonds are in the order of the scene.
struct JointHistory {
    std::span<const BondMemory> bond;
    const ContactList& contacts;
};

// The faces with their peak strengths, or with those of bonded rock where they are greater. A history lowers the
// strengths: rock bridges that have broken bear nothing; an end of a pair's joint that has slipped or opened has lost
// its part of the cohesion, and the pair its tensile strength and its peak friction.
//
// The programme lets tension act beside compression. Shear is limited by Coulomb's c + N tan(phi) for every N, with
//     t' = min(t, c / tan(phi)),  c' = c - t' tan(phi)
// in place of tensile strength t and cohesion c: compression N + t' beside a tension t' allows c' + (N + t') tan(phi).
FaceAssembly face_assembly(const BlocksUnderLoad& blocks, const std::vector<SharedFace>& faces,
                           const JointHistory* history = nullptr);

// Adds contacts at points, outside these faces: corners that touch an edge of another block, except corners on corners
// (corner_choice.hpp). Edges that continue straight past a corner count as one edge. `least_gap`: of those that were
// farther apart in the initial geometry, in openings of closed joints.
void add_corners_on_edges(const BlocksUnderLoad& blocks, const ContactList& list, FaceAssembly& made,
                          double least_gap = -infinity);

// The same for blocks that have not moved and have no contacts yet: corners that lie on an edge of another block,
// between its ends, where the two share no face and have not moved.
void add_tips_on_edges(const BlocksUnderLoad& blocks, const std::vector<SharedFace>& faces, FaceAssembly& made);

// Adds bolts that bear any tension up to their capacity, and no compression, along their initial axis where their
// blocks have carried it.
void add_bolts(const BlocksUnderLoad& blocks, FaceAssembly& made);

}  // namespace delabole
