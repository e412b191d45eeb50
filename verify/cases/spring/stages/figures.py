"""Figures of the spring beyond its free stage: force over displacement, with Eq. 10."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from analytic.spring import frame
from verify.case import AlongLine
from verify.cases.spring.stages.inputs import StagesInputs
from verify.cases.spring.stages.readings import EQ10_END, eq10, meeting
from verify.cases.spring.stages.reference import SHARES
from verify.core.case import Context
from verify.core.figures import Curve, Curves, Picture
from verify.form.plots import curve, plot
from verify.papers.ledger import published

MPa, mm = 1e6, 1e-3


def judged(q: StagesInputs) -> AlongLine:
    """Figure of force over displacement by closed form and frame, with the inputs' ends."""
    line = q.held(theory="thin")
    at = SHARES * frame.end_point(**q.path, tail=q.tail)[0]
    return AlongLine(
        title=f"Force over displacement, head {q.head}, tail clamped at {q.tail}, linear theory",
        x=("U", "mm"), y=("F", "N"), curve=line.force, reference="force", at=at, order=2.0,
        points=np.linspace(0, at[-1], 200), scale=float(line.force(at[-1])),
        scale_name="largest force of the figure",
        note="Line: closed form; dots: straight elements with rigid links between tips and leaves.",
    )  # fmt: skip


def beside(context: Context) -> Iterator[Curves]:
    """Figures of the paper's spring with Eq. 10; for other inputs, figure of all end conditions."""
    yield from _beside_eq_10(context.inputs) if context.is_paper else (_bounds(context.inputs),)


def _beside_eq_10(q: StagesInputs) -> Iterator[Curves]:
    """Figures of F(U) by Eq. 10, by the readings with the printed k_1, and for the inputs."""
    lines = eq10()
    tests = [published(f"wang2023:{name}-test").value * 1e3 for name in ("k1", "k2")]
    U = np.linspace(0.0, EQ10_END, 60)
    printed = lines.force(U)
    tested = np.where(U > lines.U, (tests[0] - tests[1]) * lines.U + tests[1] * U, tests[0] * U)
    found = [("Eq. 10, the paper's shell model", printed, "line", 0),
             ("slopes of the tests, from the origin", tested, "dots", 5)]  # fmt: skip
    found += [
        (f"printed k_1: {x}", x.stages.force(U), "dashes", i)
        for i, x in enumerate(meeting(q)[:3], start=1)
    ]
    strip = "E I" if q.width_factor is None else f"{q.width_factor:.4g} E I"
    name = f"tail clamped at {q.tail}, head {q.head}, r + b/2, {strip}"
    found.append((name, q.held().force(U), "dashes", 4))
    note = (
        "The tests end at 11 N. The paper prints only the slopes of its test lines. These lines "
        "are drawn from the origin, with the change of slope at point A of Eq. 10."
    )
    yield plot(
        "Closed form and Eq. 10, for readings with the printed k_1", "U [mm]",
        "F [N]",
        (_curve(name, U / mm, F, style, c) for name, F, style, c in found),
        note=note,
    )  # fmt: skip
    yield plot(
        "Force minus the first line of Eq. 10: effect of the contact of the tips", "U [mm]",
        "F − 0.613 N/mm U [N]",
        (
_curve(name, U / mm, F - lines.k1 * U, style, c) for name, F, style, c in found
),
        y_bottom=float(min((F - lines.k1 * U).min() for _, F, _, _ in found)), note=note,
    )  # fmt: skip


def _bounds(q: StagesInputs) -> Curves:
    """Figure of the spring of the inputs with all end conditions."""
    top = 1.5 * float(q.held().U_A)
    curves = []
    for i, head in enumerate(("guided", "free")):
        for style, tail in (("line", "mid-leaf"), ("dashes", "arc")):
            s = q.held(head=head, tail=tail)
            U = np.unique(np.clip([0.0, float(s.U_A), float(s.U_B), top], 0.0, top))
            curves.append(
                _curve(f"head {head}, tail clamped at {tail}", U / mm, s.force(U), style, i)
            )
    return plot(
        "Force over displacement for all end conditions", "U [mm]", "F [N]", curves,
        note="Closed form, linear theory.",
    )  # fmt: skip


def _curve(name: str, U: Any, F: Any, style: str, colour: int) -> Curve:
    return curve(name, np.asarray(U), np.asarray(F), style, colour)


def bending_stress(q: StagesInputs) -> Picture:
    """Picture of the spring at point A, with its bending stress."""
    body = max(frame.end_point(**q.path, tail="mid-leaf")[0], q.L1 + 2 * q.R)
    return Picture(
        field="point A", data="bending_stress", symbol="σ_b", unit="MPa", factor=MPa, width=q.h,
        share=float(q.held().U_A) / body,
        caption="Bending stress 6 M/(h b²) at point A, where the tips touch",
    )  # fmt: skip
