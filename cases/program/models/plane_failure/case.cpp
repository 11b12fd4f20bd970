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

}  // namespace

void check_case(Checker& checker, const PlaneFailureStudy<>& study) {
    check_slope(checker, study.model);
    if (study.critical && study.critical->lower_dip && study.critical->upper_dip &&
        !(*study.critical->lower_dip < *study.critical->upper_dip)) {
        checker.complain("critical.lower_dip", "bounds are reversed: must be less than critical.upper_dip");
    }
    check_required(checker, study.required, study);
}

std::vector<Quantity> possible_outputs(const PlaneFailureStudy<>&) {
    PlaneFailureStudy<> with_datum{};
    with_datum.model.slope.toe_elevation = 0;
    return model_interface(with_datum).outputs;
}

}  // namespace delabole
