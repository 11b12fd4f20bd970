"""Many points in one call."""

import itertools

import delabole
import numpy as np
import pytest


@pytest.fixture(scope="module")
def case(cases):
    return delabole.read(cases / "plane_failure/failure_locus.toml")


def test_a_grid_of_friction_and_water_is_what_single_runs_answer(case):
    friction = np.radians(np.linspace(5, 60, 7))
    depth = np.linspace(0, 3, 5)
    names = ["factor_of_safety", "weight", "friction_margin"]
    inputs = {"strength.friction_angle": friction[:, None], "water.water_depth": depth}
    grid = case.evaluate(inputs, names)
    alone = case.evaluate(inputs)
    assert grid["weight"].shape == (7, 5)
    model = case.model
    for row, column in itertools.product(range(7), range(5)):
        model.strength.friction_angle = float(friction[row])
        model.water.water_depth = float(depth[column])
        result = model.run()
        assert [grid[name][row, column] for name in names] == [result[name] for name in names]
        assert alone.factor_of_safety[row, column] == result.factor_of_safety


def test_points_without_an_answer_are_counted_by_cause(case):
    dips = np.radians([20, 35, 50, 65, 95])
    evaluation = case.evaluate({"failure_plane.dip": dips})
    assert np.isfinite(evaluation.factor_of_safety[1])
    assert np.isnan(evaluation.factor_of_safety[3:]).all()
    assert evaluation.causes == sorted(evaluation.causes)
    assert evaluation.failures["input_out_of_range"] == 1
    assert sum(evaluation.failures.values()) == np.isnan(evaluation.factor_of_safety).sum()
    assert evaluation.causes[evaluation.failure[4] - 1] == "input_out_of_range"
    assert np.isnan(case.evaluate({"failure_plane.dip": np.nan}).factor_of_safety)


def test_numbers_do_not_depend_on_threads_or_neighbours(case):
    generator = np.random.default_rng(1)
    inputs = {
        "strength.friction_angle": generator.uniform(-0.1, 1.6, 20_000),
        "tension_crack.distance_behind_crest": generator.uniform(0, 12, 20_000),
    }
    one = case.evaluate(inputs)
    two = case.evaluate(inputs, threads=2)
    backwards = case.evaluate({name: values[::-1] for name, values in inputs.items()})
    assert len(one.causes) > 1
    for other, order in ((two, 1), (backwards, -1)):
        np.testing.assert_array_equal(other.factor_of_safety[::order], one.factor_of_safety)
        np.testing.assert_array_equal(other.failure[::order], one.failure)
        assert other.causes == one.causes


def test_limiting_friction_of_stepped_bases(cases):
    case = delabole.read(cases / "stepped_base/appendix_a.toml")
    name = next(name for name in case.inputs if name.endswith("height"))
    values = case.inputs[name] * np.linspace(0.9, 1.1, 5)
    limits = case.evaluate({name: values}, "limiting_friction_angle").limiting_friction_angle
    for value, limit in zip(values, limits):
        changed = case.evaluate({name: value}, ["limiting_friction_angle"])
        assert changed.limiting_friction_angle.shape == ()
        assert changed.limiting_friction_angle == limit
    assert limits[2] == case.run().limiting_friction_angle


def test_every_model_can_be_asked(cases):
    asked = {
        "single_block": "tilt", "block_row": "tilt", "stepped_base": None, "flexural_toppling": None,
    }
    for folder in asked:
        case = delabole.read(sorted((cases / folder).glob("*.toml"))[0])
        name, value = next(iter(case.inputs.items()))
        outputs = list(case.outputs)[:3]
        evaluation = case.evaluate({name: [value, value]}, outputs)
        for output in outputs:
            assert evaluation[output][0] == evaluation[output][1] or evaluation.failure.all()


def test_wrong_names_and_shapes_are_refused(case):
    with pytest.raises(KeyError, match="no input 'strength.frction_angle'"):
        case.evaluate({"strength.frction_angle": 0.5})
    with pytest.raises(KeyError, match="no output 'factor'"):
        case.evaluate({"strength.friction_angle": 0.5}, "factor")
    with pytest.raises(ValueError, match="shape"):
        case.evaluate({"strength.friction_angle": [0.5, 0.6], "water.water_depth": [1, 2, 3]})
    with pytest.raises(KeyError, match="did you mean strength.friction_angle"):
        case.evaluate({"strength.frction_angle": 0.5})
    with pytest.raises(ValueError, match="strength.friction_angle = '30 kPa'"):
        case.evaluate({"strength.friction_angle": ["30 kPa"]})
    assert case.evaluate({"strength.friction_angle": []}).factor_of_safety.shape == (0,)


def test_texts_have_units(case):
    texts = case.evaluate({"strength.friction_angle": ["30 deg", np.radians(40)], "water.water_depth": "1 m"})
    numbers = case.evaluate({"strength.friction_angle": np.radians([30, 40]), "water.water_depth": 1})
    np.testing.assert_array_equal(texts.factor_of_safety, numbers.factor_of_safety)


def test_a_datum_changes_no_factor(cases):
    # Its elevations are asked for by another way than the factor alone.
    case = delabole.read(cases / "plane_failure/fig_2_8.toml")
    assert "slope.toe_elevation" in case.inputs
    inputs = {
        "slope.toe_elevation": case.inputs["slope.toe_elevation"] + np.linspace(-3, 3, 7)[:, None],
        "strength.friction_angle": np.radians([20, 25]),
    }
    both = case.evaluate(inputs, ["factor_of_safety", "crack_base_elevation"])
    alone = case.evaluate(inputs)
    np.testing.assert_array_equal(both.factor_of_safety, alone.factor_of_safety)
    np.testing.assert_array_equal(both.failure, alone.failure)
    assert both["crack_base_elevation"].shape == (7, 2)


@pytest.mark.parametrize("name", ["starting/support", "plane_failure/bolted_road_cut", "stepped_base/bolted_columns"])
def test_a_case_that_designs_its_support_is_evaluated_with_it(cases, name):
    case = delabole.read(cases / f"{name}.toml")
    assert case.evaluate({}).factor_of_safety == case.run().factor_of_safety
    rows = case.evaluate({"support[1].rows": [1, 2]}).factor_of_safety
    assert rows.shape == (2,)


def test_samples_are_those_of_the_program(cases):
    case = delabole.read(cases / "plane_failure/sau_mau_ping_probability.toml")
    found = case.sensitivity()
    samples = case.sample()
    assert set(samples) <= set(case.inputs)
    factors = case.evaluate(samples).factor_of_safety
    propagation = found["propagation"]
    assert factors.size == propagation["samples"]
    assert np.sum(factors < 1) == propagation["failure"]["failed"]
    assert [factors.min(), factors.max()] == [propagation["least"], propagation["greatest"]]
    again = case.sample(1000, method="monte_carlo", seed=7)
    assert {values.shape for values in again.values()} == {(1000,)}
    np.testing.assert_array_equal(again["strength.cohesion"],
                                  case.sample(1000, method="monte_carlo", seed=7)["strength.cohesion"])
    with pytest.raises(ValueError, match="no method"):
        case.sample(method="guessing")
    with pytest.raises(ValueError, match="samples must be from 1"):
        case.sample(0)
