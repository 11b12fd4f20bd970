#include "limit_equilibrium/block_row/single_block.hpp"

#include "numerics/constants.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

// A quantity sine * sin(i) + cosine * cos(i) of the inclination i.
struct Swing {
    double sine = 0;
    double cosine = 0;
    double at(double inclination) const { return sine * std::sin(inclination) + cosine * std::cos(inclination); }
};

Swing operator+(const Swing& left, const Swing& right) {
    return {left.sine + right.sine, left.cosine + right.cosine};
}
Swing operator*(double factor, const Swing& swing) {
    return {factor * swing.sine, factor * swing.cosine};
}

// All loads on the block, as functions of the inclination.
struct Loads {
    double weight = 0;
    Swing down_dip;     // D
    Swing into_base;    // N
    Swing overturning;  // moment about the toe, positive forward
    Swing restoring;
};

// Force of water of the given depth on a face, whose resultant is at a third of the depth, divided by cos(i).
double face_force(double unit_weight, double depth) {
    return unit_weight * depth * depth / 2;
}

Loads loads_on(const SingleBlock& problem) {
    const double height = problem.block.height;
    const double width = problem.block.width;
    Loads loads;
    loads.weight = problem.block.unit_weight * height * width;
    const double horizontal = problem.seismic ? problem.seismic->horizontal_coefficient : 0.0;
    const double vertical = problem.seismic ? 1 + problem.seismic->vertical_coefficient : 1.0;
    const Swing tangential = loads.weight * Swing{vertical, horizontal};
    const Swing normal = loads.weight * Swing{-horizontal, vertical};
    loads.down_dip = tangential;
    loads.into_base = normal;
    loads.overturning = height / 2 * tangential;
    loads.restoring = width / 2 * normal;
    if (problem.water) {
        const BlockWater& water = *problem.water;
        const double behind = water.depth_behind;
        const double front = water.depth_in_front.value_or(0.0);
        const double force_behind = face_force(water.unit_weight, behind);
        const double force_front = face_force(water.unit_weight, front);
        const double uplift = water.unit_weight * (behind + front) / 2 * width;
        const double uplift_moment = water.unit_weight * (front / 6 + behind / 3) * width * width;
        loads.down_dip = loads.down_dip + Swing{0, force_behind - force_front};
        loads.into_base = loads.into_base + Swing{0, -uplift};
        loads.overturning = loads.overturning + Swing{0, force_behind * behind / 3 + uplift_moment};
        loads.restoring = loads.restoring + Swing{0, force_front * front / 3};
    }
    return loads;
}

// The first inclination in [0, 90 deg] at which `excess` exceeds `resistance` >= 0; 90 deg if it never does.
double first_excess(const Swing& excess, double resistance) {
    if (excess.cosine >= resistance) {
        return 0;
    }
    const double amplitude = std::hypot(excess.sine, excess.cosine);
    if (amplitude <= resistance || excess.sine <= 0) {
        return right_angle;
    }
    const double inclination = std::asin(resistance / amplitude) - std::atan2(excess.cosine, excess.sine);
    return std::clamp(inclination, 0.0, right_angle);
}

struct Onset {
    BlockMotion mode;
    double toe_acceleration;      // down-dip, g
    double angular_acceleration;  // g / m
};

// The block is of mass 1 / g times its weight: forces over the weight are accelerations in g.
class RigidBlock {
  public:
    RigidBlock(const SingleBlock& problem, double down_dip, double into_base, double moment, double weight)
        : height_(problem.block.height),
          width_(problem.block.width),
          friction_(std::tan(problem.base.friction_angle)),
          cohesive_(problem.base.cohesion * problem.block.width / weight),
          down_dip_(down_dip / weight),
          into_base_(into_base / weight),
          moment_(moment / weight) {}

    Onset onset() const {
        if (into_base_ < 0) {
            return {BlockMotion::lifts_off, 0, 0};
        }
        const double strength = friction_ * into_base_ + cohesive_;
        const bool holds = std::abs(down_dip_) <= strength;
        const double acceleration = holds ? 0 : down_dip_ - std::copysign(strength, down_dip_);
        // A translating block needs the moment of its own acceleration about the toe.
        const double moment = moment_ - acceleration * height_ / 2;
        if (moment <= 0 && -moment <= into_base_ * width_) {
            return {holds ? BlockMotion::stable : BlockMotion::slides, acceleration, 0};
        }
        return turning(moment <= 0);
    }

  private:
    // Rotation forward about the toe or backward about the heel; moments and rotations are positive in that sense.
    Onset turning(bool backward) const {
        const double sense = backward ? -1 : 1;
        const double moment = backward ? -moment_ - into_base_ * width_ : moment_;
        const double inertia = (height_ * height_ + width_ * width_) / 3;
        // Reactions of a block that rotates about an edge which does not slip.
        const double turn = moment / inertia;
        const double shear = down_dip_ - sense * turn * height_ / 2;
        const double reaction = into_base_ + turn * width_ / 2;
        if (turn > 0 && std::abs(shear) <= friction_ * reaction) {
            return {BlockMotion::topples, 0, sense * turn};
        }
        return slipping(sense, moment, inertia, std::copysign(1.0, turn > 0 ? shear : down_dip_));
    }

    // The edge slips with acceleration s down-dip while the block rotates with w:
    //     moment = inertia w + sense s height / 2
    //     slip mu R = down_dip - s - sense w height / 2,   R = into_base + w width / 2
    Onset slipping(double sense, double moment, double inertia, double slip) const {
        const double mu = slip * friction_;
        const double arm = sense * height_ / 2;
        // From s = down_dip - mu into_base - w (mu width / 2 + arm), substituted in the first equation.
        const double unloaded = down_dip_ - mu * into_base_;
        const double lever = mu * width_ / 2 + arm;
        const double turn = (moment - arm * unloaded) / (inertia - arm * lever);
        const double acceleration = unloaded - turn * lever;
        const double reaction = into_base_ + turn * width_ / 2;
        if (reaction < 0) {
            return {BlockMotion::lifts_off, 0, 0};
        }
        if (turn <= 0) {
            // Cohesion is lost when the base opens, and the block then slides without rotating.
            return {BlockMotion::slides, unloaded, 0};
        }
        return {BlockMotion::slides_and_topples, acceleration, sense * turn};
    }

    double height_;
    double width_;
    double friction_;
    double cohesive_;
    double down_dip_;
    double into_base_;
    double moment_;
};

BlockMotion static_mode_of(const SingleBlockResult& result) {
    if (result.normal_force < 0) {
        return BlockMotion::lifts_off;
    }
    const bool slides = result.factor_of_safety < 1;
    const bool topples = result.overturning_factor < 1;
    if (slides && topples) {
        return BlockMotion::slides_and_topples;
    }
    if (slides) {
        return BlockMotion::slides;
    }
    return topples ? BlockMotion::topples : BlockMotion::stable;
}

SingleBlockCheck check_input(const SingleBlock& problem) {
    if (!in_range(problem)) {
        return SingleBlockCheck::input_out_of_range;
    }
    const bool above = problem.water && std::max(problem.water->depth_behind,
                                                 problem.water->depth_in_front.value_or(0.0)) > problem.block.height;
    return above ? SingleBlockCheck::water_above_block : SingleBlockCheck::valid;
}

double ratio(double resisting, double driving) {
    return driving > 0 ? std::max(resisting, 0.0) / driving : infinity;
}

// Nothing holds a block that its base would have to pull.
double factor(const SingleBlockResult& result, double resisting, double driving) {
    return result.normal_force < 0 ? 0 : ratio(resisting, driving);
}

}  // namespace

SingleBlockResult analyse(const SingleBlock& problem) {
    SingleBlockResult result;
    result.check = check_input(problem);
    if (result.check != SingleBlockCheck::valid) {
        return result;
    }
    const Loads loads = loads_on(problem);
    const double inclination = problem.base.inclination;
    const double friction = std::tan(problem.base.friction_angle);
    const double cohesive = problem.base.cohesion * problem.block.width;
    result.weight = loads.weight;
    result.driving_force = loads.down_dip.at(inclination);
    result.normal_force = loads.into_base.at(inclination);
    result.factor_of_safety = factor(result, cohesive + friction * result.normal_force, result.driving_force);
    const double overturning = loads.overturning.at(inclination);
    const double restoring = loads.restoring.at(inclination);
    result.overturning_factor = factor(result, restoring, overturning);
    result.critical_sliding_inclination = first_excess(loads.down_dip + -friction * loads.into_base, cohesive);
    result.critical_toppling_inclination = first_excess(loads.overturning + -1 * loads.restoring, 0);
    result.reaction_position = result.normal_force > 0
                                   ? (restoring - overturning) / (result.normal_force * problem.block.width)
                                   : std::copysign(infinity, restoring - overturning);
    result.static_mode = static_mode_of(result);
    const Onset onset =
        RigidBlock(problem, result.driving_force, result.normal_force, overturning - restoring, loads.weight).onset();
    result.onset_mode = onset.mode;
    result.toe_acceleration = onset.toe_acceleration;
    result.angular_acceleration = onset.angular_acceleration * problem.block.height;
    return result;
}

double toe_slip_friction_angle(double inclination, double slenderness_angle) {
    const double beyond = std::sin(inclination - slenderness_angle);
    return std::atan2(4 * std::sin(inclination) - 3 * std::cos(slenderness_angle) * beyond,
                      4 * std::cos(inclination) + 3 * std::sin(slenderness_angle) * beyond);
}

ModelInterface model_interface(const SingleBlock& problem) {
    return interface_of_function(problem, SingleBlockResult{},
                                 [](const SingleBlock& varied) { return prediction_of(analyse(varied)); });
}

}  // namespace delabole
