// Joint sets: a name, a mean orientation and its scatter, with samples and their statistics.
//
// Sources: Fisher, R. (1953), Dispersion on a sphere, Proc. R. Soc. A 217; Mardia & Jupp (2000), Directional
// Statistics.
#pragma once

#include "kinematics/orientation.hpp"
#include "parameters/fields.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace delabole {

// Orientations given by their ranges, as in field reports. Dip and dip direction are taken as independent, each with a
// uniform distribution over its range. The range of dip direction runs clockwise, through north if necessary.
struct OrientationRange {
    double lower_dip;
    double upper_dip;
    double first_dip_direction;
    double last_dip_direction;
    static constexpr auto fields() {
        using R = OrientationRange;
        return FieldTable{
            number<&R::lower_dip>(Dimension::angle, within(0, degrees(90)), "flattest dip"),
            number<&R::upper_dip>(Dimension::angle, within(0, degrees(90)), "steepest dip"),
            number<&R::first_dip_direction>(Dimension::angle, within(0, degrees(360)),
                                            "dip direction where the range begins"),
            number<&R::last_dip_direction>(Dimension::angle, within(0, degrees(360)),
                                           "dip direction where the range ends, clockwise from the first")};
    }
};

// Poles scattered about a mean by Fisher's distribution: the density falls with the angle t from the mean as
// exp(K cos t). For large K the angular standard deviation is 81 deg / sqrt(K).
struct MeanOrientation {
    double dip;
    double dip_direction;
    std::optional<double> concentration;
    static constexpr auto fields() {
        using M = MeanOrientation;
        return FieldTable{number<&M::dip>(Dimension::angle, within(0, degrees(90)), "mean dip"),
                          number<&M::dip_direction>(Dimension::angle, within(0, degrees(360)), "mean dip direction"),
                          number<&M::concentration>(within(1e-3, 1e9), "Fisher's K of the poles; absent: no scatter")};
    }
};

// The measured poles within an angle of a direction: a set selected by eye.
struct PoleWindow {
    double window_dip;
    double window_dip_direction;
    double window_radius;
    static constexpr auto fields() {
        return FieldTable{
            number<&PoleWindow::window_dip>(Dimension::angle, within(0, degrees(90)),
                                            "dip of the plane in whose pole the window has its middle"),
            number<&PoleWindow::window_dip_direction>(Dimension::angle, within(0, degrees(360)), "its dip direction"),
            number<&PoleWindow::window_radius>(Dimension::angle, left_open(0, degrees(90)),
                                               "angle from there within which measured poles belong to the set")};
    }
};

struct JointSet {
    std::string name;
    std::variant<OrientationRange, MeanOrientation, PoleWindow> orientation;
    static constexpr auto fields() {
        return FieldTable{section<&JointSet::name>("name of the set"),
                          inlined(&JointSet::orientation, "its orientations")};
    }
};

// Middle of the ranges or of the window, or the given mean.
Orientation mean_orientation(const JointSet& set);

// `count` planes of the set; for a window its middle, because the poles in it are measured. The result is the same for
// the same seed and stream on every machine, up to the rounding of sin, cos and log: the generator is std::mt19937_64,
// and the transforms are implemented here. Different streams of one seed are independent.
std::vector<Orientation> sampled_planes(const JointSet& set, std::size_t count, std::uint64_t seed,
                                        std::uint64_t stream);

// `count` planes drawn from measured ones with probabilities in proportion to their weights, with the generator above.
// Needs at least one plane.
std::vector<Orientation> drawn_planes(const std::vector<Orientation>& measured, const std::vector<double>& weights,
                                      std::size_t count, std::uint64_t seed, std::uint64_t stream);

struct OrientationStatistics {
    Orientation mean;                   // of the resultant
    double resultant;                   // R
    double concentration;               // (N - 1) / (N - R); infinite without scatter
    double angular_standard_deviation;  // acos(R / N)
};

// Statistics of N planes whose poles, turned to the side of their principal axis, have the resultant R. Poles spread
// over more than a hemisphere have no meaningful mean. Needs at least one plane; a single one has an infinite
// concentration. `weights`, one for each plane, apply to the resultant, scaled to the sum N; empty: equal weights.
OrientationStatistics orientation_statistics(const std::vector<Orientation>& planes,
                                             const std::vector<double>& weights = {});

}  // namespace delabole
