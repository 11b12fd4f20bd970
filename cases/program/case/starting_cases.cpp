#include "cases/program/case/starting_cases.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace delabole {

namespace {

struct StartingCase {
    std::string_view name;
    std::string_view text;
};

constexpr std::string_view plane_failure = R"(schema = 1
model = "plane_failure"
title = "My slope"

[slope]
height = "12 m"
face_dip = "60 deg"
upper_surface_dip = "0 deg"

[failure_plane]
dip = "35 deg"

[tension_crack]
dip = "90 deg"
distance_behind_crest = "4 m"

[rock]
unit_weight = "26 kN/m3"

[strength]
kind = "coulomb"
cohesion = "25 kPa"
friction_angle = "37 deg"

[water]
kind = "dry"  # or "crack_and_base", with unit_weight = "9.81 kN/m3" and water_depth = "3 m"
)";

constexpr StartingCase cases[] = {
    {"plane_failure", plane_failure},
    {"stepped_base", R"(schema = 1
model = "stepped_base"
title = "My columns"

[slope]
height = "60 m"
face_dip = "65 deg"
upper_surface_dip = "0 deg"

[columns]
kind = "continuous"
joint_dip = "70 deg"
spacing = "5 m"
base_inclination = "35 deg"

[rock]
unit_weight = "26 kN/m3"

[water]
kind = "dry"

[joints]
friction_angle = "35 deg"

[bases]
friction_angle = "38 deg"
cohesion = "0 kPa"
)"},
    {"stepped_path", R"(schema = 1
model = "stepped_path"
title = "My joint sets, and the surface that fails first"

[search]
mechanism = "slide_head_toppling"

[slope]
height = "60 m"
face_dip = "65 deg"
upper_surface_dip = "0 deg"

[steps]
dip = "10 deg"
spacing = "3 m"
friction_angle = "38 deg"
cohesion = "0 kPa"

[risers]
dip = "70 deg"
spacing = "5 m"
friction_angle = "35 deg"
cohesion = "50 kPa"

[columns]
dip = "-75 deg"
spacing = "8 m"
friction_angle = "35 deg"

[rock]
unit_weight = "26 kN/m3"

[water]
kind = "dry"
)"},
    {"single_block", R"(schema = 1
model = "single_block"
title = "My block"

[block]
height = "3 m"
width = "1 m"
unit_weight = "26 kN/m3"

[base]
inclination = "15 deg"
friction_angle = "30 deg"
cohesion = "0 kPa"
)"},
    {"block_row", R"(schema = 1
model = "block_row"
title = "My row of blocks"
block = [
    { height = "3 m", width = "1 m", unit_weight = "26 kN/m3" },
    { height = "4 m", width = "1 m", unit_weight = "26 kN/m3" },
    { height = "3 m", width = "1 m", unit_weight = "26 kN/m3" },
]

[base]
inclination = "15 deg"
friction_angle = "30 deg"

[interface]
friction_angle = "20 deg"
)"},
    {"tilted_column", R"(schema = 1
model = "tilted_column"
title = "My column with water behind it"
joint_dip = "70 deg"
saturated_tilt = "47.5 deg"
filled_ratio = 0.5
)"},
    {"kinematics", R"(schema = 1
model = "kinematics"
title = "My joint sets"
# Measured planes instead: poles = [{ file = "my_poles.csv" }], a table with columns dip and dip_direction
joint_set = [
    { name = "bedding", dip = "40 deg", dip_direction = "95 deg" },
    { name = "joints", dip = "80 deg", dip_direction = "275 deg" },
    { name = "cross_joints", dip = "85 deg", dip_direction = "185 deg" },
]

[slope]
face_dip = "70 deg"
face_dip_direction = "95 deg"

[strength]
friction_angle = "30 deg"

[lateral_limit]
planar_sliding = "20 deg"
flexural_toppling = "30 deg"
direct_toppling = "20 deg"
)"},
    {"relaxation", R"(schema = 1
model = "relaxation"
title = "My blocks"

[scene]
kind = "row"
tilt = "20 deg"
density = "2650 kg/m3"
block = [
    { width = "1 m", height = "2 m" },
    { width = "1 m", height = "4 m" },
]

[scene.base]
friction_angle = "30 deg"

[scene.interface]
friction_angle = "30 deg"
)"},
    {"flexural_toppling", R"(schema = 1
model = "flexural_toppling"
title = "My bending columns"
base_dip = "30 deg"
unit_weight = "26 kN/m3"
joint_friction_angle = "25 deg"
tensile_strength = "1000 kPa"
cohesion = "5000 kPa"
friction_angle = "40 deg"
contact_height = 1.0
column = [
    { width = "1 m", height = "4 m" },
    { width = "1 m", height = "8 m" },
    { width = "1 m", height = "6 m" },
]
)"},
    {"wedge", R"(schema = 1
model = "wedge"
title = "My wedge"

[slope]
height = "20 m"
face_dip = "65 deg"
face_dip_direction = "185 deg"
upper_surface_dip = "10 deg"
upper_surface_dip_direction = "185 deg"

[plane_1]
dip = "45 deg"
dip_direction = "110 deg"
strength = { kind = "coulomb", cohesion = "20 kPa", friction_angle = "30 deg" }

[plane_2]
dip = "65 deg"
dip_direction = "235 deg"
strength = { kind = "coulomb", cohesion = "20 kPa", friction_angle = "30 deg" }

[rock]
unit_weight = "26 kN/m3"

[water]
kind = "dry"
)"},
    {"jointed_slope", R"(schema = 1
model = "relaxation"
title = "My jointed slope"

[scene]
kind = "jointed_slope"
# A drawing instead: outline_file = "my_slope.dxf"; where it has corners that turn inwards also intact_joint = "joints"
outline = [
    { x = "0 m", y = "0 m" },
    { x = "20 m", y = "0 m" },
    { x = "20 m", y = "12 m" },
    { x = "6 m", y = "12 m" },
]
rock = [{ name = "rock", density = "2650 kg/m3" }]
joint = [{ name = "joints", friction_angle = "35 deg" }]
cut = [
    { name = "bedding", joint = "joints", trace = { kind = "set", dip = "40 deg", spacing = "3 m" } },
    { name = "columns", joint = "joints", trace = { kind = "set", dip = "-70 deg", spacing = "3 m" } },
]

[scene.frame]
sides = "below_and_behind"
thickness = "2 m"
joint = "joints"

[critical]
parameter = "strength_reduction"
)"},
};

constexpr std::string_view fit = R"(
[[fit.parameter]]
name = "strength.friction_angle"
lower = "20 deg"
upper = "50 deg"
prior = { mean = "37 deg", standard_deviation = "3 deg" }

[[fit.parameter]]
name = "strength.cohesion"
lower = "0 kPa"
upper = "80 kPa"

[[fit.observation]]
label = "it failed"
quantity = "factor_of_safety"
value = 1
standard_deviation = 0.1
)";

constexpr std::string_view support = R"(
[[support]]
rows = 3
lowest_height = "2 m"
row_spacing = "2 m"
spacing = "2 m"
length = "8 m"
plunge = "10 deg"
capacity = "200 kN"
action = "active"

[support_design]
factor_of_safety = 2
cost_per_bolt = 150
cost_per_metre = 40
choose = [
    { input = "support[1].rows", from = 1, to = 5, points = 5 },
    { input = "support[1].spacing", from = "1.5 m", to = "3 m", points = 4 },
    { input = "support[1].length", from = "4 m", to = "12 m", points = 9 },
]
)";

constexpr std::string_view sensitivity = R"(
[sensitivity]
quantity = "factor_of_safety"

[sensitivity.failure]
limit = 1
side = "below"

[sensitivity.tornado]

[sensitivity.propagation]

[[sensitivity.parameter]]
name = "strength.friction_angle"
distribution = "normal"
mean = "37 deg"
standard_deviation = "3 deg"
lower = "25 deg"
upper = "50 deg"

[[sensitivity.parameter]]
name = "strength.cohesion"
distribution = "normal"
mean = "25 kPa"
standard_deviation = "8 kPa"
lower = "0 kPa"
upper = "60 kPa"
)";

}  // namespace

std::vector<std::string> starting_case_names() {
    std::vector<std::string> names;
    for (const StartingCase& one : cases) {
        names.emplace_back(one.name);
    }
    names.insert(names.end(), {"fit", "sensitivity", "support"});
    return names;
}

std::string starting_case(std::string_view name) {
    if (name == "fit" || name == "sensitivity") {
        return std::string(plane_failure).append(name == "fit" ? fit : sensitivity);
    }
    if (name == "support") {
        return std::string(plane_failure).append(support).append(sensitivity);
    }
    const auto found = std::ranges::find(cases, name, &StartingCase::name);
    if (found == std::end(cases)) {
        throw std::invalid_argument("no case to start from is named " + std::string(name));
    }
    return std::string(found->text);
}

}  // namespace delabole
