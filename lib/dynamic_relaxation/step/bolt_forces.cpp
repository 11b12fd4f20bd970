#include "dynamic_relaxation/step/bolt_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

void put_in_bolts(const RelaxationScene& scene, const Bodies& bodies, RelaxationState& state) {
    for (std::size_t index = 0; index < scene.bolt.size(); ++index) {
        state.bolt[index] = {locate(scene.bolt[index], bodies, state.motion).extension, 0};
    }
}

void add_bolt_forces(const RelaxationScene& scene, const Bodies& bodies, RelaxationState& state,
                     std::vector<BlockForce>& load) {
    const auto add = [&](std::size_t block, const PlanePoint<>& arm, const PlanePoint<>& force) {
        load[block] += {force.x(), force.y(), arm.x() * force.y() - arm.y() * force.x()};
    };
    for (std::size_t index = 0; index < scene.bolt.size(); ++index) {
        const BoltSegment& segment = scene.bolt[index];
        if (!holds(segment, state.removed)) {
            continue;
        }
        const BoltPosition now = locate(segment, bodies, state.motion);
        BoltMemory& memory = state.bolt[index];
        // m, extension beyond the pretension at which it yields.
        const double elastic = (segment.capacity - segment.pretension) / segment.stiffness;
        memory.yielded = std::max(memory.yielded, now.extension - memory.extension_at_start - elastic);
        const PlanePoint<> force = force_of(segment, memory, now.extension) * now.towards;
        add(segment.block, now.arm(), force);
        add(segment.other, now.other_arm(), -force);
    }
}

double stable_step_of_bolts(const RelaxationScene& scene, const Bodies& bodies) {
    // The square of no frequency exceeds twice the greatest sum of any one block.
    std::vector<double> square(bodies.size(), 0);
    for (const BoltSegment& segment : scene.bolt) {
        const auto add = [&](std::size_t block, const PlanePoint<>& at) {
            square[block] +=
                segment.stiffness * (bodies.inverse_mass[block] +
                                     (at - bodies.centroid[block]).squaredNorm() * bodies.inverse_inertia[block]);
        };
        add(segment.block, segment.at);
        add(segment.other, segment.other_at);
    }
    const double greatest = square.empty() ? 0 : 2 * std::ranges::max(square);
    return greatest > 0 ? 2 / std::sqrt(greatest) : std::numeric_limits<double>::infinity();
}

std::vector<BoltPull> bolt_pulls(const RelaxationScene& scene, const Bodies& bodies, const RelaxationState& state) {
    std::vector<BoltPull> pulls;
    const auto place = [&](std::size_t block, const PlanePoint<>& arm) {
        const Motion& motion = state.motion[block];
        return PlanePoint<>(bodies.centroid[block] + PlanePoint<>(motion.x, motion.y) + arm);
    };
    for (std::size_t index = 0; index < scene.bolt.size(); ++index) {
        const BoltSegment& segment = scene.bolt[index];
        BoltPull& pull = pulls.emplace_back();
        if (holds(segment, state.removed)) {
            const BoltPosition now = locate(segment, bodies, state.motion);
            const BoltMemory& memory = state.bolt[index];
            pull = {place(segment.block, now.arm()), place(segment.other, now.other_arm()),
                    force_of(segment, memory, now.extension), memory.yielded, true};
        }
    }
    return pulls;
}

std::vector<BoltOutcome> bolt_outcomes(const RelaxationScene& scene, const std::vector<BoltPull>& pulls) {
    std::vector<BoltOutcome> outcomes;
    for (std::size_t index = 0; index < pulls.size(); ++index) {
        outcomes.resize(std::max(outcomes.size(), scene.bolt[index].bolt + 1));
        BoltOutcome& outcome = outcomes[scene.bolt[index].bolt];
        outcome.force = std::max(outcome.force, pulls[index].force);
        outcome.yielded = std::max(outcome.yielded, pulls[index].yielded);
    }
    return outcomes;
}

}  // namespace delabole
