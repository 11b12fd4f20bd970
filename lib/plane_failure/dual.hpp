// A number with its derivative along one direction, for exact derivatives of the templates in this folder.
#pragma once

// AutoDiff needs Eigen/Core but does not include it.
#include <Eigen/Core>

#include <unsupported/Eigen/AutoDiff>

#include "plane_failure/stability.hpp"

namespace delabole {

using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;

inline Dual constant(double value) {
    return {value, Eigen::Matrix<double, 1, 1>::Zero()};
}
inline Dual variable(double value) {
    return {value, Eigen::Matrix<double, 1, 1>::Ones()};
}

// AutoDiff would compute sine and cosine twice, also for an angle that is a constant 0 or 90 deg.
template <>
inline SineCosine<Dual> sine_cosine(const Dual& angle) {
    const SineCosine<double> value = sine_cosine(angle.value());
    return {Dual(value.sine, value.cosine * angle.derivatives()),
            Dual(value.cosine, -value.sine * angle.derivatives())};
}

// Compiled once, in dual.cpp, because it takes long.
extern template Equilibrium<Dual> evaluate(const PlaneFailure<Dual>& problem);

}  // namespace delabole
