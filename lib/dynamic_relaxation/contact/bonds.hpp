// Bonds: intact rock across the shared face of two blocks, which can break.
//
// Rigid-body-spring element (Kawai 1978): over the face, springs of normal and shear stiffness per area join the two
// rigid blocks. With opening n and slide s of the face's middle, turn t of the one block against the other, length L:
//   normal force k_n L n,  shear force k_s L s,  moment k_n L^3 / 12 t,  stress at the ends k_n (n +- t L / 2),
// all from one energy, k_n L n^2 / 2 + k_s L s^2 / 2 + k_n L^3 t^2 / 24, in axes that turn with the second block:
// forces are objective under any rotation, and undamped bonds dissipate nothing. n, s and t being small is no part of
// it; that blocks bend only at their faces is. With k_n = E / h and k_s = G / h over a spacing h a chain of blocks is a
// beam: bending to second order in h, shear with the whole face carrying it evenly (a beam's section of rectangular
// shape shears 6/5 as much).
//
// Strength: the greatest tension, at an end of the face, against the tensile strength; the mean shear against cohesion
// + mean compression tan(friction). A bond breaks as a whole. Once its outermost fibre has gone, the same moment acts
// on a section shorter by the crack, L', at stresses that grow as 1 / L'^2: under any load that does not fall off as
// fast the crack runs through. (Pressed hard enough, it would stop: such a face goes on bearing through its contacts,
// whose forces are at its ends.) From then on the ordinary contacts of the pair act. They start with the compression
// and the shear (as far as friction holds it) that the bond had there: what the rock has shortened stays shortened. By
// that the whole outline of one block is shifted as the other's contacts see it, a rigid shift by as much as makes the
// joint's springs, stiffer than the rock, hold the same at both ends of the face; else corners that come to other edges
// of the two blocks would lie there as deep as the rock has given way, on springs with many times its energy. The rest
// of the bond's energy is set free.
//
// A joint with cohesion that a slip takes away, or with tensile strength, has a bond of its own where there is no rock
// across it. It is as stiff as the two contacts in whose place it stands, so that they set its time step. At two
// corners tensile strength would bear three times the moment that it bears over a section, and cohesion would be lost
// at the corner that is pressed less before the other is spent. Strength of the face, with N the force and M the moment
// on it:
//   shear   cohesion L + N tan(friction), the joint's peak: limit equilibrium
//   moment  (N + t L) L / 6, the elastic section with a tensile strength t; or N L / 2, if that is more: as long as
//           both ends would be pressed without it, the joint stays closed.
// Without tensile strength such a bond does not break where an end lifts off: the contacts that take its place still
// have their cohesion, each half of it, until they slip or open. They take its place as well where it is overloaded in
// shear while static equilibrium is sought: without inertia joints give way one to the other before they break.
//
// While a pair of blocks has a whole bond, it has no contacts. Reference: Kawai, T. (1978) New discrete models and
// their application to seismic response analysis of structures. Nucl. Eng. Des. 48, 207-229.
#pragma once

#include "dynamic_relaxation/blocks/neighbours.hpp"
#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/contact/contact_forces.hpp"
#include "dynamic_relaxation/scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace delabole {

struct FaceStiffness {
    double normal_stiffness;   // N/m per metre run, of the whole face
    double shear_stiffness;    // N/m per metre run, likewise
    double bending_stiffness;  // N per metre run and radian
    double normal_dashpot;
    double shear_dashpot;
    double bending_dashpot;
};

struct Bond : FaceStiffness {
    SharedFace face;
    double tension;   // Pa
    double cohesion;  // Pa
    double friction;  // tangent
    bool of_joint;    // the joint's own strength, no rock
    // Stiffness of the bond, or of the contacts that take its place, whichever is more: a time step too long for them
    // would throw the blocks apart in the moment of breaking.
    FaceStiffness stiffest;
    double contact_stiffness;  // N/m, normal, of each of the two
};

// Handed over: only of a joint; its contacts bear in the bond's place, with all of the strength of theirs.
enum class BondState { whole, broken_in_tension, broken_in_shear, block_removed, handed_over };

constexpr bool is_broken(BondState state) {
    return state == BondState::broken_in_tension || state == BondState::broken_in_shear;
}

struct BondMemory {
    BondState state = BondState::whole;
    double time = 0;          // s, at which it broke
    double damping = 0;       // J/m, dissipated so far
    double normal_drag = 0;   // N/m, of the dashpots when last evaluated
    double shear_drag = 0;    // N/m
    double bending_drag = 0;  // N
    // Of its pair, from when the last bonds of the pair broke; with one of these alone.
    OutlineShift shift = {};
};

// The scene must be valid: one for each of its bonds.
std::vector<Bond> make_bonds(const RelaxationScene& scene, const Bodies& bodies, double viscous_damping);

// Bonds across all faces that lie on each other in the initial geometry. Of rock where the joints of both have a bond;
// the material is that of the joint with less friction, whose contacts act once it has broken. Of that joint itself
// where it has strength to lose: tensile strength, or more cohesion than remains.
std::vector<FaceBond> find_bonds(const RelaxationScene& scene);

// J/m
double elastic_energy(const Bond& bond, const FacePosition& at);

// How far a bond is loaded beyond its strength: up to 1 it bears.
struct BondLoading {
    double tension;  // share of the tensile strength
    double shear;    // share of the shear strength
    double worst() const { return tension > shear ? tension : shear; }
};

BondLoading loading_of(const Bond& bond, const FacePosition& at);

// The bonds of a scene with the forces of the moment. Of a scene without bonds nothing is kept and nothing computed.
class Bonds {
  public:
    Bonds(const RelaxationScene& scene, const Bodies& bodies, double viscous_damping, Team& team);

    bool empty() const { return bond_.empty(); }
    const std::vector<Bond>& list() const { return bond_; }
    // Numbers of a block's bonds, broken ones too, in increasing order.
    std::span<const std::uint32_t> of_block(std::size_t block) const;
    // Pairs with a whole bond, in increasing order.
    std::vector<BlockPair> joined(const std::vector<BondMemory>& memory) const;

    // Pairs whose rock has become shorter before it broke, in increasing order.
    std::span<const ShiftedPair> shifted() const { return shifted_; }
    // Finds again what is not in the memory, with which a run goes on.
    void resume(const std::vector<BondMemory>& memory);

    // Forces of the whole bonds after a step that took blocks to `motion`; those overloaded break, and do nothing any
    // more. Returns which. The same bits come out however the work is divided: the forces on a block are added in the
    // order of the bonds.
    std::vector<std::size_t> stretch(const std::vector<Motion>& motion, double step, double time,
                                     std::vector<BondMemory>& memory);
    // Forces of the last call of stretch; not to be asked for without bonds.
    const std::vector<BlockForce>& on_blocks() const { return force_on_block_; }

    double elastic_energy(std::size_t bond, const std::vector<Motion>& motion) const;
    // J/m, stored in the bonds that are whole.
    double elastic_energy(const std::vector<Motion>& motion, const std::vector<BondMemory>& memory) const;
    // Breaks whole bonds that are overloaded at rest: first those that hand over to contacts, all at once; where there
    // are none, the most overloaded one. Returns which; none where all bear.
    std::vector<std::size_t> break_at_rest(const std::vector<Motion>& motion, std::vector<BondMemory>& memory);

  private:
    void sum();
    // Of those just broken.
    void shift_outlines(const std::vector<std::size_t>& broken, const std::vector<Motion>& motion,
                        std::vector<BondMemory>& memory);

    Team& team_;
    std::vector<Bond> bond_;
    std::vector<ForceOnCorner> force_;
    std::vector<char> breaks_;  // in the last call of stretch
    std::vector<BlockForce> force_on_block_ = {};
    // Bonds of each block: begin_[block] to begin_[block + 1] in of_block_.
    std::vector<std::uint32_t> begin_ = {};
    std::vector<std::uint32_t> of_block_ = {};
    // The contact list asks for them at every update, while hardly a bond breaks.
    std::vector<ShiftedPair> shifted_ = {};
};

// Contacts of the bond's face that have come in its place take over what it carried, as far as they can. `state`: its,
// no longer whole. Returns the elastic energy that they hold then, J/m.
double hand_over(const Bond& bond, BondState state, const Bodies& bodies, const std::vector<Motion>& motion,
                 ContactList& list);

}  // namespace delabole
