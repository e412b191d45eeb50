"""Figures of partial slip: sketch, tractions, loop, energies."""

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from analytic.contact import hertz_line, tangential_cycle
from verify.case import AlongLine, Drawn, converged, sketches
from verify.cases.contact.slip.formulas import SlipFormulas
from verify.cases.contact.slip.inputs import SHARES, STAGES
from verify.cases.contact.slip.reference import ACROSS, AROUND, GROWTH
from verify.core.case import Context
from verify.core.figures import Dots, Profile, Sketch
from verify.form.sketches import shape
from verify.judging.profiles import along

nm, uJ = 1e-9, 1e-6
FINE = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 201))  # x/a of curves, dense at the edges


def sketch(q: SlipFormulas) -> Sketch:
    """Sketch of both half discs; the contact is not to scale."""
    t = np.linspace(0.0, np.pi, 61)
    lower = np.column_stack([np.cos(t), np.sin(t) - 1])
    wall = 0.1
    return sketches.sketch(
        "two equal half discs; the lower cut is fixed, the upper cut is displaced along x and y",
        shape("modelled", lower * (1, -1)),
        shape("modelled", lower),
        sketches.arrow((0.0, -1.3), (0.0, 1.3), style="axis"),
        sketches.arrow((1 + wall, -1.0), (-1 - wall, -1.0), style="clamp"),
        sketches.arrow((0.0, 1.55), (0.0, 1.05), "P"),
        sketches.arrow((-1.6, 1.0), (-1.08, 1.0), "Q"),
        sketches.leader((1.5, 0.42), (0.05, 0.0), f"contact, a = {q.shown('a')}"),
        sketches.leader((1.5, -0.42), (0.02, -0.01), f"stick zone, c = {q.shown('c')}"),
        sketches.leader((-1.5, -0.3), (-0.86, -0.5), f"R = {q.shown('R')}"),
        sketches.room(2.4, 2.6),
    )  # fmt: skip


def figures() -> Iterator[AlongLine | Drawn]:
    """Figures: tractions, growth of the slip zones, loop of a cycle, energies."""
    yield converged(_first_loading)
    yield AlongLine(
        title="Stick half-width over the tangential force", x=("Q/(μP)", "1"), y=("c/a", "1"),
        curve=lambda k: np.sqrt(1 - k), reference="profile, growth", at=GROWTH,
        points=np.linspace(0.0, 1.0, 201), order=1.0, scale=1.0,
        note="Line: Cattaneo; dots: stick half-width from the moments of the traction.",
    )  # fmt: skip
    yield converged(_cycle)
    yield converged(_loop)
    yield converged(_energies)


def _first_loading(context: Context) -> Profile:
    """Figure: tractions of the first loading at all ratios Q/(μP), as one line."""
    q = context.inputs
    limit = q.mu * hertz_line.pressure(FINE * q.a, a=q.a, p_0=q.p_0)
    edges = ", ".join(f"±{math.sqrt(1 - k):.3f} a" for k in SHARES)
    lines = [q.first_traction(FINE * q.a, k) for k in SHARES] + [limit]
    at = [q.first_traction(ACROSS * q.a, k) for k in SHARES]
    return _chained(
        context, lines, at, [f"k = {k:g}" for k in SHARES],
        title="Traction under Q/(μP) = 0.2, 0.4, 0.6, 0.8",
        note=f"The outermost line is μp, the traction in sliding. Each traction deviates from this "
        f"line inside its stick zone. For increasing Q, its edges are at {edges}.",
    )  # fmt: skip


def _cycle(context: Context) -> Profile:
    q = context.inputs
    stages = (1.0, *STAGES)
    lines, at = ([q.cycle_traction(x * q.a, s) for s in stages] for x in (FINE, ACROSS))
    return _chained(
        context, lines, at,
        [f"Q/Q_max = {s:g}" for s in stages],
        title="Traction during unloading: Q/Q_max = 1, 0.5, 0, −0.5, −1",
        note="The lines have this order from top to bottom. Reverse slip starts at the edges; at "
        "Q = 0, the traction is not zero.",
    )  # fmt: skip


def _chained(
    context: Context, curves: list[Any], references: list[Any], names: list[str], *, title: str,
    note: str,
) -> Profile:  # fmt: skip
    """Figure of several curves over x/a, which all end at zero, drawn as one line."""
    scale = context.inputs.mu * context.inputs.p_0
    found = [along(context, f"profile, {name}", formal=1.0, scale=scale) for name in names]

    def chain(parts: Sequence[Any]) -> Any:
        return np.concatenate([part[:: (-1) ** i] for i, part in enumerate(parts)])

    x = np.tile(ACROSS, len(names))
    order = np.argsort(x, kind="stable")
    y_fem = np.concatenate([values for values, _ in found])[order] / scale
    return Profile(
        title=title, x_label="x/a", y_label="q/(μp_0)", x=chain([FINE] * len(curves)),
        y=chain(curves) / scale, x_fem=x[order], y_fem=y_fem,
        y_ref=np.concatenate(references)[order] / scale,
        u=np.full(x.size, max(u.max() for _, u in found)) / scale, scale=1.0,
        note=note + " Lower diagram: lines minus dots; band: mesh uncertainty.",
    )  # fmt: skip


def _loop(context: Context) -> Profile:
    q = context.inputs
    load = {"Q_max": q.share * q.mu * q.P, **q.moved}

    def beyond(s: Any) -> Any:
        return tangential_cycle.beyond_chord(s, **load)

    fine = np.linspace(-1.0, 1.0, 101)
    scale = q.delta_0
    values, u = along(context, "profile, loop", formal=1.0, scale=scale)
    x = np.concatenate([AROUND[::-1], AROUND])
    order = np.argsort(x, kind="stable")
    return Profile(
        title="Displacement over the tangential force", x_label="Q/Q_max", y_label="δ − δ_c [nm]",
        x=np.concatenate([fine[::-1], fine]), y=beyond(fine) / nm, x_fem=x[order],
        y_fem=values[order] / nm, y_ref=beyond(AROUND)[order] / nm, u=u / nm, scale=scale / nm,
        scale_name="δ(0)",
        note="Displacement δ minus the chord δ_c, the straight line between both reversals of Q. "
        "The upper branch is unloading. The area of the loop is the energy lost in a cycle.",
    )  # fmt: skip


def _energies(context: Context) -> Dots:
    finest = context.fem[-1].values
    return Dots(
        title="Energy lost in a cycle", label="W [µJ/m]",
        items=(
            ("Mindlin", context.inputs.W / uJ, None, "formula"),
            ("FE, work of friction", finest["work"] / uJ, None, "fe"),
            ("FE, area of the loop", finest["area"] / uJ, None, "fe"),
        ),
        note="The work of friction is summed over nodes and steps; the area of the loop follows "
        "from forces and displacements of the upper cut.",
    )  # fmt: skip
