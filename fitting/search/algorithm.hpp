// The minimisation algorithms that can be chosen; all are derivative-free and bounded.
#pragma once

namespace delabole {

enum class Algorithm {
    sbplx,     // local, simplex in subspaces; tolerates failures and kinks
    bobyqa,    // local, quadratic model; fastest where the objective is smooth
    cobyla,    // local, linear models
    crs2,      // global, random population
    direct_l,  // global, deterministic division of the box; ignores the starting point
    mlsl,      // global, local sbplx runs from a low-discrepancy sequence
    isres,     // global, evolution strategy; slow but reliable
};

constexpr bool is_global(Algorithm algorithm) {
    switch (algorithm) {
    case Algorithm::sbplx:
    case Algorithm::bobyqa:
    case Algorithm::cobyla:
        return false;
    case Algorithm::crs2:
    case Algorithm::direct_l:
    case Algorithm::mlsl:
    case Algorithm::isres:
        break;
    }
    return true;
}

}  // namespace delabole
