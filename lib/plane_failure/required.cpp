#include "plane_failure/required.hpp"

#include "numerics/scalar_search.hpp"
#include "plane_failure/dual.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/stability.hpp"

#include <limits>

namespace delabole {

Required required_value(const PlaneFailureStudy<>& study, const std::string& parameter, double target,
                        const std::vector<std::string>& also) {
    return find_required_value(study.model, parameter, also, target, [&](const PlaneFailure<>& varied) {
        const ResolvedStudy resolved = resolve({varied, study.critical, {}});
        return resolved.check == PlaneFailureCheck::valid ? factor_of_safety(resolved.problem).value
                                                          : std::numeric_limits<double>::quiet_NaN();
    });
}

OptimumBolt optimum_bolt_plunge(const PlaneFailure<>& problem) {
    if (problem.bolt.empty()) {
        return {0, 0};
    }
    PlaneFailure<Dual> dual = with_scalar<PlaneFailure<Dual>>(problem);
    for_each_number(dual, [](Dual& number, const FieldInfo&) { number = constant(number.value()); });
    const auto factor = [&](double plunge) {
        dual.bolt.front().plunge = variable(plunge);
        const Equilibrium<Dual> forces = evaluate(dual);
        return forces.check == PlaneFailureCheck::valid ? forces.stability.factor_of_safety
                                                        : constant(-std::numeric_limits<double>::infinity());
    };
    const ScalarMinimum minimum = minimise_scalar([&](double plunge) { return -factor(plunge).value(); },
                                                  [&](double plunge) { return -factor(plunge).derivatives()(0); },
                                                  -problem.failure_plane.dip, degrees(90), 37);
    const bool found = minimum.value < std::numeric_limits<double>::infinity();
    return found ? OptimumBolt{minimum.position, -minimum.value} : OptimumBolt{0, 0};
}

}  // namespace delabole
