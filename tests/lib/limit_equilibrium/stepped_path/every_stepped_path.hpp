// Slopes with so few joints that every stepped surface can be tried, and all of these surfaces.
#pragma once

#include "limit_equilibrium/stepped_path/path_search.hpp"
#include "tests/lib/limit_equilibrium/stepped_path/west_face.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace delabole {

inline SteppedPath random_path(std::mt19937& random, SteppedPathMechanism mechanism) {
    const auto between = [&](double lower, double upper) {
        return std::uniform_real_distribution<>(lower, upper)(random);
    };
    SteppedPath path = west_face(mechanism);
    path.slope = {between(20, 40), degrees(between(50, 89)), degrees(between(-10, 10)), std::nullopt, std::nullopt};
    path.steps = {degrees(between(-10, 25)), between(6, 12), degrees(between(10, 45)), between(0, 100e3)};
    path.risers = PathRisers{degrees(between(50, 88)), between(4, 8), degrees(between(10, 45)), between(0, 50e3)};
    path.columns = PathColumns{degrees(between(-89, -60)), between(4, 9), degrees(between(10, 45))};
    path.search.greatest_retreat = between(15, 25);
    path.search.least_width = between(0, 6);
    if (between(0, 1) < 0.5) {
        path.rock_bridges = RockBridges{between(0.8, 1), between(0.8, 1), 500e3, degrees(40), between(0, 100e3)};
    }
    path.water = WaterDrawnDown{9.81e3, WaterDepth<>{between(0, 30)}, between(5, 50)};
    return path;
}

// Calls `visit` with every run of columns from the face up, wherever it ends.
inline void visit_columns(const PathLattice& lattice, const std::function<void(const LatticePath&)>& visit) {
    const std::function<void(const LatticePath&)> grow = [&](const LatticePath& path) {
        visit(path);
        const std::size_t last = path.first + path.level.size() - 1;
        for (std::size_t level = path.level.back(); last < lattice.cells.size() && level < lattice.levels; ++level) {
            const PathCell& above = lattice.cells[last][level];
            if (above.exists && !above.at_face) {
                LatticePath longer = path;
                longer.level.push_back(level);
                grow(longer);
            }
        }
    };
    for (std::size_t column = 0; column < lattice.cells.size(); ++column) {
        for (std::size_t level = 0; level < lattice.levels; ++level) {
            if (lattice.cells[column][level].exists && lattice.cells[column][level].at_face) {
                grow({column + 1, {level}});
            }
        }
    }
}

inline double retreat_of_crack(const PathLattice& lattice, const LatticePath& path) {
    return lattice.retreat(lattice.column_outcrop[path.first + path.level.size() - 2]);
}

// Returns every surface of columns.
inline std::vector<LatticePath> all_column_paths(const PathLattice& lattice) {
    std::vector<LatticePath> paths;
    visit_columns(lattice, [&](const LatticePath& path) {
        const std::size_t last = path.first + path.level.size() - 1;
        if (retreat_of_crack(lattice, path) >= lattice.least_width) {
            paths.push_back(path);
        }
        const PathCell& cell = lattice.cells[last - 1][path.level.back()];
        for (std::size_t wedge = 0; wedge < lattice.wedges[last - 1].size(); ++wedge) {
            if (lattice.wedges[last - 1][wedge].depth <= cell.upper_reach) {
                paths.push_back(path);
                paths.back().wedge = wedge;
            }
        }
    });
    return paths;
}

// Returns every surface of columns that comes out in front of those, from the toe up or in the face. A single column
// has to be whole: only the one through the toe of the slope is.
inline std::vector<LatticePath> all_toe_paths(const PathLattice& lattice) {
    std::vector<LatticePath> paths;
    visit_columns(lattice, [&](const LatticePath& path) {
        const bool whole = path.level.size() > 1 || (path.first == 1 && path.level.front() == 0);
        if (whole && retreat_of_crack(lattice, path) < lattice.least_width) {
            paths.push_back(path);
        }
    });
    return paths;
}

inline std::vector<LatticePath> all_sliding_paths(const PathLattice& lattice) {
    std::vector<LatticePath> paths;
    const std::function<void(LatticePath)> grow = [&](const LatticePath& path) {
        const std::size_t last = path.first + path.level.size() - 1;
        if (lattice.is_far_enough(lattice.riser_outcrop[last])) {
            paths.push_back(path);
        }
        for (std::size_t level = path.level.back(); level < lattice.levels && lattice.riser_node[last][level];
             ++level) {
            LatticePath longer = path;
            longer.level.push_back(level);
            if (last + 1 < lattice.riser_node.size() && lattice.riser_node[last + 1][level]) {
                grow(longer);
            } else if (lattice.step_outcrop[level]) {
                longer.ends_on_step = true;
                paths.push_back(longer);
            }
        }
    };
    for (std::size_t riser = 0; riser < lattice.riser_node.size(); ++riser) {
        for (std::size_t level = 0; level < lattice.levels; ++level) {
            // Steps from the face to a riser end at the first one that bounds a mass wide enough.
            if (lattice.riser_node[riser][level] && !(riser > 0 && lattice.riser_node[riser - 1][level])) {
                grow({riser, {level}});
            }
        }
    }
    for (std::size_t level = 0; level < lattice.levels; ++level) {
        const bool meets_riser =
            std::ranges::any_of(lattice.riser_node, [&](const auto& nodes) { return nodes[level].has_value(); });
        if (lattice.step_outcrop[level] && !meets_riser) {
            paths.push_back({0, {level}, true, {}});
        }
    }
    return paths;
}

// The point of each part of a sliding surface that lies deepest in the slope.
inline Point deepest_of_sliding(const PathLattice& lattice, const LatticePath& path, std::size_t index) {
    const bool comes_out = path.ends_on_step && index + 1 == path.level.size();
    const std::size_t level = path.level[index];
    return comes_out ? *lattice.step_outcrop[level] : *lattice.riser_node[path.first + index][level];
}

inline double least_of_all(const SteppedPath& problem, const PathLattice& lattice,
                           const std::vector<LatticePath>& paths) {
    double least = std::numeric_limits<double>::infinity();
    for (const LatticePath& path : paths) {
        least = std::min(least, factor_of_safety(problem, lattice, path).value);
    }
    return least;
}

}  // namespace delabole
