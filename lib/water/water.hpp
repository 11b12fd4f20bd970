// Description of water pressure on a tension crack and on the base of a sliding mass.
//
// Pressures are pore pressures in Pa; plane_failure/water_force.hpp computes the forces. A level is given in one of
// three ways: as a depth of water, as a ratio of the greatest possible depth, or as an elevation.
#pragma once

#include "parameters/fields.hpp"
#include "parameters/lengths.hpp"

#include <string_view>
#include <variant>
#include <vector>

namespace delabole {

template <class T = double>
struct WaterDepth {
    T water_depth;
    static constexpr auto fields() {
        return FieldTable{number<&WaterDepth::water_depth>(Dimension::length, distance_range(),
                                                           "vertical depth of water above the lowest wetted point")};
    }
};

template <class T = double>
struct FilledRatio {
    T filled_ratio;
    static constexpr auto fields() {
        return FieldTable{
            number<&FilledRatio::filled_ratio>(within(0, 1), "depth of water over the greatest possible depth")};
    }
};

template <class T = double>
struct WaterElevation {
    T water_elevation;
    static constexpr auto fields() {
        return FieldTable{number<&WaterElevation::water_elevation>(
            Dimension::length, position_range(),
            "elevation of the water surface in the datum of slope.toe_elevation; below the lowest wetted point the "
            "form gives no pressure")};
    }
};

template <class T = double>
using WaterLevel = std::variant<WaterDepth<T>, FilledRatio<T>, WaterElevation<T>>;

template <class T>
constexpr auto water_unit_weight_field(T member) {
    return number("unit_weight", member, Dimension::unit_weight, more_than(0), "unit weight of water");
}

struct Dry {
    static constexpr std::string_view kind = "dry";
    static constexpr auto fields() { return FieldTable{}; }
};

// Hoek & Bray: hydrostatic in the crack, decreasing linearly along the base from the crack to the point where it
// daylights. The level is above the bottom of the crack.
template <class T = double>
struct CrackAndBaseWater {
    T unit_weight;
    WaterLevel<T> level;
    static constexpr std::string_view kind = "crack_and_base";
    static constexpr auto fields() {
        return FieldTable{water_unit_weight_field(&CrackAndBaseWater::unit_weight),
                          inlined(&CrackAndBaseWater::level, "level above the bottom of the crack")};
    }
};

// Hydrostatic in the crack, none on the base. The level is above the bottom of the crack.
template <class T = double>
struct CrackOnlyWater {
    T unit_weight;
    WaterLevel<T> level;
    static constexpr std::string_view kind = "crack_only";
    static constexpr auto fields() {
        return FieldTable{water_unit_weight_field(&CrackOnlyWater::unit_weight),
                          inlined(&CrackOnlyWater::level, "level above the bottom of the crack")};
    }
};

// On the base only: zero at the level and where the base daylights, greatest half way between, where it is the
// hydrostatic pressure of half the depth. The level is above the daylighting point; full means up to the upper end of
// the base.
template <class T = double>
struct BasePeakMidHeightWater {
    T unit_weight;
    WaterLevel<T> level;
    static constexpr std::string_view kind = "base_peak_mid_height";
    static constexpr auto fields() {
        return FieldTable{water_unit_weight_field(&BasePeakMidHeightWater::unit_weight),
                          inlined(&BasePeakMidHeightWater::level, "level above the point where the base daylights")};
    }
};

// Blocked drainage: hydrostatic from the level down to the daylighting point, in the crack and along the base. The
// level is above the daylighting point; full means up to the top of the crack or, without a crack, to the upper end of
// the base.
template <class T = double>
struct PeakAtToeWater {
    T unit_weight;
    WaterLevel<T> level;
    static constexpr std::string_view kind = "peak_at_toe";
    static constexpr auto fields() {
        return FieldTable{water_unit_weight_field(&PeakAtToeWater::unit_weight),
                          inlined(&PeakAtToeWater::level, "level above the point where the base daylights")};
    }
};

template <class T = double>
struct PiezometricPoint {
    T x;
    T y;
    static constexpr auto fields() {
        return FieldTable{number<&PiezometricPoint::x>(Dimension::length, position_range(),
                                                       "horizontal distance from the toe, into the slope"),
                          number<&PiezometricPoint::y>(Dimension::length, position_range(), "height above the toe")};
    }
};

// Pressure = unit weight times vertical depth below a line, which is level beyond its ends. Points in order of
// increasing x.
template <class T = double>
struct PiezometricLineWater {
    T unit_weight;
    std::vector<PiezometricPoint<T>> point;
    static constexpr std::string_view kind = "piezometric_line";
    static constexpr auto fields() {
        return FieldTable{water_unit_weight_field(&PiezometricLineWater::unit_weight),
                          section<&PiezometricLineWater::point>("points of the line, x increasing")};
    }
};

template <class T = double>
struct PressurePoint {
    T position;
    T pressure;
    static constexpr auto fields() {
        return FieldTable{number<&PressurePoint::position>(within(0, 1),
                                                           "relative position: base 0 where it daylights to 1 at its "
                                                           "upper end; crack 0 at its bottom to 1 at the ground"),
                          number<&PressurePoint::pressure>(Dimension::stress, at_least(0), "water pressure")};
    }
};

// Measured or assumed pressures, linear between points and zero beyond the first and last. Positions increase; there
// are none, or at least two.
template <class T = double>
struct CustomWater {
    std::vector<PressurePoint<T>> crack;
    std::vector<PressurePoint<T>> base;
    static constexpr std::string_view kind = "custom";
    static constexpr auto fields() {
        return FieldTable{section<&CustomWater::crack>("pressures along the crack, position increasing"),
                          section<&CustomWater::base>("pressures along the base, position increasing")};
    }
};

template <class T = double>
using Water = std::variant<Dry, CrackAndBaseWater<T>, CrackOnlyWater<T>, BasePeakMidHeightWater<T>, PeakAtToeWater<T>,
                           PiezometricLineWater<T>, CustomWater<T>>;

// Standing water in front of the face. It always loads the face, and it enters the base where the plane daylights, and
// through the base the crack: the water there is nowhere lower than the pond. For a slope that is otherwise dry, base
// and crack are filled to the level of the pond; with crack_only water the base is. With crack_and_base and
// base_peak_mid_height the pond replaces the zero at the daylighting point. The pressure that a form itself gives must
// be at least that of the pond, at the daylighting point and at the bottom of the crack; otherwise it is refused.
template <class T = double>
struct Pond {
    T depth;
    T unit_weight;
    static constexpr auto fields() {
        return FieldTable{number<&Pond::depth>(Dimension::length, distance_range(),
                                               "depth of standing water above the toe, not above the crest"),
                          water_unit_weight_field(&Pond::unit_weight)};
    }
};

}  // namespace delabole
