// Rows of equal bolts, and the force of each row per metre of slope.
//
// A bolt runs from its head on the face through the sliding surface into stable rock. Its force where it crosses that
// surface is the least of
//     capacity                              of the bar or strand,
//     bond strength (length - l)            by which the grout behind the surface holds it (pullout),
//     plate capacity + bond strength l      by which plate and grout in front of it hold the rock (stripping),
// l being the length from the head to the surface; a bolt without grout is anchored at its end and has its full
// capacity wherever that end is in stable rock. What lies behind the point at which the bolt comes out of the ground
// holds nothing. The force divided by the spacing along the slope is the force per metre run that limit equilibrium
// uses (Hoek & Bray 1981; Wyllie & Mah 2004, 7.4 and 12.4; the force diagram is that of grouted bolts in common slope
// programs).
//
// Limits: the bolt carries tension alone, not shear, and whole rows act together: all sections of the slope are alike.
#pragma once

#include "geometry/polyline.hpp"
#include "parameters/fields.hpp"
#include "parameters/lengths.hpp"

#include <optional>

namespace delabole {

enum class BoltAction { active, passive };

template <class T = double>
struct Grout {
    T bond_strength;
    T plate_capacity;
    static constexpr auto fields() {
        return FieldTable{
            number<&Grout::bond_strength>(Dimension::force_per_length, more_than(0),
                                          "force that a metre of grouted bolt passes on to the rock"),
            number<&Grout::plate_capacity>(Dimension::force, at_least(0), "force that the plate at the head bears")};
    }
};

template <class T = double>
struct BoltPattern {
    T rows;
    T lowest_height;
    T row_spacing;
    T spacing;
    T length;
    T plunge;
    T capacity;
    std::optional<Grout<T>> grout;
    static constexpr auto fields() {
        return FieldTable{
            number<&BoltPattern::rows>(within(1, 1000), "number of rows, a whole one"),
            number<&BoltPattern::lowest_height>(Dimension::length, distance_range(),
                                                "height of the lowest row's heads on the face above the toe"),
            number<&BoltPattern::row_spacing>(Dimension::length, extent_range(), "vertical, from row to row"),
            number<&BoltPattern::spacing>(Dimension::length, extent_range(), "along the slope, from bolt to bolt"),
            number<&BoltPattern::length>(Dimension::length, extent_range(), "of a bolt, from its head to its end"),
            number<&BoltPattern::plunge>(Dimension::angle, within(degrees(-90), degrees(90)),
                                         "direction below the horizontal, into the slope; negative: inclined upwards"),
            number<&BoltPattern::capacity>(Dimension::force, at_least(0), "tension that a bolt bears"),
            section<&BoltPattern::grout>("along the whole bolt; absent: the bolt is anchored at its end alone")};
    }

    // Rows are numbered from 0, the lowest.
    T head_height(int row) const { return T(lowest_height + T(row) * row_spacing); }
};

// Force, N, of a bolt that crosses the sliding surface so far from its head.
template <class T>
T force_of_bolt(const T& capacity, const std::optional<Grout<T>>& grout, const T& length,
                const T& length_in_moving_rock) {
    T force = capacity;
    if (grout) {
        const T pullout = grout->bond_strength * (length - length_in_moving_rock);
        const T stripping = grout->plate_capacity + grout->bond_strength * length_in_moving_rock;
        force = pullout < force ? pullout : force;
        force = stripping < force ? stripping : force;
    }
    return force;
}

// Force, N/m, of a row whose bolts have that length in the moving rock, and come out of the ground behind the crest
// after a length `in_ground`, infinite if they do not. Nothing if they do not cross the sliding surface, for which the
// first length is negative, if they come out of the ground before it, or, without grout, if they end in the air.
template <class T>
T force_of_row(const BoltPattern<T>& pattern, const T& length_in_moving_rock, const T& in_ground) {
    const bool ends_in_air = in_ground < pattern.length;
    const T& length = ends_in_air ? in_ground : pattern.length;
    if (!(length_in_moving_rock >= 0) || !(length - length_in_moving_rock > 0) || (ends_in_air && !pattern.grout)) {
        return T(0);
    }
    return T(force_of_bolt(pattern.capacity, pattern.grout, length, length_in_moving_rock) / pattern.spacing);
}

// One row on a given slope.
struct BoltRow {
    Point head;
    double force;  // N/m
};

}  // namespace delabole
