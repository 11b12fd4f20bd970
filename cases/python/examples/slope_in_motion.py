"""The columns of Goodman & Bray's slope with too little friction, in motion; drawn where matplotlib is installed."""

import sys

import numpy as np

import delabole

try:
    import matplotlib  # type: ignore[import]

    matplotlib.use("agg")
    from matplotlib import pyplot
except ImportError:
    pyplot = None

picture = sys.argv[1] if len(sys.argv) > 1 else "slope_in_motion.png"
model = delabole.read("cases/relaxation/goodman_bray_1976.toml").model
assert isinstance(model, delabole.Relaxation) and isinstance(model.scene, delabole.RelaxationColumns)
model.scene.interface.friction_angle = model.scene.base.friction_angle = "33 deg"
model.settings = delabole.RelaxationNumerics(start="dropped", stop="duration", duration="8 s")
simulation = delabole.Simulation(model)
fixed = simulation.fixed
moments = []
for time in (1, 2, 4, 6):
    simulation.run(until=time)
    # A contact's force acts on the first of its two blocks. If that block is fixed, the force is reversed, so that all
    # forces act on the moving blocks.
    signs = np.where(fixed[simulation.contact_blocks[:, 0]], -1, 1)[:, None]
    moments.append((simulation.outlines, simulation.contact_points, simulation.contact_forces * signs))
    turned = np.degrees(simulation.rotations.max())
    print(f"{simulation.time:.1f} s: a column has turned by {turned:.1f} deg, {simulation.outcome}")
for number, movement in enumerate(simulation.movements[: np.count_nonzero(~fixed)], start=1):
    print(f"column {number} {movement}")

if pyplot is not None:
    sine, cosine = np.sin(simulation.tilt), np.cos(simulation.tilt)
    upright = np.array([[cosine, sine], [-sine, cosine]])
    figure, axes = pyplot.subplots(2, 2, sharex=True, sharey=True, figsize=(11, 8), layout="constrained")
    for axis, (outlines, points, forces), time in zip(axes.ravel(), moments, (1, 2, 4, 6)):
        for outline, is_fixed in zip(outlines, fixed):
            axis.fill(*(outline @ upright).T, facecolor="#bdb5a4" if is_fixed else "#e8e2d4", edgecolor="#333333")
        axis.quiver(*(points @ upright).T, *(forces @ upright).T, color="#b03a2e", width=0.003, scale=4e7)
        axis.set(title=f"{time} s", aspect="equal", xlabel="x (m)", ylabel="y (m)")
    figure.suptitle("Columns on a stepped base at 33 deg of friction, and the forces on their corners")
    figure.savefig(picture, dpi=110)
    print("drawn in", picture)
