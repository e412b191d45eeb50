"""Stored studies point by point, which a report evaluates at a user's inputs."""

from collections.abc import Sequence
from dataclasses import replace
from math import prod

from verify.cases.registry import CASES, find, ids
from verify.core import units
from verify.core.inputs import Inputs
from verify.core.results import (
    FE,
    CaseResult,
    Row,
    ScaleInput,
    StoredStudy,
    StudiedFormula,
    StudyAxis,
)
from verify.core.verdicts import Safe
from verify.studies.sweep.axes import Axis
from verify.studies.sweep.outcome import Course
from verify.studies.sweep.plan import Plan
from verify.studies.validity.messages import constant, held_with_meaning, over
from verify.studies.validity.store import measured
from verify.verdicts.declared import declared
from verify.verdicts.design import Declared, ratio_of
from verify.verdicts.of_sweep import safe_side

# of an input that has the same value in a part of another size, all in proportion, of one material
OF_ANY_SIZE = ("1", "deg", "MPa")


def studies(results: Sequence[CaseResult]) -> tuple[StoredStudy, ...]:
    """Stored studies of the cases of the suite in a run, in the order of the cases."""
    suite = ids(CASES)
    found = []
    for result in results:
        case = find(result.id) if result.id in suite else None
        record = measured(case) if case and case.scans else None
        if record:
            found += [_study(result, record.date, *scan) for scan in record.scans]
    return tuple(found)


def _study(result: CaseResult, date: str, plan: Plan, courses: Sequence[Course]) -> StoredStudy:
    shown = [
        tuple(axis.in_unit(v) for axis, v in zip(plan.axes, point, strict=True))
        for point in plan.points
    ]
    # a value of an axis may differ from the default only in the last bit
    kept = [n for n, point in enumerate(shown) if point not in shown[:n]]
    rows = {row.quantity: row for row in result.rows}
    return StoredStudy(
        case=result.id, date=date, is_star=plan.star, over=over(plan),
        held=held_with_meaning(plan),
        at=tuple((one.name, float(one.value)) for one in constant(plan)),
        axes=tuple(_axis(plan, axis) for axis in plan.axes),
        points=tuple(shown[n] for n in kept),
        formulas=tuple(
            _formula(plan, one, kept, rows.get(one.pair.name)) for one in courses
        ),
    )  # fmt: skip


def _axis(plan: Plan, axis: Axis) -> StudyAxis:
    own = axis.values[0] if axis.nominal is None else axis.nominal
    head = StudyAxis(
        name=axis.name, symbol=axis.symbol, unit=axis.unit, what=axis.what, own=axis.in_unit(own),
        log=axis.spacing == "log", whole=axis.whole, scales=axis.unit in OF_ANY_SIZE,
    )  # fmt: skip
    entry = ratio_of(plan.case.id, axis.name)
    return head if entry is None else _with_ratio(head, entry, plan.case.inputs())


def _with_ratio(head: StudyAxis, entry: Declared, own: Inputs) -> StudyAxis:
    """Axis converted to the dimensionless ratio that is declared for the input."""
    shown = {one.name: one for one in own.display()}
    per = tuple(
        ScaleInput(name=name, symbol=shown[name].symbol, unit=shown[name].unit,
                   own=float(shown[name].value), power=power)
        for name, power in entry.per.items()
    )  # fmt: skip
    divisor = prod(units.factor(one.unit) ** one.power for one in per)
    factor = float(f"{units.factor(head.unit) / divisor:.12g}")
    return replace(head, ratio=entry.ratio, factor=factor, per=per, scales=True)


def _formula(plan: Plan, course: Course, kept: Sequence[int], row: Row | None) -> StudiedFormula:
    pair = course.pair
    reference = None if row is None else row.reference
    return StudiedFormula(
        quantity=pair.name, symbol=pair.symbol, by=pair.by or FE,
        of="" if row is None else row.scale_name, safe=_safe(plan, course),
        is_positive=reference is not None and reference > 0,
        error=tuple(float(course.error[n]) for n in kept),
        U=tuple(float(course.U_error[n]) for n in kept),
        problems=tuple(course.problems[n] for n in kept),
    )  # fmt: skip


def _safe(plan: Plan, course: Course) -> Safe:
    """Safe side of the quantity as stated by the case or by a formula with this row as evidence."""
    stated = safe_side(plan, course)
    name = f"{plan.case.id}/{course.pair.name}"
    of_formulas = (
        f.safe for paper in declared().values() for f in paper.formulas if name in f.rows
    )
    known = (one for one in (stated, *of_formulas) if one is not Safe.NEITHER)
    return next(known, Safe.NEITHER)
