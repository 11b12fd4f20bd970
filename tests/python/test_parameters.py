"""Models as classes: what they take, give back and refuse."""

import math

import delabole
import numpy as np
import pytest


def slope(**changes):
    given = dict(
        slope={"height": "12 m", "face_dip": "60 deg", "upper_surface_dip": "0 deg"},
        failure_plane={"dip": "35 deg"},
        rock={"unit_weight": "26 kN/m3"},
        strength={"kind": "coulomb", "cohesion": "25 kPa", "friction_angle": "37 deg"},
        water={"kind": "dry"},
    )
    return delabole.PlaneFailure(**{**given, **changes})


def test_numbers_are_given_back_in_si():
    model = slope()
    assert model.slope.height == 12
    assert model.strength.cohesion == 25e3
    # As the reader of case files computes it.
    assert model.strength.friction_angle == 37 * (math.pi / 180)


def test_si_numbers_and_texts_mean_the_same():
    assert slope(failure_plane={"dip": 35 * (math.pi / 180)}) == slope()
    assert slope(failure_plane=delabole.FailurePlane(dip="35 deg")) == slope()
    assert slope(failure_plane={"dip": "36 deg"}) != slope()


def test_si_numbers_keep_every_bit():
    dip = 0.6108652381980154
    model = slope(failure_plane={"dip": dip})
    assert model.case().inputs["failure_plane.dip"] == dip


def test_arrays_of_one_number_are_that_number():
    # As an integer numpy hands out the whole part of an array.
    model = slope(failure_plane={"dip": np.array(0.6457)}, rock={"unit_weight": np.float64(25.5e3)})
    assert model.failure_plane.dip == 0.6457
    assert model.rock.unit_weight == 25.5e3
    model.slope.height = np.array(12.75)
    assert model.case().inputs["slope.height"] == 12.75
    for given in (np.array([12.75]), np.array([12, 13]), np.array([])):
        with pytest.raises(TypeError, match="one number is needed, not an array"):
            model.slope.height = given
    with pytest.raises(delabole.CaseError, match="height"):
        model.slope.height = 10**30


def test_attributes_can_be_changed():
    model = slope()
    before = model.run().factor_of_safety
    model.strength.cohesion = "30 kPa"
    assert model.strength.cohesion == 30e3
    assert model.run().factor_of_safety > before
    model.strength = delabole.SteppedSurface(cohesion=0, friction_angle="20 deg", roughness_angle="40 deg")
    assert model.to_dict()["strength"]["kind"] == "stepped_surface"


def test_what_is_wrong_is_said_in_the_words_of_the_reader():
    with pytest.raises(delabole.CaseError, match=r'SlopeSection: height = "-3 m": must be more than 0 and at most'):
        delabole.SlopeSection(height="-3 m", face_dip="60 deg", upper_surface_dip="0 deg")
    with pytest.raises(ValueError, match="unit"):
        delabole.FailurePlane(dip="35 stones")
    with pytest.raises(delabole.CaseError, match="FailurePlane: dip"):
        delabole.FailurePlane(dip="35 m")
    with pytest.raises(delabole.CaseError, match="dip"):
        delabole.FailurePlane(dip=math.nan)
    with pytest.raises(delabole.CaseError, match="must be one of coulomb, "):
        slope(strength={"kind": "glue"})
    with pytest.raises(delabole.CaseError, match='must be an angle, e.g. "40 deg"'):
        delabole.FailurePlane(dip=[1, 2])
    with pytest.raises(TypeError, match="not object"):
        delabole.FailurePlane(dip=object())
    with pytest.raises(TypeError, match="array"):
        delabole.FailurePlane(dip=np.array([0.1, 0.2]))
    with pytest.raises(delabole.CaseError, match=r'"1e\+40 rad": must be between 0 and 90 deg'):
        delabole.FailurePlane(dip=10**40)
    with pytest.raises(UnicodeEncodeError):
        delabole.FailurePlane(dip="\ud800")
    with pytest.raises(TypeError, match="keys of a case are texts"):
        slope().case(fit={3: "starts"})


def test_unknown_and_missing_keys_are_refused():
    with pytest.raises(TypeError, match="hight"):
        slope(slope={"hight": "12 m", "face_dip": "60 deg", "upper_surface_dip": "0 deg"})
    with pytest.raises(TypeError, match="dip"):
        delabole.FailurePlane()
    with pytest.raises(AttributeError, match="has no cohesoin; it has cohesion, friction_angle"):
        slope().strength.cohesoin = 1
    with pytest.raises(TypeError, match="PlaneFailure.rock must be Rock"):
        slope(rock=26e3)


def test_what_concerns_several_values_is_refused_with_all_problems():
    model = slope(tension_crack={"dip": "90 deg", "distance_behind_crest": "4 m", "depth": "2 m"})
    with pytest.raises(delabole.CaseError, match="takes only one of") as refused:
        model.run()
    assert [key for _, _, _, key, _, _ in refused.value.problems] == ["tension_crack"]
    with pytest.raises(delabole.CaseError, match="failure_plane.dip"):
        slope(failure_plane={"dip": "70 deg"}).run()


def test_every_class_says_what_its_keys_mean():
    assert "friction_angle" in delabole.Coulomb.__doc__
    assert "from 0 to 89.9 deg" in delabole.Coulomb.__doc__
    for model in delabole.MODELS.values():
        assert all(field.key in model.__doc__ for field in model._fields)
    assert delabole.MODELS["plane_failure"] is delabole.PlaneFailure


CASES = [
    "plane_failure/fig_2_8", "plane_failure/wyllie_mah_7_1_bolts", "plane_failure/sau_mau_ping_critical_crack",
    "stepped_base/goodman_bray_1976_cable", "stepped_base/water_wedge_cable", "relaxation/bonded_cantilever",
    "relaxation/newmark_block", "relaxation/strength_reduction", "relaxation/retreating_slope",
    "delabole_1967/delabole_1967", "delabole_1967/delabole_joint_sets",
]


@pytest.mark.parametrize("name", CASES)
def test_models_of_case_files_become_objects_and_back(cases, name):
    case = delabole.read(cases / f"{name}.toml")
    again = case.model.case()
    assert again._case.model_tree == case._case.model_tree
    assert again.model == case.model


def test_every_model_of_the_cases_can_be_read(cases):
    kinds = set()
    for path in sorted(cases.glob("*/*.toml")):
        kinds.add(type(delabole.read(path).model).__name__)
    # One of each model, or the test sees less than it says.
    assert kinds == {model.__name__ for model in delabole.MODELS.values()}
