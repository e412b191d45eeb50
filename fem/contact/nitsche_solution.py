"""Result of Nitsche's method, with the same quantities as a `ContactSolution`."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import diags_array
from scipy.sparse.linalg import spsolve

from fem.contact.bodies import Bodies
from fem.contact.mortar import Mortar
from fem.contact.nitsche_rows import Rows
from fem.contact.solution import Touch, in_plane
from fem.plane.discretisation import Array
from fem.plane.solution import PlaneSolution


@dataclass(frozen=True)
class PointTouch(Touch):
    """Contact of a pair with tractions at the integration points.

    The hat functions of the mortar method approximate these tractions; their coefficients are the
    tractions at the nodes. A node is closed or sticks if most of the surface near the node is
    closed or sticks.
    """

    @property
    def peak(self) -> float:
        """Largest pressure at an integration point."""
        return float(self.p.max(initial=0.0))


@dataclass(frozen=True, kw_only=True)
class NitscheSolution:
    """Solution of a contact problem by Nitsche's method.

    `touches` are in the order of the pairs. `displacements` (unknowns,) are those of the mesh, then
    x, y and rotation of each obstacle. `forces` (unknowns,) are the loads and the contact forces.
    `tractions` and `slips` belong to rows at the integration points. `free` is the vector q of free
    unknowns in u = T q + u_0. `iterations` is the number of linear systems solved.
    """

    bodies: Bodies
    touches: tuple[PointTouch, ...]
    displacements: Array
    forces: Array
    tractions: Array
    slips: Array
    free: Array
    iterations: int

    @cached_property
    def plane(self) -> PlaneSolution:
        """Displacements, stresses, reactions and energies; contact forces are included as loads."""
        return in_plane(self.bodies, self.displacements, self.forces)

    @property
    def strain_energy(self) -> float:
        """Strain energy of all bodies [force x length]."""
        return self.plane.strain_energy


def touches_of(
    mortars: Sequence[Mortar], own: Rows, moved: Array, found: Array, *, turn: bool
) -> tuple[PointTouch, ...]:
    """Contact states of all pairs, from gaps and slips `moved` and tractions `found` (rows,)."""
    touches, n = [], own.friction.size
    ends = np.cumsum([m.weight.size for m in mortars])
    for end, m in zip(ends, mortars, strict=True):
        points = np.arange(end - m.weight.size, end)
        rough = n + np.flatnonzero(np.isin(own.rough, points))
        q, slip = np.zeros(points.size), np.zeros(points.size)
        if rough.size:
            q, slip = found[rough], moved[rough]
        limit = own.friction[points] * found[points]
        touches.append(_touch(m, moved[points], slip, found[points], q, limit, turn))
    return tuple(touches)


def _touch(
    m: Mortar, gap: Array, slip: Array, p: Array, q: Array, limit: Array, turn: bool
) -> PointTouch:
    mass = (m.hats.T @ diags_array(m.weight) @ m.hats).tocsc()
    sticks, none = (np.abs(q) < limit).astype(float), np.zeros(m.size.size)
    return PointTouch(
        x=m.x, arc=m.arc, pressure=spsolve(mass, m.weighted(p)),
        traction=spsolve(mass, m.weighted(q)),
        gap=m.weighted(gap) / m.size, slip=m.weighted(slip) / m.size,
        closed=m.weighted((p > 0).astype(float)) > m.size / 2,
        sticks=m.weighted(sticks) > m.size / 2, mortar=m, p=p, q=q, turn=turn, traction_z=none,
        slip_z=none, q_z=np.zeros(q.size),
    )  # fmt: skip
