// Which edge bears where a corner meets a corner.
//
// Two convex blocks A and B touch where the point 0 lies on the outline of the set B - A of all differences of their
// points: it is convex, and its edges are those of B (a corner of A on an edge of B) and those of A (a corner of B on
// an edge of A), in the order of their normals. Corner on corner is a corner of this outline. Its normals, the common
// cone of both corners' normals, lie between the normals n1 and n2 of the two edges that meet there, and they are all
// that could keep the blocks apart. Blocks overlap where they are beneath both edges, and A may move by v against B as
// long as
//     v.n1 >= 0  or  v.n2 >= 0.
// That is the union of two half-planes, not one: whoever lets both edges bear demands v.n1 >= 0 and v.n2 >= 0, and can
// resist in any direction between n1 and n2, among them straight against a motion that is free to give way to either
// side. At a time one of the two bears, then:
//
//   - which one is remembered: as long as the blocks overlap there, it stays the one over which they met, until it is
//     deeper than the other by more than the way over which a corner's weight changes, or than twice the other's depth
//     (least penetration, as for the first entrance of a corner in Shi's discontinuous deformation analysis). Where the
//     corners coincide in the drawing and nothing has met yet, it is the steeper edge: what is above does not rest on
//     a point;
//   - a body is in equilibrium if the work of its forces is not positive for any motion that is possible. Here that
//     asks for equilibrium with n1 alone and with n2 alone: what only one of them holds can give way to the other side.
//     So a balance that relies on a corner on a corner is believed once balance has been found with the other edge,
//     too. Edges are exchanged wherever they bear, at all corners at a time: corners that hold a block together, as
//     those of crossing joints hold columns against sliding on each other, hide what each of them would give way to.
//
// Edges whose normals differ by less than 20 deg count as one face, lying on that of the other block: their weights add
// up to one at the corner, and both bear. What is free to give way to either side of such a corner is held there by
// friction angles above half that difference. Of the 2^n choices at n corners few are gone through.
//
// A wedge of the blocks' overlap counts as far as both depths allow, w = (depth of the other) / (twice the way of
// blending): the corner is as good as rounded by a thousandth of the blocks' shortest edge, and exchanging edges
// exchanges forces that are alike.
//
// Sources: Moreau, J. J. (1988) Unilateral contact and dry friction in finite freedom dynamics, in: Nonsmooth mechanics
// and applications, CISM 302, 1-82 (virtual work over the cone of possible velocities); Shi, G.-H. (1988) Discontinuous
// deformation analysis, University of California, Berkeley (first entrance, angle on angle); Feng, Y. T. & Owen, D. R.
// J. (2004) A 2D polygon/polygon contact model: algorithmic aspects. Eng. Comput. 21, 265-277 (why the normal of corner
// on corner needs a rule of its own).
#pragma once

#include "dynamic_relaxation/pair_search.hpp"

#include <span>
#include <vector>

namespace delabole {

// cosine; normals that differ by more belong to edges of which only one bears
constexpr double one_face = 0.937;

struct CornerMotion {
    const Bodies& bodies;
    const std::vector<Motion>& motion;
};

// Of each corner on a corner among a pair's contacts, all but those on one edge are made to yield. `is_new`: contacts
// that have no memory yet. `coincide`: m, corners drawn nearer than this coincide; 0 where the drawing does not matter
// any more. `up`: unit vector against gravity.
void choose_at_corners(const CornerMotion& blocks, const std::vector<char>& is_new, double coincide,
                       const PlanePoint<>& up, PairContacts& found);

// Exchanges the edge that bears at corners on corners where that has not been tried and where the blocks rely on it,
// which they do on a force above a thousandth of the weight of the lighter of the two. `weight`: N/m, of each block;
// infinite where it is held. Returns the blocks concerned that are not, in increasing order; none: whatever bears has
// been tried.
std::vector<std::uint32_t> exchange_at_corners(const CornerMotion& blocks, const std::vector<double>& weight,
                                               ContactList& list);
// Loads change: all has to be tried again.
void forget_tried(MemoryArray& memory);

}  // namespace delabole
