// Random jointed slopes, and changes of their description that must not change whether they stand.
#pragma once

#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/scene/straight_vertices.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "tests/support/jointed_slopes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace delabole::testing {

// A slope with one to three joint sets, and sometimes a single joint; often one set passes through the toe.
inline RelaxationStudy random_slope(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
    const double height = between(8, 40);
    const double run = height / std::tan(between(degrees(45), degrees(80)));
    const double front = between(0.3, 1) * height;
    const double below = between(0.1, 0.4) * height;
    const double back = run + between(0.8, 1.6) * height;
    std::vector<SlopeCut> cuts;
    const double spacing = height / between(1.2, 7);
    const int sets = 1 + static_cast<int>(between(0, 3));
    for (int number = 0; number < sets; ++number) {
        const double steep = degrees(between(55, 88));
        const double dip = number == 0 ? degrees(between(15, 60)) : number == 1 ? -steep : steep;
        JointSetCut set = joint_set(dip, spacing * between(0.7, 1.5));
        set.offset = number == 0 && between(0, 1) < 0.5 ? 0 : between(0, 1) * set.spacing;
        cuts.push_back(cut("set " + std::to_string(number), set));
    }
    if (between(0, 1) < 0.3) {
        // The joint goes from the toe into the slope.
        const double dip = degrees(between(20, 45));
        cuts.push_back(cut("joint", line({{0, 0}, {3 * back * std::cos(dip), 3 * back * std::sin(dip)}})));
    }
    RelaxationSlope slope{};
    slope.geometry = section({{-front, -below}, {back, -below}, {back, height}, {run, height}, {0, 0}, {-front, 0}},
                             std::move(cuts));
    slope.geometry.intact_joint = "intact";
    slope.rock = {{"rock", between(2000, 2800)}};
    RelaxationJoint open{};
    open.friction_angle = degrees(between(8, 50));
    RelaxationJoint intact{};
    intact.friction_angle = degrees(45);
    // This strength is never reached: the division of intact rock into convex blocks must not matter.
    intact.cohesion = intact.tensile_strength = 1e9;
    slope.joint = {{"joint", {}, open}, {"intact", {}, intact}};
    slope.frame = SlopeFrame{FrameSides::all_around, 0.2 * height, {}, "joint"};
    RelaxationStudy study{};
    study.model.scene = slope;
    RelaxationNumerics settings{};
    settings.stop = RelaxationStop::onset;
    settings.stiffness_ratio = 1e5;
    settings.mass_scaling = OffOn::on;
    settings.duration = 20;
    study.settings = settings;
    return study;
}

struct DrawnSlope {
    RelaxationScene scene;
    RelaxationSettings settings;
};

inline DrawnSlope drawn(const RelaxationStudy& study) {
    return {relaxation_scene(study), relaxation_settings(study)};
}

inline SlopeGeometry& geometry_of(RelaxationStudy& study) {
    return std::get<RelaxationSlope>(study.model.scene).geometry;
}

// The study must have no water, stages or forces.
inline RelaxationStudy mirrored(RelaxationStudy study) {
    const auto mirror = [](std::vector<SectionPoint>& points) {
        for (SectionPoint& point : points) {
            point.x = -point.x;
        }
    };
    auto& slope = std::get<RelaxationSlope>(study.model.scene);
    mirror(slope.geometry.outline);
    for (SlopeArea& area : slope.fixed) {
        mirror(area.vertex);
    }
    for (SlopeCut& one : slope.geometry.cut) {
        if (auto* set = std::get_if<JointSetCut>(&one.trace)) {
            set->dip = -set->dip;
            mirror(set->region);
            if (set->through) {
                set->through->x = -set->through->x;
            }
        } else {
            mirror(std::get<LineCut>(one.trace).vertex);
        }
    }
    return study;
}

inline RelaxationStudy with_sets_by_another_trace(RelaxationStudy study) {
    for (SlopeCut& one : geometry_of(study).cut) {
        if (auto* set = std::get_if<JointSetCut>(&one.trace)) {
            // The new trace is two spacings further down and some distance along the traces.
            const double down = 2 * set->spacing + set->offset.value_or(0);
            const double along = 0.7 * set->spacing;
            const SectionPoint from = set->through.value_or(SectionPoint{0, 0});
            set->through = SectionPoint{from.x + down * std::sin(set->dip) + along * std::cos(set->dip),
                                        from.y - down * std::cos(set->dip) + along * std::sin(set->dip)};
            set->offset = 0;
        }
    }
    return study;
}

// A joint through the toe then runs on into the ground in front of it, too: a slope that is cut further cannot be
// stronger.
inline RelaxationStudy with_lines_drawn_on(RelaxationStudy study) {
    for (SlopeCut& one : geometry_of(study).cut) {
        if (auto* made = std::get_if<LineCut>(&one.trace)) {
            const SectionPoint end = made->vertex.back();
            made->vertex = {{-end.x, -end.y}, {4 * end.x, 4 * end.y}};
        }
    }
    return study;
}

inline bool has_lines(RelaxationStudy study) {
    return std::ranges::any_of(geometry_of(study).cut,
                               [](const SlopeCut& one) { return std::holds_alternative<LineCut>(one.trace); });
}

inline RelaxationStudy with_cuts_reversed(RelaxationStudy study) {
    std::reverse(geometry_of(study).cut.begin(), geometry_of(study).cut.end());
    return study;
}

inline void move_points(DrawnSlope& slope, const auto& moved) {
    for (RelaxationBlock& block : slope.scene.block) {
        for (PlanePoint<>& vertex : block.outline) {
            vertex = moved(vertex);
        }
    }
}

inline DrawnSlope turned(DrawnSlope slope, double angle) {
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    move_points(slope, [&](const PlanePoint<>& at) {
        return PlanePoint<>(cosine * at.x() - sine * at.y(), sine * at.x() + cosine * at.y());
    });
    slope.scene.gravity.tilt -= angle;
    slope.scene.gravity.final_tilt -= angle;
    return slope;
}

inline DrawnSlope moved_away(DrawnSlope slope, double by) {
    move_points(slope, [&](const PlanePoint<>& at) { return PlanePoint<>(at + PlanePoint<>(by, -by)); });
    return slope;
}

// Forces per metre run are proportional to the square of lengths, and stiffnesses to lengths, so that overlaps are
// proportional to lengths too.
inline DrawnSlope scaled(DrawnSlope slope, double by) {
    move_points(slope, [&](const PlanePoint<>& at) { return PlanePoint<>(by * at); });
    for (JointMaterial& joint : slope.scene.material) {
        joint.normal_stiffness *= by;
        joint.shear_stiffness *= by;
        joint.cohesion *= by;
        joint.tensile_strength *= by;
    }
    slope.settings.duration *= std::sqrt(by);
    return slope;
}

inline DrawnSlope in_another_order(DrawnSlope slope, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::shuffle(slope.scene.block.begin(), slope.scene.block.end(), random);
    slope.scene.bond = find_bonds(slope.scene);
    return slope;
}

inline DrawnSlope with_more_vertices(DrawnSlope slope) {
    for (RelaxationBlock& block : slope.scene.block) {
        RelaxationBlock more = block;
        more.outline.clear();
        more.joint.clear();
        for (std::size_t edge = 0; edge < block.outline.size(); ++edge) {
            const PlanePoint<>& from = block.outline[edge];
            const PlanePoint<>& to = block.outline[(edge + 1) % block.outline.size()];
            more.outline.push_back(from);
            more.outline.push_back(from + 0.4 * (to - from));
            const std::size_t joint = block.joint.empty() ? 0 : block.joint[edge];
            more.joint.insert(more.joint.end(), 2, joint);
        }
        block = std::move(more);
    }
    leave_out_straight_vertices(slope.scene);
    slope.scene.bond = find_bonds(slope.scene);
    return slope;
}

// A slope that only corners hold counts neither as standing nor as failing.
enum class Verdict { stands, held_by_corners, fails, none };

inline Verdict verdict_of(const DrawnSlope& slope) {
    const RelaxationOutcome outcome = relax(slope.scene, slope.settings).outcome;
    return outcome == RelaxationOutcome::equilibrium                                       ? Verdict::stands
           : outcome == RelaxationOutcome::held_by_corners                                 ? Verdict::held_by_corners
           : outcome == RelaxationOutcome::onset || outcome == RelaxationOutcome::collapse ? Verdict::fails
                                                                                           : Verdict::none;
}

struct Variant {
    std::string name;
    Verdict verdict;
};

// Verdicts on a slope in all its descriptions that have the same rock and joints; the first is the slope itself.
inline std::vector<Variant> verdicts_of(const RelaxationStudy& study, std::uint32_t seed) {
    const DrawnSlope slope = drawn(study);
    DrawnSlope on_two_threads = slope;
    on_two_threads.settings.threads = 2;
    return {{"as drawn", verdict_of(slope)},
            {"mirrored", verdict_of(drawn(mirrored(study)))},
            {"set by another trace", verdict_of(drawn(with_sets_by_another_trace(study)))},
            {"cuts in reverse", verdict_of(drawn(with_cuts_reversed(study)))},
            {"turned", verdict_of(turned(slope, 0.6))},
            {"moved", verdict_of(moved_away(slope, 1e4))},
            {"small", verdict_of(scaled(slope, 1e-2))},
            {"large", verdict_of(scaled(slope, 1e3))},
            {"other order", verdict_of(in_another_order(slope, seed))},
            {"more vertices", verdict_of(with_more_vertices(slope))},
            {"two threads", verdict_of(on_two_threads)}};
}

}  // namespace delabole::testing
