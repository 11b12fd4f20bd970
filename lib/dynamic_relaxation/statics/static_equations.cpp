#include "dynamic_relaxation/statics/static_equations.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/contact_transition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

using Direction = Eigen::Matrix<double, 6, 1>;

// The force of a contact in a given state, and how it changes with the motion of its two blocks.
struct Response {
    Eigen::Matrix<double, 6, 1> force = Eigen::Matrix<double, 6, 1>::Zero();
    Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 6> damping = Eigen::Matrix<double, 6, 6>::Zero();
};

// Displacement along (x, y) of a point of a block against one of another, by displacements of both and turns times
// radius.
struct Arms {
    double radius;
    double other_radius;

    template <class Position>
    Direction along(double x, double y, const Position& at) const {
        Direction row;
        row << x, y, (at.arm_x * y - at.arm_y * x) / radius, -x, -y,
            -(at.other_arm_x * y - at.other_arm_y * x) / other_radius;
        return row;
    }
    Direction turn() const {
        Direction row;
        row << 0, 0, 1 / radius, 0, 0, -1 / other_radius;
        return row;
    }
};

// The law of contact_law.hpp without velocities. A contact that has opened by a hair still counts in the tangent:
// without it, blocks that touch without pressure would have nothing to stand on. Where contacts resist with
// pseudo-viscosity, open ones do so as well.
std::optional<Response> respond(const ContactLaw& law, const RelaxationContact& contact, const ContactPosition& at,
                                const Arms& arms, ContactMemory& memory, double hair, bool resists) {
    const double overlap = -at.gap;
    const bool bonded = law.tension > 0 && !memory.broken && memory.touching;
    const double weight = contact_weight(law, contact, at, memory.insists);
    memory.shear += at.slide - memory.place;
    memory.place = at.slide;
    memory.insists = memory.insists && (weight > 0 || !memory.touching);
    const bool idle = !memory.touching && (memory.beneath || memory.yields);
    const bool apart = overlap <= 0;
    const unsigned over = over_edge({.touching = memory.touching,
                                     .beneath = memory.beneath,
                                     .yields = memory.yields,
                                     .apart = apart,
                                     .handed_over = 0,
                                     .taken_over = 0});
    // One without weight goes on touching: it only has no force.
    memory.touching = holds_of_one(bearing_of(over, apart, bonded, 0));
    memory.sliding = false;
    const bool open = overlap < -hair && !bonded;
    if (idle || open) {
        memory.shear = 0;
        if (idle || !resists) {
            return std::nullopt;
        }
    }
    Response response;
    const Direction normal = arms.along(at.normal_x, at.normal_y, at);
    const Direction along = arms.along(at.along_x(), at.along_y(), at);
    if (resists) {
        response.damping = weight * (law.normal_stiffness * normal * normal.transpose() +
                                     law.shear_stiffness * along * along.transpose());
        if (open) {
            return response;
        }
    }
    const double pressing = law.normal_stiffness * std::max(overlap, 0.0);
    const double strength = shear_strength(law, pressing, memory.broken);
    response.stiffness = weight * law.normal_stiffness * normal * normal.transpose();
    const double trial = -law.shear_stiffness * memory.shear;
    const double shear = std::clamp(trial, -strength, strength);
    memory.sliding = slips(trial, strength);
    memory.slip += (shear - trial) / law.shear_stiffness;
    memory.shear = -shear / law.shear_stiffness;
    if (memory.sliding) {
        const double friction = memory.broken ? law.residual_friction : law.friction;
        response.stiffness +=
            weight * law.normal_stiffness * std::copysign(friction, trial) * along * normal.transpose();
    } else {
        response.stiffness += weight * law.shear_stiffness * along * along.transpose();
    }
    response.force = weight * ((bonded ? law.normal_stiffness * overlap : pressing) * normal + shear * along);
    return response;
}

Response respond(const Bond& bond, const FacePosition& at, const Arms& arms) {
    const Direction normal = arms.along(at.normal_x, at.normal_y, at);
    const Direction along = arms.along(at.along_x(), at.along_y(), at);
    const Direction bending = arms.turn();
    Response response;
    response.force = -bond.normal_stiffness * at.opening * normal - bond.shear_stiffness * at.slide * along -
                     bond.bending_stiffness * at.turn * bending;
    response.stiffness = bond.normal_stiffness * normal * normal.transpose() +
                         bond.shear_stiffness * along * along.transpose() +
                         bond.bending_stiffness * bending * bending.transpose();
    response.damping = response.stiffness;
    return response;
}

double stiffest_spring(const ContactList& list, const Bonds& bonds) {
    double stiffest = 0;
    for (const JointLaw& law : list.joint) {
        stiffest = std::max(stiffest, law.normal_stiffness);
    }
    for (const Bond& bond : bonds.list()) {
        stiffest = std::max(stiffest, bond.normal_stiffness);
    }
    return stiffest;
}

}  // namespace

StaticEquations::StaticEquations(const Bodies& bodies, const std::vector<char>& held,
                                 const std::vector<Eigen::Vector3d>& loads, const Bonds& bonds,
                                 const std::vector<BondMemory>& bond_memory, const ContactList& list)
    : bodies_(bodies),
      loads_(loads),
      bonds_(bonds),
      bond_memory_(bond_memory),
      unknown_(bodies.size(), none),
      stiffest_(stiffest_spring(list, bonds)) {
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (held[block] == 0) {
            unknown_[block] = 3 * static_cast<int>(free_blocks_.size());
            free_blocks_.push_back(block);
        }
    }
    if (free_blocks_.empty()) {
        return;
    }
    SparsePattern pattern = pattern_of(list);
    for (const ContactBlocks& contact : list.contact.blocks()) {
        places_of_contact_.push_back(places_of(pattern, contact.block, contact.other));
    }
    for (const Bond& bond : bonds.list()) {
        places_of_bond_.push_back(places_of(pattern, bond.face.block, bond.face.other));
    }
    for (int column = 0; column < pattern.size(); ++column) {
        const auto begin = pattern.row.begin() + pattern.column_begin[static_cast<std::size_t>(column)];
        const auto end = pattern.row.begin() + pattern.column_begin[static_cast<std::size_t>(column) + 1];
        diagonal_.push_back(static_cast<int>(std::lower_bound(begin, end, column) - pattern.row.begin()));
    }
    tangent_.resize(pattern.row.size());
    system_.emplace(std::move(pattern), 3);
}

// Three rows and three columns for each pair of free blocks that act on each other, and for each free block.
SparsePattern StaticEquations::pattern_of(const ContactList& list) const {
    std::vector<std::vector<int>> acting(free_blocks_.size());  // first unknowns of those that act on each
    for (std::size_t index = 0; index < free_blocks_.size(); ++index) {
        acting[index].push_back(3 * static_cast<int>(index));
    }
    const auto join = [&](std::size_t block, std::size_t other) {
        if (unknown_[block] != none && unknown_[other] != none) {
            acting[static_cast<std::size_t>(unknown_[block] / 3)].push_back(unknown_[other]);
            acting[static_cast<std::size_t>(unknown_[other] / 3)].push_back(unknown_[block]);
        }
    };
    for (const ContactBlocks& contact : list.contact.blocks()) {
        join(contact.block, contact.other);
    }
    for (const Bond& bond : bonds_.list()) {
        join(bond.face.block, bond.face.other);
    }
    SparsePattern pattern;
    for (std::vector<int>& blocks : acting) {
        std::ranges::sort(blocks);
        blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
        for (int column = 0; column < 3; ++column) {
            for (const int unknown : blocks) {
                pattern.row.insert(pattern.row.end(), {unknown, unknown + 1, unknown + 2});
            }
            pattern.column_begin.push_back(static_cast<int>(pattern.row.size()));
        }
    }
    return pattern;
}

StaticEquations::Places StaticEquations::places_of(const SparsePattern& pattern, std::size_t block,
                                                   std::size_t other) const {
    const auto place = [&](int row, int column) -> Place {
        if (row == none || column == none) {
            return {none, 0};
        }
        const int first = pattern.column_begin[static_cast<std::size_t>(column)];
        const int end = pattern.column_begin[static_cast<std::size_t>(column) + 1];
        const auto found = std::lower_bound(pattern.row.begin() + first, pattern.row.begin() + end, row);
        return {static_cast<int>(found - pattern.row.begin()), end - first};
    };
    const int here = unknown_[block];
    const int there = unknown_[other];
    return {place(here, here), place(here, there), place(there, here), place(there, there)};
}

void StaticEquations::evaluate(const std::vector<Motion>& motion, const MemoryArray& before, ContactList& list) {
    constexpr double hair = 1e-9;  // of the shortest edge
    unbalanced_.resize(3 * static_cast<Eigen::Index>(free_blocks_.size()));
    for (std::size_t index = 0; index < free_blocks_.size(); ++index) {
        const std::size_t block = free_blocks_[index];
        const Eigen::Vector3d lengths(1, 1, 1 / bodies_.radius[block]);
        unbalanced_.segment<3>(3 * static_cast<Eigen::Index>(index)) =
            load_share_ * loads_[block].cwiseProduct(lengths);
    }
    std::ranges::fill(tangent_, 0.0);
    std::ranges::fill(damping_, 0.0);
    contacts_evaluated_ += list.contact.size();
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const RelaxationContact contact = list.contact[index];
        const double touching =
            hair * std::min(bodies_.shortest_edge[contact.block], bodies_.shortest_edge[contact.other]);
        ContactMemory memory = before[index];
        const ContactPosition at = locate(contact, motion[contact.block], motion[contact.other]);
        if (memory.beneath && contact.twin != no_twin && before[contact.twin].touching) {
            const ContactPosition of_twin =
                locate(list.contact[contact.twin], motion[contact.other], motion[contact.block]);
            if (twin_hands_over(-at.gap, -of_twin.gap)) {
                memory.beneath = false;
                memory.shear = before[contact.twin].shear;
                memory.place = at.slide;
            }
        }
        const std::optional<Response> response =
            respond(list.law_of(contact), contact, at, {bodies_.radius[contact.block], bodies_.radius[contact.other]},
                    memory, memory.touching ? 0 : touching, !damping_.empty());
        list.memory.set(index, memory);
        if (response) {
            add(contact.block, contact.other, places_of_contact_[index], response->force, response->stiffness,
                response->damping);
        }
    }
    for (std::size_t index = 0; index < bonds_.list().size(); ++index) {
        const SharedFace& face = bonds_.list()[index].face;
        if (bond_memory_[index].state == BondState::whole) {
            const Response response =
                respond(bonds_.list()[index], locate(face, motion[face.block], motion[face.other]),
                        {bodies_.radius[face.block], bodies_.radius[face.other]});
            add(face.block, face.other, places_of_bond_[index], response.force, response.stiffness, response.damping);
        }
    }
}

double StaticEquations::load_of(std::size_t index) const {
    return std::max(loads_[free_blocks_[index]].head<2>().norm(), std::numeric_limits<double>::min());
}

std::vector<double> StaticEquations::weights() const {
    std::vector<double> weight(bodies_.size(), std::numeric_limits<double>::infinity());
    for (const std::size_t block : free_blocks_) {
        weight[block] = loads_[block].head<2>().norm();
    }
    return weight;
}

double StaticEquations::unbalanced_ratio() const {
    double ratio = 0;
    for (std::size_t index = 0; index < free_blocks_.size(); ++index) {
        const Eigen::Vector3d net = unbalanced_.segment<3>(3 * static_cast<Eigen::Index>(index));
        ratio = std::max(ratio, (net.head<2>().norm() + std::abs(net(2))) / load_of(index));
    }
    return ratio;
}

double StaticEquations::mean_ratio(const Eigen::VectorXd& forces) const {
    double sum = 0;
    for (std::size_t index = 0; index < free_blocks_.size(); ++index) {
        sum += (forces.segment<3>(3 * static_cast<Eigen::Index>(index)) / load_of(index)).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(free_blocks_.size()));
}

void StaticEquations::add(std::size_t block, std::size_t other, const Places& places, const Vector6& force,
                          const Matrix6& stiffness, const Matrix6& damping) {
    if (unknown_[block] != none) {
        unbalanced_.segment<3>(unknown_[block]) += force.head<3>();
    }
    if (unknown_[other] != none) {
        unbalanced_.segment<3>(unknown_[other]) += force.tail<3>();
    }
    for (Eigen::Index part = 0; part < 4; ++part) {
        const Place& place = places[static_cast<std::size_t>(part)];
        if (place.begin == none) {
            continue;
        }
        for (Eigen::Index column = 0; column < 3; ++column) {
            const auto at = static_cast<std::size_t>(place.begin) +
                            static_cast<std::size_t>(column) * static_cast<std::size_t>(place.stride);
            for (Eigen::Index row = 0; row < 3; ++row) {
                const std::size_t entry = at + static_cast<std::size_t>(row);
                tangent_[entry] += stiffness(3 * (part / 2) + row, 3 * (part % 2) + column);
                if (!damping_.empty()) {
                    damping_[entry] += damping(3 * (part / 2) + row, 3 * (part % 2) + column);
                }
            }
        }
    }
}

std::optional<Eigen::VectorXd> StaticEquations::change(const PseudoViscosity& resisting,
                                                       const Eigen::VectorXd& forces) {
    const std::span<double> value = system_->values();
    std::ranges::copy(tangent_, value.begin());
    for (std::size_t entry = 0; entry < damping_.size(); ++entry) {
        value[entry] += resisting.of_contacts * damping_[entry];
    }
    for (const int place : diagonal_) {
        value[static_cast<std::size_t>(place)] += resisting.of_blocks * stiffest_;
    }
    Eigen::VectorXd change = forces;
    if (!system_->solve(change)) {
        return std::nullopt;
    }
    return change;
}

Eigen::VectorXd StaticEquations::resistance(const PseudoViscosity& resisting, const Eigen::VectorXd& moved) const {
    const SparsePattern& pattern = system_->pattern();
    Eigen::VectorXd held = resisting.of_blocks * stiffest_ * moved;
    if (damping_.empty()) {
        return held;
    }
    for (int column = 0; column < pattern.size(); ++column) {
        const double by = resisting.of_contacts * moved(column);
        const int end = pattern.column_begin[static_cast<std::size_t>(column) + 1];
        for (int entry = pattern.column_begin[static_cast<std::size_t>(column)]; entry < end; ++entry) {
            held(pattern.row[static_cast<std::size_t>(entry)]) += by * damping_[static_cast<std::size_t>(entry)];
        }
    }
    return held;
}

void StaticEquations::move(const Eigen::VectorXd& change, std::vector<Motion>& motion) const {
    for (std::size_t index = 0; index < free_blocks_.size(); ++index) {
        const std::size_t block = free_blocks_[index];
        Motion& moved = motion[block];
        const Eigen::Index at = 3 * static_cast<Eigen::Index>(index);
        const double turn = change(at + 2) / bodies_.radius[block];
        moved.x += change(at) - turn / 2 * change(at + 1);
        moved.y += change(at + 1) + turn / 2 * change(at);
        moved.set_angle(moved.angle + turn);
    }
}

}  // namespace delabole
