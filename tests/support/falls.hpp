// Random blocks that fall, slide and pile up on fixed ones, and a check that no block is inside another.
#pragma once

#include "dynamic_relaxation/blocks/overlap.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/step/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace delabole::falls {

constexpr double gravity = 9.80665;
constexpr double density = 2700;
constexpr double pi = 3.14159265358979323846;

enum class Kind {
    drop,   // one block from 0.02 to 12 m, at any angle
    shot,   // one block at 5 to 50 m/s, turning
    slide,  // down a ramp and over the floor below, at up to 40 m/s
    heap,   // polygons into a bin, at up to 50 m/s
};

struct Fall {
    RelaxationScene scene;
    std::vector<Motion> start;  // velocities
    double duration = 0;        // s
};

class Draw {
  public:
    explicit Draw(unsigned seed) : random_(seed) {}
    double between(double least, double most) {
        return least + (most - least) * (static_cast<double>(random_()) / 4294967296.0);
    }
    double between_powers(double least, double most) { return least * std::pow(most / least, between(0, 1)); }

  private:
    std::mt19937 random_;
};

inline Polygon<> rectangle(double left, double bottom, double width, double height) {
    return {{left, bottom}, {left + width, bottom}, {left + width, bottom + height}, {left, bottom + height}};
}

// A polygon with its corners on an ellipse.
inline Polygon<> polygon(Draw& draw, double size, double flatness) {
    const int count = 3 + static_cast<int>(draw.between(0, 5));
    const double first = draw.between(0, 2 * pi);
    Polygon<> outline;
    for (int corner = 0; corner < count; ++corner) {
        const double at = first + 2 * pi * (corner + 0.6 * draw.between(0, 1)) / count;
        outline.emplace_back(size * std::cos(at), size * flatness * std::sin(at));
    }
    return outline;
}

inline RelaxationBlock fixed_block(Polygon<> outline) {
    RelaxationBlock block{std::move(outline), density};
    block.fixed = true;
    return block;
}

// The outline rotated, and lifted until its lowest corner is at the given height.
inline Polygon<> at_height(Polygon<> outline, double angle, double height) {
    double lowest = std::numeric_limits<double>::infinity();
    for (PlanePoint<>& vertex : outline) {
        vertex = PlanePoint<>(std::cos(angle) * vertex.x() - std::sin(angle) * vertex.y(),
                              std::sin(angle) * vertex.x() + std::cos(angle) * vertex.y());
        lowest = std::min(lowest, vertex.y());
    }
    for (PlanePoint<>& vertex : outline) {
        vertex.y() += height - lowest;
    }
    return outline;
}

inline void add_flight(Draw& draw, bool shot, Fall& fall) {
    const double height = shot ? draw.between_powers(0.02, 20) : draw.between_powers(0.02, 12);
    Polygon<> outline = rectangle(-0.5, -0.25, 1, 0.5);
    if (draw.between(0, 1) < 0.5) {
        const double size = draw.between_powers(0.2, 2);
        outline = polygon(draw, size, draw.between(0.3, 1));
    }
    fall.scene.block = {{at_height(std::move(outline), draw.between(0, 2 * pi), height), density},
                        fixed_block(rectangle(-60, -4, 120, 4))};
    fall.start.resize(2);
    fall.duration = 1 + std::sqrt(2 * height / gravity);
    if (shot) {
        Motion& motion = fall.start.front();
        motion.vy = -draw.between(5, 50);
        motion.vx = draw.between(-20, 20);
        motion.spin = draw.between(-15, 15);
        fall.duration = 1 - height / motion.vy;
    }
}

inline void add_slide(Draw& draw, Fall& fall) {
    const double dip = draw.between(25, 60) * pi / 180;
    const double length = draw.between(4, 40);
    const PlanePoint<> along(std::cos(dip), std::sin(dip));
    const PlanePoint<> up(-std::sin(dip), std::cos(dip));
    const PlanePoint<> top = length * along;
    const double width = draw.between_powers(0.3, 3);
    const double height = draw.between_powers(0.3, 3);
    const PlanePoint<> heel = draw.between(0.5, 0.9) * top + 1e-4 * up;
    const double step = draw.between(0, 1) < 0.5 ? 0 : draw.between(0.05, 3);
    fall.scene.block = {{{heel, heel + width * along, heel + width * along + height * up, heel + height * up}, density},
                        fixed_block(step > 0 ? Polygon<>{{0, 0}, {0.01, -step}, {top.x(), -step}, top}
                                             : Polygon<>{{0, 0}, {top.x(), 0}, top}),
                        fixed_block(rectangle(-80, -step - 4, 82 + top.x(), 4))};
    fall.start.resize(3);
    const double speed = draw.between(0, 1) < 0.6 ? 0 : draw.between(0, 40);
    fall.start.front().vx = -speed * along.x();
    fall.start.front().vy = -speed * along.y();
    fall.duration = 2.5;
}

inline void add_heap(Draw& draw, unsigned seed, Fall& fall) {
    const int count = 4 + static_cast<int>(draw.between(0, 12));
    const double size = draw.between_powers(0.2, 1);
    for (int block = 0; block < count; ++block) {
        const double own = size * draw.between(0.4, 1);
        Polygon<> outline = polygon(draw, own, draw.between(0.4, 1));
        const PlanePoint<> centre(((block % 3 - 1) * 2.2 + draw.between(-0.1, 0.1)) * size,
                                  (1.1 + 2.2 * (block / 3) + draw.between(0, 0.1)) * size);
        for (PlanePoint<>& vertex : outline) {
            vertex += centre;
        }
        fall.scene.block.push_back({std::move(outline), density});
        Motion motion;
        if (seed % 3 == 0) {
            motion.vy = -draw.between(0, 20);
            motion.vx = draw.between(-5, 5);
            motion.spin = draw.between(-5, 5);
        } else if (seed % 3 == 1) {
            motion.vy = -draw.between(20, 50);
        }
        fall.start.push_back(motion);
    }
    fall.scene.block.push_back(fixed_block(rectangle(-6 * size, -2, 12 * size, 2)));
    fall.scene.block.push_back(fixed_block({{-6 * size, 0}, {-3.3 * size, 0}, {-9 * size, 12 * size}}));
    fall.scene.block.push_back(fixed_block({{3.3 * size, 0}, {6 * size, 0}, {9 * size, 12 * size}}));
    fall.start.resize(fall.scene.block.size());
    fall.duration = 1.5;
}

// The same seed gives the same fall. `stiffness_ratio` is the corner stiffness times the size of the largest block over
// its weight.
inline Fall fall_of(Kind kind, unsigned seed, double stiffness_ratio = 1e6) {
    Draw draw(seed);
    Fall fall;
    const double friction = draw.between(0, kind == Kind::slide ? 25 : 60) * pi / 180;
    switch (kind) {
    case Kind::drop:
    case Kind::shot:
        add_flight(draw, kind == Kind::shot, fall);
        break;
    case Kind::slide:
        add_slide(draw, fall);
        break;
    case Kind::heap:
        add_heap(draw, seed, fall);
        break;
    }
    double largest = 0;
    for (const RelaxationBlock& block : fall.scene.block) {
        largest = block.fixed ? largest : std::max(largest, area_properties(block.outline).area);
    }
    const double stiffness = stiffness_ratio * density * gravity * std::sqrt(largest);
    fall.scene.material = {{stiffness, stiffness, friction}};
    return fall;
}

// The run continues to the end of its time, since no motion counts as failure.
inline RelaxationSettings settings_of(const Fall& fall) {
    RelaxationSettings settings;
    settings.start = RelaxationStart::dropped;
    settings.onset_rotation = settings.onset_slide = settings.collapse_rotation = settings.collapse_displacement = 1e9;
    settings.stop_at_equilibrium = false;
    settings.duration = fall.duration;
    return settings;
}

struct Landing {
    RelaxationResult result;
    // Whether the run came to its end, moving or at rest, and was not stopped by an error.
    bool ended() const {
        return result.outcome == RelaxationOutcome::undecided || result.outcome == RelaxationOutcome::equilibrium;
    }
    double deepest = 0;  // greatest penetration of a block, as a share of the shortest edge, at some hundred moments
};

// Nothing if blocks overlap in the initial geometry.
inline std::optional<Landing> land(const Fall& fall, const RelaxationSettings& settings) {
    if (check_scene(fall.scene).check != SceneCheck::valid || check_start(fall.scene).check != SceneCheck::valid) {
        return {};
    }
    const Simulation at_rest(fall.scene, settings);
    RelaxationState state = at_rest.state();
    for (std::size_t block = 0; block < fall.start.size(); ++block) {
        Motion& motion = state.motion[block];
        motion.vx = fall.start[block].vx;
        motion.vy = fall.start[block].vy;
        motion.spin = fall.start[block].spin;
        state.energy_balance.applied +=
            (at_rest.bodies().mass[block] * (motion.vx * motion.vx + motion.vy * motion.vy) +
             at_rest.bodies().inertia[block] * motion.spin * motion.spin) /
            2;
    }
    ContactWatch::start(state.motion.size(), state.watch);
    Simulation simulation(fall.scene, settings, std::move(state));
    Landing landing;
    const auto measure = [&] {
        const auto overlap =
            greatest_overlap(simulation.bodies(), simulation.state().motion, simulation.state().removed);
        landing.deepest = std::max(landing.deepest, overlap ? overlap->share : 0);
    };
    while (simulation.running()) {
        simulation.step();
        if (simulation.state().steps % 25 == 0) {
            measure();
        }
    }
    measure();
    landing.result = simulation.result();
    return landing;
}

}  // namespace delabole::falls
