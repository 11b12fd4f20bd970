// Criteria by which planes and lines allow a slope to slide or topple: geometry and friction alone, without cohesion,
// water or size.
//
// Conventions. "Feasible" is strict: at equality, within 1e-12 of a direction, no movement is feasible. The critical
// friction angle is the one below which the mechanism is feasible; 0 if geometry forbids it at any friction. Face,
// plane and friction lie within the ranges of kinematics/parameters.hpp; lateral limits are below 90 deg. All functions
// are exact to rounding.
//
// Planar sliding (Markland 1972; Hoek & Bray 1981). The block moves along the dip vector v of the joint.
//   daylight: v points out of the rock, v . n_face > 0, which is tan(dip) < tan(face dip) cos(plan angle);
//   surface:  -v points out of the ground behind the crest, v . n_upper < 0;
//   plan angle between the dip directions within the lateral limit; dip > friction angle.
//
// Wedge sliding (Markland 1972). The same criteria apply along the line of intersection, without a lateral limit. The
// condition plunge > friction angle is on the safe side, because two planes wedge the block in. The friction angle at
// which a dry cohesionless wedge really is in limiting equilibrium is given beside it (`limiting_friction_angle`).
//   The block and the planes that carry it follow from block theory (Goodman & Shi 1985). With i the line of
// intersection, plunging, n1, n2 the upward normals of the planes, f, u those of face and upper surface, the line
// leaves through the face and is cut off behind the crest if i . f > 0 and i . u < 0. The rock, x . f < 0 and
// x . u < 0, seen along i then fills the half-plane m . x < 0 with
//     m = f / (i . f) - u / (i . u),   m . i = 0,
// and the block on given sides of both planes, a sector s1 n1 . x >= 0, s2 n2 . x >= 0, is finite if it stays out of
// that half-plane, i.e. if m lies between s1 n1 and s2 n2. This holds for one choice of the sides,
//     s1 = sign of (m x n2) . (n1 x n2),   s2 = sign of (n1 x m) . (n1 x n2):
// one finite block for every line that leaves, above both planes or above one and below the other. It moves down plane
// 1 alone if it lies above that plane and movement down it opens the other, s1 > 0 and s2 v1 . n2 > 0; down plane 2
// under the corresponding conditions; otherwise along both. A finite block that moves away from its planes meets no
// rock, so that no further condition is needed.
//   For a level upper surface this is the test of Hocking (1976): if the dip direction of one plane lies, in plan,
// between the trend of the intersection and the dip direction of the face, the wedge slides on that plane alone; if
// both dip directions lie there, it slides on the plane whose dip direction is nearer to that of the face. With a
// sloping surface another of the four blocks may be the finite one.
//   The rock is taken to be convex at the crest: an upper surface steeper than the face is outside the model.
//
// Flexural toppling (Goodman & Bray 1976). Near the face the principal stress is parallel to it; layers slip over one
// another if that stress is inclined to their normal by more than the friction angle. In the section across the face
// layers dip into the slope by an apparent dip d', and their normal plunges 90 deg - d' out of it, so that
//     face dip - (90 deg - d') > friction angle,   tan(90 deg - d') = tan(90 deg - d) / cos(plan angle),
// with the plan angle between the normal's trend and the dip direction of the face, within the lateral limit. At plan
// angle 0 this is Goodman & Bray's formula; otherwise it is the slip-limit plane of Goodman (1980).
//
// Direct toppling (Goodman & Bray 1976; regions after Hudson & Harrison 1997, ch. 18). Two sets cut columns whose axis
// is their line of intersection, a third set gives them bases. The axis
//   - plunges into the slope within the lateral limit, and makes less than 90 deg with the face: plunge > 90 deg - face
//     dip; or
//   - plunges into the slope in any direction and is nearer to vertical than the friction angle (oblique toppling).
// A column whose axis plunges out of the slope leans back on the rock behind it and does not topple.
// The base
//   - dips out of the slope within the lateral limit and daylights; or
//   - dips less than the friction angle, in any direction.
// These two regions of friction are the convention of the overlays, not a result of statics: they show where a column
// can lose its base, not whether it does.
#pragma once

#include "kinematics/orientation.hpp"
#include "kinematics/parameters.hpp"

namespace delabole {

enum class Feasibility {
    feasible,
    planes_parallel,             // no line of intersection
    does_not_daylight,           // the movement points into the rock below the face
    does_not_surface,            // the plane or line never reaches the ground behind the crest
    outside_lateral_limit,       // points too far aside from the face
    flatter_than_friction,       // planar and wedge sliding; takes precedence for a level plane or line, which has no
                                 // direction to slide
    does_not_dip_into_slope,     // toppling: layers or columns lean the other way
    too_flat_to_topple,          // columns lie at 90 deg or more to the face
    no_slip_between_layers,      // flexural toppling: friction holds the layers together
    base_steeper_than_friction,  // direct toppling: a base that dips into the slope or aside, too steep for a column to
                                 // rest on
    no_base_plane,               // direct toppling: columns, but no set for their bases
};

struct FeasibilityVerdict {
    Feasibility feasibility;
    double critical_friction_angle;
};

FeasibilityVerdict planar_sliding(const SlopeOrientation& slope, const Orientation& plane, double friction_angle,
                                  double lateral_limit);

enum class SlidingContact { none, both_planes, first_plane, second_plane };

struct WedgeVerdict {
    Feasibility feasibility;
    SlidingContact contact;          // none if geometry forbids sliding
    double critical_friction_angle;  // by Markland's criterion
    double limiting_friction_angle;  // of a dry cohesionless wedge; 0 if geometry forbids sliding
};

WedgeVerdict wedge_sliding(const SlopeOrientation& slope, const Orientation& first, const Orientation& second,
                           double friction_angle);

FeasibilityVerdict flexural_toppling(const SlopeOrientation& slope, const Orientation& layers, double friction_angle,
                                     double lateral_limit);

// The two conditions of direct toppling.
Feasibility toppling_axis(const SlopeOrientation& slope, const LineOrientation& axis, double friction_angle,
                          double lateral_limit);
Feasibility toppling_base(const SlopeOrientation& slope, const Orientation& base, double friction_angle,
                          double lateral_limit);

}  // namespace delabole
