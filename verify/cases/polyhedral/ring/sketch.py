"""Sketch of the polyhedral ring."""

from typing import Any

import numpy as np

from verify.core.figures import Array, Shape, Sketch
from verify.form import sketches
from verify.form.sketches import circle, polar, shape

ARC = 13  # points of a fillet


def outline(q: Any) -> Array:
    """Points of the outline of the bore, in units of the outer radius, shape (m, 2)."""
    points = []
    for k in range(q.z):
        middle = 2 * np.pi * (k + 0.5) / q.z
        turn = middle + np.linspace(-1, 1, ARC) * q.half_angle
        centre = (q.d_i / 2 - q.rho) * np.array([np.cos(middle), np.sin(middle)])
        points.append(centre + q.rho * np.column_stack([np.cos(turn), np.sin(turn)]))
    return np.asarray(np.vstack(points) / (q.d_e / 2))


def half(q: Any) -> Array:
    """Points of the closed outline of half a sector, in units of the outer radius, (m, 2)."""
    r = q.d_e / 2
    turn = np.linspace(0, q.half_angle, ARC)
    centre = (q.d_i / 2 - q.rho) * np.array([np.cos(q.half_angle), np.sin(q.half_angle)])
    fillet = centre + q.rho * np.column_stack([np.cos(turn), np.sin(turn)])
    rim = r * np.column_stack([np.cos(turn[::-1]), np.sin(turn[::-1])])
    return np.asarray(np.vstack([[[q.apothem, 0.0]], fillet, rim]) / r)


def body(q: Any, gap: float = 0.05, roller: float = 0.12) -> list[Shape]:
    """Shapes of ring, rollers, race and modelled half sector; the clearance is enlarged."""
    shapes = [
        circle(1.0, "body"),
        shape("hole", outline(q)),
        shape("modelled", half(q)),
        circle(1 + gap + 2 * roller),
    ]
    size = min(roller, 0.9 * (1 + gap + roller) * np.sin(q.half_angle))
    for k in range(q.z):
        angle = 2 * np.pi * k / q.z
        at = (1 + gap + size) * np.array([np.cos(angle), np.sin(angle)])
        shapes.append(circle(size, centre=(at[0], at[1])))
    return shapes


def sketch(q: Any) -> Sketch:
    """Sketch of the ring, its rollers and race, with the pressure on its flats."""
    flat = q.apothem / (q.d_e / 2)
    loads = [
        sketches.arrow(polar(flat - 0.24, 360 * k / q.z), polar(flat, 360 * k / q.z),
                       "" if k else "p")
        for k in range(0, q.z, max(1, q.z // 6))
    ]  # fmt: skip
    corner = np.degrees(q.half_angle + np.pi * (1 - 2 / q.z if q.z > 3 else 0.0))
    x, y = half(q)[ARC // 2 + 1 : ARC + 4].mean(axis=0)
    thin = polar((q.d_i + q.d_e) / 2 / q.d_e, corner)
    return sketches.sketch(
        f"ring with {q.z} flats in its bore, outer diameter {q.shown('d_e')}, fillet radius "
        f"{q.shown('rho', 3)}. Thin lines show rollers and race; the clearance is drawn much "
        "larger",
        body(q), loads, sketches.leader((-1.3, 1.02), thin, f"δ_1 = {q.shown('delta_1')}"),
        sketches.leader((1.32, 1.05), (float(x), float(y)), "FE: half a sector"),
    )  # fmt: skip
