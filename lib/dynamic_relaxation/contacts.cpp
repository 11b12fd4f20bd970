#include "dynamic_relaxation/contacts.hpp"

#include "dynamic_relaxation/contact_law.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

namespace delabole {

namespace {

// A face may lean on another by this much and still touch it with both ends (sine); a corner's own other face, at right
// angles in a rectangle, must not count as touching.
constexpr double lean = 0.35;
// A corner that bears on an edge goes on doing so up to here: to take it away, or to give its load to the next edge, on
// which it is deeper, would make energy out of nothing.
constexpr double lean_while_touching = 0.7;
// The weight of a contact changes over this way around an edge's end, in shortest edges. Far above any overlap, so that
// a change of overlap hardly changes a weight, and far below what an eye or a lever arm would see.
constexpr double blend_way = 1e-3;
// A joint drawn open by less than this, in shortest edges, is closed.
constexpr double closed = 1e-3;
// A corner that is found below an edge came there over the edge if it is no deeper than this, in margins.
constexpr double came_over = 0.01;
// Deeper corners belong to the block's other side.
constexpr double deepest = 0.25;
// Of two edges that meet in a tip, a corner at the tip is on the one into whose block its faces dip less by so much
// (sine).
constexpr double clearly_less = 0.15;
// As far from the tip, in shortest edges, as overlaps may not yet tell.
constexpr double at_tip = 0.05;

std::uint64_t key_of(std::size_t corner, std::size_t edge) {
    return (static_cast<std::uint64_t>(corner) << 32U) | edge;
}

// Each law once.
class Laws {
  public:
    explicit Laws(std::vector<ContactLaw>& list) : list_(list) {}

    std::uint32_t number_of(const ContactLaw& law) {
        const auto [entry, is_new] = number_.try_emplace(law, static_cast<std::uint32_t>(list_.size()));
        if (is_new) {
            list_.push_back(law);
        }
        return entry->second;
    }

  private:
    struct Hash {
        std::size_t operator()(const ContactLaw& law) const {
            std::uint64_t hash = 0;
            for (const double number : {law.start_weight, law.end_weight, law.inverse_blend, law.rival_sine,
                                        law.normal_stiffness, law.normal_dashpot, law.friction, law.cohesion}) {
                hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15U;
                hash ^= hash >> 32U;
            }
            return hash;
        }
    };

    std::vector<ContactLaw>& list_;
    std::unordered_map<ContactLaw, std::uint32_t, Hash> number_ = {};
};

class ContactIndex {
  public:
    explicit ContactIndex(const std::vector<RelaxationContact>& contacts) {
        entries_.reserve(contacts.size());
        for (std::uint32_t index = 0; index < contacts.size(); ++index) {
            entries_.emplace_back(key_of(contacts[index].corner, contacts[index].edge), index);
        }
        std::sort(entries_.begin(), entries_.end());
    }

    // no_twin where there is none.
    std::uint32_t find(std::size_t corner, std::size_t edge) const {
        const std::uint64_t key = key_of(corner, edge);
        const auto found = std::lower_bound(entries_.begin(), entries_.end(), std::pair(key, std::uint32_t{0}));
        return found != entries_.end() && found->first == key ? found->second : no_twin;
    }

  private:
    std::vector<std::pair<std::uint64_t, std::uint32_t>> entries_ = {};
};

class Search {
  public:
    // Adds to the list.
    Search(const RelaxationScene& scene, const Bodies& bodies, const std::vector<Motion>& motion,
           const SearchOptions& options, const ContactList& previous, const ContactIndex& known, ContactList& list)
        : scene_(scene),
          bodies_(bodies),
          motion_(motion),
          options_(options),
          previous_(previous),
          known_(known),
          list_(list),
          laws_(list.law) {}

    // Corners of the first block on edges of the second.
    void add_corners(std::uint32_t block, std::uint32_t other) {
        const double shortest = std::min(bodies_.shortest_edge[block], bodies_.shortest_edge[other]);
        for (std::size_t corner = bodies_.range[block].begin; corner < bodies_.range[block].end; ++corner) {
            for (std::size_t edge = bodies_.range[other].begin; edge < bodies_.range[other].end; ++edge) {
                add_corner(corner, edge, shortest);
            }
        }
    }

  private:
    void add_corner(std::size_t corner, std::size_t edge, double shortest) {
        const std::size_t block = bodies_.block_of[corner];
        const std::size_t other = bodies_.block_of[edge];
        const double blend = blend_way * shortest;
        const PlanePoint<> way = moved_corner(bodies_, motion_, corner) - moved_corner(bodies_, motion_, edge);
        const PlanePoint<> normal = motion_[other].turned(bodies_.normal(edge));
        const double gap = normal.dot(way);
        if (gap > options_.margin || gap < -deepest * shortest) {
            return;
        }
        const PlanePoint<> along = motion_[other].turned(bodies_.along[edge]);
        const double position = along.dot(way);
        const double reach = options_.margin + 3 * blend;
        if (position < -reach || position > bodies_.length[edge] + reach) {
            return;
        }
        const std::size_t before = bodies_.range[block].before(corner);
        const PlanePoint<> to_next = motion_[block].turned(bodies_.along[corner]);
        const PlanePoint<> to_previous = -motion_[block].turned(bodies_.along[before]);
        if (!can_bear(corner, edge, to_next, to_previous)) {
            return;
        }
        const End near = end_of(edge, position < bodies_.length[edge] / 2);
        const End far = end_of(edge, !near.at_start);
        const bool near_bears = can_bear(corner, near.beyond, to_next, to_previous);
        // Of a short edge the end farther off can be the one to which the corner is carried.
        const double far_depth = depth_beyond(corner, far);
        const bool far_counts = far_depth < deepest * shortest &&
                                (!near_bears || far_depth < depth_beyond(corner, near)) &&
                                can_bear(corner, far.beyond, to_next, to_previous);
        const bool at_start = (far_counts ? far : near).at_start;
        const std::size_t beyond = (far_counts ? far : near).beyond;
        bool rival = far_counts || near_bears;
        const double from_end = at_start ? position : bodies_.length[edge] - position;
        if (rival && std::abs(from_end) < at_tip * shortest) {
            const double excess = dip_beyond_that_of(corner, edge, beyond, at_start, shortest);
            if (excess > clearly_less) {
                return;
            }
            rival = excess >= -clearly_less;
        }
        // The face of the corner's block that lies on the edge is the one nearer to its direction.
        const std::size_t face = std::abs(to_next.dot(normal)) < std::abs(to_previous.dot(normal)) ? corner : before;
        ContactLaw law = law_between(corner, edge, face, blend, {to_next.dot(along), to_previous.dot(along)});
        if (rival) {
            const PlanePoint<>& one = bodies_.along[edge];
            const PlanePoint<>& two = bodies_.along[beyond];
            law.rival = at_start ? 1 : -1;
            law.rival_sine = std::abs(one.x() * two.y() - one.y() * two.x());
            law.rival_cosine = -one.dot(two);
        }
        list_.contact.push_back(contact_of(corner, edge, laws_.number_of(law)));
    }

    struct End {
        bool at_start;
        std::size_t beyond;  // edge
    };

    End end_of(std::size_t edge, bool at_start) const {
        const CornerRange& range = bodies_.range[bodies_.block_of[edge]];
        return {at_start, at_start ? range.before(edge) : range.after(edge)};
    }

    // Of the corner below the edge beyond an end.
    double depth_beyond(std::size_t corner, const End& end) const {
        const CornerRange& range = bodies_.range[bodies_.block_of[end.beyond]];
        const std::size_t shared = end.at_start ? range.after(end.beyond) : end.beyond;
        return -moved_normal(end.beyond)
                    .dot(moved_corner(bodies_, motion_, corner) - moved_corner(bodies_, motion_, shared));
    }

    PlanePoint<> moved_normal(std::size_t edge) const {
        return motion_[bodies_.block_of[edge]].turned(bodies_.normal(edge));
    }

    bool can_bear(std::size_t corner, std::size_t edge, const PlanePoint<>& to_next,
                  const PlanePoint<>& to_previous) const {
        const PlanePoint<> normal = moved_normal(edge);
        // Of the corner's faces below the edge, sine.
        const double dips = -std::min(to_next.dot(normal), to_previous.dot(normal));
        if (dips <= lean || dips > lean_while_touching) {
            return dips <= lean;
        }
        const std::uint32_t before = known_.find(corner, edge);
        return before != no_twin && previous_.memory[before].touching;
    }

    // Where a joint comes out of a face at an acute angle, the corners of both blocks coincide in the drawing: they
    // bear on each other's joint, but on each other's face they would hold the joint. By how much the faces of a corner
    // dip deeper (sine) below one edge than below the one beyond its end; 0 where the corner is not drawn at that end.
    double dip_beyond_that_of(std::size_t corner, std::size_t edge, std::size_t beyond, bool at_start,
                              double shortest) const {
        const std::size_t block = bodies_.block_of[corner];
        const std::size_t end = at_start ? edge : bodies_.range[bodies_.block_of[edge]].after(edge);
        const PlanePoint<> apart = (bodies_.centroid[block] - bodies_.centroid[bodies_.block_of[edge]]) +
                                   (bodies_.corner[corner] - bodies_.corner[end]);
        if (apart.norm() > closed * shortest) {
            return 0;
        }
        const PlanePoint<>& to_next = bodies_.along[corner];
        const PlanePoint<> to_previous = -bodies_.along[bodies_.range[block].before(corner)];
        const auto dip = [&](std::size_t below) {
            const PlanePoint<> normal = bodies_.normal(below);
            return -std::min(to_next.dot(normal), to_previous.dot(normal));
        };
        return dip(edge) - dip(beyond);
    }

    struct Sides {
        double next;  // of the corner's faces, along the edge
        double previous;
    };

    RelaxationContact contact_of(std::size_t corner, std::size_t edge, std::uint32_t law) const {
        const std::size_t block = bodies_.block_of[corner];
        const std::size_t other = bodies_.block_of[edge];
        RelaxationContact contact{};
        contact.block = static_cast<std::uint32_t>(block);
        contact.other = static_cast<std::uint32_t>(other);
        contact.corner = static_cast<std::uint32_t>(corner);
        contact.edge = static_cast<std::uint32_t>(edge);
        contact.twin = no_twin;
        contact.law = law;
        const PlanePoint<> offset =
            (bodies_.centroid[block] - bodies_.centroid[other]) + (bodies_.corner[corner] - bodies_.corner[edge]);
        contact.arm = bodies_.corner[corner];
        contact.other_arm = bodies_.corner[edge] + offset;
        contact.along = bodies_.along[edge];
        contact.gap = bodies_.normal(edge).dot(offset);
        contact.from_start = contact.along.dot(offset);
        contact.to_end = bodies_.length[edge] - contact.from_start;
        return contact;
    }

    ContactLaw law_between(std::size_t corner, std::size_t edge, std::size_t face, double blend,
                           const Sides& sides) const {
        const std::size_t block = bodies_.block_of[corner];
        const std::size_t other = bodies_.block_of[edge];
        ContactLaw law{};
        // Over the end of an edge, a block that reaches back over it hands over to its twin; one that only touches the
        // end with a corner does not bear there at all.
        const double reaching = std::max(sides.next, sides.previous);
        const double reaching_back = -std::min(sides.next, sides.previous);
        law.start_weight = reaching > lean ? 0.5 : -0.5;
        law.end_weight = reaching_back > lean ? 0.5 : -0.5;
        law.inverse_blend = 1 / (2 * blend);
        const JointMaterial& of_face = scene_.material[bodies_.material[face]];
        const JointMaterial& of_edge = scene_.material[bodies_.material[edge]];
        const JointMaterial& joint = of_face.friction_angle < of_edge.friction_angle ? of_face : of_edge;
        law.normal_stiffness = joint.normal_stiffness;
        law.shear_stiffness = joint.shear_stiffness;
        const double effective_mass = 1 / (bodies_.inverse_mass[block] + bodies_.inverse_mass[other]);
        law.normal_dashpot = 2 * options_.viscous_damping * std::sqrt(effective_mass * joint.normal_stiffness);
        law.shear_dashpot = 2 * options_.viscous_damping * std::sqrt(effective_mass * joint.shear_stiffness);
        law.friction = std::tan(joint.friction_angle);
        law.residual_friction = std::tan(joint.residual_friction_angle.value_or(joint.friction_angle));
        const double half_shared = shared_length(face, edge) / 2;
        law.cohesion = joint.cohesion * half_shared;
        law.tension = joint.tensile_strength * half_shared;
        return law;
    }

    double shared_length(std::size_t face, std::size_t edge) const {
        const std::size_t block = bodies_.block_of[face];
        const PlanePoint<> start = moved_corner(bodies_, motion_, edge);
        const PlanePoint<> along = motion_[bodies_.block_of[edge]].turned(bodies_.along[edge]);
        const double one = along.dot(moved_corner(bodies_, motion_, face) - start);
        const double two = along.dot(moved_corner(bodies_, motion_, bodies_.range[block].after(face)) - start);
        return std::max(0.0, std::min(bodies_.length[edge], std::max(one, two)) - std::max(0.0, std::min(one, two)));
    }

    const RelaxationScene& scene_;
    const Bodies& bodies_;
    const std::vector<Motion>& motion_;
    const SearchOptions& options_;
    const ContactList& previous_;
    const ContactIndex& known_;
    ContactList& list_;
    Laws laws_;
};

// A corner's twin at the start of an edge is that end on the face that ends at the corner, because both outlines run
// anticlockwise; at the edge's end it is the face that begins there.
void pair_twins(const Bodies& bodies, const std::vector<Motion>& motion, ContactList& list) {
    const ContactIndex index(list.contact);
    for (RelaxationContact& contact : list.contact) {
        const PlanePoint<> way =
            moved_corner(bodies, motion, contact.corner) - moved_corner(bodies, motion, contact.edge);
        const double position = motion[contact.other].turned(contact.along).dot(way);
        const CornerRange& own = bodies.range[contact.block];
        const CornerRange& others = bodies.range[contact.other];
        contact.twin = position < contact.edge_length() / 2 ? index.find(contact.edge, own.before(contact.corner))
                                                            : index.find(others.after(contact.edge), contact.corner);
    }
}

double gap_of(const RelaxationContact& contact, const std::vector<Motion>& motion) {
    return locate(contact, motion[contact.block], motion[contact.other]).gap;
}

// In the drawing, below the line of the edge but outside another edge of the same block; or farther below than the
// blocks overlap, as tips of blocks on the other side of a thin one are.
bool beside(const Bodies& bodies, const RelaxationContact& contact, double shortest) {
    if (contact.gap >= 0) {
        return false;
    }
    if (contact.gap < distance_between(bodies, contact.block, contact.other) - blend_way * shortest) {
        return true;
    }
    const PlanePoint<> between = bodies.centroid[contact.block] - bodies.centroid[contact.other];
    const CornerRange& range = bodies.range[contact.other];
    for (std::size_t edge = range.begin; edge < range.end; ++edge) {
        if (bodies.normal(edge).dot(between + (contact.arm - bodies.corner[edge])) > blend_way * shortest) {
            return true;
        }
    }
    return false;
}

}  // namespace

double distance_between(const Bodies& bodies, std::size_t first, std::size_t second) {
    double greatest = -std::numeric_limits<double>::infinity();
    for (const auto& [block, other] : {std::pair(first, second), std::pair(second, first)}) {
        const PlanePoint<> between = bodies.centroid[block] - bodies.centroid[other];
        for (std::size_t edge = bodies.range[other].begin; edge < bodies.range[other].end; ++edge) {
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t corner = bodies.range[block].begin; corner < bodies.range[block].end; ++corner) {
                least =
                    std::min(least, bodies.normal(edge).dot(between + (bodies.corner[corner] - bodies.corner[edge])));
            }
            greatest = std::max(greatest, least);
        }
    }
    return greatest;
}

ContactList find_contacts(const RelaxationScene& scene, const Bodies& bodies, const std::vector<Motion>& motion,
                          const std::vector<char>& removed, const SearchOptions& options, const ContactList& previous) {
    ContactList list;
    list.margin = options.margin;
    list.contact.reserve(previous.contact.size() + 64);
    const ContactIndex known(previous.contact);
    Search search(scene, bodies, motion, options, previous, known, list);
    for (const auto& [first, second] : neighbouring_blocks(bodies, motion, removed, options.margin)) {
        if (std::binary_search(options.bonded.begin(), options.bonded.end(), BlockPair(first, second))) {
            continue;
        }
        search.add_corners(first, second);
        search.add_corners(second, first);
    }
    pair_twins(bodies, motion, list);
    list.memory.resize(list.contact.size());
    list.force.resize(list.contact.size());
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        RelaxationContact& contact = list.contact[index];
        ContactMemory& memory = list.memory[index];
        const std::uint32_t before = known.find(contact.corner, contact.edge);
        if (before != no_twin) {
            // Slip and energies have been booked; what is left is what the contact goes on with.
            memory = previous.memory[before];
            memory.slip = memory.friction = memory.damping = 0;
            contact.gap += memory.shortened;
        } else {
            const double shortest = std::min(bodies.shortest_edge[contact.block], bodies.shortest_edge[contact.other]);
            memory.broken = !(options.first && contact.gap <= closed * shortest);
            memory.beneath = options.first ? beside(bodies, contact, shortest)
                                           : list.law_of(contact).rival == 0 &&
                                                 gap_of(contact, motion) < -came_over * options.margin;
            memory.touching =
                !memory.broken && !memory.beneath && (list.law_of(contact).tension > 0 || contact.gap < 0);
        }
    }
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const RelaxationContact& contact = list.contact[index];
        if (list.memory[index].beneath) {
            continue;
        }
        const ContactPosition at = locate(contact, motion[contact.block], motion[contact.other]);
        const double shortest = std::min(bodies.shortest_edge[contact.block], bodies.shortest_edge[contact.other]);
        if (-at.gap > list.worst_overlap * shortest && contact_weight(list.law_of(contact), contact, at) > 0) {
            list.worst_overlap = -at.gap / shortest;
        }
    }
    return list;
}

}  // namespace delabole
