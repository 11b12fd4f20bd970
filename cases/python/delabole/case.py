"""Cases: what stands in a case file, or is put together in Python, and what can be asked of it."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _delabole
from .fields import Quantity, Section
from .results import Evaluation, Fit, Result, Sensitivity

Told = Optional[Callable[[float, str], None]]
Progress = Union[Told, bool]
Settings = Mapping[str, Quantity]


class Case:
    """A case, as it was read: it does not change.

    Made by read(), parse(), case() and Model.case(). Long work tells its progress by calling progress(share, what),
    share from 0 to 1, or with progress=True by a line on the screen, lets other threads of Python run, and ends at Ctrl-C with KeyboardInterrupt.
    """

    def __init__(self, made: _delabole.Case) -> None:
        self._case = made

    def __repr__(self) -> str:
        return f"<delabole.Case {self.name!r} of model {self._case.model_name}>"

    def __reduce__(self) -> tuple[Callable[[str, str], Case], tuple[str, str]]:
        return parse, (self.to_toml(), self.name)

    @property
    def name(self) -> str:
        """Of the file, or as it was given."""
        return self._case.name

    @property
    def title(self) -> str:
        return self._case.title

    @property
    def description(self) -> str:
        return self._case.description

    @property
    def hash(self) -> str:
        """Equal for cases that mean the same."""
        return self._case.hash

    @property
    def model(self) -> Model:
        """The case's model, as an object of its own: to be changed and asked again."""
        from .models import MODELS

        tree = dict(self._case.model_tree)
        return MODELS[tree.pop("model")](**tree)

    @property
    def inputs(self) -> dict[str, float]:
        """Numbers by name, in SI: what can be varied."""
        return {name: value for name, _, _, value in self._case.inputs}

    @property
    def outputs(self) -> dict[str, str]:
        """Meanings of what evaluate() answers, by name."""
        return {name: meaning for name, _, meaning, _ in self._case.outputs}

    def to_toml(self) -> str:
        """The case as a file, with every default written out."""
        return self._case.toml

    def check(self) -> None:
        """Raises CaseError for what can be said against the case before it is run."""
        self._case.check()

    def run(self, *, threads: int = 1, progress: Progress = None) -> Result:
        """What `delabole run` answers, to the last bit. CaseError for a slope that cannot be."""
        return Result(self._case.run(told_to(progress), threads))

    def fit(self, *, threads: int = 1, seed: int | None = None, mechanisms: Iterable[str] = (),
            with_costly: bool = False, progress: Progress = None) -> Fit:
        """The back-analysis that the case's section fit asks for.

        mechanisms: the only ones to be fitted; with_costly: also those whose every prediction is a run of dynamic
        relaxation. The answer does not depend on threads.
        """
        return Fit(self._case.fit(told_to(progress), threads, seed, list(mechanisms), with_costly))

    def sensitivity(self, *, threads: int = 1, seed: int | None = None, progress: Progress = None) -> Sensitivity:
        """The study that the case's section sensitivity asks for."""
        return Sensitivity(self._case.sensitivity(told_to(progress), threads, seed))

    def sample(self, samples: int | None = None, *, method: str | None = None,
               seed: int | None = None) -> dict[str, npt.NDArray[np.float64]]:
        """Samples of the uncertain parameters of the case's section sensitivity, by name and in SI, for evaluate().

        Without arguments they are those of its propagation. method: monte_carlo, latin_hypercube or sobol_sequence.
        Their number is raised to the next one that the replicates share evenly.
        """
        return self._case.sample(samples, method, seed)

    def _numbers(self, name: str, values: npt.ArrayLike) -> npt.NDArray[np.float64]:
        array = np.asarray(values)
        if array.dtype.kind not in "OU":
            return array.astype(np.float64)
        each = np.asarray(values, dtype=object)
        read = [self._case.input_value(name, one) if isinstance(one, str) else float(one) for one in each.ravel()]
        return np.array(read, dtype=np.float64).reshape(each.shape)

    def evaluate(self, inputs: Mapping[str, npt.ArrayLike], outputs: str | Iterable[str] = "factor_of_safety", *,
                 threads: int = 1, progress: Progress = None) -> Evaluation:
        """The model at many points: inputs by name, numbers or arrays that numpy can broadcast together.

        Numbers are in SI, texts have their unit: "30 deg". A point without an answer is NaN, and Evaluation.failures
        says why. What inputs do not set is as in run(): of a case with support_design the support that is designed for
        its own values.
        """
        arrays = {name: self._numbers(name, values) for name, values in inputs.items()}
        shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
        columns = {name: np.ascontiguousarray(np.broadcast_to(array, shape)).ravel() for name, array in arrays.items()}
        asked = [outputs] if isinstance(outputs, str) else list(outputs)
        count = int(np.prod(shape))
        answers, failures, causes = self._case.evaluate(columns, count, asked, told_to(progress), threads)
        shaped = {name: answer.reshape(shape) for name, answer in zip(asked, answers)}
        return Evaluation(shaped, failures.reshape(shape), causes)


class Model(Section):
    """A model with its parameters; the classes of the models are made from the keys of case files."""

    def case(self, title: str = "", **sections: Any) -> Case:
        """A case of this model, with sections as in a case file: fit={...}, sensitivity={...}, expect=[...]."""
        return case({**self._tree(), "title": title, **sections}, name=type(self).__name__)

    def run(self, *, threads: int = 1, progress: Progress = None) -> Result:
        """See Case.run."""
        return self.case().run(threads=threads, progress=progress)

    def evaluate(self, inputs: Mapping[str, npt.ArrayLike], outputs: str | Iterable[str] = "factor_of_safety", *,
                 threads: int = 1, progress: Progress = None) -> Evaluation:
        """See Case.evaluate."""
        return self.case().evaluate(inputs, outputs, threads=threads, progress=progress)


def told_to(progress: Progress) -> Told:
    """The function that is told of progress; for True one that keeps a line on the screen."""
    if isinstance(progress, bool):
        return _show_progress if progress else None
    return progress


def _show_progress(share: float, what: str) -> None:
    # What is printed next begins where this line does.
    print(f"{what}: {100 * share:3.0f} %", end="\r", file=sys.stderr, flush=True)


def _texts(settings: Settings) -> dict[str, str]:
    return {key: value if isinstance(value, str) else repr(float(value)) for key, value in settings.items()}


def read(path: str | os.PathLike[str], settings: Settings = {}) -> Case:
    """Reads a case file; settings take the place of what it says: {"strength.friction_angle": "35 deg"}.

    CaseError with everything that is wrong, each with its line.
    """
    return Case(_delabole.Case.read(os.fspath(path), _texts(settings)))


def parse(text: str, name: str = "case", settings: Settings = {}) -> Case:
    """The same of text; name stands for the file in messages."""
    return Case(_delabole.Case.parse(text, name, _texts(settings)))


def case(tree: Mapping[str, Any], name: str = "case") -> Case:
    """The same of a dictionary with the keys of a case file; its model may be an object: {"model": PlaneFailure(...)}.

    `schema = 1` need not be given.
    """
    return Case(_delabole.Case.of_tree(_tree_of(tree), name))


def _tree_of(tree: Mapping[str, Any]) -> dict[str, Any]:
    made: dict[str, Any] = {"schema": 1}
    for key, value in tree.items():
        if isinstance(value, Model) and key == "model":
            made.update(value._tree())
        else:
            made[key] = _plain(value)
    return made


def _plain(value: Any) -> Any:
    if isinstance(value, Section):
        return value._tree()
    if isinstance(value, Mapping):
        return {key: _plain(inner) for key, inner in value.items()}
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(inner) for inner in value]
    return value
