// Input of kinematic feasibility: a face, its joint sets and the limits of the test.
#pragma once

#include "kinematics/joint_set.hpp"
#include "kinematics/orientation.hpp"
#include "parameters/fields.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

struct SlopeOrientation {
    double face_dip;
    double face_dip_direction;
    std::optional<Orientation> upper_surface;
    static constexpr auto fields() {
        using S = SlopeOrientation;
        return FieldTable{number<&S::face_dip>(Dimension::angle, left_open(0, degrees(90)), "dip of the face"),
                          number<&S::face_dip_direction>(Dimension::angle, within(0, degrees(360)),
                                                         "dip direction of the face, out of the slope"),
                          section<&S::upper_surface>("ground behind the crest; absent: level")};
    }
};

struct JointFriction {
    double friction_angle;
    static constexpr auto fields() {
        return FieldTable{number<&JointFriction::friction_angle>(Dimension::angle, right_open(0, degrees(90)),
                                                                 "friction angle of every joint")};
    }
};

// Greatest angle, to either side, between the dip direction of the face and a movement that can still leave the slope.
// Customary: 20 deg for planar sliding and direct toppling, 30 deg for flexural toppling (Goodman 1980; Wyllie & Mah
// 2004 take 10 deg). Wedges need no such limit, because their planes release them.
struct LateralLimit {
    double planar_sliding;
    double flexural_toppling;
    double direct_toppling;
    static constexpr auto fields() {
        constexpr Interval range = within(0, degrees(90));
        return FieldTable{
            number<&LateralLimit::planar_sliding>(
                Dimension::angle, range,
                "largest angle in plan between joint and face dip direction, sliding on a plane"),
            number<&LateralLimit::flexural_toppling>(
                Dimension::angle, range, "largest angle in plan between joint and face strike, flexural toppling"),
            number<&LateralLimit::direct_toppling>(
                Dimension::angle, range, "largest angle in plan between block axis or base and face, direct toppling")};
    }
};

// The line along which joints were counted, a tape or a borehole: it meets too few of the joints parallel to it.
struct Scanline {
    double plunge;
    double trend;
    std::optional<double> least_angle;
    // Customary value: a smaller angle would let a few planes outweigh all others.
    static constexpr double customary_least_angle = degrees(15);
    static constexpr auto fields() {
        return FieldTable{
            number<&Scanline::plunge>(Dimension::angle, within(0, degrees(90)), "plunge of the line"),
            number<&Scanline::trend>(Dimension::angle, within(0, degrees(360)), "trend of the line"),
            absent_is(customary_least_angle,
                      number<&Scanline::least_angle>(Dimension::angle, left_open(0, degrees(90)),
                                                     "angle to the line below which a plane weighs no more"))};
    }
};

struct PoleSurvey {
    std::optional<std::string> file;
    std::vector<Orientation> plane;
    std::optional<Scanline> scanline;
    static constexpr auto fields() {
        return FieldTable{section<&PoleSurvey::file>(
                              "CSV file beside the case with columns dip and dip_direction, trend and plunge of the "
                              "poles, or strike (right-hand rule) and dip; absent: planes are given here"),
                          section<&PoleSurvey::plane>("a measured plane"),
                          section<&PoleSurvey::scanline>("line along which planes were counted; absent: no weights")};
    }
};

struct SetSearch {
    double most_sets;
    static constexpr auto fields() {
        return FieldTable{number<&SetSearch::most_sets>(within(1, 12), "largest number of sets tried, a whole number")};
    }
};

struct Kinematics {
    SlopeOrientation slope;
    JointFriction strength;
    LateralLimit lateral_limit;
    std::vector<JointSet> joint_set;
    std::vector<PoleSurvey> poles;
    std::optional<SetSearch> set_search;

    static constexpr std::string_view kind = "kinematics";
    static constexpr auto fields() {
        using K = Kinematics;
        return FieldTable{section<&K::slope>("the face"),
                          section<&K::strength>("joint strength"),
                          section<&K::lateral_limit>("limits in plan"),
                          section<&K::joint_set>("the joint sets; absent, where there are poles: those found in them"),
                          section<&K::poles>("measured planes"),
                          section<&K::set_search>("how sets are found in poles; absent: up to 8")};
    }
};

// Numerical settings. The standard error of a share p is sqrt(p (1 - p) / sample_count): at most 0.8 % at 4000.
struct OrientationSampling {
    std::optional<double> sample_count;
    std::optional<double> seed;

    static constexpr double default_sample_count = 4000;
    static constexpr double default_seed = 1967;

    static constexpr auto fields() {
        using S = OrientationSampling;
        return FieldTable{
            absent_is(default_sample_count,
                      number<&S::sample_count>(within(1, 1e6), "orientations drawn from each set, a whole number")),
            absent_is(default_seed,
                      number<&S::seed>(within(0, 9007199254740992.0), "seed of the samples, a whole number"))};
    }
};

struct KinematicsStudy {
    Kinematics model;
    std::optional<OrientationSampling> sampling;

    static constexpr std::string_view kind = "kinematics";
    static constexpr auto fields() {
        return FieldTable{inlined(&KinematicsStudy::model, "face and joint sets"),
                          section<&KinematicsStudy::sampling>("sampling of the sets; absent: its defaults")};
    }
};

}  // namespace delabole
