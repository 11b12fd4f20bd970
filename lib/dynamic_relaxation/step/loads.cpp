#include "dynamic_relaxation/step/loads.hpp"

#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/step/base_friction.hpp"
#include "dynamic_relaxation/step/state.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace delabole {

double tilt_at(const Gravity& gravity, double time) {
    if (gravity.rate == 0 || time <= gravity.start) {
        return gravity.tilt;
    }
    double turning = time - gravity.start;
    if (gravity.interval > 0) {
        turning = std::floor(turning / gravity.interval) * gravity.interval;
    }
    const double rotation = gravity.final_tilt - gravity.tilt;
    return gravity.tilt + std::copysign(std::min(std::abs(rotation), gravity.rate * turning), rotation);
}

PlanePoint<> gravity_at(const Gravity& gravity, double time) {
    const double tilt = tilt_at(gravity, time);
    return gravity.acceleration * PlanePoint<>(-std::sin(tilt), -std::cos(tilt));
}

namespace {

// Interpolates linearly; the last value applies to all later times.
PlanePoint<> value_at(const std::vector<TimedVector>& record, double time) {
    if (record.empty() || time < record.front().time) {
        return {0, 0};
    }
    const auto after = std::upper_bound(record.begin(), record.end(), time,
                                        [](double value, const TimedVector& entry) { return value < entry.time; });
    if (after == record.end()) {
        return record.back().value;
    }
    const TimedVector& before = *(after - 1);
    const double share = (time - before.time) / (after->time - before.time);
    return before.value + share * (after->value - before.value);
}

// Returns the parts of the pressures on an edge of this length that lie outside a part that is uncovered.
std::vector<FacePressure> outside(const EdgePart& uncovered, const std::vector<FacePressure>& pressures,
                                  double length) {
    std::vector<FacePressure> left;
    for (const FacePressure& pressure : pressures) {
        const EdgePart part = pressure.part.value_or(EdgePart{0, length});
        if (uncovered.end <= part.begin || uncovered.begin >= part.end) {
            left.push_back(pressure);
            continue;
        }
        const double slope = (pressure.at_second - pressure.at_first) / (part.end - part.begin);
        const auto keep = [&](double from, double to) {
            // A piece that exists only by rounding carries no pressure.
            if (to - from > 1e-9 * length) {
                FacePressure piece = pressure;
                piece.at_first += slope * (from - part.begin);
                piece.at_second = pressure.at_first + slope * (to - part.begin);
                piece.part = {from, to};
                left.push_back(piece);
            }
        };
        keep(part.begin, uncovered.begin);
        keep(uncovered.end, part.end);
    }
    return left;
}

}  // namespace

PlanePoint<> shaking_at(const RelaxationScene& scene, double time) {
    if (scene.shaking.size() > 1 && time > scene.shaking.back().time) {
        return {0, 0};
    }
    const PlanePoint<> value = value_at(scene.shaking, time);
    const double tilt = tilt_at(scene.gravity, time);
    return value.x() * PlanePoint<>(std::cos(tilt), -std::sin(tilt)) +
           value.y() * PlanePoint<>(std::sin(tilt), std::cos(tilt));
}

FaceForce force_of(const FacePressure& pressure, const Bodies& bodies, const Motion& motion) {
    const std::size_t edge = bodies.range[pressure.block].begin + pressure.edge;
    const EdgePart part = pressure.part.value_or(EdgePart{0, bodies.length[edge]});
    const double length = part.end - part.begin;
    const double sum = pressure.at_first + pressure.at_second;
    const double centre =
        part.begin + (sum != 0 ? length * (pressure.at_first + 2 * pressure.at_second) / (3 * sum) : 0);
    const PlanePoint<> inward = -bodies.normal(edge);
    return {motion.turned(bodies.corner[edge] + centre * bodies.along[edge]),
            motion.turned(PlanePoint<>(sum / 2 * length * inward))};
}

void prescribe(const PrescribedMotion& prescribed, const Bodies& bodies, double time, Motion& motion) {
    const PlanePoint<> velocity = value_at(prescribed.velocity, time);
    const bool turning = time >= prescribed.start && time < prescribed.start + prescribed.duration;
    motion.spin = turning ? prescribed.angular_velocity : 0;
    const PlanePoint<> arm = bodies.centroid[prescribed.block] + PlanePoint<>(motion.x, motion.y) - prescribed.pivot;
    motion.vx = velocity.x() - motion.spin * arm.y();
    motion.vy = velocity.y() + motion.spin * arm.x();
}

std::vector<FacePressure> pressures_left(const RelaxationScene& scene, const Bodies& bodies,
                                         const std::vector<char>& removed) {
    const auto is_gone = [&](std::size_t block) { return removed[block] == taken_away; };
    if (std::ranges::none_of(scene.pressure, &FacePressure::drains) ||
        std::ranges::find(removed, taken_away) == removed.end()) {
        return scene.pressure;
    }
    std::map<std::size_t, std::vector<EdgePart>> uncovered;  // of each edge
    for (const SharedFace& face : find_shared_faces(bodies)) {
        if (is_gone(face.block) != is_gone(face.other)) {
            const auto [edge, middle] =
                is_gone(face.other) ? std::pair(face.edge, face.arm) : std::pair(face.other_edge, face.other_arm);
            const double begin = bodies.along[edge].dot(middle - bodies.corner[edge]) - face.length / 2;
            uncovered[edge].push_back({begin, begin + face.length});
        }
    }
    std::vector<FacePressure> left;
    for (const FacePressure& pressure : scene.pressure) {
        const std::size_t edge = bodies.range[pressure.block].begin + pressure.edge;
        const auto found = uncovered.find(edge);
        std::vector<FacePressure> pieces{pressure};
        if (pressure.drains && found != uncovered.end()) {
            for (const EdgePart& dry : found->second) {
                pieces = outside(dry, pieces, bodies.length[edge]);
            }
        }
        left.insert(left.end(), pieces.begin(), pieces.end());
    }
    return left;
}

void sum_loads(const RelaxationScene& scene, const std::vector<FacePressure>& pressures,
               const RelaxationSettings& settings, const Bodies& bodies, double time, const std::vector<char>& held,
               const std::vector<Motion>& motion, std::vector<BlockForce>& load) {
    const double ramp =
        settings.start == RelaxationStart::ramped && time < settings.ramp_time ? time / settings.ramp_time : 1;
    const PlanePoint<> gravity = ramp * gravity_at(scene.gravity, time);
    const PlanePoint<> shaking = shaking_at(scene, time);
    const PlanePoint<> acceleration = scene.belt ? PlanePoint<>(-shaking) : PlanePoint<>(gravity - shaking);
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        load[block] = {bodies.mass[block] * acceleration.x(), bodies.mass[block] * acceleration.y(), 0};
    }
    const auto add = [&](std::size_t block, const PlanePoint<>& arm, const PlanePoint<>& force) {
        load[block].x += force.x();
        load[block].y += force.y();
        load[block].moment += arm.x() * force.y() - arm.y() * force.x();
    };
    if (scene.belt) {
        const PlanePoint<> velocity = scene.belt->speed / scene.gravity.acceleration * gravity_at(scene.gravity, time);
        for (std::size_t block = 0; block < bodies.size(); ++block) {
            if (held[block] == 0) {
                const double weight = ramp * scene.gravity.acceleration * bodies.mass[block];
                const BlockForce drag = belt_drag(*scene.belt, velocity, weight, bodies, block, motion[block]);
                load[block].x += drag.x;
                load[block].y += drag.y;
                load[block].moment += drag.moment;
            }
        }
    }
    for (const PointForce& force : scene.force) {
        add(force.block, motion[force.block].turned(force.at - bodies.centroid[force.block]), force.force);
    }
    for (const FacePressure& pressure : pressures) {
        const FaceForce force = force_of(pressure, bodies, motion[pressure.block]);
        add(pressure.block, force.arm, force.force);
    }
}

double last_scheduled_time(const RelaxationScene& scene, const RelaxationSettings& settings) {
    double last = settings.consolidation_time;
    if (settings.start == RelaxationStart::ramped) {
        last = std::max(last, settings.ramp_time);
    }
    if (scene.gravity.rate > 0) {
        last = std::max(last, scene.gravity.start +
                                  std::abs(scene.gravity.final_tilt - scene.gravity.tilt) / scene.gravity.rate +
                                  scene.gravity.interval);
    }
    if (!scene.shaking.empty()) {
        last = std::max(last, scene.shaking.back().time);
    }
    for (const PrescribedMotion& motion : scene.motion) {
        last = std::max(last, motion.start + motion.duration);
        if (!motion.velocity.empty()) {
            last = std::max(last, motion.velocity.back().time);
        }
    }
    for (const Removal& removal : scene.removal) {
        last = std::max(last, removal.time);
    }
    return last;
}

}  // namespace delabole
