// Stepped surfaces along joint sets, as the reader knows them.
#include "cases/program/case/model_cases.hpp"
#include "limit_equilibrium/stepped_path/stepped_path.hpp"

#include <variant>

namespace delabole {
namespace {

// A slope of 60 m whose columns, 5 m wide, are pushed by a wedge.
SteppedPath example_path() {
    SteppedPath path{};
    path.search = {.mechanism = SteppedPathMechanism::slide_head_toppling,
                   .least_width = std::nullopt,
                   .greatest_retreat = std::nullopt};
    path.slope = {
        .height = 60, .face_dip = degrees(65), .upper_surface_dip = 0, .bench = std::nullopt, .toe_elevation = 100};
    path.steps = {.dip = degrees(10), .spacing = 3, .friction_angle = degrees(38), .cohesion = 0};
    path.risers = PathRisers{.dip = degrees(70), .spacing = 5, .friction_angle = degrees(35), .cohesion = 50e3};
    path.columns = PathColumns{.dip = degrees(-75), .spacing = 8, .friction_angle = degrees(35)};
    path.rock = {.unit_weight = 26e3};
    path.rock_bridges = RockBridges{.step_persistence = 1,
                                    .riser_persistence = 0.9,
                                    .cohesion = 1e6,
                                    .friction_angle = degrees(45),
                                    .tensile_strength = 200e3};
    path.water = WaterTable<>{.unit_weight = 9.81e3, .level = WaterDepth<>{8}};
    return path;
}

constexpr std::string_view path_parts = R"(
[sources]                           # where a value comes from, by its key
"steps.dip" = "mapping of the face"

[[expect]]                          # a value known otherwise: delabole verify compares
quantity = "factor_of_safety"
value = 1
tolerance = 10                      # absolute, or relative_tolerance
source = "an earlier analysis"
)";

}  // namespace

void check_case(Checker& checker, const SteppedPath& path) {
    const bool slides = path.search.mechanism == SteppedPathMechanism::sliding;
    if (path.search.mechanism != SteppedPathMechanism::toppling && !path.risers) {
        checker.complain("search.mechanism", "steps up along risers, so [risers] is required");
    }
    if (!slides && !path.columns) {
        checker.complain("search.mechanism", "moves columns, so [columns] is required");
    }
    if (path.slope.bench) {
        checker.complain("slope.bench", "is not covered: the ground is a face and an upper surface");
    }
    if (path.search.least_width && path.search.greatest_retreat &&
        !(*path.search.least_width < *path.search.greatest_retreat)) {
        checker.complain("search.least_width", "must be less than search.greatest_retreat");
    }
    std::visit(
        [&](const auto& water) {
            if constexpr (requires { water.level; }) {
                if (std::holds_alternative<WaterElevation<>>(water.level) && !path.slope.toe_elevation) {
                    checker.complain("water.water_elevation",
                                     "is an elevation, so slope.toe_elevation is required too");
                }
            }
        },
        path.water);
}

ModelExample<SteppedPath> example_case(const SteppedPath*) {
    return {example_path(), "The stepped surface that fails first", path_parts};
}

std::vector<Quantity> possible_outputs(const SteppedPath& path) {
    return model_interface(path).outputs;
}

}  // namespace delabole
