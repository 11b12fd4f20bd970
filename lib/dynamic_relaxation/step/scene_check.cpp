#include "dynamic_relaxation/step/scene_check.hpp"

#include "dynamic_relaxation/blocks/neighbours.hpp"
#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"
#include "dynamic_relaxation/contact/pair_search.hpp"
#include "parameters/fields.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace delabole {

namespace {

constexpr double longest_to_shortest_edge = 1e5;
constexpr double shortest_edge_in_radii = 1e-6;
constexpr double softest = 10;     // stiffness over the weight of a block and its length
constexpr double stiffest = 1e13;  // stiffness over the same; above it an overlap has less than three digits
constexpr double greatest_friction = 89.95;
constexpr double straight = 1e-9;  // sine of a corner's turn

bool finite(std::initializer_list<double> numbers) {
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

bool finite(const PlanePoint<>& point) {
    return finite({point.x(), point.y()});
}

bool finite(const std::vector<TimedVector>& record) {
    return std::ranges::all_of(
        record, [](const TimedVector& entry) { return std::isfinite(entry.time) && finite(entry.value); });
}

bool increasing(const std::vector<TimedVector>& record) {
    const auto not_after = [](const TimedVector& entry, const TimedVector& next) { return !(next.time > entry.time); };
    return std::ranges::adjacent_find(record, not_after) == record.end();
}

bool is_friction(double angle) {
    return angle >= 0 && angle <= degrees(greatest_friction);
}

// The first item for which `check_of` is not valid.
template <class Items, class CheckOf>
SceneFault first_fault(const Items& items, const CheckOf& check_of) {
    for (std::size_t index = 0; index < items.size(); ++index) {
        const SceneCheck check = check_of(items[index]);
        if (check != SceneCheck::valid) {
            return {check, index};
        }
    }
    return {};
}

SceneCheck check_outline(const Polygon<>& outline) {
    if (!std::ranges::all_of(outline, [](const PlanePoint<>& vertex) { return finite(vertex); })) {
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

SceneCheck check_rock(const BondMaterial& rock) {
    const double spacing = rock.spacing.value_or(1);
    const bool numbers = finite(
        {rock.young_modulus, rock.shear_modulus, rock.tensile_strength, rock.cohesion, rock.friction_angle, spacing});
    const bool moduli = rock.young_modulus > 0 && rock.shear_modulus > 0 && spacing > 0;
    return !numbers                                         ? SceneCheck::number_not_finite
           : !moduli                                        ? SceneCheck::modulus_not_positive
           : rock.tensile_strength < 0 || rock.cohesion < 0 ? SceneCheck::strength_negative
           : !is_friction(rock.friction_angle)              ? SceneCheck::friction_out_of_range
                                                            : SceneCheck::valid;
}

SceneCheck check_material(const JointMaterial& joint) {
    const double residual = joint.residual_friction_angle.value_or(joint.friction_angle);
    const bool numbers = finite({joint.normal_stiffness, joint.shear_stiffness, joint.friction_angle, residual,
                                 joint.cohesion, joint.tensile_strength, joint.residual_cohesion});
    const bool frictions = is_friction(joint.friction_angle) && residual >= 0 && residual <= joint.friction_angle;
    const bool strengths =
        joint.residual_cohesion >= 0 && joint.cohesion >= joint.residual_cohesion && joint.tensile_strength >= 0;
    return !numbers                                                     ? SceneCheck::number_not_finite
           : !(joint.normal_stiffness > 0 && joint.shear_stiffness > 0) ? SceneCheck::stiffness_not_positive
           : !frictions                                                 ? SceneCheck::friction_out_of_range
           : !strengths                                                 ? SceneCheck::strength_negative
           : joint.bond                                                 ? check_rock(*joint.bond)
                                                                        : SceneCheck::valid;
}

SceneFault check_gravity(const RelaxationScene& scene) {
    const Gravity& gravity = scene.gravity;
    const bool numbers =
        finite({gravity.acceleration, gravity.tilt, gravity.final_tilt, gravity.rate, gravity.interval, gravity.start});
    const bool negative = gravity.acceleration < 0 || gravity.rate < 0 || gravity.interval < 0;
    return {!numbers ? SceneCheck::number_not_finite : negative ? SceneCheck::load_out_of_range : SceneCheck::valid};
}

SceneFault check_materials(const RelaxationScene& scene) {
    return first_fault(scene.material, check_material);
}

SceneFault check_blocks(const RelaxationScene& scene) {
    if (scene.material.empty()) {
        return {SceneCheck::unknown_material};
    }
    double longest = 0;
    double shortest = std::numeric_limits<double>::infinity();
    bool any_free = false;
    const auto unknown = [&](std::size_t material) { return material >= scene.material.size(); };
    const SceneFault fault = first_fault(scene.block, [&](const RelaxationBlock& block) {
        const SceneCheck outline = check_outline(block.outline);
        const SceneCheck check = outline != SceneCheck::valid    ? outline
                                 : !std::isfinite(block.density) ? SceneCheck::number_not_finite
                                 : !(block.density > 0)          ? SceneCheck::density_not_positive
                                 : !block.joint.empty() && block.joint.size() != block.outline.size()
                                     ? SceneCheck::unknown_edge
                                 : std::ranges::any_of(block.joint, unknown) ? SceneCheck::unknown_material
                                                                             : SceneCheck::valid;
        if (check != SceneCheck::valid) {
            return check;
        }
        any_free |= !block.fixed;
        double perimeter = 0;
        for (std::size_t vertex = 0; vertex < block.outline.size(); ++vertex) {
            const double edge = (block.outline[(vertex + 1) % block.outline.size()] - block.outline[vertex]).norm();
            shortest = std::min(shortest, edge);
            perimeter += edge;
        }
        longest = block.fixed ? longest : std::max(longest, perimeter / 2);
        return longest < longest_to_shortest_edge * shortest ? SceneCheck::valid : SceneCheck::sizes_too_different;
    });
    return fault.check != SceneCheck::valid || any_free ? fault : SceneFault{SceneCheck::no_free_block};
}

// A joint has to carry the blocks that it separates: it may be neither as soft as a cushion nor too stiff for the
// precision of numbers.
SceneFault check_stiffness(const RelaxationScene& scene) {
    return first_fault(scene.block, [&](const RelaxationBlock& block) {
        const double area = area_properties(block.outline).area;
        const double weight = block.density * area * (scene.gravity.acceleration > 0 ? scene.gravity.acceleration : 1);
        const double size = std::sqrt(area);
        for (std::size_t edge = 0; !block.fixed && edge < block.outline.size(); ++edge) {
            const JointMaterial& joint = scene.material[block.joint.empty() ? 0 : block.joint[edge]];
            const double ratio = joint.normal_stiffness * size / weight;
            if (ratio < softest || ratio > stiffest) {
                return ratio < softest ? SceneCheck::stiffness_too_soft : SceneCheck::stiffness_too_stiff;
            }
        }
        return SceneCheck::valid;
    });
}

SceneFault check_forces(const RelaxationScene& scene) {
    return first_fault(scene.force, [&](const PointForce& force) {
        return force.block >= scene.block.size()           ? SceneCheck::unknown_block
               : !finite(force.at) || !finite(force.force) ? SceneCheck::number_not_finite
                                                           : SceneCheck::valid;
    });
}

SceneFault check_bolts(const RelaxationScene& scene) {
    const SceneFault fault = first_fault(scene.bolt, [&](const BoltSegment& segment) {
        const bool numbers =
            finite(segment.at) && finite(segment.other_at) && finite({segment.stiffness, segment.capacity});
        const bool in_range =
            segment.pretension >= 0 && segment.pretension <= segment.capacity && segment.stiffness > 0;
        return std::max(segment.block, segment.other) >= scene.block.size() ? SceneCheck::bolt_outside_blocks
               : !numbers                                                   ? SceneCheck::number_not_finite
               : !in_range                                                  ? SceneCheck::load_out_of_range
                                                                            : SceneCheck::valid;
    });
    return fault.check == SceneCheck::valid ? fault : SceneFault{fault.check, scene.bolt[fault.index].bolt};
}

SceneFault check_pressures(const RelaxationScene& scene) {
    return first_fault(scene.pressure, [&](const FacePressure& pressure) {
        if (pressure.block >= scene.block.size()) {
            return SceneCheck::unknown_block;
        }
        const Polygon<>& outline = scene.block[pressure.block].outline;
        if (pressure.edge >= outline.size()) {
            return SceneCheck::unknown_edge;
        }
        const double length = (outline[(pressure.edge + 1) % outline.size()] - outline[pressure.edge]).norm();
        const EdgePart part = pressure.part.value_or(EdgePart{0, length});
        const bool on_edge = part.begin >= 0 && part.end > part.begin && part.end <= length;
        return !finite({pressure.at_first, pressure.at_second})  ? SceneCheck::number_not_finite
               : pressure.at_first < 0 || pressure.at_second < 0 ? SceneCheck::load_out_of_range
               : !finite({part.begin, part.end})                 ? SceneCheck::number_not_finite
               : !on_edge                                        ? SceneCheck::load_out_of_range
                                                                 : SceneCheck::valid;
    });
}

SceneFault check_motions(const RelaxationScene& scene) {
    return first_fault(scene.motion, [&](const PrescribedMotion& motion) {
        const bool numbers = finite(motion.velocity) && finite(motion.pivot) &&
                             finite({motion.angular_velocity, motion.start, motion.duration});
        return motion.block >= scene.block.size() ? SceneCheck::unknown_block
               : !scene.block[motion.block].fixed ? SceneCheck::motion_of_free_block
               : !numbers                         ? SceneCheck::number_not_finite
               : !increasing(motion.velocity)     ? SceneCheck::times_not_increasing
               : motion.duration < 0              ? SceneCheck::load_out_of_range
                                                  : SceneCheck::valid;
    });
}

SceneFault check_removals(const RelaxationScene& scene) {
    std::vector<char> stays(scene.block.size(), 0);
    std::ranges::transform(scene.block, stays.begin(),
                           [](const RelaxationBlock& block) { return block.fixed ? 0 : 1; });
    const SceneFault fault = first_fault(scene.removal, [&](const Removal& removal) {
        if (removal.block >= scene.block.size()) {
            return SceneCheck::unknown_block;
        }
        stays[removal.block] = 0;
        return std::isfinite(removal.time) ? SceneCheck::valid : SceneCheck::number_not_finite;
    });
    const bool left = std::ranges::count(stays, 1) > 0;
    return fault.check != SceneCheck::valid || left ? fault : SceneFault{SceneCheck::no_block_left};
}

SceneFault check_shaking(const RelaxationScene& scene) {
    return {!finite(scene.shaking)       ? SceneCheck::number_not_finite
            : !increasing(scene.shaking) ? SceneCheck::times_not_increasing
                                         : SceneCheck::valid};
}

SceneFault check_bonds(const RelaxationScene& scene) {
    if (scene.bond.empty()) {
        return {};
    }
    const Bodies bodies = make_bodies(scene);
    return first_fault(scene.bond, [&](const FaceBond& bond) {
        if (std::max(bond.block, bond.other) >= bodies.size() || bond.block == bond.other) {
            return SceneCheck::unknown_block;
        }
        const CornerRange edges = bodies.range[bond.block];
        const CornerRange other_edges = bodies.range[bond.other];
        if (bond.edge >= edges.size() || bond.other_edge >= other_edges.size()) {
            return SceneCheck::unknown_edge;
        }
        const std::size_t edge = edges.begin + bond.edge;
        const std::size_t other_edge = other_edges.begin + bond.other_edge;
        const bool both_fixed = scene.block[bond.block].fixed && scene.block[bond.other].fixed;
        return bond.of_rock && !joint_between(scene, bodies, edge, other_edge).bond ? SceneCheck::unknown_material
               : both_fixed || !shared_face(bodies, edge, other_edge)               ? SceneCheck::bond_without_face
                                                                                    : SceneCheck::valid;
    });
}

SceneFault check_belt(const RelaxationScene& scene) {
    if (!scene.belt) {
        return {};
    }
    const auto [speed, friction] = *scene.belt;
    return {!finite({speed, friction})                       ? SceneCheck::number_not_finite
            : !(friction > 0 && is_friction(friction))       ? SceneCheck::friction_out_of_range
            : !(speed > 0 && scene.gravity.acceleration > 0) ? SceneCheck::load_out_of_range
                                                             : SceneCheck::valid};
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
    // Blocks are checked first: stiffnesses that follow from their weights are wrong if those are.
    for (const auto check : {check_gravity, check_blocks, check_materials, check_stiffness, check_forces, check_bolts,
                             check_pressures, check_motions, check_removals, check_shaking, check_bonds, check_belt}) {
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
    return first_fault(scene.block, [&](const RelaxationBlock& block) {
        const auto below = [&](const PlanePoint<>& corner) { return corner.y() < *settings.taken_away_below; };
        const bool gone = settings.taken_away_below && !block.fixed && std::ranges::all_of(block.outline, below);
        return gone ? SceneCheck::setting_out_of_range : SceneCheck::valid;
    });
}

SceneFault check(const RelaxationScene& scene, const RelaxationSettings& settings) {
    SceneFault fault = check_settings(settings);
    fault = fault.check == SceneCheck::valid ? check_scene(scene) : fault;
    fault = fault.check == SceneCheck::valid ? check_departure(scene, settings) : fault;
    return fault.check == SceneCheck::valid ? check_start(scene) : fault;
}

}  // namespace delabole
