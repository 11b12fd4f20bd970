// A complete case to break in one place at a time.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace delabole::testing {

inline constexpr std::string_view example_text = R"(schema = 1
title = "Example"
model = "plane_failure"

[slope]
height = "225 ft"
face_dip = "70 deg"
upper_surface_dip = "0 deg"

[failure_plane]
dip = "40 deg"

[tension_crack]
dip = "90 deg"
depth = "40 m"

[rock]
unit_weight = "26 kN/m3"

[strength]
kind = "coulomb"
cohesion = "30 lbf/in^2"
friction_angle = "30 deg"

[water]
kind = "crack_and_base"
unit_weight = "9.81 kN/m3"
water_depth = "10 m"
)";

inline constexpr std::string_view fit_text = R"(
[fit]
algorithm = "bobyqa"

[[fit.parameter]]
name = "strength.friction_angle"
lower = "20 deg"
upper = "45 deg"

[[fit.observation]]
label = "it failed"
quantity = "factor_of_safety"
value = 1
standard_deviation = 0.05
)";

// To be appended to example_text: a mechanism of the case's own model and one of another model.
inline constexpr std::string_view two_models = R"(
[fit]
[[fit.mechanism]]
name = "sliding"
[[fit.mechanism.parameter]]
name = "water.water_depth"
lower = "0 m"
upper = "40 m"
[[fit.mechanism]]
name = "tilting"
model = "tilted_column"
joint_dip = "70 deg"
saturated_tilt = "47.5 deg"
filled_ratio = 0.5
[[fit.mechanism.parameter]]
name = "filled_ratio"
lower = 0
upper = 1
[[fit.observation]]
label = "tilt"
quantity = "tilt"
value = "12 deg"
standard_deviation = "1 deg"
)";

// To be inserted behind the second mechanism's parameter: its own observation and evidence, and a surrogate.
inline constexpr std::string_view own_terms = R"(
[[fit.mechanism.observation]]
label = "tilt"
quantity = "tilt"
relation = "at_least"
value = "10 deg"
standard_deviation = "2 deg"
[[fit.mechanism.shows]]
evidence = "leaning_columns"
quantity = "tilt"
relation = "at_least"
value = "5 deg"
[[fit.evidence]]
name = "leaning_columns"
statement = "columns lean"
[fit.surrogate]
runs = 50
first_runs = 20
tolerance = 0.05
)";

// The text with its first `from` replaced by `to`.
inline std::string changed(std::string_view text, std::string_view from, std::string_view to) {
    std::string result(text);
    const std::size_t position = result.find(from);
    EXPECT_NE(position, std::string::npos) << from;
    return position == std::string::npos ? result : result.replace(position, from.size(), to);
}

inline std::string complaint(std::string_view text, const std::vector<Setting>& settings = {}) {
    try {
        parse_case(text, "slope.toml", settings);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "no complaint";
}

inline void expect_complaint(std::string_view text, std::string_view words) {
    const std::string said = complaint(text);
    EXPECT_NE(said.find(words), std::string::npos) << said;
}

inline std::string complaint_after(std::string_view from, std::string_view to) {
    return complaint(changed(example_text, from, to));
}

inline std::string fit_complaint(std::string_view from, std::string_view to) {
    return complaint(changed(std::string(example_text) + std::string(fit_text), from, to));
}

inline const PlaneFailure<>& plane_failure(const CaseFile& case_file) {
    return std::get<PlaneFailureStudy<>>(case_file.model).model;
}

}  // namespace delabole::testing
