"""Blocks in motion: steps, arrays without copies, checkpoints."""

import gc

import conftest
import delabole
import numpy as np
import pytest

BRICK = np.array([[0, 0], [1, 0], [1, 2], [0, 2]], dtype=float)
PLANE = np.array([[-12, -1], [8, -1], [8, 0], [-12, 0]], dtype=float)


def bricks(**settings):
    return delabole.blocks(
        [PLANE] + [BRICK + [column, 0] for column in range(3)],
        joint={"friction_angle": "20 deg"},
        density="2700 kg/m3",
        fixed=[0],
        tilt="24 deg",
        settings={"stop": "duration", "collapse_displacement": 10, "duration": "2 s", **settings},
    )


@pytest.mark.parametrize("name", ["free_slide", "two_blocks_3", "bonded_cantilever"])
def test_a_run_to_its_end_is_that_of_the_program(cases, name):
    case = delabole.read(cases / f"relaxation/{name}.toml")
    answer = case.run()
    simulation = delabole.Simulation(case)
    simulation.run()
    assert simulation.steps == answer["steps"]
    free = np.flatnonzero(~simulation.fixed)
    moved = simulation.displacements[free] - simulation.first_displacements[free]
    assert np.sqrt((moved**2).sum(axis=1)).tolist() == [answer[f"block[{index + 1}].displacement"] for index in free]
    assert simulation.energies["friction"] == answer["energy.friction"]


def test_arrays_look_into_the_simulation_without_copies():
    simulation = delabole.Simulation(bricks())
    simulation.step(100)
    first, second = simulation.displacements, simulation.displacements
    assert first.shape == (4, 2) and not first.flags.owndata
    assert np.shares_memory(first, second)
    assert not first.flags.writeable
    with pytest.raises(ValueError):
        first[1, 0] = 0
    with pytest.raises(ValueError):
        first.flags.writeable = True
    forces, blocks, points = simulation.contact_forces, simulation.contact_blocks, simulation.contact_points
    assert forces.shape == blocks.shape == points.shape and len(forces) > 0
    assert np.shares_memory(forces, simulation.contact_forces)
    assert blocks.dtype == np.uint32 and blocks.max() < 4


def test_arrays_keep_the_moment_at_which_they_were_taken():
    simulation = delabole.Simulation(bricks())
    simulation.step(100)
    taken = [getattr(simulation, name) for name in
             ("displacements", "rotations", "velocities", "spins", "contact_forces", "contact_blocks", "centroids")]
    copies = [array.copy() for array in taken]
    simulation.step(5000)
    assert not np.array_equal(simulation.displacements, copies[0])
    for array, copy in zip(taken, copies):
        np.testing.assert_array_equal(array, copy)
    # And they outlive the simulation.
    del simulation
    gc.collect()
    for array, copy in zip(taken, copies):
        np.testing.assert_array_equal(array, copy)


def test_being_looked_at_changes_nothing():
    alone, watched = delabole.Simulation(bricks()), delabole.Simulation(bricks())
    alone.step(600)
    kept = []
    for _ in range(6):
        watched.step(100)
        kept.append(watched.contact_forces)
    assert watched.checkpoint() == alone.checkpoint()


def test_a_checkpoint_goes_on_bit_for_bit():
    model = bricks()
    simulation = delabole.Simulation(model)
    simulation.step(300)
    checkpoint = simulation.checkpoint()
    assert isinstance(checkpoint, bytes)
    simulation.step(700)
    resumed = delabole.Simulation(model, checkpoint=checkpoint)
    assert resumed.steps == 300
    resumed.step(700)
    assert resumed.checkpoint() == simulation.checkpoint()
    damaged = bytearray(checkpoint)
    damaged[200] ^= 1
    for wrong, word in ((bytes(damaged), "damaged"), (b"", "not_a_checkpoint")):
        with pytest.raises(ValueError, match=word):
            delabole.Simulation(model, checkpoint=wrong)
    with pytest.raises(ValueError, match="other_scene"):
        delabole.Simulation(bricks(local_damping=0.3), checkpoint=checkpoint)


def test_forces_and_energies_balance():
    simulation = delabole.Simulation(bricks(stop="equilibrium", duration="20 s"))
    simulation.run(until=1.0)
    # Sliding freely at 24 deg with 20 deg of friction: g (sin 24 - cos 24 tan 20) t^2 / 2, less what damping takes.
    assert simulation.time == pytest.approx(1.0, abs=2 * simulation.time_step)
    assert simulation.movements[0] == "fixed" and set(simulation.movements[1:]) == {"slides_forward"}
    assert abs(simulation.energies["residual_share"]) < 1e-3
    # What the plane bears in all is the weight of the bricks across it.
    on_plane = simulation.contact_blocks == 0
    force = np.abs(simulation.contact_forces[on_plane.any(axis=1), 1]).sum()
    weight = 3 * 2 * 2700 * 9.80665
    assert force == pytest.approx(weight * np.cos(np.radians(24)), rel=1e-2)  # bricks tremble a little


def test_a_run_ends_at_a_time_or_where_there_is_an_outcome():
    simulation = delabole.Simulation(bricks())
    made = simulation.run(until=0.5)
    assert made == simulation.steps and simulation.running and simulation.outcome == "undecided"
    told = []
    simulation.run(progress=lambda share, what: told.append(share))
    assert not simulation.running and simulation.step(10) == 0
    assert told == sorted(told)
    np.testing.assert_array_equal(simulation.positions, simulation.centroids + simulation.displacements)
    outline = simulation.outlines[1]
    assert outline.shape == (4, 2)
    np.testing.assert_allclose(outline.mean(axis=0), simulation.positions[1], rtol=0, atol=1e-12)


def test_ctrl_c_leaves_a_simulation_that_goes_on():
    # So small are the steps that the bricks slide on for many seconds of the processor.
    simulation = delabole.Simulation(
        bricks(duration="1e6 s", collapse_displacement=1e9, time_step="1e-7 s", most_steps=1_000_000_000))
    interruption = conftest.Interruption()
    with pytest.raises(KeyboardInterrupt):
        simulation.run(progress=interruption.soon)
    steps = simulation.steps
    assert steps > 0 and simulation.step(10) == 10 and simulation.steps == steps + 10


def test_a_callback_may_look_and_keep_what_it_sees():
    simulation = delabole.Simulation(bricks(duration="4 s", time_step="1e-5 s"))
    kept = []
    simulation.run(progress=lambda share, what: kept.append((simulation.time, simulation.displacements)))
    alone = delabole.Simulation(bricks(duration="4 s", time_step="1e-5 s"))
    alone.run()
    assert alone.checkpoint() == simulation.checkpoint()
    if len(kept) > 1:
        assert not np.array_equal(kept[0][1], kept[-1][1])


def test_what_does_not_move_is_refused(cases):
    with pytest.raises(TypeError, match="only the model relaxation moves, not plane_failure"):
        delabole.Simulation(delabole.read(cases / "plane_failure/fig_2_8.toml"))
    with pytest.raises(delabole.CaseError):
        delabole.Simulation(delabole.blocks([BRICK[::-1]], joint={"friction_angle": "20 deg"}, density="2700 kg/m3"))
    for index in (1, -1):
        with pytest.raises(ValueError, match=f"there is no block {index}; blocks are counted from 0 to 0"):
            delabole.blocks([BRICK], joint={"friction_angle": "20 deg"}, density="2700 kg/m3", fixed=[index])
    with pytest.raises(ValueError, match="outline 0 must be an array of corners"):
        delabole.blocks([[1, 2, 3]], joint={"friction_angle": "20 deg"}, density=2700)
