"""Figures of a sweep: error over the varied inputs, values of formula and finite elements."""

import math
from collections.abc import Sequence
from itertools import combinations, product

import numpy as np
from numpy.typing import NDArray

from reports.measured import LIMITS, Measured
from reports.sweep import Panels, Picture
from reports.sweep_plots import Causes, Histogram, reach
from reports.validity_map import LEAST
from verify.core import units
from verify.core.figures import Array, Band, Curve, Curves
from verify.core.verdicts import Safe
from verify.studies.sweep.axes import Axis, Tolerance
from verify.studies.sweep.indices import Indices, Scatter
from verify.studies.sweep.outcome import Course
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.region import Region, lines
from verify.studies.sweep.tables import quantities, with_unit
from verify.verdicts.of_sweep import safe_side

UNSAFE = {Safe.ABOVE: -1, Safe.BELOW: 1, Safe.NEITHER: 0}  # sign of errors on the unsafe side
MIDDLE = LIMITS[1]  # whose region maps outline
MOST_PANELS, MOST_PAIRS, MOST_CURVES, MOST_DOTS = 12, 6, 4, 500
ERROR = "Formula minus finite elements, in %."
MATTERS = 0.1  # share of the points whose bar reaches across a limit, from which on it is drawn
LINES = " Lines mark where the error crosses a limit, by linear interpolation between points."
QUANTILES = ("2.5 %", "50 %", "97.5 %")


def of_grid(plan: Plan, course: Course, regions: Sequence[Region]) -> Sequence[Picture]:
    """Figures of a grid: a curve or a map of the error, and the compared values."""
    if plan.star:
        return [_of_line(plan, course, k) for k in range(len(plan.axes))]
    if len(plan.axes) == 1:
        return [_of_line(plan, course, 0), _values_1d(plan, course)]
    if len(plan.axes) > 2:
        return []
    x, y = plan.axes
    box = next((r.box for r in regions if r.limit == MIDDLE and not r.everywhere), ())
    error, U = (v.reshape(plan.shape) for v in (course.error, course.U_error))
    lined = min(plan.shape) >= LEAST
    found: list[Picture] = [
        _map((x, y), error, U, title="Error of the formula",
            note=f"{ERROR} Each cell represents the point at its centre." + LINES * lined,
            nominal=True,
            box=tuple((r.axis.in_unit(r.low), r.axis.in_unit(r.high)) for r in box),
            unsafe=UNSAFE[safe_side(plan, course)],
        ),
        _values_2d(plan, course),
    ]  # fmt: skip
    across = sum(r.undecided for r in regions)
    if across > MATTERS * len(plan.points):
        found.append(
            _map((x, y), U, np.zeros_like(U), title="Error bar",
                note="Half-width of the error bar in %: the uncertainty of the finite elements.",
                 nominal=True)
        )  # fmt: skip
    return found


def panels(plan: Plan, course: Course) -> Sequence[Panels]:
    """Maps for more than two axes: largest error over the other axes, and cuts at fixed values."""
    if plan.star or len(plan.axes) < 3:
        return ()
    shape = plan.shape
    error, U = (v.reshape(shape) for v in (course.error, course.U_error))
    others, last = plan.axes[:-2], plan.axes[-2:]
    unsafe = UNSAFE[safe_side(plan, course)]
    places = list(product(*(range(n) for n in shape[:-2])))
    some = _evenly(len(places), MOST_PANELS)
    cuts = tuple(
        _map(last, error[places[k]], U[places[k]], title=", ".join(
            f"{a.symbol} = {_valued(a, a.values[i])}"
            for a, i in zip(others, places[k], strict=True)
        ), nominal=all(_at_nominal(a, a.values[i]) for a, i in zip(others, places[k], strict=True)),
        unsafe=unsafe)
        for k in some
    )  # fmt: skip
    left_out = "" if len(some) == len(places) else (
        f" {len(some)} of {len(places)} cuts are drawn; all points are in points.csv."
    )  # fmt: skip
    pairs = list(combinations(range(len(shape)), 2))[:MOST_PAIRS]
    worst = tuple(_worst(plan.axes, error, U, pair, unsafe) for pair in pairs)
    return (
        Panels(title="The largest error over all other axes", maps=worst,
               note="Each cell represents all points with these two values: if the cell is "
                    "within a "
               "limit, all solved points of the cell are within it."),
        Panels(title=f"Cuts: error over {last[0].symbol} and {last[1].symbol}", maps=cuts,
               note="Each cut is at fixed values of the other axes; a cell represents the "
                    "point at its centre."
               f"{left_out}"),
    )  # fmt: skip


def of_sample(plan: Plan, course: Course, found: Indices) -> Sequence[Picture]:
    """Figures of a sample: histograms, causes of scatter, error over the most influential input."""
    independent = np.arange(len(plan.points)) < 2 * plan.base
    factor = units.factor(course.pair.unit)
    label = with_unit(course.pair.symbol, course.pair.unit)
    drawn: list[Picture] = []
    if found.fe.n:
        name = quantities(found)[1][0]
        drawn.append(_histogram(f"{label}, {name}", course.fe[independent] / factor, found.fe,
                                factor, "Result"))  # fmt: skip
        drawn.append(_histogram("error [%]", 100 * course.error[independent], found.error, 0.01,
                                "Error of the formula", limits=True))  # fmt: skip
    for what, scatter, _ in quantities(found):
        if scatter.indices:
            drawn.append(
                Causes(
                    title=f"Causes of scatter: {'error' if what == 'error' else f'result: {what}'}",
                    items=tuple((i.tolerance.symbol, (i.first.value, i.first.low, i.first.high),
                                 (i.total.value, i.total.low, i.total.high))
                                for i in scatter.ranked),
                    note="Sobol indices with 95 % intervals.",
                )
            )  # fmt: skip
    if found.error.indices:
        drawn.append(_dots(plan, course, found.error.ranked[0].tolerance, independent))
    return drawn


def _map(
    axes: Sequence[Axis], error: Array, U: Array, *, title: str, note: str = "",
    box: tuple[tuple[float, float], ...] = (), nominal: bool = False, unsafe: int | None = None,
) -> Measured:  # fmt: skip
    """Map of the error over two axes; `nominal` is True if all other inputs are as in the file."""
    x, y = axes
    return Measured(
        title=title, x=_shown(x), x_label=_label(x), y=_shown(y), y_label=_label(y), error=error,
        U=U, nominal=_nominal(axes) if nominal else None,
        box=(box[0], box[1]) if len(box) == 2 else None,
        box_name=f"largest region within {100 * MIDDLE:g} %", note=note,
        log=(x.spacing == "log", y.spacing == "log"), unsafe_sign=unsafe,
    )  # fmt: skip


def _of_line(plan: Plan, course: Course, k: int) -> Measured:
    line = list(lines(plan, 0))[k]
    a = line.axis
    return Measured(
        title=f"Error over {a.symbol}", x=line.x / units.factor(a.unit), x_label=_label(a),
        error=course.error[line.points], U=course.U_error[line.points], nominal=_nominal([a]),
        log=(a.spacing == "log", False),
        note=f"{ERROR} The error bar is shaded. The strips below mark where the whole error bar "
             "is within a limit, up to "
        "halfway between points." + " All other inputs have the values of the file." * plan.star
        + " The ring on the axis marks the value in the file." * _reached(a),
    )  # fmt: skip


def _values_1d(plan: Plan, course: Course) -> Curves:
    (a,) = plan.axes
    return _curves(course, a, [(slice(None), "")])


def _values_2d(plan: Plan, course: Course) -> Curves:
    x, y = plan.axes
    table = np.arange(len(plan.points)).reshape(plan.shape)
    rows = [
        (table[:, j], f"{y.symbol} = {_valued(y, y.values[j])}")
        for j in _evenly(len(y.values), MOST_CURVES)
    ]
    return _curves(course, x, rows)


def _curves(
    course: Course, a: Axis, rows: Sequence[tuple[slice | NDArray[np.int_], str]]
) -> Curves:
    """Plot of formula and finite elements over one axis, for some values of another axis."""
    x = _shown(a)
    factor, by = units.factor(course.pair.unit), course.pair.by or "finite elements"
    drawn, bands = [], []
    for k, (points, name) in enumerate(rows):
        formula, fe, U = (v[points] / factor for v in (course.formula, course.fe, course.U))
        drawn += [
            Curve(name=f"formula, {name}" if name else "formula", x=x, y=formula, colour=k),
            Curve(name=by if k == 0 else "", x=x, y=fe, style="dots", colour=k),
        ]
        if np.isfinite(U).sum() > 1:
            bands.append(Band(name="", x=x, lower=fe - U, upper=fe + U, colour=k))
    every = np.concatenate([c.y[np.isfinite(c.y)] for c in drawn])
    low, high = (float(every.min()), float(every.max())) if every.size else (0.0, 1.0)
    near = low > 0.4 * high > 0
    return Curves(
        title="Formula and finite elements", x_label=_label(a), x_log=a.spacing == "log",
        y_label=with_unit(course.pair.symbol, course.pair.unit), curves=tuple(drawn),
        bands=tuple(bands), y_bottom=low - 0.1 * (high - low) if near and high > low else None,
        note="Lines: formula; dots: finite elements on the finest mesh, with their error bar.",
    )  # fmt: skip


def _worst(
    axes: Sequence[Axis], error: Array, U: Array, pair: tuple[int, int], unsafe: int
) -> Measured:
    """Map of the largest error, including its error bar, over all axes except two."""
    seen = [axes[k] for k in pair]
    rest = tuple(k for k in range(error.ndim) if k not in pair)
    flat = error.transpose(*pair, *rest).reshape(*(error.shape[k] for k in pair), -1)
    bars = U.transpose(*pair, *rest).reshape(flat.shape)
    size = np.where(np.isfinite(flat + bars), np.abs(flat) + bars, -1.0)
    at = size.argmax(axis=-1)[..., None]
    e, b = (np.take_along_axis(v, at, axis=-1)[..., 0] for v in (flat, bars))
    return _map(seen, e, b, title=f"{seen[0].symbol} and {seen[1].symbol}", unsafe=unsafe)


def _histogram(
    label: str, values: Array, scatter: Scatter, factor: float, title: str, *, limits: bool = False
) -> Histogram:
    ends = (scatter.low / factor, scatter.median / factor, scatter.high / factor)
    known = values[np.isfinite(values)]
    left, right = reach(known)
    seen = tuple(100 * v for v in LIMITS if limits
                 and (left < 100 * v < right or left < -100 * v < right))  # fmt: skip
    return Histogram(
        title=title, label=label, values=known,
        quantiles=tuple(zip(ends, QUANTILES, strict=True)),
        limits=seen, note="Dotted: quantiles." + " Dashed: the limits." * bool(seen),
    )  # fmt: skip


def _dots(plan: Plan, course: Course, one: Tolerance, independent: NDArray[np.bool_]) -> Curves:
    k = plan.names.index(one.name)
    known = np.flatnonzero(independent & np.isfinite(course.error))
    some = known[list(_evenly(len(known), MOST_DOTS))]
    x = plan.points[some, k] / units.factor(one.unit)
    y = 100 * course.error[some]
    return Curves(
        title=f"Error over {one.symbol}, the most influential input", x_label=_label(one),
        y_label="error [%]", curves=(Curve(name="", x=x, y=y, style="dots"),),
        y_bottom=float(y.min() - 0.05 * (np.ptp(y) or 1.0)),
        note="All other inputs also vary within their tolerances.",
    )  # fmt: skip


def _nominal(axes: Sequence[Axis]) -> tuple[float, ...] | None:
    found = [None if a.nominal is None else a.in_unit(a.nominal) for a in axes]
    return None if None in found else tuple(v for v in found if v is not None)


def _at_nominal(a: Axis, value: float) -> bool:
    """Whether a value equals the value in the file."""
    return a.nominal is not None and math.isclose(a.in_unit(a.nominal), a.in_unit(value))


def _reached(a: Axis) -> bool:
    """Whether the value in the file is between the ends of the axis."""
    return a.nominal is not None and a.values[0] <= a.nominal <= a.values[-1]


def _shown(a: Axis) -> Array:
    return np.array([a.in_unit(v) for v in a.values])


def _label(a: Axis | Tolerance) -> str:
    return with_unit(a.symbol, a.unit)


def _valued(a: Axis, value: float) -> str:
    return f"{a.in_unit(value):.4g}{'' if a.unit == '1' else f' {a.unit}'}"


def _evenly(count: int, most: int) -> Sequence[int]:
    """At most `most` evenly distributed numbers below `count`, including the first and the last."""
    return sorted({round(v) for v in np.linspace(0, count - 1, min(count, most))})
