"""Figures of a press fit: sketch, stresses through both walls, pressure along the fit."""

from collections.abc import Iterator

import numpy as np

from verify.case import AlongLine, sketches
from verify.cases.contact.press_fit.formulas import FitFormulas
from verify.cases.contact.press_fit.reference import TURNS, stations
from verify.core.figures import Shape, Sketch
from verify.form.sketches import polar, shape

LOADED = np.arange(22.5, 360.0, 45.0)  # degrees: arrows of the pressures


def sketch(q: FitFormulas) -> Sketch:
    """Sketch of both rings, with the modelled quarter and the pressures."""
    inner, fit = q.r_i / q.r_o, q.r_f / q.r_o
    t = np.linspace(0, 90, 73)
    quarter = [polar(1.0, d) for d in t] + [polar(inner, d) for d in t[::-1]]
    sizes = (("r_o", 130, 1.0), ("r_f", 158, fit), ("r_i", 220, inner))
    return sketches.sketch(
        f"inner ring (E_i = {q.shown('E_i')}) pressed into the outer ring (E_o = "
        f"{q.shown('E_o')}), pressure {q.shown('p_i')} in the bore and "
        f"{q.shown('p_o')} on the outer rim",
        sketches.ring(inner, 1.0), shape("modelled", np.array(quarter)),
        sketches.circle(fit, "line"),
        sketches.arrow((-1.12, 0.0), (1.12, 0.0), style="axis"),
        sketches.arrow((0.0, -1.12), (0.0, 1.12), style="axis"),
        _pressures(q, inner),
        (sketches.leader(polar(1.35, degrees), polar(at, degrees), f"{name} = {q.shown(name)}")
         for name, degrees, at in sizes),
        sketches.leader((1.2, 0.98), (0.75, 0.52), "FE: a quarter"),
        sketches.leader((1.2, -0.98), (fit * 0.77, -fit * 0.638), f"δ = {q.shown('delta')}"),
    )  # fmt: skip


def _pressures(q: FitFormulas, inner: float) -> Iterator[Shape]:
    for k, degrees in enumerate(LOADED):
        for p, start, end, label in (
            (q.p_i, max(inner - 0.2, 0.0), inner, "p_i"), (q.p_o, 1.2, 1.0, "p_o"),
        ):  # fmt: skip
            if p:
                yield sketches.arrow(polar(start, degrees), polar(end, degrees), "" if k else label)


def profiles(fit: FitFormulas) -> Iterator[AlongLine]:
    """Figures: stresses through both rings, and the contact pressure along the fit."""
    fine = np.concatenate([np.linspace(fit.r_i, fit.r_f, 41), np.linspace(fit.r_f, fit.r_o, 41)])
    for name, symbol, curve in (
        ("radial", "σ_r", lambda r: fit.stresses(r)[0]),
        ("hoop", "σ_θ", lambda r: fit.stresses(r)[1]),
    ):
        yield AlongLine(
            title=f"{name.capitalize()} stress through both rings, plane stress", x=("r", "mm"),
            y=(symbol, "MPa"), curve=curve, reference=f"profile {name}",
            at=stations(fit), points=fine, order=2.0, scale=fit.stress_scale,
            note="Line: formula; dots: finite elements on a radius at 30°. Lower diagram: line "
            "minus dots; band: tolerance of the profile.",
        )  # fmt: skip
    yield AlongLine(
        title="Contact pressure along the fit of two rings, plane stress", x=("angle", "deg"),
        y=("p", "MPa"), curve=lambda turns: np.full(turns.size, fit.p), reference="p along",
        at=TURNS, points=TURNS, order=2.0, scale=fit.p, scale_name="p",
        note="The meshes do not match: three cells of the inner ring face two of the outer ring.",
    )  # fmt: skip
