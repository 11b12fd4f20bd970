#include "dynamic_relaxation/blocks/block_sweep.hpp"

#include "numerics/lanes.hpp"

#include <algorithm>
#include <cstring>

namespace delabole {

namespace {

template <class Number>
struct BlockVelocity {
    Number x;
    Number y;
    Number spin;
};

// Bodies and scales of the blocks that are swept together.
template <class Number>
struct BlockMeasures {
    Number inverse_mass;
    Number inverse_inertia;
    Number inverse_radius;
    Number inverse_weight;
};

template <class Number>
struct Imbalance {
    Number force;  // N/m
    Number ratio;  // share of the weight
};

template <class Number>
DELABOLE_INLINED Imbalance<Number> imbalance_of(const BlockForceOf<Number>& net,
                                                const BlockMeasures<Number>& measures) {
    const Number force = square_root(net.x * net.x + net.y * net.y);
    return {force, (force + absolute(net.moment) * measures.inverse_radius) * measures.inverse_weight};
}

template <class Number>
struct KickWork {
    Number applied;
    Number damped;
};

// `moving`: the velocity that local damping opposes. The work of a force over the kick is exact with the mean of the
// velocities before and after it.
template <class Number>
DELABOLE_INLINED KickWork<Number> kick(const BlockForceOf<Number>& net, const Number& force,
                                       const BlockForceOf<Number>& load, const BlockVelocity<Number>& moving,
                                       const BlockMeasures<Number>& measures, double local_damping, double duration,
                                       MotionOf<Number>& motion) {
    const Number zero{};
    BlockForceOf<Number> brake;
    if (local_damping > 0) {
        const Number speed = square_root(moving.x * moving.x + moving.y * moving.y);
        const Number share = select(speed > zero, local_damping * force / speed, zero);
        const Number turning = select(moving.spin != zero, with_sign(zero + 1.0, moving.spin), zero);
        brake.x = -share * moving.x;
        brake.y = -share * moving.y;
        brake.moment = -turning * local_damping * absolute(net.moment);
    }
    const Number vx = motion.vx + (net.x + brake.x) * measures.inverse_mass * duration;
    const Number vy = motion.vy + (net.y + brake.y) * measures.inverse_mass * duration;
    const Number spin = motion.spin + (net.moment + brake.moment) * measures.inverse_inertia * duration;
    const Number moved_x = (motion.vx + vx) * 0.5 * duration;
    const Number moved_y = (motion.vy + vy) * 0.5 * duration;
    const Number turn = (motion.spin + spin) * 0.5 * duration;
    motion.vx = vx;
    motion.vy = vy;
    motion.spin = spin;
    return {load.x * moved_x + load.y * moved_y + load.moment * turn,
            brake.x * moved_x + brake.y * moved_y + brake.moment * turn};
}

BlockForce force_of_joints(const BlockSweep& sweep, std::size_t block) {
    BlockForce force = sweep.of_contacts[block];
    if (sweep.of_bonds != nullptr) {
        force += sweep.of_bonds[block];
    }
    return force;
}

// A moving base carries its blocks along: damping acts on their motion relative to it.
BlockVelocity<double> velocity_on_base(const BlockSweep& sweep, std::size_t block) {
    const Motion& motion = sweep.motion[block];
    const Bodies& bodies = sweep.bodies;
    if (!bodies.moved_base) {
        return {motion.vx, motion.vy, motion.spin};
    }
    const std::size_t number = *bodies.moved_base;
    const Motion& base = sweep.base;
    const PlanePoint<> arm =
        bodies.centroid[block] - bodies.centroid[number] + PlanePoint<>(motion.x - base.x, motion.y - base.y);
    return {motion.vx - (base.vx - base.spin * arm.y()), motion.vy - (base.vy + base.spin * arm.x()),
            motion.spin - base.spin};
}

template <class Number>
struct PoseOf {
    Number x;
    Number y;
    Number angle;
};

// A pose that is not a number counts as noticed.
template <class Number>
DELABOLE_INLINED MaskOf<Number> is_unnoticed(const MotionOf<Number>& now, const PoseOf<Number>& then,
                                             const Number& radius, const Number& limit) {
    return absolute(now.x - then.x) + absolute(now.y - then.y) + absolute(now.angle - then.angle) * radius <= limit;
}

// Returns false for a block at rest.
bool kick_block(const BlockSweep& sweep, std::size_t block, StepSums& sums) {
    Motion& motion = sweep.motion[block];
    const BlockForce& load = sweep.load[block];
    BlockForce net = force_of_joints(sweep, block);
    net += load;
    const BlockMeasures<double> measures{sweep.bodies.inverse_mass[block], sweep.bodies.inverse_inertia[block],
                                         sweep.scales.inverse_radius[block], sweep.scales.inverse_weight[block]};
    const Imbalance<double> imbalance = imbalance_of(net, measures);
    sums.unbalanced = std::max(sums.unbalanced, imbalance.ratio);
    if (sweep.checks_at_rest[block] >= sweep.checks_before_rest) {
        if (imbalance.ratio <= 4 * sweep.rest_ratio) {
            return false;
        }
        sweep.checks_at_rest[block] = 0;
    }
    const KickWork<double> work = kick<double>(net, imbalance.force, load, velocity_on_base(sweep, block), measures,
                                               sweep.local_damping, sweep.kick, motion);
    sums.applied += work.applied;
    sums.damped -= work.damped;
    if (imbalance.ratio > sweep.rest_ratio ||
        fastest_point<double>(motion, sweep.bodies.radius[block]) > sweep.scales.rest_speed[block]) {
        sweep.checks_at_rest[block] = 0;
    }
    return true;
}

void move_block(const BlockSweep& sweep, std::size_t block, StepSums& sums) {
    Motion& motion = sweep.motion[block];
    NoticedMotion& noticed = sweep.noticed;
    noticed.moved[block] = 0;
    if (sweep.held[block] != 0) {
        const BlockForce force = force_of_joints(sweep, block);
        // A moved block exerts on the others the opposite of their forces on it.
        sums.prescribed -= (force.x * motion.vx + force.y * motion.vy + force.moment * motion.spin) * sweep.step;
    } else if (!kick_block(sweep, block, sums)) {
        return;
    }
    motion.x += motion.vx * sweep.step;
    motion.y += motion.vy * sweep.step;
    if (motion.spin != 0) {
        motion.set_angle(motion.angle + motion.spin * sweep.step);
    }
    const double radius = sweep.bodies.radius[block];
    const double fastest = fastest_point<double>(motion, radius);
    sums.fastest = std::max(sums.fastest, fastest);
    sweep.travelled[block] += fastest * sweep.step;
    const PoseOf<double> then{noticed.x[block], noticed.y[block], noticed.angle[block]};
    if (!is_unnoticed<double>(motion, then, radius, sweep.scales.unnoticed[block])) {
        noticed.notice(block, motion);
    }
}

DELABOLE_INLINED BlockForceOf<FourLanes> gather_forces(const BlockForce* first) {
    const FourOf<FourLanes> four = gather_four({&first[0].x, &first[1].x, &first[2].x, &first[3].x}, 0);
    return {four[0], four[1], four[2], four[3]};
}

// Sums over lanes.
struct WideSums {
    FourLanes unbalanced{};
    FourLanes applied{};
    FourLanes damped{};
    FourLanes fastest{};
};

DELABOLE_INLINED void notice_four(const BlockSweep& sweep, std::size_t first, const MotionOf<FourLanes>& now,
                                  const FourLanes& radius) {
    NoticedMotion& noticed = sweep.noticed;
    const PoseOf<FourLanes> then{load_lanes<FourLanes>(&noticed.x[first]), load_lanes<FourLanes>(&noticed.y[first]),
                                 load_lanes<FourLanes>(&noticed.angle[first])};
    const MaskOf<FourLanes> unnoticed =
        is_unnoticed<FourLanes>(now, then, radius, load_lanes<FourLanes>(&sweep.scales.unnoticed[first]));
    const auto moved = static_cast<std::uint32_t>(bytes_of(all_lanes<FourLanes> & ~bits(unnoticed)));
    std::memcpy(&noticed.moved[first], &moved, lane_count<FourLanes>);
    store_lanes<FourLanes>(select(unnoticed, then.x, now.x), &noticed.x[first]);
    store_lanes<FourLanes>(select(unnoticed, then.y, now.y), &noticed.y[first]);
    store_lanes<FourLanes>(select(unnoticed, then.angle, now.angle), &noticed.angle[first]);
}

// Moves four free blocks that are not at rest, on a base that does not rotate.
DELABOLE_INLINED void move_four(const BlockSweep& sweep, std::size_t first, WideSums& sums) {
    Motion* const moved = sweep.motion + first;
    const Rows<FourLanes> rows{&moved[0].x, &moved[1].x, &moved[2].x, &moved[3].x};
    const BlockForceOf<FourLanes> load = gather_forces(sweep.load + first);
    BlockForceOf<FourLanes> net = gather_forces(sweep.of_contacts + first);
    if (sweep.of_bonds != nullptr) {
        net += gather_forces(sweep.of_bonds + first);
    }
    net += load;
    const BlockMeasures<FourLanes> measures{load_lanes<FourLanes>(&sweep.bodies.inverse_mass[first]),
                                            load_lanes<FourLanes>(&sweep.bodies.inverse_inertia[first]),
                                            load_lanes<FourLanes>(&sweep.scales.inverse_radius[first]),
                                            load_lanes<FourLanes>(&sweep.scales.inverse_weight[first])};
    const Imbalance<FourLanes> imbalance = imbalance_of(net, measures);
    sums.unbalanced = greater(sums.unbalanced, imbalance.ratio);
    const FourOf<FourLanes> pose = gather_four(rows, 0);
    const FourOf<FourLanes> rest = gather_four(rows, 4);
    MotionOf<FourLanes> motion{pose[0], pose[1], pose[2], pose[3], rest[0], rest[1], rest[2], rest[3]};
    const KickWork<FourLanes> work = kick<FourLanes>(net, imbalance.force, load, {motion.vx, motion.vy, motion.spin},
                                                     measures, sweep.local_damping, sweep.kick, motion);
    sums.applied += work.applied;
    sums.damped -= work.damped;
    const FourLanes radius = load_lanes<FourLanes>(&sweep.bodies.radius[first]);
    const FourLanes fastest = fastest_point<FourLanes>(motion, radius);
    sums.fastest = greater(sums.fastest, fastest);
    const unsigned not_at_rest =
        bits((imbalance.ratio > sweep.rest_ratio) | (fastest > load_lanes<FourLanes>(&sweep.scales.rest_speed[first])));
    for (std::size_t lane = 0; lane < lane_count<FourLanes>; ++lane) {
        sweep.checks_at_rest[first + lane] = (not_at_rest >> lane & 1U) != 0 ? 0 : sweep.checks_at_rest[first + lane];
    }
    motion.x += motion.vx * sweep.step;
    motion.y += motion.vy * sweep.step;
    const MaskOf<FourLanes> turns = motion.spin != 0.0;
    motion.angle = select(turns, motion.angle + motion.spin * sweep.step, motion.angle);
    FourLanes sine;
    FourLanes versine;
    const unsigned large = bits(turns) & ~bits(small_turn(motion.angle, sine, versine));
    const FourOf<FourLanes> poses = transposed<FourLanes>(motion.x, motion.y, select(turns, sine, motion.sine),
                                                          select(turns, versine, motion.versine));
    const FourOf<FourLanes> rests = transposed<FourLanes>(motion.vx, motion.vy, motion.spin, motion.angle);
    for (std::size_t lane = 0; lane < lane_count<FourLanes>; ++lane) {
        store_row<FourLanes>(poses, lane, &moved[lane].x);
        store_row<FourLanes>(rests, lane, &moved[lane].vx);
    }
    for (std::size_t lane = 0; large >> lane != 0; ++lane) {
        if ((large >> lane & 1U) != 0) {
            moved[lane].set_angle(motion.angle[lane]);
        }
    }
    double* const travelled = sweep.travelled + first;
    store_lanes<FourLanes>(load_lanes<FourLanes>(travelled) + fastest * sweep.step, travelled);
    notice_four(sweep, first, motion, radius);
}

DELABOLE_INLINED bool together(const BlockSweep& sweep, std::size_t first) {
    bool free = true;
    for (std::size_t block = first; block < first + lane_count<FourLanes>; ++block) {
        free = free && sweep.held[block] == 0 && sweep.checks_at_rest[block] < sweep.checks_before_rest;
    }
    return free;
}

}  // namespace

DELABOLE_FOR_EACH_PROCESSOR
StepSums move_blocks(const BlockSweep& sweep, std::size_t begin, std::size_t end) {
    StepSums sums;
    WideSums wide;
    std::size_t block = begin;
    while (block < end) {
        if (!sweep.bodies.moved_base && block + lane_count<FourLanes> <= end && together(sweep, block)) {
            move_four(sweep, block, wide);
            block += lane_count<FourLanes>;
        } else {
            move_block(sweep, block, sums);
            ++block;
        }
    }
    for (std::size_t lane = 0; lane < lane_count<FourLanes>; ++lane) {
        sums.unbalanced = std::max(sums.unbalanced, wide.unbalanced[lane]);
        sums.applied += wide.applied[lane];
        sums.damped += wide.damped[lane];
        sums.fastest = std::max(sums.fastest, wide.fastest[lane]);
    }
    return sums;
}

}  // namespace delabole
