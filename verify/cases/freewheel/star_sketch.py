"""Sketch of an inner cam: one pitch of star, roller and ring, with dimensions."""

import math
from typing import Any

import numpy as np

from verify.core.figures import Array, Shape, Sketch
from verify.form import sketches
from verify.form.sketches import arrow, leader, shape, text

mm = 1e-3
SIDE = 0.62  # over the height of the drawing: space for labels on both sides


def ray(angle: float) -> Array:
    """Unit vector at an angle [rad] from the vertical, clockwise."""
    return np.array([math.sin(angle), math.cos(angle)])


def arc(r: float, start: float, end: float) -> Array:
    """Points (m, 2) on a circle around the axis, between two angles [rad]."""
    turn = np.linspace(start, end, 61)
    return np.asarray(r * np.column_stack([np.sin(turn), np.cos(turn)]))


def label(name: str, metres: float, digits: int = 5) -> str:
    return f"{name} = {metres / mm:.{digits}g} mm"


def sketch(q: Any) -> Sketch:
    """Sketch of one pitch, to scale, in metres; the axis, where radii and X start, lies below."""
    cam, half = q.cam, math.pi / q.z
    psi = 2 * float(cam.alpha0)
    corner = min(q.X / math.cos(half), q.R)
    centre = np.array([float(v) for v in cam.centre(d_i=0.0, d_o=0.0)])
    circle = arc(q.r, 0.0, 2 * math.pi)
    low, top = q.r_b * math.cos(half), q.R_a
    tall, wide = top - low, max(q.R_a * math.sin(half + psi), q.R * math.sin(half))
    return sketches.sketch(
        f"one of {q.z} pitches, to scale; the axis is below the drawing. The torque T on the ring "
        "draws the roller to the right, where the gap is narrower. Both cut faces of the pitch "
        "have equal radial and circumferential displacements (cyclic symmetry)",
        shape("modelled",
              np.vstack([arc(q.r_b, -half, half), corner * ray(half), corner * ray(-half)])),
        shape("modelled",
              np.vstack([arc(q.R, psi - half, psi + half), arc(q.R_a, psi + half, psi - half)])),
        shape("body", centre + circle),
        (shape("clamp", arc(q.r_b, half, -half)[[k, k + 15]]) for k in (0, 15, 30, 45)),
        _forces(q, centre, psi, tall),
        _turning(q, half, psi, tall),
        _flat(q, half, low, tall, wide),
        _radii(q, centre, half, psi, tall, wide),
        text((wide + SIDE * tall, low - 0.1 * tall)),
        text((-wide - 0.5 * SIDE * tall, low)),
    )  # fmt: skip


def _forces(q: Any, centre: Array, psi: float, tall: float) -> tuple[Shape, ...]:
    """Arrows of the normal forces at both contacts, within the walls."""
    up, out = ray(0.0), ray(psi)
    star, ring = centre - q.r * up, centre + q.r * out
    short, long = 0.55 * min(0.3 * tall, q.X - q.r_b), 0.8 * min(0.25 * tall, q.R_a - q.R)
    aside = np.array([0.075 * tall, 0.0])
    return (
        arrow(star - short * up, star),
        arrow(ring + long * out, ring),
        text(ring + 0.4 * long * out + aside, "F_n"),
    )


def _turning(q: Any, half: float, psi: float, tall: float) -> tuple[Shape, ...]:
    """Angle between the normals of flat and ring, and arrow of the torque."""
    r = q.R_a + 0.1 * tall
    far = r + 0.05 * tall
    over = far * ray(psi / 2) + np.array([0.0, 0.06 * tall])
    return (
        arrow(q.r_b * ray(0.0), far * ray(0.0), style="axis"),
        arrow(q.r_b * ray(psi), far * ray(psi), style="axis"),
        shape("angle", arc(r, 0.0, psi)),
        text(over, f"ψ = 2α_0 = {math.degrees(psi):.4g}°"),
        shape("load",
              arc(q.R_a + 0.06 * tall, min(0.0, psi - 0.7 * half) - 0.35 * half, -0.15 * half),
              "T"),
    )  # fmt: skip


def _flat(q: Any, half: float, low: float, tall: float, wide: float) -> tuple[Shape, ...]:
    """Dimension X, measured from the axis, which lies below the drawing."""
    at, edge = -wide - 0.08 * tall, -q.X * math.tan(half)
    return (
        arrow((edge, q.X), (at - 0.03 * tall, q.X), style="faint"),
        leader((at, low), (at, q.X), label("X", q.X, 7)),
    )


def _radii(
    q: Any, centre: Array, half: float, psi: float, tall: float, wide: float
) -> tuple[Shape, ...]:
    """Labels of the radii in a column on the right, each with an arrow to its circle."""
    foot = min(q.R * math.cos(half + psi) - 0.06 * tall, q.R_a - 0.2 * tall)
    below = min(q.r_b, foot - 0.3 * tall)
    named = (
        ("R_a", q.R_a, q.R_a * ray(psi + 0.8 * half), q.R_a),
        ("R", q.R, q.R * ray(psi + 0.6 * half), foot),
        ("r", q.r, centre + q.r * ray(math.radians(105)), (foot + below) / 2),
        ("r_b", q.r_b, q.r_b * ray(0.75 * half), below),
    )
    x = wide + 0.06 * tall
    return tuple(leader((x, y), tip, label(name, value)) for name, value, tip, y in named)
