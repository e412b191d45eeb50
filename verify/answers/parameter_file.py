"""Reading of a parameter file for commands: its case, its inputs and the values of the formulas."""

import math
import shlex
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from textwrap import shorten
from typing import Any

import numpy as np

from verify.answers.assumed.complete import build_completed
from verify.answers.assumed.registry import TASKS
from verify.answers.assumed.rules import Assumed
from verify.answers.toml_lines import with_line
from verify.cases.files import is_file_name
from verify.cases.registry import find
from verify.core.case import Case, Values
from verify.core.inputs import LONGEST_RULE, InputError, Inputs, read_parameter_file
from verify.core.unit_systems import System, system_of

MISSING = "inputs: missing "
DEFAULTS = {
    "freewheel-cup": 'freewheel-clutch with kind = "outer cam"',
    "freewheel-torque": "freewheel-clutch", "freewheel-friction": "freewheel-clutch",
    "polyhedral-ring": "polyhedral-clutch", "polyhedral-locking": "polyhedral-clutch",
    "polyhedral-wedge": "polyhedral-clutch", "sprag-wedge": "sprag-clutch",
    "spring-stages": "spring-accordion", "spring-buckling": "spring-accordion",
}  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class ParameterFile:
    """Content of a parameter file.

    `assumed` contains the inputs that the file omits; `system` is the unit system of the file.
    """

    name: str
    case: Case
    inputs: Inputs
    values: Values
    assumed: tuple[Assumed, ...]
    system: System


def read(path: Path) -> ParameterFile:
    """Content of the parameter file at `path`. Raises InputError with a message of one line."""
    case_id, name, raw = read_parameter_file(path)
    case = _case(case_id, path)
    try:
        return completed(case, raw, name=name, where=str(path), named=case_id)
    except InputError as error:
        message = with_line(str(error), path)
        if message == str(error):
            raise
        raise InputError(message) from error


def completed(
    case: Case, raw: Mapping[str, Any], *, name: str, where: str, named: str = ""
) -> ParameterFile:
    """Completed inputs of a case, from the raw inputs of a file with the name `where`.

    `named` is the name of the case in the file, by default its id. Raises InputError if an input is
    wrong.
    """
    case_id = named or case.id
    try:
        inputs, assumed = build_completed(case_id, case.inputs, raw, where)
    except InputError as error:
        raise InputError(f"{error}{_with_defaults(case_id, str(error))}") from error
    return ParameterFile(
        name=name, case=case, inputs=inputs, values=_values(case, inputs, where), assumed=assumed,
        system=system_of(raw),
    )  # fmt: skip


def _with_defaults(case_id: str, message: str) -> str:
    """Advice if inputs are missing: use another case, which assumes values for omitted inputs."""
    other = DEFAULTS.get(case_id)
    return (
        f"; case {other} assumes values for omitted inputs" if other and MISSING in message else ""
    )


def _case(case_id: str, path: Path) -> Case:
    try:
        return find(str(path.parent / case_id) if is_file_name(case_id) else case_id)
    except ValueError as error:
        if case_id in TASKS:
            task = f"a task for freewheel design: freewheel design {shlex.quote(str(path))}"
            raise InputError(f"{path}: case: {task}") from error
        raise InputError(f"{path}: case: {error}") from error


def _values(case: Case, inputs: Inputs, where: str) -> Values:
    """All values of the formulas [SI]. Raises InputError if a value is not finite."""
    try:
        with np.errstate(over="raise", divide="raise", invalid="raise"):
            values = case.analytic(inputs)
    except FloatingPointError as error:
        reason = "with these inputs, the formulas divide by zero or overflow"
        raise InputError(f"{where}: inputs: {reason} ({error})") from error
    except (ValueError, ArithmeticError) as error:
        reason = shorten(str(error), LONGEST_RULE, placeholder=" …")  # in one line, also of arrays
        raise InputError(f"{where}: inputs: {reason}") from error
    if wild := [key for key, value in values.items() if not math.isfinite(value)]:
        raise InputError(
            f"{where}: inputs: the value {wild[0]} of the formulas is not finite with these inputs"
        )
    return values
