// Contacts of a corner on a corner, and which of the two edges bears.
//
// Two convex blocks A and B touch where the point 0 lies on the outline of the set B - A of all differences of their
// points: it is convex, and its edges are those of B (a corner of A on an edge of B) and those of A (a corner of B on
// an edge of A), in the order of their normals. A contact of a corner on a corner is a corner of this outline. Its
// normals, the common cone of both corners' normals, lie between the normals n1 and n2 of the two edges that meet
// there, and no other normal could keep the blocks apart. Blocks overlap where they are beneath both edges, and A may
// move by v against B as long as
//     v.n1 >= 0  or  v.n2 >= 0.
// This is the union of two half-planes. If both edges bore, v.n1 >= 0 and v.n2 >= 0 would be required, which could
// resist in any direction between n1 and n2, even directly against a motion that is free to give way to either side. So
// only one of the two bears at a time:
//
//   - the one that the blocks overlap less over (least penetration, as for the first entrance of a corner in Shi's
//     discontinuous deformation analysis). The overlap counts as far as both depths d1 and d2 allow: the weight of the
//     contact over edge 1 is d2 / (2 l), l being the distance over which weights change (pair_search.cpp), so that its
//     spring has the energy k d1^2 d2 / (4 l).
//     Where the depths are equal both edges have the same energy: none is gained where the blocks change from one to
//     the other. The corner acts as if rounded by a thousandth of the blocks' shortest edge. Corners that only pass
//     each other, as those of crossing joints do where columns slide on each other, catch by no more than the force
//     that presses the columns together times d / (2 l), some millionths of it;
//   - a body is in equilibrium if the work of its forces is not positive for any motion that is possible. Here that
//     requires equilibrium with n1 alone and with n2 alone: a block held by only one of them can give way to the other
//     side. So blocks that rest on corners on corners have to rest with the other edges as well: all that bear are
//     exchanged at once, in a trial, and bear again once it has found equilibrium. In it the other edge bears until it
//     is more than 64 times as deep as its rival: then the blocks are beside each other rather than corner on corner.
//     (A tip of 1 deg that slides down a plane comes 57 times as deep below level ground as the ground's corner comes
//     below its face.) A trial pushes the blocks, by so much that in slopes of thousand blocks many go on moving:
//     blocks that faces hold are spared it, and so are those of searches, which have failed if faces do not hold them.
//
// Edges whose normals differ by less than 20 deg count as one face that lies on a face of the other block: their
// weights add up to one at the corner, and both bear. A block that is free to give way to either side of such a corner
// is held there by friction angles above half that difference; so a tip on it counts as a corner on a corner where it
// is asked whether faces alone hold the blocks; so does a corner at the end of an edge from which its face gapes. Of
// the 2^n choices at n corners only two are tried.
//
// The tips of thin wedges meet where several joints come out in one point. A tip whose faces dip into the block below
// an edge in the initial geometry lies on the other side of that block. It does not bear on this edge, on which it
// would hang.
//
// Blocks that both edges hold are not thereby safe. Where three edges meet in a corner, for instance at a wedge whose
// tip stands in the corner between a plane and the level ground in front of it, no motion may be possible, whatever the
// friction: a rigid point carries any load. A real one, of a radius r (UDEC rounds corners), bears on an area of about
// r, under a stress that no rock withstands where r is small, and once crushed or chipped it holds no more than the
// faces do; how near it is to that, rigid blocks cannot show. So a state counts as equilibrium here only if the faces
// alone hold it. Forces within the strength of faces that lie on each other, and of corners within edges, which have
// one normal, have to exist (`least_imbalance` in lp_bound.hpp). That they exist is no proof, because the joints do not
// dilate as they slip: so the blocks have to stay, too, when both edges give way at every corner on a corner, in a
// trial that ends at rest or past the thresholds of onset. (Columns that topple on a base which ends in the corner of
// level ground stand by forces up to a factor of 0.940; they fail at 0.772 where the ground is lower, and in this
// trial.) Otherwise corners hold it, which is neither equilibrium nor failure (RelaxationOutcome).
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
#include <set>
#include <utility>
#include <vector>

namespace delabole {

// cosine; of two edges whose normals differ by more, only one bears
constexpr double one_face = 0.937;
constexpr double least_bend = 0.02;  // sine; edges that bend, or faces that gape, by less are one face to statics, too

struct CornerMotion {
    const Bodies& bodies;
    const std::vector<Motion>& motion;
};

// Below, blocks rely on a contact of a corner on a corner if its force exceeds a thousandth of the weight of the
// lighter of the two. `weight`: N/m, of each block; infinite where it is held.

// Whether the corner is within a hundredth of the smaller block's radius of an end of its edge at which the blocks
// could bear over another edge as well: blocks move no farther than that before the onset of failure.
bool is_on_corner(const Bodies& bodies, const ContactLaw& law, const RelaxationContact& contact,
                  const ContactPosition& at);

// Whether blocks rely on any contact of a corner on a corner.
bool relies_on_corners(const CornerMotion& blocks, const std::vector<double>& weight, const ContactList& list);

// Begins a trial: exchanges the edge that bears at all corners on which blocks rely where that has not been tried.
// Returns the blocks concerned that are not held, in increasing order; empty if every bearing edge has been tried.
// Elastic energy gained or lost is counted with the contacts' friction.
std::vector<std::uint32_t> try_other_edges(const CornerMotion& blocks, const std::vector<double>& weight,
                                           ContactList& list);
// Ends a trial in which balance was found and returns the free blocks whose contacts it changed; empty if no trial was
// under way.
std::vector<std::uint32_t> end_trial(const CornerMotion& blocks, ContactList& list);
// Takes both edges away wherever blocks rely on a corner, until they are beside each other. Returns whether there was
// any that is not among those that have given way before, to which it is added: corners and edges of contacts.
bool give_way_at_corners(const CornerMotion& blocks, const std::vector<double>& weight, ContactList& list,
                         std::set<std::pair<std::uint32_t, std::uint32_t>>& before);
// Records as tried the edges that a successful trial, which began with `memory`, has marked.
void note_tried(const MemoryArray& in_trial, MemoryArray& memory);
// Clears these records after a change of loads: all edges have to be tried again.
void forget_tried(MemoryArray& memory);

}  // namespace delabole
