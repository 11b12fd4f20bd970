#include "wedge_failure/wedge_failure.hpp"

#include "kinematics/orientation.hpp"

#include <cmath>
#include <limits>

namespace delabole {

namespace {

double trend_of(const Direction& direction) {
    return wrapped_azimuth(std::atan2(direction.x(), direction.y()));
}

double plunge_of(const Direction& direction) {
    return std::atan2(-direction.z(), std::hypot(direction.x(), direction.y()));
}

WedgeFailureResult result_of(const WedgeGeometry& wedge, const WedgeStability& stability) {
    WedgeFailureResult result;
    result.check = WedgeFailureCheck::valid;
    result.contact = stability.contact;
    result.factor_of_safety = stability.factor_of_safety;
    result.line_plunge = plunge_of(wedge.line);
    result.line_trend = trend_of(wedge.line);
    if (stability.contact != SlidingContact::none) {
        result.sliding_plunge = plunge_of(stability.sliding);
        result.sliding_trend = trend_of(stability.sliding);
    }
    result.volume = wedge.volume;
    result.weight = stability.weight;
    result.area_1 = wedge.area_1;
    result.area_2 = wedge.area_2;
    result.crack_area = wedge.crack_area;
    result.crack_depth = wedge.crack_depth;
    result.height_of_line = wedge.line_top.z();
    result.water_force_1 = stability.water_force_1;
    result.water_force_2 = stability.water_force_2;
    result.crack_water_force = stability.crack_water_force;
    result.normal_force_1 = stability.normal_force_1;
    result.normal_force_2 = stability.normal_force_2;
    result.driving_force = stability.driving_force;
    result.resisting_force = stability.resisting_force;
    return result;
}

}  // namespace

WedgeFailureResult analyse(const WedgeFailure& problem) {
    WedgeFailureResult result;
    if (!in_range(problem)) {
        return result;
    }
    const WedgeEquilibrium forces = evaluate(problem);
    if (forces.check == WedgeFailureCheck::valid) {
        return result_of(forces.wedge, forces.stability);
    }
    result.check = forces.check;
    return result;
}

Required required_value(const WedgeFailure& problem, const std::string& parameter, double target,
                        const std::vector<std::string>& also) {
    return find_required_value(problem, parameter, also, target, [](const WedgeFailure& varied) {
        const WedgeEquilibrium forces = evaluate(varied);
        return forces.check == WedgeFailureCheck::valid ? forces.stability.factor_of_safety
                                                        : std::numeric_limits<double>::quiet_NaN();
    });
}

ModelInterface model_interface(const WedgeFailureStudy& study) {
    return interface_of_function(study.model, WedgeFailureResult{},
                                 [](const WedgeFailure& varied) { return prediction_of(analyse(varied)); });
}

}  // namespace delabole
