"""Figures and tables of the whole curve: force over displacement, shapes, readings, points."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from fem.beam.two_lines import TOUCH, FittedLines
from verify.cases.spring.claims import stored
from verify.cases.spring.curve.claims import (
    deviations,
    ends_early,
    lines,
    read,
)
from verify.cases.spring.curve.reference import FINE, LEVELS
from verify.cases.spring.stages.readings import eq10
from verify.core.case import Context
from verify.core.figures import Array, Curves, Figure, Panel, Shapes, Table
from verify.form.plots import curve, dashes, dots, line, plot
from verify.papers.ledger import published

mm, N_PER_MM = 1e-3, 1e3
TABLE_N = 18.0  # N, the end load of the paper's finite elements


def figures(context: Context) -> Sequence[Figure]:
    if len(context.fem) < len(LEVELS):  # not run, or a curve broke off
        return ()
    found: list[Figure] = [_curve(context), _whole(context), _slope(context), _states(context)]
    return (*found, _readings(context)) if context.is_paper else tuple(found)


def _own(context: Context) -> tuple[Array, Array]:
    U, F = (stored(context, f"curve {FINE} {key}") for key in ("U", "F"))
    return np.append(0.0, U), np.append(0.0, F)


def _curve(context: Context) -> Curves:
    """Figure of force over displacement up to the stroke, with linear theory, Eq. 10 and tests."""
    q = context.inputs
    U, F = _own(context)
    within = q.stroke * (1 + 1e-9) >= U
    at = np.linspace(0, q.stroke, 200)
    curves = [
        line("beams with contact", U[within] / mm, F[within], 1),
        dashes("closed form (linear)", at / mm, q.linear.force(at)),
    ]
    if context.is_paper:
        k1, k2 = (published(f"wang2023:{k}-test").value for k in ("k1", "k2"))
        test = np.where(at < eq10().U, k1 * at / mm, k1 * eq10().U / mm + k2 * (at - eq10().U) / mm)
        curves += [
            dots("Eq. 10", at[::8] / mm, eq10().force(at[::8]), 3),
            dashes("slopes of the tests", at / mm, test, 4),
        ]
    kink = (
        "At the kink (A), the leaves of head and tail touch the adjacent leaves."
        if np.isfinite(lines(context).U_A) else "No leaves touch within the stroke."
    )  # fmt: skip
    tests = " The paper prints only the slopes of its test lines; they are drawn from the origin."
    return plot(
        "Force over displacement until the loops touch", "U [mm]", "F [N]", curves,
        note=kink + tests * context.is_paper,
    )  # fmt: skip


def _whole(context: Context) -> Curves:
    U, F = _own(context)
    return plot(
        "The whole curve", "U [mm]", "F [N]", line("beams with contact", U / mm, F, 1),
        note="Stages: OA free, AB leaves in contact, BE loops in contact. The curve ends "
        + ("because no equilibrium was found; this is not a limit of the spring."
           if ends_early(context) else
           "where the force is twice the force at the end of the stroke, or at 1.24 times the "
           "stroke if this is reached first."),
    )  # fmt: skip


def _slope(context: Context) -> Curves:
    U, F = _own(context)
    q = context.inputs
    k, middle = np.diff(F) / np.diff(U) / N_PER_MM, (U[1:] + U[:-1]) / 2
    form = q.linear
    kink = min(float(form.U_A), q.stroke)
    at = np.array([0, kink, kink, q.stroke])
    level = np.array([form.k1, form.k1, form.k2, form.k2], float) / N_PER_MM
    curves = [
        line("beams with contact", middle / mm, k, 1),
        dashes("closed form (linear)", at / mm, level),
    ]
    if context.is_paper:
        steps = np.array([0, eq10().U, eq10().U, q.stroke]) / mm
        printed = np.array([eq10().k1, eq10().k1, eq10().k2, eq10().k2]) / N_PER_MM
        curves.append(dashes("Eq. 10", steps, printed, 3))
    return plot(
        "Stiffness over displacement", "U [mm]", "dF/dU [N/mm]", curves,
        y_bottom=0.9 * float(k.min()), y_top=1.6 * float(k[0]),
        note="In the free stage, the stiffness decreases and then increases, because the leaves "
        "rotate; linear theory has two constant values."
        if np.isfinite(lines(context).U_A) else "No leaves touch within the stroke.",
    )  # fmt: skip


def points(context: Context) -> dict[str, int]:
    """Indices of states: O unloaded, A first contact, B half of the pairs in contact, E end."""
    press, F = (stored(context, f"curve {FINE} {key}") for key in ("press", "F"))
    found = {"O": -1}
    touching = press.sum(axis=1) > TOUCH * F
    half = (press > TOUCH * F[:, None]).sum(axis=1) >= press.shape[1] / 2
    if touching.any():
        found["A"] = int(np.argmax(touching))
    if half.any():
        found["B"] = int(np.argmax(half))
    return found | {"E": len(F) - 1}


def _states(context: Context) -> Shapes:
    shapes, touches, U = (
        stored(context, f"curve {FINE} {key}") for key in ("shapes", "touches", "U")
    )
    rest = stored(context, "rest")
    panels = []
    for name, k in points(context).items():
        line = (rest if k < 0 else shapes[k]) / mm
        own = touches[touches[:, 0] == k, 1:] / mm
        words = f"{name}: {0 if k < 0 else U[k] / mm:.3g} mm"
        panels.append(Panel(name=words, lines=(line,), dots=own))
    return Shapes(
        title="Deformed shapes", unit="mm", panels=tuple(panels),
        thickness=context.inputs.b / mm, dots_name="contacts",
        note="The lines are as thick as the strip. B: half of the pairs of adjacent leaves touch.",
    )  # fmt: skip


def _readings(context: Context) -> Curves:
    """Figure of the difference of each reading from Eq. 10 over the displacement."""
    curves = []
    for k, (name, found) in enumerate(_stable(context)):
        U, F = found
        curves.append(
            curve(name, U / mm, 100 * (F / eq10().force(U) - 1), "line" if k < 6 else "dashes",
                  k % 6)
        )  # fmt: skip
    return plot(
        "Readings of the paper's spring against Eq. 10", "U [mm]",
        "difference of F from Eq. 10 [%]", curves,
        note="The name of a reading states the clamp of the tail, the head, and the radius of the "
        "centre line of the arcs. All springs have the width factor f. Springs with a free head "
        "buckle at 1.5 mm and are not drawn.",
    )  # fmt: skip


def _stable(context: Context) -> list[tuple[str, Array]]:
    f = context.inputs.width_factor
    return [(name, curve) for name, factor, _, curve in read(context)
            if factor == f and "free" not in name]  # fmt: skip


def tables(_: Any, context: Context) -> Sequence[Table]:
    if len(context.fem) < len(LEVELS):  # not run, or a curve broke off
        return ()
    if not context.is_paper:
        return (_points(context),)
    return (_points(context), _forces(context), _combinations(context))


def _points(context: Context) -> Table:
    U, F = (stored(context, f"curve {FINE} {key}") for key in ("U", "F"))
    found, form = lines(context), context.inputs.linear
    most = float(abs(stored(context, f"curve {FINE} side") / F).max())
    rows: list[tuple[str, float, float, str]] = []
    words = {"B": "half of the pairs of adjacent leaves touch", "E": "end of the curve"}
    if np.isfinite(found.U_A):
        rows.append(
            ("A", found.U_A / mm, found.F_A, "first contact, at the leaves of head and tail")
        )
    rows += [(name, U[k] / mm, F[k], words[name]) for name, k in points(context).items()
             if name in words]  # fmt: skip
    if context.is_paper:
        there = float(np.interp(TABLE_N, F, U))
        rows.append((f"{TABLE_N:g} N", there / mm, TABLE_N, "final load of the paper's model"))
    if np.isfinite(form.U_A):
        rows.append(("A, linear", float(form.U_A) / mm, float(form.F_A),
                     "first contact by the closed form of linear theory"))  # fmt: skip
    return Table(
        title="Points of the curve", header=("point", "U [mm]", "F [N]", "event"),
        rows=tuple((name, round(u, 3), round(f, 3), what) for name, u, f, what in rows),
        note="In the paper, the tail slides on its base between the points C and D. These points "
        f"do not occur here, because the tail is clamped. The lateral force on the clamp is at "
        f"most {most:.2g} F.",
    )  # fmt: skip


def _forces(context: Context) -> Table:
    U, off = deviations(context, FINE)
    q = context.inputs
    F, theory = (1 + off) * eq10().force(U), published("wang2023:k1-theory").value * U / mm
    form = q.linear.force(U)
    rows = tuple(
        (round(u / mm), round(f, 4), round(p, 4), _percent(f / p - 1), _percent(t / f - 1),
         _percent(c / f - 1))
        for u, f, p, t, c in zip(U, F, eq10().force(U), theory, form, strict=True)
    )  # fmt: skip
    return Table(
        title="F(U) against Eq. 10", rows=rows,
        header=("U [mm]", "F, beams [N]", "Eq. 10 [N]", "beams against Eq. 10",
                "0.601 U against beams", "closed form against beams"),
        note="The reading of the paper is chosen only by its k_1. All other values are "
        "predictions.",
    )  # fmt: skip


def _combinations(context: Context) -> Table:
    """Table of all readings with all width factors."""
    test = {k: published(f"wang2023:{k}-test").value * N_PER_MM for k in ("k1", "k2")}
    rows = []
    for name, factor, found, forces in read(context):
        if "free" in name:  # it has buckled
            rows.append((name, round(factor, 4), None, None, None, None, None, None, None))
            continue
        rows.append((name, round(factor, 4), *_beside(found, forces, test)))
    return Table(
        title="Readings of the paper's spring at large displacement", rows=tuple(rows),
        header=("tail, head, arcs", "f", "k_1 [N/mm]", "against Eq. 10", "k_2 [N/mm]",
                "against Eq. 10", "U of intersection against Eq. 10", "F at 17 mm against Eq. 10",
                "k_1, k_2 against the tests"),
        note="k_1 and k_2 are slopes of least-squares lines before and after the leaves touch, as "
        "in Eq. 10. Springs with a free head buckle at about 1.5 mm and 0.9 N and have no lines.",
    )  # fmt: skip


def _beside(found: FittedLines, curve: Array, test: dict[str, float]) -> tuple[Any, ...]:
    last = curve[1, -1] / eq10().force(curve[0, -1:])[0] - 1
    return (
        round(found.k1 / N_PER_MM, 4), _percent(found.k1 / eq10().k1 - 1),
        round(found.k2 / N_PER_MM, 4), _percent(found.k2 / eq10().k2 - 1),
        _percent(found.U / eq10().U - 1), _percent(last),
        f"{_percent(found.k1 / test['k1'] - 1)}, {_percent(found.k2 / test['k2'] - 1)}",
    )  # fmt: skip


def _percent(share: float) -> str:
    return f"{100 * share:+.1f} %"
