"""All contact pairs of a problem as one system: gaps, slips and compliance."""

from collections.abc import Sequence

import numpy as np
from scipy.sparse import csr_array, vstack

from fem.contact.bodies import UNHELD, Bodies, Response
from fem.contact.complementarity import Complementarity
from fem.contact.mortar import Mortar, mortar
from fem.contact.pairing import Points, pair, pair_with_shape
from fem.contact.pairs import Pair
from fem.contact.shapes import Motion
from fem.contact.trace import Trace, trace_of
from fem.plane.discretisation import Array, Indices

SPIN = 1e-3  # turn times extent over displacement: below, a motion is a translation
LEAST = 1e-13  # relative to the mean compliance per area
ROUND_OFF = 1e-9  # relative to the mesh's extent: overlaps that are round-off


class Surfaces:
    """Traces of the slave and the master of every pair; the master trace of an obstacle is None."""

    def __init__(self, bodies: Bodies, pairs: Sequence[Pair]) -> None:
        self.pairs = tuple(pairs)
        known = {*(bodies.basis.mesh.boundaries or {}), *bodies.obstacles}
        for p in pairs:
            if p.slave in bodies.obstacles:
                raise ValueError(
                    f"contact {p}: an obstacle must be the master: swap slave and master"
                )
            if p.master not in known:
                raise ValueError(
                    f"contact {p}: there is no boundary or obstacle {p.master!r}; there are: "
                    f"{', '.join(sorted(known))}"
                )
        self.slaves = [trace_of(bodies.basis, p.slave, p.slave_shape) for p in pairs]
        self.masters = [
            None if p.master in bodies.obstacles
            else trace_of(bodies.basis, p.master, p.master_shape)
            for p in pairs
        ]  # fmt: skip

    @property
    def unknowns(self) -> Indices:
        """Unknowns (s,) of the mesh on all contact surfaces."""
        traces = [t for t in (*self.slaves, *self.masters) if t is not None]
        return np.unique(np.concatenate([t.dofs.ravel() for t in traces]))


class Interface:
    """All contact pairs as one system; `bases` (all,) displace the surfaces of each pair rigidly.

    `rows` (r, all) are the weighted gaps of all pairs, one pair after the other, then the weighted
    slips of pairs with friction. `gaps` (m,) are the weighted gaps without displacement, `sizes`
    (m,) the integrals of their hat functions, `starts` the first rows of the pairs, and `kernel`
    the compliance of all rows.
    """

    def __init__(
        self, bodies: Bodies, surfaces: Surfaces, bases: Sequence[Array | None] | None = None
    ) -> None:
        self.bodies, self.pairs = bodies, surfaces.pairs
        bases = bases or [None] * len(self.pairs)
        self.mortars = [self._pair(surfaces, i, base) for i, base in enumerate(bases)]
        self.starts = np.cumsum([0, *(m.size.size for m in self.mortars)])
        rough = [i for i, p in enumerate(self.pairs) if p.friction > 0]
        tangential = [self.mortars[i].weighted(self.mortars[i].tangential) for i in rough]
        self.rows: csr_array = vstack(
            [*(m.weighted(m.normal) for m in self.mortars), *tangential]
        ).tocsr()
        self.gaps = np.concatenate([
            m.weighted(m.points.gap - p.interference - (0.0 if base is None else m.normal @ base))
            for m, p, base in zip(self.mortars, self.pairs, bases, strict=True)
        ])  # fmt: skip
        self.sizes = np.concatenate([m.size for m in self.mortars])
        unknowns = bodies.unknowns
        self.C = (self.rows @ unknowns.T[:, unknowns.T.shape[1] - unknowns.surface :]).toarray()
        friction = np.repeat([p.friction for p in self.pairs], np.diff(self.starts))
        partner = np.full(friction.size, -1)
        held = friction > 0
        partner[held] = friction.size + np.arange(held.sum())
        B = self.C @ bodies.compliance(self.C.T)
        # points fixed on both sides could carry any traction: the smallest is taken; by area,
        # which around a turn differs by many orders of magnitude from row to row
        area = np.concatenate([self.sizes, *(self.mortars[i].size for i in rough)])
        B[np.diag_indices(len(B))] += LEAST * np.mean(np.diag(B) / area**2) * area**2
        self.kernel = Complementarity(
            B=(B + B.T) / 2,
            D=self.C @ bodies.motions,
            friction=friction,
            partner=partner,
            part=np.repeat(np.arange(len(self.pairs)), np.diff(self.starts)),
        )

    def shift(self, response: Response) -> Array:
        """Change of the gaps and slips (r,) by a response in which all rigid motions are zero."""
        w = self.C @ response.at_rest
        return w + self.rows @ response.u_0 if np.any(response.u_0) else w

    def check_held(self, surfaces: Surfaces) -> None:
        """Raise ValueError if neither supports nor a contact prevent a rigid motion of a body.

        The rotation of a round body in a round hole is permitted, because it changes no gap.
        """
        k = self.bodies.motions.shape[1]
        if not k:
            return
        _, s, v = np.linalg.svd(np.vstack([self.kernel.D, np.zeros((k, k))]))
        free = v[s < UNHELD * max(s[0], 1e-300)].T
        if not free.size:
            return
        T = self.bodies.unknowns.T
        u = T[:, T.shape[1] - self.bodies.unknowns.surface :] @ (self.bodies.motions @ free)
        traces = [t for t in (*surfaces.slaves, *surfaces.masters) if t is not None]
        turns = np.array([
            [Motion.fitted(t.points, u[t.dofs.reshape(2, -1), j]).angle * t.extent
             for j in range(free.shape[1])]
            for t in traces
        ])  # fmt: skip
        _, s, v = np.linalg.svd(np.vstack([turns, np.zeros((free.shape[1], free.shape[1]))]))
        if s[-1] < SPIN * np.abs(u).max():
            self.bodies.refuse(self.bodies.named(free @ v[-1]))

    def _pair(self, surfaces: Surfaces, i: int, base: Array | None) -> Mortar:
        bodies, contact = self.bodies, self.pairs[i]
        slave, master = surfaces.slaves[i], surfaces.masters[i]
        if base is not None:
            slave = slave.moved(base)
            master = None if master is None else master.moved(base)
        if np.any(bodies.mu[slave.cells] == 0):
            raise ValueError(
                f"contact {contact}: the slave must be elastic, because it carries the contact "
                "traction: swap slave and master"
            )
        obstacle = 0, (0.0, 0.0)
        if master is None:
            body = bodies.obstacles[contact.master]
            first = bodies.basis.N + 3 * list(bodies.obstacles).index(contact.master)
            shape, centre = body.shape, body.centre
            if base is not None:
                x, y, angle = base[first : first + 3]
                motion = Motion((float(x), float(y)), float(angle), centre)
                shape, centre = shape.moved(motion), motion.of(centre)
            points, obstacle = pair_with_shape(slave, shape), (first, centre)
        else:
            share = self._share(slave, master) if contact.normal == "between" else 0.0
            points = pair(slave, master, share)
        if not points.s.size:
            raise ValueError(f"contact {contact}: no parts of the surfaces face each other")
        if base is None and not contact.press_fit:
            self._check_overlap(contact, slave, master, points)
        depth = np.full(points.s.size, bodies.thickness)
        if bodies.turn:
            depth = 2 * np.pi * points.x[0]
        return mortar(slave, master, points, unknowns=bodies.count, depth=depth, obstacle=obstacle)

    def _share(self, slave: Trace, master: Trace) -> float:
        """Ratio c_1/(c_1 + c_2) of plane moduli (1: slave, 2: master); 0 if the master is rigid."""
        own = self.bodies.plane_modulus(slave.cells)
        other = self.bodies.plane_modulus(master.cells)
        return own / (own + other)

    def _check_overlap(
        self, contact: Pair, slave: Trace, master: Trace | None, points: Points
    ) -> None:
        extent = np.ptp(self.bodies.basis.mesh.p, axis=1).max()
        allowed = slave.sag()[points.slave] + ROUND_OFF * extent
        if master is not None:
            allowed = allowed + master.sag()[points.master]
        worst = int(np.argmin(points.gap + allowed))
        if points.gap[worst] < -allowed[worst]:
            x, y = points.x[:, worst]
            raise ValueError(
                f"contact {contact}: the surfaces overlap by {-points.gap[worst]:.3g} at "
                f"({x:.5g}, {y:.5g}) before any load: separate them, or set press_fit=True"
            )
