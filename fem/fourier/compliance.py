"""How far the surface of a body of revolution gives way under pressure, harmonic by harmonic.

A cylindrical surface of radius R carries the pressure cos(n t) on one of several cells along z. The
inward displacement it makes, times cos(n t) too, integrated over each cell and one radian, is
G_n (cells, cells), symmetric. n G_n tends to a limit for large n and is smooth in ln n before, so
that few harmonics need a solution.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from fem.fourier.loads import pull, turn_of
from fem.fourier.solid import FourierSolid
from fem.plane.discretisation import Array, Indices, facet_basis, outer_facets

AT_STATION = 1e-9  # of the surface's length
LOW = 8  # multiples of the lowest harmonic that are all solved
ENOUGH = 150.0  # harmonic times the narrowest cell's angle, beyond which the sum breaks off


@dataclass(frozen=True)
class SurfaceCompliance:
    """`G` (orders, cells, cells) [length^4/force] for the harmonics `orders` on cells in z.

    The cells lie between `stations` (cells + 1,) on the surface of radius `radius`; loads repeat
    `places` times around the turn, so that all harmonics are multiples of it.
    """

    radius: float
    stations: Array
    places: int
    orders: Indices
    G: Array

    def between(self, across: Array) -> Array:
        """Matrix (M, M, cells, cells) of a patch: mean inward displacements times area.

        Unknowns are pressures on |s| in M cells between the growing arc lengths `across` (M + 1,)
        from 0 on. Entry [k, l, i, j] is the integral, over the cell (k, i) and its mirror image in
        s, of the displacement under pressure 1 on the cell (l, j), its image and both's repetitions
        at the other places.
        """
        angle = np.asarray(across, float) / self.radius
        weight = np.zeros((self.orders.size, angle.size - 1, angle.size - 1))
        for n, share in self._harmonics(float(np.diff(angle).min())):
            wave = _waves(angle, n)
            for s in np.flatnonzero(share.any(axis=0)):
                weight[s] += (wave * (self.places / turn_of(int(n[-1])) * share[:, s])) @ wave.T
        return np.einsum("skl,sij->klij", weight, self.G, optimize=True)

    def _harmonics(self, finest: float) -> Iterator[tuple[Indices, Array]]:
        """Blocks of harmonics n (b,), and how each G_n is made of those solved (b, orders)."""
        solved, step = self.orders[1:], self.places
        yield np.zeros(1, int), np.eye(1, self.orders.size)
        n = np.arange(step, solved[-1] + 1, step)
        share = np.zeros((n.size, self.orders.size))
        share[:, 1:] = CubicSpline(np.log(solved), np.diag(solved))(np.log(n)) / n[:, None]
        yield n, share
        n = np.arange(solved[-1] + step, ENOUGH / finest + step, step, dtype=int)
        share = np.zeros((n.size, self.orders.size))
        share[:, -1] = solved[-1] / n
        yield n, share


def _waves(angle: Array, n: Indices) -> Array:
    """Integral (cells, orders) of cos(n t) over the cells between `angle` and their images."""
    wave = np.sin(angle[:, None] * n) / np.maximum(n, 1)
    return np.asarray(2 * np.diff(np.where(n > 0, wave, angle[:, None]), axis=0))


def harmonics(*, places: int, highest: float, growth: float = 1.3) -> Indices:
    """Multiples of `places` to be solved: 0, the lowest eight, then each about `growth` times more.

    The last is the first to reach `highest`.
    """
    found = [0, *(places * k for k in range(1, LOW + 1))]
    while found[-1] < highest:
        found.append(places * max(found[-1] // places + 1, round(found[-1] * growth / places)))
    return np.array(found)


def surface_compliance(
    solid: FourierSolid, boundary: str, *, stations: Array, orders: Indices, places: int = 2
) -> SurfaceCompliance:
    """The compliance of the cylindrical `boundary` of `solid` on cells between `stations` in z.

    `orders` are the harmonics to be solved: 0 and growing multiples of `places`, such as
    `harmonics` gives; the last stands for all higher ones. ValueError where the boundary is no
    cylinder, or a station no node of it.
    """
    orders = np.asarray(orders)
    if orders[0] != 0 or np.any(orders % places) or np.any(np.diff(orders) <= 0) or orders.size < 3:
        raise ValueError(
            f"orders must be 0 and at least two growing multiples of places={places}, got {orders}"
        )
    radius, f = _unit_pressures(solid, boundary, np.asarray(stations, float))
    G = np.empty((orders.size, f.shape[1], f.shape[1]))
    for k, n in enumerate(orders):
        G[k] = turn_of(int(n)) * solid.flexibility(int(n), f)
    return SurfaceCompliance(radius, np.asarray(stations, float), places, orders, G)


def _unit_pressures(solid: FourierSolid, boundary: str, stations: Array) -> tuple[float, Array]:
    """Radius of the boundary and the forces (unknowns, cells) of pressure 1 on each, per radian."""
    facets = outer_facets(solid.mesh, boundary)
    r, z = solid.mesh.p[:, solid.mesh.facets[:, facets]]
    radius, close = float(r.max()), AT_STATION * max(float(np.ptp(z)), float(r.max()))
    if np.ptp(r) > close:
        raise ValueError(
            f"the boundary {boundary!r} must be a cylinder, its radii run from {r.min():.10g} to "
            f"{radius:.10g}"
        )
    for station in stations:
        if abs(z - station).min() > close:
            raise ValueError(f"the boundary {boundary!r} has no node at the station z={station:g}")
    cell = np.searchsorted(stations, z.mean(axis=0)) - 1
    f = np.zeros((solid.basis.N, stations.size - 1))
    for j in range(stations.size - 1):
        side = facet_basis(solid.basis, facets[cell == j])
        x = np.asarray(side.global_coordinates())
        inward = np.zeros((3, *x.shape[1:]))
        inward[0] = -np.asarray(side.normals)[0]
        f[:, j] = pull.assemble(side, t=inward)
    return radius, f
