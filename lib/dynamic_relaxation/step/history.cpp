#include "dynamic_relaxation/step/history.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"

#include <algorithm>
#include <utility>

namespace delabole {

namespace {

// The linear stress on the bond's face is shared between the face's ends.
void add_forces(const Bond& bond, const Bodies& bodies, const std::vector<Motion>& motion,
                std::vector<CornerForce>& forces) {
    const SharedFace& face = bond.face;
    const FacePosition at = locate(face, motion[face.block], motion[face.other]);
    const PlanePoint<> along(at.along_x(), at.along_y());
    const PlanePoint<> normal(at.normal_x, at.normal_y);
    const PlanePoint<> middle =
        bodies.centroid[face.block] + PlanePoint<>(motion[face.block].x + at.arm_x, motion[face.block].y + at.arm_y);
    const double shear = -bond.shear_stiffness * at.slide / 2;
    for (const double end : {-0.5, 0.5}) {
        const double pressing =
            -bond.normal_stiffness * at.opening / 2 + 2 * end * bond.bending_stiffness * at.turn / face.length;
        forces.push_back({face.block, face.other, middle + end * face.length * along, pressing * normal + shear * along,
                          pressing, shear, 2 * end * at.turn * face.length / 2 - at.opening, false});
    }
}

}  // namespace

std::vector<CornerForce> corner_forces(const std::vector<Bond>& bonds, const Bodies& bodies,
                                       const RelaxationState& state) {
    std::vector<CornerForce> forces;
    for (std::size_t index = 0; index < bonds.size(); ++index) {
        if (state.bond[index].state == BondState::whole) {
            add_forces(bonds[index], bodies, state.motion, forces);
        }
    }
    for (std::size_t index = 0; index < state.contacts.contact.size(); ++index) {
        const auto [contact, law, memory, at] = contact_now(state.contacts, index, state.motion);
        const double weight = contact_weight(law, contact, at, memory.insists);
        if (!memory.touching || !(weight > 0)) {
            continue;
        }
        const double normal = -weight * law.normal_stiffness * at.gap;
        const double shear = -weight * law.shear_stiffness * memory.shear;
        forces.push_back(
            {contact.block, contact.other, moved_corner(bodies, state.motion, contact.corner),
             PlanePoint<>(at.normal_x * normal + at.along_x() * shear, at.normal_y * normal + at.along_y() * shear),
             normal, shear, -at.gap, memory.sliding});
    }
    return forces;
}

namespace {

MotionFrame frame_of(const Simulation& simulation, FrameParts parts) {
    const RelaxationState& state = simulation.state();
    return {state.time,
            simulation.tilt(),
            state.motion,
            simulation.block_outcomes(),
            bolt_pulls(simulation.scene(), simulation.bodies(), state),
            parts == FrameParts::all ? corner_forces(simulation.bonds(), simulation.bodies(), state)
                                     : std::vector<CornerForce>{}};
}

// The result is even. Frames of motion alone have the same limit for a scene of any size.
std::size_t most_frames(std::size_t blocks, FrameParts parts) {
    constexpr std::size_t most = 120;
    constexpr std::size_t block_frames = 1'200'000;
    return parts == FrameParts::all ? most : std::clamp<std::size_t>(block_frames / blocks / 2 * 2, 8, most);
}

}  // namespace

void MotionRecord::record(const Simulation& simulation, FrameParts parts) {
    const RelaxationState& state = simulation.state();
    if (state.time < next) {
        return;
    }
    constexpr double first_interval_in_steps = 20;
    interval = interval > 0 ? interval : first_interval_in_steps * state.step;
    if (frame.size() == most_frames(state.motion.size(), parts)) {
        std::vector<MotionFrame> kept;
        for (std::size_t index = 0; index < frame.size(); index += 2) {
            kept.push_back(std::move(frame[index]));
        }
        frame = std::move(kept);
        interval *= 2;
    }
    frame.push_back(frame_of(simulation, parts));
    next = state.time + interval;
}

void MotionRecord::add_last(const Simulation& simulation) {
    if (frame.empty() || frame.back().time < simulation.state().time) {
        frame.push_back(frame_of(simulation, FrameParts::all));
    }
}

HistoryLine history_line(const HistoryRequest& request, const Simulation& simulation) {
    const RelaxationState& state = simulation.state();
    HistoryLine line;
    line.time = state.time;
    line.tilt = simulation.tilt();
    line.energy = simulation.energy_balance();
    for (const BlockMonitor& monitor : request.block) {
        const auto block = static_cast<std::size_t>(monitor.block) - 1;
        const Motion& motion = state.motion[block];
        const Motion& origin = state.origin[block];
        line.block.push_back(
            {motion.x - origin.x, motion.y - origin.y, motion.angle - origin.angle, motion.vx, motion.vy, motion.spin});
    }
    if (!request.contact.empty()) {
        const std::vector<CornerForce> forces = corner_forces(simulation.bonds(), simulation.bodies(), state);
        for (const ContactMonitor& monitor : request.contact) {
            const auto block = static_cast<std::size_t>(monitor.block) - 1;
            const auto other = static_cast<std::size_t>(monitor.other) - 1;
            MonitoredContact sum;
            for (const CornerForce& force : forces) {
                const bool as_listed = force.block == block && force.other == other;
                if (as_listed || (force.block == other && force.other == block)) {
                    sum.horizontal += as_listed ? force.force.x() : -force.force.x();
                    sum.vertical += as_listed ? force.force.y() : -force.force.y();
                    sum.normal += force.normal;
                    sum.overlap = std::max(sum.overlap, force.overlap);
                }
            }
            line.contact.push_back(sum);
        }
    }
    for (const BlockOutcome& outcome : simulation.block_outcomes()) {
        line.base_slip.push_back(outcome.base_slip);
        line.rotation.push_back(outcome.rotation);
    }
    const RelaxationScene& scene = simulation.scene();
    for (const BoltOutcome& outcome : bolt_outcomes(scene, bolt_pulls(scene, simulation.bodies(), state))) {
        line.bolt.push_back(outcome.force);
    }
    return line;
}

}  // namespace delabole
