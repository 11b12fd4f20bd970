#include "dynamic_relaxation/preload.hpp"

#include "dynamic_relaxation/contact_law.hpp"
#include "dynamic_relaxation/corner_choice.hpp"

#include <Eigen/LU>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace delabole {

namespace {

constexpr Eigen::Index none = -1;

// What a contact does in a given state, and how that changes with the motion of its two blocks.
struct Response {
    Eigen::Matrix<double, 6, 1> force = Eigen::Matrix<double, 6, 1>::Zero();
    Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
};

using Direction = Eigen::Matrix<double, 6, 1>;

template <class Position>
Direction direction(double x, double y, const Position& at) {
    Direction row;
    row << x, y, at.arm_x * y - at.arm_y * x, -x, -y, -(at.other_arm_x * y - at.other_arm_y * x);
    return row;
}

// The law of contact_law.hpp without velocities. A contact that has opened by a hair still counts in the tangent:
// without it, blocks that touch without pressure would have nothing to stand on.
Response respond(const ContactLaw& law, const RelaxationContact& contact, const ContactPosition& at,
                 ContactMemory& memory, double hair) {
    Response response;
    const double overlap = -at.gap;
    const bool bonded = law.tension > 0 && !memory.broken && memory.touching;
    memory.shear += at.slide - memory.place;
    memory.place = at.slide;
    memory.touching = (overlap > 0 && !memory.beneath && !memory.yields) || bonded;
    memory.sliding = false;
    if (memory.beneath || memory.yields || (overlap < -hair && !bonded)) {
        memory.shear = 0;
        return response;
    }
    const double weight = contact_weight(law, contact, at, memory.insists);
    const Direction normal = direction(at.normal_x, at.normal_y, at);
    const Direction along = direction(at.along_x(), at.along_y(), at);
    const double pressing = law.normal_stiffness * std::max(overlap, 0.0);
    const double friction = memory.broken ? law.residual_friction : law.friction;
    const double strength = pressing * friction + (memory.broken ? law.residual_cohesion : law.cohesion);
    response.stiffness = weight * law.normal_stiffness * normal * normal.transpose();
    const double trial = -law.shear_stiffness * memory.shear;
    const double shear = std::clamp(trial, -strength, strength);
    memory.sliding = std::abs(trial) > strength;
    memory.shear = -shear / law.shear_stiffness;
    if (memory.sliding) {
        response.stiffness +=
            weight * law.normal_stiffness * std::copysign(friction, trial) * along * normal.transpose();
    } else {
        response.stiffness += weight * law.shear_stiffness * along * along.transpose();
    }
    response.force = weight * ((bonded ? law.normal_stiffness * overlap : pressing) * normal + shear * along);
    return response;
}

Response respond(const Bond& bond, const FacePosition& at) {
    const Direction normal = direction(at.normal_x, at.normal_y, at);
    const Direction along = direction(at.along_x(), at.along_y(), at);
    Direction bending;
    bending << 0, 0, 1, 0, 0, -1;
    Response response;
    response.force = -bond.normal_stiffness * at.opening * normal - bond.shear_stiffness * at.slide * along -
                     bond.bending_stiffness * at.turn * bending;
    response.stiffness = bond.normal_stiffness * normal * normal.transpose() +
                         bond.shear_stiffness * along * along.transpose() +
                         bond.bending_stiffness * bending * bending.transpose();
    return response;
}

// Rotations and moments are counted at the block's radius: all unknowns are lengths, so that scenes of every size lead
// to the same equations.
class Preload {
  public:
    Preload(const Bodies& bodies, const std::vector<char>& held, const std::vector<Eigen::Vector3d>& loads,
            const PreloadSettings& settings, const Bonds& bonds, const std::vector<BondMemory>& bond_memory)
        : bodies_(bodies),
          loads_(loads),
          settings_(settings),
          bonds_(bonds),
          bond_memory_(bond_memory),
          unknown_(bodies.size(), none) {
        for (std::size_t block = 0; block < bodies.size(); ++block) {
            if (held[block] == 0) {
                unknown_[block] = 3 * static_cast<Eigen::Index>(free_blocks_.size());
                free_blocks_.push_back(block);
            }
        }
    }

    Preloaded solve(std::vector<Motion>& motion, ContactList& list) {
        if (free_blocks_.empty()) {
            return {0, false, motion, 0};
        }
        forget_tried(list.memory);
        const MemoryArray memory = list.memory;
        std::vector<Motion> start = motion;
        Preloaded found = approach(start, motion, list);
        constexpr std::size_t few_blocks = 400;  // many settle in the run for less
        if (found.ratio > settings_.tolerance && !creeps() && !bonds_.empty() && free_blocks_.size() < few_blocks) {
            approach_in_steps(start, memory, found, motion, list);
        }
        // Peak strength goes one joint after the other, wherever it is reached.
        while (found.ratio <= settings_.tolerance && break_spent(motion, list)) {
            start = motion;
            found = approach(start, motion, list);
        }
        while (found.ratio <= settings_.tolerance && try_corners(found, motion, list)) {
        }
        found.contacts_evaluated = contacts_evaluated_;
        return found;
    }

  private:
    // Slender bonded columns lean far on each other before the full load is in balance, and rounds go astray on the
    // way. Under a load that grows they follow. (Without bonds it would not help: what friction cannot hold, it cannot
    // hold in part either.) Where this fails, too, all is left as it was.
    void approach_in_steps(const std::vector<Motion>& start, const MemoryArray& memory, Preloaded& found,
                           std::vector<Motion>& motion, ContactList& list) {
        constexpr int steps = 8;
        constexpr double astray = 0.3;  // of a load: not to be made good by the steps after it
        std::vector<Motion> stepped = start;
        MemoryArray memory_found = std::exchange(list.memory, memory);
        Preloaded last{0, false, start, 0};
        for (int step = 1; step <= steps && last.ratio <= astray; ++step) {
            load_share_ = static_cast<double>(step) / steps;
            last = approach(start, stepped, list);
        }
        load_share_ = 1;
        if (last.ratio > settings_.tolerance) {
            list.memory = std::move(memory_found);
            return;
        }
        found = std::move(last);
        motion = std::move(stepped);
    }

    // What corners on corners hold has to be held either way (corner_choice.hpp). Returns whether there was anything to
    // try.
    bool try_corners(Preloaded& found, std::vector<Motion>& motion, ContactList& list) {
        MemoryArray memory_before = list.memory;
        if (try_other_edges({bodies_, motion}, weights(), list).empty()) {
            return false;
        }
        const std::vector<Motion> before = motion;
        Preloaded other = approach(before, motion, list);
        if (other.ratio > settings_.tolerance) {
            found = std::move(other);
            return true;
        }
        note_tried(list.memory, memory_before);
        motion = before;
        list.memory = std::move(memory_before);
        return true;
    }

    // Contacts with a peak that carry all they can slip, and have their residual strength from then on.
    bool break_spent(const std::vector<Motion>& motion, ContactList& list) const {
        constexpr double nearly = 1 - 1e-9;
        bool any = false;
        for (std::size_t index = 0; index < list.contact.size(); ++index) {
            const RelaxationContact contact = list.contact[index];
            const ContactLaw law = list.law_of(contact);
            ContactMemory memory = list.memory[index];
            if (!memory.touching || memory.broken ||
                (law.cohesion == law.residual_cohesion && law.friction == law.residual_friction)) {
                continue;
            }
            const double overlap = -locate(contact, motion[contact.block], motion[contact.other]).gap;
            const double strength = law.normal_stiffness * std::max(overlap, 0.0) * law.friction + law.cohesion;
            memory.broken = law.shear_stiffness * std::abs(memory.shear) >= nearly * strength;
            list.memory.set(index, memory);
            any |= memory.broken;
        }
        return any;
    }

    // `start`: where the limits of motion are measured from.
    Preloaded approach(const std::vector<Motion>& start, std::vector<Motion>& motion, ContactList& list) {
        // As stiff as the joints at first, so that no contact is left behind by a leap; then thinner as long as balance
        // does not get much worse. Blocks may lose balance for a while before they jam. Leaps to where it is far worse,
        // or over half of the way that is allowed, are not made: friction would keep what they leave behind, and could
        // hold blocks that nothing holds.
        constexpr double thinner = 1.6;
        constexpr double thicker = 4;
        constexpr double much_worse = 1.5;
        constexpr double far_worse = 4;
        constexpr double half_way = 0.5;
        stiffest_ = stiffest_joint(list);
        double resistance = 1;
        double ratio = assemble(motion, list);
        Preloaded best{ratio, false, motion, 0};
        MemoryArray best_memory = list.memory;
        bool improves = true;
        for (int round = 0;; ++round) {
            if (best.ratio <= settings_.finest || (best.ratio <= settings_.tolerance && !improves)) {
                break;
            }
            if (round == most_rounds()) {
                best.cut_short = best.ratio > settings_.tolerance && most_rounds() < rounds_of_few();
                break;
            }
            const Eigen::VectorXd change = solve_linear(resistance);
            if (!change.allFinite()) {
                break;
            }
            const std::vector<Motion> motion_before = motion;
            const MemoryArray memory_before = list.memory;
            const double ratio_before = ratio;
            const double come = share_of_limits(start, best.most_balanced, motion);
            move(change, motion);
            const double gone = share_of_limits(start, best.most_balanced, motion);
            if (gone >= 1 && come > half_way) {
                if (!creeps() || best.ratio <= settings_.tolerance) {
                    break;
                }
                constexpr double just_within = 0.99;  // so that the run has only to show that they move on
                move(-std::min(1.0, (gone - just_within) / (gone - come)) * change, motion);
                assemble(motion, list);
                settle(resistance, motion, list);
                return best;
            }
            ratio = gone < 1 ? assemble(motion, list) : std::numeric_limits<double>::infinity();
            if (creeps() && gone < 1 && ratio > settings_.tolerance) {
                ratio = settle(resistance, motion, list);
            }
            if (!(ratio < far_worse * ratio_before)) {
                motion = motion_before;
                list.memory = memory_before;
                ratio = assemble(motion, list);
                resistance *= thicker;
                continue;
            }
            improves = ratio < ratio_before / 2;
            if (ratio < best.ratio) {
                best.ratio = ratio;
                best.most_balanced = motion;
                best_memory = list.memory;
            }
            resistance =
                std::max(ratio < much_worse * ratio_before ? resistance / thinner : resistance * thicker, 1e-13);
        }
        motion = best.most_balanced;
        list.memory = best_memory;
        return best;
    }

    std::vector<double> weights() const {
        std::vector<double> weight(bodies_.size(), std::numeric_limits<double>::infinity());
        for (const std::size_t block : free_blocks_) {
            weight[block] = loads_[block].head<2>().norm();
        }
        return weight;
    }

    int most_rounds() const {
        return std::max(8, std::min(rounds_of_few(), 40000 / static_cast<int>(1 + free_blocks_.size())));
    }
    int rounds_of_few() const { return creeps() ? 2000 : 300; }

    double stiffest_joint(const ContactList& list) const {
        double stiffest = 0;
        for (const JointLaw& law : list.joint) {
            stiffest = std::max(stiffest, law.normal_stiffness);
        }
        for (const Bond& bond : bonds_.list()) {
            stiffest = std::max(stiffest, bond.normal_stiffness);
        }
        return stiffest;
    }

    // A round too thick for blocks to creep: stiff joints only recover from the last one, which took a straight way.
    double settle(double resistance, std::vector<Motion>& motion, ContactList& list) {
        constexpr double thick = 1e-3;
        move(solve_linear(std::max(resistance, thick)), motion);
        return assemble(motion, list);
    }

    // Forces and tangents; the greatest unbalanced force over its block's load.
    double assemble(const std::vector<Motion>& motion, ContactList& list) {
        constexpr double hair = 1e-9;  // of the shortest edge
        const Eigen::Index count = 3 * static_cast<Eigen::Index>(free_blocks_.size());
        unbalanced_ = Eigen::VectorXd::Zero(count);
        for (std::size_t index = 0; index < free_blocks_.size(); ++index) {
            const std::size_t block = free_blocks_[index];
            unbalanced_.segment<3>(3 * static_cast<Eigen::Index>(index)) =
                load_share_ * loads_[block].cwiseProduct(lengths_of(block));
        }
        entries_.clear();
        contacts_evaluated_ += list.contact.size();
        for (std::size_t index = 0; index < list.contact.size(); ++index) {
            const RelaxationContact contact = list.contact[index];
            const double touching =
                hair * std::min(bodies_.shortest_edge[contact.block], bodies_.shortest_edge[contact.other]);
            ContactMemory memory = list.memory[index];
            const Response response =
                respond(list.law_of(contact), contact, locate(contact, motion[contact.block], motion[contact.other]),
                        memory, memory.touching ? 0 : touching);
            list.memory.set(index, memory);
            add(contact.block, contact.other, response);
        }
        for (std::size_t index = 0; index < bonds_.list().size(); ++index) {
            const Bond& bond = bonds_.list()[index];
            if (bond_memory_[index].state == BondState::whole) {
                add(bond.face.block, bond.face.other,
                    respond(bond, locate(bond.face, motion[bond.face.block], motion[bond.face.other])));
            }
        }
        double ratio = 0;
        for (std::size_t index = 0; index < free_blocks_.size(); ++index) {
            const std::size_t block = free_blocks_[index];
            const Eigen::Vector3d net = unbalanced_.segment<3>(3 * static_cast<Eigen::Index>(index));
            const double load = std::max(loads_[block].head<2>().norm(), std::numeric_limits<double>::min());
            ratio = std::max(ratio, (net.head<2>().norm() + std::abs(net(2))) / load);
        }
        return ratio;
    }

    Eigen::Vector3d lengths_of(std::size_t block) const { return {1, 1, 1 / bodies_.radius[block]}; }

    void add(std::size_t block, std::size_t other, const Response& response) {
        const std::array<Eigen::Index, 2> at{unknown_[block], unknown_[other]};
        Direction lengths;
        lengths << lengths_of(block), lengths_of(other);
        const Direction force = response.force.cwiseProduct(lengths);
        const Eigen::Matrix<double, 6, 6> stiffness = lengths.asDiagonal() * response.stiffness * lengths.asDiagonal();
        for (Eigen::Index row = 0; row < 2; ++row) {
            if (at[static_cast<std::size_t>(row)] == none) {
                continue;
            }
            unbalanced_.segment<3>(at[static_cast<std::size_t>(row)]) += force.segment<3>(3 * row);
            for (Eigen::Index column = 0; column < 2; ++column) {
                if (at[static_cast<std::size_t>(column)] == none) {
                    continue;
                }
                for (Eigen::Index i = 0; i < 3; ++i) {
                    for (Eigen::Index j = 0; j < 3; ++j) {
                        entries_.emplace_back(at[static_cast<std::size_t>(row)] + i,
                                              at[static_cast<std::size_t>(column)] + j,
                                              stiffness(3 * row + i, 3 * column + j));
                    }
                }
            }
        }
    }

    // `resistance`: as a share of the stiffest joint.
    Eigen::VectorXd solve_linear(double resistance) {
        for (Eigen::Index unknown = 0; unknown < unbalanced_.size(); ++unknown) {
            entries_.emplace_back(unknown, unknown, resistance * stiffest_);
        }
        Eigen::SparseMatrix<double> matrix(unbalanced_.size(), unbalanced_.size());
        matrix.setFromTriplets(entries_.begin(), entries_.end());
        constexpr Eigen::Index small = 60;
        if (unbalanced_.size() <= small) {
            return Eigen::MatrixXd(matrix).partialPivLu().solve(unbalanced_);
        }
        const Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
        if (solver.info() != Eigen::Success) {
            return Eigen::VectorXd::Constant(unbalanced_.size(), std::numeric_limits<double>::infinity());
        }
        return solver.solve(unbalanced_);
    }

    void move(const Eigen::VectorXd& change, std::vector<Motion>& motion) const {
        for (std::size_t index = 0; index < free_blocks_.size(); ++index) {
            const std::size_t block = free_blocks_[index];
            Motion& moved = motion[block];
            const Eigen::Index at = 3 * static_cast<Eigen::Index>(index);
            // About the centre of the turn, exact to second order: what rolls over its toe stays on it.
            const double turn = change(at + 2) / bodies_.radius[block];
            moved.x += change(at) - turn / 2 * change(at + 1);
            moved.y += change(at + 1) + turn / 2 * change(at);
            moved.set_angle(moved.angle + turn);
        }
    }

    bool creeps() const { return settings_.creep_rotation > 0; }

    // Up to 1 a motion is within the limits.
    double share_of_limits(const std::vector<Motion>& start, const std::vector<Motion>& most_balanced,
                           const std::vector<Motion>& motion) const {
        double share = 0;
        for (const std::size_t block : free_blocks_) {
            const double radius = bodies_.radius[block];
            const Motion& now = motion[block];
            const Motion& then = start[block];
            const double way = std::hypot(now.x - then.x, now.y - then.y) + std::abs(now.angle - then.angle) * radius;
            share = std::max(share, way / settings_.farthest);
            if (creeps()) {
                const Motion& best = most_balanced[block];
                share = std::max({share, std::abs(now.angle - best.angle) / settings_.creep_rotation,
                                  std::hypot(now.x - best.x, now.y - best.y) / (settings_.creep_slide * radius)});
            }
        }
        return share;
    }

    const Bodies& bodies_;
    const std::vector<Eigen::Vector3d>& loads_;
    const PreloadSettings& settings_;
    const Bonds& bonds_;
    const std::vector<BondMemory>& bond_memory_;
    std::vector<std::size_t> free_blocks_ = {};
    double load_share_ = 1;
    std::vector<Eigen::Index> unknown_;  // first of a block's three; none where it is held
    std::vector<Eigen::Triplet<double>> entries_ = {};
    Eigen::VectorXd unbalanced_ = {};
    double stiffest_ = 0;
    std::uint64_t contacts_evaluated_ = 0;
};

}  // namespace

Preloaded preload(const Bodies& bodies, const std::vector<char>& held, const std::vector<Eigen::Vector3d>& loads,
                  const PreloadSettings& settings, const Bonds& bonds, const std::vector<BondMemory>& bond_memory,
                  std::vector<Motion>& motion, ContactList& list) {
    return Preload(bodies, held, loads, settings, bonds, bond_memory).solve(motion, list);
}

}  // namespace delabole
