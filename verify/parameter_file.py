"""A parameter file as the commands take it: its case, its inputs and the values of the formulas."""

import math
import shlex
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from verify.assumed.complete import build_completed
from verify.assumed.rules import Assumed
from verify.case import Case, Values
from verify.cases.registry import find
from verify.design.inputs import CASE as DESIGN
from verify.design_sprag.inputs import CASE as DESIGN_SPRAG
from verify.inputs import InputError, Inputs, read_parameter_file
from verify.unit_systems import System, system_of


@dataclass(frozen=True, kw_only=True)
class ParameterFile:
    """What a file holds: `assumed` are the inputs that it leaves out, `system` its units."""

    name: str
    case: Case
    inputs: Inputs
    values: Values
    assumed: tuple[Assumed, ...]
    system: System


def read(path: Path) -> ParameterFile:
    """The parameter file at `path`; InputError says in one line what is wrong."""
    case_id, name, raw = read_parameter_file(path)
    case = _case(case_id, path)
    inputs, assumed = build_completed(case_id, case.inputs, raw, str(path))
    return ParameterFile(
        name=name, case=case, inputs=inputs, values=_values(case, inputs, path), assumed=assumed,
        system=system_of(raw),
    )  # fmt: skip


def _case(case_id: str, path: Path) -> Case:
    try:
        return find(case_id)
    except ValueError as error:
        if case_id in (DESIGN, DESIGN_SPRAG):
            task = f"a task for freewheel design: freewheel design {shlex.quote(str(path))}"
            raise InputError(f"{path}: case: {task}") from error
        raise InputError(f"{path}: case: {error}") from error


def _values(case: Case, inputs: Inputs, path: Path) -> Values:
    """All values of the formulas [SI]; InputError where one is not finite."""
    try:
        with np.errstate(over="raise", divide="raise", invalid="raise"):
            values = case.analytic(inputs)
    except FloatingPointError as error:
        reason = "the formulas divide by zero or overflow with these values"
        raise InputError(f"{path}: inputs: {reason} ({error})") from error
    except (ValueError, ArithmeticError) as error:
        raise InputError(f"{path}: inputs: {error}") from error
    if wild := [key for key, value in values.items() if not math.isfinite(value)]:
        raise InputError(f"{path}: inputs: {wild[0]} is not finite with these inputs")
    return values
