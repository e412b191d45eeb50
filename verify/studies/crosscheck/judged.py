"""Judged comparisons: difference between both solvers, and whether it is permissible."""

from collections.abc import Iterator, Sequence

from verify.core import units
from verify.core.results import Crosscheck, CrossState
from verify.studies.crosscheck.not_compared import ALONE
from verify.studies.crosscheck.registry import COMPARISONS
from verify.studies.crosscheck.statement import Cross
from verify.studies.crosscheck.store import Found, current

# full names of numbers that belong to no row, by their short names in a comparison
TOLD = {
    "mid": "pressure at mid-length", "q mid": "load per length at mid-length",
    "largest": "largest pressure",
}  # fmt: skip
STALE = "comparison with a second solver not computed for the present code: run `make crosscheck`"


def judged(cross: Cross, found: Found) -> tuple[Crosscheck, ...]:
    """One record per quantity of a comparison: both values, difference, agreement."""
    lines = []
    for q in cross.quantities:
        ours, theirs = found.ours[q.name], found.theirs[q.name]
        difference = theirs / ours - 1 if ours else abs(theirs)
        agrees = abs(difference) <= q.allowed
        lines.append(Crosscheck(
            case=cross.case, problem=cross.id, what=cross.what,
            quantity=TOLD.get(q.name, q.name) if q.beside or not q.row else q.row,
            row=f"{cross.case}/{q.row}" if q.row else "", symbol=q.symbol, unit=q.unit,
            solver=cross.solver, version=found.version, date=found.date,
            state=CrossState.AGREES if agrees else CrossState.OUTSIDE,
            ours=ours / units.factor(q.unit), theirs=theirs / units.factor(q.unit),
            difference=difference, allowed=q.allowed, why=q.why, seconds=tuple(found.seconds),
            unknowns=found.unknowns,
        ))  # fmt: skip
    return tuple(lines)


def reported(cases: Sequence[str]) -> tuple[Crosscheck, ...]:
    """Records for a report on `cases`: one for each quantity that both solvers have computed.

    A comparison without a stored result, and a case that no second solver can solve, have one
    record with the reason. If no case has a comparison, the result is empty.
    """
    found = [line for cross in COMPARISONS if cross.case in cases for line in _of(cross)]
    if not found:
        return ()
    return (*found, *(_none(case, why) for case, why in ALONE.items() if case in cases))


def _none(case: str, why: str) -> Crosscheck:
    return Crosscheck(
        case=case, problem=case, what="no second solver", quantity="", row="", symbol="", unit="1",
        solver="", state=CrossState.ALONE, why=why,
    )  # fmt: skip


def _of(cross: Cross) -> Iterator[Crosscheck]:
    found = current(cross)
    if found is not None:
        yield from judged(cross, found)
        return
    yield Crosscheck(
        case=cross.case, problem=cross.id, what=cross.what, quantity="", row="", symbol="",
        unit="1", solver=cross.solver, state=CrossState.MISSING, why=STALE,
    )  # fmt: skip
