// Resultants of water pressure on the base, the tension crack and the submerged part of the mass's face.
//
// Every form is a piecewise linear pressure, integrated exactly. Moments are first moments of pressure: about the
// daylighting point along the base and along the face, about the bottom of the crack along the crack. Source of the
// Hoek-Bray form: thesis 2.3.2 (c), U = gamma_w z_w (H - z) cosec(psi_p) / 2, V = gamma_w z_w^2 / 2 for a vertical
// crack; V / sin(dip) for an inclined one. Peak at mid-height: U = gamma_w H_w^2 / (4 sin psi_p).
#pragma once

#include "plane_failure/wedge.hpp"

#include <vector>

namespace delabole {

template <class T>
struct PressureResultant {
    T force = T(0);   // N/m, normal to the surface, into the mass
    T moment = T(0);  // N, force times distance along the surface
};

template <class T>
struct WaterForces {
    PressureResultant<T> base;
    PressureResultant<T> crack;
    PressureResultant<T> face;
};

namespace detail {

// Adds pressure varying linearly from p_start at s_start to p_end at s_end; negative pressure counts as zero.
template <class T>
void add_pressure(PressureResultant<T>& resultant, T s_start, T p_start, T s_end, T p_end) {
    // Pressures of exactly zero are processed, because they have a derivative.
    if (p_start <= 0 && p_end <= 0 && (p_start < 0 || p_end < 0)) {
        return;
    }
    if (p_start < 0) {
        s_start += (s_end - s_start) * (p_start / (p_start - p_end));
        p_start = T(0);
    } else if (p_end < 0) {
        s_end = s_start + (s_end - s_start) * (p_start / (p_start - p_end));
        p_end = T(0);
    }
    const T length = s_end - s_start;
    const T force = length * (p_start + p_end) / 2;
    resultant.force += force;
    resultant.moment += s_start * force + length * length * (p_start / 6 + p_end / 3);
}

// Depth of water above a reference height (above the daylighting point); `full` is the greatest possible depth.
template <class T>
PlaneFailureCheck water_depth(const WaterLevel<T>& level, const PlaneFailure<T>& problem, const Wedge<T>& wedge,
                              const T& reference_height, const T& full, T& depth) {
    if (const auto* given = std::get_if<WaterDepth<T>>(&level)) {
        depth = given->water_depth;
    } else if (const auto* ratio = std::get_if<FilledRatio<T>>(&level)) {
        depth = ratio->filled_ratio * full;
        return PlaneFailureCheck::valid;
    } else {
        if (!problem.slope.toe_elevation) {
            return PlaneFailureCheck::elevation_without_datum;
        }
        depth = std::get<WaterElevation<T>>(level).water_elevation - *problem.slope.toe_elevation -
                wedge.daylight_height - reference_height;
        if (depth < 0) {
            depth = T(0);
        }
    }
    // The level of a full crack is often given by the same number twice, one of them with rounding errors.
    return depth > full * (1 + 1e-12) ? PlaneFailureCheck::water_above_crack : PlaneFailureCheck::valid;
}

// Adds hydrostatic pressure along the base from the daylighting point, with the given height of water there, up to that
// level.
template <class T>
void add_hydrostatic_base(WaterForces<T>& forces, const Wedge<T>& wedge, const T& unit_weight, const T& height) {
    add_pressure(forces.base, T(0), T(unit_weight * height), wedge.base_length,
                 T(unit_weight * (height - wedge.base_top_height())));
}

// `depth` is above the bottom of the crack; it exceeds the depth of the crack if a pond covers its top.
template <class T>
void add_crack_water(WaterForces<T>& forces, const Wedge<T>& wedge, const T& unit_weight, const T& depth) {
    if (depth > wedge.crack_depth()) {
        add_pressure(forces.crack, T(0), T(unit_weight * depth), wedge.crack_length,
                     T(unit_weight * (depth - wedge.crack_depth())));
    } else {
        add_pressure(forces.crack, T(0), T(unit_weight * depth), T(depth / wedge.crack.sine), T(0));
    }
}

template <class T>
T piezometric_height(const std::vector<PiezometricPoint<T>>& line, const T& x) {
    if (x <= line.front().x) {
        return line.front().y;
    }
    for (std::size_t index = 1; index < line.size(); ++index) {
        const PiezometricPoint<T>& left = line[index - 1];
        const PiezometricPoint<T>& right = line[index];
        if (x <= right.x) {
            return left.y + (right.y - left.y) * ((x - left.x) / (right.x - left.x));
        }
    }
    return line.back().y;
}

// Adds pressure below a piezometric line along a straight surface from (x, y) at s = 0; all heights are above the toe.
template <class T>
void add_piezometric(PressureResultant<T>& resultant, const PiezometricLineWater<T>& water, const T& x, const T& y,
                     const SineCosine<T>& dip, const T& length) {
    const auto pressure = [&](const T& s) {
        return T(water.unit_weight * (piezometric_height(water.point, T(x + s * dip.cosine)) - (y + s * dip.sine)));
    };
    T s_start = T(0);
    T p_start = pressure(s_start);
    const auto advance = [&](const T& s_end) {
        const T p_end = pressure(s_end);
        add_pressure(resultant, s_start, p_start, s_end, p_end);
        s_start = s_end;
        p_start = p_end;
    };
    const auto visit = [&](const PiezometricPoint<T>& point) {
        if (dip.cosine == 0) {
            return;
        }
        const T s = (point.x - x) / dip.cosine;
        if (s > s_start && s < length) {
            advance(s);
        }
    };
    if (dip.cosine < 0) {  // an overhanging crack runs towards smaller x
        for (std::size_t index = water.point.size(); index-- > 0;) {
            visit(water.point[index]);
        }
    } else {
        for (const PiezometricPoint<T>& point : water.point) {
            visit(point);
        }
    }
    advance(length);
}

template <class T>
void add_custom(PressureResultant<T>& resultant, const std::vector<PressurePoint<T>>& points, const T& length) {
    for (std::size_t index = 1; index < points.size(); ++index) {
        add_pressure(resultant, T(points[index - 1].position * length), points[index - 1].pressure,
                     T(points[index].position * length), points[index].pressure);
    }
}

template <class Points, class Member>
bool increasing(const Points& points, Member member) {
    for (std::size_t index = 1; index < points.size(); ++index) {
        if (!(points[index - 1].*member < points[index].*member)) {
            return false;
        }
    }
    return true;
}

// Effect of a pond on the mass. Heights are above the daylighting point; all members are 0 without a pond.
template <class T>
struct PondAtMass {
    T height;
    T unit_weight;

    T pressure_at(const T& level) const { return height >= level ? T(unit_weight * (height - level)) : T(0); }
    // Depth of pond water in a crack, above its bottom. A crack that opens in the face fills from a pond above its top;
    // from a crack behind the crest the water would drain.
    T depth_in_crack(const Wedge<T>& wedge) const {
        const T above_bottom = height - wedge.base_top_height();
        if (!(above_bottom > 0)) {
            return T(0);
        }
        const bool runs_off = wedge.crack_location != CrackLocation::face && above_bottom > wedge.crack_depth();
        return runs_off ? wedge.crack_depth() : above_bottom;
    }
    // The same level is often given twice, one of them with rounding errors.
    bool exceeds(const T& pressure, const T& level) const {
        return height > level && pressure_at(level) * (1 - 1e-12) > pressure;
    }
};

// One overload per water form.
template <class T>
struct WaterVisitor {
    const PlaneFailure<T>& problem;
    const Wedge<T>& wedge;
    const PondAtMass<T>& pond;
    WaterForces<T>& forces;

    PlaneFailureCheck operator()(const Dry&) const {
        add_pond_to_base();
        if (problem.tension_crack && pond.height > wedge.base_top_height()) {
            add_crack_water(forces, wedge, pond.unit_weight, pond.depth_in_crack(wedge));
        }
        return PlaneFailureCheck::valid;
    }

    PlaneFailureCheck operator()(const CrackAndBaseWater<T>& water) const {
        T depth = T(0);
        const PlaneFailureCheck check = crack_depth(water.level, water.unit_weight, depth);
        add_crack_water(forces, wedge, water.unit_weight, depth);
        add_pressure(forces.base, T(0), pond.pressure_at(T(0)), wedge.base_length, T(water.unit_weight * depth));
        return check;
    }

    PlaneFailureCheck operator()(const CrackOnlyWater<T>& water) const {
        T depth = T(0);
        const PlaneFailureCheck check = crack_depth(water.level, water.unit_weight, depth);
        add_crack_water(forces, wedge, water.unit_weight, depth);
        add_pond_to_base();
        return check;
    }

    PlaneFailureCheck operator()(const BasePeakMidHeightWater<T>& water) const {
        T height = T(0);
        const PlaneFailureCheck check = water_depth(water.level, problem, wedge, T(0), wedge.base_top_height(), height);
        const T middle = height / (2 * wedge.plane.sine);
        const T peak = water.unit_weight * height / 2;
        add_pressure(forces.base, T(0), pond.pressure_at(T(0)), middle, peak);
        add_pressure(forces.base, middle, peak, T(2 * middle), T(0));
        return checked(check, T(water.unit_weight * height), T(0));
    }

    PlaneFailureCheck operator()(const PeakAtToeWater<T>& water) const {
        const T base_top = wedge.base_top_height();
        T height = T(0);
        const PlaneFailureCheck check =
            water_depth(water.level, problem, wedge, T(0), T(base_top + full_crack()), height);
        add_hydrostatic_base(forces, wedge, water.unit_weight, height);
        if (height > base_top) {
            add_crack_water(forces, wedge, water.unit_weight, T(height - base_top));
        }
        return checked(check, T(water.unit_weight * height), T(0));
    }

    PlaneFailureCheck operator()(const PiezometricLineWater<T>& water) const {
        if (water.point.size() < 2 || !increasing(water.point, &PiezometricPoint<T>::x)) {
            return PlaneFailureCheck::water_points_not_increasing;
        }
        const T x = wedge.daylight_height * wedge.face.cosine / wedge.face.sine;
        add_piezometric(forces.base, water, x, wedge.daylight_height, wedge.plane, wedge.base_length);
        const auto pressure_at = [&](const T& along, const T& level) {
            return T(water.unit_weight *
                     (piezometric_height(water.point, T(x + along)) - (wedge.daylight_height + level)));
        };
        PlaneFailureCheck check = checked(PlaneFailureCheck::valid, pressure_at(T(0), T(0)), T(0));
        if (problem.tension_crack) {
            const T base_top = wedge.base_top_height();
            add_piezometric(forces.crack, water, T(x + wedge.base_top_x), T(wedge.daylight_height + base_top),
                            wedge.crack, wedge.crack_length);
            check = checked(check, pressure_at(wedge.base_top_x, base_top), base_top);
        }
        return check;
    }

    PlaneFailureCheck operator()(const CustomWater<T>& water) const {
        if (water.base.size() == 1 || water.crack.size() == 1 || !increasing(water.base, &PressurePoint<T>::position) ||
            !increasing(water.crack, &PressurePoint<T>::position)) {
            return PlaneFailureCheck::water_points_not_increasing;
        }
        if (!water.crack.empty() && !problem.tension_crack) {
            return PlaneFailureCheck::water_needs_crack;
        }
        add_custom(forces.base, water.base, wedge.base_length);
        add_custom(forces.crack, water.crack, wedge.crack_length);
        const PlaneFailureCheck check = checked(PlaneFailureCheck::valid, pressure_at_start(water.base), T(0));
        return problem.tension_crack ? checked(check, pressure_at_start(water.crack), wedge.base_top_height()) : check;
    }

  private:
    void add_pond_to_base() const {
        if (pond.height > 0) {
            add_hydrostatic_base(forces, wedge, pond.unit_weight, pond.height);
        }
    }

    // The check so far, or water_below_pond if the pond's pressure at this height exceeds that of the water form.
    PlaneFailureCheck checked(PlaneFailureCheck check, const T& pressure, const T& level) const {
        return check == PlaneFailureCheck::valid && pond.exceeds(pressure, level) ? PlaneFailureCheck::water_below_pond
                                                                                  : check;
    }

    static T pressure_at_start(const std::vector<PressurePoint<T>>& points) {
        return points.empty() || points.front().position > 0 ? T(0) : points.front().pressure;
    }

    // Greatest depth of water in the crack.
    T full_crack() const {
        const T from_pond = pond.depth_in_crack(wedge);
        return problem.tension_crack && from_pond > wedge.crack_depth() ? from_pond : wedge.crack_depth();
    }

    PlaneFailureCheck crack_depth(const WaterLevel<T>& level, const T& unit_weight, T& depth) const {
        if (!problem.tension_crack) {
            return PlaneFailureCheck::water_needs_crack;
        }
        const T base_top = wedge.base_top_height();
        const PlaneFailureCheck check = water_depth(level, problem, wedge, base_top, full_crack(), depth);
        return checked(check, T(unit_weight * depth), base_top);
    }
};

}  // namespace detail

template <class T>
detail::PondAtMass<T> pond_at_mass(const PlaneFailure<T>& problem, const Wedge<T>& wedge) {
    if (!problem.pond || !(problem.pond->depth >= wedge.daylight_height)) {
        return {T(0), T(0)};
    }
    return {T(problem.pond->depth - wedge.daylight_height), problem.pond->unit_weight};
}

template <class T>
PlaneFailureCheck water_forces(const PlaneFailure<T>& problem, const Wedge<T>& wedge, WaterForces<T>& forces) {
    if (problem.pond && problem.pond->depth > problem.slope.height) {
        return PlaneFailureCheck::pond_above_crest;
    }
    const detail::PondAtMass<T> pond = pond_at_mass(problem, wedge);
    if (pond.unit_weight > 0) {
        // If the crack opens in the face, the face above it stays, and the pond there does not load the mass.
        const T face_height = wedge.crack_location == CrackLocation::face
                                  ? T(wedge.base_top_height() + wedge.crack_depth())
                                  : wedge.crest_height;
        detail::add_pressure(forces.face, T(0), T(pond.unit_weight * pond.height), T(face_height / wedge.face.sine),
                             T(pond.unit_weight * (pond.height - face_height)));
    }
    return std::visit(detail::WaterVisitor<T>{problem, wedge, pond, forces}, problem.water);
}

}  // namespace delabole
