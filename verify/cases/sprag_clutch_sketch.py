"""What a sprag between its races looks like, with the angles of its strut."""

import math

import numpy as np

from verify.cases.sprag_inputs import SpragInputs
from verify.shown import Array, Shape, Sketch

ORIGIN = np.zeros(2)
SIDE = 0.45  # rad of race to either side


def arc(centre: Array, r: float, low: float, high: float, n: int = 41) -> Array:
    """Points of an arc; angles from up, clockwise [rad]."""
    t = np.linspace(low, high, n)
    return np.asarray(centre + r * np.column_stack([np.sin(t), np.cos(t)]))


def sketch(q: SpragInputs) -> Sketch:
    """The first contact to scale, O below, C_e and B straight above it, A to the right."""
    sprag, unit = q.sprag, 1 / q.R_ed
    up = np.array([0.0, 1.0])
    beta, eta = float(sprag.beta_0), float(sprag.eta_0)
    nu, omega = float(sprag.nu_0), float(sprag.omega_0)
    A = q.R_i * unit * np.array([math.sin(beta), math.cos(beta)])
    B, C = q.R_e * unit * up, float(sprag.OC_e) * unit * up
    out, along = A / np.hypot(*A), (B - A) / np.hypot(*(B - A))
    tilt = math.atan2(along[0], along[1])
    shapes = (
        Shape(style="modelled", points=ring(q.R_id * unit, q.R_i * unit)),
        Shape(style="modelled", points=ring(q.R_e * unit, 1.0)),
        Shape(style="body", points=outline(q) * unit),
        Shape(style="axis", points=np.array([0.45 * q.R_i * unit * up, 1.08 * up])),
        Shape(style="axis", points=np.vstack([0.45 * q.R_i * unit * out, 1.08 * out])),
        Shape(style="line", points=np.vstack([A, B])),
        Shape(style="faint", points=np.vstack([A, C])),
        Shape(style="load", points=np.vstack([A - 0.2 * along, A]), label=""),
        Shape(style="load", points=np.vstack([B + 0.2 * along, B]), label=""),
        *marked(A, tilt, beta, 0.8 * np.hypot(*(B - A)), f"ν_0 = {math.degrees(nu):.3g}°", 1),
        *marked(B, math.pi, math.pi + tilt, 0.8 * np.hypot(*(B - A)),
                f"ω_0 = {math.degrees(omega):.3g}°", -1),
        *marked(ORIGIN, 0.0, beta, 0.52 * q.R_i * unit, f"β_0 = {math.degrees(beta):.3g}°", 1),
        Shape(style="leader", points=np.vstack([[0.42, 0.62], C]),
              label=f"pole C_e, η_0 = {math.degrees(eta):.3g}°"),
        Shape(style="leader", points=np.vstack([[0.42, 0.34], A]),
              label=f"A, R_i = {q.R_i * 1e3:.4g} mm"),
        Shape(style="leader", points=np.vstack([[-0.5, 0.86], B]),
              label=f"B, R_e = {q.R_e * 1e3:.4g} mm"),
    )  # fmt: skip
    return Sketch(
        title=f"one of {q.z} sprags at first contact, to scale: it carries along AB; the inner "
        "race drives to the left and draws A under B",
        shapes=shapes,
    )


def ring(low: float, high: float) -> Array:
    return np.vstack([arc(ORIGIN, low, -SIDE, SIDE), arc(ORIGIN, high, SIDE, -SIDE)])


def outline(q: SpragInputs) -> Array:
    """Spiral below and circle above the pole, joined by flanks b apart [m]."""
    sprag = q.sprag
    C, half = np.array([0.0, float(sprag.OC_e)]), q.b / 2
    m, rho = float(np.asarray(sprag.m)), float(sprag.rho_0)
    theta = np.linspace(-1.2, 1.2, 121)
    phi, r = float(sprag.eta_0) + theta, rho * np.exp(m * theta)
    below = C + np.column_stack([r * np.sin(phi), -r * np.cos(phi)])
    below = below[np.abs(below[:, 0]) <= half]
    top = min(math.asin(min(1.0, half / float(sprag.r_e))), 1.2)
    return np.vstack([below, arc(C, float(sprag.r_e), top, -top)])


def marked(
    at: Array, low: float, high: float, r: float, label: str, side: int
) -> tuple[Shape, ...]:
    """An angle of a few degrees, its label at a leader to the side."""
    found = arc(at, r, low, high, 21)
    middle = found[len(found) // 2]
    name = Shape(style="leader", points=np.vstack([middle + np.array([0.36 * side, 0.03]), middle]),
                 label=label)  # fmt: skip
    return Shape(style="angle", points=found), name
