// How precisely blocks are drawn makes no difference: joints that are closed but for rounded coordinates are closed,
// and joints that are open are said to have lost their cohesion.
#include "cases/program/case/model_cases.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace delabole {
namespace {

using testing::changed;

// A slab of 4 x 1 m on two supports that meet under its middle; cohesion is kept after slip.
constexpr std::string_view slab_text = R"(schema = 1
model = "relaxation"
[scene]
kind = "blocks"
tilt = "30 deg"
joint = [{ friction_angle = "20 deg", cohesion = "20 kPa", residual_cohesion = "20 kPa" }]
[[scene.block]]
density = "2700 kg/m3"
vertex = [{ x = "0 m", y = "0 m" }, { x = "4 m", y = "0 m" }, { x = "4 m", y = "1 m" }, { x = "0 m", y = "1 m" }]
[[scene.block]]
density = "2700 kg/m3"
hold = "fixed"
vertex = [{ x = "-3 m", y = "-1 m" }, { x = "2 m", y = "-1 m" }, { x = "2 m", y = "0 m" }, { x = "-3 m", y = "left m" }]
[[scene.block]]
density = "2700 kg/m3"
hold = "fixed"
vertex = [{ x = "2 m", y = "-1 m" }, { x = "7 m", y = "-1 m" }, { x = "7 m", y = "right m" }, { x = "2 m", y = "step m" }]
[settings]
stop = "onset"
[critical]
parameter = "strength_reduction"
tolerance = 0.002
)";

struct Drawn {
    const char* left = "0";   // level of the outer end of the lower support
    const char* right = "0";  // of the upper one
    const char* step = "0";   // of the upper one under the middle
};

Analysis analysis_of_slab(const Drawn& drawn) {
    const std::string left = changed(slab_text, "left", drawn.left);
    return analyse_model(parse_case(changed(changed(left, "right", drawn.right), "step", drawn.step), "case").model);
}

double factor_of_slab(const Analysis& analysis) {
    return std::get<double>(analysis.find("factor_of_safety")->value);
}

bool warns_of_open_joints(const Analysis& analysis) {
    return std::ranges::any_of(analysis.warnings, [](const std::string& warning) {
        return warning.find("open in the initial geometry") != std::string::npos;
    });
}

// Cohesion acts along 4 m: (c L + W cos 30 tan 20) / (W sin 30). With a step of 10 micrometres it acted along 2
// m: 1.386.
TEST(RelaxationDrawing, RoundedCoordinatesCostNoCohesion) {
    const double weight = 4 * 2700 * 9.81;
    const double whole = (20e3 * 4 + weight * std::cos(degrees(30)) * std::tan(degrees(20))) / (weight / 2);
    // Half of the bracket, and the settlement of the springs.
    constexpr double resolution = 0.003;
    // A step under the middle, a slope of the upper support, a valley, a ridge; the same with supports that overlap the
    // slab.
    for (const Drawn& drawn : {Drawn{}, Drawn{"0", "-1e-6", "-1e-6"}, Drawn{"0", "-1e-5", "-1e-5"},
                               Drawn{"0", "-3e-4", "-3e-4"}, Drawn{"0", "-3e-4", "0"}, Drawn{"0", "0", "-3e-6"},
                               Drawn{"-3e-4", "-3e-4", "0"}, Drawn{"0", "1e-6", "1e-6"}, Drawn{"0", "3e-4", "3e-4"},
                               Drawn{"0", "3e-4", "0"}, Drawn{"3e-4", "3e-4", "0"}, Drawn{"-3e-4", "3e-4", "0"}}) {
        const Analysis found = analysis_of_slab(drawn);
        EXPECT_NEAR(factor_of_slab(found), whole, resolution) << drawn.left << ' ' << drawn.right << ' ' << drawn.step;
        EXPECT_FALSE(warns_of_open_joints(found));
    }
}

TEST(RelaxationDrawing, OpenJointsAreSaidToHaveNoCohesion) {
    const Analysis open = analysis_of_slab({"0", "-3e-3", "-3e-3"});
    EXPECT_NEAR(factor_of_slab(open), 1.386, 0.003) << "cohesion along half of the slab";
    EXPECT_TRUE(warns_of_open_joints(open));
    // Wedges that narrow to nothing where the supports meet.
    EXPECT_TRUE(warns_of_open_joints(analysis_of_slab({"0", "-5e-3", "0"})));
    EXPECT_TRUE(warns_of_open_joints(analysis_of_slab({"-5e-3", "0", "0"})));
}

// The block's own joint has less friction and more cohesion than that of its base.
TEST(RelaxationDrawing, FacesOfUnlikeJointsAreNamed) {
    const auto warns_of_unlike_faces = [](std::string_view cohesion_of_base) {
        const std::string text = R"(schema = 1
model = "relaxation"
[scene]
kind = "blocks"
tilt = "15 deg"
joint = [{ friction_angle = "20 deg", cohesion = "50 kPa" }, { friction_angle = "21 deg", cohesion = "COHESION" }]
block = [
    { density = "2700 kg/m3", vertex = [{ x = "0 m", y = "0 m" }, { x = "2 m", y = "0 m" }, { x = "2 m", y = "1 m" }, { x = "0 m", y = "1 m" }] },
    { density = "2700 kg/m3", hold = "fixed", vertex = [{ x = "-4 m", y = "-1 m" }, { x = "9 m", y = "-1 m" }, { x = "9 m", y = "0 m", joint = 2 }, { x = "-4 m", y = "0 m" }] },
]
[settings]
stop = "onset"
)";
        const Analysis found = analyse_model(parse_case(changed(text, "COHESION", cohesion_of_base), "case").model);
        return std::ranges::any_of(found.warnings, [](const std::string& warning) {
            return warning.find("block 1 and block 2 touch differ") != std::string::npos;
        });
    };
    EXPECT_TRUE(warns_of_unlike_faces("0 kPa"));
    EXPECT_FALSE(warns_of_unlike_faces("50 kPa"));
}

// Between walls lie two blocks and, in a corner, three small ones, the least of 0.02 m; coordinates are rounded to a
// micrometre. All runs up to 62.8 deg come to rest where they begin. Searches said 35 to 61 deg, by their upper bound,
// where the least block slipped on the way of the static solver to the balance.
constexpr std::string_view corner_text = R"(schema = 1
model = "relaxation"
[scene]
kind = "blocks"
tilt = "0 deg"
joint = [{ friction_angle = "20.47 deg" }, { friction_angle = "48.56 deg" }, { friction_angle = "23.41 deg" }, { friction_angle = "13.98 deg" }]
block = [
    { density = "2700 kg/m3", vertex = [{ x = "5.845264 m", y = "4 m" }, { x = "5.825264 m", y = "4 m", joint = 4 }, { x = "5.840393 m", y = "3.982684 m", joint = 3 }] },
    { density = "2700 kg/m3", vertex = [{ x = "0 m", y = "0 m" }, { x = "4.339962 m", y = "0 m", joint = 2 }, { x = "3.140179 m", y = "4 m" }, { x = "0 m", y = "4 m" }] },
    { density = "2700 kg/m3", vertex = [{ x = "4.339962 m", y = "0 m" }, { x = "6 m", y = "0 m" }, { x = "6 m", y = "3.8 m", joint = 4 }, { x = "5.825264 m", y = "4 m" }, { x = "3.140179 m", y = "4 m", joint = 2 }] },
    { density = "2700 kg/m3", vertex = [{ x = "5.861197 m", y = "4 m" }, { x = "5.845264 m", y = "4 m", joint = 3 }, { x = "5.840393 m", y = "3.982684 m", joint = 4 }, { x = "5.874476 m", y = "3.943673 m", joint = 3 }] },
    { density = "2700 kg/m3", vertex = [{ x = "6 m", y = "3.8 m" }, { x = "6 m", y = "4 m" }, { x = "5.861197 m", y = "4 m", joint = 3 }, { x = "5.874476 m", y = "3.943673 m", joint = 4 }] },
    { density = "2700 kg/m3", hold = "fixed", vertex = [{ x = "-4 m", y = "-1 m" }, { x = "10 m", y = "-1 m" }, { x = "10 m", y = "0 m" }, { x = "-4 m", y = "0 m" }] },
    { density = "2700 kg/m3", hold = "fixed", vertex = [{ x = "6 m", y = "0 m" }, { x = "8 m", y = "0 m" }, { x = "8 m", y = "4 m" }, { x = "6 m", y = "4 m" }] },
    { density = "2700 kg/m3", hold = "fixed", vertex = [{ x = "-2 m", y = "0 m" }, { x = "0 m", y = "0 m" }, { x = "0 m", y = "2.056294 m" }, { x = "-2 m", y = "2.056294 m" }] },
]
[critical]
parameter = "tilt"
lower = "0 deg"
upper = "limit deg"
tolerance = "0.01 deg"
)";

// On the path of growing gravity, 52 and 50 deg by bounds of 70 and 88: only the last of its ten steps sought a balance
// near by.
TEST(RelaxationDrawing, TheTiltOfASearchDoesNotHangOnItsBounds) {
    for (const char* upper : {"66", "70", "80", "88"}) {
        for (const char* path : {"preloaded", "gravity"}) {
            const std::string text = changed(corner_text, "limit", upper) + "path = \"" + path + "\"\n";
            const Analysis found = analyse_model(parse_case(text, "case").model);
            EXPECT_NEAR(std::get<double>(found.find("critical_tilt")->value), degrees(62.84), degrees(0.01))
                << upper << ' ' << path;
        }
    }
}

// Blocks on either side of a thin layer have no joint between them.
TEST(RelaxationDrawing, AThinLayerIsNoOpenJoint) {
    const Analysis layered = analyse_model(parse_case(R"(schema = 1
model = "relaxation"
[scene]
kind = "blocks"
tilt = "0 deg"
joint = [{ friction_angle = "30 deg", cohesion = "20 kPa" }]
[[scene.block]]
density = "2700 kg/m3"
hold = "fixed"
vertex = [{ x = "0 m", y = "-10 m" }, { x = "10 m", y = "-10 m" }, { x = "10 m", y = "0 m" }, { x = "0 m", y = "0 m" }]
[[scene.block]]
density = "2700 kg/m3"
vertex = [{ x = "0 m", y = "0 m" }, { x = "10 m", y = "0 m" }, { x = "10 m", y = "0.1 m" }, { x = "0 m", y = "0.1 m" }]
[[scene.block]]
density = "2700 kg/m3"
vertex = [{ x = "0 m", y = "0.1 m" }, { x = "10 m", y = "0.1 m" }, { x = "10 m", y = "10 m" }, { x = "0 m", y = "10 m" }]
)",
                                                      "case")
                                               .model);
    EXPECT_FALSE(warns_of_open_joints(layered));
}

}  // namespace
}  // namespace delabole
