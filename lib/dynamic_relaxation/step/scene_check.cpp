#include "dynamic_relaxation/step/scene_check.hpp"

#include "dynamic_relaxation/blocks/neighbours.hpp"
#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"
#include "dynamic_relaxation/contact/pair_search.hpp"
#include "parameters/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

constexpr double longest_to_shortest_edge = 1e5;
constexpr double shortest_edge_in_radii = 1e-6;
constexpr double softest = 10;     // stiffness over the weight of a block and its length
constexpr double stiffest = 1e13;  // stiffness over the same; above it an overlap has less than three digits
constexpr double greatest_friction = 89.95;
constexpr double straight = 1e-9;  // sine of a corner's turn

bool finite(const PlanePoint<>& point) {
    return std::isfinite(point.x()) && std::isfinite(point.y());
}

bool increasing(const std::vector<TimedVector>& record) {
    for (std::size_t index = 1; index < record.size(); ++index) {
        if (!(record[index].time > record[index - 1].time)) {
            return false;
        }
    }
    return true;
}

bool finite(const std::vector<TimedVector>& record) {
    return std::all_of(record.begin(), record.end(),
                       [](const TimedVector& entry) { return std::isfinite(entry.time) && finite(entry.value); });
}

SceneCheck check_outline(const Polygon<>& outline) {
    if (!std::all_of(outline.begin(), outline.end(), [](const PlanePoint<>& vertex) { return finite(vertex); })) {
        return SceneCheck::number_not_finite;
    }
    const std::size_t count = outline.size();
    if (count < 3 || !(area_properties(outline).area > 0)) {
        return SceneCheck::outline_not_convex;
    }
    double turning = 0;
    double longest = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t vertex = 0; vertex < count; ++vertex) {
        const PlanePoint<> edge = outline[(vertex + 1) % count] - outline[vertex];
        const PlanePoint<> next = outline[(vertex + 2) % count] - outline[(vertex + 1) % count];
        const double cross = edge.x() * next.y() - edge.y() * next.x();
        // A corner in the middle of a straight face may deviate from it by rounding.
        if (cross < -straight * edge.norm() * next.norm()) {
            return SceneCheck::outline_not_convex;
        }
        turning += std::atan2(std::abs(cross), edge.dot(next));
        longest = std::max(longest, edge.norm());
        shortest = std::min(shortest, edge.norm());
    }
    // An outline that winds round twice has a total turn of more than a circle.
    if (turning > 7) {
        return SceneCheck::outline_not_convex;
    }
    return shortest > shortest_edge_in_radii * longest ? SceneCheck::valid : SceneCheck::edge_too_short;
}

SceneCheck check_material(const JointMaterial& joint) {
    const double residual = joint.residual_friction_angle.value_or(joint.friction_angle);
    for (const double number : {joint.normal_stiffness, joint.shear_stiffness, joint.friction_angle, residual,
                                joint.cohesion, joint.tensile_strength, joint.residual_cohesion}) {
        if (!std::isfinite(number)) {
            return SceneCheck::number_not_finite;
        }
    }
    if (!(joint.normal_stiffness > 0) || !(joint.shear_stiffness > 0)) {
        return SceneCheck::stiffness_not_positive;
    }
    if (joint.friction_angle < 0 || joint.friction_angle > degrees(greatest_friction) || residual < 0 ||
        residual > joint.friction_angle) {
        return SceneCheck::friction_out_of_range;
    }
    return joint.residual_cohesion < 0 || joint.cohesion < joint.residual_cohesion || joint.tensile_strength < 0
               ? SceneCheck::strength_negative
               : SceneCheck::valid;
}

SceneFault check_materials(const RelaxationScene& scene) {
    for (std::size_t index = 0; index < scene.material.size(); ++index) {
        const SceneCheck check = check_material(scene.material[index]);
        if (check != SceneCheck::valid) {
            return {check, index};
        }
    }
    return {};
}

SceneFault check_blocks(const RelaxationScene& scene) {
    double longest = 0;
    double shortest = std::numeric_limits<double>::infinity();
    bool any_free = false;
    for (std::size_t index = 0; index < scene.block.size(); ++index) {
        const RelaxationBlock& block = scene.block[index];
        const SceneCheck outline = check_outline(block.outline);
        if (outline != SceneCheck::valid) {
            return {outline, index};
        }
        if (!std::isfinite(block.density)) {
            return {SceneCheck::number_not_finite, index};
        }
        if (!(block.density > 0)) {
            return {SceneCheck::density_not_positive, index};
        }
        if (!block.joint.empty() && block.joint.size() != block.outline.size()) {
            return {SceneCheck::unknown_edge, index};
        }
        for (const std::size_t material : block.joint) {
            if (material >= scene.material.size()) {
                return {SceneCheck::unknown_material, index};
            }
        }
        any_free |= !block.fixed;
        double perimeter = 0;
        for (std::size_t vertex = 0; vertex < block.outline.size(); ++vertex) {
            const double edge = (block.outline[(vertex + 1) % block.outline.size()] - block.outline[vertex]).norm();
            shortest = std::min(shortest, edge);
            perimeter += edge;
        }
        longest = block.fixed ? longest : std::max(longest, perimeter / 2);
        if (!(longest < longest_to_shortest_edge * shortest)) {
            return {SceneCheck::sizes_too_different, index};
        }
    }
    return any_free ? SceneFault{} : SceneFault{SceneCheck::no_free_block, 0};
}

// A joint has to carry the blocks that it separates: it may be neither as soft as a cushion nor too stiff for the
// precision of numbers.
SceneFault check_stiffness(const RelaxationScene& scene) {
    for (std::size_t index = 0; index < scene.block.size(); ++index) {
        const RelaxationBlock& block = scene.block[index];
        if (block.fixed) {
            continue;
        }
        const double area = area_properties(block.outline).area;
        const double weight = block.density * area * (scene.gravity.acceleration > 0 ? scene.gravity.acceleration : 1);
        const double size = std::sqrt(area);
        for (std::size_t edge = 0; edge < block.outline.size(); ++edge) {
            const JointMaterial& joint = scene.material[block.joint.empty() ? 0 : block.joint[edge]];
            const double ratio = joint.normal_stiffness * size / weight;
            if (ratio < softest) {
                return {SceneCheck::stiffness_too_soft, index};
            }
            if (ratio > stiffest) {
                return {SceneCheck::stiffness_too_stiff, index};
            }
        }
    }
    return {};
}

SceneFault check_loads(const RelaxationScene& scene) {
    const std::size_t count = scene.block.size();
    for (std::size_t index = 0; index < scene.force.size(); ++index) {
        const PointForce& force = scene.force[index];
        if (force.block >= count) {
            return {SceneCheck::unknown_block, index};
        }
        if (!finite(force.at) || !finite(force.force)) {
            return {SceneCheck::number_not_finite, index};
        }
    }
    for (const BoltSegment& segment : scene.bolt) {
        if (segment.block >= count || segment.other >= count) {
            return {SceneCheck::bolt_outside_blocks, segment.bolt};
        }
        if (!finite(segment.at) || !finite(segment.other_at) || !std::isfinite(segment.stiffness) ||
            !std::isfinite(segment.capacity)) {
            return {SceneCheck::number_not_finite, segment.bolt};
        }
        if (!(segment.pretension >= 0 && segment.pretension <= segment.capacity && segment.stiffness > 0)) {
            return {SceneCheck::load_out_of_range, segment.bolt};
        }
    }
    for (std::size_t index = 0; index < scene.pressure.size(); ++index) {
        const FacePressure& pressure = scene.pressure[index];
        if (pressure.block >= count) {
            return {SceneCheck::unknown_block, index};
        }
        if (pressure.edge >= scene.block[pressure.block].outline.size()) {
            return {SceneCheck::unknown_edge, index};
        }
        if (!std::isfinite(pressure.at_first) || !std::isfinite(pressure.at_second)) {
            return {SceneCheck::number_not_finite, index};
        }
        if (pressure.at_first < 0 || pressure.at_second < 0) {
            return {SceneCheck::load_out_of_range, index};
        }
        if (const std::optional<EdgePart>& part = pressure.part) {
            if (!std::isfinite(part->begin) || !std::isfinite(part->end)) {
                return {SceneCheck::number_not_finite, index};
            }
            const Polygon<>& outline = scene.block[pressure.block].outline;
            const double length = (outline[(pressure.edge + 1) % outline.size()] - outline[pressure.edge]).norm();
            if (!(part->begin >= 0 && part->end > part->begin && part->end <= length)) {
                return {SceneCheck::load_out_of_range, index};
            }
        }
    }
    for (std::size_t index = 0; index < scene.motion.size(); ++index) {
        const PrescribedMotion& motion = scene.motion[index];
        if (motion.block >= count) {
            return {SceneCheck::unknown_block, index};
        }
        if (!scene.block[motion.block].fixed) {
            return {SceneCheck::motion_of_free_block, index};
        }
        if (!finite(motion.velocity) || !finite(motion.pivot) || !std::isfinite(motion.angular_velocity) ||
            !std::isfinite(motion.start) || !std::isfinite(motion.duration)) {
            return {SceneCheck::number_not_finite, index};
        }
        if (!increasing(motion.velocity)) {
            return {SceneCheck::times_not_increasing, index};
        }
        if (motion.duration < 0) {
            return {SceneCheck::load_out_of_range, index};
        }
    }
    std::vector<char> stays(count, 0);
    std::ranges::transform(scene.block, stays.begin(),
                           [](const RelaxationBlock& block) { return block.fixed ? 0 : 1; });
    for (std::size_t index = 0; index < scene.removal.size(); ++index) {
        if (scene.removal[index].block >= count) {
            return {SceneCheck::unknown_block, index};
        }
        if (!std::isfinite(scene.removal[index].time)) {
            return {SceneCheck::number_not_finite, index};
        }
        stays[scene.removal[index].block] = 0;
    }
    if (std::ranges::count(stays, 1) == 0) {
        return {SceneCheck::no_block_left, 0};
    }
    if (!finite(scene.shaking)) {
        return {SceneCheck::number_not_finite, 0};
    }
    return increasing(scene.shaking) ? SceneFault{} : SceneFault{SceneCheck::times_not_increasing, 0};
}

SceneFault check_bonds(const RelaxationScene& scene) {
    for (std::size_t index = 0; index < scene.bond_material.size(); ++index) {
        const BondMaterial& material = scene.bond_material[index];
        for (const double number : {material.young_modulus, material.shear_modulus, material.tensile_strength,
                                    material.cohesion, material.friction_angle, material.spacing.value_or(1)}) {
            if (!std::isfinite(number)) {
                return {SceneCheck::number_not_finite, index};
            }
        }
        if (!(material.young_modulus > 0) || !(material.shear_modulus > 0) || !(material.spacing.value_or(1) > 0)) {
            return {SceneCheck::modulus_not_positive, index};
        }
        if (material.tensile_strength < 0 || material.cohesion < 0) {
            return {SceneCheck::strength_negative, index};
        }
        if (material.friction_angle < 0 || material.friction_angle > degrees(greatest_friction)) {
            return {SceneCheck::friction_out_of_range, index};
        }
    }
    if (scene.bond.empty()) {
        return {};
    }
    const Bodies bodies = make_bodies(scene);
    for (std::size_t index = 0; index < scene.bond.size(); ++index) {
        const FaceBond& bond = scene.bond[index];
        if (bond.block >= bodies.size() || bond.other >= bodies.size() || bond.block == bond.other) {
            return {SceneCheck::unknown_block, index};
        }
        if (bond.edge >= bodies.range[bond.block].size() || bond.other_edge >= bodies.range[bond.other].size()) {
            return {SceneCheck::unknown_edge, index};
        }
        if (bond.material && *bond.material >= scene.bond_material.size()) {
            return {SceneCheck::unknown_material, index};
        }
        if ((scene.block[bond.block].fixed && scene.block[bond.other].fixed) ||
            !shared_face(bodies, bodies.range[bond.block].begin + bond.edge,
                         bodies.range[bond.other].begin + bond.other_edge)) {
            return {SceneCheck::bond_without_face, index};
        }
    }
    return {};
}

SceneFault check_belt(const RelaxationScene& scene) {
    if (!scene.belt) {
        return {};
    }
    if (!std::isfinite(scene.belt->speed) || !std::isfinite(scene.belt->friction_angle)) {
        return {SceneCheck::number_not_finite, 0};
    }
    if (!(scene.belt->friction_angle > 0) || scene.belt->friction_angle > degrees(greatest_friction)) {
        return {SceneCheck::friction_out_of_range, 0};
    }
    const bool pressed = scene.gravity.acceleration > 0;
    return scene.belt->speed > 0 && pressed ? SceneFault{} : SceneFault{SceneCheck::load_out_of_range, 0};
}

double softest_joint(const RelaxationScene& scene, const Bodies& bodies, std::size_t block) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t edge = bodies.range[block].begin; edge < bodies.range[block].end; ++edge) {
        least = std::min(least, scene.material[bodies.material[edge]].normal_stiffness);
    }
    return least;
}

}  // namespace

SceneFault check_settings(const RelaxationSettings& settings) {
    const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
    const auto not_negative = [](double value) { return value >= 0 && std::isfinite(value); };
    const bool valid = within(settings.step_fraction, 0.01, 0.8) &&
                       (!settings.time_step || (*settings.time_step > 0 && std::isfinite(*settings.time_step))) &&
                       within(settings.viscous_damping, 0, 2) && settings.local_damping >= 0 &&
                       settings.local_damping < 1 && not_negative(settings.ramp_time) &&
                       not_negative(settings.consolidation_time) && settings.equilibrium_ratio > 0 &&
                       settings.onset_rotation > 0 && settings.onset_slide > 0 && settings.collapse_rotation > 0 &&
                       settings.collapse_displacement > 0 && settings.duration >= 0 && settings.overlap_limit >= 0.02 &&
                       settings.threads > 0 && settings.crack_opening.value_or(1) > 0;
    return valid ? SceneFault{} : SceneFault{SceneCheck::setting_out_of_range, 0};
}

SceneFault check_scene(const RelaxationScene& scene) {
    const Gravity& gravity = scene.gravity;
    for (const double number :
         {gravity.acceleration, gravity.tilt, gravity.final_tilt, gravity.rate, gravity.interval, gravity.start}) {
        if (!std::isfinite(number)) {
            return {SceneCheck::number_not_finite, 0};
        }
    }
    if (gravity.acceleration < 0 || gravity.rate < 0 || gravity.interval < 0) {
        return {SceneCheck::load_out_of_range, 0};
    }
    if (scene.material.empty()) {
        return {SceneCheck::unknown_material, 0};
    }
    // Blocks are checked first: stiffnesses that follow from their weights are wrong if those are.
    for (const auto check : {check_blocks, check_materials, check_stiffness, check_loads, check_bonds, check_belt}) {
        const SceneFault fault = check(scene);
        if (fault.check != SceneCheck::valid) {
            return fault;
        }
    }
    return {};
}

SceneFault check_start(const RelaxationScene& scene) {
    constexpr double deepest_in_settlements = 10;
    const Bodies bodies = make_bodies(scene);
    const std::vector<Motion> unmoved(bodies.size());
    const double margin = 1e-9 * *std::min_element(bodies.shortest_edge.begin(), bodies.shortest_edge.end());
    const std::vector<char> none_removed(bodies.size(), 0);
    const double gravity = scene.gravity.acceleration > 0 ? scene.gravity.acceleration : 1;
    const auto allowed = [&](std::size_t block, std::size_t other, double stiffness) {
        const double lighter = 1 / std::max(bodies.inverse_mass[block], bodies.inverse_mass[other]);
        return deepest_in_settlements * lighter * gravity / stiffness + margin;
    };
    const std::vector<BlockPair> pairs =
        neighbouring_blocks(bodies, unmoved, none_removed, std::vector<double>(bodies.size(), margin / 2));
    const std::vector<ShiftedPair> shifted = closing_shifts(bodies);
    // Pairs are checked one at a time: a list of all contacts would take most of the memory and of the time of a check.
    PairSearch search(scene, bodies, 0);
    const ContactList none;
    PairContacts found;
    for (const BlockPair& pair : pairs) {
        const auto [first, second] = pair;
        const OutlineShift shift = shift_of(pair, shifted);
        // Half the margin is safe from rounding: the search computes the same distance by other sums.
        const InitialDistance initial = initial_distance(bodies, first, second, margin / 2);
        if (initial.may_overlap) {
            search.find(pair, unmoved, {margin, true, shift}, none, {0, 0}, {}, found);
        } else {
            found.clear();
        }
        for (std::size_t index = 0; index < found.contact.size(); ++index) {
            const RelaxationContact& contact = found.contact[index];
            const ContactLaw& law = found.law[index];
            const ContactMemory& memory = found.memory[index];
            const ContactPosition at = locate(contact, unmoved[contact.block], unmoved[contact.other]);
            if (!memory.beneath && !memory.yields && contact_weight(law, contact, at, memory.insists) > 0 &&
                -at.gap > allowed(contact.block, contact.other, law.normal_stiffness)) {
                return {SceneCheck::overlap_at_start, contact.block, contact.other};
            }
        }
        // Blocks that cross or overlap deeply have no contacts.
        const double stiffness = std::min(softest_joint(scene, bodies, first), softest_joint(scene, bodies, second));
        const double as_shifted = shift == OutlineShift{} ? 0 : opening_of_closed_joint(bodies, first, second);
        if (-initial.distance > allowed(first, second, stiffness) + as_shifted) {
            return {SceneCheck::overlap_at_start, first, second};
        }
    }
    return {};
}

SceneFault check_departure(const RelaxationScene& scene, const RelaxationSettings& settings) {
    for (std::size_t block = 0; settings.taken_away_below && block < scene.block.size(); ++block) {
        const auto below = [&](const PlanePoint<>& corner) { return corner.y() < *settings.taken_away_below; };
        if (!scene.block[block].fixed && std::ranges::all_of(scene.block[block].outline, below)) {
            return {SceneCheck::setting_out_of_range, block};
        }
    }
    return {};
}

SceneFault check(const RelaxationScene& scene, const RelaxationSettings& settings) {
    SceneFault fault = check_settings(settings);
    fault = fault.check == SceneCheck::valid ? check_scene(scene) : fault;
    fault = fault.check == SceneCheck::valid ? check_departure(scene, settings) : fault;
    return fault.check == SceneCheck::valid ? check_start(scene) : fault;
}

}  // namespace delabole
