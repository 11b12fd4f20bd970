// A study of blocks redrawn as polygons, and variants of it that must not change a critical value. Any scene can be
// used, also one with a frame behind it, lines that bound sets, regions, or columns on steps.
#pragma once

#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <optional>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace delabole::testing {

inline RelaxationPolygons& polygons_of(RelaxationStudy& study) {
    return std::get<RelaxationPolygons>(study.model.scene);
}

// The study has no water, motion or removals; the strength of all joints is reduced.
inline RelaxationStudy as_polygons(RelaxationStudy study) {
    const RelaxationScene scene = relaxation_scene(study);
    RelaxationPolygons polygons{};
    polygons.tilt = scene.gravity.tilt;
    for (const JointMaterial& material : scene.material) {
        RelaxationJoint joint{};
        joint.friction_angle = material.friction_angle;
        joint.residual_friction_angle = material.residual_friction_angle;
        joint.cohesion = material.cohesion;
        joint.residual_cohesion = material.residual_cohesion;
        joint.tensile_strength = material.tensile_strength;
        joint.normal_stiffness = material.normal_stiffness;
        joint.shear_stiffness = material.shear_stiffness;
        joint.bond = material.bond;
        polygons.joint.push_back(joint);
    }
    for (const RelaxationBlock& block : scene.block) {
        RelaxationPolygon polygon{};
        polygon.density = block.density;
        polygon.hold = block.fixed ? BlockHold::fixed : BlockHold::free;
        for (std::size_t vertex = 0; vertex < block.outline.size(); ++vertex) {
            const std::size_t joint = block.joint.empty() ? 0 : block.joint[vertex];
            polygon.vertex.push_back(
                {block.outline[vertex].x(), block.outline[vertex].y(), static_cast<double>(joint + 1)});
        }
        polygons.block.push_back(std::move(polygon));
    }
    study.model.scene = std::move(polygons);
    return study;
}

inline void move_vertices(RelaxationStudy& study, const auto& moved) {
    for (RelaxationPolygon& block : polygons_of(study).block) {
        for (RelaxationVertex& vertex : block.vertex) {
            std::tie(vertex.x, vertex.y) = moved(vertex.x, vertex.y);
        }
    }
    for (ForceOnBlock& force : study.model.force) {
        std::tie(force.x, force.y) = moved(force.x, force.y);
    }
}

inline RelaxationStudy polygons_mirrored(RelaxationStudy study) {
    move_vertices(study, [](double x, double y) { return std::pair(-x, y); });
    for (RelaxationPolygon& block : polygons_of(study).block) {
        std::vector<RelaxationVertex> turned(block.vertex.rbegin(), block.vertex.rend());
        // An edge keeps its joint; its first vertex is the one that was its last.
        for (std::size_t edge = 0; edge < turned.size(); ++edge) {
            turned[edge].joint = block.vertex[(2 * turned.size() - 2 - edge) % turned.size()].joint;
        }
        block.vertex = std::move(turned);
    }
    for (ForceOnBlock& force : study.model.force) {
        force.horizontal = -force.horizontal;
    }
    polygons_of(study).tilt = -polygons_of(study).tilt;
    if (auto* search = std::get_if<TiltSearch>(&*study.critical)) {
        search->lower = -search->lower;
        search->upper = -search->upper;
    }
    return study;
}

inline RelaxationStudy polygons_turned(RelaxationStudy study, double angle) {
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    const auto turn = [&](double x, double y) { return std::pair(cosine * x - sine * y, sine * x + cosine * y); };
    move_vertices(study, turn);
    for (ForceOnBlock& force : study.model.force) {
        std::tie(force.horizontal, force.vertical) = turn(force.horizontal, force.vertical);
    }
    polygons_of(study).tilt -= angle;
    if (auto* search = std::get_if<TiltSearch>(&*study.critical)) {
        search->lower -= angle;
        search->upper -= angle;
    }
    return study;
}

inline RelaxationStudy polygons_moved_away(RelaxationStudy study, double by) {
    move_vertices(study, [&](double x, double y) { return std::pair(x + by, y - by); });
    return study;
}

// Stresses are proportional to lengths, forces per metre run to their squares and times to their roots; the stiffness
// of a contact is proportional to lengths, so that overlaps are too.
inline RelaxationStudy polygons_scaled(RelaxationStudy study, double by) {
    move_vertices(study, [&](double x, double y) { return std::pair(by * x, by * y); });
    const auto scale = [&](std::initializer_list<std::optional<double>*> values) {
        for (std::optional<double>* value : values) {
            if (*value) {
                **value *= by;
            }
        }
    };
    for (RelaxationJoint& joint : polygons_of(study).joint) {
        scale({&joint.cohesion, &joint.residual_cohesion, &joint.tensile_strength, &joint.normal_stiffness,
               &joint.shear_stiffness});
        if (joint.bond) {
            scale({&joint.bond->spacing});
            for (double* of_rock : {&joint.bond->young_modulus, &joint.bond->shear_modulus,
                                    &joint.bond->tensile_strength, &joint.bond->cohesion}) {
                *of_rock *= by;
            }
        }
    }
    for (ForceOnBlock& force : study.model.force) {
        force.horizontal *= by * by;
        force.vertical *= by * by;
    }
    const double duration = relaxation_settings(study).duration;
    study.settings = study.settings.value_or(RelaxationNumerics{});
    study.settings->duration = std::sqrt(by) * duration;
    return study;
}

inline RelaxationStudy polygons_in_another_order(RelaxationStudy study, std::uint32_t seed) {
    std::vector<RelaxationPolygon>& blocks = polygons_of(study).block;
    std::vector<std::size_t> place(blocks.size());
    std::iota(place.begin(), place.end(), std::size_t{0});
    std::mt19937 random(seed);
    std::shuffle(place.begin(), place.end(), random);
    std::vector<RelaxationPolygon> shuffled(blocks.size());
    for (std::size_t block = 0; block < blocks.size(); ++block) {
        shuffled[place[block]] = std::move(blocks[block]);
    }
    blocks = std::move(shuffled);
    for (ForceOnBlock& force : study.model.force) {
        force.block = static_cast<double>(place[static_cast<std::size_t>(force.block) - 1] + 1);
    }
    return study;
}

inline RelaxationStudy polygons_with_more_vertices(RelaxationStudy study) {
    for (RelaxationPolygon& block : polygons_of(study).block) {
        std::vector<RelaxationVertex> more;
        for (std::size_t edge = 0; edge < block.vertex.size(); ++edge) {
            const RelaxationVertex& from = block.vertex[edge];
            const RelaxationVertex& to = block.vertex[(edge + 1) % block.vertex.size()];
            constexpr double share = 0.4;
            more.push_back(from);
            more.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), from.joint});
        }
        block.vertex = std::move(more);
    }
    return study;
}

}  // namespace delabole::testing
