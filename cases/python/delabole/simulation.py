"""Blocks in motion."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _delabole
from .case import Case, Model, Progress, told_to
from .models import Relaxation, RelaxationJoint, RelaxationPolygon, RelaxationPolygons
from .fields import Quantity


class Simulation(_delabole.Simulation):
    """A run of dynamic relaxation, step by step.

    Its arrays look into the memory of the simulation, without copies and read only. Each keeps showing the moment at
    which it was taken: while one is kept, the next step goes on with a copy, which is the same to the last bit. Section
    axes, SI: x into the slope, y up.
    """

    def __init__(self, model: Union[Case, Model], *, checkpoint: bytes | None = None, threads: int = 1) -> None:
        """checkpoint: bytes that checkpoint() gave for the same model; the run goes on from there bit for bit."""
        super().__init__((model if isinstance(model, Case) else model.case())._case, checkpoint, threads)

    def step(self, count: int = 1) -> int:
        """Makes so many steps, fewer where the run comes to its end. Returns how many."""
        return super().step(count)

    def run(self, until: float | None = None, *, progress: Progress = None) -> int:
        """Steps until there is an outcome, the duration is over or a time (s) is reached. Returns how many steps.

        After Ctrl-C the simulation stands between two steps and can go on.
        """
        return super().run(until, progress=told_to(progress))

    @property
    def positions(self) -> npt.NDArray[np.float64]:
        """Of the centroids: where they were in the initial geometry, and how far they have moved since."""
        return self.centroids + self.displacements

    def __repr__(self) -> str:
        return f"<delabole.Simulation of {len(self.rotations)} blocks, {self.outcome} after {self.steps} steps>"


def blocks(outlines: Sequence[npt.ArrayLike], *, joint: Any, density: Quantity, fixed: Sequence[int] = (),
           tilt: Quantity = "0 deg", **sections: Any) -> Relaxation:
    """The model of convex blocks with these outlines: arrays of corners (x, y) in metres, anticlockwise.

    joint: a RelaxationJoint or its keys, of all edges; fixed: indices of the blocks that do not move; further keys, as
    settings and force, are those of Relaxation.
    """
    unknown = [index for index in fixed if index not in range(len(outlines))]
    if unknown:
        raise ValueError(f"fixed: there is no block {unknown[0]}; blocks are counted from 0 to {len(outlines) - 1}")
    made = []
    for index, outline in enumerate(outlines):
        corners = np.asarray(outline, dtype=np.float64)
        if corners.ndim != 2 or corners.shape[1] != 2:
            raise ValueError(f"outline {index} must be an array of corners, two numbers each")
        vertex = [{"x": x, "y": y} for x, y in corners.tolist()]
        made.append(RelaxationPolygon(density=density, hold="fixed" if index in fixed else None, vertex=vertex))
    return Relaxation(scene=RelaxationPolygons(tilt=tilt, joint=[joint], block=made), **sections)
