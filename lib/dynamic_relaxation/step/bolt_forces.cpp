#include "dynamic_relaxation/step/bolt_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

struct Stretched {
    double extension;      // m, since the initial geometry
    PlanePoint<> towards;  // unit vector from the block to the other
    PlanePoint<> arm;      // about the block's centroid, in its present rotation
    PlanePoint<> other_arm;
};

Stretched stretched(const BoltSegment& segment, const Bodies& bodies, const std::vector<Motion>& motion) {
    const Motion& one = motion[segment.block];
    const Motion& two = motion[segment.other];
    const PlanePoint<> arm = segment.at - bodies.centroid[segment.block];
    const PlanePoint<> other_arm = segment.other_at - bodies.centroid[segment.other];
    const PlanePoint<> drawn = segment.other_at - segment.at;
    // Computed from the displacement, because the difference of two lengths would lose the small extensions of a stiff
    // bolt.
    const PlanePoint<> moved =
        PlanePoint<>(two.x - one.x, two.y - one.y) + two.turned_by(other_arm) - one.turned_by(arm);
    const PlanePoint<> now = drawn + moved;
    const double length = now.norm();
    return {(2 * drawn + moved).dot(moved) / (length + drawn.norm()),
            length > 0 ? PlanePoint<>(now / length) : PlanePoint<>(0, 0), one.turned(arm), two.turned(other_arm)};
}

double force_of(const BoltSegment& segment, const BoltMemory& memory, double extension) {
    const double elastic =
        segment.pretension + segment.stiffness * (extension - memory.extension_at_start - memory.yielded);
    return std::clamp(elastic, 0.0, segment.capacity);
}

bool holds(const BoltSegment& segment, const std::vector<char>& removed) {
    return removed[segment.block] == 0 && removed[segment.other] == 0;
}

}  // namespace

void put_in_bolts(const RelaxationScene& scene, const Bodies& bodies, RelaxationState& state) {
    for (std::size_t index = 0; index < scene.bolt.size(); ++index) {
        state.bolt[index] = {stretched(scene.bolt[index], bodies, state.motion).extension, 0};
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
        const Stretched now = stretched(segment, bodies, state.motion);
        BoltMemory& memory = state.bolt[index];
        // m, extension beyond the pretension at which it yields.
        const double elastic = (segment.capacity - segment.pretension) / segment.stiffness;
        memory.yielded = std::max(memory.yielded, now.extension - memory.extension_at_start - elastic);
        const PlanePoint<> force = force_of(segment, memory, now.extension) * now.towards;
        add(segment.block, now.arm, force);
        add(segment.other, now.other_arm, -force);
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
            const Stretched now = stretched(segment, bodies, state.motion);
            const BoltMemory& memory = state.bolt[index];
            pull = {place(segment.block, now.arm), place(segment.other, now.other_arm),
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
