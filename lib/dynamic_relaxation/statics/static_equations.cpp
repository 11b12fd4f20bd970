#include "dynamic_relaxation/statics/static_equations.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/contact_transition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace delabole {

namespace {

// The law of contact_law.hpp without velocities. A contact that is open by less than a `hair` still counts in the
// tangent: without it, nothing would support blocks that touch without pressure. Where contacts resist with
// pseudo-viscosity (`resists`), open ones resist as well.
PairResponse respond(const ContactLaw& law, const RelaxationContact& contact, const ContactPosition& at,
                     const Arms& arms, ContactMemory& memory, double hair, bool resists) {
    const double overlap = -at.gap;
    const bool idle = !memory.touching && (memory.beneath || memory.yields);
    const bool open = overlap < -hair;
    // Computed only where something depends on it, because it takes much of the time.
    const double weight =
        memory.insists || !(idle || (open && !resists)) ? contact_weight(law, contact, at, memory.insists) : 0;
    memory.shear += at.slide - memory.place;
    memory.place = at.slide;
    memory.insists = memory.insists && (weight > 0 || !memory.touching);
    const bool apart = overlap <= 0;
    const unsigned over = over_edge({.touching = memory.touching,
                                     .beneath = memory.beneath,
                                     .yields = memory.yields,
                                     .apart = apart,
                                     .handed_over = 0,
                                     .taken_over = 0});
    // A contact of zero weight stays in touch; it carries no force.
    memory.touching = holds_of_one(bearing_of(over, apart, 0));
    memory.sliding = false;
    PairResponse response;
    if (weight != 0 && !idle) {
        response.normal = arms.along(at.normal_x, at.normal_y, at);
        response.along = arms.along(at.along_x(), at.along_y(), at);
        if (resists) {
            response.normal_damping = weight * law.normal_stiffness;
            response.shear_damping = weight * law.shear_stiffness;
        }
    }
    if (idle || open) {
        memory.shear = 0;
        return response;
    }
    const double pressing = law.normal_stiffness * std::max(overlap, 0.0);
    const double strength = shear_strength(law, pressing, memory.broken);
    const double trial = -law.shear_stiffness * memory.shear;
    const double shear = std::clamp(trial, -strength, strength);
    memory.sliding = slips(trial, strength);
    memory.slip += (shear - trial) / law.shear_stiffness;
    memory.shear = -shear / law.shear_stiffness;
    response.normal_stiffness = weight * law.normal_stiffness;
    if (memory.sliding) {
        const double friction = memory.broken ? law.residual_friction : law.friction;
        response.coupling = weight * law.normal_stiffness * std::copysign(friction, trial);
    } else {
        response.shear_stiffness = weight * law.shear_stiffness;
    }
    response.normal_force = weight * pressing;
    response.shear_force = weight * shear;
    return response;
}

double stiffest_spring(const ContactList& list, const Bonds& bonds, std::span<const HeldByBolt> bolts) {
    double stiffest = 0;
    for (const JointLaw& law : list.joint) {
        stiffest = std::max(stiffest, law.normal_stiffness);
    }
    for (const Bond& bond : bonds.list()) {
        stiffest = std::max(stiffest, bond.normal_stiffness);
    }
    for (const HeldByBolt& bolt : bolts) {
        stiffest = std::max(stiffest, bolt.segment.stiffness);
    }
    return stiffest;
}

// Six rows of six columns: changes of the forces with the displacements of both blocks of a pair, including
// pseudo-viscosity.
std::array<double, 36> tangent_of(std::span<const PairResponse> responses, double resisting) {
    std::array<double, 36> tangent{};
    for (const PairResponse& response : responses) {
        if (!response.acts()) {
            continue;
        }
        const std::array<double, 6> normal = response.normal.of_both();
        const std::array<double, 6> along = response.along.of_both();
        const double normal_stiffness = response.normal_stiffness + resisting * response.normal_damping;
        const double shear_stiffness = response.shear_stiffness + resisting * response.shear_damping;
        for (std::size_t column = 0; column < 6; ++column) {
            const double pressed = normal_stiffness * normal[column];
            const double sheared = response.coupling * normal[column] + shear_stiffness * along[column];
            for (std::size_t row = 0; row < 6; ++row) {
                tangent[6 * column + row] += pressed * normal[row] + sheared * along[row];
            }
        }
    }
    return tangent;
}

// Resisting forces of a unit pseudo-viscosity for displacements of both blocks.
std::array<double, 6> damping_against(const std::array<double, 6>& moved, std::span<const PairResponse> responses) {
    std::array<double, 6> force{};
    for (const PairResponse& response : responses) {
        if (!response.acts()) {
            continue;
        }
        const auto resist = [&](const PairDirection& direction, double damping) {
            const double by = damping * (direction.x * (moved[0] - moved[3]) + direction.y * (moved[1] - moved[4]) +
                                         direction.lever * moved[2] + direction.other_lever * moved[5]);
            const std::array<double, 6> along = direction.of_both();
            for (std::size_t row = 0; row < 6; ++row) {
                force[row] += by * along[row];
            }
        };
        resist(response.normal, response.normal_damping);
        resist(response.along, response.shear_damping);
    }
    return force;
}

}  // namespace

StaticEquations::StaticEquations(const Bodies& bodies, const std::vector<char>& held,
                                 const std::vector<Eigen::Vector3d>& loads, const Bonds& bonds,
                                 const std::vector<BondMemory>& bond_memory, std::span<const HeldByBolt> bolts,
                                 const ContactList& list)
    : bodies_(bodies),
      loads_(loads),
      bonds_(bonds),
      bond_memory_(bond_memory),
      bolts_(bolts),
      unknown_(bodies.size(), none),
      to_evaluate_(bodies.size(), 0),
      stiffest_(stiffest_spring(list, bonds, bolts)) {
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (held[block] == 0) {
            unknown_[block] = 3 * static_cast<int>(free_blocks_.size());
            free_blocks_.push_back(block);
        }
    }
    if (free_blocks_.empty()) {
        return;
    }
    list_what_acts(list);
    SparsePattern pattern = pattern_of();
    const auto add = [&](std::size_t block, std::size_t other, std::size_t responses) {
        const std::size_t begin = pairs_.empty() ? 0 : pairs_.back().end;
        const std::size_t first = std::min(block, other);
        const std::size_t second = std::max(block, other);
        if (pairs_.empty() || pairs_.back().first != first || pairs_.back().second != second) {
            pairs_.push_back({first, second, begin, begin, places_of(pattern, first, second)});
        }
        pairs_.back().end += responses;
    };
    for (const ContactBlocks& contact : list.contact.blocks()) {
        add(contact.block, contact.other, 1);
    }
    for (const Bond& bond : bonds.list()) {
        add(bond.face.block, bond.face.other, 2);
    }
    for (const HeldByBolt& bolt : bolts) {
        add(bolt.segment.block, bolt.segment.other, 1);
    }
    response_.resize(pairs_.empty() ? 0 : pairs_.back().end);
    for (int column = 0; column < pattern.size(); ++column) {
        const auto begin = pattern.row.begin() + pattern.column_begin[static_cast<std::size_t>(column)];
        const auto end = pattern.row.begin() + pattern.column_begin[static_cast<std::size_t>(column) + 1];
        diagonal_.push_back(static_cast<int>(std::lower_bound(begin, end, column) - pattern.row.begin()));
    }
    system_.emplace(std::move(pattern), 3);
}

void StaticEquations::list_what_acts(const ContactList& list) {
    contacts_of_.resize(free_blocks_.size());
    bolts_of_.resize(free_blocks_.size());
    neighbours_.resize(free_blocks_.size());
    const auto join = [&](std::size_t block, std::size_t other) {
        if (unknown_[block] != none && unknown_[other] != none) {
            neighbours_[static_cast<std::size_t>(unknown_[block] / 3)].push_back(unknown_[other] / 3);
            neighbours_[static_cast<std::size_t>(unknown_[other] / 3)].push_back(unknown_[block] / 3);
        }
    };
    const auto note = [&](std::vector<std::vector<std::size_t>>& of_block, std::size_t block, std::size_t other,
                          std::size_t index) {
        join(block, other);
        for (const std::size_t one : {block, other}) {
            if (unknown_[one] != none) {
                of_block[static_cast<std::size_t>(unknown_[one] / 3)].push_back(index);
            }
        }
    };
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const ContactBlocks& contact = list.contact.blocks()[index];
        note(contacts_of_, contact.block, contact.other, index);
    }
    for (const Bond& bond : bonds_.list()) {
        join(bond.face.block, bond.face.other);
    }
    for (std::size_t index = 0; index < bolts_.size(); ++index) {
        note(bolts_of_, bolts_[index].segment.block, bolts_[index].segment.other, index);
    }
    for (std::vector<int>& neighbours : neighbours_) {
        std::ranges::sort(neighbours);
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    }
}

// Each free block and each pair of interacting free blocks has three rows and three columns.
SparsePattern StaticEquations::pattern_of() const {
    SparsePattern pattern;
    for (std::size_t index = 0; index < free_blocks_.size(); ++index) {
        std::vector<int> acting = neighbours_[index];
        acting.insert(std::ranges::lower_bound(acting, static_cast<int>(index)), static_cast<int>(index));
        for (int column = 0; column < 3; ++column) {
            for (const int block : acting) {
                pattern.row.insert(pattern.row.end(), {3 * block, 3 * block + 1, 3 * block + 2});
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
    std::ranges::fill(to_evaluate_, 1);
    evaluate_again(motion, before, list);
}

void StaticEquations::evaluate_again(const std::vector<Motion>& motion, const MemoryArray& before, ContactList& list) {
    unbalanced_.resize(3 * static_cast<Eigen::Index>(free_blocks_.size()));
    for (std::size_t index = 0; index < free_blocks_.size(); ++index) {
        unbalanced_.segment<3>(3 * static_cast<Eigen::Index>(index)) = load_on(free_blocks_[index]);
    }
    // All contacts count, also those whose responses are kept: the number limits the work of some trials.
    contacts_evaluated_ += list.contact.size();
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const ContactBlocks& blocks = list.contact.blocks()[index];
        if (to_evaluate_[blocks.block] != 0 || to_evaluate_[blocks.other] != 0) {
            keep(blocks.block, blocks.other, response_of_contact(index, motion, before, list), index);
        }
        if (response_[index].acts()) {
            add_forces(blocks.block, blocks.other, response_[index]);
        }
    }
    for (std::size_t index = 0; index < bonds_.list().size(); ++index) {
        const SharedFace& face = bonds_.list()[index].face;
        if (bond_memory_[index].state == BondState::whole) {
            const std::array<PairResponse, 2> responses =
                respond(bonds_.list()[index], locate(face, motion[face.block], motion[face.other]),
                        {bodies_.radius[face.block], bodies_.radius[face.other]});
            for (std::size_t part = 0; part < responses.size(); ++part) {
                add_forces(face.block, face.other,
                           keep(face.block, face.other, responses[part], list.contact.size() + 2 * index + part));
            }
        }
    }
    for (std::size_t index = 0; index < bolts_.size(); ++index) {
        const BoltSegment& segment = bolts_[index].segment;
        add_forces(segment.block, segment.other,
                   keep(segment.block, segment.other, response_of_bolt(bolts_[index], motion),
                        list.contact.size() + 2 * bonds_.list().size() + index));
    }
    std::ranges::fill(to_evaluate_, 0);
}

PairResponse StaticEquations::response_of_bolt(const HeldByBolt& bolt, const std::vector<Motion>& motion) const {
    const BoltSegment& segment = bolt.segment;
    return respond(bolt, locate(segment, bodies_, motion),
                   {bodies_.radius[segment.block], bodies_.radius[segment.other]});
}

PairResponse StaticEquations::response_of_contact(std::size_t index, const std::vector<Motion>& motion,
                                                  const MemoryArray& before, ContactList& list) {
    constexpr double hair = 1e-9;  // of the shortest edge
    const RelaxationContact contact = list.contact[index];
    const double touching = hair * std::min(bodies_.shortest_edge[contact.block], bodies_.shortest_edge[contact.other]);
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
    const PairResponse response =
        respond(list.law_of(contact), contact, at, {bodies_.radius[contact.block], bodies_.radius[contact.other]},
                memory, memory.touching ? 0 : touching, contacts_resist_);
    list.memory.set(index, memory);
    return response;
}

StaticEquations::BlockBalance StaticEquations::balance_of(std::size_t index, const PseudoViscosity& resisting,
                                                          const Eigen::VectorXd& moved,
                                                          const std::vector<Motion>& motion, const MemoryArray& before,
                                                          ContactList& list) {
    const std::size_t block = free_blocks_[index];
    to_evaluate_[block] = 1;
    const Eigen::Vector3d own_moved = moved.segment<3>(3 * static_cast<Eigen::Index>(index));
    const double resists = resisting.of_blocks * stiffest_;
    BlockBalance balance{load_on(block) - resists * own_moved, resists * Eigen::Matrix3d::Identity()};
    const auto add = [&](std::size_t first, std::size_t second, const PairResponse& response) {
        if (!response.acts()) {
            return;
        }
        const bool is_first = first == block;
        const int other = unknown_[is_first ? second : first];
        const Eigen::Vector3d other_moved = other != none ? moved.segment<3>(other) : Eigen::Vector3d::Zero().eval();
        const auto own = [&](const PairDirection& direction) {
            return (is_first ? direction : direction.of_other_first()).of_first();
        };
        const auto moved_along = [&](const PairDirection& direction) {
            return own(direction).dot(own_moved) +
                   (is_first ? direction.of_other_first() : direction).of_first().dot(other_moved);
        };
        const Eigen::Vector3d normal = own(response.normal);
        const Eigen::Vector3d along = own(response.along);
        const double normal_damping = resisting.of_contacts * response.normal_damping;
        const double shear_damping = resisting.of_contacts * response.shear_damping;
        balance.force += (response.normal_force - normal_damping * moved_along(response.normal)) * normal +
                         (response.shear_force - shear_damping * moved_along(response.along)) * along;
        balance.tangent += (response.normal_stiffness + normal_damping) * normal * normal.transpose() +
                           (response.shear_stiffness + shear_damping) * along * along.transpose() +
                           response.coupling * along * normal.transpose();
    };
    for (const std::size_t contact : contacts_of_[index]) {
        const ContactBlocks& blocks = list.contact.blocks()[contact];
        add(blocks.block, blocks.other, response_of_contact(contact, motion, before, list));
    }
    contacts_evaluated_ += contacts_of_[index].size();
    for (const std::size_t bolt : bolts_of_[index]) {
        add(bolts_[bolt].segment.block, bolts_[bolt].segment.other, response_of_bolt(bolts_[bolt], motion));
    }
    return balance;
}

Eigen::Vector3d StaticEquations::load_on(std::size_t block) const {
    return loads_[block].cwiseProduct(Eigen::Vector3d(1, 1, 1 / bodies_.radius[block]));
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

const PairResponse& StaticEquations::keep(std::size_t block, std::size_t other, const PairResponse& response,
                                          std::size_t index) {
    PairResponse& kept = response_[index];
    kept = response;
    if (block > other) {
        kept.normal = response.normal.of_other_first();
        kept.along = response.along.of_other_first();
    }
    return kept;
}

void StaticEquations::add_forces(std::size_t block, std::size_t other, const PairResponse& kept) {
    const int first = unknown_[std::min(block, other)];
    const int second = unknown_[std::max(block, other)];
    const Eigen::Vector3d force = kept.normal_force * kept.normal.of_first() + kept.shear_force * kept.along.of_first();
    if (first != none) {
        unbalanced_.segment<3>(first) += force;
    }
    if (second != none) {
        const double moment = kept.normal_force * kept.normal.other_lever + kept.shear_force * kept.along.other_lever;
        unbalanced_.segment<3>(second) += Eigen::Vector3d(-force.x(), -force.y(), moment);
    }
}

std::optional<Eigen::VectorXd> StaticEquations::change(const PseudoViscosity& resisting,
                                                       const Eigen::VectorXd& forces) {
    const std::span<double> value = system_->values();
    std::ranges::fill(value, 0.0);
    for (const Pair& pair : pairs_) {
        const std::array<double, 36> tangent =
            tangent_of({response_.data() + pair.begin, pair.end - pair.begin}, resisting.of_contacts);
        for (std::size_t part = 0; part < pair.places.size(); ++part) {
            const Place& place = pair.places[part];
            for (std::size_t column = 0; column < 3 && place.begin != none; ++column) {
                double* const to = value.data() + place.begin + column * static_cast<std::size_t>(place.stride);
                const double* const from = tangent.data() + 6 * (3 * (part % 2) + column) + 3 * (part / 2);
                to[0] += from[0];
                to[1] += from[1];
                to[2] += from[2];
            }
        }
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
    Eigen::VectorXd held = resisting.of_blocks * stiffest_ * moved;
    if (!contacts_resist_) {
        return held;
    }
    for (const Pair& pair : pairs_) {
        const int first = unknown_[pair.first];
        const int second = unknown_[pair.second];
        std::array<double, 6> by{};
        for (int one = 0; one < 3; ++one) {
            by[static_cast<std::size_t>(one)] = first != none ? moved(first + one) : 0;
            by[static_cast<std::size_t>(one) + 3] = second != none ? moved(second + one) : 0;
        }
        const std::array<double, 6> resists =
            damping_against(by, {response_.data() + pair.begin, pair.end - pair.begin});
        for (int one = 0; one < 3; ++one) {
            if (first != none) {
                held(first + one) += resisting.of_contacts * resists[static_cast<std::size_t>(one)];
            }
            if (second != none) {
                held(second + one) += resisting.of_contacts * resists[static_cast<std::size_t>(one) + 3];
            }
        }
    }
    return held;
}

void StaticEquations::move(std::size_t index, const Eigen::Vector3d& change, std::vector<Motion>& motion) const {
    const std::size_t block = free_blocks_[index];
    Motion& moved = motion[block];
    const double turn = change(2) / bodies_.radius[block];
    moved.x += change(0) - turn / 2 * change(1);
    moved.y += change(1) + turn / 2 * change(0);
    moved.set_angle(moved.angle + turn);
}

void StaticEquations::move(const Eigen::VectorXd& change, std::vector<Motion>& motion) const {
    for (std::size_t index = 0; index < free_blocks_.size(); ++index) {
        move(index, change.segment<3>(3 * static_cast<Eigen::Index>(index)), motion);
    }
}

}  // namespace delabole
