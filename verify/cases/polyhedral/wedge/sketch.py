"""Sketch of the free body of a wedged roller with its contact forces."""

import math
from collections.abc import Iterator

import numpy as np

from verify.cases.polyhedral.wedge.inputs import WedgeInputs
from verify.core.figures import Shape, Sketch
from verify.form import sketches
from verify.form.sketches import arrow, shape

DRAWN = math.radians(12)  # half of the wedge angle in the sketch, at least


def sketch(self: WedgeInputs) -> Sketch:
    """Sketch of the normal and friction forces on a roller in a wedge."""
    half = max(self.half, DRAWN)
    x = math.sin(half)
    return sketches.sketch(
        "free-body diagram of a roller; the wedge angle is drawn larger. The normal forces N act "
        "out of the wedge, the friction forces T into the wedge. The finite-element model is the "
        "half above the bisector",
        sketches.circle(1.0, "body"), arrow((-1.9, 0), (3.0, 0), style="axis"),
        _flat(half, 1), _flat(half, -1),
        arrow((x, -1.9), (x, 1.9), style="faint"),
        sketches.leader((2.1, 1.55), (x, 1.35), "line through both contacts"),
        sketches.leader((-1.5, -0.45), (-0.86, -0.5), f"d = {self.shown('d')}"),
        sketches.leader((2.2, 0.32), (1.7, 0.0),
                        f"bisector, α = {math.degrees(self.alpha):.4g}°"),
        sketches.room(3.0, 4.6),
    )  # fmt: skip


def _flat(half: float, side: int) -> Iterator[Shape]:
    """Shapes of a flat and its forces on the roller; `side`: 1 above the bisector, -1 below."""
    mirror = np.array([1, side])
    n = np.array([math.sin(half), math.cos(half)]) * mirror
    t = np.array([math.cos(half), -math.sin(half)]) * mirror
    inside = 0.8 * n
    yield shape("clamp", np.array([n - 1.7 * t, n + 1.9 * t])[::side])
    yield arrow(1.75 * n, n, "N")
    yield arrow(inside, inside + 0.62 * t, "T")
