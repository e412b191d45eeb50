"""Sketch of a sprag between its races, with an enlarged wedge angle."""

import math

import numpy as np
from scipy.optimize import brentq

from analytic.sprag.geometry import LogSprag
from verify.cases.sprag.inputs import SpragInputs
from verify.core.figures import Array, Shape, Sketch
from verify.form import sketches
from verify.form.sketches import arrow, leader, shape

ORIGIN = np.zeros(2)
SIDE, SHARE = 0.36, 0.85  # rad of race on both sides, and over the sprag's height, at most
LARGER = 5.0  # times the angles are drawn, at most
STEEP = 0.8  # over the largest angle of a spiral, at (2 R_i/r_i + 1) sin(beta) = 1
WALL = 0.4  # over the sprag's height: largest drawn wall of a race


def drawn(q: SpragInputs) -> LogSprag:
    """The sprag of the sketch, whose wedge angle is enlarged."""
    most = math.asin(STEEP / (2 * q.R_i / q.r_i + 1))

    def over(nu: float) -> float:
        return nu - math.asin(q.R_i / q.R_e * math.sin(nu)) - most

    nu = brentq(over, 0.0, 1.2) if over(1.2) > 0 else 1.2
    nu = max(min(LARGER * q.nu_0, float(nu)), q.nu_0)
    return LogSprag.from_wedge_angle(nu_0=nu, R_i=q.R_i, R_e=q.R_e, r_i=q.r_i)


def arc(centre: Array, r: float, low: float, high: float, n: int = 41) -> Array:
    """Points of an arc, shape (n, 2); angles [rad] clockwise from the upward direction."""
    t = np.linspace(low, high, n)
    return np.asarray(centre + r * np.column_stack([np.sin(t), np.cos(t)]))


def sketch(q: SpragInputs) -> Sketch:
    """Sketch at first contact: axis O below, points C_e (pole) and B above O, A to the right."""
    sprag, height = drawn(q), q.R_e - q.R_i
    low, high = max(q.R_id, q.R_i - WALL * height), min(q.R_ed, q.R_e + WALL * height)
    beta, eta = float(sprag.beta_0), float(sprag.eta_0)
    out, up = np.array([math.sin(beta), math.cos(beta)]), np.array([0.0, 1.0])
    A, B, C = q.R_i * out, q.R_e * up, float(sprag.OC_e) * up
    long = float(np.hypot(*(B - A)))
    along = (B - A) / long
    tilt = math.atan2(along[0], along[1])
    true = {name: math.degrees(float(getattr(q.sprag, f"{name}_0")))
            for name in ("nu", "omega", "beta", "eta")}  # fmt: skip
    top, away, end = q.R_e + 0.12 * height, 0.55 * height, low - 0.24 * height
    side = min(SIDE, SHARE * height / q.R_e)
    shapes = (
        shape("modelled", ring(low, q.R_i, side)), shape("modelled", ring(q.R_e, high, side)),
        shape("body", outline(q, sprag)), arrow(end * up, top * up, style="axis"),
        arrow(end * out, (q.R_i + 0.8 * long) * out, style="axis"), arrow(A, B, style="line"),
        arrow(A, C, style="faint"), arrow(A - 0.3 * height * along, A),
        arrow(B + 0.3 * height * along, B),
        *marked(arc(A, 0.72 * long, tilt, beta), f"ν_0 = {true['nu']:.3g}°", away),
        *marked(arc(B, 0.36 * long, math.pi + tilt, math.pi), f"ω_0 = {true['omega']:.3g}°", -away),
        *marked(arc(C, 0.6 * float(sprag.rho_0), math.pi - eta, math.pi),
                f"η_0 = {true['eta']:.3g}°", away),
        *marked(arc(ORIGIN, low - 0.2 * height, 0.0, beta), f"β_0 = {true['beta']:.3g}°", away),
        *named("B", B, -away), *named("C_e", C, -away), *named("A", A, 1.2 * away),
    )  # fmt: skip
    times = float(sprag.nu_0) / q.nu_0
    return sketches.sketch(
        f"one of {q.z} sprags at first contact; the wedge angle is drawn {times:.2g} times as "
        "large. The force acts along AB. If the inner race drives to the left, A moves under B",
        (shape(s.style, s.points / q.R_e, s.label) for s in shapes),
    )  # fmt: skip


def ring(low: float, high: float, side: float) -> Array:
    return np.vstack([arc(ORIGIN, low, -side, side), arc(ORIGIN, high, side, -side)])


def outline(q: SpragInputs, sprag: LogSprag) -> Array:
    """Outline [m] of the sprag: spiral below the pole, circle above it, flanks at x = ±b/2."""
    C, half = np.array([0.0, float(sprag.OC_e)]), q.b / 2
    theta = np.linspace(-1.4, 1.4, 201)
    phi = float(sprag.eta_0) + theta
    r = np.asarray(sprag.rho_0 * np.exp(np.asarray(sprag.m) * theta))
    below = C + np.column_stack([r * np.sin(phi), -r * np.cos(phi)])
    below = below[np.abs(below[:, 0]) <= half]
    r_e = float(sprag.r_e)
    top = math.asin(min(0.9, half / r_e))
    return np.vstack([below, arc(C, r_e, top, -top)])


def marked(found: Array, label: str, away: float) -> tuple[Shape, ...]:
    """Shapes of an angle and its label."""
    return (shape("angle", found), *named(label, found[len(found) // 2], away))


def named(label: str, at: Array, away: float) -> tuple[Shape, ...]:
    beside = at + np.array([away, 0.06 * abs(away)])
    return (leader(beside, at, label),)
