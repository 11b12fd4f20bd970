#include "limit_equilibrium/stepped_base/stepped_base.hpp"

#include "limit_equilibrium/columns/base_profile.hpp"
#include "numerics/constants.hpp"
#include "numerics/edge_of_sign.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

// Range of the logarithm: 11 decades in each direction and one further step. On level bases the driving force is
// rounding alone, the cosine of 90 deg being 6e-17: they must hold at any strength.
constexpr double widest_search = 25;

// Searches outwards from zero, to the side on which the sign can change. Under water, and with a heavy wedge, slopes
// may stand over several separate ranges of strength: steps of 5 % find the one nearest to the given strength; beyond a
// factor of 50 the steps grow.
template <class Function>
SignBracket bracket_from_zero(const Function& function, double direction) {
    double near = 0;
    double at_near = function(near);
    for (double step = 0.05; std::abs(near) < widest_search; step *= std::abs(near) < 4 ? 1 : 2) {
        const double far = near + direction * step;
        const double at_far = function(far);
        if ((at_near > 0) != (at_far > 0)) {
            return near < far ? SignBracket{near, far, at_near, at_far, true}
                              : SignBracket{far, near, at_far, at_near, true};
        }
        near = far;
        at_near = at_far;
    }
    return {};
}

// Limit at which a margin that is negative for strong slopes changes sign; `weakening` is the direction of decreasing
// strength.
template <class Margin>
Limit solve(Margin margin, double weakening) {
    int evaluations = 0;
    auto counted = [&](double logarithm) {
        ++evaluations;
        return margin(logarithm);
    };
    const bool stands = !(counted(0) > 0);
    const SignBracket bracket = bracket_from_zero(counted, stands ? weakening : -weakening);
    if (!bracket.found) {
        return {stands ? LimitState::holds_at_any_strength : LimitState::fails_at_any_strength, 0, evaluations};
    }
    const double logarithm = edge_in(counted, bracket);
    return {LimitState::found, std::exp(logarithm), evaluations};  // or abrupt, which the caller determines
}

double margin_at(const ColumnSlope<>& slope, const ColumnStrength<>& strength, double factor) {
    return failure_margin(slope, toe_balance(slope, strength.reduced_by(factor), head_force(slope, strength, factor)));
}

// Whether the toe column is just in balance, or stands with a reserve. The relative error of the forces on it is some
// 1e-12; the reserve of random slopes is either much less than `share` or, past the pole, much more.
LimitState state_at(const ColumnSlope<>& slope, const ColumnStrength<>& strength, const JointForce<>& head) {
    constexpr double share = 1e-6;
    double thrust = head.normal;
    const ToeBalance<> toe = descend(
        slope, strength, head,
        [&](std::size_t, const Column<>&, const JointForce<>&, double, double, double lower) { thrust = lower; });
    const Column<>& first = slope.columns.front();
    const double forces = thrust + std::abs(first.down_dip_force) + std::abs(first.normal_force) +
                          std::abs(first.overturning_moment) / toe_lever(first) + strength.base_cohesion * first.width;
    return std::abs(failure_margin(slope, toe)) <= share * forces ? LimitState::found : LimitState::abrupt;
}

Point in_section(double base_dip, double u, double v) {
    return {u * std::cos(base_dip) - v * std::sin(base_dip), u * std::sin(base_dip) + v * std::cos(base_dip)};
}

// Beginning of the base above a column: the toe corner of the next one, or where that would be.
Point corner_above(const ColumnSlope<>& slope, std::size_t index) {
    const Column<>& column = slope.columns[index];
    const double u = column.base_u + column.width;
    if (index + 1 < slope.columns.size()) {
        return in_section(slope.base_dip, u, slope.columns[index + 1].base_v);
    }
    return in_section(slope.base_dip, u, slope.end_v.value_or(column.base_v));
}

void add_cable(Column<>& column, double base_dip, double plunge, double height, double force) {
    column.down_dip_force -= force * std::cos(plunge + base_dip);
    column.normal_force += force * std::sin(plunge + base_dip);
    column.overturning_moment -= force * height * std::cos(plunge + base_dip);
}

// In both balances of the toe column the cable's force enters linearly.
CableForce cable_in_toe(const ToeBalance<>& toe, const ColumnStrength<>& strength, double inclination, double height) {
    if (!(toe.overturning_moment < infinity)) {
        return {CableState::cannot_hold, 0};
    }
    const double lever = height * std::cos(inclination);
    const double grip = std::cos(inclination) + strength.base_friction * std::sin(inclination);
    const auto least = [](double demand, double effect) {
        return demand > 0 ? (effect > 0 ? demand / effect : infinity) : 0.0;
    };
    const double force = std::max(least(toe.overturning_moment, lever), least(toe.unresisted_force, grip));
    if (force == 0) {
        return {CableState::not_needed, 0};
    }
    // A steep cable that holds the column in one balance may use up its reserve in the other.
    const auto is_met = [&](double demand, double effect) {
        constexpr double rounding = 1e-12;
        return demand - force * effect <= rounding * std::abs(demand);
    };
    return force < infinity && is_met(toe.overturning_moment, lever) && is_met(toe.unresisted_force, grip)
               ? CableForce{CableState::found, force}
               : CableForce{CableState::cannot_hold, 0};
}

}  // namespace

ColumnStrength<> strength_of(const SteppedBase<>& problem) {
    return {std::tan(problem.joints.friction_angle), std::tan(problem.bases.friction_angle), problem.bases.cohesion};
}

JointForce<> head_force(const ColumnSlope<>& slope, const ColumnStrength<>& strength, double factor) {
    if (!slope.slide_head) {
        return {0, 0, 0};
    }
    const SlideHeadThrust<> thrust =
        slide_head_thrust(*slope.slide_head, slope.base_dip, strength.joint_friction, factor);
    return {thrust.force, thrust.shear, thrust.height};
}

Limit factor_of_safety(const ColumnSlope<>& slope, const ColumnStrength<>& strength) {
    Limit limit = solve([&](double logarithm) { return margin_at(slope, strength, std::exp(logarithm)); }, 1);
    if (limit.state == LimitState::holds_at_any_strength) {
        limit.value = infinity;
    } else if (limit.state == LimitState::found) {
        limit.state = state_at(slope, strength.reduced_by(limit.value), head_force(slope, strength, limit.value));
    }
    return limit;
}

Limit limiting_friction_angle(const ColumnSlope<>& slope, double base_cohesion) {
    ColumnSlope<> varied{slope.check, slope.base_dip, {}, slope.slide_head};
    const auto head_at = [&](double friction) {
        if (!varied.slide_head) {
            return JointForce<>{0, 0, 0};
        }
        varied.slide_head->friction_angle = std::atan(friction);
        return head_force(varied, {friction, friction, base_cohesion}, 1);
    };
    const auto margin = [&](double logarithm) {
        const double friction = std::exp(logarithm);
        const ColumnStrength<> strength{friction, friction, base_cohesion};
        return failure_margin(slope, toe_balance(slope, strength, head_at(friction)));
    };
    Limit limit = solve(margin, -1);
    if (limit.state == LimitState::found) {
        const double friction = limit.value;
        limit.state = state_at(slope, {friction, friction, base_cohesion}, head_at(friction));
        limit.value = std::atan(friction);
    } else {
        limit.value = limit.state == LimitState::fails_at_any_strength ? degrees(90) : 0;
    }
    return limit;
}

double toe_force(const ColumnSlope<>& slope, const ColumnStrength<>& strength, double factor) {
    const ToeBalance<> toe = toe_balance(slope, strength.reduced_by(factor), head_force(slope, strength, factor));
    const double against_toppling = toe.overturning_moment / toe_lever(slope.columns.front());
    double against_sliding = toe.unresisted_force;
    if (toe.push_effect > 0) {
        against_sliding /= toe.push_effect;
    } else if (toe.unresisted_force > 0) {
        against_sliding = infinity;
    }
    return std::max(against_toppling, against_sliding);
}

CableForce required_cable(const SteppedBase<>& problem, const RequiredCable<>& cable) {
    // The head of the cable must be found as that of a bolt is.
    ColumnScene<> bolted = problem.scene;
    bolted.bolt.push_back({cable.block, 0, cable.plunge, cable.height});
    ColumnSlope<> slope = make_columns(bolted);
    if (slope.check != ColumnCheck::valid) {
        return {CableState::no_such_place, 0};
    }
    const auto index = static_cast<std::size_t>(cable.block) - 1;
    const Column<> column = slope.columns[index];
    const ColumnStrength<> strength = strength_of(problem);
    const double factor = cable.factor_of_safety;
    if (index == 0) {
        const ColumnStrength<> reduced = strength.reduced_by(factor);
        return cable_in_toe(toe_balance(slope, reduced, head_force(slope, strength, factor)), reduced,
                            cable.plunge + slope.base_dip, cable.height);
    }
    auto margin = [&](double force) {
        slope.columns[index] = column;
        add_cable(slope.columns[index], slope.base_dip, cable.plunge, cable.height, force);
        return margin_at(slope, strength, factor);
    };
    if (!(margin(0) > 0)) {
        return {CableState::not_needed, 0};
    }
    double total = 0;
    for (const Column<>& each : slope.columns) {
        total += each.weight;
    }
    SignBracket bracket{0, total, margin(0), margin(total), false};
    for (int count_of_steps = 0; bracket.at_upper > 0; ++count_of_steps) {
        if (count_of_steps == 20) {
            return {CableState::cannot_hold, 0};
        }
        bracket.lower = bracket.upper;
        bracket.at_lower = bracket.at_upper;
        bracket.upper *= 2;
        bracket.at_upper = margin(bracket.upper);
    }
    return {CableState::found, edge_in(margin, bracket)};
}

std::vector<ColumnResult> column_results(const ColumnSlope<>& slope, const ColumnStrength<>& strength, double factor) {
    const ColumnStrength<> reduced = strength.reduced_by(factor);
    std::vector<ColumnResult> results(slope.columns.size());
    for (std::size_t index = 0; index < results.size(); ++index) {
        const Column<>& column = slope.columns[index];
        results[index].number = static_cast<int>(index) + 1;
        results[index].width = column.width;
        results[index].height = column.height;
        results[index].weight = column.weight;
    }
    // The product would be undefined for an unbounded push on a frictionless joint.
    const auto friction_of = [&](double push) {
        return reduced.joint_friction > 0 ? reduced.joint_friction * push : 0;
    };
    const auto record = [&](std::size_t index, const Column<>& column, const JointForce<>& upper, double toppling,
                            double sliding, double lower) {
        ColumnResult& result = results[index];
        result.upper_force = upper.normal;
        result.upper_force_height = upper.height;
        result.against_toppling = toppling;
        result.against_sliding = sliding;
        result.mode = !(lower > 0) ? ColumnMode::stays : toppling >= sliding ? ColumnMode::topples : ColumnMode::slides;
        result.lower_force = lower;
        result.lower_force_height = column.lower_contact;
        // The joint below carries load only if the column moves.
        result.normal_reaction = column.normal_force + upper.shear - friction_of(lower);
        result.shear_reaction = column.down_dip_force + upper.normal - lower;
        // Beside an unbounded push all other loads vanish: the values are then per newton of it.
        const bool bounded = std::isfinite(upper.normal);
        const double normal = bounded ? result.normal_reaction : reduced.joint_friction;
        const double shear = bounded ? result.shear_reaction : 1;
        const double moment = bounded ? column.overturning_moment + upper.normal * upper.height -
                                            upper.shear * column.width - lower * result.lower_force_height
                                      : upper.height - reduced.joint_friction * column.width;
        result.friction_ratio = normal > 0 ? shear / normal : infinity;
        const bool unloaded = normal == 0 && moment == 0;  // a column of zero height
        result.reaction_position = result.mode == ColumnMode::topples || unloaded ? 0
                                   : normal > 0                                   ? -moment / (normal * column.width)
                                                                                  : infinity;
        // The moments of a column that just topples balance to rounding.
        constexpr double rounding = 1e-9;
        result.reaction_inside_base = result.reaction_position >= -rounding && result.reaction_position <= 1 + rounding;
        const double unresolved = bounded ? rounding * (std::abs(column.normal_force) + std::abs(lower)) : rounding;
        const double cohesion = bounded ? reduced.base_cohesion * column.width : 0;
        result.base_friction_holds =
            normal >= -unresolved && std::abs(shear) <= reduced.base_friction * normal + cohesion + unresolved;
    };
    const JointForce<> head = head_force(slope, strength, factor);
    JointForce<> upper = head;
    const ToeBalance<> toe = descend(slope, reduced, head,
                                     [&](std::size_t index, const Column<>& column, const JointForce<>& force,
                                         double toppling, double sliding, double lower) {
                                         record(index, column, force, toppling, sliding, lower);
                                         upper = {lower, friction_of(lower), slope.columns[index - 1].upper_contact};
                                     });
    // The toe column has no neighbour to lean on: it moves if it would need a force.
    const Column<>& first = slope.columns.front();
    const double toppling = toe.overturning_moment / toe_lever(first);
    record(0, first, upper, toppling, toe.unresisted_force, 0);
    const bool topples = toppling >= toe.unresisted_force;
    const double threshold = -1e-9 * (std::abs(first.normal_force) + std::abs(upper.normal));
    if (std::max(toppling, toe.unresisted_force) > threshold) {
        results.front().mode = topples ? ColumnMode::topples : ColumnMode::slides;
    }
    return results;
}

namespace {

double unit_weight_of(const ColumnScene<>& scene, std::size_t index) {
    const auto* blocks = std::get_if<BlockColumns<>>(&scene.columns);
    return blocks ? blocks->block[index].unit_weight.value_or(scene.rock.unit_weight) : scene.rock.unit_weight;
}

// Finds the shares of the slope, by weight, that move in a limiting state, and where the crest cracks.
void add_movement(const ColumnScene<>& scene, const std::vector<ColumnResult>& columns, double wedge_weight,
                  SteppedBaseResult& result) {
    double topples = 0;
    double slides = 0;
    for (const ColumnResult& column : columns) {
        topples += column.mode == ColumnMode::topples ? column.weight : 0;
        slides += column.mode == ColumnMode::slides ? column.weight : 0;
    }
    result.moving_count = result.toppling_count + result.sliding_count;
    const double moving = topples + slides + wedge_weight;
    if (moving > 0) {
        result.moving_area = wedge_weight / scene.rock.unit_weight;
        for (std::size_t index = 0; index < columns.size(); ++index) {
            result.moving_area +=
                columns[index].mode != ColumnMode::stays ? columns[index].weight / unit_weight_of(scene, index) : 0;
        }
        result.toppling_share = topples / moving;
        result.sliding_share = slides / moving;
        result.slide_head_share = wedge_weight / moving;
    }
    const std::vector<Point> outcrops = joint_outcrops(scene);
    if (outcrops.empty()) {
        return;
    }
    const double crest = scene.slope->height / std::tan(scene.slope->face_dip);
    const auto parts = [&](std::size_t index) {
        if (index >= columns.size()) {
            return wedge_weight > 0;
        }
        const ColumnMode mode = columns[index].mode;
        if (index + 1 < columns.size()) {
            // Columns that slide move together, as their bases are parallel; columns that topple slip past each other.
            return mode != columns[index + 1].mode || mode == ColumnMode::topples;
        }
        return mode != ColumnMode::stays || wedge_weight > 0;
    };
    for (std::size_t index = 0; index < outcrops.size(); ++index) {
        result.crest_cracks += outcrops[index].x() > crest && parts(index) ? 1 : 0;
    }
}

}  // namespace

SteppedBaseResult analyse(const SteppedBase<>& problem) {
    SteppedBaseResult result;
    if (!in_range(problem)) {
        result.check = ColumnCheck::input_out_of_range;
        return result;
    }
    const ColumnSlope<> slope = make_columns(problem.scene);
    result.check = slope.check;
    if (slope.check != ColumnCheck::valid) {
        return result;
    }
    const ColumnStrength<> strength = strength_of(problem);
    const Limit limit = factor_of_safety(slope, strength);
    result.limit = limit.state;
    result.factor_of_safety = limit.value;
    const Limit friction = limiting_friction_angle(slope, strength.base_cohesion);
    result.friction_limit = friction.state;
    result.limiting_friction_angle = friction.value;
    result.toe_force = toe_force(slope, strength);
    result.column_count = static_cast<double>(slope.columns.size());
    const double at_limit = limit.state == LimitState::found ? limit.value : 1;
    const std::vector<ColumnResult> columns = column_results(slope, strength, at_limit);
    for (std::size_t index = 0; index < columns.size(); ++index) {
        result.weight += columns[index].weight;
        result.toppling_count += columns[index].mode == ColumnMode::topples ? 1 : 0;
        result.sliding_count += columns[index].mode == ColumnMode::slides ? 1 : 0;
        result.inadmissible_count += columns[index].base_friction_holds && columns[index].reaction_inside_base ? 0 : 1;
        result.uppermost_moving =
            columns[index].mode != ColumnMode::stays ? static_cast<double>(index + 1) : result.uppermost_moving;
    }
    const Point crack = corner_above(slope, static_cast<std::size_t>(std::max(1.0, result.uppermost_moving)) - 1);
    result.crack_base_distance = crack.x();
    result.crack_base_height = crack.y();
    const Point end = corner_above(slope, slope.columns.size() - 1);
    result.base_end_height = end.y();
    result.base_inclination = std::visit(
        [&](const auto& layout) {
            if constexpr (requires { layout.base_inclination; }) {
                return layout.base_inclination;
            } else {
                return std::atan2(end.y(), end.x());
            }
        },
        problem.scene.columns);
    const double moving_wedge =
        slope.slide_head && head_force(slope, strength, at_limit).normal > 0 ? slope.slide_head->weight : 0;
    add_movement(problem.scene, columns, moving_wedge, result);
    if (slope.slide_head) {
        const SlideHeadThrust<> thrust =
            slide_head_thrust(*slope.slide_head, slope.base_dip, strength.joint_friction, 1.0);
        result.slide_head = thrust.state;
        result.slide_head_thrust = thrust.force;
        result.slide_head_factor_of_safety = thrust.own_factor_of_safety;
    }
    return result;
}

}  // namespace delabole
