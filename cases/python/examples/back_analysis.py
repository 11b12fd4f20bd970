"""A back-analysis of a slope of one's own: it failed by sliding, and which friction and cohesion does that allow?"""

import delabole

slope = delabole.PlaneFailure(
    slope={"height": "12 m", "face_dip": "60 deg", "upper_surface_dip": "0 deg"},
    failure_plane={"dip": "35 deg"},
    tension_crack={"dip": "90 deg", "distance_behind_crest": "4 m"},
    rock={"unit_weight": "26 kN/m3"},
    strength=delabole.Coulomb(cohesion="25 kPa", friction_angle="30 deg"),
    water={"kind": "crack_and_base", "unit_weight": "9.81 kN/m3", "filled_ratio": 0.5},
)
case = slope.case(
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
        "posterior": {},
    },
)
fit = case.fit()
mechanism = fit.mechanisms[0]
print("What the data determine:", mechanism.verdict)
for profile in mechanism.profiles:
    if profile.with_priors:
        print(f"{profile.parameter}: best {mechanism.best[profile.parameter]:.4g},"
              f" 95 % from {profile.interval_95[0]:.4g} to {profile.interval_95[1]:.4g} (SI), {profile.determination}")
if mechanism.posterior is not None:
    draws = mechanism.posterior.draws  # pandas.DataFrame(draws) takes them as they are
    for name, values in draws.items():
        print(f"{name}: {len(values)} draws with mean {values.mean():.4g}")
