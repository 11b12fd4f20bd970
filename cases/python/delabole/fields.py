"""Sections of cases as classes: what their attributes take and give back.

Numbers are taken as texts with a unit ("30 deg") or as SI numbers, and given back in SI. What is wrong raises CaseError
with the words of the reader of case files.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Generic, TypeVar, Union, overload

from . import _delabole

Quantity = Union[float, str]

Got = TypeVar("Got")
Given = TypeVar("Given")
Own = TypeVar("Own", bound="Field[Any, Any]")


class Field(Generic[Got, Given]):
    """One key of a section."""

    def __init__(self, key: str, meaning: str, *, optional: bool = False) -> None:
        self.key = key
        self.meaning = meaning
        self.optional = optional

    @overload
    def __get__(self: Own, section: None, owner: type[Any]) -> Own: ...

    @overload
    def __get__(self, section: Section, owner: type[Any]) -> Got: ...

    def __get__(self, section: Section | None, owner: type[Any]) -> Any:
        return self if section is None else section._values[self.key]

    def __set__(self, section: Section, value: Given) -> None:
        section._values[self.key] = None if value is None and self.optional else self.taken(section, value)

    def taken(self, section: Section, value: Any) -> Any:
        """What is kept of a value that is given."""
        raise NotImplementedError

    def written(self, value: Any) -> Any:
        """What the reader of cases reads as exactly this value."""
        return value

    def plain(self, value: Any) -> Any:
        """The value without classes."""
        return value


class Number(Field[Got, Given]):
    """A number, in SI."""

    def __init__(self, key: str, meaning: str, dimension: int, unit: str, interval: tuple[float, float, bool, bool],
                 *, optional: bool = False) -> None:
        super().__init__(key, meaning, optional=optional)
        self.dimension = dimension
        self.unit = unit
        self.interval = interval

    def taken(self, section: Section, value: Any) -> float:
        return _delabole.number(type(section).__name__, self.key, value, self.dimension, self.interval)

    def written(self, value: float) -> Quantity:
        return f"{value!r} {self.unit}" if self.unit else value


class Word(Field[Got, Given]):
    """One of a few words."""

    def __init__(self, key: str, meaning: str, words: tuple[str, ...], *, optional: bool = False) -> None:
        super().__init__(key, meaning, optional=optional)
        self.words = words

    def taken(self, section: Section, value: Any) -> str:
        if value not in self.words:
            where = f"{type(section).__name__}: {self.key} = {value!r}"
            raise _delabole.CaseError(f"{where}: must be one of {', '.join(self.words)}")
        return str(value)


class Text(Field[Got, Given]):
    """Any text."""

    def taken(self, section: Section, value: Any) -> str:
        if not isinstance(value, str):
            raise TypeError(f"{type(section).__name__}.{self.key} must be a text")
        return value


class Texts(Field[Got, Given]):
    """A list of texts."""

    def taken(self, section: Section, value: Any) -> list[str]:
        return [str(text) for text in value or ()]


class Part(Field[Got, Given]):
    """A section, as an object or a dictionary of its keys; of one of several classes where a kind tells them apart."""

    def __init__(self, key: str, meaning: str, *classes: type[Section], optional: bool = False) -> None:
        super().__init__(key, meaning, optional=optional)
        self.classes = classes

    def taken(self, section: Section, value: Any) -> Section:
        if isinstance(value, self.classes):
            return value  # type: ignore[no-any-return]
        where = f"{type(section).__name__}.{self.key}"
        if isinstance(value, Mapping):
            return self._made(where, dict(value))
        names = " or ".join(one.__name__ for one in self.classes)
        raise TypeError(f"{where} must be {names}, or a dictionary of its keys")

    def _made(self, where: str, keys: dict[str, Any]) -> Section:
        if len(self.classes) == 1:
            return self.classes[0](**keys)
        kinds = {one._kind: one for one in self.classes}
        kind_key = self.classes[0]._kind_key
        kind = keys.pop(kind_key, None)
        if kind not in kinds:
            raise _delabole.CaseError(f"{where}.{kind_key} = {kind!r}: must be one of {', '.join(kinds)}")
        return kinds[kind](**keys)

    def written(self, value: Section) -> dict[str, Any]:
        return value._tree()

    def plain(self, value: Section) -> dict[str, Any]:
        return value.to_dict()


class Parts(Part[Got, Given]):
    """A list of sections of one class."""

    def taken(self, section: Section, value: Any) -> Any:
        return [super(Parts, self).taken(section, one) for one in value or ()]

    def written(self, value: Any) -> Any:
        return [one._tree() for one in value]

    def plain(self, value: Any) -> Any:
        return [one.to_dict() for one in value]


class Section:
    """A section of a case. Two are equal where all their values are."""

    _kind: str = ""
    _kind_key: str = ""
    _fields: Sequence[Field[Any, Any]] = ()

    _values: dict[str, Any]

    def __init__(self, **keys: Any) -> None:
        self._take(keys)

    def __init_subclass__(cls) -> None:
        cls._fields = tuple(value for value in vars(cls).values() if isinstance(value, Field))

    def _take(self, given: Mapping[str, Any]) -> None:
        self._values = {}
        for field in self._fields:
            field.__set__(self, given[field.key])

    def __setattr__(self, name: str, value: Any) -> None:
        if name != "_values" and not isinstance(getattr(type(self), name, None), Field):
            keys = ", ".join(field.key for field in self._fields)
            raise AttributeError(f"{type(self).__name__} has no {name}; it has {keys}")
        object.__setattr__(self, name, value)

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and isinstance(other, Section) and other._values == self._values

    def __repr__(self) -> str:
        values = (f"{key}={value!r}" for key, value in self._values.items() if value is not None and value != [])
        return f"{type(self).__name__}({', '.join(values)})"

    def _each(self) -> list[tuple[Field[Any, Any], Any]]:
        present = ((field, self._values[field.key]) for field in self._fields)
        return [(field, value) for field, value in present if value is not None and value != []]

    def _tree(self) -> dict[str, Any]:
        tree: dict[str, Any] = {self._kind_key: self._kind} if self._kind_key else {}
        tree.update({field.key: field.written(value) for field, value in self._each()})
        return tree

    def to_dict(self) -> dict[str, Any]:
        """Keys as in a case file, numbers in SI; what is absent is left out."""
        plain: dict[str, Any] = {self._kind_key: self._kind} if self._kind_key else {}
        plain.update({field.key: field.plain(value) for field, value in self._each()})
        return plain
