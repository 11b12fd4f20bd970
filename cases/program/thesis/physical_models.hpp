// The physical models of the thesis's chapters 2 and 3, as printed: base friction tests, tilting frame, the models of
// the Delabole face. The tables are cases/thesis/chapter_2/*.csv and cases/thesis/chapter_3/*.csv, whose comments say
// where each number stands in the thesis and what is doubtful; they are built into the program. SI and radians.
#pragma once

#include "parameters/fields.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

constexpr double mixture_friction = degrees(40.5);  // of the models' material, 40 to 41 deg (2.3.3.1, 3.2)

namespace detail {
constexpr Interval slope_angles = left_open(0, degrees(90));
constexpr std::string_view doubt_meaning = "what is doubtful in the printed row; empty: nothing";
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
    std::string test;
    double slope_angle;
    double height_over_spacing;
    double joint_dip;
    double joint_spacing;
    std::optional<double> cross_joint_spacing;
    std::optional<double> crack_time_from;
    std::optional<double> crack_time_to;
    std::optional<double> crack_angle_from;
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

    static constexpr auto fields() {
        using S = BaseFrictionState;
        using D = Dimension;
        return FieldTable{
            section<&S::test>("number of the model, side of the table"),
            number<&S::slope_angle>(D::angle, detail::slope_angles, "inclination of the face"),
            number<&S::height_over_spacing>(more_than(0), "height of the slope over the spacing of the joints"),
            number<&S::joint_dip>(D::angle, detail::slope_angles, "dip of the joints, into the slope"),
            number<&S::joint_spacing>(D::length, more_than(0), "normal distance of the joints"),
            number<&S::cross_joint_spacing>(D::length, more_than(0),
                                            "normal distance of the cross joints; absent: continuous columns"),
            number<&S::crack_time_from>(
                D::time, at_least(0),
                "time from the last change to the critical crack path, its least; absent: none given"),
            number<&S::crack_time_to>(D::time, at_least(0), "its greatest"),
            number<&S::crack_angle_from>(D::angle, detail::slope_angles,
                                         "inclination of the critical crack path, its least; absent: none given"),
            number<&S::crack_angle_to>(D::angle, detail::slope_angles, "its greatest"),
            section<&S::behaviour>("stable, in limiting equilibrium, unstable"),
            section<&S::foundation>("what the slope stands on"),
            section<&S::toe>("change made at the toe"),
            section<&S::columns>("kind of columns"),
            section<&S::surroundings>("how near the steel frame is"),
            number<&S::slope_surface>(D::length, more_than(0),
                                      "length of the ground behind the crest; absent: not printed"),
            number<&S::base_columns>(at_least(1), "columns that form the bottom of the slope; absent: not printed"),
            section<&S::remark>("printed remark"),
            section<&S::doubt>(detail::doubt_meaning)};
    }
};

// A row of Table 3.3, which is a point of Fig 3.2: slopes on the right and left of the table.
struct SlopeHeightVariation {
    double model;
    double slope_angle;
    double joint_dip;
    double slope_height;
    double right_crack_time;
    std::optional<double> left_crack_time;
    double right_crack_angle;
    std::optional<double> left_crack_angle;
    std::string remark;
    std::string doubt;
    static constexpr auto fields() {
        using V = SlopeHeightVariation;
        using D = Dimension;
        return FieldTable{
            number<&V::model>(at_least(1), "number of the model"),
            number<&V::slope_angle>(D::angle, detail::slope_angles, "inclination of the face"),
            number<&V::joint_dip>(D::angle, detail::slope_angles, "dip of the joints, into the slope"),
            number<&V::slope_height>(D::length, more_than(0), "height of the slope"),
            number<&V::right_crack_time>(D::time, at_least(0), "time to the critical crack path, right slope"),
            number<&V::left_crack_time>(D::time, at_least(0), "left slope; absent: not built"),
            number<&V::right_crack_angle>(D::angle, detail::slope_angles,
                                          "inclination of the critical crack path, right slope"),
            number<&V::left_crack_angle>(D::angle, detail::slope_angles, "left slope; absent: not built"),
            section<&V::remark>("printed remark"),
            section<&V::doubt>(detail::doubt_meaning)};
    }
};

// An angle printed for the tilting frame.
struct TiltingFrameAngle {
    std::string key;
    double least;
    double most;
    std::string section;
    std::string meaning;
    static constexpr auto fields() {
        using A = TiltingFrameAngle;
        return FieldTable{delabole::section<&A::key>("its name here"),
                          number<&A::least>(Dimension::angle, within(0, degrees(90)), "least printed"),
                          number<&A::most>(Dimension::angle, within(0, degrees(90)), "greatest printed"),
                          delabole::section<&A::section>("section of the thesis"),
                          delabole::section<&A::meaning>("what it is")};
    }
};

enum class FieldVerdict { no, partly, yes, not_said };

// How far a model of Plates 2.I to 2.VI reproduced the failure, by the three criteria of 2.3.3.2.
struct MechanismVerdict {
    std::string plate;
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
    std::optional<double> fault_thickness;
    std::string remark;
    std::string doubt;
    static constexpr auto fields() {
        using V = MechanismVerdict;
        using D = Dimension;
        return FieldTable{
            section<&V::plate>("plate, or the model told of beside it"),
            section<&V::mechanism>("mode of failure tried"),
            section<&V::profile>("post-failure profile reproduced"),
            section<&V::cracks>("tension cracks at the crest reproduced"),
            section<&V::movements>("monitored movements of blocks at the top reproduced"),
            number<&V::slope_angle>(D::angle, detail::slope_angles, "inclination of the face"),
            number<&V::joint_a_dip>(D::angle, detail::slope_angles, "dip of joint set A, into the pit"),
            number<&V::joint_a_spacing>(D::length, more_than(0), "spacing of joint set A"),
            number<&V::joint_b_dip>(D::angle, detail::slope_angles,
                                    "dip of joint set B, into the slope; absent: no such joints"),
            number<&V::joint_c_dip>(D::angle, detail::slope_angles,
                                    "dip of joint set C, into the pit; absent: no such joints"),
            number<&V::cleavage_dip>(D::angle, detail::slope_angles,
                                     "dip of the cleavage, into the slope; absent: none cut"),
            number<&V::cleavage_spacing>(D::length, more_than(0), "spacing of the cleavage"),
            number<&V::fault_dip>(D::angle, detail::slope_angles, "dip of the fault, into the slope; absent: none"),
            number<&V::fault_thickness>(D::length, more_than(0), "thickness of its gouge"),
            section<&V::remark>("what happened"),
            section<&V::doubt>(detail::doubt_meaning)};
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
    static constexpr auto fields() {
        using T = PrintedTrend;
        return FieldTable{section<&T::conclusion>("number of the conclusion"),
                          section<&T::parameter>("what was varied"), section<&T::response>("what was observed"),
                          section<&T::change>("of the response as the parameter grows"),
                          section<&T::doubt>(detail::doubt_meaning)};
    }
};

// A test of one joint-A column with groundwater (2.3.5).
struct GroundwaterTest {
    std::string material;
    double density;
    double friction_least;
    double friction_most;
    double filled_ratio;
    double rotation;
    std::string plate;
    std::string remark;
    double friction() const { return (friction_least + friction_most) / 2; }
    static constexpr auto fields() {
        using T = GroundwaterTest;
        using D = Dimension;
        constexpr Interval frictions = between(0, degrees(90));
        return FieldTable{section<&T::material>("mixture or cork"),
                          number<&T::density>(D::density, more_than(0), "density of the material"),
                          number<&T::friction_least>(D::angle, frictions, "friction, its least"),
                          number<&T::friction_most>(D::angle, frictions, "friction, its greatest"),
                          number<&T::filled_ratio>(within(0, 1), "depth of water over its greatest"),
                          number<&T::rotation>(D::angle, right_open(0, degrees(90)), "of the model on the belt"),
                          section<&T::plate>("plate that shows it"),
                          section<&T::remark>("what happened")};
    }
};

std::vector<BaseFrictionState> base_friction_states();
std::vector<SlopeHeightVariation> slope_height_variations();
std::vector<TiltingFrameAngle> tilting_frame_angles();
std::vector<MechanismVerdict> mechanism_verdicts();
std::vector<PrintedTrend> printed_trends();
std::vector<GroundwaterTest> groundwater_tests();

}  // namespace delabole
