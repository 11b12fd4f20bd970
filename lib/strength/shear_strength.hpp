// Shear stress at failure for a given effective normal stress; see strength.hpp for the laws and their sources.
#pragma once

#include "strength/strength.hpp"

#include <numbers>

namespace delabole {

namespace detail {

template <class T>
T tangent(const T& angle) {
    using std::tan;
    return T(tan(angle));
}

template <class T>
T natural_logarithm(const T& value) {
    using std::log;
    return T(log(value));
}

template <class T>
T exponential(const T& value) {
    using std::exp;
    return T(exp(value));
}

}  // namespace detail

template <class T>
T shear_strength(const Coulomb<T>& law, const T& normal_stress) {
    return law.cohesion + normal_stress * detail::tangent(law.friction_angle);
}

template <class T>
T shear_strength(const SteppedSurface<T>& law, const T& normal_stress) {
    return law.cohesion + normal_stress * detail::tangent(T(law.friction_angle + law.roughness_angle));
}

template <class T>
T shear_strength(const PattonBilinear<T>& law, const T& normal_stress) {
    const T steep = detail::tangent(T(law.friction_angle + law.roughness_angle));
    if (normal_stress <= law.transition_stress) {
        return normal_stress * steep;
    }
    return law.transition_stress * steep +
           (normal_stress - law.transition_stress) * detail::tangent(law.friction_angle);
}

// Zero in tension, because the law has no cohesion.
template <class T>
T shear_strength(const BartonBandis<T>& law, const T& normal_stress) {
    if (!(normal_stress > 0)) {
        return T(0);
    }
    const T decades = detail::natural_logarithm(T(law.joint_wall_strength / normal_stress)) / std::numbers::ln10;
    T angle = law.residual_friction_angle;
    if (decades > 0) {
        // JRC is in degrees per decade of stress.
        angle += law.joint_roughness_coefficient * decades * degrees(1);
    }
    if (angle > degrees(70)) {
        angle = T(degrees(70));
    }
    return normal_stress * detail::tangent(angle);
}

template <class T>
T shear_strength(const PowerCurve<T>& law, const T& normal_stress) {
    const T shifted = normal_stress + law.stress_offset;
    if (!(shifted > 0)) {
        return law.cohesion;
    }
    const T ratio = shifted / law.reference_stress;
    return law.cohesion + law.coefficient * law.reference_stress *
                              detail::exponential(T(law.exponent * detail::natural_logarithm(ratio)));
}

// Never negative: below the stress at which an envelope crosses zero the strength is zero.
template <class T>
T shear_strength(const StrengthLaw<T>& law, const T& normal_stress) {
    const T strength = std::visit([&](const auto& form) { return shear_strength(form, normal_stress); }, law);
    return strength < 0 ? T(0) : strength;  // NaN stays NaN, and a strength of exactly zero keeps its derivative
}

// Whether phi + i is below 90 deg, if the law adds them.
template <class T>
bool friction_below_90_degrees(const StrengthLaw<T>& law) {
    const auto check = [](const auto& form) {
        if constexpr (requires { form.roughness_angle; }) {
            return form.friction_angle + form.roughness_angle <= degrees(89.9);
        } else {
            return true;
        }
    };
    return std::visit(check, law);
}

}  // namespace delabole
