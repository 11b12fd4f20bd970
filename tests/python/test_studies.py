"""Back-analyses and sensitivity studies: the program's numbers, arrays, progress and Ctrl-C."""

import json
import subprocess
import threading
import time

import conftest
import delabole
import numpy as np
import pytest

SLOPE = delabole.PlaneFailure(
    slope={"height": "12 m", "face_dip": "60 deg", "upper_surface_dip": "0 deg"},
    failure_plane={"dip": "35 deg"},
    tension_crack={"dip": "90 deg", "distance_behind_crest": "4 m"},
    rock={"unit_weight": "26 kN/m3"},
    strength=delabole.Coulomb(cohesion="25 kPa", friction_angle="30 deg"),
    water={"kind": "crack_and_base", "unit_weight": "9.81 kN/m3", "filled_ratio": 0.5},
)


def fitted(**settings):
    return SLOPE.case(
        title="My slope",
        fit={
            "parameter": [
                {"name": "strength.friction_angle", "lower": "20 deg", "upper": "50 deg",
                 "prior": {"mean": "30 deg", "standard_deviation": "3 deg"}},
                {"name": "strength.cohesion", "lower": "0 kPa", "upper": "80 kPa"},
            ],
            "observation": [
                {"label": "it failed", "quantity": "factor_of_safety", "value": 1, "standard_deviation": 0.1},
            ],
            **settings,
        },
    )


@pytest.fixture(scope="module")
def case():
    return fitted(posterior={})


@pytest.fixture(scope="module")
def fit(case):
    return case.fit()


def asked(program, folder, command, case, *words):
    path = folder / "case.toml"
    path.write_text(case.to_toml())
    made = subprocess.run([program, command, path, *words, "--json", "--no-report", "--out", folder / "result"],
                          capture_output=True, check=True)
    answer = json.loads(made.stdout)
    del answer["provenance"]
    return answer


def test_a_fit_finds_what_the_program_finds(case, fit, program, tmp_path):
    assert fit.to_dict() == asked(program, tmp_path, "fit", case)


def test_parameters_profiles_and_loci_are_in_si(fit):
    mechanism = fit["plane_failure"]
    assert mechanism is fit.mechanisms[0] and mechanism.status == fit.status == "converged"
    assert mechanism.rank == 1
    printed = fit.to_dict()["mechanisms"][0]["parameters"]
    assert mechanism.best["strength.cohesion"] / 1e3 == printed["strength.cohesion_kPa"]["best"]
    for profile in mechanism.profiles:
        assert profile.values.shape == profile.misfits.shape
        if profile.with_priors:  # else the least misfit is that of a whole valley
            lowest = profile.values[np.argmin(profile.misfits)]
            assert lowest == pytest.approx(mechanism.best[profile.parameter], rel=1e-3)
    # At every point of the locus the model itself answers 1.
    (locus,) = mechanism.failure_loci
    factors = SLOPE.evaluate({locus.x: locus.points[:, 0], locus.y: locus.points[:, 1]}).factor_of_safety
    np.testing.assert_allclose(factors, 1, atol=1e-6)  # roots are bracketed to 1e-8 of the ranges
    misfits = mechanism.misfit_map
    assert misfits.misfit.shape == (len(misfits.y_values), len(misfits.x_values))
    with pytest.raises(KeyError):
        fit["toppling"]


def test_draws_are_columns_and_chains(fit):
    posterior = fit.mechanisms[0].posterior
    assert set(posterior.chains) == {"strength.friction_angle", "strength.cohesion", "misfit"}
    (count, length), = {chains.shape for chains in posterior.chains.values()}
    assert posterior.draws["chain"].tolist() == np.repeat(np.arange(count), length).tolist()
    np.testing.assert_array_equal(posterior.draws["strength.cohesion"][length:2 * length],
                                  posterior.chains["strength.cohesion"][1])
    # Each draw's misfit is that of the model at its parameters.
    draws = {name: values for name, values in posterior.draws.items() if name.startswith("strength")}
    factors = SLOPE.evaluate(draws).factor_of_safety
    np.testing.assert_allclose(((factors - 1) / 0.1) ** 2, posterior.draws["misfit"], rtol=1e-9, atol=1e-12)
    assert fit.mechanisms[0].probability == 1


def test_a_fit_does_not_depend_on_threads_but_on_its_seed(case, fit):
    assert case.fit(threads=2).to_dict() == fit.to_dict()
    draws, others = (one.mechanisms[0].posterior.draws["misfit"] for one in (fit, case.fit(seed=2)))
    assert not np.array_equal(draws, others)


def test_mechanisms_are_chosen_by_name(cases):
    case = delabole.read(cases / "delabole_1967/delabole_1967.toml",
                         {"fit.starts": "1", "fit.evaluations_per_start": "20"})
    with pytest.raises(ValueError, match="the case has no mechanism 'stepped_slidng'.*stepped_sliding"):
        case.fit(mechanisms=["stepped_slidng"])


def test_conclusions_and_further_measurements_are_judged_too(cases, program, tmp_path):
    case = delabole.read(cases / "delabole_1967/delabole_1967.toml", {"fit.starts": "2"})
    found = case.fit(mechanisms=["stepped_sliding"]).to_dict()
    assert {"value_of_information", "conclusions"} <= set(found)
    assert found == asked(program, tmp_path, "fit", case, "--mechanism", "stepped_sliding")


@pytest.mark.parametrize("name", ["plane_failure/sau_mau_ping_probability", "plane_failure/bolted_road_cut"])
def test_a_study_finds_what_the_program_finds(cases, program, tmp_path, name):
    case = delabole.read(cases / f"{name}.toml")
    found = case.sensitivity()
    assert found.to_dict() == asked(program, tmp_path, "sensitivity", case)
    shares = found.cumulative[:, 1]
    assert (np.diff(shares) >= 0).all() and shares[-1] == 1


def test_progress_is_shown_where_it_is_true(case, capsys):
    case.fit(progress=True)
    shown = capsys.readouterr().err
    assert "plane_failure: " in shown and shown.endswith(" %\r")


def test_progress_is_told_in_the_callers_thread(case):
    told = []
    case.fit(progress=lambda share, what: told.append((share, what, threading.current_thread())))
    shares = [share for share, _, _ in told]
    assert shares == sorted(shares) and 0 <= shares[0] and shares[-1] <= 1
    assert {thread for _, _, thread in told} == {threading.current_thread()}
    assert any(what.startswith("plane_failure: ") for _, what, _ in told)


def test_what_a_callback_raises_ends_the_work():
    class Enough(Exception):
        pass

    def enough(share, what):
        raise Enough(what)

    # By far more starts than can be done before the callback is called.
    with pytest.raises(Enough):
        fitted(starts=100_000).fit(progress=enough)


def test_ctrl_c_ends_the_work_and_python_goes_on():
    # As many evaluations as take half a minute.
    case = fitted(starts=100_000)
    interruption = conftest.Interruption()
    with pytest.raises(KeyboardInterrupt):
        case.fit(progress=interruption.soon)
    assert SLOPE.run().status == "ok"


def test_other_threads_run_meanwhile():
    case = fitted(starts=2000)
    counted = [0]
    over = threading.Event()

    def count():
        while not over.is_set():
            counted[0] += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    before = counted[0]
    case.fit()
    during = counted[0] - before
    over.set()
    other.join()
    # With the lock held it would be 0 or 1.
    assert during > 2
