// Rows of blocks on a plane as the reader knows them.
#include "cases/program/case/model_cases.hpp"
#include "limit_equilibrium/block_row/block_row.hpp"

namespace delabole {
namespace {

BlockRow<> example_row() {
    BlockRow<> row{};
    row.base = {.inclination = degrees(15), .friction_angle = degrees(30)};
    row.interface = {.friction_angle = degrees(20)};
    for (const double height : {3.0, 4.0, 3.0}) {
        row.block.push_back({height, 1, UnitWeightOfBlock<>{26e3}, {}, {}});
    }
    return row;
}

constexpr std::string_view block_row_parts = R"(
[sources]                           # where a value comes from, by its key
"base.friction_angle" = "tilting test"

[[expect]]                          # a value known otherwise: delabole verify compares
quantity = "critical_tilt"
value = "18.4 deg"
tolerance = "10 deg"                # absolute, or relative_tolerance
with = { "block[1].height" = "3.1 m" }  # inputs that differ
source = "an earlier analysis"

[[expect]]                          # of one mode, by its letters
quantity = "mode.FPB.admissibility"
value = "admissible"
)";

}  // namespace

void check_case(Checker& checker, const BlockRow<>& row) {
    if (row.block.empty()) {
        checker.complain("block", "is required: at least one [[block]]");
    }
}

ModelExample<BlockRow<>> example_case(const BlockRow<>*) {
    return {example_row(), "A row of blocks on an inclined plane", block_row_parts};
}

std::vector<Quantity> possible_outputs(const BlockRow<>&) {
    return model_interface(example_row()).outputs;
}

}  // namespace delabole
