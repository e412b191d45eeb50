"""Pairing of surfaces: segments of a slave surface, each opposite to one facet of the master.

Gap and contact traction have the same direction n. This is the normal of the surface on which the
deformed bodies meet: n ~ c_1 n_1 - c_2 n_2. The outward normals n_1 of the slave and n_2 of the
master are weighted by the plane moduli c_1 and c_2 of the bodies, because the stiffer body bends
the softer body. With n_1 of a round slave alone, the error of Hertz's pressure would be of the
order a/R instead of (a/R)^2.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.contact.shapes import Shape
from fem.contact.trace import Trace, cross
from fem.plane.discretisation import Array, Indices

FACING = -0.2  # n_1 . n_2 of surfaces that can touch: at more than some 100 deg to each other
GAUSS = 4
SECANT_STEPS = 40
DONE = 1e-12
SHORTEST = 1e-10  # relative to a facet: shorter segments carry nothing
PAIRS = 2_000_000  # points times facets compared at once


@dataclass(frozen=True)
class Points:
    """Gauss points of the segments between two surfaces.

    A point lies on the facet `slave` (m,) at the parameter `s` (m,), opposite to the facet `master`
    (m,) at `t` (m,). `x` (2, m) are positions on the slave, `y` (2, m) the opposite positions on
    the master, `n` (2, m) directions from slave to master. `gap` (m,) is measured along n
    (negative: overlap), `weight` (m,) [length] are integration weights. For a rigid shape, `master`
    is -1.
    """

    slave: Indices
    s: Array
    master: Indices
    t: Array
    x: Array
    y: Array
    n: Array
    gap: Array
    weight: Array


def pair_with_shape(slave: Trace, master: Shape) -> Points:
    """Gauss points on the slave's facets that face a rigid `master`, along the master's normals."""
    k = np.arange(slave.count)
    return _gauss(
        slave, k, np.zeros(k.size), np.ones(k.size), lambda k, s: _onto(slave, master, k, s)
    )


def pair(slave: Trace, master: Trace, share: float) -> Points:
    """Gauss points of the segments on which `slave` faces `master`.

    `share` is c_1/(c_1 + c_2), the share of the slave in the sum of the two plane moduli.
    """
    ray = _Ray(slave, master, share)
    k, s_0, s_1 = _segments(ray)
    opposite, t = ray.cast(k, (s_0 + s_1) / 2)
    hit = opposite >= 0
    hit[hit] = np.logical_not(
        _through(slave, ray, k[hit], (s_0 + s_1)[hit] / 2, opposite[hit], t[hit])
    )
    k, s_0, s_1, opposite = k[hit], s_0[hit], s_1[hit], opposite[hit]
    master_of = np.repeat(opposite, GAUSS)

    def onto(k: Indices, s: Array) -> tuple[Indices, Array, Array, Array, NDArray[np.bool_]]:
        t = ray.refine(k, s, master_of)
        y = master.places(master_of, t)
        return master_of, t, y, ray.direction(k, s, master_of, t), np.ones(k.size, bool)

    return _gauss(slave, k, s_0, s_1, onto)


def _through(slave: Trace, ray: "_Ray", k: Indices, s: Array, opposite: Indices, t: Array) -> Array:
    """True (m,) where the ray from `s` on `k` to `t` on `opposite` lies within one body."""
    x = slave.places(k, s)
    gap = ((ray.master.places(opposite, t) - x) * slave.normals(k, s)).sum(axis=0)
    behind = np.flatnonzero(gap < 0)
    own, found = _Ray(slave, slave, 1.0), np.zeros(k.size, bool)
    exit_, t = own.cast(k[behind], s[behind])
    leaves = behind[exit_ >= 0]
    way = np.hypot(*(slave.places(exit_[exit_ >= 0], t[exit_ >= 0]) - x[:, leaves]))
    found[leaves] = way < -gap[leaves]
    return found


def _onto(slave, master, k, s):
    """Nearest points of a rigid shape to points of the slave, along the normals of the shape."""
    x = slave.places(k, s)
    y = master.project(x)
    n = -master.normal(y)
    faces = (slave.normals(k, s) * n).sum(axis=0) > -FACING
    return np.full(k.size, -1), np.zeros(k.size), y, n, faces


def _gauss(slave, k, s_0, s_1, onto) -> Points:
    """Gauss points of the segments from `s_0` to `s_1` on the facets `k`."""
    g, w = np.polynomial.legendre.leggauss(GAUSS)
    s = (s_0[:, None] + np.outer(s_1 - s_0, (g + 1) / 2)).ravel()
    weight = np.outer(s_1 - s_0, w / 2).ravel()
    k = np.repeat(k, GAUSS)
    master, t, y, n, faces = onto(k, s)
    x = slave.places(k, s)
    weight = weight * np.hypot(*slave.tangents(k, s))
    gap = ((y - x) * n).sum(axis=0)
    return Points(*(a[..., faces] for a in (k, s, master, t, x, y, n, gap, weight)))


def _segments(ray: "_Ray") -> tuple[Indices, Array, Array]:
    """Facet, start and end (m,) of the segments of the slave between projected master vertices."""
    count = ray.slave.count
    k, s = ray.breaks()
    k = np.concatenate([*[np.arange(count)] * 3, k])
    s = np.concatenate([np.repeat([0.0, 0.5, 1.0], count), s])
    order = np.lexsort((s, k))
    k, s = k[order], s[order]
    long = (np.diff(k) == 0) & (np.diff(s) > SHORTEST)
    start = np.flatnonzero(long)
    return k[start], s[start], s[start + 1]


class _Ray:
    """Rays from the slave in the direction of contact, and intersections with the master."""

    def __init__(self, slave: Trace, master: Trace, share: float) -> None:
        self.slave, self.master, self.share = slave, master, share

    def direction(self, k: Indices, s: Array, j: Indices, t: Array) -> Array:
        """Unit vectors (2, m) of the contact direction, from slave to master."""
        n = self.share * self.slave.normals(k, s) - (1 - self.share) * self.master.normals(j, t)
        return n / np.hypot(*n)

    def miss(self, k: Indices, s: Array, j: Indices, t: Array) -> Array:
        """Distances (m,) of points of the master from the rays."""
        d = self.master.places(j, t) - self.slave.places(k, s)
        return cross(self.direction(k, s, j, t), d)

    def refine(self, k: Indices, s: Array, j: Indices) -> Array:
        """Parameters t (m,) at which the rays from `s` intersect the extended facets `j`."""
        return self._root(lambda t: self.miss(k, s, j, t), k.size)

    def breaks(self) -> tuple[Indices, Array]:
        """Facets and parameters of the slave opposite to the vertices of the master."""
        j, t = np.tile(np.arange(self.master.count), 2), np.repeat([0.0, 1.0], self.master.count)
        places = np.vstack([self.master.places(j, t), self.master.normals(j, t)])
        # one facet represents both that share a vertex with one normal
        size = np.abs(places).max(axis=1, keepdims=True).clip(1e-300)
        first = np.unique(np.round(places / size, 11), axis=1, return_index=True)[1]
        j, t, places = j[first], t[first], places[:, first]
        ends = self._ends(self.slave)
        k, row = self._between(ends, places[:2], places[2:], -1.0)
        s = self._root(lambda s: self.miss(k, s, j[row], t[row]), k.size)
        inside = (s > SHORTEST) & (s < 1 - SHORTEST)
        return k[inside], s[inside]

    def cast(self, k: Indices, s: Array) -> tuple[Indices, Array]:
        """Nearest master facet (m,) on the ray from `s` on `k` (-1 if none), and parameter t."""
        facet, t = np.full(k.size, -1), np.zeros(k.size)
        x, n = self.slave.places(k, s), self.slave.normals(k, s)
        hit, point = self._between(self._ends(self.master), x, n, 1.0)
        at = self.refine(k[point], s[point], hit)
        distance = np.hypot(*(self.master.places(hit, at) - x[:, point]))
        order = np.lexsort((distance, point))
        first = order[np.unique(point[order], return_index=True)[1]]
        facet[point[first]], t[point[first]] = hit[first], at[first]
        return facet, t

    @staticmethod
    def _ends(trace: Trace) -> tuple[Array, Array]:
        """Positions and normals (2, 2, m) of the start and the end of all facets."""
        k = np.arange(trace.count)
        at = [
            (trace.places(k, e), trace.normals(k, e)) for e in (np.zeros(k.size), np.ones(k.size))
        ]
        return np.array([a[0] for a in at]), np.array([a[1] for a in at])

    def _between(self, ends, x: Array, n: Array, side: float) -> tuple[Indices, Indices]:
        """Facets and points for which the ray of the point passes between the ends of the facet.

        `ends` are positions and normals of the ends of the facets; `x`, `n` are points and normals
        of the other surface. `side` is 1 if the points belong to the slave, -1 if the facets do.
        """
        places, normals = ends
        own, other = (self.share, 1 - self.share) if side > 0 else (1 - self.share, self.share)
        facets, points = [], []
        for part in np.array_split(
            np.arange(n.shape[1]), 1 + x.shape[1] * places.shape[2] // PAIRS
        ):
            X, N = x[:, part, None], n[:, part, None]
            beyond = [
                cross(own * N - other * m[:, None], p[:, None] - X) <= 0
                for p, m in zip(places, normals, strict=True)
            ]
            facing = sum(N[i] * (normals[0, i] + normals[1, i])[None] for i in (0, 1)) < 2 * FACING
            row, facet = np.nonzero((beyond[0] != beyond[1]) & facing)
            facets.append(facet)
            points.append(part[row])
        return np.concatenate(facets), np.concatenate(points)

    @staticmethod
    def _root(function, size: int) -> Array:
        """Roots (m,) of `function` by the secant method, from the initial values 0 and 1."""
        before, s = np.zeros(size), np.ones(size)
        f_before, f = function(before), function(s)
        for _ in range(SECANT_STEPS):
            with np.errstate(divide="ignore", invalid="ignore"):
                step = np.nan_to_num(f * (s - before) / (f - f_before), posinf=0.0, neginf=0.0)
            before, s = s, np.clip(s - step, -0.5, 1.5)
            if not np.any(np.abs(step) > DONE):
                break
            f_before, f = f, function(s)
        return s
