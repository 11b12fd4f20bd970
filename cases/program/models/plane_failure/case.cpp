// Plane failure: checks of its case for the reader.
#include "cases/program/case/model_cases.hpp"
#include "cases/program/reader/units.hpp"
#include "plane_failure/plane_failure.hpp"

#include <variant>

namespace delabole {
namespace {

void check_water(Checker& checker, const PlaneFailure<>& model) {
    check_water_level(checker, model.water, model.slope.toe_elevation.has_value());
    if (const auto* line = std::get_if<PiezometricLineWater<>>(&model.water)) {
        if (line->point.empty()) {
            checker.complain("water", "needs at least one [[water.point]]");
        }
        check_increasing(checker, line->point, &PiezometricPoint<>::x, "water.point", "x");
    } else if (const auto* custom = std::get_if<CustomWater<>>(&model.water)) {
        check_increasing(checker, custom->crack, &PressurePoint<>::position, "water.crack", "position");
        check_increasing(checker, custom->base, &PressurePoint<>::position, "water.base", "position");
    }
}

void check_slope(Checker& checker, const PlaneFailure<>& model) {
    if (model.tension_crack && std::holds_alternative<CrackBaseElevation<>>(model.tension_crack->position) &&
        !model.slope.toe_elevation) {
        checker.complain("tension_crack.base_elevation", "is an elevation, so slope.toe_elevation is required too");
    }
    check_water(checker, model);
    check_strength(checker, "strength", model.strength);
    if (model.pond && model.pond->depth > model.slope.height) {
        checker.complain("pond.depth",
                         "must be at most slope.height = " + readable_quantity(model.slope.height, Dimension::length));
    }
    if (model.failure_plane.daylight_height && !(*model.failure_plane.daylight_height < model.slope.height)) {
        checker.complain("failure_plane.daylight_height", "must be less than slope.height = " +
                                                              readable_quantity(model.slope.height, Dimension::length));
    }
    check_surcharges(checker, model.surcharge);
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
    if (study.critical) {
        check_bounds(checker, "critical", "dip", study.critical->lower_dip, study.critical->upper_dip);
    }
    check_required(checker, study.required, study);
    for (std::size_t index = 0; study.critical && index < study.required.size(); ++index) {
        const std::string& parameter = study.required[index].parameter;
        const bool of_crack = parameter.starts_with("tension_crack.") && parameter != "tension_crack.dip" &&
                              study.critical->find != CriticalFeature::failure_plane;
        const bool of_plane =
            parameter == "failure_plane.dip" && study.critical->find != CriticalFeature::tension_crack;
        if (of_crack || of_plane) {
            checker.complain(indexed("required", index) + ".parameter",
                             '"' + parameter + "\" is what [critical] searches for: remove one of the two");
        }
    }
}

std::vector<Quantity> possible_outputs(const PlaneFailureStudy<>&) {
    PlaneFailureStudy<> with_datum{};
    with_datum.model.slope.toe_elevation = 0;
    return model_interface(with_datum).outputs;
}

}  // namespace delabole
