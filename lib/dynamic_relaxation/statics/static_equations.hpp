// Forces that are out of balance in a state of the blocks, and how they change with small motions: what a static
// equilibrium solve repeats in each of its rounds.
#pragma once

#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"
#include "numerics/sparse_system.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace delabole {

// Resists the change from one state to the next: force for a displacement, as a share of a stiffness.
struct PseudoViscosity {
    double of_blocks;    // against displacements of each block, of the stiffest joint
    double of_contacts;  // between two blocks, of the springs that their contacts have or would have if they closed
};

// Displacement along a line of a point of one block against one of another: the product of (x, y, lever) with the
// first's displacements and turn times radius, and of (-x, -y, other_lever) with the second's.
struct PairDirection {
    double x = 0;
    double y = 0;
    double lever = 0;
    double other_lever = 0;

    Eigen::Vector3d of_first() const { return {x, y, lever}; }
    std::array<double, 6> of_both() const { return {x, y, lever, -x, -y, other_lever}; }
    PairDirection of_other_first() const { return {-x, -y, other_lever, lever}; }
};

// The force of a contact or a bond in a given state, N/m, and how it changes with the motion of its two blocks, N/m2.
struct PairResponse {
    PairDirection normal = {};
    PairDirection along = {};
    double normal_force = 0;
    double shear_force = 0;
    double normal_stiffness = 0;
    double shear_stiffness = 0;  // where it sticks
    double coupling = 0;         // of the shear force with the displacement along the normal, where it slides
    double normal_damping = 0;   // for a pseudo-viscosity of contacts of 1
    double shear_damping = 0;    // likewise
};

// Rotations and moments are counted at the block's radius: all unknowns are lengths, so that scenes of every size lead
// to the same equations. Loads: x force, y force and moment of each block.
//
// Which blocks act on each other is taken from a list of contacts and the whole bonds once; their forces and tangents
// are then added in place, tangents only where a solution asks for them.
class StaticEquations {
  public:
    StaticEquations(const Bodies& bodies, const std::vector<char>& held, const std::vector<Eigen::Vector3d>& loads,
                    const Bonds& bonds, const std::vector<BondMemory>& bond_memory, const ContactList& list);

    const std::vector<std::size_t>& free_blocks() const { return free_blocks_; }

    // N/m, of the loads of each block; infinite where it is held.
    std::vector<double> weights() const;

    // Sets the share of the loads that acts, 1 at first.
    void set_load_share(double share) { load_share_ = share; }

    // Without it, contacts do not resist, and nothing is computed for that.
    void let_contacts_resist() { contacts_resist_ = true; }

    // Forces, and what tangents are made of, where blocks have moved to `motion` since contacts had the memories of
    // `before`; `list`, which has the constructor's contacts in the same order, gets those of now.
    void evaluate(const std::vector<Motion>& motion, const MemoryArray& before, ContactList& list);

    // Three numbers for each free block: x force, y force, moment over radius.
    const Eigen::VectorXd& unbalanced() const { return unbalanced_; }
    // The greatest of a block over its load.
    double unbalanced_ratio() const;
    // Root of the mean square of forces over their blocks' loads.
    double mean_ratio(const Eigen::VectorXd& forces) const;

    // The net force on one block, its load and pseudo-viscosity included and bonds left out, and by how much it falls
    // with the block's own motion while the others stay; moments over the radius.
    struct BlockBalance {
        Eigen::Vector3d force;
        Eigen::Matrix3d tangent;
    };
    // `index`: among the free blocks, which have `moved` to `motion` since contacts had the memories of `before`.
    // Contacts of the block in `list` get their memories of now.
    BlockBalance balance_of(std::size_t index, const PseudoViscosity& resisting, const Eigen::VectorXd& moved,
                            const std::vector<Motion>& motion, const MemoryArray& before, ContactList& list);
    double load_of(std::size_t index) const;  // of a free block, N per metre run
    // Indices, among the free blocks, of those that a free block acts on.
    std::span<const int> neighbours_of(std::size_t index) const { return neighbours_[index]; }

    // Motion that would balance the forces if tangents stayed what they are: three numbers for each free block. Nothing
    // where the equations have no solution.
    std::optional<Eigen::VectorXd> change(const PseudoViscosity& resisting, const Eigen::VectorXd& forces);
    // The forces of pseudo-viscosity against blocks that have moved so far.
    Eigen::VectorXd resistance(const PseudoViscosity& resisting, const Eigen::VectorXd& moved) const;

    // Turns are about their own centre, exact to second order: what rolls over its toe stays on it.
    void move(const Eigen::VectorXd& change, std::vector<Motion>& motion) const;
    void move(std::size_t index, const Eigen::Vector3d& change, std::vector<Motion>& motion) const;

    std::uint64_t contacts_evaluated() const { return contacts_evaluated_; }

  private:
    // Where the three rows of a block in the three columns of another stand among the values of the system: the first
    // row of the first column, and entries from one column to the next.
    struct Place {
        int begin;  // none where one of the blocks is held
        int stride;
    };
    using Places = std::array<Place, 4>;  // block on block, other on block, block on other, other on other
    // Two blocks with what acts between them, in a row of the responses.
    struct Pair {
        std::size_t first;
        std::size_t second;  // the higher number
        std::size_t begin;
        std::size_t end;
        Places places;
    };
    static constexpr int none = -1;

    SparsePattern pattern_of() const;
    Places places_of(const SparsePattern& pattern, std::size_t block, std::size_t other) const;
    Eigen::Vector3d load_on(std::size_t block) const;  // moments over the radius
    void list_what_acts(const ContactList& list);
    PairResponse response_of_contact(std::size_t index, const std::vector<Motion>& motion, const MemoryArray& before,
                                     ContactList& list);
    // Adds the forces of what acts between two blocks, and keeps it among the responses.
    void take_up(std::size_t block, std::size_t other, const PairResponse& response, std::size_t index);

    const Bodies& bodies_;
    const std::vector<Eigen::Vector3d>& loads_;
    const Bonds& bonds_;
    const std::vector<BondMemory>& bond_memory_;
    std::vector<std::size_t> free_blocks_ = {};
    std::vector<int> unknown_;  // first of a block's three; none where it is held
    std::vector<Pair> pairs_ = {};
    std::vector<PairResponse> response_ = {};                 // of the contacts, then of the bonds, two each
    std::vector<std::vector<std::size_t>> contacts_of_ = {};  // of each free block
    std::vector<std::vector<int>> neighbours_ = {};
    std::vector<int> diagonal_ = {};           // among the values, of each unknown
    std::optional<SparseSystem> system_ = {};  // none where no block is free
    bool contacts_resist_ = false;
    Eigen::VectorXd unbalanced_ = {};
    double load_share_ = 1;
    double stiffest_ = 0;
    std::uint64_t contacts_evaluated_ = 0;
};

}  // namespace delabole
