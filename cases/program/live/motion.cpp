#include "cases/program/live/motion.hpp"

#include "cases/program/results/model_reports.hpp"
#include "dynamic_relaxation/step/history.hpp"
#include "dynamic_relaxation/study/study_run.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

namespace delabole {

namespace {

// After its verdict a motion on the page ends only when its user ends it.
RelaxationSettings endless(RelaxationSettings settings) {
    settings.stop_at_onset = settings.stop_at_equilibrium = settings.stop_at_collapse = false;
    settings.duration = 1e9;
    settings.most_steps = std::size_t{1} << 62U;
    return settings;
}

bool is_broken_off(RelaxationOutcome outcome) {
    return outcome == RelaxationOutcome::motion_not_finite || outcome == RelaxationOutcome::overlap_too_large ||
           outcome == RelaxationOutcome::scene_not_valid;
}

bool same_blocks(const RelaxationScene& one, const RelaxationScene& other) {
    return std::ranges::equal(one.block, other.block, [](const auto& first, const auto& second) {
        return first.fixed == second.fixed && first.outline == second.outline;
    });
}

class Floats {
  public:
    void add(double value) {
        static_assert(std::endian::native == std::endian::little);
        const auto narrow = static_cast<float>(value);
        const std::size_t end = bytes_.size();
        bytes_.resize(end + sizeof narrow);
        std::memcpy(bytes_.data() + end, &narrow, sizeof narrow);
    }
    std::string take() { return std::move(bytes_); }

  private:
    std::string bytes_;
};

}  // namespace

LiveMotion::LiveMotion(const RelaxationStudy& study) : study_(study) {
    const RelaxationScene scene = relaxation_scene(study);
    simulation_.emplace(scene, relaxation_settings(study, scene));
}

Json LiveMotion::blocks() const {
    Json blocks = Json::array();
    for (const auto& block : simulation_->scene().block) {
        Json outline = Json::array();
        for (const PlanePoint<>& corner : block.outline) {
            outline.push_back(Json::array({corner.x(), corner.y()}));
        }
        blocks.push_back({{"outline", std::move(outline)}, {"fixed", block.fixed}});
    }
    const std::vector<double>& mass = simulation_->bodies().mass;
    Json centres = Json::array();
    for (const PlanePoint<>& centre : simulation_->bodies().centroid) {
        centres.push_back(Json::array({centre.x(), centre.y()}));
    }
    return {{"blocks", std::move(blocks)},
            {"centres", std::move(centres)},
            {"tilt", simulation_->tilt()},
            {"mass", std::accumulate(mass.begin(), mass.end(), 0.0) / static_cast<double>(mass.size())}};
}

void LiveMotion::go_on(std::uint64_t most_steps, std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    for (std::uint64_t step = 0; step < most_steps && !is_broken_off(simulation_->outcome()); ++step) {
        simulation_->step();
        if (!verdict_ && !simulation_->running()) {
            decide();
        }
        if (std::chrono::steady_clock::now() >= end) {
            return;
        }
    }
}

void LiveMotion::decide() {
    RelaxationStudyAnswer answer;
    answer.run = ended_at(study_, *simulation_);
    verdict_ = head_card(study_, answer);
    collapsed_ = simulation_->outcome() == RelaxationOutcome::collapse;
    ++decisions_;
    if (!is_broken_off(simulation_->outcome())) {
        RelaxationState state = simulation_->state();
        state.outcome = static_cast<std::uint64_t>(RelaxationOutcome::undecided);
        const RelaxationScene scene = simulation_->scene();
        const RelaxationSettings settings = endless(simulation_->settings());
        simulation_.emplace(scene, settings, std::move(state));
    }
}

Json LiveMotion::verdict() const {
    if (!verdict_) {
        return Json::object();
    }
    return {{"verdict", verdict_->sentences.front()},
            {"sentences", std::vector<std::string>(verdict_->sentences.begin() + 1, verdict_->sentences.end())},
            {"over", is_broken_off(simulation_->outcome())}};
}

bool LiveMotion::change(const RelaxationStudy& study) {
    const RelaxationScene scene = relaxation_scene(study);
    if (!same_blocks(scene, simulation_->scene())) {
        return false;
    }
    RelaxationState state = simulation_->state();
    // All pairs are searched again, with the laws of the new strengths; contacts that are found keep their memory, and
    // new ones do not count as joints that were closed in the initial geometry.
    ContactWatch::start(scene.block.size(), state.watch);
    state.watch.searches = 1;
    for (WatchedPair& pair : state.watch.pair) {
        pair.holds = 0;  // otherwise the contacts of blocks at rest would keep their laws
    }
    state.outcome = static_cast<std::uint64_t>(RelaxationOutcome::undecided);
    std::ranges::fill(state.checks_at_rest, 0);
    // Contacts of blocks at rest are only evaluated once these blocks have been noticed.
    for (std::size_t block = 0; block < state.motion.size(); ++block) {
        state.noticed.notice(block, state.motion[block]);
    }
    study_ = study;
    RelaxationSettings settings = relaxation_settings(study, scene);
    settings.duration += state.time;
    settings.most_steps += static_cast<std::size_t>(state.steps);
    if (collapsed_) {
        settings = endless(settings);  // what has collapsed gets no new verdict
    } else {
        verdict_.reset();
    }
    simulation_.emplace(scene, settings, std::move(state));
    return true;
}

std::string LiveMotion::picture() const {
    const RelaxationState& state = simulation_->state();
    const EnergyBalance energy_balance = simulation_->energy_balance();
    const std::vector<CornerForce> forces = corner_forces(simulation_->bonds(), simulation_->bodies(), state);
    std::vector<BoltPull> bolts = bolt_pulls(simulation_->scene(), simulation_->bodies(), state);
    std::erase_if(bolts, [](const BoltPull& bolt) { return !bolt.holds; });
    Floats floats;
    // A float does not hold every whole number beyond 2^24.
    constexpr std::uint64_t float_holds = std::uint64_t{1} << 24U;
    for (const double value :
         {state.time, static_cast<double>(state.steps / float_holds), static_cast<double>(state.steps % float_holds),
          verdict_ ? static_cast<double>(decisions_) : 0.0, state.onset_time, energy_balance.applied,
          energy_balance.kinetic, energy_balance.elastic, energy_balance.friction,
          energy_balance.dashpots + energy_balance.local_damping + energy_balance.kinetic_damping,
          energy_balance.residual(), std::max(state.unbalanced, state.unbalanced_then),
          static_cast<double>(state.motion.size()), static_cast<double>(forces.size()),
          static_cast<double>(bolts.size())}) {
        floats.add(value);
    }
    for (const Motion& motion : state.motion) {
        floats.add(motion.x);
        floats.add(motion.y);
        floats.add(motion.angle);
    }
    for (const CornerForce& force : forces) {
        floats.add(force.at.x());
        floats.add(force.at.y());
        floats.add(force.force.x());
        floats.add(force.force.y());
    }
    for (const BoltPull& bolt : bolts) {
        for (const double value :
             {bolt.at.x(), bolt.at.y(), bolt.other_at.x(), bolt.other_at.y(), bolt.force, bolt.yielded}) {
            floats.add(value);
        }
    }
    return floats.take();
}

}  // namespace delabole
