// Unbalanced forces in a state of the blocks, and their changes with small motions: the part of a static equilibrium
// solve that each of its rounds repeats.
#pragma once

#include "dynamic_relaxation/statics/pair_response.hpp"
#include "numerics/sparse_system.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace delabole {

// Resists the change from one state to the next: force per displacement, as a share of a stiffness.
struct PseudoViscosity {
    double of_blocks;    // against displacements of each block, of the stiffest joint
    double of_contacts;  // between two blocks, of the springs that their contacts have or would have if they closed
};

// Rotations and moments are referred to the block's radius, so that all unknowns are lengths and scenes of every size
// lead to the same equations. Loads: x force, y force and moment of each block.
//
// The list of contacts and the whole bonds determine once which blocks interact; their forces and tangents are then
// added in place, tangents only when a solution needs them.
class StaticEquations {
  public:
    StaticEquations(const Bodies& bodies, const std::vector<char>& held, const std::vector<Eigen::Vector3d>& loads,
                    const Bonds& bonds, const std::vector<BondMemory>& bond_memory, std::span<const HeldByBolt> bolts,
                    const ContactList& list);

    const std::vector<std::size_t>& free_blocks() const { return free_blocks_; }

    // Load of each block, N/m; infinite where the block is held.
    std::vector<double> weights() const;

    // Turns on the pseudo-viscosity of contacts, including open ones, which keeps them from fluttering. Otherwise
    // nothing is computed for it.
    void let_contacts_resist() { contacts_resist_ = true; }

    // Computes forces and the parts of tangents after blocks have moved to `motion`, starting from the memories
    // `before` of the contacts. `list`, which has the constructor's contacts in the same order, gets their present
    // memories.
    void evaluate(const std::vector<Motion>& motion, const MemoryArray& before, ContactList& list);

    // The same if, since the last evaluation, only blocks have moved for which balance_of was called, and nothing else
    // has changed: computes the forces of their contacts only.
    void evaluate_again(const std::vector<Motion>& motion, const MemoryArray& before, ContactList& list);

    // Three numbers for each free block: x force, y force, moment over radius.
    const Eigen::VectorXd& unbalanced() const { return unbalanced_; }
    // Greatest unbalanced force of a block over its load.
    double unbalanced_ratio() const;
    // Root of the mean square of forces over their blocks' loads.
    double mean_ratio(const Eigen::VectorXd& forces) const;

    // The net force on one block, including its load and pseudo-viscosity but without bonds, and its decrease with the
    // block's own motion while the others stay; moments over the radius.
    struct BlockBalance {
        Eigen::Vector3d force;
        Eigen::Matrix3d tangent;
    };
    // `index`: among the free blocks, which have `moved` to `motion`, starting from the memories `before` of the
    // contacts. Contacts of the block in `list` get their present memories.
    BlockBalance balance_of(std::size_t index, const PseudoViscosity& resisting, const Eigen::VectorXd& moved,
                            const std::vector<Motion>& motion, const MemoryArray& before, ContactList& list);
    double load_of(std::size_t index) const;  // of a free block, N per metre run
    // Indices, among the free blocks, of the neighbours of a free block.
    std::span<const int> neighbours_of(std::size_t index) const { return neighbours_[index]; }

    // Motion that would balance the forces if tangents stayed constant: three numbers for each free block. Empty if the
    // equations have no solution.
    std::optional<Eigen::VectorXd> change(const PseudoViscosity& resisting, const Eigen::VectorXd& forces);
    // The forces of pseudo-viscosity after blocks have moved by `moved`.
    Eigen::VectorXd resistance(const PseudoViscosity& resisting, const Eigen::VectorXd& moved) const;

    // Each block rotates about its own centroid, exact to second order, so that a block that rolls over its toe stays
    // on it.
    void move(const Eigen::VectorXd& change, std::vector<Motion>& motion) const;
    void move(std::size_t index, const Eigen::Vector3d& change, std::vector<Motion>& motion) const;

    std::uint64_t contacts_evaluated() const { return contacts_evaluated_; }

  private:
    // Position, among the values of the system, of the three rows of one block in the three columns of another: the
    // first row of the first column, and the number of entries from one column to the next.
    struct Place {
        int begin;  // `none` if one of the blocks is held
        int stride;
    };
    using Places = std::array<Place, 4>;  // block on block, other on block, block on other, other on other
    // Two blocks and the forces between them, as a range of the responses.
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
    PairResponse response_of_bolt(const HeldByBolt& bolt, const std::vector<Motion>& motion) const;
    // Stores the response of two blocks to each other.
    const PairResponse& keep(std::size_t block, std::size_t other, const PairResponse& response, std::size_t index);
    void add_forces(std::size_t block, std::size_t other, const PairResponse& kept);

    const Bodies& bodies_;
    const std::vector<Eigen::Vector3d>& loads_;
    const Bonds& bonds_;
    const std::vector<BondMemory>& bond_memory_;
    std::span<const HeldByBolt> bolts_;
    std::vector<std::size_t> free_blocks_ = {};
    std::vector<int> unknown_;       // first of a block's three unknowns; `none` where the block is held
    std::vector<char> to_evaluate_;  // of all blocks: whether their contacts may have changed
    std::vector<Pair> pairs_ = {};
    std::vector<PairResponse> response_ = {};                 // of the contacts, two of each bond, of the bolts
    std::vector<std::vector<std::size_t>> contacts_of_ = {};  // of each free block
    std::vector<std::vector<std::size_t>> bolts_of_ = {};     // likewise
    std::vector<std::vector<int>> neighbours_ = {};
    std::vector<int> diagonal_ = {};           // positions of the diagonal entries among the values, for each unknown
    std::optional<SparseSystem> system_ = {};  // empty if no block is free
    bool contacts_resist_ = false;
    Eigen::VectorXd unbalanced_ = {};
    double stiffest_ = 0;
    std::uint64_t contacts_evaluated_ = 0;
};

}  // namespace delabole
