"""Figures of spheres in contact: sketch, profiles, errors of Hertz's theory, pictures."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from analytic.contact import hertz_point
from verify.case import AlongLine, Drawn, converged, sketches
from verify.cases.contact.sphere.formulas import SphereFormulas
from verify.cases.contact.sphere.inputs import END
from verify.cases.contact.sphere.reference import ACROSS, DEEP, VIEW
from verify.core.case import Context
from verify.core.figures import Array, Dots, Picture, Sketch
from verify.form.sketches import shape


def sketch(q: SphereFormulas) -> Sketch:
    """Sketch of both spheres to scale; of a far larger sphere, only the part near the contact."""
    R = q.R_2 / q.R_1  # the upper sphere has radius 1 about (0, 1)
    t = np.linspace(0, 2 * np.pi, 145)
    ball = np.column_stack([np.sin(t), 1 + np.cos(t)])
    turn = np.arcsin(min(1.0, 1.6 / R))
    cap = np.linspace(-turn, turn, 61)
    deep = min(R, 1.7)
    lower = np.column_stack([R * np.sin(cap), R * (np.cos(cap) - 1)])
    lower = np.vstack([lower, [[lower[-1, 0], -deep], [lower[0, 0], -deep]]])
    right = max(float(lower[:, 0].max()), 1.0)
    return sketches.sketch(
        f"spheres under P = {q.shown('P')}, to scale; in a second problem, a rigid flat replaces "
        "the lower sphere",
        shape("body", lower),
        shape("body", ball),
        shape("modelled", np.vstack([[[0.0, 1.0]], ball[36:73]])),
        sketches.arrow((0.0, -deep - 0.2), (0.0, 2.6), style="axis"),
        sketches.arrow((-1.2, 1.0), (1.2, 1.0), style="axis"),
        sketches.arrow((0.0, 2.55), (0.0, 2.0), "P"),
        sketches.leader((-1.7, 1.9), (-0.8, 1.6), f"R_1 = {q.shown('R_1')}"),
        sketches.leader((-right - 0.5, -deep - 0.25), (-0.6 * right, -0.7 * deep),
                        f"R_2 = {q.shown('R_2')}"),
        sketches.leader((1.7, 1.9), (0.45, 0.6), "FE: axisymmetric"),
        sketches.leader((1.7, 0.45), (0.03, 0.01), f"a = {q.shown('a')}"),
    )  # fmt: skip


def pressure(q: SphereFormulas, words: str) -> AlongLine:
    """Figure of the contact pressure over the radius."""
    return AlongLine(
        title=f"Contact pressure of the upper sphere on {words}", x=("r", "µm"), y=("p", "MPa"),
        curve=lambda r: hertz_point.pressure(r, a=q.a, p_0=q.p_0), reference=f"p{END[q.pair]}",
        at=q.a * ACROSS, points=np.linspace(0, 1.05 * q.a, 211), order=2.0, scale=q.p_0,
        scale_name="p_0",
        note="Line: Hertz; dots: finite elements. Near the edge of the contact, a small change of "
        "the contact radius changes p strongly.",
    )  # fmt: skip


def stresses(q: SphereFormulas, body: str) -> Iterator[AlongLine]:
    """Figures: radial and axial stress on the axis of `body`, with a common uncertainty."""
    nu = q.nu_1 if body == "upper" else q.nu_2
    shared: dict[str, Any] = {
        "x": ("depth", "µm"), "reference": f"axis_{body}", "at": q.a * DEEP, "order": 2.0,
        "points": np.linspace(0, DEEP[-1] * q.a, 201), "scale": q.p_0, "scale_name": "p_0",
        "neglects": True,
        "note": "Line: half-space under Hertz's pressure; band: uncertainty of the finite "
        "elements only.",
    }  # fmt: skip

    def on_axis(z: Array) -> tuple[Array, Array]:
        return hertz_point.axis_stresses(z, a=q.a, p_0=q.p_0, nu=nu)

    where = f"stress on the axis of the {body} sphere (contact of two spheres)"
    yield AlongLine(title=f"Radial {where}", y=("σ_r", "MPa"), curve=lambda z: on_axis(z)[0],
                    part=(0, DEEP.size), **shared)  # fmt: skip
    yield AlongLine(title=f"Axial {where}", y=("σ_z", "MPa"), curve=lambda z: on_axis(z)[1],
                    part=(DEEP.size, None), **shared)  # fmt: skip


def errors(q: SphereFormulas) -> Drawn:
    """Figure: errors of Hertz's theory, without and with the first-order correction."""

    @converged
    def drawn(context: Context) -> Dots:
        items: list[tuple[str, float, float | None, str]] = []
        for key, words in (("a", "a"), ("p_0", "p_0"), ("approach", "δ")):
            fe = context.series(f"{key}{END[q.pair]}")[1][-1]
            for label, suffix in (("Hertz", ""), ("first-order correction", "_finite")):
                error = (getattr(q, f"{key}{suffix}") / fe - 1) * 1e4
                items.append((f"{words}, {label}", error, None, "formula"))
        items.append(("finite elements", 0.0, None, "fe"))
        where = "on a rigid flat" if q.pair == "flat" else "on the lower sphere"
        return Dots(
            title=f"Error of Hertz's theory: upper sphere {where}",
            label="formula / FE − 1 [1/10 000]", items=tuple(items),
            note="The correction is of first order in a/R. After the correction, the remaining "
            "difference consists of the mesh error and terms of second order.",
        )  # fmt: skip

    return drawn


def pictures(a: float) -> Iterator[Picture]:
    """Pictures of stresses near the contact of both spheres; `a` is the contact radius."""
    reach = VIEW * a * 0.65
    for data, symbol, words in (
        ("von_mises", "σ_v", "Von Mises stress"), ("axial_stress", "σ_z", "Axial stress"),
    ):  # fmt: skip
        yield Picture(field="sphere", data=data, symbol=symbol, unit="MPa", factor=1e6,
                      mirror=("x",), displacement="", window=(-reach, -reach, reach, reach),
                      caption=f"{words} near the contact of spheres (mean value of each cell)",
                      )  # fmt: skip
