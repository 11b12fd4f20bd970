// Bonds: intact rock across the shared face of two blocks, which can break.
//
// Rigid-body-spring element (Kawai 1978): over the face, springs of normal and shear stiffness per area join the two
// rigid blocks. With opening n and slide s of the face's middle, turn t of the one block against the other, length L:
//   normal force k_n L n,  shear force k_s L s,  moment k_n L^3 / 12 t,  stress at the ends k_n (n +- t L / 2),
// all from one energy, k_n L n^2 / 2 + k_s L s^2 / 2 + k_n L^3 t^2 / 24, in axes that turn with the second block:
// forces are objective under any rotation, and undamped bonds dissipate nothing. n, s and t need not be small; the
// assumption is that blocks deform only at their faces. With k_n = E / h and k_s = G / h over a spacing h a chain of
// blocks is a beam: its bending is exact to second order in h, and its shear is carried evenly by the whole face (a
// beam of rectangular section shears 6/5 as much).
//
// Strength: the greatest tension, at an end of the face, is compared with the tensile strength, and the mean shear with
// cohesion + mean compression tan(friction). A bond breaks as a whole. Once its outermost fibre has failed, the same
// moment acts on a section L' that is shorter by the crack, at stresses that grow as 1 / L'^2: unless the load falls
// off as fast, the crack runs through. (Under enough compression it would stop: such a face goes on bearing through its
// contacts, whose forces are at its ends.) From then on the ordinary contacts of the pair act. They start with the
// compression and the shear (up to what friction holds) that the bond carried: the shortening of the rock is kept. To
// keep it, the whole outline of one block is shifted, as the contacts of the other see it. The shift is rigid; after it
// the joint's springs, which are stiffer than the rock, carry the same at both ends of the face. Without it, corners
// that come to other edges of the two blocks would overlap them by the shortening of the rock, on springs with many
// times its energy. The rest of the bond's energy is set free.
//
// A joint with tensile strength, or with cohesion that is lost by slip, has a bond of its own where no rock bridges it.
// The bond is as stiff as the two contacts that it replaces, so that the time step is set by them. Contacts have no
// tensile strength: at two corners it would carry three times the moment of a section. And cohesion would be lost at
// the corner in less compression before that of the other is used up. Strength of the face, with N the force and M the
// moment on it:
//   shear   cohesion L + N tan(friction), the joint's peak: limit equilibrium
//   moment  (N + t L) L / 6, the elastic section with a tensile strength t; or N L / 2, if that is more: as long as
//           both ends would be pressed without it, the joint stays closed.
// A joint loses its tensile strength where an end lifts off, but keeps its cohesion: each of the contacts that replace
// the bond has half of it, until it slips or opens. Contacts also replace a bond that is overloaded in shear while
// static equilibrium is sought: without inertia, load passes from joint to joint before they break.
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
#include <span>
#include <vector>

namespace delabole {

struct FaceStiffness {
    double normal_stiffness;   // N/m per metre run, of the whole face
    double shear_stiffness;    // N/m per metre run, of the whole face
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
    bool of_joint;    // strength of the joint itself, without rock
    // Stiffness of the bond, or of the contacts that replace it, whichever is greater: a time step too long for the
    // contacts would throw the blocks apart when the bond breaks.
    FaceStiffness stiffest;
    double contact_stiffness;  // N/m, normal, of each of the two
};

// `handed_over` occurs for bonds of joints only: the contacts replace a bond that is overloaded in shear, or has no
// tensile strength, and keep its cohesion.
enum class BondState { whole, broken_in_tension, broken_in_shear, block_removed, handed_over };

constexpr bool is_broken(BondState state) {
    return state == BondState::broken_in_tension || state == BondState::broken_in_shear;
}

struct BondMemory {
    BondState state = BondState::whole;
    double time = 0;          // s, at which it broke
    double damping = 0;       // J/m, dissipated so far
    double normal_drag = 0;   // N/m, force of the dashpots when last evaluated
    double shear_drag = 0;    // N/m
    double bending_drag = 0;  // N
    // Shift of the pair, set when the last bonds of the pair break, in one of these bonds only.
    OutlineShift shift = {};
};

// Makes one bond for each bond of a valid scene.
std::vector<Bond> make_bonds(const RelaxationScene& scene, const Bodies& bodies, double viscous_damping);

// Bonds across all faces that lie on each other in the initial geometry. A bond is of rock where the joints of both
// faces are bonded; once it has broken, the contacts of joint_between act. Otherwise a bond is of that joint itself, if
// it has strength to lose: tensile strength, or more cohesion or friction than remains. Corners that slip one after the
// other would lose the peak of a face before the face has reached it.
std::vector<FaceBond> find_bonds(const RelaxationScene& scene);

// Energy of the bond's springs, J/m.
double elastic_energy(const Bond& bond, const FacePosition& at);

// Load of a bond as a share of its strength; it holds up to 1.
struct BondLoading {
    double tension;  // share of the tensile strength
    double shear;    // share of the shear strength
    double worst() const { return tension > shear ? tension : shear; }
};

BondLoading loading_of(const Bond& bond, const FacePosition& at);

// The bonds of a scene with their current forces, and the outlines on which contacts are based instead of those drawn:
// where rock shortened before it broke, and where blocks on a closed joint were drawn apart or overlapping.
class Bonds {
  public:
    Bonds(const RelaxationScene& scene, const Bodies& bodies, double viscous_damping, Team& team);

    bool empty() const { return bond_.empty(); }
    const std::vector<Bond>& list() const { return bond_; }
    // Numbers of a block's bonds, including broken ones, in increasing order.
    std::span<const std::uint32_t> of_block(std::size_t block) const;
    // Pairs with a whole bond, in increasing order.
    std::vector<BlockPair> joined(const std::vector<BondMemory>& memory) const;

    // Pairs whose closed joint was not drawn closed or whose rock had shortened before it broke, in increasing order.
    std::span<const ShiftedPair> shifted() const { return shifted_; }
    // Computes again what the memory of a resumed run does not hold.
    void resume(const std::vector<BondMemory>& memory);

    // Computes the forces of the whole bonds after a step that took blocks to `motion`. Overloaded bonds break and
    // carry nothing from then on; their numbers are returned. The result is the same to the bit however the work is
    // divided, because the forces on a block are added in the order of the bonds.
    std::vector<std::size_t> stretch(const std::vector<Motion>& motion, double step, double time,
                                     std::vector<BondMemory>& memory);
    // Forces of the last call of stretch; must not be called for a scene without bonds.
    const std::vector<BlockForce>& on_blocks() const { return force_on_block_; }

    // J/m, stored in a bond or, some seconds `ago`, with its present force and velocity.
    double elastic_energy(std::size_t index, const std::vector<Motion>& motion, double ago = 0) const;
    // J/m, stored in the bonds that are whole.
    double elastic_energy(const std::vector<Motion>& motion, const std::vector<BondMemory>& memory) const;
    // Breaks whole bonds that are overloaded at rest and returns their numbers: all those that hand over to contacts at
    // once, or else the most overloaded one. The result is empty if all bonds hold.
    std::vector<std::size_t> break_at_rest(const std::vector<Motion>& motion, double time,
                                           std::vector<BondMemory>& memory);

  private:
    void sum();
    // Sets the shifts of pairs whose bonds have just broken.
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
    // Stored because the contact list reads it at every update, while bonds rarely break.
    std::vector<ShiftedPair> shifted_ = {};
    std::vector<ShiftedPair> closed_;
};

// Contacts along the bond's face that have replaced the bond take over what it carried, as far as they can. `state` is
// the bond's new state, no longer `whole`. Returns the elastic energy that the contacts then hold, J/m, or would have
// held some seconds `ago` with their present forces and velocities.
double hand_over(const Bond& bond, BondState state, const Bodies& bodies, const std::vector<Motion>& motion,
                 ContactList& list, double ago = 0);

}  // namespace delabole
