"""What an outer cam looks like: shaft, roller, cup with its flats."""

import math

import numpy as np

from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.core.figures import Array, Shape, Sketch


def cup(q: ClutchInputs) -> Sketch:
    """One pitch to scale: the roller between shaft and flat, the angle psi to the flat's normal."""
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
    shapes = (
        Shape(style="modelled", points=shaft), Shape(style="modelled", points=outer),
        Shape(style="body", points=roller),
        Shape(style="axis", points=np.array([[0.0, 0.4 * q.R * unit], [0.0, 1.07]])),
        Shape(style="axis", points=np.vstack([0.5 * q.R * unit * out, 1.05 * out])),
        Shape(style="load", points=np.vstack([at_flat + 0.16 * up, at_flat]), label="F_n"),
        Shape(style="load", points=np.vstack([at_shaft - 0.16 * out, at_shaft])),
        Shape(style="leader", points=np.array([[-0.36, 1.02], [-0.2, q.X * unit]]),
              label=f"X = {q.X * 1e3:.7g} mm"),
        Shape(style="leader", points=np.vstack([[0.55, 0.5], q.R * unit * np.array(
            [math.sin(0.6 * half), math.cos(0.6 * half)])]), label=f"R = {q.R * 1e3:.4g} mm"),
        Shape(style="leader", points=np.vstack([[0.55, 0.72], centre]),
              label=f"r = {q.r * 1e3:.4g} mm"),
        Shape(style="text", points=np.array([[0.3, 1.13]]),
              label=f"ψ = 2α_0 = {math.degrees(psi):.4g}°"),
    )  # fmt: skip
    return Sketch(
        title=f"one of {q.z} pitches, to scale: load draws the roller towards the flat's middle, "
        "where the gap is narrowest and it goes through",
        shapes=shapes,
    )
