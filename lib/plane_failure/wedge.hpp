// Geometry of the sliding mass: the polygon between failure plane, tension crack and ground.
//
// Coordinates start where the plane daylights. A ground point at horizontal distance x lies `above` the plane by a
// vertical height; along a ground segment of dip s this height grows at sin(s - p) / (cos s cos p) per metre, p the
// plane's dip. This form, unlike a difference of elevations, keeps full relative precision when plane and face are
// nearly parallel; the difference of cotangents in the printed formulas loses digits there in proportion to the small
// angle between them. The area is a sum of positive trapezoids of vertical thickness, for the same reason.
//
// Accuracy: area, base length and crack depth are accurate to a few units in the last place of their inputs, except if
// a crack given by its distance ends near the line along which the plane meets the ground: its depth is then a
// difference of the two, and loses digits in proportion (depth / height). The area does not.
//
// Everything here is a template over the scalar: double, the dual numbers of sensitivity.cpp, and 50-digit numbers in
// tests.
#pragma once

#include "plane_failure/check.hpp"
#include "plane_failure/parameters.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace delabole {

template <class T>
struct SineCosine {
    T sine;
    T cosine;
};

template <class T>
inline SineCosine<T> sine_cosine(const T& angle) {
    using std::cos;
    using std::sin;
    return {T(sin(angle)), T(cos(angle))};
}

// The two angles of most scenes, those of level ground and vertical cracks, need no call of the mathematical library.
template <>
inline SineCosine<double> sine_cosine(const double& angle) {
    if (angle == 0) {
        return {0, 1};
    }
    if (angle == std::numbers::pi / 2) {
        return {1, 6.123233995736766e-17};  // cos of the double nearest to pi / 2
    }
    return {std::sin(angle), std::cos(angle)};
}

// sin(a - b). The product form costs two multiplications; if it would lose digits the angles are subtracted first,
// which is exact for nearby angles.
template <class T>
inline T sine_of_difference(const T& a, const SineCosine<T>& of_a, const T& b, const SineCosine<T>& of_b) {
    using std::sin;
    const T product = of_a.sine * of_b.cosine - of_a.cosine * of_b.sine;
    if (product > 0.05 || product < -0.05) {
        return product;
    }
    const T difference = a - b;
    return T(sin(difference));
}

// Vertical thickness of the sliding mass at a horizontal distance from the daylighting point.
template <class T>
struct Station {
    T x;
    T ground;  // height of the ground above the plane
    T floor;   // height of the crack line above the plane, 0 over the failure plane itself
};

template <class T>
struct Wedge {
    CrackLocation crack_location;
    SineCosine<T> face;
    SineCosine<T> plane;
    SineCosine<T> crack;
    T plane_secant;  // 1 / cos(plane dip), by which most heights above the plane are multiplied
    T sine_face_minus_plane;
    T sine_crack_minus_plane;  // 1 if there is no crack
    T daylight_height;         // of the plane above the toe
    T crest_x;                 // from the daylighting point
    T crest_height;            // of the crest above the daylighting point
    T base_top_x;              // end of the plane, at the crack or at the ground
    T base_length;
    T crack_top_x;
    T crack_length;  // along the crack; 0 without a crack
    T area;
    std::array<Station<T>, 5> stations;
    std::size_t station_count;

    T base_top_height() const { return base_length * plane.sine; }  // above the daylighting point
    T crack_depth() const { return crack_length * crack.sine; }     // vertical
};

namespace detail {

// A segment of ground that begins at a node and goes into the slope at a dip. `above` is the height of the node above
// the plane.
template <class T>
struct GroundSegment {
    T x;
    T above;
    T angle;
    SineCosine<T> dip;  // of `angle`
    T rate;             // of growth of the height above the plane with x
    CrackLocation location;
};

template <class T>
struct Ground {
    std::array<GroundSegment<T>, 2> segments;  // behind the crest
    std::size_t count = 0;
};

template <class T>
void set_ground_behind_crest(Ground<T>& ground, const SlopeSection<T>& slope, const T& plane_dip,
                             const SineCosine<T>& plane, const T& plane_secant, const T& crest_x,
                             const T& crest_above) {
    const auto rate = [&](const T& angle, const SineCosine<T>& dip) {
        return T(sine_of_difference(angle, dip, plane_dip, plane) * plane_secant / dip.cosine);
    };
    T x = crest_x;
    T above = crest_above;
    if (slope.bench) {
        const SineCosine<T> dip = sine_cosine(slope.bench->dip);
        GroundSegment<T>& bench = ground.segments[ground.count++];
        bench = {x, above, slope.bench->dip, dip, rate(slope.bench->dip, dip), CrackLocation::bench};
        above += slope.bench->width * bench.rate;
        x += slope.bench->width;
    }
    const SineCosine<T> dip = sine_cosine(slope.upper_surface_dip);
    ground.segments[ground.count++] = {
        x, above, slope.upper_surface_dip, dip, rate(slope.upper_surface_dip, dip), CrackLocation::upper_surface};
}

// x at which the ground behind the crest is a given height above the plane, nearest to the crest.
template <class T>
bool find_height(const Ground<T>& ground, const T& height, T& x, CrackLocation& location) {
    for (std::size_t index = 0; index < ground.count; ++index) {
        const GroundSegment<T>& segment = ground.segments[index];
        const T difference = height - segment.above;
        const T& rate = segment.rate;
        const bool last = index + 1 == ground.count;
        if (difference == 0 && rate == 0) {
            x = segment.x;
            location = segment.location;
            return true;
        }
        if ((difference != 0 && (difference > 0) != (rate > 0)) || rate == 0) {
            continue;
        }
        const T candidate = segment.x + difference / rate;  // divided even where it is 0, as its derivative is not
        if (last || candidate <= ground.segments[index + 1].x) {
            x = candidate;
            location = segment.location;
            return true;
        }
    }
    return false;
}

template <class T>
T height_above_plane(const Wedge<T>& wedge, const Ground<T>& ground, const T& x) {
    if (x < wedge.crest_x) {
        return x * wedge.sine_face_minus_plane * wedge.plane_secant / wedge.face.cosine;
    }
    const GroundSegment<T>& segment =
        ground.count == 2 && x > ground.segments[1].x ? ground.segments[1] : ground.segments[0];
    return segment.above + (x - segment.x) * segment.rate;
}

// Side of the crack line on which a ground node lies, positive behind the crack.
template <class T>
T behind_crack(const Wedge<T>& wedge, const GroundSegment<T>& node) {
    return T(wedge.sine_crack_minus_plane * (node.x - wedge.base_top_x) -
             wedge.crack.cosine * wedge.plane.cosine * node.above);
}

// Follows the crack from its base upwards to the first ground that it meets.
template <class T>
PlaneFailureCheck trace_crack_up(Wedge<T>& wedge, const Ground<T>& ground, const T& crack_dip, const T& face_dip) {
    if (behind_crack(wedge, ground.segments[0]) >= 0) {
        const T sine = sine_of_difference(crack_dip, wedge.crack, face_dip, wedge.face);
        if (!(sine > 0)) {
            return PlaneFailureCheck::crack_never_surfaces;
        }
        wedge.crack_length = wedge.base_top_x * wedge.sine_face_minus_plane * wedge.plane_secant / sine;
        wedge.crack_location = CrackLocation::face;
    } else {
        for (std::size_t index = 0; index < ground.count; ++index) {
            const GroundSegment<T>& segment = ground.segments[index];
            if (index + 1 < ground.count && behind_crack(wedge, ground.segments[index + 1]) < 0) {
                continue;
            }
            const T above_base = segment.above + (wedge.base_top_x - segment.x) * segment.rate;
            const T sine = sine_of_difference(crack_dip, wedge.crack, segment.angle, segment.dip);
            if (!(sine > 0)) {
                return PlaneFailureCheck::crack_never_surfaces;
            }
            wedge.crack_length = above_base * segment.dip.cosine / sine;
            wedge.crack_location = segment.location;
            break;
        }
        if (!(wedge.crack_length >= 0)) {
            return PlaneFailureCheck::crack_below_plane;
        }
    }
    wedge.crack_top_x = wedge.base_top_x + wedge.crack_length * wedge.crack.cosine;
    return PlaneFailureCheck::valid;
}

// A crack placed by its top or by its depth is a line through the plane and one point of the ground. It is valid only
// if it runs through rock all the way, and if the ground in front of it stays above the plane.
template <class T>
PlaneFailureCheck check_crack_in_rock(const Wedge<T>& wedge, const Ground<T>& ground) {
    if (ground.count == 2 && ground.segments[1].x < wedge.crack_top_x && !(ground.segments[1].above > 0)) {
        return PlaneFailureCheck::crack_below_plane;
    }
    if (!(wedge.crack_length > 0)) {
        return PlaneFailureCheck::valid;
    }
    // Downwards from the ground the line must get below the ground, on the side to which it dips ...
    const bool leaning_out = wedge.crack_top_x > wedge.base_top_x;
    const auto is_beside = [&](const T& node_x) {
        return leaning_out ? wedge.crack_top_x <= node_x : wedge.crack_top_x < node_x;
    };
    const SineCosine<T>& dip = is_beside(wedge.crest_x) ? wedge.face
                               : ground.count == 2 && is_beside(ground.segments[1].x)
                                   ? ground.segments[0].dip
                                   : ground.segments[ground.count - 1].dip;
    if (!(wedge.crack.sine * dip.cosine > wedge.crack.cosine * dip.sine)) {
        return PlaneFailureCheck::crack_never_surfaces;
    }
    // ... and stay below every corner of it, down to the plane.
    for (std::size_t index = 0; index < ground.count; ++index) {
        const GroundSegment<T>& node = ground.segments[index];
        if (leaning_out && node.x > wedge.base_top_x && node.x < wedge.crack_top_x && behind_crack(wedge, node) > 0) {
            return PlaneFailureCheck::crack_never_surfaces;
        }
        if (!leaning_out && node.x > wedge.crack_top_x && node.x < wedge.base_top_x &&
            (behind_crack(wedge, node) < 0 || height_above_plane(wedge, ground, wedge.base_top_x) < 0)) {
            return PlaneFailureCheck::crack_never_surfaces;
        }
    }
    return PlaneFailureCheck::valid;
}

template <class T>
PlaneFailureCheck place_crack(Wedge<T>& wedge, const Ground<T>& ground, const PlaneFailure<T>& problem) {
    const TensionCrack<T>& crack = *problem.tension_crack;
    wedge.crack = sine_cosine(crack.dip);
    if (!(crack.dip > problem.failure_plane.dip)) {
        return PlaneFailureCheck::crack_flatter_than_plane;
    }
    wedge.sine_crack_minus_plane = sine_of_difference(crack.dip, wedge.crack, problem.failure_plane.dip, wedge.plane);
    if (const auto* placed = std::get_if<CrackAtDistance<T>>(&crack.position)) {
        wedge.crack_top_x = wedge.crest_x + placed->distance_behind_crest;
        if (!(wedge.crack_top_x >= 0)) {
            return PlaneFailureCheck::crack_base_below_daylight;
        }
        const T above = height_above_plane(wedge, ground, wedge.crack_top_x);
        if (!(above >= 0)) {
            return PlaneFailureCheck::crack_below_plane;
        }
        wedge.crack_location = wedge.crack_top_x < wedge.crest_x ? CrackLocation::face
                               : ground.count == 2 && wedge.crack_top_x <= ground.segments[1].x
                                   ? CrackLocation::bench
                                   : CrackLocation::upper_surface;
        wedge.crack_length = above * wedge.plane.cosine / wedge.sine_crack_minus_plane;
        wedge.base_top_x = wedge.crack_top_x - wedge.crack_length * wedge.crack.cosine;
    } else if (const auto* deep = std::get_if<CrackOfDepth<T>>(&crack.position)) {
        wedge.crack_length = deep->depth / wedge.crack.sine;
        const T above = wedge.crack_length * wedge.sine_crack_minus_plane * wedge.plane_secant;
        if (!find_height(ground, above, wedge.crack_top_x, wedge.crack_location)) {
            return PlaneFailureCheck::crack_deeper_than_mass;
        }
        wedge.base_top_x = wedge.crack_top_x - wedge.crack_length * wedge.crack.cosine;
    } else {
        T base_height{};  // above the daylighting point
        if (const auto* below = std::get_if<CrackBaseBelowCrest<T>>(&crack.position)) {
            base_height = wedge.crest_height - below->base_below_crest;
        } else {
            if (!problem.slope.toe_elevation) {
                return PlaneFailureCheck::elevation_without_datum;
            }
            base_height = std::get<CrackBaseElevation<T>>(crack.position).base_elevation -
                          *problem.slope.toe_elevation - wedge.daylight_height;
        }
        wedge.base_top_x = base_height * wedge.plane.cosine / wedge.plane.sine;
        if (!(wedge.base_top_x > 0)) {
            return PlaneFailureCheck::crack_base_below_daylight;
        }
        const PlaneFailureCheck check = trace_crack_up(wedge, ground, crack.dip, problem.slope.face_dip);
        if (check != PlaneFailureCheck::valid) {
            return check;
        }
    }
    return wedge.base_top_x > 0 ? check_crack_in_rock(wedge, ground) : PlaneFailureCheck::crack_base_below_daylight;
}

// Thickness of the mass at every corner, in order of x.
template <class T>
void set_stations(Wedge<T>& wedge, const Ground<T>& ground) {
    const auto add = [&](const T& x, const T& above, const T& floor) {
        wedge.stations[wedge.station_count++] = {x, above, floor};
    };
    wedge.station_count = 0;
    const bool leaning_out = wedge.crack_top_x > wedge.base_top_x;  // the mass extends beyond the base, over the crack
    const T crack_above = wedge.crack_length * wedge.sine_crack_minus_plane * wedge.plane_secant;  // of its top
    bool base_top_passed = !leaning_out;
    // If the crack opens exactly at the node, derivatives depend on the side of it on which the crack is taken to be.
    const auto add_ground = [&](const T& x, const T& above, bool crack_beyond) {
        if (!(x < wedge.crack_top_x) && !(crack_beyond && x == wedge.crack_top_x)) {
            return;
        }
        if (!base_top_passed && x >= wedge.base_top_x) {
            add(wedge.base_top_x, height_above_plane(wedge, ground, wedge.base_top_x), T(0));
            base_top_passed = true;
        }
        const bool over_crack = leaning_out && x >= wedge.base_top_x;  // includes the base's end: its floor has a slope
        add(x, above,
            over_crack
                ? T((x - wedge.base_top_x) * wedge.sine_crack_minus_plane / (wedge.crack.cosine * wedge.plane.cosine))
                : T(0));
    };
    add(T(0), T(0), T(0));
    add_ground(wedge.crest_x, ground.segments[0].above, wedge.crack_location != CrackLocation::face);
    if (ground.count == 2) {
        add_ground(ground.segments[1].x, ground.segments[1].above,
                   wedge.crack_location == CrackLocation::upper_surface);
    }
    if (!base_top_passed) {
        add(wedge.base_top_x, height_above_plane(wedge, ground, wedge.base_top_x), T(0));
    }
    if (leaning_out) {
        add(wedge.crack_top_x, crack_above, crack_above);
        return;
    }
    add(wedge.crack_top_x, crack_above, T(0));
    // The line of an overhanging crack is the roof of the mass. A vertical crack is treated in the same way: the strip
    // then has no width, but its derivative with respect to the crack's dip is not zero.
    add(wedge.base_top_x, T(0), T(0));
}

}  // namespace detail

// Fills in the wedge of a problem. If the result is not `valid` the members are unspecified.
template <class T>
PlaneFailureCheck make_wedge(const PlaneFailure<T>& problem, Wedge<T>& wedge) {
    const SlopeSection<T>& slope = problem.slope;
    const T& plane_dip = problem.failure_plane.dip;
    wedge.face = sine_cosine(slope.face_dip);
    wedge.plane = sine_cosine(plane_dip);
    wedge.plane_secant = 1 / wedge.plane.cosine;
    wedge.daylight_height = problem.failure_plane.daylight_height.value_or(T(0));
    wedge.crest_height = slope.height - wedge.daylight_height;
    if (!(plane_dip < slope.face_dip)) {
        return PlaneFailureCheck::plane_does_not_daylight;
    }
    if (!(wedge.crest_height > 0)) {
        return PlaneFailureCheck::plane_daylights_above_crest;
    }
    wedge.sine_face_minus_plane = sine_of_difference(slope.face_dip, wedge.face, plane_dip, wedge.plane);
    const T crest_over_sine = wedge.crest_height / wedge.face.sine;
    wedge.crest_x = crest_over_sine * wedge.face.cosine;
    const T crest_above = crest_over_sine * wedge.sine_face_minus_plane * wedge.plane_secant;
    detail::Ground<T> ground;
    detail::set_ground_behind_crest(ground, slope, plane_dip, wedge.plane, wedge.plane_secant, wedge.crest_x,
                                    crest_above);

    wedge.crack_length = T(0);
    wedge.crack_location = CrackLocation::none;
    if (problem.tension_crack) {
        const PlaneFailureCheck check = detail::place_crack(wedge, ground, problem);
        if (check != PlaneFailureCheck::valid) {
            return check;
        }
    } else {
        wedge.crack = {T(1), T(0)};
        wedge.sine_crack_minus_plane = T(1);
        CrackLocation location{};
        if (!detail::find_height(ground, T(0), wedge.base_top_x, location)) {
            return PlaneFailureCheck::plane_never_surfaces;
        }
        wedge.crack_top_x = wedge.base_top_x;
    }
    wedge.base_length = wedge.base_top_x * wedge.plane_secant;

    detail::set_stations(wedge, ground);
    wedge.area = T(0);
    for (std::size_t index = 1; index < wedge.station_count; ++index) {
        const Station<T>& left = wedge.stations[index - 1];
        const Station<T>& right = wedge.stations[index];
        wedge.area += (right.x - left.x) * ((left.ground - left.floor) + (right.ground - right.floor));
    }
    wedge.area /= 2;
    return wedge.area > 0 && wedge.base_length > 0 ? PlaneFailureCheck::valid : PlaneFailureCheck::mass_vanishes;
}

}  // namespace delabole
