// Flexural toppling by limit equilibrium, as the reader knows it.
#include "cases/program/case/model_cases.hpp"

namespace delabole {
namespace {

FlexuralSlope example_slope() {
    FlexuralSlope slope{};
    slope.base_dip = degrees(30);
    slope.unit_weight = 26e3;
    slope.joint_friction_angle = degrees(25);
    slope.tensile_strength = 1e6;
    slope.cohesion = 5e6;
    slope.friction_angle = degrees(40);
    slope.contact_height = 1;
    slope.column = {{1, 4}, {1, 8}, {1, 6}};
    return slope;
}

constexpr std::string_view flexural_parts = R"(
[sources]                           # where a value comes from, by its key
"tensile_strength" = "bending tests"

[[expect]]                          # a value known otherwise: delabole verify compares
quantity = "toe_push"
value = "0 kN/m"
tolerance = "1 N/m"                 # absolute, or relative_tolerance
source = "the slope stands"
)";

}  // namespace

void check_case(Checker& checker, const FlexuralSlope& slope) {
    if (slope.column.empty()) {
        checker.complain("column", "is required: at least one [[column]]");
    }
}

ModelExample<FlexuralSlope> example_case(const FlexuralSlope*) {
    return {example_slope(), "Columns that bend out of a slope and break at their feet", flexural_parts};
}

std::vector<Quantity> possible_outputs(const FlexuralSlope& slope) {
    return model_interface(slope).outputs;
}

}  // namespace delabole
