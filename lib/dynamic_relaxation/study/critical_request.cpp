#include "dynamic_relaxation/study/critical_request.hpp"

namespace delabole {

CriticalParameter parameter_of(const CriticalRequest& request) {
    return static_cast<CriticalParameter>(request.index());
}

std::string_view name_of_critical(CriticalParameter parameter) {
    switch (parameter) {
    case CriticalParameter::tilt:
        return "critical_tilt";
    case CriticalParameter::friction:
        return "limiting_friction_angle";
    case CriticalParameter::strength_reduction:
        return "factor_of_safety";
    case CriticalParameter::weight:
        break;
    }
    return "critical_weight_factor";
}

}  // namespace delabole
