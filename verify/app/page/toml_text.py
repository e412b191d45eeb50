"""Converts a state of the page to a parameter file (TOML) of the command line, and back."""

import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from verify.app.page.session import State
from verify.core.inputs import read_parameter_file

_NUMBER = re.compile(r"[-+]?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][-+]?\d{1,3})?")
_KEY = re.compile(r"[A-Za-z0-9_-]+")


def parameter_file(state: State) -> str:
    """Text of a parameter file with the inputs of a state.

    Tables are written after all other inputs.
    """
    lines = [f"case = {_text(state.case)}", f"name = {_text(state.name)}", "", "[inputs]"]
    tables = {k: v for k, v in state.raw.items() if isinstance(v, list)}
    lines += [_line(k, v) for k, v in state.raw.items() if k not in tables]
    for table, entries in tables.items():
        for entry in entries:
            lines += ["", f"[[inputs.{_key(table)}]]", *(_line(k, v) for k, v in entry.items())]
    return "\n".join(lines) + "\n"


def read_state(path: Path) -> State:
    """Return the state from a parameter file, with numbers as texts. May raise InputError."""
    case, name, raw = read_parameter_file(path)
    return State(case, name, as_texts(raw))


def as_texts(raw: Mapping[str, Any]) -> dict[str, Any]:
    """Raw inputs with every value as the text that a user would type.

    >>> as_texts({"nu": 0.3, "supports": [{"at": "0 mm"}]})
    {'nu': '0.3', 'supports': [{'at': '0 mm'}]}
    """
    return {k: _typed(v) for k, v in raw.items()}


def as_values(raw: Mapping[str, Any], whole: frozenset[str]) -> dict[str, Any]:
    """Raw inputs in which texts are converted to integers for the inputs named in `whole`.

    `whole` also contains names of inputs in tables.
    """
    return {k: _value(k, v, whole) for k, v in raw.items()}


def _value(key: str, value: Any, whole: frozenset[str]) -> Any:
    if isinstance(value, list):
        return [as_values(e, whole) if isinstance(e, Mapping) else e for e in value]
    if key in whole and isinstance(value, str) and re.fullmatch(r"\s*[-+]?\d{1,15}\s*", value):
        return int(value)
    return value


def _typed(value: Any) -> Any:
    if isinstance(value, list):
        return [as_texts(e) if isinstance(e, Mapping) else str(e) for e in value]
    return value if isinstance(value, str) else str(value)


def _line(key: str, value: Any) -> str:
    text = str(value).strip()
    return f"{_key(key)} = {text if _NUMBER.fullmatch(text) else _text(str(value))}"


def _key(key: str) -> str:
    return key if _KEY.fullmatch(key) else _text(key)


def _text(value: str) -> str:
    """Basic string of TOML.

    It has the escapes of JSON, and also an escape of DEL, which TOML requires.
    """
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
