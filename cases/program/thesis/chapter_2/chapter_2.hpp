// The items of the thesis's chapter 2 that stand in files of their own.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/thesis/physical_models.hpp"
#include "cases/program/thesis/reproduction.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "geometry/polyline.hpp"
#include "plane_failure/plane_failure.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

Reproduction reproduce_mechanisms(const Sheet& sheet);
Reproduction reproduce_groundwater(const Sheet& sheet);
Reproduction reproduce_slope_drawings(const Sheet& sheet);
Reproduction reproduce_column_motion(const Sheet& sheet);
Reproduction reproduce_trends(const Sheet& sheet);
Reproduction reproduce_plates(const Sheet& sheet);

// Thesis Fig 2.8: the crack depth z that its two printed statements imply.
//
// Printed: H, z and the unit weight are missing; "the slope is stable for a half filled tension crack even for c = 0",
// and "for the slope to be unstable two thirds of the tension crack must be full of water when c = 30 lbf/in2". With H
// between the printed levels 575 and 350 ft, the second statement is an equation for z, FS(2/3, 30 lbf/in2) = 1, and
// the first an inequality that the solution has to meet, FS(1/2, 0) > 1.
//
// "Tension crack full" can be read in two ways, because the z of the printed formulas is measured from crest level: for
// a crack in the face it is more than the depth of the crack. Both readings are solved.
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

// Returns the factor of safety over the filled fraction, from 0 to 1, as long as the water stays within the crack.
Polyline fig_2_8_curve(FilledFraction reading, double unit_weight, double z, double cohesion);

// Tells whether one quantity rises or falls with another (Spearman 1904).
struct RankCorrelation {
    double value;         // -1 to 1; 0 where either does not change
    double significance;  // probability of a correlation as strong, either way, where there is none; 0 to 1
};

// Ties get their mean rank. Both lists have the same length, three or more. The significance is by Student's t, to 0.02
// from eight values on.
RankCorrelation rank_correlation(const std::vector<double>& parameter, const std::vector<double>& response);

constexpr double joint_a_dip = degrees(70);  // of the models (2.3.3)

// Returns the base friction model of a file, named without its ending: "plate_2_iii". The models of the west face of
// Delabole, as they are run, are in cases/thesis/chapter_2/*.toml, which are built into the program. Throws
// std::logic_error if there is none of that name.
RelaxationStudy slope_model(std::string_view name, const std::vector<Setting>& settings = {});

// A run of a slope from start to end, with frames in between.
struct SlopeRun {
    RelaxationStudy study;
    RelaxationRun run;
    PostFailure end;
    // The last frame at which no more than half of the final failure has begun: cracks and first movements.
    std::size_t early_frame = 0;
    PostFailure early;
};

SlopeRun run_slope(RelaxationStudy study);

// Adds to a section the dip of each joint set, of a fault and of a discontinuity as a short line with its name, in the
// space in front of the face.
void add_directions(const RelaxationSlope& slope, Figure& figure);

// Height, m, of the slope above its toe.
double slope_height(const PostFailure& failure);

// The field criteria of 2.3.3.2 as numbers, and how a run meets them.
struct FieldScore {
    FieldVerdict profile;
    FieldVerdict cracks;
    FieldVerdict movements;
    std::string profile_in_words;
    std::string cracks_in_words;
    std::string movements_in_words;
};

FieldScore score_of(const SlopeRun& run);

}  // namespace delabole
