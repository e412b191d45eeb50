"""Compliance of the surface of a body of revolution under pressure, harmonic by harmonic.

A cylindrical surface (rim or bore) carries tractions cos(n t) into the body, or sin(n t) around the
axis, on one of several cells along z. The displacements in these directions, multiplied by cos(n t)
or sin(n t) and integrated over each cell and one radian, are the symmetric matrix G_n. The product
n G_n has a limit for large n and is smooth in ln n; therefore, only a few harmonics are solved.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array

from fem.fourier.loads import pull, turn_of
from fem.fourier.solid import FourierSolid
from fem.plane.discretisation import Array, Indices, facet_basis, outer_facets

AT_STATION = 1e-9  # relative to the surface's length
LOW = 8  # multiples of the lowest harmonic that are all solved
SAME = 1e-9
CUBIC = 4  # harmonics that a cubic runs through
ENOUGH = 60.0  # harmonic times the narrowest cell's angle, beyond which the sum breaks off


@dataclass(frozen=True)
class SurfaceCompliance:
    """Compliance `G` (orders, 2, cells, 2, cells) [length^4/force] for the harmonics `orders`.

    Axes of length 2 are the directions into the body and around the axis. The cells lie between
    `stations` (cells + 1,) in z on a surface with the `curvature` 1/R, negative for a bore. Loads
    are repeated at `places` positions on the circumference; all harmonics are multiples of this
    number. `softness` is (1 - nu^2)/E of the surface [1/stress].
    """

    curvature: float
    stations: Array
    places: int
    orders: Indices
    G: Array
    softness: float

    @property
    def radius(self) -> float:
        """Radius R of the surface [length]."""
        return 1 / abs(self.curvature)

    def depth(self, s: Array) -> Array:
        """Depth, at the arc length `s`, of the surface below its tangent at s = 0."""
        return np.asarray((1 - np.cos(self.curvature * s)) / self.curvature)

    def between(self, across: Array, tilt: float) -> Array:
        """Compliance matrix (M, M, cells, cells) of a patch: integrals of displacements over cells.

        Unknowns are uniform pressures on cells in |s| and z. The M cells in |s| lie between the
        increasing arc lengths `across` (M + 1,), which begin with 0. Pressures act along the
        contact normal, which is inclined to the surface normal by `tilt` s [rad] towards s = 0;
        displacements are components along the contact normal. Entry [k, l, i, j] is the integral of
        the displacement over the cell (k, i) and its mirror image in s. The pressure 1 acts on the
        cell (l, j), its mirror image, and their repetitions at the other positions.
        """
        angle = np.asarray(across, float) / self.radius
        M = angle.size - 1
        weight = np.zeros((self.orders.size, 2, M, 2, M))
        for n, share in self._harmonics(float(np.diff(angle).min())):
            waves = _waves(angle, n, tilt * self.radius).reshape(2 * M, n.size)
            for s in np.flatnonzero(share.any(axis=0)):
                factor = self.places / turn_of(int(n[-1])) * share[:, s]
                weight[s] += ((waves * factor) @ waves.T).reshape(2, M, 2, M)
        return np.einsum("sakbl,saibj->klij", weight, self.G, optimize=True)

    def _harmonics(self, finest: float) -> Iterator[tuple[Indices, Array]]:
        """Blocks of harmonics n (b,), and weights (b, orders) of the solved harmonics in G_n.

        n G_n is a cubic in ln n through the four nearest solved harmonics, and constant after the
        last.
        """
        yield np.zeros(1, int), np.eye(1, self.orders.size)
        for k in range(1, self.orders.size):
            low, high = (self.orders[k - 1], self.orders[k])
            n = np.arange(low + self.places, high + self.places, self.places)
            first = min(max(1, k - 2), self.orders.size - CUBIC)
            own = slice(first, first + CUBIC)
            share = np.zeros((n.size, self.orders.size))
            share[:, own] = _lagrange(np.log(self.orders[own]), np.log(n))
            yield n, share * self.orders / n[:, None]
        last = self.orders[-1]
        n = np.arange(last + self.places, ENOUGH / finest + self.places, self.places, dtype=int)
        share = np.zeros((n.size, self.orders.size))
        share[:, -1] = last / n
        yield n, share


def _lagrange(knots: Array, x: Array) -> Array:
    """Values (x, knots) at `x` of the polynomials that are 1 at one knot and 0 at the others."""
    apart = knots[:, None] - knots + np.eye(knots.size)
    beyond = (x[:, None, None] - knots) * (1 - np.eye(knots.size)) + np.eye(knots.size)
    return np.asarray((beyond / apart).prod(axis=-1))


def surface_flexibility(
    solid: FourierSolid, boundary: str, *, stations: Array, n: int = 0
) -> Array:
    """Compliance G_n (2, cells, 2, cells) of the `boundary` for the harmonic `n`.

    The two directions of displacement and of load are inwards, and around the axis. The cells are
    along z. G_0 is the compliance under pressures that are constant around the axis. For
    ValueError, see `surface_compliance`.
    """
    return _by_cells(n, solid.flexibility(n, _loaded(solid, boundary, stations)[2]))


def _loaded(
    solid: FourierSolid, boundary: str, stations: Array
) -> tuple[list[Indices], float, Array]:
    """Facets of each cell, curvature of the boundary, unit loads inwards and around the axis."""
    stations = np.asarray(stations, float)
    if stations.ndim != 1 or stations.size < 2 or not np.all(np.diff(stations) > 0):
        raise ValueError(f"stations must be two or more values rising along z, got {stations}")
    cells, curvature = _surface_cells(solid, boundary, stations)
    inwards, around = (-float(np.sign(curvature)), 0.0, 0.0), (0.0, 1.0, 0.0)
    loads = [_unit_loads(solid, cells, traction) for traction in (inwards, around)]
    return cells, curvature, np.hstack(loads)


def _by_cells(n: int, work: Array) -> Array:
    """Compliance G_n (2, cells, 2, cells) from the work of unit loads on displacements."""
    m = len(work) // 2
    return np.asarray(turn_of(n) * work).reshape(2, m, 2, m)


def _waves(angle: Array, n: Indices, tilt: float) -> Array:
    """Integrals (2, cells, orders) of (1 - l^2) cos(n t) and l sin(n t) over cells in t.

    l = tilt t is the inclination of the contact normal. 1 - l^2 and l approximate cos^2 l and
    sin l cos l: the components, inwards and around the axis, of a unit pressure along this normal
    on the length cos l dt. Each integral includes the mirror image of the cell.
    """
    t, m = angle[:, None], np.maximum(n, 1)
    sine, cosine = np.sin(n * t) / m, np.cos(n * t) / m
    square = np.where(n > 0, t**2 * sine + 2 * t * cosine / m - 2 * sine / m**2, t**3 / 3)
    inwards = np.where(n > 0, sine, t) - tilt**2 * square
    around = tilt * np.where(n > 0, sine / m - t * cosine, 0.0)
    return np.asarray(2 * np.diff([inwards, around], axis=1))


def harmonics(*, places: int, highest: float, growth: float = 1.5) -> Indices:
    """Harmonics for which the compliance is calculated: multiples of `places`, including 0.

    The harmonics are 0, the eight lowest multiples of `places`, then a geometric series. Each
    harmonic of the series is about `growth` times the previous harmonic. The last harmonic is the
    first that reaches `highest`.
    """
    found = [0, *(places * k for k in range(1, LOW + 1))]
    while found[-1] < highest:
        found.append(places * max(found[-1] // places + 1, round(found[-1] * growth / places)))
    return np.array(found)


def surface_compliance(
    solid: FourierSolid, boundary: str, *, stations: Array, orders: Indices, places: int = 2
) -> SurfaceCompliance:
    """Compliance of the cylindrical `boundary` of `solid` for cells between `stations` in z.

    `orders` are the solved harmonics: 0 and rising multiples of `places`, for example the result of
    `harmonics`; the last harmonic represents all higher harmonics. Raises ValueError if the
    boundary is not a cylinder, or if there is no node at a station.
    """
    orders = np.asarray(orders)
    if (
        orders[0] != 0
        or np.any(orders % places)
        or np.any(np.diff(orders) <= 0)
        or orders.size <= CUBIC
    ):
        raise ValueError(
            "orders must begin with 0, followed by at least four rising multiples of "
            f"places={places}, got {orders}"
        )
    cells, curvature, f = _loaded(solid, boundary, stations)
    G = np.array([
        _by_cells(int(n), work)
        for n, work in zip(orders, solid.flexibilities(orders, f), strict=True)
    ])  # fmt: skip
    return SurfaceCompliance(
        curvature, np.asarray(stations, float), places, orders, G, _softness(solid, cells)
    )


def _surface_cells(
    solid: FourierSolid, boundary: str, stations: Array
) -> tuple[list[Indices], float]:
    """Facets of each cell between `stations`, and curvature of the boundary."""
    facets = outer_facets(solid.mesh, boundary)
    r, z = solid.mesh.p[:, solid.mesh.facets[:, facets]]
    radius, close = float(r.max()), AT_STATION * max(float(np.ptp(z)), float(r.max()))
    if np.ptp(r) > close:
        raise ValueError(
            f"the boundary {boundary!r} must be a cylinder, but its radii are {r.min():.10g} to "
            f"{radius:.10g}"
        )
    for station in stations:
        if abs(z - station).min() > close:
            raise ValueError(
                f"the boundary {boundary!r} must have a node at every station, but has none at "
                f"z={station:g}"
            )
    cell = np.searchsorted(stations, z.mean(axis=0)) - 1
    inside = solid.mesh.p[0, solid.mesh.t[:, solid.mesh.f2t[0, facets[0]]]].mean()
    curvature = np.sign(radius - inside) / radius
    return [facets[cell == j] for j in range(stations.size - 1)], curvature


def _unit_loads(
    solid: FourierSolid, cells: Sequence[Indices], traction: tuple[float, float, float]
) -> Array:
    """Forces (unknowns, cells) of `traction` on each cell, for one radian."""
    side = facet_basis(solid.basis, np.concatenate(cells))
    x = np.asarray(side.global_coordinates())
    t = np.broadcast_to(np.reshape(traction, (3, 1, 1)), (3, *x.shape[1:]))
    forces = pull.coo_data(side, t=t)
    column = np.repeat(np.arange(len(cells)), [facets.size for facets in cells])
    at = forces.indices[0], np.tile(column, forces.data.size // column.size)
    return np.asarray(coo_array((forces.data, at), (solid.basis.N, len(cells))).toarray())


def _softness(solid: FourierSolid, cells: Sequence[Indices]) -> float:
    """Softness (1 - nu^2)/E of the solid at the surface.

    Raises ValueError if the surface has several materials.
    """
    behind = solid.mesh.f2t[0, np.concatenate(cells)]
    lam, mu = solid.cells.lam[behind], solid.cells.mu[behind]
    softness = (lam + 2 * mu) / (4 * mu * (lam + mu))
    if np.ptp(softness) > SAME * softness.max():
        raise ValueError("the contact surface must have a single material")
    return float(softness[0])
