#include "plane_failure/dual.hpp"

namespace delabole {

template Equilibrium<Dual> evaluate(const PlaneFailure<Dual>& problem);

}  // namespace delabole
