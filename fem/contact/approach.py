"""Bodies with an initial gap: rigid displacements of the surfaces up to first contact."""

import numpy as np

from fem.contact.interface import Surfaces
from fem.contact.shapes import Motion
from fem.contact.solution import ContactSolution, Touch
from fem.contact.trace import Trace
from fem.plane.discretisation import Array

LARGEST_GAP = 1e-4  # initial distance times curvature: below, gaps are linear in the motion


def approached(solution: ContactSolution, surfaces: Surfaces) -> list[Array | None] | None:
    """Rigid displacements (all,) that move the surfaces of each pair to first contact.

    The entry of a pair that needs no displacement is None. The result is None if no pair needs a
    displacement: all initial gaps of loaded points are then so small that they change linearly with
    the motion.
    """
    sides = list(zip(solution.touches, surfaces.slaves, surfaces.masters, strict=True))
    obstacles = solution.bodies.obstacles
    masters = [
        obstacles[p.master].shape.curvature if m is None else m.curvature()
        for p, m in zip(surfaces.pairs, surfaces.masters, strict=True)
    ]
    bends = [s.curvature() + m for s, m in zip(surfaces.slaves, masters, strict=True)]
    if not any(_is_far(touch, bend) for (touch, _, _), bend in zip(sides, bends, strict=True)):
        return None
    u, count = solution.displacements, solution.bodies.basis.N
    return [_base(u, count, *side) if np.any(side[0].p > 0) else None for side in sides]


def _is_far(touch: Touch, bend: float) -> bool:
    distance = touch.mortar.points.gap[touch.p > 0]
    return distance.size > 0 and bool(distance.min() * bend > LARGEST_GAP)


def _base(u: Array, count: int, touch: Touch, slave: Trace, master: Trace | None) -> Array:
    """Rigid displacements of the loaded parts of both surfaces, extended to the whole surfaces."""
    base = np.zeros(u.size)
    base[count:] = u[count:]
    points, loaded = touch.mortar.points, touch.p > 0
    for trace, facets in ((slave, points.slave), (master, points.master)):
        if trace is not None:
            places = trace.nodes[:, : trace.dofs.shape[1]]
            near = np.unique(facets[loaded])
            motion = Motion.fitted(
                places[:, :, near].reshape(2, -1), u[trace.dofs[:, :, near]].reshape(2, -1)
            )
            base[trace.dofs] = motion.displacement(places.reshape(2, -1)).reshape(places.shape)
    return base
