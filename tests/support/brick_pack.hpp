// Bricks of 1 m by 2 m, laid as in a wall on a fixed plane and against a fixed toe.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"

#include <algorithm>
#include <cstddef>

namespace delabole {

struct BrickPack {
    int rows;
    int bricks;              // in a row
    double stiffness_ratio;  // corner stiffness times the width of a brick over its weight
    double friction_angle;
    double tilt;
};

inline RelaxationScene brick_pack_scene(const BrickPack& pack) {
    constexpr double density = 2700;
    constexpr double gravity = 9.80665;
    const auto rectangle = [](double left, double bottom, double width, double height) -> Polygon<> {
        return {{left, bottom}, {left + width, bottom}, {left + width, bottom + height}, {left, bottom + height}};
    };
    RelaxationScene scene;
    const double stiffness = pack.stiffness_ratio * density * gravity * 2;
    scene.material = {{stiffness, stiffness, pack.friction_angle}};
    const double width = 2.0 * pack.bricks;
    for (int row = 0; row < pack.rows; ++row) {
        const double shift = row % 2 == 0 ? 0 : 1;
        if (shift > 0) {
            scene.block.push_back({rectangle(0, row, 1, 1), density});
        }
        for (int brick = 0; brick < pack.bricks; ++brick) {
            const double left = shift + 2 * brick;
            scene.block.push_back({rectangle(left, row, std::min(2.0, width - left), 1), density});
        }
    }
    for (const Polygon<>& outline : {rectangle(-3, -2, width + 6, 2), rectangle(-3, 0, 3, pack.rows + 2)}) {
        scene.block.push_back({outline, density});
        scene.block.back().fixed = true;
    }
    scene.gravity.tilt = scene.gravity.final_tilt = pack.tilt;
    return scene;
}

}  // namespace delabole
