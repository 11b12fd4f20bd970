// Stepped surfaces along joint sets: checks of their case for the reader.
#include "cases/program/case/model_cases.hpp"
#include "limit_equilibrium/stepped_path/stepped_path.hpp"

namespace delabole {
void check_case(Checker& checker, const SteppedPath& path) {
    const bool slides = path.search.mechanism == SteppedPathMechanism::sliding;
    if (path.search.mechanism != SteppedPathMechanism::toppling && !path.risers) {
        checker.complain("search.mechanism", "steps up along risers, so [risers] is required");
    }
    if (!slides && !path.columns) {
        checker.complain("search.mechanism", "moves columns, so [columns] is required");
    }
    if (path.slope.bench) {
        checker.complain("slope.bench", "is not covered: the ground is a face and an upper surface");
    }
    if (path.search.least_width && path.search.greatest_retreat &&
        !(*path.search.least_width < *path.search.greatest_retreat)) {
        checker.complain("search.least_width", "must be less than search.greatest_retreat");
    }
    check_water_level(checker, path.water, path.slope.toe_elevation.has_value());
}

}  // namespace delabole
