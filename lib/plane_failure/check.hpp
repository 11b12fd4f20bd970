// Reasons why a plane-failure model has no answer.
#pragma once

namespace delabole {

enum class PlaneFailureCheck {
    valid,
    plane_does_not_daylight,      // failure plane as steep as the face, or steeper
    plane_daylights_above_crest,  // daylight_height not below the crest
    plane_never_surfaces,         // no crack, and the ground behind the crest is as steep as the plane
    crack_flatter_than_plane,     // the crack does not rise from the plane
    crack_below_plane,            // the ground at the top of the crack, or in front of it, lies below the plane
    crack_base_below_daylight,    // the crack meets the plane below the point where it daylights
    crack_deeper_than_mass,       // nowhere behind the crest is the rock above the plane that deep
    crack_never_surfaces,         // the crack does not reach the ground from within the rock
    mass_vanishes,                // plane, crack and ground enclose no mass
    water_needs_crack,            // a form of water that fills a crack, but there is no crack
    water_above_crack,            // level above the top of the crack (or, on the base alone, above its upper end)
    water_points_not_increasing,  // piezometric line or custom pressures out of order, or a single point
    water_below_pond,             // pressure below the pond's at the daylighting point or at the bottom of the crack
    pond_above_crest,
    elevation_without_datum,    // an elevation is given but slope.toe_elevation is not
    friction_not_below_90_deg,  // friction_angle + roughness_angle
    bolt_head_above_crest,
    input_out_of_range,  // a number outside the range of its field, not finite, or so large that forces overflow
};

// `face`: the crack opens in front of the crest, so that the crest stays outside the mass.
enum class CrackLocation { none, face, bench, upper_surface };

}  // namespace delabole
