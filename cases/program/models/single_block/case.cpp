// A single block on a plane as the reader knows it.
#include "cases/program/case/model_cases.hpp"
#include "cases/program/reader/units.hpp"

namespace delabole {
namespace {

SingleBlock<> example_block() {
    SingleBlock<> problem{};
    problem.block = {.height = 3, .width = 1, .unit_weight = 26e3};
    problem.base = {.inclination = degrees(15), .friction_angle = degrees(30), .cohesion = 0};
    return problem;
}

constexpr std::string_view single_block_parts = R"(
[sources]                           # where a value comes from, by its key
"block.height" = "survey"

[[expect]]                          # a value known otherwise: delabole verify compares
quantity = "critical_toppling_inclination"
value = "18.435 deg"
tolerance = "0.001 deg"             # absolute, or relative_tolerance
source = "arc tangent of width over height"

[[expect]]                          # a word
quantity = "onset_mode"
value = "stable"
)";

}  // namespace

void check_case(Checker& checker, const SingleBlock<>& problem) {
    if (!problem.water) {
        return;
    }
    const auto check_depth = [&](const std::string& key, double depth) {
        if (depth > problem.block.height) {
            checker.complain(
                key, "exceeds the height of the block, " + readable_quantity(problem.block.height, Dimension::length));
        }
    };
    check_depth("water.depth_behind", problem.water->depth_behind);
    check_depth("water.depth_in_front", problem.water->depth_in_front.value_or(0));
}

ModelExample<SingleBlock<>> example_case(const SingleBlock<>*) {
    return {example_block(), "One block on an inclined plane", single_block_parts};
}

std::vector<Quantity> possible_outputs(const SingleBlock<>&) {
    return model_interface(example_block()).outputs;
}

}  // namespace delabole
