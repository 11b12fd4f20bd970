// What concerns several inputs of a model at once and can be judged without running it.
#include "cases/case_parts.hpp"
#include "cases/spelling.hpp"

#include <cmath>
#include <variant>

namespace delabole {
namespace {

class Checker {
  public:
    Checker(Reading& reading, std::string prefix) : reading_(&reading), prefix_(std::move(prefix)) {}

    // At the mechanism's own key where it has one, otherwise at the case's.
    void complain(const std::string& key, std::string message) {
        reading_->complain_at(reading_->knows(prefix_ + key) ? prefix_ + key : key, std::move(message));
    }

  private:
    Reading* reading_;
    std::string prefix_;
};

std::string indexed(const std::string& key, std::size_t index) {
    return key + "[" + std::to_string(index + 1) + "]";
}

// Calls complain for the first point whose coordinate does not exceed the one before.
template <class Point, class Coordinate>
void check_increasing(Checker& checker, const std::vector<Point>& points, Coordinate coordinate, const std::string& key,
                      const std::string& name) {
    for (std::size_t index = 1; index < points.size(); ++index) {
        if (!(points[index].*coordinate > points[index - 1].*coordinate)) {
            checker.complain(indexed(key, index) + "." + name, "must be more than that of the point before");
            return;
        }
    }
}

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

struct StrengthChecks {
    Checker& checker;

    template <class Law>
    void operator()(const Law& law) const {
        if constexpr (requires { law.friction_angle + law.roughness_angle; }) {
            if (!(law.friction_angle + law.roughness_angle < degrees(90))) {
                checker.complain("strength.roughness_angle",
                                 "friction_angle + roughness_angle must be less than 90 deg");
            }
        }
    }
};

void check(Checker& checker, const PlaneFailure<>& model) {
    if (model.tension_crack && std::holds_alternative<CrackBaseElevation<>>(model.tension_crack->position)) {
        check_elevation(checker, model, "tension_crack.base_elevation");
    }
    std::visit(WaterChecks{checker, model}, model.water);
    std::visit(StrengthChecks{checker}, model.strength);
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
    for (std::size_t index = 0; index < model.bolt.size(); ++index) {
        if (model.bolt[index].head_height > model.slope.height) {
            checker.complain(
                indexed("bolt", index) + ".head_height",
                "must be at most slope.height = " + readable_quantity(model.slope.height, Dimension::length));
        }
    }
}

void check(Checker& checker, const PlaneFailureStudy<>& study) {
    check(checker, study.model);
    if (study.critical && study.critical->lower_dip && study.critical->upper_dip &&
        !(*study.critical->lower_dip < *study.critical->upper_dip)) {
        checker.complain("critical.lower_dip", "bounds are reversed: must be less than critical.upper_dip");
    }
    const std::vector<std::string> inputs = names_in(named_inputs(study));
    for (std::size_t index = 0; index < study.required.size(); ++index) {
        const std::string& name = study.required[index].parameter;
        if (std::ranges::find(inputs, name) == inputs.end()) {
            checker.complain(indexed("required", index) + ".parameter",
                             "is not an input of this case" + suggestion(name, inputs));
        }
    }
}

void check(Checker&, const TiltedColumn<>&) {}

}  // namespace

void check_model(Reading& reading, const CaseModel& model, const std::string& prefix) {
    Checker checker(reading, prefix);
    std::visit([&](const auto& alternative) { check(checker, alternative); }, model);
}

}  // namespace delabole
