"""Frictionless contact of two bodies of revolution with parallel axes, on a narrow patch.

The patch is a grid of cells: across (arc length s from the line of centres) and along z. Each cell
has a uniform pressure, symmetric in s. The mean gap of a cell is the gap of the undeformed surfaces
plus the deflections of both bodies by finite elements (`SurfaceCompliance`), without a half-space.
Both bodies carry the same load at each of their `places`; they are therefore in balance without
supports.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PchipInterpolator

from fem.fourier.compliance import SurfaceCompliance
from fem.fourier.unilateral import push_together
from fem.plane.discretisation import Array
from fem.plane.recent import Recent

GAUSS = 4  # points a cell for the mean gap
SAME = 1e-9  # stations of both bodies, of their extent
PATCHES: Recent[Array] = Recent(most=12, room=1e7)  # entries of their matrices, 80 MB


class NarrowPatchError(ValueError):
    """The contact is as wide as its patch, so that a wider patch is required."""


@dataclass(frozen=True)
class PatchContact:
    """Contact pressures `p` (M, cells) on a grid of cells, with the load and the approach.

    The boundaries of the cells are `across` (M + 1,) in x and `stations` (cells + 1,) in z.
    `across` are distances from the plane through the axes, for points at the arc lengths s. `load`
    and `approach` belong to the modelled length.
    """

    across: Array
    stations: Array
    p: Array
    load: float
    approach: float

    @property
    def z(self) -> Array:
        """Middle positions (cells,) of the cells along z."""
        return np.asarray((self.stations[1:] + self.stations[:-1]) / 2)

    @property
    def line_load(self) -> Array:
        """Contact force per unit length along z (cells,)."""
        return np.asarray(2 * np.diff(self.across) @ self.p)

    @property
    def ridge(self) -> Array:
        """Pressure (cells,) at x = 0, extrapolated by a parabola.

        The parabola is even in x and has the mean pressures of the two cells nearest to x = 0.
        """
        a, b, c = self.across[:3] ** 3 / 3
        h, k = np.diff(self.across[:3])
        first, second = (b - a) / h, (c - b) / k  # mean x^2
        bend = (self.p[1] - self.p[0]) / (second - first)
        return np.asarray(self.p[0] - first * bend)

    @property
    def half_width(self) -> Array:
        """Half-width (cells,) of an elliptic pressure with the line load and second moment of p."""
        moment = 2 * np.diff(self.across**3) / 3 @ self.p
        q = np.where(self.line_load > 0, self.line_load, np.inf)
        return np.asarray(2 * np.sqrt(moment / q))

    def load_between(self, low: float, high: float) -> float:
        """Contact force on low <= z <= high, with a uniform line load in each cell."""
        ends = np.clip(self.stations, low, high)
        return float(self.line_load @ np.diff(ends))

    def ridge_at(self, z: float) -> float:
        """Pressure at x = 0 and `z`, interpolated between the middle positions of cells."""
        return float(PchipInterpolator(self.z, self.ridge, extrapolate=True)(z))


def patch_contact(
    bodies: tuple[SurfaceCompliance, SurfaceCompliance],
    *,
    across: Array,
    load: float,
    crown: Callable[[Array], Array] | None = None,
) -> PatchContact:
    """Contact of `bodies` under `load` [force] on the modelled length.

    The undeformed gap is the sum of the depths R - R cos(s/R) of both circles, with R < 0 for a
    bore, plus `crown`(z). Raises ValueError if stations or places of the bodies differ, or if
    their surfaces do not curve away from each other; NarrowPatchError if the contact is as wide as
    the patch.
    """
    across = _check(bodies, across, load)
    stations = bodies[0].stations
    M, m = across.size - 1, stations.size - 1
    # the surface between the bodies takes a share of the curvature from each, by its compliance
    curvature, softness = (sum(b.curvature for b in bodies), sum(b.softness for b in bodies))
    A = np.add(*(_between(body, across, curvature * body.softness / softness) for body in bodies))
    A = A.transpose(0, 2, 1, 3).reshape(M * m, M * m)
    gap = _mean(across, lambda s: np.add(*(body.depth(s) for body in bodies)))[:, None]
    if crown is not None:
        heights = _mean(stations, crown)
        if not np.all(np.isfinite(heights)):
            raise ValueError(
                f"the crown must be finite on {stations[0]:g} <= z <= {stations[-1]:g} m"
            )
        gap = gap + heights
    gap = np.broadcast_to(gap, (M, m))
    x = np.sin(curvature / 2 * across) / (curvature / 2)
    area = 2 * np.outer(np.diff(x), np.diff(stations))
    p, approach = push_together(A, gap.ravel(), area.ravel(), load)
    p = p.reshape(M, m)
    if np.any(p[-1] > 0):
        z = stations[int(np.argmax(p[-1]))]
        raise NarrowPatchError(
            f"the contact is as wide as its patch, |s| <= {across[-1]:g} m, at z={z:g} m: "
            "use a wider patch"
        )
    return PatchContact(x, stations, p, load, approach)


def _between(body: SurfaceCompliance, across: Array, tilt: float) -> Array:
    """Result of `body.between`, cached for later contacts of this body with another crown."""
    key = (body.places, np.array([body.curvature, tilt]), across, body.orders, body.G)
    return PATCHES.get(key, lambda: body.between(across, tilt), lambda found: found.size)


def _check(
    bodies: tuple[SurfaceCompliance, SurfaceCompliance], across: Array, load: float
) -> Array:
    across = np.asarray(across, float)
    first, second = bodies
    if not 0 < load < np.inf:
        raise ValueError(f"the load must be positive and finite, got load={load:g} N")
    if across.ndim != 1 or across.size < 3 or across[0] != 0 or not np.all(np.diff(across) > 0):
        raise ValueError(f"across must rise from 0 over at least two cells, got {across}")
    if not across[-1] < min(body.radius for body in bodies):
        raise ValueError(f"the patch |s| <= {across[-1]:g} m must be narrower than both radii")
    if not first.curvature + second.curvature > 0:
        raise ValueError(
            "the surfaces must curve away from each other, got the radii (negative for a bore) "
            f"{1 / first.curvature:g} m and {1 / second.curvature:g} m"
        )
    if first.places != second.places:
        raise ValueError(
            "both bodies must have the same number of loads around the axis, got "
            f"{first.places} and {second.places}"
        )
    same = first.stations.shape == second.stations.shape
    if not same or np.ptp(first.stations - second.stations) > SAME * np.ptp(first.stations):
        raise ValueError(
            "both bodies must have the same stations along z; only a uniform shift is permitted"
        )
    return across


def _mean(stations: Array, f: Callable[[Array], Array]) -> Array:
    """Means (cells,) of f between `stations`."""
    t, w = np.polynomial.legendre.leggauss(GAUSS)
    x = stations[:-1, None] + np.diff(stations)[:, None] * (t + 1) / 2
    return np.asarray(f(x) @ w / 2)
