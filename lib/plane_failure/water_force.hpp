// Resultants of water pressure on the base, the tension crack and the submerged part of the mass's face.
//
// Every form is a piecewise linear pressure, integrated exactly. Moments are first moments of pressure: about the
// daylighting point along the base and along the face, about the bottom of the crack along the crack.
// Source of the Hoek-Bray form: thesis 2.3.2 (c), U = gamma_w z_w (H - z) cosec(psi_p) / 2, V = gamma_w z_w^2 / 2
// (vertical crack); V / sin(dip) for an inclined one. Peak at mid-height: U = gamma_w H_w^2 / (4 sin psi_p).
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

// Adds pressure varying linearly from p_start at s_start to p_end at s_end; negative pressure counts as none.
template <class T>
void add_pressure(PressureResultant<T>& resultant, T s_start, T p_start, T s_end, T p_end) {
    // Pressures of exactly zero go on: they have a derivative.
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

// Depth of water above a reference height (above the daylighting point); `full` is the greatest depth that makes sense.
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
    // A crack filled to the brim is often given by the same number twice, one of them after a few roundings.
    return depth > full * (1 + 1e-12) ? PlaneFailureCheck::water_above_crack : PlaneFailureCheck::valid;
}

// Hydrostatic pressure along the base from the daylighting point up to a level, the height of water there given.
template <class T>
void add_hydrostatic_base(WaterForces<T>& forces, const Wedge<T>& wedge, const T& unit_weight, const T& height) {
    add_pressure(forces.base, T(0), T(unit_weight * height), wedge.base_length,
                 T(unit_weight * (height - wedge.base_top_height())));
}

template <class T>
void add_crack_water(WaterForces<T>& forces, const Wedge<T>& wedge, const T& unit_weight, const T& depth) {
    add_pressure(forces.crack, T(0), T(unit_weight * depth), T(depth / wedge.crack.sine), T(0));
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

// Pressure below a piezometric line along a straight surface from (x, y) at s = 0; all heights above the toe.
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

// One overload per water form. `pond_height` is that of the pond above the daylighting point, 0 without one.
template <class T>
struct WaterVisitor {
    const PlaneFailure<T>& problem;
    const Wedge<T>& wedge;
    const T& pond_height;
    const T& pond_unit_weight;
    WaterForces<T>& forces;

    PlaneFailureCheck operator()(const Dry&) const {
        if (pond_height > 0) {
            add_hydrostatic_base(forces, wedge, pond_unit_weight, pond_height);
        }
        return PlaneFailureCheck::valid;
    }

    PlaneFailureCheck operator()(const CrackAndBaseWater<T>& water) const {
        T depth{};
        const PlaneFailureCheck check = crack_depth(water.level, depth);
        add_crack_water(forces, wedge, water.unit_weight, depth);
        add_pressure(forces.base, T(0), T(pond_unit_weight * pond_height), wedge.base_length,
                     T(water.unit_weight * depth));
        return check;
    }

    PlaneFailureCheck operator()(const CrackOnlyWater<T>& water) const {
        T depth{};
        const PlaneFailureCheck check = crack_depth(water.level, depth);
        add_crack_water(forces, wedge, water.unit_weight, depth);
        (*this)(Dry{});
        return check;
    }

    PlaneFailureCheck operator()(const BasePeakMidHeightWater<T>& water) const {
        T height{};
        const PlaneFailureCheck check = water_depth(water.level, problem, wedge, T(0), wedge.base_top_height(), height);
        const T middle = height / (2 * wedge.plane.sine);
        const T peak = water.unit_weight * height / 2;
        add_pressure(forces.base, T(0), T(pond_unit_weight * pond_height), middle, peak);
        add_pressure(forces.base, middle, peak, T(2 * middle), T(0));
        return check;
    }

    PlaneFailureCheck operator()(const PeakAtToeWater<T>& water) const {
        const T base_top = wedge.base_top_height();
        T height{};
        const PlaneFailureCheck check =
            water_depth(water.level, problem, wedge, T(0), T(base_top + wedge.crack_depth()), height);
        add_hydrostatic_base(forces, wedge, water.unit_weight, height);
        if (height > base_top) {
            add_crack_water(forces, wedge, water.unit_weight, T(height - base_top));
        }
        return check;
    }

    PlaneFailureCheck operator()(const PiezometricLineWater<T>& water) const {
        if (water.point.size() < 2 || !increasing(water.point, &PiezometricPoint<T>::x)) {
            return PlaneFailureCheck::water_points_not_increasing;
        }
        const T x = wedge.daylight_height * wedge.face.cosine / wedge.face.sine;
        add_piezometric(forces.base, water, x, wedge.daylight_height, wedge.plane, wedge.base_length);
        if (problem.tension_crack) {
            add_piezometric(forces.crack, water, T(x + wedge.base_top_x),
                            T(wedge.daylight_height + wedge.base_top_height()), wedge.crack, wedge.crack_length);
        }
        return PlaneFailureCheck::valid;
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
        return PlaneFailureCheck::valid;
    }

  private:
    PlaneFailureCheck crack_depth(const WaterLevel<T>& level, T& depth) const {
        return problem.tension_crack
                   ? water_depth(level, problem, wedge, wedge.base_top_height(), wedge.crack_depth(), depth)
                   : PlaneFailureCheck::water_needs_crack;
    }
};

}  // namespace detail

template <class T>
PlaneFailureCheck water_forces(const PlaneFailure<T>& problem, const Wedge<T>& wedge, WaterForces<T>& forces) {
    T pond_height = T(0);
    T pond_unit_weight = T(0);
    if (problem.pond) {
        if (problem.pond->depth > problem.slope.height) {
            return PlaneFailureCheck::pond_above_crest;
        }
        pond_unit_weight = problem.pond->unit_weight;
        if (problem.pond->depth >= wedge.daylight_height) {
            pond_height = problem.pond->depth - wedge.daylight_height;
            // A crack in the face leaves the face above it standing: the pond there does not load the mass.
            const T face_height = wedge.crack_location == CrackLocation::face
                                      ? T(wedge.base_top_height() + wedge.crack_depth())
                                      : wedge.crest_height;
            detail::add_pressure(forces.face, T(0), T(pond_unit_weight * pond_height), T(face_height / wedge.face.sine),
                                 T(pond_unit_weight * (pond_height - face_height)));
        }
    }
    return std::visit(detail::WaterVisitor<T>{problem, wedge, pond_height, pond_unit_weight, forces}, problem.water);
}

}  // namespace delabole
