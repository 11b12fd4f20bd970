// The corners that can touch edges before the next search, and what each such contact remembers.
//
// Contact memory belongs to a corner and an edge. Where a corner passes the end of an edge, the edge's end corner takes
// over on an edge of the first block (its twin): both are contacts, their weights add up to one and change over a short
// distance around the end, and the shear spring is handed over. The overlap of one face is never compared with that of
// another; such a comparison is what made the thesis's program diverge (5.3.2, cycle 677).
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/blocks/neighbours.hpp"
#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/wide/large_array.hpp"
#include "dynamic_relaxation/wide/packed_array.hpp"
#include "numerics/lanes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace delabole {

constexpr double not_open = -1;
constexpr std::uint32_t no_twin = static_cast<std::uint32_t>(-1);

struct ContactRange {
    std::size_t begin;
    std::size_t end;

    std::size_t size() const { return end - begin; }
};

// How an edge bears as a corner of another block comes over its ends. Many contacts share it, so that a step has less
// to read: a pack of bricks has only a few. It is read as rows of eight numbers.
template <class Number>
struct alignas(8 * sizeof(double)) EdgeEndsOf {
    Number start_weight;  // weight of the contact where the corner is at the edge's start
    Number end_weight;
    Number inverse_blend;  // 1 / length over which the weight changes
    // The rival edge; the less deep one of the two bears. 1 or -1: the edge beyond this edge's start or end, on which
    // the corner could also bear. 2 or -2: an edge of the corner's block, on which that end could bear. 0: no rival.
    Number rival;
    // If there is a rival: sine of the interior angle between the two edges in the initial geometry. If there is none
    // and a tip stands on a bend, bearing on this edge alone, or a corner on an edge from which its face gapes: sine of
    // that angle, negative at the edge's end. Otherwise 0.
    Number rival_sine;
    Number rival_cosine;
    // 1 if only one of the two may bear at a time; 2 if, moreover, no other edge of the block may bear at that end, and
    // the rival is the edge of the corner's own block on which the edge's end may bear (corner_choice.hpp); otherwise
    // 0.
    Number alone;
    Number unused;  // fills the row

    bool operator==(const EdgeEndsOf&) const = default;
};

// Strength and stiffness of a contact, shared by even more contacts.
template <class Number>
struct alignas(8 * sizeof(double)) JointLawOf {
    Number normal_stiffness;
    Number shear_stiffness;
    Number normal_dashpot;
    Number shear_dashpot;
    Number friction;           // tangent of the peak angle
    Number residual_friction;  // tangent of the residual angle
    Number cohesion;           // N/m, over half the shared length
    Number residual_cohesion;  // N/m, likewise

    bool operator==(const JointLawOf&) const = default;
};

template <class Number>
struct ContactLawOf : EdgeEndsOf<Number>, JointLawOf<Number> {
    bool operator==(const ContactLawOf&) const = default;
};

using EdgeEnds = EdgeEndsOf<double>;
using JointLaw = JointLawOf<double>;
using ContactLaw = ContactLawOf<double>;

// The place of a contact in the initial geometry.
template <class Number>
struct ContactShapeOf {
    Number arm_x{};  // of the corner, about its block's centroid
    Number arm_y{};
    Number other_arm_x{};  // of the corner, about the other block's centroid
    Number other_arm_y{};
    Number along_x{};  // of the edge
    Number along_y{};
    Number gap{};         // from the edge to the corner, where the pair's outline is shifted after the shift
    Number from_start{};  // of the edge to the corner, along the edge
    Number to_end{};      // from the corner to the edge's end, along the edge
};

// Numbers of each contact that every step reads.
struct ContactBlocks {
    std::uint32_t block;  // of the corner
    std::uint32_t other;  // of the edge
    std::uint32_t twin;
    std::uint32_t ends;   // in the list's ends
    std::uint32_t joint;  // in the list's joints

    BlockPair pair() const { return {block < other ? block : other, block < other ? other : block}; }
};

struct ContactCorner {
    std::uint32_t corner;
    std::uint32_t edge;
};

struct RelaxationContact : ContactBlocks, ContactCorner, ContactShapeOf<double> {
    double edge_length() const { return from_start + to_end; }
};

template <class Number>
struct ContactNumbersOf {
    Number shear{};        // displacement of the shear spring, along the edge
    Number place{};        // of the corner along the edge when last evaluated, since the initial geometry
    Number damping{};      // J/m, dissipated so far
    Number normal_drag{};  // N/m, force of the dashpots when last evaluated, along the normal
    Number shear_drag{};   // N/m, along the edge
    // These change only where a contact slides or begins to touch.
    Number slip{};      // plastic displacement along the edge since it was last recorded (outcome.hpp)
    Number friction{};  // J/m, dissipated so far
};

template <class Flag>
struct ContactFlagsOf {
    Flag touching{};
    Flag sliding{};
    Flag broken{};  // peak friction and cohesion are gone
    // The corner is below the line of the edge without having crossed the edge, for instance past its end: it does not
    // overlap this edge and cannot bear on it until it has been above its line.
    Flag beneath{};
    // For corners on corners (corner_choice.hpp):
    Flag yields{};   // does not bear in a trial
    Flag insists{};  // bears in a trial although it is the deeper one
    Flag tried{};    // the balance without it has been tried
};

template <class Number>
struct ContactMemoryOf : ContactNumbersOf<Number>, ContactFlagsOf<MaskOf<Number>> {};

using ContactMemory = ContactMemoryOf<double>;

template <class Number>
struct ForceOnCornerOf {
    Number x{};  // on the corner's block, N/m; the other gets the opposite
    Number y{};
    Number moment{};        // N, about the centroid of the corner's block
    Number other_moment{};  // N, of the opposite force about the other's centroid

    BlockForceOf<Number> on_block() const { return {x, y, moment}; }
    BlockForceOf<Number> on_other() const { return {-x, -y, other_moment}; }
};

using ForceOnCorner = ForceOnCornerOf<double>;

class ContactArray {
  public:
    std::size_t size() const { return blocks_.size(); }
    bool empty() const { return blocks_.empty(); }
    RelaxationContact operator[](std::size_t index) const { return {blocks_[index], corners_[index], shapes_[index]}; }
    void push_back(const RelaxationContact& contact) {
        shapes_.push_back(size(), contact);
        blocks_.push_back(contact);
        corners_.push_back(contact);
    }
    void reserve(std::size_t count) {
        blocks_.reserve(count);
        corners_.reserve(count);
        shapes_.reserve(count);
    }

    std::span<ContactBlocks> blocks() { return blocks_; }
    std::span<const ContactBlocks> blocks() const { return blocks_; }
    std::span<const ContactCorner> corners() const { return corners_; }
    const ContactShapeOf<NumberGroup>* shapes() const { return shapes_.groups(); }

  private:
    LargeArray<ContactBlocks> blocks_ = {};
    LargeArray<ContactCorner> corners_ = {};
    PackedArray<ContactShapeOf, NumberGroup> shapes_ = {};
};

class MemoryArray {
  public:
    std::size_t size() const { return size_; }
    ContactMemory operator[](std::size_t index) const { return {numbers_[index], flags_[index]}; }
    void set(std::size_t index, const ContactMemory& memory) {
        numbers_.set(index, memory);
        flags_.set(index, memory);
    }
    void push_back(const ContactMemory& memory) {
        numbers_.push_back(size_, memory);
        flags_.push_back(size_, memory);
        ++size_;
    }
    void reserve(std::size_t count) {
        numbers_.reserve(count);
        flags_.reserve(count);
    }

    ContactNumbersOf<NumberGroup>* numbers() { return numbers_.groups(); }
    ContactFlagsOf<FlagGroup>* flags() { return flags_.groups(); }

  private:
    PackedArray<ContactNumbersOf, NumberGroup> numbers_ = {};
    PackedArray<ContactFlagsOf, FlagGroup> flags_ = {};
    std::size_t size_ = 0;
};

// Contacts in the order of their pairs.
struct ContactList {
    ContactArray contact = {};
    std::vector<EdgeEnds> ends = {};
    std::vector<JointLaw> joint = {};
    MemoryArray memory = {};
    LargeArray<ForceOnCorner> force = {};  // when last evaluated
    // m; an open contact stays open until the sum of what its blocks have travelled since the start exceeds this.
    // not_open if it touches.
    LargeArray<double> open_until = {};

    ContactLaw law_of(const ContactBlocks& one) const { return {ends[one.ends], joint[one.joint]}; }
};

// Displacement, in the initial geometry, of the outline of a pair's block with the lower number, on which the pair's
// contacts are based: it closes a joint that was drawn slightly open, and keeps the permanent shortening of the rock
// between the two blocks (bonds.hpp). It moves with the block.
struct OutlineShift {
    double x = 0;      // m, of the centroid
    double y = 0;      // m
    double angle = 0;  // rad, small

    bool operator==(const OutlineShift&) const = default;
};

struct ShiftedPair {
    BlockPair pair;
    OutlineShift shift;
};

// The shift of the face's lower block that displaces its outline by these amounts, m, where the shared length starts
// and ends along the other's edge, in the direction of the edge's outward normal.
OutlineShift outline_shift(const SharedFace& face, const std::array<double, 2>& displaced);

// Shifts that close the longest face of each pair whose closed joint is open or overlaps in the initial geometry by
// more than rounding of the calculation, in increasing order of the pairs. Pairs in which that would open another face
// or make it overlap have none.
std::vector<ShiftedPair> closing_shifts(const Bodies& bodies);

// Raises the reach within which the neighbours of blocks with a shifted outline are found to the opening of a closed
// joint: the shift brings an outline nearer by no more.
void reach_as_shifted(const Bodies& bodies, std::span<const ShiftedPair> shifted, std::vector<double>& reach);

// Shift of a pair. `shifted`: pairs that have one, in increasing order.
OutlineShift shift_of(const BlockPair& pair, std::span<const ShiftedPair> shifted);

struct SearchOptions {
    double margin;
    double viscous_damping;
    // Joints that are closed in the initial geometry have their peak strengths. Joints that were open, or that close
    // later, have lost them.
    bool first;
    // Pairs held by bonds, which therefore have no contacts, in increasing order.
    std::span<const BlockPair> bonded = {};
    std::span<const ShiftedPair> shifted = {};  // in increasing order
};

// Finds all contacts nearer than the margin by a search of the whole scene. Their order depends on positions alone.
// Those that were contacts already take over their memory from `previous`. A run keeps its list up to date pair by pair
// (contact_watch.hpp).
ContactList find_contacts(const RelaxationScene& scene, const Bodies& bodies, const std::vector<Motion>& motion,
                          const std::vector<char>& removed, const SearchOptions& options, const ContactList& previous);

}  // namespace delabole
