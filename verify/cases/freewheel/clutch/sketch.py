"""Sketch of an outer cam: shaft, roller, cup with its flats."""

import math

import numpy as np

from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.core.figures import Array, Sketch
from verify.form import sketches
from verify.form.sketches import arrow, leader, shape, text


def cup(q: ClutchInputs) -> Sketch:
    """Sketch of one pitch, to scale: roller, shaft, flat, angle psi between contact normals."""
    half, unit = math.pi / q.z, 1 / q.R_a
    psi = 2 * float(q.cam.alpha0)
    turn = np.linspace(-half, half, 61)

    def arc(r: float) -> Array:
        return np.asarray(r * unit * np.column_stack([np.sin(turn), np.cos(turn)]))

    corner = q.X / math.cos(half) * unit * np.array([math.sin(half), math.cos(half)])
    shaft = np.vstack([arc(q.R), arc(max(q.r_b, 0.45 * q.R))[::-1]])
    outer = np.vstack([arc(q.R_a), corner, corner * [-1, 1]])
    up, out = np.array([0.0, 1.0]), np.array([math.sin(psi), math.cos(psi)])
    centre = (q.R + q.r) * unit * out
    around = np.linspace(0, 2 * np.pi, 91)
    roller = centre + q.r * unit * np.column_stack([np.cos(around), np.sin(around)])
    at_shaft, at_flat = centre - q.r * unit * out, centre + q.r * unit * up
    return sketches.sketch(
        f"one of {q.z} pitches, to scale. Load draws the roller towards the middle of the flat, "
        "where the gap is narrowest, and where the roller can pop through",
        shape("modelled", shaft), shape("modelled", outer),
        shape("body", roller),
        arrow((0.0, 0.4 * q.R * unit), (0.0, 1.07), style="axis"),
        arrow(0.5 * q.R * unit * out, 1.05 * out, style="axis"),
        arrow(at_flat + 0.16 * up, at_flat, "F_n"),
        arrow(at_shaft - 0.16 * out, at_shaft),
        leader((-0.36, 1.02), (-0.2, q.X * unit), f"X = {q.X * 1e3:.7g} mm"),
        leader((0.55, 0.5), q.R * unit * np.array([math.sin(0.6 * half), math.cos(0.6 * half)]),
               f"R = {q.R * 1e3:.4g} mm"),
        leader((0.55, 0.72), centre, f"r = {q.r * 1e3:.4g} mm"),
        text((0.3, 1.13), f"ψ = 2α_0 = {math.degrees(psi):.4g}°"),
    )  # fmt: skip
