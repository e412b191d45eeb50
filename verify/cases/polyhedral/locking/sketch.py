"""Sketch of the locked ring, also used for the clutch."""

from typing import Any

import numpy as np

from verify.cases.polyhedral.ring.sketch import body
from verify.core.figures import Sketch
from verify.form import sketches

MPa, mm = 1e6, 1e-3


def sketch(q: Any, *, d: float, e: float, p_t: float) -> Sketch:
    """Sketch of the ring `q`: rollers of diameter d [m], hub contacts at e [m], pressure p_t."""
    flat, at = q.apothem / (q.d_e / 2), e / (q.d_e / 2)
    arrows = {
        "R": ((flat - 0.28, at - 0.014), (flat, at)),
        "p": ((flat - 0.16, -0.1), (flat, -0.1)),
    }
    loads = []
    for k in range(0, q.z, max(1, q.z // 6)):
        c, s = np.cos(2 * np.pi * k / q.z), np.sin(2 * np.pi * k / q.z)
        for label, (start, end) in arrows.items():
            (x, y), (u, v) = np.array([start, end]) @ np.array([[c, s], [-s, c]])
            loads.append(sketches.arrow((x, y), (u, v), "" if k else label))
    return sketches.sketch(
        f"ring with {q.z} flats, pressed against rollers of {d / mm:.4g} mm diameter by p_t = "
        f"{p_t / MPa:.4g} MPa in its bore. The hub exerts the force R on each flat at e = "
        f"{e / mm:.4g} mm from the middle of the flat",
        body(q, gap=0.0), loads,
    )  # fmt: skip
