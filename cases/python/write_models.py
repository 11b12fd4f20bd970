"""Usage: write_models.py FOLDER FILE

Writes the classes of all models and their sections as Python, from the described parameters of the extension module in
FOLDER.
"""

import os
import sys
import textwrap

WIDTH = 120
HEAD = '''"""The models and their sections: a class for each section of a case file, a keyword for each key.

Written from the described parameters by write_models.py.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal, Union

from .case import Model
from .fields import Field, Number, Part, Parts, Quantity, Section, Text, Texts, Word
'''


def types_of(field):
    """What an attribute gives back and what it takes, without None."""
    kind = field["kind"]
    if kind == "number":
        return "float", "Quantity"
    if kind == "word":
        words = "Literal[" + ", ".join(f'"{word}"' for word in field["words"]) + "]"
        return words, words
    if kind == "text":
        return "str", "str"
    if kind == "texts":
        return "list[str]", "Sequence[str]"
    if kind == "sections":
        (name,) = field["classes"]
        return f"list[{name}]", f"Sequence[Union[{name}, Mapping[str, Any]]]"
    return union(field["classes"]), union(field["classes"] + ["Mapping[str, Any]"])


def union(names):
    return names[0] if len(names) == 1 else f"Union[{', '.join(names)}]"


def is_list(field):
    return field["kind"] in ("texts", "sections")


def meaning_of(field):
    """For the documentation: unit, range or words, and what it means."""
    notes = []
    if field["kind"] == "number":
        notes.append(field["range_in_words"] or (field["unit"] and "in " + field["unit"]) or "a number")
    if field["kind"] == "word":
        notes.append(" or ".join(field["words"]))
    if field["optional"] and "absent" not in field["meaning"]:
        notes.append("may be absent")
    return field["meaning"] + (f" ({'; '.join(notes)})" if notes else "")


def default_of(field):
    if not field["optional"]:
        return ""
    return " = ()" if is_list(field) else " = None"


def argument_of(field):
    given = types_of(field)[1]
    if field["optional"] and not is_list(field):
        given = f"Union[{given}, None]"
    return f"{field['key']}: {given}{default_of(field)}"


def number(value):
    return f'float("{value}")' if value in (float("inf"), float("-inf")) else repr(value)


def attribute_of(field):
    got, given = types_of(field)
    if field["optional"] and not is_list(field):
        got, given = f"Union[{got}, None]", f"Union[{given}, None]"
    makers = {"number": "Number", "word": "Word", "text": "Text", "texts": "Texts", "section": "Part", "choice": "Part",
              "sections": "Parts"}
    arguments = [repr(field["key"]), repr(field["meaning"])]
    if field["kind"] == "number":
        lower, upper, lower_open, upper_open = field["range"]
        arguments += [repr(field["dimension"]), repr(field["unit"]),
                      f"({number(lower)}, {number(upper)}, {lower_open}, {upper_open})"]
    if field["kind"] == "word":
        arguments.append(repr(tuple(field["words"])))
    arguments += field["classes"]
    if field["optional"]:
        arguments.append("optional=True")
    return f"    {field['key']}: Field[{got}, {given}] = {makers[field['kind']]}({', '.join(arguments)})\n"


def class_of(one):
    base = "Model" if one["kind_key"] == "model" else "Section"
    meaning = one["meaning"].split("; absent:")[0].rstrip(".") + "."
    doc = textwrap.wrap(meaning[:1].upper() + meaning[1:], WIDTH - 4)
    doc.append("")
    for field in one["fields"]:
        doc += textwrap.wrap(f"{field['key']}: {meaning_of(field)}", WIDTH - 4, subsequent_indent="    ")
    text = f'\n\nclass {one["name"]}({base}):\n    """' + "\n    ".join(doc) + '\n    """\n\n'
    text = text.replace("    \n", "\n")
    if one["kind_key"]:
        text += f'    _kind_key = "{one["kind_key"]}"\n    _kind = "{one["kind"]}"\n'
    text += "".join(attribute_of(field) for field in one["fields"])
    required = [field for field in one["fields"] if not field["optional"]]
    others = [field for field in one["fields"] if field["optional"]]
    keywords = ["*"] if one["fields"] else []
    arguments = ",\n                 ".join(["self"] + keywords + [argument_of(field) for field in required + others])
    keys = ", ".join(f'"{field["key"]}": {field["key"]}' for field in one["fields"])
    text += f"\n    def __init__({arguments}) -> None:\n        self._take({{{keys}}})\n"
    return text


def main(folder, path):
    sys.path.insert(0, folder)
    import _delabole

    classes = _delabole.schema()
    text = HEAD + "".join(class_of(one) for one in classes)
    models = ", ".join(f'"{one["kind"]}": {one["name"]}' for one in classes if one["kind_key"] == "model")
    text += f"\n\nMODELS: dict[str, type[Model]] = {{{models}}}\n"
    text += f"\n__all__ = {['MODELS'] + [one['name'] for one in classes]}\n"
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".new", path)


if __name__ == "__main__":
    main(*sys.argv[1:])
