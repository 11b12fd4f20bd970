#include "dynamic_relaxation/contact/pair_search.hpp"

#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/corner_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

// Sine of the greatest angle at which a face may lean on another and still touch it with both ends; a corner's own
// other face, at right angles in a rectangle, must not count as touching.
constexpr double lean = 0.35;
// A corner that bears on an edge goes on doing so up to this sine: removing it, or giving its load to the next edge,
// over which it is deeper, would create energy.
constexpr double lean_while_touching = 0.7;
// The weight of a contact changes over this distance around an edge's end, in shortest edges. It is far above any
// overlap, so that a change of overlap hardly changes a weight, and far too short to be visible or to change a lever
// arm.
constexpr double blend_length = 1e-3;
// A corner that is found below an edge has crossed the edge if it is no deeper than this, in margins.
constexpr double came_over = 0.01;
// In shortest edges: deeper corners belong to the block's other side, unless they bear already.
constexpr double deepest = 0.25;
// Where two edges meet in a tip, a corner at the tip belongs to the edge into whose block its faces dip less, if the
// sines of the two dips differ by more than this.
constexpr double clearly_less = 0.15;
// Sine; a corner whose faces dip deeper below an edge than this does not lie on it.
constexpr double into_the_block = 0.02;
// Distance from the tip, in shortest edges, up to which overlaps may not yet show to which edge a corner belongs.
constexpr double at_tip = 0.05;

constexpr std::size_t unknown = static_cast<std::size_t>(-1);

// Greatest distance by which the line of an edge separates a block's corners from the edge's block.
template <class GapOf>
double greatest_distance(const CornerRange& corners, const CornerRange& edges, const GapOf& gap_of) {
    double greatest = -std::numeric_limits<double>::infinity();
    for (std::size_t edge = edges.begin; edge < edges.end; ++edge) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t corner = corners.begin; corner < corners.end; ++corner) {
            least = std::min(least, gap_of(corner, edge));
        }
        greatest = std::max(greatest, least);
    }
    return greatest;
}

// Whether the corner, in the initial geometry, is below the line of the edge but outside another edge of the same
// block, or farther below it than the blocks overlap. The latter are tips of blocks on the other side of a thin block.
bool beside(const Bodies& bodies, const RelaxationContact& contact, double shortest) {
    const PlanePoint<> between = bodies.centroid[contact.block] - bodies.centroid[contact.other];
    const double gap =
        bodies.normal(contact.edge).dot(between + (bodies.corner[contact.corner] - bodies.corner[contact.edge]));
    if (gap >= 0) {
        return false;
    }
    if (gap < initial_distance(bodies, contact.block, contact.other, 0).distance - blend_length * shortest) {
        return true;
    }
    const CornerRange& range = bodies.range[contact.other];
    for (std::size_t edge = range.begin; edge < range.end; ++edge) {
        if (bodies.normal(edge).dot(between + (bodies.corner[contact.corner] - bodies.corner[edge])) >
            blend_length * shortest) {
            return true;
        }
    }
    return false;
}

}  // namespace

InitialDistance initial_distance(const Bodies& bodies, std::size_t first, std::size_t second, double margin) {
    double behind = -std::numeric_limits<double>::infinity();  // the least distance of a corner behind an edge's line
    const auto over_edges_of = [&](std::size_t other, std::size_t block) {
        const PlanePoint<> between = bodies.centroid[block] - bodies.centroid[other];
        return greatest_distance(bodies.range[block], bodies.range[other], [&](std::size_t corner, std::size_t edge) {
            const double gap = bodies.normal(edge).dot(between + (bodies.corner[corner] - bodies.corner[edge]));
            behind = gap < -margin ? std::max(behind, gap) : behind;
            return gap;
        });
    };
    const double distance = std::max(over_edges_of(second, first), over_edges_of(first, second));
    // Corners farther behind are beside the edge (see `beside`); the tolerance is doubled because rounding differs
    // there.
    const double shortest = std::min(bodies.shortest_edge[first], bodies.shortest_edge[second]);
    return {distance, behind >= distance - 2 * blend_length * shortest};
}

void PairContacts::clear() {
    contact.clear();
    law.clear();
    memory.clear();
    distance = worst_overlap = 0;
}

std::size_t PairSearch::Side::before(std::size_t corner_number) const {
    return corner_number > 0 ? corner_number - 1 : corner.size() - 1;
}

std::size_t PairSearch::Side::after(std::size_t corner_number) const {
    return corner_number + 1 < corner.size() ? corner_number + 1 : 0;
}

PairSearch::PairSearch(const RelaxationScene& scene, const Bodies& bodies, double viscous_damping)
    : scene_(scene), bodies_(bodies), viscous_damping_(viscous_damping) {}

PlanePoint<> PairSearch::corner_of(std::size_t corner) const {
    const PlanePoint<>& arm = bodies_.corner[corner];
    return is_shifted(corner) ? PlanePoint<>(shift_.turned(arm) + PlanePoint<>(shift_.x, shift_.y)) : arm;
}

PlanePoint<> PairSearch::along_of(std::size_t edge) const {
    return is_shifted(edge) ? shift_.turned(bodies_.along[edge]) : bodies_.along[edge];
}

void PairSearch::place(const std::vector<Motion>& motion, Side& side) const {
    const CornerRange& range = bodies_.range[side.block];
    side.begin = range.begin;
    side.corner.resize(range.size());
    side.along.resize(range.size());
    const Motion& moved = motion[side.block];
    const PlanePoint<> centroid = bodies_.centroid[side.block] + PlanePoint<>(moved.x, moved.y);
    for (std::size_t corner = 0; corner < range.size(); ++corner) {
        side.corner[corner] = centroid + moved.turned(corner_of(range.begin + corner));
        side.along[corner] = moved.turned(along_of(range.begin + corner));
    }
}

// Fills `gaps` and returns the greatest distance by which an edge of the other block separates the two.
double PairSearch::measure(const Side& block, const Side& other, Gaps& gaps) {
    gaps.corners = block.corner.size();
    gaps.gap.resize(block.corner.size() * other.corner.size());
    return greatest_distance(
        {0, block.corner.size()}, {0, other.corner.size()}, [&](std::size_t corner, std::size_t edge) {
            return gaps(corner, edge) = other.normal(edge).dot(block.corner[corner] - other.corner[edge]);
        });
}

void PairSearch::find(const BlockPair& pair, const std::vector<Motion>& motion, const PairQuery& query,
                      const ContactList& list, const ContactRange& before, const std::optional<PairPose>& then,
                      PairContacts& found) {
    found.clear();
    query_ = query;
    shift_.x = query.shift.x;
    shift_.y = query.shift.y;
    shift_.set_angle(query.shift.angle);
    shortest_ = std::min(bodies_.shortest_edge[pair.first], bodies_.shortest_edge[pair.second]);
    side_[0].block = pair.first;
    side_[1].block = pair.second;
    list_ = &list;
    before_ = before;
    then_ = then;
    place(motion, side_[0]);
    place(motion, side_[1]);
    const double distance = std::max(measure(side_[0], side_[1], gaps_[0]), measure(side_[1], side_[0], gaps_[1]));
    found.distance = distance;
    found.worst_overlap = std::max(0.0, -distance / shortest_);
    if (distance > query.margin + 3 * blend_length * shortest_) {
        return;
    }
    for (std::size_t side = 0; side < 2; ++side) {
        const Gaps& gaps = gaps_[side];
        for (std::size_t corner = 0; corner < side_[side].corner.size(); ++corner) {
            for (std::size_t edge = 0; edge < side_[1 - side].corner.size(); ++edge) {
                const bool too_deep = gaps(corner, edge) < -deepest * shortest_;
                if (gaps(corner, edge) <= query.margin &&
                    (!too_deep || bears(side_[side], corner, side_[1 - side], edge))) {
                    add_corner(side, corner, edge, found);
                }
            }
        }
    }
    pair_twins(found);
    remember(found, motion);
}

// `side` is the side of the corner.
void PairSearch::add_corner(std::size_t side, std::size_t corner, std::size_t edge, PairContacts& found) const {
    const Side& block = side_[side];
    const Side& other = side_[1 - side];
    const Gaps& gaps = gaps_[side];
    const std::size_t corner_number = block.begin + corner;
    const std::size_t edge_number = other.begin + edge;
    const double length = bodies_.length[edge_number];
    const PlanePoint<>& along = other.along[edge];
    const double position = along.dot(block.corner[corner] - other.corner[edge]);
    const double reach = query_.margin + 3 * blend_length * shortest_;
    if (position < -reach || position > length + reach || !can_bear(block, corner, other, edge)) {
        return;
    }
    const bool start_is_near = position < length / 2;
    const std::size_t near = start_is_near ? other.before(edge) : other.after(edge);
    const std::size_t far = start_is_near ? other.after(edge) : other.before(edge);
    const bool near_bears = can_bear(block, corner, other, near);
    // On a short edge the corner may be carried to the farther end. Where the edge beyond that end continues as one
    // face, the blocks overlap equally over it wherever the corner is, which tells nothing about the end that the
    // corner is at.
    const bool far_counts = -gaps(corner, far) < deepest * shortest_ &&
                            bodies_.along[edge_number].dot(bodies_.along[other.begin + far]) < one_face &&
                            (!near_bears || gaps(corner, far) > gaps(corner, near)) &&
                            can_bear(block, corner, other, far);
    const bool at_start = start_is_near != far_counts;
    const std::size_t beyond = other.begin + (far_counts ? far : near);
    bool rival = far_counts || near_bears;
    const bool alone = rival && bodies_.along[edge_number].dot(bodies_.along[beyond]) < one_face;
    const double from_end = at_start ? position : length - position;
    const double sense = at_start ? 1 : -1;
    const PlanePoint<>& one = bodies_.along[edge_number];
    const PlanePoint<>& two = bodies_.along[beyond];
    const double sine = std::abs(one.x() * two.y() - one.y() * two.x());
    const bool on_both = rival && !alone && sine < least_bend && std::abs(from_end) < at_tip * shortest_;
    double bend = 0;  // on which a tip stands that bears on this edge alone
    if (rival && std::abs(from_end) < at_tip * shortest_) {
        const double dip = dip_below(corner_number, edge_number);
        const double excess = dip_beyond_that_of(corner_number, edge_number, beyond, at_start);
        const bool belongs_beyond = alone ? dip > into_the_block && excess > into_the_block : excess > clearly_less;
        if (belongs_beyond) {
            return;
        }
        if (!alone && excess < -clearly_less) {
            rival = false;
            bend = dip < -into_the_block ? sense * sine : 0;
        }
    }
    ContactLaw law = law_between(block, corner, other, edge, on_both ? std::optional(beyond) : std::nullopt);
    law.rival_sine = bend;
    if (rival) {
        law.rival = sense;
        law.rival_sine = sine;
        law.rival_cosine = -one.dot(two);
        law.alone = alone ? 1 : 0;
    }
    add_twin_as_rival(block, corner, other, edge, at_start, law);
    if (law.alone > 0) {
        // At this end the weight depends only on how far the blocks overlap.
        (at_start ? law.start_weight : law.end_weight) = 1;
    }
    found.contact.push_back(contact_of(corner_number, edge_number));
    found.law.push_back(law);
}

// Beyond the edge's end, that end itself may bear on a face of the corner's block, which then is the rival. The angle
// between edges of two blocks changes as they rotate: the law keeps that of the initial geometry and stays the same
// from search to search.
void PairSearch::add_twin_as_rival(const Side& block, std::size_t corner, const Side& other, std::size_t edge,
                                   bool at_start, ContactLaw& law) const {
    const std::size_t end = at_start ? edge : other.after(edge);
    const std::size_t face = at_start ? block.before(corner) : corner;
    const PlanePoint<> inward = at_start ? other.along[edge] : PlanePoint<>(-other.along[edge]);
    const PlanePoint<> along_face = at_start ? PlanePoint<>(-block.along[face]) : block.along[face];
    const double cosine = inward.dot(along_face);
    // The edge with the nearer normal is the neighbour on the outline of all differences (corner_choice.hpp). Where
    // joints of two sets cross, both are equally near, and a minute rotation must not change the law.
    constexpr double clearly_nearer = 0.02;
    const bool farther = law.alone > 0 && cosine < -law.rival_cosine + clearly_nearer;
    if (farther || !can_bear(other, end, block, face)) {
        return;
    }
    const double sense = at_start ? 1 : -1;
    const PlanePoint<> one = sense * along_of(other.begin + edge);
    const PlanePoint<> two = -sense * along_of(block.begin + face);
    const double sine = sense * (two.x() * one.y() - two.y() * one.x());
    if (cosine > one_face) {
        // Edge and face lie on each other as one face, so that the edge beyond the end is not a rival. Where a sliver
        // was taken away between them, they gape, and a corner at the end bears like a tip on a bend.
        if (law.alone > 0) {
            law.rival = law.rival_sine = law.rival_cosine = law.alone = 0;
        }
        if (law.rival == 0 && std::abs(sine) > least_bend) {
            law.rival_sine = sense * std::abs(sine);
        }
        return;
    }
    law.rival = 2 * sense;
    law.rival_sine = sine;
    law.rival_cosine = -two.dot(one);
    law.alone = law.alone > 0 ? 1 : 2;
}

bool PairSearch::can_bear(const Side& block, std::size_t corner, const Side& other, std::size_t edge) const {
    const PlanePoint<> normal = other.normal(edge);
    // Sine of the angle by which the corner's faces dip below the edge.
    const double dips = std::max(-block.along[corner].dot(normal), block.along[block.before(corner)].dot(normal));
    if (dips <= lean || dips > lean_while_touching) {
        return dips <= lean;
    }
    return bears(block, corner, other, edge);
}

bool PairSearch::bears(const Side& block, std::size_t corner, const Side& other, std::size_t edge) const {
    const std::size_t before = known(block.begin + corner, other.begin + edge);
    return before != unknown && list_->memory[before].touching;
}

// By how much (sine) the faces of a corner dip deeper below one edge than below the edge beyond its end; 0 if the
// corner does not lie at that end in the initial geometry. Where a joint daylights in a face at an acute angle, the
// corners of both blocks coincide in the initial geometry: they bear on each other's joint, but if they bore on each
// other's face they would lock the joint.
double PairSearch::dip_beyond_that_of(std::size_t corner, std::size_t edge, std::size_t beyond, bool at_start) const {
    const std::size_t block = bodies_.block_of[corner];
    const std::size_t end = at_start ? edge : bodies_.range[bodies_.block_of[edge]].after(edge);
    const PlanePoint<> apart = (bodies_.centroid[block] - bodies_.centroid[bodies_.block_of[edge]]) +
                               (bodies_.corner[corner] - bodies_.corner[end]);
    if (apart.norm() > closed_joint * shortest_) {
        return 0;
    }
    return dip_below(corner, edge) - dip_below(corner, beyond);
}

double PairSearch::dip_below(std::size_t corner, std::size_t edge) const {
    const PlanePoint<>& to_next = bodies_.along[corner];
    const PlanePoint<>& from_previous = bodies_.along[bodies_.range[bodies_.block_of[corner]].before(corner)];
    const PlanePoint<> normal = bodies_.normal(edge);
    return -std::min(to_next.dot(normal), -from_previous.dot(normal));
}

RelaxationContact PairSearch::contact_of(std::size_t corner, std::size_t edge) const {
    const std::size_t block = bodies_.block_of[corner];
    const std::size_t other = bodies_.block_of[edge];
    RelaxationContact contact{};
    contact.block = static_cast<std::uint32_t>(block);
    contact.other = static_cast<std::uint32_t>(other);
    contact.corner = static_cast<std::uint32_t>(corner);
    contact.edge = static_cast<std::uint32_t>(edge);
    contact.twin = no_twin;
    const PlanePoint<> arm = corner_of(corner);
    const PlanePoint<> start = corner_of(edge);
    const PlanePoint<> offset = (bodies_.centroid[block] - bodies_.centroid[other]) + (arm - start);
    const PlanePoint<> other_arm = start + offset;
    const PlanePoint<> along = along_of(edge);
    contact.arm_x = arm.x();
    contact.arm_y = arm.y();
    contact.other_arm_x = other_arm.x();
    contact.other_arm_y = other_arm.y();
    contact.along_x = along.x();
    contact.along_y = along.y();
    contact.gap = PlanePoint<>(along.y(), -along.x()).dot(offset);
    contact.from_start = along.dot(offset);
    contact.to_end = bodies_.length[edge] - contact.from_start;
    return contact;
}

ContactLaw PairSearch::law_between(const Side& block, std::size_t corner, const Side& other, std::size_t edge,
                                   std::optional<std::size_t> beyond) const {
    const PlanePoint<>& to_next = block.along[corner];
    const PlanePoint<> to_previous = -block.along[block.before(corner)];
    const PlanePoint<> normal = other.normal(edge);
    // The face of the corner's block that lies on the edge is the one nearer to its direction; where the joint
    // changes on a straight face, the one that lies on the edge itself.
    const double length = bodies_.length[other.begin + edge];
    const auto shared = [&](std::size_t face) { return shared_length(block, face, other, edge, length); };
    constexpr double straight = 1e-9;  // sine of the turn
    const bool goes_on = std::abs(to_next.x() * to_previous.y() - to_next.y() * to_previous.x()) < straight;
    const bool is_next = goes_on ? shared(corner) > shared(block.before(corner))
                                 : std::abs(to_next.dot(normal)) < std::abs(to_previous.dot(normal));
    const std::size_t face = is_next ? corner : block.before(corner);
    const double next = to_next.dot(other.along[edge]);
    const double previous = to_previous.dot(other.along[edge]);
    ContactLaw law{};
    // A block that reaches back over the end of an edge hands over to its twin there; one that only touches the end
    // with a corner does not bear there at all.
    law.start_weight = std::max(next, previous) > lean ? 0.5 : -0.5;
    law.end_weight = -std::min(next, previous) > lean ? 0.5 : -0.5;
    law.inverse_blend = 1 / (2 * (blend_length * shortest_));
    JointMaterial joint = joint_between(scene_, bodies_, block.begin + face, other.begin + edge);
    if (beyond && shared(face) < at_tip * shortest_) {
        // Joints cross here at so small an angle that they are one face. Blocks on opposite sides of both meet in this
        // point alone, and have the lesser strength of all.
        for (const std::size_t there : {block.begin + corner, block.begin + block.before(corner), *beyond}) {
            joint = lesser_of(joint, scene_.material[bodies_.material[there]]);
        }
    }
    law.friction = std::tan(joint.friction_angle);
    law.residual_friction = std::tan(joint.residual_friction_angle.value_or(joint.friction_angle));
    law.normal_stiffness = joint.normal_stiffness;
    law.shear_stiffness = joint.shear_stiffness;
    const double effective_mass = 1 / (bodies_.inverse_mass[block.block] + bodies_.inverse_mass[other.block]);
    law.normal_dashpot = 2 * viscous_damping_ * std::sqrt(effective_mass * joint.normal_stiffness);
    law.shear_dashpot = 2 * viscous_damping_ * std::sqrt(effective_mass * joint.shear_stiffness);
    if (joint.cohesion != 0) {
        const double half_shared = shared(face) / 2;
        law.cohesion = joint.cohesion * half_shared;
        law.residual_cohesion = joint.residual_cohesion * half_shared;
    }
    return law;
}

double PairSearch::shared_length(const Side& block, std::size_t face, const Side& other, std::size_t edge,
                                 double length) {
    const double one = other.along[edge].dot(block.corner[face] - other.corner[edge]);
    const double two = other.along[edge].dot(block.corner[block.after(face)] - other.corner[edge]);
    return std::max(0.0, std::min(length, std::max(one, two)) - std::max(0.0, std::min(one, two)));
}

// The twin of a corner at the start of an edge is the contact of that start with the face that ends at the corner,
// because both outlines run anticlockwise; at the edge's end it is the contact of that end with the face that begins
// there.
void PairSearch::pair_twins(PairContacts& found) const {
    const auto number_of = [&](std::size_t corner, std::size_t edge) {
        const auto is_it = [&](const RelaxationContact& contact) {
            return contact.corner == corner && contact.edge == edge;
        };
        const auto twin = std::find_if(found.contact.begin(), found.contact.end(), is_it);
        return twin == found.contact.end() ? no_twin : static_cast<std::uint32_t>(twin - found.contact.begin());
    };
    for (RelaxationContact& contact : found.contact) {
        const Side& block = side_of(contact.block);
        const Side& other = side_of(contact.other);
        const std::size_t edge = contact.edge - other.begin;
        const double position = other.along[edge].dot(block.corner[contact.corner - block.begin] - other.corner[edge]);
        contact.twin = position < contact.edge_length() / 2
                           ? number_of(contact.edge, bodies_.range[contact.block].before(contact.corner))
                           : number_of(bodies_.range[contact.other].after(contact.edge), contact.corner);
    }
}

void PairSearch::remember(PairContacts& found, const std::vector<Motion>& motion) const {
    found.memory.resize(found.contact.size());
    for (std::size_t index = 0; index < found.contact.size(); ++index) {
        RelaxationContact& contact = found.contact[index];
        const ContactLaw& law = found.law[index];
        ContactMemory& memory = found.memory[index];
        memory = {};
        const std::size_t before = known(contact.corner, contact.edge);
        if (before != unknown) {
            memory = list_->memory[before];
        } else {
            memory.broken = !(query_.first && contact.gap <= closed_joint * shortest_);
            const ContactPosition at = locate(contact, motion[contact.block], motion[contact.other]);
            // Far deeper than the blocks overlap, the corner has not come over this edge: it lies on the other side of
            // a thin block.
            const bool behind_block = at.gap < found.distance - at_tip * shortest_;
            memory.beneath = query_.first ? beside(bodies_, contact, shortest_)
                                          : behind_block || (law.rival == 0 && at.gap < -came_over * query_.margin &&
                                                             !came_over_edge(contact, at));
            memory.touching = !memory.broken && !memory.beneath && contact.gap < 0;
        }
    }
    for (std::size_t index = 0; index < found.contact.size(); ++index) {
        const RelaxationContact& contact = found.contact[index];
        const ContactLaw& law = found.law[index];
        const ContactMemory& memory = found.memory[index];
        if (memory.beneath || memory.yields) {
            continue;
        }
        const ContactPosition at = locate(contact, motion[contact.block], motion[contact.other]);
        if (-at.gap > found.worst_overlap * shortest_ && contact_weight(law, contact, at, memory.insists) > 0) {
            found.worst_overlap = -at.gap / shortest_;
        }
    }
}

// Whether the corner has crossed the line of the edge between the edge's ends since the pair was last checked.
bool PairSearch::came_over_edge(const RelaxationContact& contact, const ContactPosition& now) const {
    if (!then_) {
        return false;
    }
    Motion first;
    first.x = then_->x;
    first.y = then_->y;
    first.set_angle(then_->first_angle);
    Motion second;
    second.set_angle(then_->second_angle);
    const bool of_first = contact.block == side_[0].block;
    const ContactPosition before = locate(contact, of_first ? first : second, of_first ? second : first);
    if (before.gap < 0) {
        return false;
    }
    const double share = before.gap / (before.gap - now.gap);
    const double position = before.position + share * (now.position - before.position);
    return position >= 0 && position <= contact.edge_length();
}

std::size_t PairSearch::known(std::size_t corner, std::size_t edge) const {
    const std::span<const ContactCorner> corners = list_->contact.corners();
    for (std::size_t index = before_.begin; index < before_.end; ++index) {
        if (corners[index].corner == corner && corners[index].edge == edge) {
            return index;
        }
    }
    return unknown;
}

}  // namespace delabole
