// Sliding on steps: the surface of least factor of safety as the least ratio of two lengths of a path. See
// path_search.hpp.
#pragma once

#include "limit_equilibrium/stepped_path/path_search.hpp"

namespace delabole {

CriticalPath least_stable_sliding(const SteppedPath& problem, const PathLattice& lattice);

// The same for one surface alone.
Limit sliding_limit(const SteppedPath& problem, const PathLattice& lattice, const LatticePath& path);

}  // namespace delabole
