"""Fig 2.8 of the thesis, plane failure of the west face: what friction and water level do to it, in ten lines."""

import sys

import numpy as np

import delabole

case = delabole.read(sys.argv[1] if len(sys.argv) > 1 else "cases/plane_failure/fig_2_8.toml")
friction = np.radians([15, 20, 25, 30])
depth = np.array([0, 1 / 2, 2 / 3]) * 48.4529  # m of water in the crack
answer = case.evaluate({"strength.friction_angle": friction[:, None], "water.water_depth": depth})
print("friction  dry    half   two thirds full")
for angle, row in zip(friction, answer.factor_of_safety):
    print(f"{np.degrees(angle):4.0f} deg  ", "  ".join(f"{factor:.3f}" for factor in row))
