// What a corner on a corner holds.
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
//   - the one that the blocks overlap less over (least penetration, as for the first entrance of a corner in Shi's
//     discontinuous deformation analysis). A wedge of overlap counts as far as both depths d1 and d2 allow: the weight
//     of the contact over edge 1 is d2 / (2 l), l being the distance over which weights change (pair_search.cpp), so
//     that its spring holds k d1^2 d2 / (4 l).
//     Where the depths are equal both edges hold the same: nothing is gained where the blocks change from one to the
//     other. The corner is as good as rounded by a thousandth of the blocks' shortest edge. Corners that only pass each
//     other, as those of crossing joints do where columns slide on each other, catch by no more than the force that
//     presses the columns together times d / (2 l), some millionths of it;
//   - a body is in equilibrium if the work of its forces is not positive for any motion that is possible. Here that
//     asks for equilibrium with n1 alone and with n2 alone: what only one of them holds can give way to the other side.
//     So a balance that relies on corners on corners is believed once balance has been found with the other edges, too:
//     all of them are exchanged at once, in a trial. Of three edges in a corner two may bear, squeezing a tip: the one
//     that holds more gives way, in whatever order blocks and corners are numbered. In a trial the edge stays the other
//     one until it is more than 64 times as deep: then the blocks are beside each other rather than corner on corner.
//     (A tip of 1 deg that slides down a plane comes 57 times as deep below level ground as the ground's corner comes
//     below its face.) Balance in the trial puts back what was before it.
//
// Edges whose normals differ by less than 20 deg count as one face, lying on that of the other block: their weights add
// up to one at the corner, and both bear. What is free to give way to either side of such a corner is held there by
// friction angles above half that difference. Of the 2^n choices at n corners two are gone through.
//
// That both edges hold the blocks does not make them safe. With three edges in a corner, as of a wedge whose tip stands
// in the corner between a plane and the level ground in front of it, there may be nowhere to go, whatever the friction:
// a rigid point holds anything. A real one does not. UDEC rounds corners; a corner with a radius r that stands on
// another bears on an area of about r, under a stress that no rock stands where r is small, and what has crushed or
// chipped holds no more than the faces do. How far it is to that is no property of rigid blocks. So a state is in
// equilibrium here only if the faces alone can hold it: forces within the strength of faces that lie on each other, and
// of corners within edges, which have one normal, have to exist (limit_equilibrium/bound/lp_bound.hpp,
// `least_imbalance`). What stands without them is held by corners, which is neither equilibrium nor failure
// (RelaxationOutcome). Measured on 200 random jointed slopes: of 95 that come to rest 21 are held by corners, one of
// them on a plane that dips 53 deg at a friction of 20 deg.
//
// Sources: Moreau, J. J. (1988) Unilateral contact and dry friction in finite freedom dynamics, in: Nonsmooth mechanics
// and applications, CISM 302, 1-82 (virtual work over the cone of possible velocities); Shi, G.-H. (1988) Discontinuous
// deformation analysis, University of California, Berkeley (first entrance, angle on angle); Feng, Y. T. & Owen, D. R.
// J. (2004) A 2D polygon/polygon contact model: algorithmic aspects. Eng. Comput. 21, 265-277 (why the normal of corner
// on corner needs a rule of its own).
#pragma once

#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"

#include <cstdint>
#include <vector>

namespace delabole {

// cosine; normals that differ by more belong to edges of which only one bears
constexpr double one_face = 0.937;

struct CornerMotion {
    const Bodies& bodies;
    const std::vector<Motion>& motion;
};

// Whether the corner is within a hundredth of the smaller block's radius of an end of its edge at which the blocks
// could bear over another edge as well: before the onset of failure blocks move no farther.
bool is_on_corner(const Bodies& bodies, const ContactLaw& law, const RelaxationContact& contact,
                  const ContactPosition& at);

// Whether any corner on a corner is relied on, by a force above a thousandth of the weight of the lighter of the two
// blocks. `weight`: as below.
bool relies_on_corners(const CornerMotion& blocks, const std::vector<double>& weight, const ContactList& list);

// Begins a trial: exchanges the edge that bears at all corners on corners where that has not been tried and where the
// blocks rely on it, which they do on a force above a thousandth of the weight of the lighter of the two. `weight`:
// N/m, of each block; infinite where it is held. Returns the blocks concerned that are not, in increasing order; none:
// whatever bears has been tried. Elastic energy that comes or goes is booked with the contacts' friction.
std::vector<std::uint32_t> try_other_edges(const CornerMotion& blocks, const std::vector<double>& weight,
                                           ContactList& list);
// Ends the trial, in which balance has been found. Returns the blocks concerned, likewise; none: there was no trial.
std::vector<std::uint32_t> end_trial(const CornerMotion& blocks, ContactList& list);
// The trial that began with `memory`, and has marked there what it tries, has ended well.
void note_tried(const MemoryArray& in_trial, MemoryArray& memory);
// Loads change: all has to be tried again.
void forget_tried(MemoryArray& memory);

}  // namespace delabole
