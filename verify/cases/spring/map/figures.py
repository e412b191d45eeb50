"""Maps of the error of Eqs. 1-9, and a table on the effect of the path of the roller."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from verify.cases.spring.map.inputs import (
    ANGLES,
    DEEP_ANGLES,
    DEEP_LEAVES,
    DEEP_SEGMENTS,
    DEEP_SLENDER,
    LEAVES,
    SEGMENTS,
    SHARES,
    SLENDER,
)
from verify.core.case import Context
from verify.core.figures import Array, Curves, Map, Table
from verify.form.plots import dots, plot

mm = 1e-3
WHAT = (
    ("at small displacement", "head free in both models"),
    *(
        (f"at a displacement of {share:.0%} of the length", "head guided, leaves not in contact")
        for share in SHARES
    ),
)


def maps(name: str, m: Array, date: str) -> list[Map]:
    """Maps of the error: for small displacement, and for each displacement in `SHARES`.

    `date` is the date of the long study; it is empty if the maps are those of the present run.
    """
    deep, unstable = bool(date), f"guided spring unstable before {SHARES[-1]:.0%} compression"
    columns: Sequence[float]
    rows: Sequence[float]
    if name == "slender":
        labels = "L_0/b", "segments n"
        columns, rows = (DEEP_SLENDER, DEEP_SEGMENTS) if deep else (SLENDER, SEGMENTS)
        without, of = f"b ≥ r, or {unstable}", "n and L_0/b"
    else:
        labels = "L_1/r", "α [deg]"
        columns, rows = (DEEP_LEAVES, DEEP_ANGLES) if deep else (LEAVES, ANGLES)
        without, of = unstable, "α and L_1/r"
    return [
        Map(
            title=f"Error of Eqs. 1-9 over {of}, {when}", x_label=labels[0], y_label=labels[1],
            columns=tuple(f"{c:g}" for c in columns), rows=tuple(f"{row:g}" for row in rows),
            error=m[..., k], checked=np.isfinite(m[..., k]), without=without,
            note=f"Error of the force in per cent. Condition: {how}."
            + (f" Computed by `freewheel deep` on {date}." if deep else ""),
        )
        for k, (when, how) in enumerate(WHAT)
    ]  # fmt: skip


def radius(over: list[tuple[Array, Array]]) -> Curves:
    """Figure over b/R of the errors at small displacement, for all springs of both maps."""
    curves = [
        dots(name, x[np.isfinite(m)], 100 * m[np.isfinite(m)], k)
        for k, (name, (x, m)) in enumerate(
            zip(("over n and L_0/b", "over α and L_1/r"), over, strict=True)
        )
    ]
    return plot(
        "Error of k_1 at small displacement over b/R", "b/R", "error of k_1 [%]", curves,
        y_bottom=0.0,
        note="The error is caused by the inner radius, which Eqs. 1-9 use as radius of the centre "
        "line. The error depends mainly on b/R, with the radius R of the centre line.",
    )  # fmt: skip


def tables(q: Any, context: Context) -> Sequence[Table]:  # noqa: ARG001
    if not math.isfinite(q.F_x):
        return ()
    slope = math.degrees(math.atan2(q.y_r, q.x_r))
    longer = math.hypot(q.x_r, q.y_r) / q.x_r - 1
    rows = [
        ("relative amount by which the slanted path is longer than x_r", f"{longer:+.2%}"),
        ("angle between path and axis of the spring", f"{slope:.2f}°"),
        (
            "change of direction of the chamber wall along the path",
            f"{math.degrees(q.kappa * q.x_r):.2f}°",
        ),
        ("sagitta of the chamber wall along the path", f"{q.kappa * q.x_r**2 / 8 / mm:.3f} mm"),
        ("axial force at the end of a straight path, by Eq. 9", f"{q.k1 * q.x_r:.4g} N"),
        (
            "axial force at the end of a straight path, by the elastica with a guided head",
            f"{q.F_x_straight:.4g} N",
        ),
        ("axial force at the end of the roller's slanted path", f"{q.F_x:.4g} N"),
        ("transverse force at the end of the roller's slanted path", f"{q.F_y:.4g} N"),
    ]
    return (
        Table(
            title="Path of the roller, approximated by a straight line",
            header=("quantity", "value"),
            rows=tuple(rows),
            note="The spring is unloaded at the start of the path; the head does not rotate. The "
            "transverse force includes the lateral force that the spring exerts on a straight "
            "path.",
        ),
    )
