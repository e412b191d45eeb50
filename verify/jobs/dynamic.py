"""The transient part of a case with a user's parameters, which `check --dynamic` adds."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from verify.core.case import Case, Dynamic, Output, Values
from verify.core.figures import Figure, FormulaValue
from verify.core.inputs import InputError, Inputs
from verify.core.progress import message_if_slow
from verify.core.results import CaseResult
from verify.papers.case_report import shown_values


@dataclass(frozen=True, kw_only=True)
class DynamicResult:
    """Result of a simulation in time: values `raw` [SI], `outputs` that are displayed, findings."""

    what: str
    raw: Values
    outputs: tuple[Output, ...]
    findings: tuple[str, ...]
    summary: Mapping[str, Any]
    figures: tuple[Figure, ...]
    verdict: str = ""  # of both parts together, if the case has a dynamic part
    first: tuple[str, ...] = ()  # findings in the place of the formulas' first

    def after(self, findings: tuple[str, ...]) -> tuple[str, ...]:
        """All findings. `findings` are those of the formulas; `first` replaces the first one."""
        return (self.first + findings[1:] if self.first else findings) + self.findings

    @property
    def values(self) -> tuple[FormulaValue, ...]:
        """The outputs in display units."""
        return shown_values(self.outputs, self.raw)

    def unjudged(self) -> "DynamicResult":
        """The result with all outputs marked as not judged by finite elements."""
        return replace(self, outputs=tuple(replace(o, judged=False) for o in self.outputs))


def run_dynamic(
    case: Case, inputs: Inputs, values: Values, *, where: str, drawn: bool, quiet: bool
) -> DynamicResult:
    """Result of the dynamic part for these inputs; figures only if they are `drawn`.

    Raises InputError with a message of one line, which begins with `where`, if the case has no
    dynamic part or if this part has no solution. A run of more than two seconds is reported on
    stderr unless `quiet`.
    """
    part = asked_for(case, where)
    try:
        with (
            message_if_slow(f"{part.what}: compiled the first time, some seconds", quiet=quiet),
            np.errstate(all="ignore"),
        ):
            return _ran(part, inputs, values, drawn=drawn)
    except (ValueError, ArithmeticError) as error:
        raise InputError(f"{where}: {part.what}: {error}") from error


def asked_for(case: Case, where: str) -> Dynamic:
    """The dynamic part of a case. Raises InputError if there is none."""
    if case.dynamic is None:
        raise InputError(f"{where}: case {case.id} has no dynamic part; omit --dynamic")
    return case.dynamic


def with_dynamic(result: CaseResult, dynamic: DynamicResult) -> CaseResult:
    """The result for a report, with the dynamic part after the static part."""
    return replace(
        result,
        values=result.values + dynamic.values,
        findings=dynamic.after(result.findings),
        figures=result.figures + dynamic.figures,
    )


def _ran(part: Dynamic, inputs: Inputs, values: Values, *, drawn: bool) -> DynamicResult:
    raw = dict(part.run(inputs, values))
    if wild := [key for key, value in raw.items() if not math.isfinite(value)]:
        raise ArithmeticError(f"the value {wild[0]} is not finite with these inputs")
    together = {**values, **raw}
    verdict, first = part.overall(inputs, together) if part.overall else ("", ())
    return DynamicResult(
        what=part.what,
        raw=raw,
        outputs=part.outputs,
        findings=tuple(part.findings(inputs, together)),
        summary=part.summary(inputs, together),
        figures=tuple(part.figures(inputs, together)) if drawn else (),
        verdict=verdict,
        first=tuple(first),
    )
