// Blocks and their faces as the linear programmes of limit equilibrium see them (limit_equilibrium/bound).
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"
#include "dynamic_relaxation/scene/scene.hpp"
#include "limit_equilibrium/bound/assembly.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace delabole {

struct BlocksUnderLoad {
    const RelaxationScene& scene;
    const Bodies& bodies;
    const std::vector<char>& held;  // blocks that are fixed now: the base of the assembly
    const std::vector<Motion>& motion;
    std::span<const BlockForce> load;  // of each block, its weight among it
};

struct FaceAssembly {
    Assembly assembly;
    std::vector<std::size_t> block_of;  // of each body: the blocks that are not held, in their order
};

// The faces with their peak strengths, and with that of bonded rock where it is more and the bond is whole. `bond`: as
// the scene lists them; none: all are whole.
FaceAssembly face_assembly(const BlocksUnderLoad& blocks, const std::vector<SharedFace>& faces,
                           std::span<const BondMemory> bond = {});

// Adds what bears otherwise than over these faces, at a point: corners that touch an edge of another block, but for
// corners on corners (corner_choice.hpp). Edges that go on straight past a corner are one edge.
void add_corners_on_edges(const BlocksUnderLoad& blocks, const ContactList& list, FaceAssembly& made);

}  // namespace delabole
