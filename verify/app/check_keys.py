"""The option `check --keys`: keys of inputs and values in the JSON output."""

from collections.abc import Sequence
from pathlib import Path

from verify.answers.keys import identifier
from verify.cases.registry import find
from verify.core.case import Case, Output
from verify.core.console import aligned
from verify.core.console_rows import unit_of
from verify.core.inputs import meta, read_parameter_file
from verify.core.terminal import print_wrapped


def run_keys(file: Path) -> int:
    """Print keys, units and descriptions for a case; `file` is a parameter file or a case name."""
    case = _case(file)
    inputs = [
        (name, unit_of(meta(field)["unit"]), meta(field)["what"])
        for name, field in case.inputs.model_fields.items()
    ]
    _print(f"{case.id}: inputs", inputs)
    _print("values", _lines(case.outputs))
    if case.dynamic:
        _print("dynamic.values, with --dynamic", _lines(case.dynamic.outputs))
    return 0


def _case(file: Path) -> Case:
    if not file.exists() and file.suffix != ".toml":
        return find(str(file))
    return find(read_parameter_file(file)[0])


def _lines(outputs: Sequence[Output]) -> list[tuple[str, ...]]:
    return [(identifier(o.key), unit_of(o.unit), o.label) for o in outputs]


def _print(title: str, lines: Sequence[tuple[str, ...]]) -> None:
    print(title)
    print_wrapped(*(f"  {line}" for line in aligned(lines)))
