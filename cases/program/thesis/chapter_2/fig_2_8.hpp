// Thesis Fig 2.8: the crack depth z that its two printed statements imply.
//
// Printed: H, z and the unit weight are missing; "the slope is stable for a half filled tension crack even for c = 0",
// and "for the slope to be unstable two thirds of the tension crack must be full of water when c = 30 lbf/in2". With H
// between the printed levels 575 and 350 ft, the second statement is an equation for z, FS(2/3, 30 lbf/in2) = 1, and
// the first an inequality that the solution has to meet, FS(1/2, 0) > 1.
//
// "Tension crack full" can be read in two ways, because the z of the printed formulas is measured from crest level: for
// a crack in the face it is more than the depth of the crack. Both readings are solved.
#pragma once

#include "geometry/polyline.hpp"
#include "plane_failure/plane_failure.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace delabole {

enum class FilledFraction { of_z_below_crest, of_the_crack_itself };

constexpr std::array<std::string_view, 2> enum_names(FilledFraction) {
    return {"of z below crest level", "of the crack itself"};
}

struct Fig28Solution {
    FilledFraction reading;
    double unit_weight;        // N/m3
    std::optional<double> z;   // m, bottom of the crack below crest level; absent where no z gives FS = 1
    double factor_half_full;   // at c = 0, half filled; meaningful with z
    PlaneFailureResult state;  // at c = 30 lbf/in2, two thirds filled; meaningful with z
};

constexpr double fig_2_8_cohesion = 30 * 6894.757293168361;  // Pa, 30 lbf/in2

// Friction 20 + 46 deg on a 40 deg plane below a 70 deg face of 225 ft; water weighs 9.81 kN/m3.
Fig28Solution solve_fig_2_8(FilledFraction reading, double unit_weight);

// Factor of safety against the filled fraction, from 0 to 1, as far as the water stays within the crack.
Polyline fig_2_8_curve(FilledFraction reading, double unit_weight, double z, double cohesion);

}  // namespace delabole
