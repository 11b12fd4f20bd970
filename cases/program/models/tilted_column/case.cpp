// Groundwater by tilting, as the reader knows it.
#include "cases/program/case/model_cases.hpp"
#include "water/column_tilt.hpp"

namespace delabole {
namespace {

constexpr std::string_view column_parts = R"(
[[expect]]                          # a printed value: delabole verify compares
quantity = "tilt"
value = "12 deg"
tolerance = "0.5 deg"               # absolute, or relative_tolerance
source = "tilting test"
)";

}  // namespace

void check_case(Checker&, const TiltedColumn<>&) {}

ModelExample<TiltedColumn<>> example_case(const TiltedColumn<>*) {
    return {{.joint_dip = degrees(70), .saturated_tilt = degrees(47.5), .filled_ratio = 0.5},
            "Groundwater by tilting",
            column_parts};
}

std::vector<Quantity> possible_outputs(const TiltedColumn<>&) {
    return model_interface(TiltedColumn<>{}).outputs;
}

}  // namespace delabole
