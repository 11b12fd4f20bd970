// The physical models of the thesis's chapters 2 and 3, as printed: base friction tests, tilting frame, the models of
// the Delabole face. The tables are cases/thesis/chapter_2/*.csv and cases/thesis/chapter_3/*.csv, whose comments say
// where each number stands in the thesis and what is doubtful; they are built into the program. SI and radians.
#pragma once

#include "cases/program/thesis/thesis_tables.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

constexpr double mixture_friction = degrees(40.5);  // of the models' material, 40 to 41 deg (2.3.3.1, 3.2)

namespace detail {
constexpr Interval slope_angles = left_open(0, degrees(90));
}  // namespace detail

enum class SlopeBehaviour { stable, limiting, unstable };

// The words as they are printed.
constexpr std::array<std::string_view, 3> enum_names(SlopeBehaviour) {
    return {"S", "L.E.", "U"};
}

enum class SlopeFoundation { model_material, steel_frame, tin_strip, not_said };

enum class ToeChange { as_built, vertical_cut, horizontal_cut, blocks_removed, triangle_removed };

enum class ColumnKind { continuous, cross_jointed, saw_tooth };

enum class ModelSurroundings { near_frame, boundary_free };

// A row of Table 3.2: one state of a base friction model and its outcome.
struct BaseFrictionState {
    std::string test;  // number of the model, side of the table
    double slope_angle;
    double height_over_spacing;
    double joint_dip;
    double joint_spacing;
    std::optional<double> cross_joint_spacing;  // absent: continuous columns
    std::optional<double> crack_time_from;      // to the critical crack path; absent: none given
    std::optional<double> crack_time_to;
    std::optional<double> crack_angle_from;  // its inclination; absent: none given
    std::optional<double> crack_angle_to;
    SlopeBehaviour behaviour;
    SlopeFoundation foundation;
    ToeChange toe;
    ColumnKind columns;
    ModelSurroundings surroundings;
    std::optional<double> slope_surface;
    std::optional<double> base_columns;
    std::string remark;
    std::string doubt;

    double slope_height() const { return height_over_spacing * joint_spacing; }

    static constexpr std::string_view file = "thesis/chapter_3/table_3_2.csv";
    static constexpr auto fields() {
        using S = BaseFrictionState;
        using D = Dimension;
        return joined(
            table_columns<&S::test, &S::behaviour, &S::foundation, &S::toe, &S::columns, &S::surroundings, &S::remark,
                          &S::doubt>(),
            table_columns<&S::slope_angle, &S::joint_dip, &S::crack_angle_from, &S::crack_angle_to>(
                D::angle, detail::slope_angles),
            table_columns<&S::height_over_spacing>(more_than(0)),
            table_columns<&S::joint_spacing, &S::cross_joint_spacing, &S::slope_surface>(D::length, more_than(0)),
            table_columns<&S::crack_time_from, &S::crack_time_to>(D::time, at_least(0)),
            table_columns<&S::base_columns>(at_least(1)));
    }
};

// A row of Table 3.3, which is a point of Fig 3.2: slopes on the right and left of the table.
struct SlopeHeightVariation {
    double model;
    double slope_angle;
    double joint_dip;
    double slope_height;
    double right_crack_time;                // to the critical crack path
    std::optional<double> left_crack_time;  // absent: not built
    double right_crack_angle;
    std::optional<double> left_crack_angle;
    std::string remark;
    std::string doubt;
    static constexpr std::string_view file = "thesis/chapter_3/table_3_3.csv";
    static constexpr auto fields() {
        using V = SlopeHeightVariation;
        using D = Dimension;
        return joined(table_columns<&V::model>(at_least(1)),
                      table_columns<&V::slope_angle, &V::joint_dip, &V::right_crack_angle, &V::left_crack_angle>(
                          D::angle, detail::slope_angles),
                      table_columns<&V::slope_height>(D::length, more_than(0)),
                      table_columns<&V::right_crack_time, &V::left_crack_time>(D::time, at_least(0)),
                      table_columns<&V::remark, &V::doubt>());
    }
};

// An angle printed for the tilting frame.
struct TiltingFrameAngle {
    std::string key;
    double least;
    double most;
    std::string section;
    std::string meaning;
    static constexpr std::string_view file = "thesis/chapter_3/tilting_frame.csv";
    static constexpr auto fields() {
        using A = TiltingFrameAngle;
        return joined(table_columns<&A::key, &A::section, &A::meaning>(),
                      table_columns<&A::least, &A::most>(Dimension::angle, within(0, degrees(90))));
    }
};

enum class FieldVerdict { no, partly, yes, not_said };

// How far a model of Plates 2.I to 2.VI reproduced the failure, by the three criteria of 2.3.3.2.
struct MechanismVerdict {
    std::string plate;  // or the model told of beside it
    std::string mechanism;
    FieldVerdict profile;
    FieldVerdict cracks;
    FieldVerdict movements;
    std::optional<double> slope_angle;
    double joint_a_dip;
    std::optional<double> joint_a_spacing;
    std::optional<double> joint_b_dip;
    std::optional<double> joint_c_dip;
    std::optional<double> cleavage_dip;
    std::optional<double> cleavage_spacing;
    std::optional<double> fault_dip;
    std::optional<double> fault_thickness;  // of its gouge
    std::string remark;
    std::string doubt;
    static constexpr std::string_view file = "thesis/chapter_2/mechanisms.csv";
    static constexpr auto fields() {
        using V = MechanismVerdict;
        using D = Dimension;
        return joined(
            table_columns<&V::plate, &V::mechanism, &V::profile, &V::cracks, &V::movements, &V::remark, &V::doubt>(),
            table_columns<&V::slope_angle, &V::joint_a_dip, &V::joint_b_dip, &V::joint_c_dip, &V::cleavage_dip,
                          &V::fault_dip>(D::angle, detail::slope_angles),
            table_columns<&V::joint_a_spacing, &V::cleavage_spacing, &V::fault_thickness>(D::length, more_than(0)));
    }
};

enum class PrintedChange { none, rises, falls, falls_slightly };

// A conclusion of 2.3.4: how a response changes as a parameter grows.
struct PrintedTrend {
    std::string conclusion;
    std::string parameter;
    std::string response;
    PrintedChange change;
    std::string doubt;
    static constexpr std::string_view file = "thesis/chapter_2/trends.csv";
    static constexpr auto fields() {
        using T = PrintedTrend;
        return table_columns<&T::conclusion, &T::parameter, &T::response, &T::change, &T::doubt>();
    }
};

// A test of one joint-A column with groundwater (2.3.5).
struct GroundwaterTest {
    std::string material;
    double density;
    double friction_least;
    double friction_most;
    double filled_ratio;  // depth of water over its greatest
    double rotation;
    std::string plate;
    std::string remark;
    double friction() const { return (friction_least + friction_most) / 2; }
    static constexpr std::string_view file = "thesis/chapter_2/groundwater_tests.csv";
    static constexpr auto fields() {
        using T = GroundwaterTest;
        using D = Dimension;
        constexpr Interval frictions = between(0, degrees(90));
        return joined(table_columns<&T::material, &T::plate, &T::remark>(),
                      table_columns<&T::density>(D::density, more_than(0)),
                      table_columns<&T::friction_least, &T::friction_most>(D::angle, frictions),
                      table_columns<&T::filled_ratio>(within(0, 1)),
                      table_columns<&T::rotation>(D::angle, right_open(0, degrees(90))));
    }
};

}  // namespace delabole
