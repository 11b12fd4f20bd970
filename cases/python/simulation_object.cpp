#include "cases/python/simulation_object.hpp"

#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/terminal/options.hpp"
#include "cases/python/arrays.hpp"
#include "cases/python/case_object.hpp"
#include "dynamic_relaxation/checkpoint/checkpoint.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <pybind11/stl.h>

#include <chrono>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace delabole {

namespace py = pybind11;

namespace {

const RelaxationStudy& relaxation_of(const CaseFile& file) {
    const auto* study = std::get_if<RelaxationStudy>(&file.model);
    if (study == nullptr) {
        throw py::type_error("only the model relaxation moves, not " + std::string(model_name(file.model)));
    }
    return *study;
}

// Arrays refer to the memory of a simulation and keep it alive. Their values never change: a simulation to which an
// array refers makes no further steps; a copy of it, identical to the last bit, continues instead. Without such an
// array nothing is copied.
class SimulationObject {
  public:
    SimulationObject(const CaseObject& object, const std::optional<std::string>& checkpoint, std::size_t threads) {
        const RelaxationStudy& study = relaxation_of(object.file);
        refuse_impossible(object.file);
        RelaxationScene scene = relaxation_scene(study);
        RelaxationSettings settings = relaxation_settings(study, scene);
        settings.threads = threads;
        if (const SceneFault fault = check(scene, settings); fault.check != SceneCheck::valid) {
            throw CaseError({impossible(object.file, word_of(fault.check))});
        }
        // Finding the initial equilibrium takes a while in large slopes.
        const py::gil_scoped_release released;
        if (!checkpoint) {
            simulation_ = std::make_shared<Simulation>(std::move(scene), settings);
            return;
        }
        RestoredState restored = restore_checkpoint(*checkpoint, scene, settings);
        if (restored.check != CheckpointCheck::ok) {
            throw UsageError("the checkpoint cannot be gone on from: " + std::string(word_of(restored.check)));
        }
        simulation_ = std::make_shared<Simulation>(std::move(scene), settings, std::move(restored.state));
    }

    const Simulation& now() const {
        if (stepping_) {
            throw std::runtime_error("the simulation is being stepped in another thread");
        }
        return *simulation_;
    }

    // Returns the number of steps made, which is less than `count` if the run came to its end.
    std::uint64_t step(std::uint64_t count) {
        return go_on(count, std::numeric_limits<double>::infinity(), py::none());
    }

    std::uint64_t run(const std::optional<double>& until, const py::object& progress) {
        return go_on(std::numeric_limits<std::uint64_t>::max(), until.value_or(std::numeric_limits<double>::infinity()),
                     progress);
    }

    // A read-only array of rows that are `bytes_apart` from each other in memory.
    template <class Number>
    py::array look(const Number* first, std::size_t rows, std::size_t columns, std::size_t bytes_apart) const {
        now();
        std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
        std::vector<py::ssize_t> strides{static_cast<py::ssize_t>(bytes_apart)};
        if (columns > 1) {
            shape.push_back(static_cast<py::ssize_t>(columns));
            strides.push_back(sizeof(Number));
        }
        using Kept = std::shared_ptr<Simulation>;
        const py::capsule owner(new Kept(simulation_), [](void* kept) { delete static_cast<Kept*>(kept); });
        py::array array(py::dtype::of<Number>(), shape, strides, first, owner);
        py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
        return array;
    }

  private:
    std::uint64_t go_on(std::uint64_t steps, double until, const py::object& progress) {
        using Clock = std::chrono::steady_clock;
        constexpr std::chrono::milliseconds between_looks(50);
        now();
        const std::uint64_t first = simulation_->state().steps;
        const auto goes_on = [&] {
            return simulation_->running() && simulation_->state().steps - first < steps &&
                   simulation_->reached() < until;
        };
        while (goes_on()) {
            stop_being_looked_at();
            {
                const Stepping stepping(stepping_);
                const py::gil_scoped_release released;
                const Clock::time_point next_look = Clock::now() + between_looks;
                do {
                    simulation_->step();
                } while (goes_on() && Clock::now() < next_look);
            }
            if (PyErr_CheckSignals() != 0) {
                throw py::error_already_set();
            }
            if (!progress.is_none()) {
                progress(simulation_->reached() / simulation_->settings().duration, "steps");
            }
        }
        return simulation_->state().steps - first;
    }

    // Sets the flag while steps are made without Python's lock.
    class Stepping {
      public:
        explicit Stepping(bool& flag) : flag_(&flag) { flag = true; }
        ~Stepping() { *flag_ = false; }
        Stepping(const Stepping&) = delete;
        Stepping& operator=(const Stepping&) = delete;

      private:
        bool* flag_;
    };

    void stop_being_looked_at() {
        if (simulation_.use_count() > 1) {
            simulation_ =
                std::make_shared<Simulation>(simulation_->scene(), simulation_->settings(), simulation_->state());
        }
    }

    std::shared_ptr<Simulation> simulation_;
    bool stepping_ = false;
};

py::array displacements(const SimulationObject& object) {
    static_assert(offsetof(MotionOf<double>, y) == offsetof(MotionOf<double>, x) + sizeof(double));
    const std::vector<Motion>& motion = object.now().state().motion;
    return object.look(&motion.front().x, motion.size(), 2, sizeof(Motion));
}

// Displacements at the beginning of the run, after the static solve.
py::array first_displacements(const SimulationObject& object) {
    const std::vector<Motion>& origin = object.now().state().origin;
    return object.look(&origin.front().x, origin.size(), 2, sizeof(Motion));
}

py::array velocities(const SimulationObject& object) {
    static_assert(offsetof(MotionOf<double>, vy) == offsetof(MotionOf<double>, vx) + sizeof(double));
    const std::vector<Motion>& motion = object.now().state().motion;
    return object.look(&motion.front().vx, motion.size(), 2, sizeof(Motion));
}

py::array rotations(const SimulationObject& object) {
    const std::vector<Motion>& motion = object.now().state().motion;
    return object.look(&motion.front().angle, motion.size(), 1, sizeof(Motion));
}

py::array spins(const SimulationObject& object) {
    const std::vector<Motion>& motion = object.now().state().motion;
    return object.look(&motion.front().spin, motion.size(), 1, sizeof(Motion));
}

py::array centroids(const SimulationObject& object) {
    const std::vector<PlanePoint<>>& centroid = object.now().bodies().centroid;
    return object.look(centroid.front().data(), centroid.size(), 2, sizeof(PlanePoint<>));
}

py::array contact_forces(const SimulationObject& object) {
    static_assert(offsetof(ForceOnCorner, y) == offsetof(ForceOnCorner, x) + sizeof(double));
    const auto& force = object.now().state().contacts.force;
    return object.look(reinterpret_cast<const double*>(force.data()), force.size(), 2, sizeof(ForceOnCorner));
}

py::array contact_blocks(const SimulationObject& object) {
    static_assert(offsetof(ContactBlocks, block) == 0 && offsetof(ContactBlocks, other) == sizeof(std::uint32_t));
    const auto blocks = object.now().state().contacts.contact.blocks();
    return object.look(reinterpret_cast<const std::uint32_t*>(blocks.data()), blocks.size(), 2, sizeof(ContactBlocks));
}

// Present positions of the corners that are in contact.
py::array_t<double> contact_points(const SimulationObject& object) {
    const Simulation& simulation = object.now();
    std::vector<PlanePoint<>> points;
    for (const ContactCorner& contact : simulation.state().contacts.contact.corners()) {
        points.push_back(moved_corner(simulation.bodies(), simulation.state().motion, contact.corner));
    }
    return array_of(points);
}

py::list outlines(const SimulationObject& object) {
    const Simulation& simulation = object.now();
    py::list list;
    for (const CornerRange& range : simulation.bodies().range) {
        std::vector<PlanePoint<>> corners;
        for (std::size_t corner = range.begin; corner < range.end; ++corner) {
            corners.push_back(moved_corner(simulation.bodies(), simulation.state().motion, corner));
        }
        list.append(array_of(corners));
    }
    return list;
}

py::dict energies(const SimulationObject& object) {
    const EnergyBalance energy_balance = object.now().energy_balance();
    py::dict dict;
    dict["applied"] = energy_balance.applied;
    dict["prescribed"] = energy_balance.prescribed;
    dict["kinetic"] = energy_balance.kinetic;
    dict["elastic"] = energy_balance.elastic;
    dict["friction"] = energy_balance.friction;
    dict["bonds"] = energy_balance.bonds;
    dict["dashpots"] = energy_balance.dashpots;
    dict["local_damping"] = energy_balance.local_damping;
    dict["kinetic_damping"] = energy_balance.kinetic_damping;
    dict["residual"] = energy_balance.residual();
    dict["residual_share"] = energy_balance.residual_share();
    return dict;
}

py::list movements(const SimulationObject& object) {
    py::list words;
    for (const BlockOutcome& block : object.now().block_outcomes()) {
        words.append(word_of(block.movement));
    }
    return words;
}

}  // namespace

void bind_simulation(py::module_& module) {
    py::class_<SimulationObject>(module, "Simulation")
        .def(py::init([](const CaseObject& object, const std::optional<py::bytes>& checkpoint, std::size_t threads) {
                 return SimulationObject(object, checkpoint ? std::optional(std::string(*checkpoint)) : std::nullopt,
                                         threads);
             }),
             py::arg("case"), py::arg("checkpoint"), py::arg("threads"))
        .def("step", &SimulationObject::step, py::arg("count"))
        .def("run", &SimulationObject::run, py::arg("until"), py::kw_only(), py::arg("progress"))
        .def("checkpoint",
             [](const SimulationObject& object) {
                 const Simulation& now = object.now();
                 return py::bytes(checkpoint_of(now.scene(), now.settings(), now.state()));
             })
        .def_property_readonly(
            "running", [](const SimulationObject& object) { return object.now().running(); },
            "whether neither an outcome nor the end of the duration has been reached")
        .def_property_readonly(
            "outcome",
            [](const SimulationObject& object) { return std::string(word_of(object.now().result().outcome)); },
            "how the run has ended: undecided, equilibrium, held_by_corners, onset, collapse, or why it was stopped")
        .def_property_readonly(
            "time", [](const SimulationObject& object) { return object.now().state().time; }, "of the model, s")
        .def_property_readonly(
            "time_step", [](const SimulationObject& object) { return object.now().state().step; }, "the last one, s")
        .def_property_readonly(
            "steps", [](const SimulationObject& object) { return object.now().state().steps; }, "made so far")
        .def_property_readonly(
            "tilt", [](const SimulationObject& object) { return object.now().tilt(); }, "of gravity now, rad")
        .def_property_readonly(
            "fixed",
            [](const SimulationObject& object) {
                const std::vector<char>& fixed = object.now().bodies().fixed;
                return py::array(py::dtype("bool"), {static_cast<py::ssize_t>(fixed.size())}, {}, fixed.data());
            },
            "of each block: whether it never moves")
        .def_property_readonly(
            "gone",
            [](const SimulationObject& object) {
                py::array_t<bool> gone(static_cast<py::ssize_t>(object.now().state().removed.size()));
                auto flags = gone.mutable_unchecked<1>();
                for (py::ssize_t block = 0; block < gone.size(); ++block) {
                    flags(block) = object.now().state().removed[static_cast<std::size_t>(block)] != 0;
                }
                return gone;
            },
            "of each block: whether it was removed or has left the slope")
        .def_property_readonly("centroids", &centroids, "in the initial geometry, m: an array of blocks by two")
        .def_property_readonly("displacements", &displacements,
                               "of centroids since the initial geometry, m: an array of blocks by two")
        .def_property_readonly("first_displacements", &first_displacements,
                               "of centroids when the run began, after the static start, m: an array of blocks by two")
        .def_property_readonly("rotations", &rotations, "of blocks, anticlockwise, rad")
        .def_property_readonly("velocities", &velocities, "of centroids, m/s: an array of blocks by two")
        .def_property_readonly("spins", &spins, "angular velocities of blocks, anticlockwise, rad/s")
        .def_property_readonly("contact_forces", &contact_forces,
                               "on the first block of each contact, N per metre of slope: an array of contacts by two")
        .def_property_readonly(
            "contact_blocks", &contact_blocks,
            "the two blocks of each contact, counted from 0: the first is pressed by an edge of the second")
        .def_property_readonly("contact_points", &contact_points,
                               "corners that touch, as they lie now, m: an array of contacts by two")
        .def_property_readonly("outlines", &outlines, "of each block as it lies now, m: an array of corners by two")
        .def_property_readonly("movements", &movements,
                               "of each block a word: stays, slides_forward, rotates and so on")
        .def_property_readonly("energies", &energies,
                               "the balance of energy, J per metre of slope, and residual_share, a ratio");
}

}  // namespace delabole
