"""Sketch of a wedged sprag: one pitch with the line through both contacts."""

import math

import numpy as np

from verify.cases.freewheel.star_sketch import arc, label, ray
from verify.cases.sprag.wedge.formulas import WedgeFormulas
from verify.core.figures import Array, Shape, Sketch
from verify.form import sketches
from verify.form.sketches import arrow, leader, shape, text

SIDE = 0.42  # over the height of the drawing: space for labels on both sides


def outline(q: WedgeFormulas, *, turned: float, alpha_b: float, OC_e: float) -> Array:
    """Closed outline [m] of the sprag, shape (m, 2), with its pole on the y axis.

    The origin is the axis of the clutch. The outline is empty if the sprag rolls over.
    """
    whole = q.bodies.column
    drawn = whole and whole.outline(turned=turned, alpha_b=alpha_b)
    if not drawn:
        return np.empty((0, 2))
    around = np.concatenate([[drawn.A], drawn.right, [drawn.B], drawn.left[::-1], [drawn.A]])
    placed = around * np.exp(-1j * alpha_b) + 1j * OC_e
    return np.column_stack([placed.real, placed.imag])


def sketch(q: WedgeFormulas) -> Sketch:
    """Sketch of one pitch of the unloaded clutch, to scale, in metres; the axis lies below."""
    sprag, half = q.sprag, math.pi / q.z
    beta, OC_e = float(sprag.beta_0), float(sprag.OC_e)
    A, B, pole = q.R_i * ray(beta), q.R_e * ray(0.0), OC_e * ray(0.0)
    low, tall = q.R_id * math.cos(half), q.R_ed - q.R_id * math.cos(half)
    wide = q.R_ed * math.sin(half)
    body = outline(q, turned=0.0, alpha_b=0.0, OC_e=OC_e)
    inner = [arc(q.R_i, -half, half), arc(q.R_id, half, -half)]
    outer = [arc(q.R_e, -half, half), arc(q.R_ed, half, -half)]
    along = (B - A) / np.hypot(*(B - A))
    shapes = (
        shape("modelled", np.vstack(inner)), shape("modelled", np.vstack(outer)),
        *((shape("body", body),) if body.size else ()),
        arrow(low * ray(0.0), (q.R_ed + 0.06 * tall) * ray(0.0), style="axis"),
        arrow(low * ray(beta), (q.R_e + 0.1 * tall) * ray(beta), style="axis"),
        arrow(A - 0.16 * tall * along, A), arrow(B + 0.16 * tall * along, B),
        shape("load", arc(q.R_id + 0.25 * (q.R_i - q.R_id), 0.75 * half, 0.3 * half), "T"),
        *_named(q, A, B, pole, tall=tall, wide=wide, low=low), text((wide + SIDE * tall, low)),
        text((-wide - SIDE * tall, low)),
    )  # fmt: skip
    return sketches.sketch(
        f"one of {q.z} pitches at first contact, to scale; the axis lies below. The torque T "
        "rotates the inner race, and the sprag rotates clockwise and wedges. Forces act along the "
        f"line through both contacts, at {math.degrees(q.nu_0):.4g}° to the radius of the inner "
        "contact",
        shapes,
    )  # fmt: skip


def _named(
    q: WedgeFormulas, A: Array, B: Array, pole: Array, *, tall: float, wide: float, low: float
) -> tuple[Shape, ...]:
    """Labels with arrows: radii of the races on the right, points of the sprag on the left."""
    half, right, left = math.pi / q.z, wide + 0.06 * tall, -wide - 0.06 * tall
    radii = [
        ("R_ed", q.R_ed, 0.97),
        ("R_e", q.R_e, 0.7),
        ("R_i", q.R_i, 0.42),
        ("R_id", q.R_id, 0.06),
    ]
    found = [
        leader((right, low + height * tall), r * ray(0.85 * half), label(name, r))
        for name, r, height in radii
    ]  # fmt: skip
    spots = [
        ("B", B, 0.8),
        ("C_e", pole, 0.62),
        (f"A, r_i = {q.r_i * 1e3:.4g} mm", A, 0.3),
    ]
    found += [leader((left, low + height * tall), spot, name) for name, spot, height in spots]
    return tuple(found)
