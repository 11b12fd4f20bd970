// Which corners can touch which edges before the next search, and what each such contact remembers.
//
// Contact memory belongs to a corner and an edge. Where a corner passes the end of an edge, the edge's end corner takes
// over on an edge of the first block (its twin): both are contacts, their weights add up to one and change over a short
// way around the end, and the shear spring is handed over. No overlap of one face is ever compared with that of
// another, which is what made the thesis's program blow up (5.3.2, cycle 677).
#pragma once

#include "dynamic_relaxation/lanes.hpp"
#include "dynamic_relaxation/large_array.hpp"
#include "dynamic_relaxation/neighbours.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace delabole {

constexpr double not_open = -1;
constexpr std::uint32_t no_twin = static_cast<std::uint32_t>(-1);

// What many contacts have in common, so that a step has less to read: a pack of bricks has a handful of laws. Of a size
// by which numbers of laws are multiplied at once.
template <class Number>
struct alignas(16 * sizeof(double)) ContactLawOf {
    Number start_weight;  // weight of the contact where the corner is at the edge's start
    Number end_weight;
    Number inverse_blend;  // 1 / length over which the weight changes
    // 1 or -1 where the corner could bear as well on the edge beyond this one's start or end: it bears on the one that
    // it is less deep in. 0 where not.
    Number rival;
    Number rival_sine;  // of the interior angle between the two
    Number rival_cosine;
    Number normal_stiffness;
    Number shear_stiffness;
    Number normal_dashpot;
    Number shear_dashpot;
    Number friction;           // tangent of the peak angle
    Number residual_friction;  // likewise
    Number cohesion;           // N/m: over half the shared length
    Number tension;            // N/m

    bool operator==(const ContactLawOf&) const = default;
};

using ContactLaw = ContactLawOf<double>;

// Of a contact, in the drawing, as the loop over contacts wants it.
template <class Number>
struct ContactShape {
    Number arm_x;
    Number arm_y;
    Number other_arm_x;
    Number other_arm_y;
    Number along_x;
    Number along_y;
    Number gap;
    Number from_start;
    Number to_end;
};

struct RelaxationContact {
    // In the drawing:
    PlanePoint<> arm = PlanePoint<>::Zero();        // of the corner, about its block's centroid
    PlanePoint<> other_arm = PlanePoint<>::Zero();  // of the corner, about the other block's centroid
    PlanePoint<> along = PlanePoint<>::Zero();      // of the edge
    double gap;                                     // from the edge to the corner
    double from_start;                              // of the edge to the corner, along the edge
    double to_end;                                  // from the corner to the edge's end, likewise
    std::uint32_t block;                            // of the corner
    std::uint32_t other;                            // of the edge
    std::uint32_t corner;
    std::uint32_t edge;
    std::uint32_t twin;
    std::uint32_t law;  // in the list's laws

    ContactShape<double> shape() const {
        return {arm.x(), arm.y(), other_arm.x(), other_arm.y(), along.x(), along.y(), gap, from_start, to_end};
    }
    double edge_length() const { return from_start + to_end; }
    BlockPair pair() const { return {block < other ? block : other, block < other ? other : block}; }
};

template <class Number>
struct ContactMemoryOf {
    Number shear{};        // displacement of the shear spring, along the edge
    Number place{};        // of the corner along the edge when last evaluated, since the drawing
    Number damping{};      // J/m, dissipated so far
    Number overlap{};      // m, when last evaluated while touching
    Number normal_drag{};  // N/m, of the dashpots when last evaluated, along the normal
    Number shear_drag{};   // N/m, along the edge
    Number slip{};         // sum of plastic displacement along the edge, with its sign
    Number friction{};     // J/m, dissipated so far, with broken bonds
    // m; a joint that was a bond is as much shorter as the rock was under its load when the bond broke (bonds.hpp).
    Number shortened{};
    MaskOf<Number> touching{};
    MaskOf<Number> sliding{};
    MaskOf<Number> broken{};  // peak strength, cohesion and tensile strength are gone
    // Below the line of the edge without having come there over the edge, for instance past its end: no overlap of this
    // edge, and none to bear with, until the corner has been above.
    MaskOf<Number> beneath{};
};

using ContactMemory = ContactMemoryOf<double>;

template <class Number>
struct ForceOnCornerOf {
    Number x{};  // on the corner's block, N/m; the other gets the opposite
    Number y{};
    Number moment{};        // N, about the centroid of the corner's block
    Number other_moment{};  // N, of the opposite force about the other's centroid
};

using ForceOnCorner = ForceOnCornerOf<double>;

// In the order of their pairs.
struct ContactList {
    LargeArray<RelaxationContact> contact = {};
    std::vector<ContactLaw> law = {};
    LargeArray<ContactMemory> memory = {};
    LargeArray<ForceOnCorner> force = {};  // when last evaluated
    // m; an open contact stays open while its blocks' ways since the start do not sum up to more. Negative: not open.
    LargeArray<double> open_until = {};

    const ContactLaw& law_of(const RelaxationContact& one) const { return law[one.law]; }
};

struct SearchOptions {
    double margin;
    double viscous_damping;
    // Joints that are closed in the drawing are whole: they have their peak strengths. Those that come about later, or
    // were open, have lost them.
    bool first;
    // Pairs that have none, in increasing order.
    std::span<const BlockPair> bonded = {};
};

// All contacts nearer than the margin, by a search of the whole scene. In an order that depends on positions alone.
// `previous` gives its memory to those that were contacts already. A run keeps its list up to date pair by pair
// (contact_watch.hpp).
ContactList find_contacts(const RelaxationScene& scene, const Bodies& bodies, const std::vector<Motion>& motion,
                          const std::vector<char>& removed, const SearchOptions& options, const ContactList& previous);

}  // namespace delabole
