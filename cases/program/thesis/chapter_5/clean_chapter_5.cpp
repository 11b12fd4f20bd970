#include "cases/program/thesis/chapter_5/clean_chapter_5.hpp"

#include "cases/program/terminal/interrupt.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/step/simulation.hpp"
#include "parameters/fields.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace delabole {

namespace {

constexpr std::size_t of_joints = 0;
constexpr std::size_t of_bases = 1;

JointMaterial material(const HockingSettings& settings, const HockingFriction& friction) {
    return {settings.stiffness, settings.stiffness, friction.peak, friction.residual};
}

Polygon<> outline_along_base(const HockingBlock& block, double dip) {
    const Point centroid = Eigen::Rotation2Dd(-dip) * block.centroid;
    const double left = centroid.x() - block.width / 2;
    const double bottom = centroid.y() - block.height / 2;
    return {{left, bottom},
            {left + block.width, bottom},
            {left + block.width, bottom + block.height},
            {left, bottom + block.height}};
}

// Goes through a run cycle by cycle and keeps its print edits.
class Recorder {
  public:
    Recorder(const Chapter5Run& run, const std::vector<HockingBlock>& blocks, RelaxationStart start)
        : run_(run), blocks_(blocks), simulation_(clean_scene(run, blocks), clean_settings(run, start)) {
        for (const HockingBlock& block : blocks) {
            weight_ += block.fixed ? 0 : block.width * block.height * run.settings.density * run.settings.gravity;
        }
    }

    CleanRun record() {
        const HockingSettings& settings = run_.settings;
        print(0, slips());
        int last = settings.cycles;
        for (int cycle = 1; cycle <= last; ++cycle) {
            const bool prints = cycle % settings.print_interval == 0;
            const std::vector<double> before = prints ? slips() : std::vector<double>();
            advance(cycle * settings.time_step);
            if (blown_out() && !history().blow_out_cycle) {
                history().blow_out_cycle = cycle;
                last = std::min(last, cycle + settings.cycles_after_blow_out);
            }
            if (prints || cycle == last) {
                print(cycle, prints ? before : slips());
                if (farthest_turned_ > settings.stop_rotation) {
                    last = cycle;
                }
            }
        }
        history().outcome = outcome();
        const EnergyBalance energy_balance = simulation_.energy_balance();
        result_.energy_error =
            energy_balance.turnover() > 0 ? std::abs(energy_balance.residual()) / energy_balance.turnover() : 0;
        return result_;
    }

  private:
    HockingResult& history() { return result_.history; }

    void advance(double time) {
        // Sums of steps differ from products by rounding alone.
        const double close = 1e-3 * run_.settings.time_step;
        while (simulation_.state().time < time - close) {
            simulation_.step();
            for (const auto& force : simulation_.state().contacts.force) {
                largest_force_ = std::max(largest_force_, std::hypot(force.x, force.y));
            }
            greatest_force_ = std::max(greatest_force_, largest_force_);
            result_.largest_speed = std::max(result_.largest_speed, fastest());
        }
    }

    bool blown_out() const {
        return greatest_force_ > run_.settings.blow_out_force * weight_ ||
               simulation_.outcome() == RelaxationOutcome::overlap_too_large ||
               simulation_.outcome() == RelaxationOutcome::motion_not_finite;
    }

    double fastest() const {
        double fastest = 0;
        for (std::size_t block = 0; block < blocks_.size(); ++block) {
            if (!blocks_[block].fixed) {
                const Motion& motion = simulation_.state().motion[block];
                fastest = std::max(fastest, std::hypot(motion.vx, motion.vy) +
                                                std::abs(motion.spin) * simulation_.bodies().radius[block]);
            }
        }
        return fastest;
    }

    std::vector<double> slips() const {
        std::vector<double> slips;
        for (const BlockOutcome& block : simulation_.block_outcomes()) {
            slips.push_back(block.base_slip);
        }
        return slips;
    }

    double tilt() const {
        if (!run_.settings.tilting) {
            return 0;
        }
        if (run_.settings.tilting->part == TiltedPart::gravity) {
            return simulation_.tilt() - run_.columns.dip;
        }
        return simulation_.state().motion.back().angle;
    }

    HockingOutcome outcome() const {
        if (blown_out()) {
            return HockingOutcome::blows_out;
        }
        if (farthest_turned_ > run_.settings.failure_rotation) {
            return HockingOutcome::fails;
        }
        return fastest() <= run_.settings.settled_speed ? HockingOutcome::stands : HockingOutcome::undecided;
    }

    void print(int cycle, const std::vector<double>& slips_before) {
        const std::vector<double> slips_now = slips();
        const Eigen::Rotation2Dd to_drawing(run_.columns.dip);
        HockingPrint edit;
        edit.cycle = cycle;
        edit.tilt = tilt();
        edit.largest_force = std::exchange(largest_force_, 0.0);
        for (std::size_t block = 0; block < blocks_.size(); ++block) {
            const Motion& motion = simulation_.state().motion[block];
            HockingBlockState state;
            state.centroid = blocks_[block].centroid + to_drawing * Point(motion.x, motion.y);
            state.angle = motion.angle;
            state.velocity = to_drawing * Point(motion.vx, motion.vy);
            state.angular_velocity = motion.spin;
            const double slip = slips_now[block] - slips_before[block];
            state.sliding = slip < 0 ? BaseSliding::forward : slip > 0 ? BaseSliding::backward : BaseSliding::none;
            edit.blocks.push_back(state);
            if (!blocks_[block].fixed) {
                farthest_turned_ = std::max(farthest_turned_, std::abs(rotation_in(run_, edit, block)));
            }
        }
        history().prints.push_back(edit);
    }

    const Chapter5Run& run_;
    const std::vector<HockingBlock>& blocks_;
    Simulation simulation_;
    double weight_ = 0;         // N/m, of all free blocks
    double largest_force_ = 0;  // since the last print
    double greatest_force_ = 0;
    double farthest_turned_ = 0;
    CleanRun result_ = {};
};

}  // namespace

std::vector<HockingBlock> exact_blocks(const Chapter5Run& run) {
    HockingColumns columns = run.columns;
    columns.coordinate_unit = 0;
    return make_blocks(columns);
}

RelaxationScene clean_scene(const Chapter5Run& run, const std::vector<HockingBlock>& blocks) {
    const HockingSettings& settings = run.settings;
    RelaxationScene scene;
    scene.material = {material(settings, settings.joints), material(settings, settings.bases)};
    for (const HockingBlock& block : blocks) {
        RelaxationBlock made{outline_along_base(block, run.columns.dip), settings.density};
        made.fixed = block.fixed;
        made.joint.assign(made.outline.size(), block.fixed ? of_bases : of_joints);
        made.joint.front() = of_bases;
        scene.block.push_back(made);
    }
    const double dip = run.columns.dip;
    scene.gravity = {.acceleration = settings.gravity, .tilt = dip, .final_tilt = dip};
    if (settings.tilting) {
        const HockingTilting& tilting = *settings.tilting;
        const double interval = tilting.every * settings.time_step;
        const double rate = tilting.increment / interval;
        const double start = tilting.begin * settings.time_step;
        if (tilting.part == TiltedPart::gravity) {
            scene.gravity.final_tilt = dip + tilting.total;
            scene.gravity.rate = rate;
            scene.gravity.interval = interval;
            scene.gravity.start = start;
        } else {
            for (std::size_t block = 0; block < blocks.size(); ++block) {
                if (blocks[block].fixed) {
                    scene.motion.push_back({.block = block,
                                            .velocity = {},
                                            .angular_velocity = rate,
                                            .pivot = area_properties(scene.block[block].outline).centroid,
                                            .start = start,
                                            .duration = tilting.total / rate});
                }
            }
        }
    }
    return scene;
}

RelaxationSettings clean_settings(const Chapter5Run& run, RelaxationStart start) {
    RelaxationSettings settings;
    settings.time_step = run.settings.time_step;
    settings.step_fraction = 0.5;  // above it a trembling of the springs dies away too slowly for a decision
    settings.viscous_damping = run.settings.damping;
    settings.local_damping = 0;
    settings.start = start;
    settings.stop_at_equilibrium = false;
    settings.collapse_rotation = settings.collapse_displacement = std::numeric_limits<double>::infinity();
    settings.duration = run.settings.cycles * run.settings.time_step;
    return settings;
}

CleanRun run_clean(const Chapter5Run& run, const std::vector<HockingBlock>& blocks, RelaxationStart start) {
    const RelaxationScene scene = clean_scene(run, blocks);
    if (check_scene(scene).check != SceneCheck::valid || check_start(scene).check != SceneCheck::valid) {
        return {};
    }
    return Recorder(run, blocks, start).record();
}

HockingResult compute(const Chapter5Run& run, Engine engine, const std::vector<HockingBlock>& blocks) {
    if (engine == Engine::recreated) {
        return run_hocking(blocks, run.settings);
    }
    const RelaxationStart start = engine == Engine::dropped ? RelaxationStart::dropped : RelaxationStart::preloaded;
    return run_clean(run, blocks, start).history;
}

HockingResult compute(const Chapter5Run& run, Engine engine) {
    return compute(run, engine, engine == Engine::recreated ? make_blocks(run.columns) : exact_blocks(run));
}

std::vector<HockingResult> compute_shifted(const Chapter5Run& run, Engine engine, double unit, int starts) {
    const std::vector<HockingBlock> blocks = make_blocks(run.columns);
    std::vector<HockingResult> results;
    for (int seed = 1; seed <= starts; ++seed) {
        stop_if_interrupted();
        results.push_back(compute(run, engine, perturbed(blocks, unit, static_cast<unsigned>(seed))));
    }
    return results;
}

}  // namespace delabole
