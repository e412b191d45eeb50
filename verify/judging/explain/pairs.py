"""Explanation of rows that compare two values: formula, finite elements, printed number."""

import math

from verify.core.differences import percent, significant
from verify.core.references import is_finite_elements, reference_name
from verify.core.results import Row, Status
from verify.core.units import factor
from verify.judging import judge
from verify.judging.explain.grid import grid_steps, regrid, uncertainty_steps
from verify.judging.explain.lines import (
    Derivation,
    Step,
    amount,
    demand,
    difference_steps,
    expanded,
    long,
    sharpness,
    short,
)
from verify.papers.digits import half_last_digit


def identity(row: Row) -> Derivation:
    """Derivation of the verdict on a formula and finite elements that solve the same problem."""
    assert row.grid is not None
    assert row.analytic is not None
    assert row.scale is not None
    again, u_num = regrid(row.grid)
    v, r = row.grid.levels[-1][1], row.analytic
    name = reference_name(row)
    found: list[Step] = [
        ("formula", amount(r, row.unit, long)),
        _finest(row, v),
        *grid_steps(row.grid),
    ]
    if not again.converges:
        return Derivation(tuple(found), judge.Verdict(Status.FAIL, "does not converge"), u_num)
    u_ref = row.u_ref or 0.0
    U = judge.expanded(u_num, u_ref)
    verdict = judge.difference(v, r, U=U, scale=row.scale, demand=demand(row))
    evaluated = f"{amount(u_ref, row.unit)}: truncation error of the series in the formula"
    found += [
        *uncertainty_steps(row.grid),
        ("u_ref", evaluated if u_ref else "0: the formula is evaluated to round-off"),
        ("u_input", "0: formula and reference use the same inputs"),
        expanded(row.unit, u_num, u_ref, 0.0, U),
        *difference_steps(row, verdict, f"formula − {name}"),
    ]
    return Derivation(tuple(found), verdict, u_num)


def printed_theory(row: Row) -> Derivation:
    """Derivation of the verdict on a formula and the number that the paper computed from it."""
    assert row.analytic is not None
    assert row.partner is not None
    assert row.scale is not None
    entry = row.published[0]
    half = half_last_digit(entry.printed) * factor(entry.unit) / factor(row.unit)
    u_ref = half / math.sqrt(3)
    U = judge.expanded(0.0, u_ref)
    verdict = judge.difference(
        row.analytic, row.partner.value, U=U, scale=row.scale, demand=demand(row)
    )
    found = (
        ("formula", amount(row.analytic, row.unit, long)),
        ("printed", f"{entry.printed} {entry.unit}"),
        ("u_num", "0: the formula is evaluated to round-off"),
        (
            "u_ref",
            f"half the last printed digit/√3 = {short(half)}/√3 = {amount(u_ref, row.unit)}",
        ),
        ("u_input", "0: the inputs are those of the paper"),
        expanded(row.unit, 0.0, u_ref, 0.0, U),
        *difference_steps(row, verdict, "formula − printed"),
    )
    return Derivation(found, verdict, 0.0)


def approximation(row: Row) -> Derivation:
    """Derivation of the verdict on a formula that neglects an effect."""
    assert row.grid is not None
    assert row.analytic is not None
    again, u_num = regrid(row.grid)
    v, formula = row.grid.levels[-1][1], row.analytic
    found: list[Step] = [
        ("formula", f"{amount(formula, row.unit, long)}, which neglects an effect"),
        _finest(row, v),
        *grid_steps(row.grid),
    ]
    if not again.converges:
        return Derivation(tuple(found), judge.Verdict(Status.FAIL, "does not converge"), u_num)
    U = judge.expanded(u_num)
    verdict = judge.approximation(formula, v, U=U, interval=row.interval, demand=demand(row))
    found += [
        *uncertainty_steps(row.grid),
        ("u_ref", f"0: the reference is {reference_name(row)}, whose uncertainty is u_num"),
        ("u_input", "0: formula and reference use the same inputs"),
        expanded(row.unit, u_num, 0.0, 0.0, U),
        *_model_error(row, formula, v, U, verdict),
    ]
    return Derivation(tuple(found), verdict, u_num)


def _finest(row: Row, v: float) -> Step:
    where = "on the finest mesh" if is_finite_elements(row) else "at the finest refinement"
    return (reference_name(row), f"{amount(v, row.unit, long)} {where}")


def _percent(fraction: float) -> str:
    """Percentage with five significant digits, enough to decide whether a limit is exceeded."""
    return f"{significant(100 * fraction, 5, signed=True)} %"


def _model_error(
    row: Row, formula: float, v: float, U: float, verdict: judge.Verdict
) -> tuple[Step, ...]:
    if v == 0 or not math.isfinite(U):
        return (("test", "a value is zero or not finite: the solution did not converge"),)
    m, U_m = formula / v - 1, abs(formula / v) * U / abs(v)
    name = reference_name(row)
    found: list[Step] = [
        ("m", f"formula/{name} − 1 = {_percent(m)}, the signed model error"),
        ("U_m", f"|formula/{name}| U/|{name}| = {percent(U_m)}"),
    ]
    if row.interval is None:
        return (*found, ("expected", f"no interval was derived ({row.interval_source})"))
    low, high = row.interval
    inside = low + U_m <= m <= high - U_m
    return (
        *found,
        ("expected", f"{_percent(low)} to {_percent(high)}: {row.interval_source}"),
        (
            "test",
            f"low + U_m ≤ m ≤ high − U_m, that is {_percent(low + U_m)} ≤ {_percent(m)} ≤ "
            f"{_percent(high - U_m)}: {'holds' if inside else 'does not hold'}",
        ),
        sharpness(
            row,
            verdict,
            "smallest change of the formula that certainly moves m out of the interval",
        ),
    )


def agreement(row: Row) -> Derivation:
    """Derivation of the verdict on two values that may differ by a tolerance stated beforehand."""
    assert row.analytic is not None
    assert row.reference is not None
    U = judge.COVERAGE * (row.u_num or 0.0)
    verdict = judge.approximation(
        row.analytic, row.reference, U=U, interval=row.interval, demand=demand(row)
    )
    found = (
        ("value", amount(row.analytic, row.unit, long)),
        (reference_name(row), amount(row.reference, row.unit, long)),
        expanded(row.unit, row.u_num or 0.0, 0.0, 0.0, U),
        *_model_error(row, row.analytic, row.reference, U, verdict),
    )
    return Derivation(found, verdict, row.u_num)


def deviation(row: Row) -> Derivation:
    """Derivation of the verdict on a difference whose limit was stated beforehand."""
    assert row.reference is not None
    assert row.scale is not None
    assert row.tolerance is not None
    verdict = judge.difference(
        row.reference, 0.0, U=row.tolerance, scale=row.scale, demand=demand(row)
    )
    u = judge.COVERAGE * (row.u_num or 0.0)
    found = (
        ("size", f"{amount(row.reference, row.unit)}, {reference_name(row)}"),
        ("accepted", f"{amount(row.tolerance + u, row.unit)}: {row.interval_source}"),
        (
            "U",
            f"accepted − U of the size = {short(row.tolerance + u)} − {short(u)} = "
            f"{amount(row.tolerance, row.unit)}",
        ),
        *difference_steps(row, verdict, "0 − size"),
    )
    return Derivation(found, verdict, row.u_num)


def shown(row: Row) -> Derivation:
    """Derivation of the verdict on a formula and a number without a stated uncertainty."""
    assert row.analytic is not None
    assert row.difference is not None
    reference = row.analytic - row.difference
    printed = f"printed {row.published[0].printed}" if row.published else reference_name(row)
    by = row.partner.by if row.partner else printed
    found = (
        ("formula", amount(row.analytic, row.unit, long)),
        ("reference", f"{amount(reference, row.unit)}, {by}"),
        (
            "d",
            f"formula − reference = {amount(row.difference, row.unit)}, "
            f"{percent(row.difference / reference, signed=True)} of the reference",
        ),
        ("test", "not judged: the uncertainty of the reference is not stated"),
    )
    return Derivation(found, judge.Verdict(row.status, row.reason, row.difference))
