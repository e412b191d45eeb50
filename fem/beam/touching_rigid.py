r"""Gap and slip between a probe and a rigid flat or disc that moves with a carrier node.

In the frame of reference of the obstacle, x_s is the position of the probe on the centre line of
the beam, and n the normal of the obstacle at its nearest point P. The beam has the thickness b:

.. math:: g = n\cdot(x_s - P) - b/2, \qquad
   \dot s = t\cdot v + \tfrac{b}{2}(\dot\phi_s - \dot\phi_c)

where v is the velocity of x_s relative to the obstacle, phi_s the rotation of the cross-section and
phi_c the rotation of the obstacle.
"""

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from fem.beam.section import Array, Indices
from fem.beam.terms import Positions
from fem.beam.touching_closest import least
from fem.beam.touching_points import Places, Probes, lengths, on, places, positions, powers
from fem.beam.touching_touch import Touch, along, outer, turned

PARALLEL = 1e-6  # relative curvature x thickness below which a line counts as parallel

PIECES = 1000  # of a step's path at most, each no longer than the thickness


@dataclass(frozen=True)
class Surface:
    """Nearest points of a shape to points (k, 2): `distance`, normal `n` (k, 2), arc length `arc`.

    `turn` and `stretch` are the derivatives of the angle of n and of arc with respect to a
    displacement of the point along t (n rotated by -90°). `period` is the arc length of the
    circumference.
    """

    distance: Array
    n: Array
    turn: Array
    stretch: Array
    arc: Array
    period: float = math.inf


class Shape(Protocol):
    """Shape of a rigid obstacle, in coordinates fixed to the obstacle."""

    def surface(self, at: Array) -> Surface:
        """Nearest points of the surface to the points `at` (k, 2)."""
        ...


@dataclass(frozen=True)
class FlatObstacle:
    """Half plane with the point `at` on its boundary; `normal` points towards the beam."""

    at: tuple[float, float]
    normal: tuple[float, float]

    def __post_init__(self) -> None:
        if not math.hypot(*self.normal) > 0:
            raise ValueError(f"the normal of a flat must not be zero, got {self.normal}")

    def surface(self, at: Array) -> Surface:
        n = np.asarray(self.normal, float) / math.hypot(*self.normal)
        d = at - np.asarray(self.at, float)
        none = np.zeros(len(at))
        arc = d[:, 0] * n[1] - d[:, 1] * n[0]
        return Surface(d @ n, np.tile(n, (len(at), 1)), none, none + 1, arc)


Flat = FlatObstacle  # its name in version 0.1


@dataclass(frozen=True)
class DiscObstacle:
    """Disc of `radius` [length] about `centre`; with `inside`, a bore that contains the beam."""

    centre: tuple[float, float]
    radius: float
    inside: bool = False

    def __post_init__(self) -> None:
        if not self.radius > 0:
            raise ValueError(f"the radius of a disc must be positive, got {self.radius:g}")

    def surface(self, at: Array) -> Surface:
        d = at - np.asarray(self.centre, float)
        away = np.maximum(np.hypot(*d.T), 1e-9 * self.radius)
        way = -1.0 if self.inside else 1.0
        n = way * d / away[:, None]
        angle = np.arctan2(d[:, 1], d[:, 0])
        arc = -way * self.radius * angle
        round_ = 2 * math.pi * self.radius
        return Surface(way * (away - self.radius), n, -way / away, self.radius / away, arc, round_)


Disc = DiscObstacle  # its name in version 0.1


class Body:
    """Rigid shape that moves with a carrier node (None: it is fixed), and the probes of a beam."""

    def __init__(
        self, shape: Shape, carrier: int | None, points: Array, probes: Probes, thickness: float
    ) -> None:
        self.shape, self.carrier, self.points = shape, carrier, points
        self.probes, self.b = probes, thickness

    def start(self, x: Array) -> None:
        self.rest = self._pose(x)[:2].copy()
        self.accept(x)

    def accept(self, x: Array) -> None:
        self.before = x.copy()
        self.eta, self.past = self.nearest(x)

    def nearest(self, x: Array) -> tuple[Array, Surface]:
        """For each cell, the point of the beam that is nearest to the shape.

        The results are the parameters eta of these points, and the nearest points of the shape.
        """
        p = self.probes
        curves = powers(x[p.nodes, :2])

        def rise(eta: Array, rows: Indices) -> tuple[Array, Array]:
            """Distance from the shape plus additional gap, and derivative with respect to eta."""
            own, slope = on(curves[rows], eta)
            surface = self._surface(x, own)
            n = self.normals(x, surface)
            off = eta - p.middle[rows]
            eased = surface.distance + p.ease[rows] * off**2 / 2
            return eased, (n * slope).sum(axis=1) + p.ease[rows] * off

        eta = least(p.lower, p.upper, rise)
        return eta, self._surface(x, on(curves, eta)[0])

    def passed(self, x: Array) -> bool:
        """True if a node passed straight through the shape since the last accepted state."""
        nodes = np.unique(self.probes.nodes)
        then = self._seen(self.before, self.before[nodes, :2])
        way = self._seen(x, x[nodes, :2]) - then
        pieces = min(PIECES, 1 + int(np.hypot(*way.T).max() / self.b))
        at = then + np.linspace(0, 1, pieces, endpoint=False)[:, None, None] * way
        distance = self.shape.surface(at.reshape(-1, 2)).distance.reshape(pieces, -1)
        return bool(((distance[0] > 0) & (distance.min(axis=0) < 0)).any())

    def gap(self, x: Positions, probe: Indices, eta: Array) -> Array:
        """Gaps of some probes at the parameters eta, in the full precision of the positions `x`."""
        at = x.astype(np.longdouble)
        own = positions(at, self.probes.nodes[probe], eta)
        easing = self.probes.ease[probe] * (eta - self.probes.middle[probe]) ** 2 / 2
        gap: Array = (self._surface(at, own).distance + easing - self.b / 2).astype(float)
        return gap

    def eased(self, eta: Array) -> Array:
        """Additional gaps (`Probes.ease`) of all probes at the parameters eta."""
        eased: Array = self.probes.ease * (eta - self.probes.middle) ** 2 / 2
        return eased

    def _surface(self, x: Positions, at: Positions) -> Surface:
        """Nearest points, in the frame of the shape, to the points `at` (k, 2) in space."""
        return self.shape.surface(self._seen(x, at))

    def _seen(self, x: Positions, at: Positions) -> Array:
        """Coordinates, in the frame of the shape, of the points `at` (k, 2) in space."""
        pose = self._pose(x)
        d = at - pose[:2]
        c, s = np.cos(pose[2]), np.sin(pose[2])
        own = np.column_stack([c * d[:, 0] + s * d[:, 1], c * d[:, 1] - s * d[:, 0]])
        seen: Array = own + self.rest
        return seen

    def touch(self, x: Array, probe: Indices, eta: Array, surface: Surface) -> Touch:
        """Gap, slip and their derivatives at the probes `probe`.

        `eta` and `surface` belong to all probes.
        """
        x_c, y_c, _ = self._pose(x)
        n = self.normals(x, surface)[probe]
        t = np.column_stack([n[:, 1], -n[:, 0]])
        own = places(x, self.probes.nodes[probe], eta[probe])
        r = own.position - (x_c, y_c)
        across = np.column_stack([-r[:, 1], r[:, 0]])  # how a turn of the carrier moves the place
        one = np.ones((len(probe), 1))
        W, own_1 = np.hstack([own.N, -one]), np.hstack([own.N1, 0 * one])
        sections, e = turned(np.hstack([own.N, 0 * one])), turned(np.hstack([0 * own.N, one]))
        relative_t, relative_n = along(W, t), along(W, n)
        A = relative_t - (t * across).sum(axis=1)[:, None] * e
        B = relative_n - (n * across).sum(axis=1)[:, None] * e
        a, C = (own.slope * t).sum(axis=1), along(own_1, n)
        turning = surface.turn[probe]
        # the gap is stationary in eta unless a bound of the cell holds it
        H = (own.second * n).sum(axis=1) - a**2 * turning + self.probes.ease[probe]
        free = (eta > self.probes.lower)[probe] & (eta < self.probes.upper)[probe]
        free &= (H - PARALLEL * a**2 / self.b) > 0
        moved = np.where(free, 1 / np.where(free, H, 1.0), 0.0)[:, None] * (
            a[:, None] * (turning[:, None] * A + e) - C
        )
        rise = (own.slope * n).sum(axis=1)[:, None]
        along_t = A + a[:, None] * moved
        psi = turning[:, None] * along_t + e
        slip, bend = self._passed(x, probe, eta, own, surface)
        stretch = surface.stretch[probe, None]
        own_stretch = np.sign(a) * self._stretch(probe, eta[probe])
        touch = Touch(
            slot=probe, dofs=self._dofs(own.nodes),
            gap=(surface.distance + self.eased(eta))[probe] - self.b / 2,
            opening=B,
            turning=outer(C, moved) - outer(A, psi) - outer(e, relative_t + a[:, None] * moved),
            sliding=A + self.b / 2 * (sections - e),
            swerving=outer(B, psi) + outer(along(own_1, t), moved)
            + outer(e, relative_n + rise * moved) + self.b / 2 * outer(turned(own_1), moved),
            slip=slip,
            slipping=stretch * along_t + self.b / 2 * (sections - psi)
            + (self.b / 2 * bend - own_stretch)[:, None] * moved,
        )  # fmt: skip
        return touch if self.carrier is not None else touch.without(3)

    def _passed(
        self, x: Array, probe: Indices, eta: Array, own: Places, surface: Surface
    ) -> tuple[Array, Array]:
        """Slip (k,) since the last accepted state, and d(rotation of the section)/d(eta)."""
        phi, before = self._pose(x)[2], self._pose(self.before)[2]
        passed = surface.arc[probe] - self.past.arc[probe]
        if math.isfinite(surface.period):
            passed -= surface.period * np.round(passed / surface.period)
        n = self.normals(x, surface)[probe]
        forward = np.sign(own.slope[:, 0] * n[:, 1] - own.slope[:, 1] * n[:, 0])
        nodes, lines = self.probes.nodes[probe], self.points
        passed -= forward * (lengths(lines, nodes, eta[probe])
                             - lengths(lines, nodes, self.eta[probe]))  # fmt: skip
        rotated = (x - self.before)[nodes, 2]
        old, now = self.past.n[probe], surface.n[probe]
        turn = np.arctan2(old[:, 0] * now[:, 1] - old[:, 1] * now[:, 0], (old * now).sum(axis=1))
        slip = passed + self.b / 2 * ((own.N * rotated).sum(axis=1) - turn - phi + before)
        return slip, (own.N1 * rotated).sum(axis=1)

    def _stretch(self, probe: Indices, eta: Array) -> Array:
        """Derivative of the reference length with respect to eta."""
        return np.hypot(*places(self.points, self.probes.nodes[probe], eta).slope.T)

    def normals(self, x: Array, surface: Surface) -> Array:
        """Normals (k, 2) at the nearest points, in global coordinates."""
        phi = self._pose(x)[2]
        c, s = math.cos(phi), math.sin(phi)
        return surface.n @ np.array([[c, s], [-s, c]])

    def _dofs(self, nodes: Indices) -> Indices:
        carrier = np.full((len(nodes), 1), self.carrier or 0)
        own = np.hstack([nodes, carrier])
        return (3 * own[:, :, None] + np.arange(3)).reshape(len(nodes), 3 * own.shape[1])

    def _pose(self, x: Positions) -> Positions:
        return np.zeros_like(x[0]) if self.carrier is None else x[self.carrier]
