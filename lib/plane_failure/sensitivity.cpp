#include "plane_failure/sensitivity.hpp"

#include "plane_failure/dual.hpp"
#include "plane_failure/stability.hpp"

namespace delabole {

SensitivityResult sensitivities(const PlaneFailure<>& problem) {
    SensitivityResult result{PlaneFailureCheck::valid, 0, {}};
    PlaneFailure<Dual> dual = with_scalar<PlaneFailure<Dual>>(problem);
    for_each_number(dual, [](Dual& number, const FieldInfo&) { number = constant(number.value()); });
    std::vector<Dual*> numbers;
    for_each_named_number(dual, [&](const std::string& path, const FieldInfo& info, Dual& number) {
        numbers.push_back(&number);
        result.derivatives.push_back({path, info.dimension, number.value(), 0});
    });
    for (std::size_t index = 0; index < numbers.size(); ++index) {
        *numbers[index] = variable(numbers[index]->value());
        const Equilibrium<Dual> forces = evaluate(dual);
        *numbers[index] = constant(numbers[index]->value());
        if (forces.check != PlaneFailureCheck::valid) {
            return {forces.check, 0, {}};
        }
        result.factor_of_safety = forces.stability.factor_of_safety.value();
        result.derivatives[index].derivative = forces.stability.factor_of_safety.derivatives()(0);
    }
    return result;
}

}  // namespace delabole
