// Plane failure as the reader knows it.
#include "cases/program/case/model_cases.hpp"
#include "cases/program/reader/units.hpp"
#include "plane_failure/plane_failure.hpp"

#include <variant>

namespace delabole {
namespace {

void check_elevation(Checker& checker, const PlaneFailure<>& model, const std::string& key) {
    if (!model.slope.toe_elevation) {
        checker.complain(key, "is an elevation, so slope.toe_elevation is required too");
    }
}

struct WaterChecks {
    Checker& checker;
    const PlaneFailure<>& model;

    void operator()(const Dry&) const {}
    void operator()(const PiezometricLineWater<>& water) const {
        if (water.point.empty()) {
            checker.complain("water", "needs at least one [[water.point]]");
        }
        check_increasing(checker, water.point, &PiezometricPoint<>::x, "water.point", "x");
    }
    void operator()(const CustomWater<>& water) const {
        check_increasing(checker, water.crack, &PressurePoint<>::position, "water.crack", "position");
        check_increasing(checker, water.base, &PressurePoint<>::position, "water.base", "position");
    }
    template <class WithLevel>
    void operator()(const WithLevel& water) const {
        if (std::holds_alternative<WaterElevation<>>(water.level)) {
            check_elevation(checker, model, "water.water_elevation");
        }
    }
};

void check_slope(Checker& checker, const PlaneFailure<>& model) {
    if (model.tension_crack && std::holds_alternative<CrackBaseElevation<>>(model.tension_crack->position)) {
        check_elevation(checker, model, "tension_crack.base_elevation");
    }
    std::visit(WaterChecks{checker, model}, model.water);
    check_strength(checker, "strength", model.strength);
    if (model.pond && model.pond->depth > model.slope.height) {
        checker.complain("pond.depth",
                         "must be at most slope.height = " + readable_quantity(model.slope.height, Dimension::length));
    }
    if (model.failure_plane.daylight_height && !(*model.failure_plane.daylight_height < model.slope.height)) {
        checker.complain("failure_plane.daylight_height", "must be less than slope.height = " +
                                                              readable_quantity(model.slope.height, Dimension::length));
    }
    for (std::size_t index = 0; index < model.surcharge.size(); ++index) {
        if (!(model.surcharge[index].from_distance < model.surcharge[index].to_distance)) {
            checker.complain(indexed("surcharge", index) + ".from_distance", "must be less than to_distance");
        }
    }
    for (std::size_t index = 0; index < model.support.size(); ++index) {
        check_support(checker, indexed("support", index), model.support[index].pattern, model.slope.height);
    }
    for (std::size_t index = 0; index < model.bolt.size(); ++index) {
        if (model.bolt[index].head_height > model.slope.height) {
            checker.complain(
                indexed("bolt", index) + ".head_height",
                "must be at most slope.height = " + readable_quantity(model.slope.height, Dimension::length));
        }
    }
}

// Wyllie & Mah (2004), example 7.1, with 3 m of water in the crack.
PlaneFailureStudy<> example_plane_failure() {
    PlaneFailureStudy<> study{};
    study.model.slope = {.height = 12,
                         .face_dip = degrees(60),
                         .upper_surface_dip = 0,
                         .bench = std::nullopt,
                         .toe_elevation = std::nullopt};
    study.model.failure_plane = {.dip = degrees(35), .daylight_height = std::nullopt};
    study.model.tension_crack = TensionCrack<>{.dip = degrees(90), .position = CrackAtDistance<>{4}};
    study.model.rock = {.unit_weight = 26e3};
    study.model.strength = Coulomb<>{.cohesion = 25e3, .friction_angle = degrees(37)};
    study.model.water = CrackAndBaseWater<>{.unit_weight = 9.81e3, .level = WaterDepth<>{3}};
    return study;
}

constexpr std::string_view study_parts = R"(
[sources]                           # where a value comes from, by its key
"slope.height" = "survey of 1966"

[[expect]]                          # a printed value: delabole verify compares
quantity = "factor_of_safety"
value = 1.247
tolerance = 0.001                   # absolute, or relative_tolerance
with = { "water.water_depth" = "3 m" }  # inputs that differ
source = "example 7.1"
note = "printed to three decimals"
# unreachable = "why the printed value cannot be reached: it is shown, but does not fail"
)";

}  // namespace

void check_case(Checker& checker, const PlaneFailureStudy<>& study) {
    check_slope(checker, study.model);
    if (study.critical && study.critical->lower_dip && study.critical->upper_dip &&
        !(*study.critical->lower_dip < *study.critical->upper_dip)) {
        checker.complain("critical.lower_dip", "bounds are reversed: must be less than critical.upper_dip");
    }
    check_required(checker, study.required, study);
}

ModelExample<PlaneFailureStudy<>> example_case(const PlaneFailureStudy<>*) {
    return {example_plane_failure(), "Plane failure of a slope 12 m high", study_parts};
}

std::vector<Quantity> possible_outputs(const PlaneFailureStudy<>&) {
    PlaneFailureStudy<> with_datum{};
    with_datum.model.slope.toe_elevation = 0;
    return model_interface(with_datum).outputs;
}

}  // namespace delabole
