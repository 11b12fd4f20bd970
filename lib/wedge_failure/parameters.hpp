// Input of wedge failure: a slope, its two planes, crack, strengths, water and loads.
//
// Directions are compass readings (kinematics/orientation.hpp): dips and plunges below the horizontal, azimuths
// clockwise from north, in the frame east, north, up. The rock lies behind the face and below the upper surface; the
// two planes meet in a line that plunges out of the slope and daylights in the face at the origin.
#pragma once

#include "parameters/fields.hpp"
#include "parameters/lengths.hpp"
#include "plane_failure/study.hpp"
#include "strength/strength.hpp"
#include "water/water.hpp"

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace delabole {

constexpr Interval azimuth_range() {
    return within(0, degrees(360));
}

// `height` is H1 of Hoek & Bray. If face and upper surface differ in strike, the crest is inclined, and plane 2 meets
// it at another height.
struct WedgeSlope {
    double height;
    double face_dip;
    double face_dip_direction;
    double upper_surface_dip;
    double upper_surface_dip_direction;
    static constexpr auto fields() {
        using S = WedgeSlope;
        return FieldTable{number<&S::height>(Dimension::length, extent_range(),
                                             "vertical height from the point where the line of intersection comes out "
                                             "of the face to the point where plane 1 meets the crest"),
                          number<&S::face_dip>(Dimension::angle, between(0, degrees(180)),
                                               "dip of the face; above 90 deg it overhangs"),
                          number<&S::face_dip_direction>(Dimension::angle, azimuth_range(),
                                                         "dip direction of the face, out of the slope"),
                          number<&S::upper_surface_dip>(Dimension::angle, within(0, degrees(89)),
                                                        "dip of the ground behind the crest"),
                          number<&S::upper_surface_dip_direction>(Dimension::angle, azimuth_range(),
                                                                  "dip direction of the ground behind the crest")};
    }
};

struct WedgePlane {
    double dip;
    double dip_direction;
    StrengthLaw<> strength;
    static constexpr auto fields() {
        return FieldTable{number<&WedgePlane::dip>(Dimension::angle, within(0, degrees(90)), "dip"),
                          number<&WedgePlane::dip_direction>(Dimension::angle, azimuth_range(),
                                                             "azimuth of the dip, clockwise from north"),
                          section<&WedgePlane::strength>("shear strength of the plane")};
    }
};

struct WedgeCrack {
    double dip;
    double dip_direction;
    double distance;
    static constexpr auto fields() {
        return FieldTable{number<&WedgeCrack::dip>(Dimension::angle, within(0, degrees(90)), "dip"),
                          number<&WedgeCrack::dip_direction>(Dimension::angle, azimuth_range(),
                                                             "azimuth of the dip, clockwise from north"),
                          number<&WedgeCrack::distance>(
                              Dimension::length, distance_range(),
                              "distance from the crest, measured along the trace of plane 1 on the upper surface")};
    }
};

// Hoek & Bray: heavy rain fills the fissures. Pressure is zero where a surface meets the open air and rises linearly to
// its greatest value p: at the foot of the crack, p = unit weight times its depth below the upper surface; without a
// crack half-way down the line of intersection, p = unit weight times half the height between the ends of that line.
// The mean pressure on either plane and on the crack is p / 3. `filled_ratio` multiplies p.
struct FilledFissures {
    double unit_weight;
    double filled_ratio;
    static constexpr std::string_view kind = "filled_fissures";
    static constexpr auto fields() {
        return FieldTable{water_unit_weight_field(&FilledFissures::unit_weight),
                          number<&FilledFissures::filled_ratio>(
                              within(0, 1), "greatest pressure over that of fissures filled to the ground")};
    }
};

struct MeanPressures {
    double plane_1;
    double plane_2;
    std::optional<double> tension_crack;
    static constexpr std::string_view kind = "mean_pressures";
    static constexpr auto fields() {
        using P = MeanPressures;
        return FieldTable{number<&P::plane_1>(Dimension::stress, at_least(0), "mean water pressure on plane 1"),
                          number<&P::plane_2>(Dimension::stress, at_least(0), "mean water pressure on plane 2"),
                          number<&P::tension_crack>(Dimension::stress, at_least(0),
                                                    "mean water pressure on the tension crack; absent: 0")};
    }
};

using WedgeWater = std::variant<Dry, FilledFissures, MeanPressures>;

struct WedgeSeismicLoad {
    double coefficient;
    std::optional<double> plunge;
    std::optional<double> trend;
    static constexpr auto fields() {
        using S = WedgeSeismicLoad;
        return FieldTable{number<&S::coefficient>(within(-5, 5), "inertia force over weight"),
                          number<&S::plunge>(Dimension::angle, within(degrees(-90), degrees(90)),
                                             "direction of the force below the horizontal; absent: level"),
                          number<&S::trend>(Dimension::angle, azimuth_range(),
                                            "azimuth of the force; absent: that of the line of intersection")};
    }
};

struct WedgeLoad {
    double force;
    double plunge;
    double trend;
    static constexpr auto fields() {
        return FieldTable{
            number<&WedgeLoad::force>(Dimension::force, at_least(0), "force on the wedge"),
            number<&WedgeLoad::plunge>(Dimension::angle, within(degrees(-90), degrees(90)),
                                       "direction of the force below the horizontal; negative: upwards"),
            number<&WedgeLoad::trend>(Dimension::angle, azimuth_range(), "azimuth of the force, clockwise from north")};
    }
};

// The force acts on the wedge: it points from the head into the rock.
struct WedgeBolt {
    double force;
    double plunge;
    double trend;
    BoltAction action;
    static constexpr auto fields() {
        return FieldTable{
            number<&WedgeBolt::force>(Dimension::force, at_least(0), "tension"),
            number<&WedgeBolt::plunge>(Dimension::angle, within(degrees(-90), degrees(90)),
                                       "direction below the horizontal, into the rock; negative: inclined upwards"),
            number<&WedgeBolt::trend>(Dimension::angle, azimuth_range(),
                                      "azimuth of the direction into the rock, clockwise from north"),
            section<&WedgeBolt::action>(
                "active: tensioned, part of the driving forces; passive: mobilised by movement, adds to resistance")};
    }
};

struct WedgeFailure {
    WedgeSlope slope;
    WedgePlane plane_1;
    WedgePlane plane_2;
    std::optional<WedgeCrack> tension_crack;
    Rock<> rock;
    WedgeWater water;
    std::optional<WedgeSeismicLoad> seismic;
    std::vector<WedgeLoad> load;
    std::vector<WedgeBolt> bolt;

    static constexpr std::string_view kind = "wedge";
    static constexpr auto fields() {
        return FieldTable{
            section<&WedgeFailure::slope>("face and upper surface"),
            section<&WedgeFailure::plane_1>("the plane along whose trace heights and the crack's place are measured"),
            section<&WedgeFailure::plane_2>("the other plane"),
            section<&WedgeFailure::tension_crack>("crack that cuts the wedge off; absent: none"),
            section<&WedgeFailure::rock>("the rock mass"),
            section<&WedgeFailure::water>("water pressure on the planes and in the crack"),
            section<&WedgeFailure::seismic>("pseudo-static earthquake load; absent: none"),
            section<&WedgeFailure::load>("forces on the wedge"),
            section<&WedgeFailure::bolt>("bolts and cables through the planes")};
    }
};

struct WedgeFailureStudy {
    WedgeFailure model;
    std::vector<RequiredValue<>> required;

    static constexpr std::string_view kind = "wedge";
    static constexpr auto fields() {
        return FieldTable{inlined(&WedgeFailureStudy::model, "the slope and its wedge"),
                          section<&WedgeFailureStudy::required>("inputs solved for")};
    }
};

}  // namespace delabole
