"""What cases answer: numbers in SI, words, and arrays."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any, Union

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Answer = Union[float, str]


class _Named:
    """Answers whose names begin with the same words: result.critical.tilt is result["critical.tilt"]."""

    def __init__(self, values: Mapping[str, Answer], prefix: str = "") -> None:
        self._values = values
        self._prefix = prefix

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        full = self._prefix + name
        if full in self._values:
            return self._values[full]
        if any(key.startswith(full + ".") for key in self._values):
            return _Named(self._values, full + ".")
        raise AttributeError(f"there is no answer {full!r}")

    def __dir__(self) -> list[str]:
        names = (key[len(self._prefix):] for key in self._values if key.startswith(self._prefix))
        return sorted({*super().__dir__(), *(name.split(".")[0] for name in names if "[" not in name)})


class Result(_Named):
    """What a run answers: result.factor_of_safety, or result["block[1].rotation"]; a number in SI, or a word."""

    def __init__(self, made: dict[str, Any]) -> None:
        super().__init__(made["values"])
        self._meanings: dict[str, tuple[str, str]] = made["meanings"]
        self._json: str = made["json"]
        self.status: str = made["status"]
        self.unfinished: str = made["unfinished"]
        self.warnings: list[str] = made["warnings"]
        self.sentences: list[str] = made["sentences"]
        """The answer in words, as a report begins."""

    def __getitem__(self, name: str) -> Answer:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __repr__(self) -> str:
        return f"<delabole.Result {self.status}, {len(self)} answers>"

    def __str__(self) -> str:
        return "\n".join(self.sentences)

    def meaning(self, name: str) -> str:
        """Of an answer, in words."""
        return self._meanings[name][1]

    def to_dict(self) -> dict[str, Answer]:
        """All answers by name, numbers in SI."""
        return dict(self._values)

    def to_json(self) -> dict[str, Any]:
        """What `delabole run --json` prints, without the provenance: names carry units, as crack_depth_m."""
        return dict(json.loads(self._json))


class Evaluation(Mapping[str, Array]):
    """Outputs of many points: evaluation["factor_of_safety"] has the shape of the inputs."""

    def __init__(self, arrays: dict[str, Array], failure: npt.NDArray[np.int16], causes: list[str]) -> None:
        self._arrays = arrays
        self.failure = failure
        """Of each point: 0, or the place of its cause of failure in `causes`, counted from 1."""
        self.causes = causes

    @property
    def failures(self) -> dict[str, int]:
        """How many points have no answer, by cause."""
        counts = np.bincount(self.failure.ravel(), minlength=len(self.causes) + 1)
        return {cause: int(count) for cause, count in zip(self.causes, counts[1:])}

    def __getitem__(self, name: str) -> Array:
        return self._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def __getattr__(self, name: str) -> Array:
        try:
            return self.__dict__["_arrays"][name]  # type: ignore[no-any-return]
        except KeyError:
            raise AttributeError(name) from None


class ProfileLikelihood:
    """Least misfit as a function of one parameter, the others free."""

    def __init__(self, made: dict[str, Any]) -> None:
        self.parameter: str = made["parameter"]
        self.with_priors: bool = made["with_priors"]
        self.values: Array = made["values"]
        self.misfits: Array = made["misfits"]
        self.interval_68: tuple[float, float] = made["interval_68"]
        self.interval_95: tuple[float, float] = made["interval_95"]
        self.determination: str = made["determination"]
        self.lower_bounded_by: list[str] = made["lower_bounded_by"]
        self.upper_bounded_by: list[str] = made["upper_bounded_by"]


class FailureLocus:
    """Points in the plane of two parameters at which the factor of safety is 1."""

    def __init__(self, made: dict[str, Any]) -> None:
        self.x: str = made["x"]
        self.y: str = made["y"]
        self.points: Array = made["points"]
        self.branches: npt.NDArray[np.int32] = made["branches"]


class MisfitMap:
    """Misfit over the plane of the first two free parameters: a row for each y, a column for each x."""

    def __init__(self, made: dict[str, Any]) -> None:
        self.x: str = made["x"]
        self.y: str = made["y"]
        self.x_values: Array = made["x_values"]
        self.y_values: Array = made["y_values"]
        self.misfit: Array = made["misfit"]
        self.level_68: float = made["level_68"]
        self.level_95: float = made["level_95"]


class Posterior:
    """Draws of the parameters given the data, and the evidence."""

    def __init__(self, made: dict[str, Any]) -> None:
        self.status: str = made["status"]
        self.warnings: list[str] = made["warnings"]
        self.chains: dict[str, Array] = made["chains"]
        """By parameter, and the misfit of the data: chains by draws, as ArviZ takes them."""
        self.correlation: Array = made["correlation"]
        self.log_evidence: float = made["log_evidence"]
        self.log_evidence_error: float = made["log_evidence_error"]

    @property
    def draws(self) -> dict[str, Array]:
        """All chains one after the other, with the number of the chain: columns, as pandas takes them."""
        columns = {name: chains.ravel() for name, chains in self.chains.items()}
        count, length = self.chains["misfit"].shape
        return {"chain": np.repeat(np.arange(float(count)), length), **columns}


class MechanismFit:
    """One mechanism fitted to what was observed; parameters in SI."""

    def __init__(self, made: dict[str, Any]) -> None:
        self.name: str = made["name"]
        self.title: str = made["title"]
        self.status: str = made["status"]
        self.verdict: str = made["verdict"]
        """What the data determine, in words: to be read before the best point."""
        self.rank: int = made["rank"]
        self.best: dict[str, float] = made["best"]
        self.misfit: float = made["misfit"]
        self.data_misfit: float = made["data_misfit"]
        self.prior_misfit: float = made["prior_misfit"]
        self.profile: Array = made["profile"]
        """Ground left standing at the best point."""
        self.explained: list[str] = made["explained"]
        self.unexplained: list[str] = made["unexplained"]
        self.profiles = [ProfileLikelihood(one) for one in made["profiles"]]
        self.failure_loci = [FailureLocus(one) for one in made["failure_loci"]]
        self.misfit_map = None if made["misfit_map"] is None else MisfitMap(made["misfit_map"])
        self.posterior = None if made["posterior"] is None else Posterior(made["posterior"])
        self.probability: float | None = made["probability"]
        """Of this mechanism, one of those fitted being true; None where no posterior was asked for."""

    def __repr__(self) -> str:
        return f"<delabole.MechanismFit {self.name!r}: {self.status}>"


class Fit:
    """A back-analysis: its mechanisms, the most probable first."""

    def __init__(self, made: dict[str, Any]) -> None:
        self._json: str = made["json"]
        self.status: str = made["status"]
        self.left_out: list[str] = made["left_out"]
        """Costly mechanisms that were not fitted."""
        self.mechanisms = [MechanismFit(one) for one in made["mechanisms"]]

    def __getitem__(self, name: str) -> MechanismFit:
        for mechanism in self.mechanisms:
            if mechanism.name == name:
                return mechanism
        raise KeyError(name)

    def __repr__(self) -> str:
        return f"<delabole.Fit {self.status}: {', '.join(mechanism.name for mechanism in self.mechanisms)}>"

    def __str__(self) -> str:
        return "\n".join(f"{mechanism.title or mechanism.name}: {mechanism.verdict}" for mechanism in self.mechanisms)

    def to_dict(self) -> dict[str, Any]:
        """What `delabole fit --json` prints, without the provenance: names carry units."""
        return dict(json.loads(self._json))


class Sensitivity:
    """A sensitivity study: what its methods found, as `delabole sensitivity --json` prints it."""

    def __init__(self, made: dict[str, Any]) -> None:
        self._found: dict[str, Any] = json.loads(made["json"])
        self.status: str = made["status"]
        self.cumulative: Array | None = made["cumulative"]
        """Rows of value (SI) and share of the samples not above it; None without propagation."""

    def __getitem__(self, key: str) -> Any:
        return self._found[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._found)

    def __repr__(self) -> str:
        return f"<delabole.Sensitivity {self.status}>"

    def __str__(self) -> str:
        return "\n".join(self._found["findings"])

    def to_dict(self) -> dict[str, Any]:
        return dict(self._found)
