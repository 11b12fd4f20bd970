"""Cases are read and answered as by the program, to the last bit."""

import copy
import json
import os
import pickle
import subprocess
import sys

import delabole
import pytest

CASES = [
    "plane_failure/fig_2_8", "plane_failure/sau_mau_ping_critical_crack", "stepped_base/goodman_bray_1976_cable",
    "single_block/*", "block_row/*", "flexural_toppling/*", "relaxation/free_slide", "relaxation/two_blocks_3", "plane_failure/bolted_road_cut",
    "delabole_1967/delabole_joint_sets",
]


def asked(program, folder, *words):
    """What the program prints as JSON."""
    made = subprocess.run([program, *map(str, words), "--json", "--no-report", "--out", folder / "result"],
                          capture_output=True, check=True, cwd=folder)
    answer = json.loads(made.stdout)
    del answer["provenance"]
    return answer


@pytest.mark.parametrize("pattern", CASES)
def test_a_run_answers_what_the_program_answers(cases, program, tmp_path, pattern):
    path = sorted(cases.glob(f"{pattern}.toml"))[0]
    result = delabole.read(path).run()
    assert result.to_json() == asked(program, tmp_path, "run", path)
    # The same numbers by name in SI.
    assert set(result.to_dict()) == set(result)


def test_answers_are_printed_in_the_words_of_a_report(cases):
    design = delabole.read(cases / "plane_failure/bolted_road_cut.toml").run()
    assert str(design).startswith(f"With these bolts FS {design.factor_of_safety:.3g}") and "without these bolts" in str(design)
    fit = delabole.read(cases / "starting/fit.toml").fit()
    assert str(fit).endswith(fit.mechanisms[0].verdict)
    study = delabole.read(cases / "delabole_1967/sensitivity_critical_sliding.toml").sensitivity()
    assert str(study).splitlines() == study["findings"]


def test_settings_take_the_place_of_what_the_file_says(cases, program, tmp_path):
    path = cases / "plane_failure/fig_2_8.toml"
    case = delabole.read(path, {"strength.friction_angle": "25 deg", "water.water_depth": "20 m"})
    assert case.run().to_json() == asked(program, tmp_path, "run", path, "--set", "strength.friction_angle=25 deg",
                                         "--set", "water.water_depth=20 m")


def test_settings_that_are_wrong_are_called_settings(cases):
    with pytest.raises(delabole.CaseError, match="^settings: slope.height"):
        delabole.read(cases / "plane_failure/fig_2_8.toml", {"slope.height": "12 deg"})


def test_answers_have_names_meanings_and_si_numbers(cases):
    result = delabole.read(cases / "plane_failure/fig_2_8.toml").run()
    assert result.status == "ok"
    assert result.factor_of_safety == result["factor_of_safety"] == pytest.approx(1, abs=1e-4)
    assert result.crack_location == "face"
    assert result.meaning("weight") == "weight of the sliding mass"
    assert result.to_json()["results"]["weight_kN_per_m"] == result.weight / 1e3
    with pytest.raises(AttributeError):
        result.factor_of_saftey


def test_mistakes_in_files_are_told_with_their_lines(tmp_path):
    path = tmp_path / "slope.toml"
    path.write_text('schema = 1\nmodel = "plane_failure"\n[slope]\nheight = "-3 m"\nwidht = 1\n')
    with pytest.raises(delabole.CaseError) as refused:
        delabole.read(path)
    assert f'{path}:4:10: slope.height = "-3 m"' in str(refused.value)
    files, lines, _, keys, _, _ = zip(*refused.value.problems)
    assert set(files) == {str(path)}
    assert {"slope.height", "slope.widht", "failure_plane"} <= set(keys)
    assert lines[keys.index("slope.widht")] == 5
    with pytest.raises(delabole.CaseError, match="no such file|cannot be read|does not exist"):
        delabole.read(tmp_path / "nowhere.toml")


def test_texts_and_dictionaries_are_cases_too(cases):
    text = (cases / "plane_failure/failure_locus.toml").read_text()
    case = delabole.parse(text)
    made = delabole.case({"model": case.model, "title": case.title})
    assert made.title == "FS = 1 locus: straight in (tan phi, c)"
    assert made.run().to_dict() == case.run().to_dict()
    again = delabole.parse(case.to_toml())
    assert again.hash == case.hash
    with pytest.raises(TypeError, match="not object"):
        delabole.case({"model": case.model, "fit": object()})
    with pytest.raises(delabole.CaseError, match="is not an input"):
        case.model.case(fit={"parameter": [{"name": "strenght", "lower": 0, "upper": 1}]})


def test_cases_and_models_can_be_copied_and_pickled(cases):
    case = delabole.read(cases / "plane_failure/fig_2_8.toml")
    again = pickle.loads(pickle.dumps(case))
    assert (again.hash, again.name) == (case.hash, case.name)
    model = case.model
    copied = copy.deepcopy(model)
    assert pickle.loads(pickle.dumps(model)) == copied == model
    copied.strength.cohesion = 0
    assert copied != model


def test_what_the_case_has_not_is_said(cases):
    case = delabole.read(cases / "plane_failure/fig_2_8.toml")
    with pytest.raises(delabole.CaseError, match=r"no \[fit\] section"):
        case.fit()
    with pytest.raises(delabole.CaseError, match=r"no \[sensitivity\] section"):
        case.sensitivity()
    with pytest.raises(delabole.CaseError, match=r"no \[sensitivity\] section"):
        case.sample()


def test_a_decimal_comma_of_the_process_changes_nothing(cases, tmp_path):
    subprocess.run(["localedef", "--inputfile=de_DE", "--charmap=UTF-8", tmp_path / "de_DE.UTF-8"], check=True)
    answer = """
import locale, sys
locale.setlocale(locale.LC_ALL, sys.argv[1])
import delabole
case = delabole.read(sys.argv[2])
print(locale.str(1.5) if sys.argv[1] != "C" else "1,5", case.run().to_dict(), case.to_toml())
"""
    told = [
        subprocess.run([sys.executable, "-c", answer, language, cases / "plane_failure/fig_2_8.toml"], check=True,
                       capture_output=True, text=True, env={**os.environ, "LOCPATH": str(tmp_path)}).stdout
        for language in ("de_DE.UTF-8", "C")
    ]
    assert told[0].startswith("1,5 ")
    assert told[0] == told[1]
