"""Bodies that start apart: where their surfaces are once they have come together."""

import numpy as np
from numpy.typing import NDArray

from fem.contact.interface import Surfaces
from fem.contact.mortar import Mortar
from fem.contact.shapes import Motion
from fem.contact.solution import ContactSolution
from fem.contact.trace import Trace
from fem.plane.discretisation import Array

APART = 1e-4  # initial distance times curvature: below, gaps are linear in the motion


def approached(solution: ContactSolution, surfaces: Surfaces) -> list[Array | None] | None:
    """Rigid displacements (all,) of the surfaces of each pair from the mesh to where they touch.

    None for a pair that does not need them, and None altogether where no pair does: where those
    parts of the surfaces that touch were paired no farther from each other than a linear gap
    allows.
    """
    bases: list[Array | None] = [None] * len(surfaces.pairs)
    needed = False
    u = None
    for i, (touch, slave, master) in enumerate(
        zip(solution.touches, surfaces.slaves, surfaces.masters, strict=True)
    ):
        loaded = touch.p > 0
        if not np.any(loaded):
            continue
        bend = slave.curvature() + (0.0 if master is None else master.curvature())
        needed |= bool(touch.mortar.points.gap[loaded].min() * bend > APART)
        if u is None:
            u = solution.displacements
        bases[i] = _base(u, touch.mortar, loaded, slave, master, solution.bodies.basis.N)
    return bases if needed else None


def _base(
    u: Array,
    mortar: Mortar,
    loaded: NDArray[np.bool_],
    slave: Trace,
    master: Trace | None,
    meshed: int,
) -> Array:
    base = np.zeros(u.size)
    base[meshed:] = u[meshed:]
    sides = [(slave, mortar.points.slave)]
    if master is not None:
        sides.append((master, mortar.points.master))
    for trace, facets in sides:
        dofs = trace.dofs[:, :, np.unique(facets[loaded])].reshape(2, -1)
        places = trace.nodes[:, : trace.dofs.shape[1], np.unique(facets[loaded])].reshape(2, -1)
        motion = Motion.fitted(places, u[dofs])
        nodes = trace.nodes[:, : trace.dofs.shape[1]].reshape(2, -1)
        base[trace.dofs.reshape(2, -1)] = motion.displacement(nodes)
    return base
