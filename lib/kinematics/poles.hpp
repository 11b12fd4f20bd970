// Measured poles: weights against the bias of a scanline, Fisher's statistics, densities, and the sets found in them.
//
// Poles are axes: a normal and its opposite are the same plane. Angles in radians, weights positive.
//
// Sources: Fisher, R. (1953), Dispersion on a sphere; Fisher, N. I., Lewis & Embleton (1987), Statistical Analysis of
// Spherical Data, 5.3; Terzaghi (1965), Sources of error in joint surveys; Kamb (1959), Ice petrofabric observations
// from Blue Glacier; Schwarz (1978), Estimating the dimension of a model; Fisher, N. I., Lewis & Willcox (1981), Tests
// of discordancy for samples from Fisher's distribution on the sphere.
#pragma once

#include "kinematics/orientation.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace delabole {

// A line meets a plane at an angle d with a frequency proportional to sin d, so that a plane met counts for 1 / sin d.
// Planes nearly parallel to the line would outweigh all others: a smaller d than `least_angle` is replaced by it.
double terzaghi_weight(const Orientation& plane, const LineOrientation& line, double least_angle);

// Statistics of poles turned to the side of their principal axis, with weights w scaled to the sum N. R is the length
// of their resultant.
struct FisherStatistics {
    double mean_dip;
    double mean_dip_direction;
    double count;          // N
    double resultant;      // R
    double concentration;  // K = (N - 1) / (N - R); infinite without scatter
    double
        lower_concentration;  // 95 % bounds: 2 K (N - R) is distributed as chi-square with 2 N - 2 degrees of freedom
    double upper_concentration;
    double confidence_cone;   // 95 %: half-angle about the mean that contains the true mean, cos a = 1 - (N - R) / R
                              // (20^(1 / (N - 1)) - 1)
    double variability_cone;  // 68 %: half-angle about the mean that contains that share of the poles
    static constexpr auto fields() {
        return FieldTable{
            number<&FisherStatistics::mean_dip>(Dimension::angle, "dip of the mean plane"),
            number<&FisherStatistics::mean_dip_direction>(Dimension::angle, "dip direction of the mean plane"),
            number<&FisherStatistics::count>("number of poles"),
            number<&FisherStatistics::resultant>("length R of the resultant of their unit vectors"),
            number<&FisherStatistics::concentration>("Fisher's K"),
            number<&FisherStatistics::lower_concentration>("lower 95 % bound of K"),
            number<&FisherStatistics::upper_concentration>("upper 95 % bound of K"),
            number<&FisherStatistics::confidence_cone>(Dimension::angle,
                                                       "half-angle of the cone that holds the true mean with 95 %"),
            number<&FisherStatistics::variability_cone>(
                Dimension::angle, "half-angle of the cone about the mean that holds 68 % of the poles")};
    }
};

// Needs at least one plane and one weight for each. For a single plane K is infinite, its lower bound 0 and the
// confidence cone 180 deg. The bounds and cones are valid for K above 3.
FisherStatistics fisher_statistics(const std::vector<Orientation>& planes, const std::vector<double>& weights);

struct PoleCluster {
    Direction axis;        // unit vector, upwards
    double concentration;  // Fisher's K
    double share;          // of the poles, by weight
};

// A mixture of Fisher distributions on axes, each of density K cosh(K x.m) / sinh K in multiples of the uniform one,
// over a uniform background of poles that belong to no set.
struct PoleClusters {
    std::vector<PoleCluster> sets;               // of their members alone, the largest first
    std::vector<std::optional<std::size_t>> of;  // the set of each pole; absent: it belongs to none
    std::vector<double> information_criterion;   // Bayesian, of 0, 1, 2 ... sets, less that of none; the least decides
    std::vector<bool> too_small;                 // of the same numbers: a set would have fewer than three poles
};

// The number of sets, at most `most_sets`, is that of the least Bayesian information criterion, -2 log L + 4 k log N,
// among those whose sets all have three poles or more.
// For each number the parameters are those of greatest likelihood that expectation-maximisation finds, starting from
// the sets of one fewer and a new one at one of the densest of their unexplained poles. Deterministic. K is limited to
// 1e4 (a scatter of 0.8 deg, the resolution of a compass). Time grows with the number of poles times the square of
// most_sets. Two sets whose scatter overlaps by more than their distance count as one.
//
// A pole belongs to its most probable set, unless the background is more probable or the pole is a stray. The
// likelihood alone keeps strays: where few poles lie between the sets it gives the background no share and widens a set
// until it holds the nearest of them. A stray is a pole so far from the others that only one of a hundred poles of
// their set would be expected there. For n poles and the resultants R of all and R' of all but this one,
//     E = (n - 2) (1 + R' - R) / (n - 1 - R')
// is distributed as F with 2 and 2 n - 4 degrees of freedom (Fisher, Lewis & Willcox 1981), so that E exceeds
// (n - 2) (100^(1 / (n - 2)) - 1) with 1 %. For many poles that is the cone about the mean that holds 99 % of them,
// K (1 - cos a) = ln 100; it is wider for few poles, whose mean and K are uncertain. All poles are judged by the
// members found before, until these are the same. Strays inside the cone stay: of 18 poles with K = 50 it reaches to 27
// deg.
PoleClusters find_clusters(const std::vector<Orientation>& planes, const std::vector<double>& weights,
                           std::size_t most_sets);

// Kamb's density at a direction: the weight of the poles within the circle of area 9 / (N + 9) of the hemisphere, less
// the value for uniform poles, in standard deviations of the latter. A value of 3 or more is commonly called
// significant.
double kamb_density(const std::vector<Direction>& poles, const std::vector<double>& weights, const Direction& at);

}  // namespace delabole
