"""Comparisons with second solvers, grouped for the page and the PDF."""

from collections.abc import Sequence
from dataclasses import dataclass

from reports import formats
from reports.pdf_tables import Data, prose
from reports.richtext import Run, runs
from verify.core.results import Crosscheck, CrossState, Report

SEVERAL = 4  # comparisons of a problem that are listed one by one
WITHOUT_NUMBERS = (CrossState.MISSING, CrossState.ALONE)


@dataclass(frozen=True)
class Problem:
    """One problem and its comparisons; `missing` is the reason if there are none."""

    head: Crosscheck
    lines: Sequence[Crosscheck]

    @property
    def missing(self) -> str:
        return self.head.why if self.head.state in WITHOUT_NUMBERS else ""

    @property
    def by(self) -> str:
        """Name of the solver in brackets; empty for a case without a second solver."""
        return f" ({self.head.solver})" if self.head.solver else ""

    @property
    def is_brief(self) -> bool:
        """Whether only the largest difference is printed, because several comparisons all agree."""
        return len(self.lines) > SEVERAL and all(c.state is CrossState.AGREES for c in self.lines)

    @property
    def largest(self) -> Crosscheck:
        """Comparison with the largest difference."""
        return _largest(self.lines)

    @property
    def why(self) -> str:
        """Causes of the differences, each stated once."""
        return "" if self.missing else "; ".join(dict.fromkeys(c.why for c in self.lines))


@dataclass(frozen=True)
class Solver:
    """All comparisons with a solver."""

    name: str
    lines: Sequence[Crosscheck]

    @property
    def problems(self) -> int:
        return len({check.problem for check in self.lines})

    @property
    def largest(self) -> Crosscheck:
        return _largest(self.lines)


def _largest(lines: Sequence[Crosscheck]) -> Crosscheck:
    return max(lines, key=lambda check: abs(check.difference or 0.0))


def solvers(checks: Sequence[Crosscheck]) -> list[Solver]:
    """Solvers that have results, in the order of their first result."""
    found: dict[str, list[Crosscheck]] = {}
    for check in checks:
        if check.state not in WITHOUT_NUMBERS:
            found.setdefault(f"{check.solver} {check.version}".strip(), []).append(check)
    return [Solver(name, lines) for name, lines in found.items()]


def of_cases(report: Report) -> tuple[Crosscheck, ...]:
    """Comparisons of the cases of the report, to which the report can link."""
    here = {case.id for case in report.cases}
    return tuple(check for check in report.crosschecks if check.case in here)


def problems(checks: Sequence[Crosscheck]) -> list[Problem]:
    """Comparisons grouped by problem, in their order."""
    found: dict[str, list[Crosscheck]] = {}
    for check in checks:
        found.setdefault(check.problem, []).append(check)
    return [Problem(group[0], group) for group in found.values()]


def left_out(checks: Sequence[Crosscheck]) -> list[tuple[str, list[Problem]]]:
    """Problems without compared numbers, grouped by the reason."""
    found: dict[str, list[Problem]] = {}
    for problem in problems(checks):
        if problem.missing:
            found.setdefault(problem.missing, []).append(problem)
    return list(found.items())


def counts_in_words(checks: Sequence[Crosscheck]) -> str:
    """Counts in words: numbers that agree, problems not measured, cases without second solver."""
    agree = sum(check.state is CrossState.AGREES for check in checks)
    outside = sum(check.state is CrossState.OUTSIDE for check in checks)
    missing = sum(p.head.state is CrossState.MISSING for p in problems(checks))
    alone = sum(check.state is CrossState.ALONE for check in checks)
    parts = [f"{agree} of {agree + outside} numbers agree"] if agree + outside else []
    if missing:
        parts.append(f"{missing} problem{'s have' if missing > 1 else ' has'} no current result")
    if alone:
        have = "s have" if alone > 1 else " has"
        parts.append(f"{alone} case{have} no second solver (reasons below)")
    return "; ".join(parts)


def crosscheck_data(checks: Sequence[Crosscheck]) -> list[Data]:
    """Data of the comparisons for the template of the PDF."""
    return [
        {
            "case": p.head.case, "what": runs(p.head.what),
            "by": f"{p.head.solver} {p.head.version}".strip(), "unknowns": p.head.unknowns,
            "seconds": [f"{s:.2f}" for s in p.head.seconds],
            "rows": [
                [prose(c.quantity), _number(c.ours), _number(c.theirs),
                 [c.unit if c.unit != "1" else ""], _difference(c)]
                for c in p.lines
            ],
        }
        for p in problems(checks) if not p.missing
    ]  # fmt: skip


def left_out_data(checks: Sequence[Crosscheck]) -> list[list[Run]]:
    """Sentences for the PDF, one for each reason why problems have no compared numbers."""
    return [
        [*prose(why[:1].upper() + why[1:]), ": ", *_joined(found), "."]
        for why, found in left_out(checks)
    ]


def _joined(found: Sequence[Problem]) -> list[Run]:
    return prose("; ".join(f"{p.head.case}, {p.head.what}{p.by}" for p in found))


def _number(value: float | None) -> list[Run]:
    return runs(formats.written(value))


def _difference(check: Crosscheck) -> list[Run]:
    if check.difference is None or check.allowed is None:
        return ["–"]
    mark = " !" if check.state is CrossState.OUTSIDE else ""
    found = runs(formats.percents(check.difference, signed=True))
    return [*found, " (", *runs(formats.percents(check.allowed)), f"){mark}"]
