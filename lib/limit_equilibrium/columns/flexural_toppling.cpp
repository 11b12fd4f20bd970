#include "limit_equilibrium/columns/flexural_toppling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace delabole {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Angles {
    double sine;
    double cosine;
    double friction;  // tangents
    double foot_friction;
};

struct Descent {
    double toe_push = 0;
    std::vector<FlexuralColumnState> column = {};
};

// Height of the force between a column and the next one; for the uppermost and the toe column, at their free faces.
double contact_above(const FlexuralSlope& slope, std::size_t index) {
    const double height = slope.column[index].height;
    const double next = index + 1 < slope.column.size() ? slope.column[index + 1].height : height;
    return slope.contact_height * std::min(height, next);
}

// A column passes these on to the next one below.
struct Passed {
    double push;
    double friction;  // on the face between them, down on the lower column
};

FlexuralColumnState column_state(const FlexuralSlope& slope, const Angles& angles, double strength, std::size_t index,
                                 Passed& passed) {
    const FlexuralColumn& column = slope.column[index];
    const double t = column.width;
    const double weight = slope.unit_weight * t * column.height;
    const double above = contact_above(slope, index);
    const double below = index > 0 ? contact_above(slope, index - 1) : slope.contact_height * column.height;
    const double m = angles.friction;
    const auto [push_above, friction_above] = passed;
    const double overturning = weight * column.height * angles.sine / 2 + push_above * above;
    const double pressing = weight * angles.cosine + friction_above;  // on the foot, without friction below
    const double bending =
        (overturning - friction_above * t / 2 - pressing * t / 6 - strength * t * t / 6) / (below + m * t / 3);
    const double toppling = (overturning - friction_above * t / 2 - pressing * t / 2) / below;
    const double torn_off = toppling - strength * t * t / (2 * below);
    const bool foot_torn = m * bending > pressing + strength * t;
    const double relief = 1 - m * angles.foot_friction;
    const double unresisted = push_above + weight * angles.sine - angles.foot_friction * pressing - slope.cohesion * t;
    // Here friction is all that the foot allows: N = -s t.
    const double torn_and_sheared =
        push_above + weight * angles.sine - slope.cohesion * t + angles.foot_friction * strength * t;
    const bool all_friction = relief > 0 && m * unresisted <= relief * (pressing + strength * t);
    const double shearing = unresisted <= 0 ? 0 : all_friction ? unresisted / relief : std::max(torn_and_sheared, 0.0);
    const double turning = std::min(foot_torn ? torn_off : bending, toppling);
    FlexuralColumnState state;
    state.push = std::max({0.0, shearing, turning});
    if (state.push > 0) {
        state.mode = state.push == shearing   ? FlexuralMode::shears
                     : state.push == toppling ? FlexuralMode::topples
                                              : FlexuralMode::bends;
    }
    const double held_down = state.mode == FlexuralMode::topples ? 0 : strength * t;
    const double friction = std::min(m * state.push, pressing + held_down);
    state.moment = overturning - friction_above * t / 2 - state.push * below - friction * t / 2;
    state.normal = pressing - friction;
    passed = {state.push, friction};
    return state;
}

Descent descend(const FlexuralSlope& slope, const Angles& angles, double strength) {
    Descent descent;
    descent.column.resize(slope.column.size());
    Passed passed{0, 0};
    for (std::size_t index = slope.column.size(); index-- > 0;) {
        descent.column[index] = column_state(slope, angles, strength, index, passed);
    }
    descent.toe_push = passed.push;
    return descent;
}

// The push does not increase with strength, and the least strength without a push lies in one bracket, but in rare
// slopes: where columns are sheared off, or contacts lie lower than friction across a column's width acts back, there
// may be more brackets, and this is one of them.
double required_strength(const FlexuralSlope& slope, const Angles& angles) {
    const auto stands = [&](double strength) { return descend(slope, angles, strength).toe_push <= 0; };
    if (stands(0)) {
        return 0;
    }
    double upper = 0;
    for (const FlexuralColumn& column : slope.column) {
        // This strength is enough for every column by itself.
        upper = std::max(upper, 3 * slope.unit_weight * column.height * column.height * angles.sine / column.width);
    }
    // Pushes from above may need more.
    constexpr int most_doublings = 10;
    for (int doublings = 0; !stands(upper); ++doublings, upper *= 2) {
        if (doublings == most_doublings) {
            return infinite;
        }
    }
    double lower = 0;
    for (;;) {
        const double middle = lower + (upper - lower) / 2;
        if (middle <= lower || middle >= upper) {
            return upper;
        }
        (stands(middle) ? upper : lower) = middle;
    }
}

}  // namespace

FlexuralStability analyse(const FlexuralSlope& slope) {
    FlexuralStability answer;
    if (slope.column.empty()) {
        return answer;
    }
    if (!in_range(slope)) {
        answer.check = FlexuralCheck::input_out_of_range;
        return answer;
    }
    answer.check = FlexuralCheck::valid;
    const Angles angles{std::sin(slope.base_dip), std::cos(slope.base_dip), std::tan(slope.joint_friction_angle),
                        std::tan(slope.friction_angle)};
    Descent descent = descend(slope, angles, slope.tensile_strength);
    answer.toe_push = descent.toe_push;
    answer.column = std::move(descent.column);
    answer.required_tensile_strength = required_strength(slope, angles);
    answer.factor_of_safety =
        answer.required_tensile_strength > 0 ? slope.tensile_strength / answer.required_tensile_strength : infinite;
    return answer;
}

ModelInterface model_interface(const FlexuralSlope& slope) {
    FlexuralStability shape;
    shape.column.resize(slope.column.size());
    return interface_of_function(slope, shape,
                                 [](const FlexuralSlope& varied) { return prediction_of(analyse(varied)); });
}

}  // namespace delabole
