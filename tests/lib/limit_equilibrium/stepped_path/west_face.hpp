// A slope along whose joints surfaces step.
#pragma once

#include "limit_equilibrium/stepped_path/stepped_path_parameters.hpp"

namespace delabole {

// The west face of Old Delabole with the joints that the thesis describes.
inline SteppedPath west_face(SteppedPathMechanism mechanism) {
    SteppedPath path{};
    path.search = {mechanism, std::nullopt, std::nullopt};
    path.slope = {68.58, degrees(70), 0, std::nullopt, std::nullopt};
    path.steps = {degrees(-6), 4, degrees(26.5), 100e3};
    path.risers = PathRisers{degrees(72.5), 6, degrees(26.5), 100e3};
    path.columns = PathColumns{degrees(-85), 10, degrees(26.5)};
    path.rock = {27e3};
    path.water = WaterTable<>{9.81e3, WaterDepth<>{40}};
    return path;
}

}  // namespace delabole
