"""A sweep for other programs: request, results and run times as JSON."""

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from verify.core import units
from verify.core.figures import Array
from verify.studies.sweep.axes import Axis, Tolerance
from verify.studies.sweep.indices import Indices, indices
from verify.studies.sweep.outcome import Course, Outcome
from verify.studies.sweep.point import code_of
from verify.studies.sweep.region import NAMES, Region, regions
from verify.studies.sweep.run import Solved, versions
from verify.studies.sweep.tables import FAILED, REFUSED, SOLVED, quantities, reasons, statuses

SCHEMA = 1


def record(found: Outcome, repeat: str) -> dict[str, Any]:
    """Sweep as a dictionary for JSON; `repeat` is the command that repeats the sweep.

    schema       1; a new number whenever a key below changes
    name, case, command
    inputs       value and unit by name, as in the parameter file
    plan         kind: "grid", "star" or "sample"; points: their number; base: N of a sample;
                 varied: name, symbol, unit, what, nominal, and values with spacing, or off
    points       lists over the points: inputs (values by name), status, reason. Grid: the last
                 axis varies fastest; star: its centre is first; sample: rows of A,
                 of B, and, for each input, of A with one column from B
    counts       numbers of points: solved, refused, failed; reasons: points with each reason
    rows         name, symbol, unit, kind, by (method used instead of finite elements), and lists
                 over the points: formula, fe, U in the unit; error, U_error as fractions;
                 problem; then validity (grid, star) or sensitivity (sample)
    validity     for each limit: numbers of points inside, outside, undecided, unsolved; box: low,
                 high, whole by input; held: points in the box; base: values by input; nominal:
                 whether base is the point of the file; at_nominal: verdict at this point;
                 breaks: input, last, first, at, verdict, why of the first violation
    sensitivity  rows: complete rows of the sample; dropped: other rows; scatter of formula, fe and
                 error: n, mean, sd, q025, q500, q975, noise, why; indices: S1 and ST by input,
                 [value, low, high]; within: for each limit, numbers of points of A and B
    solved_by    portion, levels, code (hashes of the sources of formulas and fe), versions
    timing       points, wall_s, busy_s, workers, known, overhead of the run that wrote the record

    Values have the stated unit. Errors are fractions (0.02 is 2 %). A value that does not exist
    is null.
    """
    plan = found.solved.plan
    kind = "sample" if plan.base else "star" if plan.star else "grid"
    return {
        "schema": SCHEMA, "name": plan.name, "case": plan.case.id, "command": repeat,
        "inputs": plan.inputs.record(),
        "plan": {
            "kind": kind, "points": len(plan.points), **({"base": plan.base} if plan.base else {}),
            "varied": [_varied(one) for one in plan.axes or plan.tolerances],
        },
        "points": _points(found),
        "counts": _counts(found),
        "rows": [_row(found, course) for course in found.courses],
        "solved_by": _solved_by(found.solved),
        "timing": _timing(found.solved),
    }  # fmt: skip


def _varied(one: Axis | Tolerance) -> dict[str, Any]:
    about: dict[str, Any] = {
        "name": one.name, "symbol": one.symbol, "unit": one.unit, "what": one.what,
        "nominal": None if one.nominal is None else one.in_unit(one.nominal),
    }  # fmt: skip
    if isinstance(one, Tolerance):
        return about | {"off": one.in_unit(one.off)}
    return about | {"values": [one.in_unit(v) for v in one.values], "spacing": one.spacing}


def _points(found: Outcome) -> dict[str, Any]:
    plan = found.solved.plan
    varied: Sequence[Axis | Tolerance] = plan.axes or plan.tolerances
    return {
        "inputs": {
            one.name: [one.in_unit(float(v)) for v in column]
            for one, column in zip(varied, plan.points.T, strict=True)
        },
        "status": list(statuses(found)),
        "reason": list(reasons(found)),
    }


def _counts(found: Outcome) -> dict[str, Any]:
    of = statuses(found)
    counts = Counter(reason for reason in reasons(found) if reason)
    return {status: of.count(status) for status in (SOLVED, REFUSED, FAILED)} | {
        "reasons": [{"reason": reason, "points": count} for reason, count in counts.most_common()]
    }


def _row(found: Outcome, course: Course) -> dict[str, Any]:
    pair, plan = course.pair, found.solved.plan
    about: dict[str, Any] = {
        "name": pair.name, "symbol": pair.symbol, "unit": pair.unit, "kind": pair.kind.value,
        "by": pair.by,
    }  # fmt: skip
    size = units.factor(pair.unit)
    for name, values in (("formula", course.formula), ("fe", course.fe), ("U", course.U)):
        about[name] = _finite(values / size)
    about |= {"error": _finite(course.error), "U_error": _finite(course.U_error)}
    about["problem"] = list(course.problems)
    if plan.axes:
        return about | {"validity": [_region(plan.axes, one) for one in regions(plan, course)]}
    return about | {"sensitivity": _sensitivity(indices(plan, course))}


def _region(axes: Sequence[Axis], one: Region) -> dict[str, Any]:
    by = one.breaks
    names = ("limit", "inside", "outside", "undecided", "unsolved", "held", "nominal")
    return {name: getattr(one, name) for name in names} | {
        "at_nominal": None if one.at_nominal is None else NAMES[one.at_nominal],
        "base": None if one.base is None else {
            axis.name: axis.in_unit(v) for axis, v in zip(axes, one.base, strict=True)
        },
        "box": {
            r.axis.name: {"low": r.axis.in_unit(r.low), "high": r.axis.in_unit(r.high),
                          "whole": r.whole} for r in one.box
        },
        "breaks": None if by is None else {
            "input": by.axis.name, "last": by.axis.in_unit(by.last),
            "first": by.axis.in_unit(by.first),
            "at": None if by.at is None else by.axis.in_unit(by.at), "verdict": NAMES[by.verdict],
            "why": by.why,
        },
    }  # fmt: skip


def _sensitivity(one: Indices) -> dict[str, Any]:
    scatter = {}
    for what, (_, of, unit) in zip(("formula", "fe", "error"), quantities(one), strict=True):
        size = 1.0 if what == "error" else units.factor(unit)
        moments = zip(("mean", "sd", "q025", "q500", "q975"),
                      (of.mean, of.sd, of.low, of.median, of.high), strict=True)  # fmt: skip
        scatter[what] = {
            "n": of.n, **{name: _number(v / size) for name, v in moments},
            "noise": _number(of.noise), "why": of.why,
            "indices": {
                index.tolerance.name: {
                    name: [_number(v) for v in (e.value, e.low, e.high)]
                    for name, e in (("S1", index.first), ("ST", index.total))
                } for index in of.indices
            },
        }  # fmt: skip
    return {
        "rows": one.rows, "dropped": one.dropped, "scatter": scatter,
        "within": [asdict(w) for w in one.within],
    }  # fmt: skip


def _solved_by(solved: Solved) -> dict[str, Any]:
    part = solved.part
    formulas, fe = code_of(solved.plan.case, part)
    return {
        "portion": part.name, "levels": list(part.levels),
        "code": {"formulas": formulas, "fe": fe}, "versions": versions(part),
    }  # fmt: skip


def _timing(solved: Solved) -> dict[str, Any]:
    of = solved.timing
    return {
        "points": of.points, "wall_s": round(of.wall, 3), "busy_s": round(of.busy, 3),
        "workers": of.workers, "known": of.known, "overhead": round(of.overhead, 4),
    }  # fmt: skip


def _finite(values: Array) -> list[float | None]:
    return [_number(float(v)) for v in values]


def _number(value: float) -> float | None:
    """`value`, or None if it is not finite, because JSON has no NaN."""
    return float(value) if math.isfinite(value) else None
