"""Explanation of the judgement of a row, recomputed from its stored values."""

from collections.abc import Callable, Mapping

from verify.core.references import reference_name
from verify.core.results import Kind, Published, Row, Status
from verify.judging import judge
from verify.judging.explain import pairs, single
from verify.judging.explain.lines import Derivation, Step, long

PAIRED: Mapping[Kind, Callable[[Row], Derivation]] = {  # with finite-element levels
    Kind.IDENTITY: pairs.identity,
    Kind.APPROXIMATION: pairs.approximation,
    Kind.FACT: single.convergence,
}
SINGLE: Mapping[Kind, Callable[[Row], Derivation]] = {
    Kind.IDENTITY: pairs.printed_theory,
    Kind.APPROXIMATION: pairs.shown,
    Kind.FACT: single.fact,
    Kind.TREND: single.trend,
    Kind.ASYMPTOTIC: single.limit,
    Kind.EXACT: single.exact,
}

STATED: Mapping[Kind, Callable[[Row], Derivation]] = {  # within a figure that a source states
    Kind.IDENTITY: pairs.deviation,
    Kind.APPROXIMATION: pairs.agreement,
}


def steps(row: Row) -> tuple[Step, ...]:
    """Explanation in lines (label and text): compared values, uncertainty, and verdict."""
    return derive(row).steps


def derive(row: Row) -> Derivation:
    """Derivation of the verdict on a row, which is judged again from its stored numbers.

    The derivation contains only the verdict if the row was not run, or if its finite elements ended
    with an error.
    """
    if row.grid is not None:
        found = PAIRED[row.kind](row)
    elif row.status is Status.SKIP or not _has_numbers(row):
        found = Derivation((), judge.Verdict(row.status, row.reason))
    elif row.interval_source and row.kind in STATED:
        found = STATED[row.kind](row)
    else:
        found = SINGLE[row.kind](row)
    verdict = f"{row.status.value}: {row.reason}" if row.reason else row.status.value
    last = (*(_printed(row, entry) for entry in row.published), ("verdict", verdict))
    return Derivation((*found.steps, *last), found.verdict, found.u_num)


def _has_numbers(row: Row) -> bool:
    if row.kind in (Kind.TREND, Kind.ASYMPTOTIC):
        return bool(row.levels)
    return row.difference is not None


def _printed(row: Row, entry: Published) -> Step:
    """Line of the explanation: a published value, and formula and finite elements divided by it."""
    computed = row.grid is not None or row.fem is not None  # a partner may be the print itself
    ours = (("formula", row.analytic), (reference_name(row), row.reference if computed else None))
    ratios = [f"{who}/printed = {v / entry.value:.5f}" for who, v in ours if v and entry.value]
    unit = "" if entry.unit == "1" else f" {entry.unit}"
    text = f"{entry.printed}{unit} ({entry.kind}, {entry.document}, {entry.place})"
    if entry.unit != row.unit:
        text += f" = {long(entry.value)} {row.unit}"
    return ("printed", "; ".join((text, *ratios)))
