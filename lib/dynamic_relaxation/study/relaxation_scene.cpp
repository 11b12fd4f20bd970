// Converts case parameters to a scene and settings.
#include "dynamic_relaxation/blocks/joint_water.hpp"
#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/scene/bolts.hpp"
#include "dynamic_relaxation/scene/scenes.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "dynamic_relaxation/scene/straight_vertices.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace delabole {

namespace {

RelaxationAccuracy accuracy_of(const RelaxationStudy& study) {
    const RelaxationNumerics numerics = study.settings.value_or(RelaxationNumerics{});
    return accuracy_of(numerics.quality.value_or(RelaxationQuality::standard));
}

// Stiffness 0 means that it follows from the stiffness ratio.
JointMaterial material_of(const RelaxationJoint& joint) {
    const double normal = joint.normal_stiffness.value_or(0);
    return {normal,
            joint.shear_stiffness.value_or(normal),
            joint.friction_angle,
            joint.residual_friction_angle,
            joint.cohesion.value_or(0),
            joint.tensile_strength.value_or(0),
            joint.bond,
            joint.residual_cohesion.value_or(0)};
}

// A normal deviate within twice the deviation, the same on every machine: Marsaglia's polar method on the bits of the
// generator.
double deviate(std::mt19937_64& random) {
    constexpr double most = 2;
    const auto uniform = [&] { return 2 * (static_cast<double>(random() >> 11U) * 0x1p-53) - 1; };
    for (;;) {
        const double one = uniform();
        const double other = uniform();
        const double square = one * one + other * other;
        if (square > 0 && square < 1) {
            const double value = one * std::sqrt(-2 * std::log(square) / square);
            if (std::abs(value) <= most) {
                return value;
            }
        }
    }
}

double scattered(double friction_angle, double deviation) {
    return std::clamp(friction_angle + deviation, 0.0, degrees(89.9));
}

// Heights are drawn before the blocks are made; friction is drawn afterwards, joint by joint from the toe up.
void scatter_heights(StandingBlocks& blocks, const RelaxationScatter& scatter, std::mt19937_64& random) {
    for (StandingBlock& block : blocks.block) {
        block.height *= 1 + scatter.height_deviation * deviate(random);
    }
}

void scatter_friction(RelaxationScene& scene, std::size_t standing, const RelaxationScatter& scatter,
                      std::mt19937_64& random) {
    constexpr std::size_t bottom = 0;
    constexpr std::size_t right = 1;
    constexpr std::size_t top = 2;
    constexpr std::size_t left = 3;
    const auto drawn = [&](std::size_t material) {
        JointMaterial joint = scene.material[material];
        const double deviation = scatter.friction_deviation * deviate(random);
        joint.friction_angle = scattered(joint.friction_angle, deviation);
        if (joint.residual_friction_angle) {
            joint.residual_friction_angle =
                std::min(scattered(*joint.residual_friction_angle, deviation), joint.friction_angle);
        }
        scene.material.push_back(joint);
        return scene.material.size() - 1;
    };
    for (std::size_t block = 0; block < standing; ++block) {
        scene.block[block].joint[bottom] = drawn(scene.block[block].joint[bottom]);
        if (block + 1 < standing) {
            scene.block[block].joint[right] = scene.block[block + 1].joint[left] =
                drawn(scene.block[block].joint[right]);
        }
    }
    // The lesser friction of two faces counts. The base has so much that below each block its own friction does.
    JointMaterial below = scene.material[scene.block[standing].joint[top]];
    below.friction_angle = degrees(89.9);
    below.residual_friction_angle.reset();
    scene.material.push_back(below);
    for (std::size_t base = standing; base < scene.block.size(); ++base) {
        scene.block[base].joint[top] = scene.material.size() - 1;
    }
}

// Numbers in a case are counted from 1. A number that no block has becomes one that the scene's check refuses.
std::size_t index_of(double number) {
    constexpr double most = 1e9;
    return number >= 1 && number <= most && number == std::floor(number) ? static_cast<std::size_t>(number) - 1
                                                                         : static_cast<std::size_t>(-1);
}

void apply_hold(RelaxationBlock& block, const std::optional<BlockHold>& hold) {
    block.fixed = hold == BlockHold::fixed;
    block.held_at_first = hold == BlockHold::held_at_first;
}

template <class Standing>
StandingBlocks standing_blocks(const Standing& standing) {
    StandingBlocks blocks{
        {}, standing.density, material_of(standing.interface), material_of(standing.base), standing.tilt};
    for (const auto& block : standing.block) {
        double step = 0;
        if constexpr (requires { block.step_above; }) {
            step = block.step_above;
        }
        blocks.block.push_back({block.width, block.height, step});
    }
    return blocks;
}

template <class Standing>
RelaxationScene standing_scene(const Standing& standing, RelaxationScene (*draw)(const StandingBlocks&)) {
    StandingBlocks blocks = standing_blocks(standing);
    std::mt19937_64 random(standing.scatter ? static_cast<std::uint64_t>(standing.scatter->seed) : 0);
    if (standing.scatter) {
        scatter_heights(blocks, *standing.scatter, random);
    }
    RelaxationScene scene = draw(blocks);
    if (standing.scatter) {
        scatter_friction(scene, blocks.block.size(), *standing.scatter, random);
    }
    for (std::size_t index = 0; index < standing.block.size(); ++index) {
        apply_hold(scene.block[index], standing.block[index].hold);
    }
    return scene;
}

RelaxationScene blocks_of(const RelaxationRow& row) {
    return standing_scene(row, &row_scene);
}

RelaxationScene blocks_of(const RelaxationColumns& columns) {
    return standing_scene(columns, &column_scene);
}

RelaxationScene blocks_of(const RelaxationPolygons& polygons) {
    RelaxationScene scene;
    for (const RelaxationJoint& joint : polygons.joint) {
        scene.material.push_back(material_of(joint));
    }
    scene.gravity.tilt = scene.gravity.final_tilt = polygons.tilt;
    for (const RelaxationPolygon& polygon : polygons.block) {
        RelaxationBlock block{{}, polygon.density};
        apply_hold(block, polygon.hold);
        for (const RelaxationVertex& vertex : polygon.vertex) {
            block.outline.emplace_back(vertex.x, vertex.y);
            block.joint.push_back(index_of(vertex.joint.value_or(polygon.joint.value_or(1))));
        }
        scene.block.push_back(std::move(block));
    }
    return scene;
}

// The scene has no blocks if the slope cannot be cut.
RelaxationScene blocks_of(const RelaxationSlope& slope) {
    SlopeScene made = slope_scene(slope);
    RelaxationScene scene;
    for (const SlopeJoint& joint : slope.joint) {
        scene.material.push_back(material_of(joint.strength));
    }
    scene.gravity.tilt = scene.gravity.final_tilt = slope.tilt.value_or(0);
    scene.block = std::move(made.block);
    scene.pressure = std::move(made.pressure);
    scene.removal = std::move(made.removal);
    return scene;
}

// Blocks, joints and water on given faces, without the other loads.
RelaxationScene drawn_scene(const RelaxationStudy& study) {
    RelaxationScene scene = std::visit([](const auto& blocks) { return blocks_of(blocks); }, study.model.scene);
    for (const WaterPressure& pressure : study.model.pressure) {
        scene.pressure.push_back(
            {index_of(pressure.block), index_of(pressure.edge), pressure.at_first, pressure.at_second});
    }
    if (std::holds_alternative<RelaxationPolygons>(study.model.scene)) {
        leave_out_straight_vertices(scene);
    }
    return scene;
}

// Extent of the outline along a direction.
double extent_along(const PlanePoint<>& direction, const Polygon<>& outline) {
    const auto [least, greatest] = std::minmax_element(
        outline.begin(), outline.end(),
        [&](const PlanePoint<>& one, const PlanePoint<>& other) { return direction.dot(one) < direction.dot(other); });
    return direction.dot(*greatest - *least);
}

// The direction of the edge that is nearest to horizontal. Unlike the axes of the section it turns with the block.
PlanePoint<> most_level_edge(const Polygon<>& outline, const PlanePoint<>& up) {
    PlanePoint<> most_level(1, 0);
    double least_rise = std::numeric_limits<double>::infinity();
    for (std::size_t corner = 0; corner < outline.size(); ++corner) {
        const PlanePoint<> edge = outline[(corner + 1) % outline.size()] - outline[corner];
        const double rise = std::abs(up.dot(edge)) / edge.norm();
        constexpr double alike = 1e-9;  // opposite edges
        if (rise < least_rise - alike) {
            least_rise = rise;
            most_level = edge.normalized();
        }
    }
    return most_level;
}

// Greatest weight over width of the free blocks, N/m2. The width of a block is measured along its base; blocks that
// joints cut out of a slope may have no base and are measured normal to gravity. Neither width changes when scene and
// gravity are rotated together.
double greatest_weight_over_width(const RelaxationScene& scene, bool is_slope) {
    const PlanePoint<> up(std::sin(scene.gravity.tilt), std::cos(scene.gravity.tilt));
    const PlanePoint<> level(up.y(), -up.x());
    double greatest = 0;
    for (const RelaxationBlock& block : scene.block) {
        if (block.fixed || block.outline.empty()) {
            continue;
        }
        const double width = extent_along(is_slope ? level : most_level_edge(block.outline, up), block.outline);
        const double weight = block.density * area_properties(block.outline).area * scene.gravity.acceleration;
        greatest = std::max(greatest, width > 0 ? weight / width : 0);
    }
    return greatest;
}

void stiffen(RelaxationScene& scene, bool is_slope, double ratio) {
    const double stiffness = ratio * greatest_weight_over_width(scene, is_slope);
    for (JointMaterial& material : scene.material) {
        material.normal_stiffness = material.normal_stiffness > 0 ? material.normal_stiffness : stiffness;
        material.shear_stiffness = material.shear_stiffness > 0 ? material.shear_stiffness : material.normal_stiffness;
    }
}

void apply_tilting(RelaxationScene& scene, const Tilting& tilting) {
    Gravity& gravity = scene.gravity;
    const double start = tilting.start.value_or(0);
    if (tilting.turned == TiltingFrame::gravity) {
        gravity.final_tilt = tilting.final_tilt;
        gravity.rate = tilting.rate;
        gravity.interval = tilting.interval.value_or(0);
        gravity.start = start;
        return;
    }
    const double rotation = tilting.final_tilt - gravity.tilt;
    for (std::size_t block = 0; block < scene.block.size(); ++block) {
        if (scene.block[block].fixed) {
            PrescribedMotion motion{block, {}};
            // A base that dips more towards -x has rotated anticlockwise.
            motion.angular_velocity = std::copysign(tilting.rate, rotation);
            motion.pivot = {tilting.pivot_x.value_or(0), tilting.pivot_y.value_or(0)};
            motion.start = start;
            motion.duration = std::abs(rotation) / tilting.rate;
            scene.motion.push_back(std::move(motion));
        }
    }
}

// If this is false, the scene's check refuses the scene before its joints are used.
bool all_joints_known(const RelaxationScene& scene) {
    return std::ranges::all_of(scene.block, [&](const RelaxationBlock& block) {
        return block.outline.size() >= 3 &&
               std::ranges::all_of(block.joint, [&](std::size_t material) { return material < scene.material.size(); });
    });
}

// For blocks that share no face a pressure is added that the scene's check refuses.
void add_joint_water(RelaxationScene& scene, const std::vector<WaterInJoint>& joint_water) {
    constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
    if (joint_water.empty() || !all_joints_known(scene)) {
        return;
    }
    const Bodies bodies = make_bodies(scene);
    for (const WaterInJoint& given : joint_water) {
        const JointWater water{index_of(given.block), index_of(given.other), given.at_first, given.at_second};
        std::vector<FacePressure> pressures;
        if (water.block < bodies.size() && water.other < bodies.size()) {
            pressures = pressures_of(water, bodies);
        }
        if (pressures.empty()) {
            pressures.push_back({water.block, nowhere, water.at_first, water.at_second});
        }
        scene.pressure.insert(scene.pressure.end(), pressures.begin(), pressures.end());
    }
}

void apply_crack_opening(const RelaxationStudy& study, const RelaxationScene& scene, RelaxationSettings& settings) {
    constexpr double of_columns = 0.01;
    std::optional<double> share = study.settings.value_or(RelaxationNumerics{}).crack_opening;
    if (!share && !std::holds_alternative<RelaxationPolygons>(study.model.scene)) {
        share = of_columns;
    }
    if (share) {
        double shortest = std::numeric_limits<double>::infinity();
        for (const RelaxationBlock& block : scene.block) {
            for (std::size_t vertex = 0; vertex < block.outline.size(); ++vertex) {
                const PlanePoint<> edge = block.outline[(vertex + 1) % block.outline.size()] - block.outline[vertex];
                shortest = block.fixed ? shortest : std::min(shortest, edge.norm());
            }
        }
        settings.crack_opening = *share * shortest;
    }
}

}  // namespace

double stiffness_ratio_of(const RelaxationStudy& study) {
    return study.settings.value_or(RelaxationNumerics{}).stiffness_ratio.value_or(accuracy_of(study).stiffness_ratio);
}

std::size_t number_of_blocks(const RelaxationStudy& study) {
    struct Count {
        std::size_t operator()(const RelaxationRow& row) const { return row.block.size() + 1; }
        std::size_t operator()(const RelaxationColumns& columns) const { return 2 * columns.block.size(); }
        std::size_t operator()(const RelaxationPolygons& polygons) const { return polygons.block.size(); }
        std::size_t operator()(const RelaxationSlope& slope) const { return slope_scene(slope).block.size(); }
    };
    return std::visit(Count{}, study.model.scene);
}

RelaxationScene relaxation_scene(const RelaxationStudy& study) {
    const Relaxation& model = study.model;
    RelaxationScene scene = drawn_scene(study);
    scene.gravity.acceleration = model.gravity.value_or(scene.gravity.acceleration);
    stiffen(scene, std::holds_alternative<RelaxationSlope>(model.scene), stiffness_ratio_of(study));
    if (all_joints_known(scene)) {
        scene.bond = find_bonds(scene);
    }
    scene.belt = model.base_friction;
    if (model.tilting) {
        apply_tilting(scene, *model.tilting);
    }
    for (const ForceOnBlock& force : model.force) {
        scene.force.push_back({index_of(force.block), {force.x, force.y}, {force.horizontal, force.vertical}});
    }
    const std::vector<RelaxationBolt> bolts = all_bolts(model);
    for (std::size_t index = 0; index < bolts.size(); ++index) {
        const std::vector<BoltSegment> segments = bolt_segments(scene, bolts[index], index);
        scene.bolt.insert(scene.bolt.end(), segments.begin(), segments.end());
    }
    add_joint_water(scene, model.joint_water);
    for (const ShakingPoint& point : model.shaking) {
        scene.shaking.push_back({point.time, {point.horizontal, point.vertical}});
    }
    for (const FixedBlockMotion& moved : model.motion) {
        PrescribedMotion motion{index_of(moved.block), {}};
        for (const VelocityPoint& point : moved.velocity) {
            motion.velocity.push_back({point.time, {point.horizontal, point.vertical}});
        }
        if (moved.turning) {
            motion.angular_velocity = moved.turning->rate;
            motion.pivot = {moved.turning->pivot_x, moved.turning->pivot_y};
            motion.start = moved.turning->start;
            motion.duration = moved.turning->duration;
        }
        scene.motion.push_back(std::move(motion));
    }
    for (const BlockRemoval& removal : model.removal) {
        scene.removal.push_back({index_of(removal.block), removal.time});
    }
    return scene;
}

RelaxationSettings relaxation_settings(const RelaxationStudy& study) {
    return relaxation_settings(study, drawn_scene(study));
}

RelaxationSettings relaxation_settings(const RelaxationStudy& study, const RelaxationScene& scene) {
    const RelaxationNumerics numerics = study.settings.value_or(RelaxationNumerics{});
    const RelaxationAccuracy accuracy = accuracy_of(study);
    RelaxationSettings settings;
    const auto take = [](auto& setting, const auto& given) {
        if (given) {
            setting = static_cast<std::remove_reference_t<decltype(setting)>>(*given);
        }
    };
    settings.step_fraction = numerics.step_fraction.value_or(accuracy.step_fraction);
    settings.equilibrium_ratio = numerics.equilibrium_ratio.value_or(accuracy.equilibrium_ratio);
    settings.time_step = numerics.time_step;
    take(settings.viscous_damping, numerics.viscous_damping);
    // Shaking leaves permanent displacements, which damping would reduce.
    settings.local_damping = has_record_of_shaking(study) ? 0 : settings.local_damping;
    take(settings.local_damping, numerics.local_damping);
    settings.kinetic_damping = numerics.kinetic_damping == OffOn::on;
    settings.corners_bear = numerics.corners_bear == OffOn::on;
    settings.mass_scaling = numerics.mass_scaling == OffOn::on;
    take(settings.start, numerics.start);
    take(settings.ramp_time, numerics.ramp_time);
    take(settings.consolidation_time, numerics.consolidation_time);
    take(settings.onset_rotation, numerics.onset_rotation);
    take(settings.onset_slide, numerics.onset_slide);
    take(settings.collapse_rotation, numerics.collapse_rotation);
    take(settings.collapse_displacement, numerics.collapse_displacement);
    const RelaxationStop stop = numerics.stop.value_or(RelaxationStop::equilibrium);
    settings.stop_at_onset = stop == RelaxationStop::onset;
    settings.stop_at_equilibrium = stop != RelaxationStop::collapse;
    settings.stop_at_collapse = stop != RelaxationStop::rest;
    settings.taken_away_below = numerics.taken_away_below;
    take(settings.duration, numerics.duration);
    if (numerics.watch) {
        settings.duration = *numerics.watch;
        settings.stop_at_equilibrium = settings.stop_at_collapse = false;
    }
    take(settings.most_steps, numerics.most_steps);
    take(settings.overlap_limit, numerics.overlap_limit);
    apply_crack_opening(study, scene, settings);
    return settings;
}

}  // namespace delabole
