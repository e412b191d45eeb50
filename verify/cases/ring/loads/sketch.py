"""Sketch of a race under its sprags."""

from collections.abc import Iterator

import numpy as np

from verify.cases.ring.loads.formulas import SpragLoads
from verify.core.figures import Shape, Sketch
from verify.form import sketches
from verify.form.sketches import polar

MOST = 48  # arrows


def sketch(self: SpragLoads) -> Sketch:
    """Sketch of the race, its loads and the half pitch of the finite-element model."""
    inner, pitch = self.r_i / self.r_o, 180 / self.n
    wall, behind = (inner, -0.22) if self.loaded == "bore" else (1.0, 0.22)
    pushed = "load the bore outwards" if self.loaded == "bore" else "load the rim inwards"
    loads = (
        sketches.arrow(polar(wall + behind, 2 * k * pitch), polar(wall, 2 * k * pitch))
        for k in range(min(self.n, MOST))
    )
    low, high = self.names
    return sketches.sketch(
        f"{self.n} sprags, each with {self.F:.4g} N on a length of {self.shown('L')}, {pushed}",
        sketches.room(2.4, 2.2), sketches.ring(inner, 1.0), _sector(inner, pitch), loads,
        sketches.leader(polar(1.5, 141), polar(1.0, 141), f"{high} = {self.shown('r_o')}"),
        sketches.leader(polar(1.5, 159), polar(inner, 159), f"{low} = {self.shown('r_i')}"),
        sketches.leader((1.35, 0.95), polar((1 + inner) / 2, pitch / 2), "FE: half a pitch"),
    )  # fmt: skip


def _sector(inner: float, pitch: float) -> Iterator[Shape]:
    """Outline of half a pitch of a ring with outer radius 1; `pitch`: its angle [deg]."""
    arcs = [polar(1.0, d) for d in np.linspace(0, pitch, 73)]
    arcs += [polar(inner, d) for d in np.linspace(pitch, 0, 73)]
    yield Shape(style="modelled", points=np.array(arcs))
