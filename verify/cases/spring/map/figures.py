"""Maps of the error of Eqs. 1-9, and the effect of the roller's path."""

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
    ("at small displacement", "head free in both"),
    *((f"at {share:.0%} of the length", "head guided, no contact") for share in SHARES),
)


def maps(name: str, m: Array, date: str) -> list[Map]:
    """A map for small displacement and one for each share of the length.

    `date` is the date of the measurement of the finer cells, empty for cells of the run.
    """
    deep, unstable = bool(date), f"guided spring unstable before {SHARES[-1]:.0%} of its length"
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
            title=f"Eqs. 1-9 over {of}, {when}", x_label=labels[0], y_label=labels[1],
            columns=tuple(f"{c:g}" for c in columns), rows=tuple(f"{row:g}" for row in rows),
            error=m[..., k], checked=np.isfinite(m[..., k]), without=without,
            note=f"Error of the force in per cent; {how}."
            + (f" Measured by freewheel deep on {date}." if deep else ""),
        )
        for k, (when, how) in enumerate(WHAT)
    ]  # fmt: skip


def radius(over: list[tuple[Array, Array]]) -> Curves:
    """All cells of both maps at small displacement over b/R."""
    curves = [
        dots(name, x[np.isfinite(m)], 100 * m[np.isfinite(m)], k)
        for k, (name, (x, m)) in enumerate(
            zip(("over n and L_0/b", "over α and L_1/r"), over, strict=True)
        )
    ]
    return plot(
        "Error at small displacement over b/R", "b/R", "error of k_1 [%]", curves,
        y_bottom=0.0,
        note="The inner radius in place of the centre line's: no other number of the spring "
        "matters as much.",
    )  # fmt: skip


def tables(q: Any, context: Context) -> Sequence[Table]:  # noqa: ARG001
    if not math.isfinite(q.F_x):
        return ()
    slope = math.degrees(math.atan2(q.y_r, q.x_r))
    longer = math.hypot(q.x_r, q.y_r) / q.x_r - 1
    rows = [
        ("slanted path over its straight part", f"{longer:+.2%}"),
        ("direction of the path against the spring's axis", f"{slope:.2f}°"),
        ("rotation of the chamber's wall along the path", f"{math.degrees(q.kappa * q.x_r):.2f}°"),
        ("bow of the wall over the path", f"{q.kappa * q.x_r**2 / 8 / mm:.3f} mm"),
        ("force at the end of a straight path, Eq. 9", f"{q.k1 * q.x_r:.4g} N"),
        ("the same, guided elastica", f"{q.F_x_straight:.4g} N"),
        ("axial force at the end of the slanted path", f"{q.F_x:.4g} N"),
        ("transverse force there", f"{q.F_y:.4g} N"),
    ]
    return (
        Table(
            title="The roller's path, taken as straight",
            header=("what", "value"),
            rows=tuple(rows),
            note="The head is guided without rotation from the unloaded spring on. The transverse "
            "force is added to the lateral force of the spring on a straight path.",
        ),
    )
