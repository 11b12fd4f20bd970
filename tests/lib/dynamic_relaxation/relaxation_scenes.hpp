// Scenes that the tests of dynamic relaxation share.
#pragma once

#include "dynamic_relaxation/step/simulation.hpp"
#include "parameters/fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace delabole::relaxation_scenes {

constexpr double gravity = 9.80665;
constexpr double density = 2700;

inline Polygon<> rectangle(double left, double bottom, double width, double height) {
    return {{left, bottom}, {left + width, bottom}, {left + width, bottom + height}, {left, bottom + height}};
}

inline JointMaterial joint(double stiffness, double friction_angle) {
    return {stiffness, stiffness, friction_angle};
}

inline RelaxationBlock fixed_block(Polygon<> outline) {
    RelaxationBlock block{std::move(outline), density};
    block.fixed = true;
    return block;
}

// A block of width b on a wide fixed plane, drawn level; gravity is tilted.
struct OnPlane {
    double height_to_width = 1;
    double width = 1;
    double stiffness_ratio = 1e6;  // k b / W
    double friction = degrees(30);
    double tilt = 0;
    double density = relaxation_scenes::density;

    double mass() const { return density * height_to_width * width * width; }
    double weight() const { return mass() * gravity; }
    double stiffness() const { return stiffness_ratio * density * gravity * height_to_width * width; }
};

inline RelaxationScene scene_of(const OnPlane& plane) {
    RelaxationScene scene;
    const double b = plane.width;
    scene.block = {{rectangle(0, 0, b, plane.height_to_width * b), plane.density}};
    scene.block.push_back(fixed_block(rectangle(-3 * b, -b, 7 * b, b)));
    scene.material = {joint(plane.stiffness(), plane.friction)};
    scene.gravity.tilt = scene.gravity.final_tilt = plane.tilt;
    return scene;
}

inline RelaxationSettings until_onset() {
    RelaxationSettings settings;
    settings.stop_at_onset = true;
    return settings;
}

// The blocks may move far without that being a failure.
inline RelaxationSettings unlimited(double duration) {
    RelaxationSettings settings;
    settings.onset_rotation = settings.onset_slide = 1e3;
    settings.collapse_rotation = settings.collapse_displacement = 1e6;
    settings.stop_at_equilibrium = false;
    settings.duration = duration;
    return settings;
}

// Returns false if the run was stopped for what blocks or their numbers must not do.
inline bool ends_as_blocks_do(RelaxationOutcome outcome) {
    return outcome == RelaxationOutcome::undecided || outcome == RelaxationOutcome::equilibrium ||
           outcome == RelaxationOutcome::onset || outcome == RelaxationOutcome::collapse;
}

// Returns the share of the energy turned over that the energy balance misses. A start in equilibrium turns over next to
// nothing: below `scale`, J/m, it is all rounding.
inline double energy_error(const RelaxationResult& result, double scale) {
    return std::abs(result.energy_balance.residual()) / (result.energy_balance.turnover() + scale);
}

// A flat block: its corners bear the same to a hundredth, and reach their strengths together.
inline OnPlane flat(double friction, double tilt = 0) {
    OnPlane plane;
    plane.height_to_width = 0.01;
    plane.friction = degrees(friction);
    plane.tilt = tilt;
    plane.stiffness_ratio = 1e6;
    return plane;
}

// Root of an increasing function between 0 and 89 deg.
inline double root(const std::function<double(double)>& function) {
    double low = 0;
    double high = degrees(89);
    for (int round = 0; round < 60; ++round) {
        const double middle = (low + high) / 2;
        (function(middle) < 0 ? low : high) = middle;
    }
    return low;
}

// Stands at 0.99 times the load or tilt of limit equilibrium, fails at 1.01.
inline void expect_threshold(const std::function<RelaxationScene(double)>& scene_at, const std::string& what,
                             const RelaxationSettings& settings = until_onset()) {
    EXPECT_EQ(relax(scene_at(0.99), settings).outcome, RelaxationOutcome::equilibrium) << what;
    const RelaxationResult fails = relax(scene_at(1.01), settings);
    EXPECT_EQ(fails.outcome, RelaxationOutcome::onset) << what;
    EXPECT_LT(energy_error(fails, 1e-6 * density * gravity), 0.02) << what;
}

}  // namespace delabole::relaxation_scenes
