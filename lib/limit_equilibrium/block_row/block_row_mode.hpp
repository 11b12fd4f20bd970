// Modes of motion of a row of blocks, and their equations.
//
// A mode gives every block a role, from the lowest block up:
//     S...  slide together down the plane, by their own weight or pushed by the blocks above
//     F, P, B, =  turn forward, all by the same angle, each about its own toe: the toe slides forward (F), does not
//           slide (P), slides backward (B); "=" adheres to the block below and turns as one unit with it
//     0...  stand while the part below moves away from them; if all toes of the turning part are F, they press on its
//           heel
//     R...  are pushed back up the plane by the heel of the turning part
//
// Reason for this order. Blocks that turn by the same angle w keep their faces in contact; the distance of two faces is
// the width b of the block between them, that of their toes along the plane therefore b / cos(w): toes move apart. Of
// two neighbouring toes the lower one moves forward relative to the upper, so that F is below P and P below B, with at
// most one P. A row of N has N modes F..FPB..B and N - 1 modes F..FB..B: three for two blocks (thesis eqs. 7, 10, 11),
// five for three, seven for four, which are the counts of the lost Fig 4.9. Backward turning about a heel never occurs:
// thrust from above acts forward, its friction passes through the heel, and for a tilt >= 0 gravity also acts against
// it.
//
// Statics. T = W sin(tilt), N = W cos(tilt), X = (a T - b N) / 2 the overturning moment about the toe, c and mu the
// friction of base and upper interface, S the thrust in that interface at height l; a turning block rises against its
// upper neighbour, so that the whole shear mu S acts down on it. For block i
//     R = N + mu S - mu' S',   Q = T + S - S',   X + S l - b mu S - S' l' = 0       (primes: interface below)
//     F:  Q =  c R:   S  (1 - c mu)  = c N - T + S' (1 - c mu')        from below
//     B:  Q = -c R:   S' (1 + c mu') = c N + T + S  (1 + c mu)         from above
// Summed over the turning blocks the l cancel except for the lowest, h S', where sliding blocks are pushed at their top
// corner (Goodman & Bray's contact); without such blocks that term is zero:
//     sum X = h S' + sum b mu S
// Every term is linear in sin and cos of the tilt: tan(tilt) in closed form for any number of unequal blocks.
//
// F..FB..B lacks the pivot's shear as an unknown. If sum X is closed with S from below, the tilt is that of F..FPB..B
// with P in the lowest B's place; closed from above, it is that with P in the highest F's place; equality of both S
// gives a third tilt, which does not depend on the block dimensions (eqs. 11, 17). The three agree only where the two
// neighbouring modes with a pivot change over. The mode is reported as over-determined, never as the answer.
//
// Forward sliding under thrust needs 1 - c mu > 0, phi + psi < 90 deg: beyond that the thrust with its friction lies
// within the friction cone of the base and no thrust can move the block ("locked").
//
// Thrust S from above on the heel of the uppermost turning block (l = 0) holds that block by its shear mu S alone:
//     sum X = h S' + sum b mu S, the uppermost interface included
// It is limited by what the turning toes bear (F..F0..) or by what the blocks above bear (..R..). The heel of a turning
// block recedes; only if the toes below drive it back farther than that is R a motion. Otherwise both are limits of
// pressed blocks: up to these tilts the blocks can hold one another; beyond them, or once the blocks have separated,
// they cannot.
//
// Blocks that slide together do not slip on each other; their interfaces are taken as smooth. With one pushed block, or
// with the same friction under all of them, this choice does not affect the tilt.
#pragma once

#include <vector>

namespace delabole {

enum class RowModeCheck {
    admissible,
    no_tilt,                   // no tilt below 90 deg satisfies the equation
    locked,                    // phi + psi >= 90 deg where a block would be pushed forward
    over_determined,           // one unknown too few
    tension,                   // between blocks
    base_lifts,                // equilibrium requires the plane to pull
    pivot_slips,               // the pivot's shear exceeds its friction
    thrust_outside_interface,  // the point of application lies below or above the contact
    sliding_block_overturns,   // no reaction within the base of a block that slides
    adhering_blocks_slip,
    blocked_by_standing_block,  // the heel of the uppermost turning block meets its neighbour
    standing_blocks_fail,       // the part that is to stand fails first, or is too long to be checked
};

// Roles as letters, one per block, the lowest first: "SFPB0".
namespace row_role {
inline constexpr char slides = 'S';
inline constexpr char forward = 'F';
inline constexpr char pivot = 'P';
inline constexpr char backward = 'B';
inline constexpr char adheres = '=';
inline constexpr char stands = '0';
inline constexpr char retreats = 'R';
}  // namespace row_role

template <class T>
struct RowMember {
    T height;
    T width;
    T weight;
    T base_friction;       // tangents
    T interface_friction;  // with the block above
    T contact;             // height of the contact with the block above
};

// The forces on one block, per metre run.
template <class T>
struct MemberForces {
    T thrust;         // S, in the interface above
    T thrust_moment;  // S l
    T shear;          // in that interface, down on this block
    T normal_force;   // R, of the plane
    T base_shear;     // Q, of the plane, up-dip positive
    T base_moment;    // R times its distance from the toe
};

template <class T>
struct RowMode {
    RowModeCheck check = RowModeCheck::no_tilt;
    bool pressed = false;  // not a motion but the limit of what pressing the blocks together can hold
    T tangent{};           // of the tilt; 0 if there is none
    T second_tangent{};    // over-determined modes: of the tilt at which both thrusts agree, 0 if there is none
    std::vector<MemberForces<T>> forces{};  // at `tangent`, blocks of the (sub-)row; empty without a tilt
};

}  // namespace delabole
