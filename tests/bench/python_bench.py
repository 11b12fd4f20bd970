"""Processor time on one core of what the Python module does to many slopes in one call."""

import time

import delabole
import numpy as np


def measured(what, case, inputs, output):
    best = float("inf")
    for _ in range(3):
        start = time.process_time()
        evaluation = case.evaluate(inputs, output)
        best = min(best, time.process_time() - start)
    count = evaluation[output].size
    failed = sum(evaluation.failures.values())
    print(f"{what}: {count} in {best:.3f} s, {1e6 * best / count:.3f} us each, {failed} without an answer")


generator = np.random.default_rng(1)
plane = delabole.read("cases/plane_failure/wyllie_mah_7_1.toml")
million = {
    "strength.friction_angle": generator.uniform(0.3, 0.7, 1_000_000),
    "strength.cohesion": generator.uniform(0, 50e3, 1_000_000),
}
measured("factors of safety of plane failure", plane, million, "factor_of_safety")
fig_2_8 = delabole.read("cases/plane_failure/fig_2_8.toml")  # whose toe has an elevation
measured("factors of safety of Fig 2.8", fig_2_8, million, "factor_of_safety")
measured("weights of plane failure, with all that a run computes", plane, million, "weight")
grid = {
    "strength.friction_angle": np.linspace(0.3, 0.7, 1000)[:, None],
    "water.water_depth": np.linspace(0, 3, 1000),
}
measured("a grid of plane failure", plane, grid, "factor_of_safety")
columns = delabole.read("cases/stepped_base/goodman_bray_1976.toml")
inclined = {"columns.joint_dip": np.radians(np.linspace(55, 65, 20_000))}
measured("limiting friction of 16 columns", columns, inclined, "limiting_friction_angle")
