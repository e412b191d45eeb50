"""Data for judging cases again: levels from the cache, and statuses of rows."""

import traceback
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from verify.audit.mutation.tracing import ROOT
from verify.core.case import Case, Context, FemResult, Values
from verify.core.inputs import InputError, Inputs
from verify.core.results import Status
from verify.jobs import cache

States = Mapping[str, str]  # of rows, by their names


@dataclass(frozen=True)
class Judged:
    """Statuses of rows by their names, and the errors that were raised."""

    states: dict[str, str] = field(default_factory=dict)
    errors: tuple[Exception, ...] = ()


@dataclass(frozen=True)
class Load:
    """A case at the inputs of the paper with its levels from coarse to fine.

    `values` are the values of the formulas; None if they are to be computed.
    """

    case: Case
    inputs: Inputs
    levels: tuple[FemResult, ...]
    values: Values | None = None

    def judged(self) -> Judged:
        """Statuses of all rows, judged again; rows of checks that raise an error are missing."""
        try:
            values = self.case.analytic(self.inputs) if self.values is None else self.values
        except Exception as error:
            return Judged(errors=(error,))
        context = Context(self.case.id, self.inputs, values, self.levels, is_paper=True)
        states: dict[str, str] = {}
        errors: list[Exception] = []
        for check in self.case.checks:
            try:
                states |= {row.quantity: row.status.value for row in check.rows(context)}
            except Exception as error:  # one check's alone, as in a run
                errors.append(error)
        return Judged(states, tuple(errors))

    def with_values(self) -> "Load":
        """A copy that contains the values of the formulas, so that only the judging is repeated."""
        return replace(self, values=self.case.analytic(self.inputs))


def loads(cases: Sequence[Case], folder: Path) -> list[Load]:
    """The cases with their levels.

    Raises InputError if the cache does not contain all levels.
    """
    return [_load(case, folder) for case in cases]


def _load(case: Case, folder: Path) -> Load:
    inputs = case.inputs()
    levels = []
    for level in case.levels:
        found = cache.load(folder, case, inputs, level)
        if found is None:
            raise InputError(f"{case.id} level {level} is not solved: run `freewheel verify`")
        levels.append(replace(found, fields=()))  # pictures, which no row looks at
    return Load(case, inputs, tuple(levels))


def reddened(before: States, after: States) -> list[str]:
    """Names of the rows that fail now and did not fail before."""
    fail = Status.FAIL.value
    return [name for name, state in after.items() if state == fail != before.get(name)]


def refuses(error: BaseException) -> bool:
    """Whether code of the project raised this error deliberately, as for invalid inputs."""
    if not isinstance(error, ValueError | ArithmeticError):
        return False
    frames = traceback.extract_tb(error.__traceback__)
    if not frames:
        return False
    last = frames[-1]
    return Path(last.filename).is_relative_to(ROOT) and (last.line or "").startswith("raise")
