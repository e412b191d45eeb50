"""Frictionless contact of two bodies of revolution with parallel axes, on a narrow patch.

The patch is a grid of cells, across (arc length s from the line of centres) and along z, each with
an even pressure; both halves in s are alike. The mean gap of a cell is that of the undeformed
surfaces plus what both bodies give way by, from their own finite elements (`SurfaceCompliance`):
nothing is a half-space. Both bodies are loaded alike at each of their `places`, so that they are in
balance without supports.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PchipInterpolator

from fem.fourier.compliance import SurfaceCompliance
from fem.fourier.unilateral import push_together
from fem.plane.discretisation import Array

GAUSS = 4  # points a cell for the mean gap
SAME = 1e-9  # stations of both bodies, of their extent


@dataclass(frozen=True)
class PatchContact:
    """Pressures `p` (M, cells) between `across` (M + 1,) and `stations` (cells + 1,).

    `load` and `approach` are those of the length modelled.
    """

    across: Array
    stations: Array
    p: Array
    load: float
    approach: float

    @property
    def z(self) -> Array:
        """Middles (cells,) of the cells along z."""
        return np.asarray((self.stations[1:] + self.stations[:-1]) / 2)

    @property
    def line_load(self) -> Array:
        """Force per length (cells,)."""
        return np.asarray(2 * np.diff(self.across) @ self.p)

    @property
    def ridge(self) -> Array:
        """Pressure (cells,) at s = 0, from the parabola through the means of the first two cells."""
        a, b, c = self.across[:3] ** 3 / 3
        h, k = np.diff(self.across[:3])
        first, second = (b - a) / h, (c - b) / k  # mean s^2
        bend = (self.p[1] - self.p[0]) / (second - first)
        return np.asarray(self.p[0] - first * bend)

    @property
    def half_width(self) -> Array:
        """Half width (cells,) of an elliptic pressure with the line load and its second moment."""
        moment = 2 * np.diff(self.across**3) / 3 @ self.p
        q = np.where(self.line_load > 0, self.line_load, np.inf)
        return np.asarray(2 * np.sqrt(moment / q))

    def load_between(self, low: float, high: float) -> float:
        """Force on low <= z <= high, the line load even in each cell."""
        ends = np.clip(self.stations, low, high)
        return float(self.line_load @ np.diff(ends))

    def ridge_at(self, z: float) -> float:
        """Pressure at s = 0 and `z`, between the middles of cells."""
        return float(PchipInterpolator(self.z, self.ridge, extrapolate=True)(z))


def patch_contact(
    bodies: tuple[SurfaceCompliance, SurfaceCompliance],
    *,
    across: Array,
    load: float,
    crown: Callable[[Array], Array] | None = None,
) -> PatchContact:
    """The contact of `bodies`, whose surfaces curve away from each other, under `load` [force].

    Their undeformed gap is that of their circles, R - sqrt(R^2 - s^2) each, plus `crown` (z). A
    hollow surface is not meant. ValueError where stations or places of the bodies differ, or where
    the contact is as wide as the patch.
    """
    across = _check(bodies, across, load)
    first, second = bodies
    M, m = across.size - 1, first.stations.size - 1
    # the surface between the bodies takes a share of the curvature from each, as each gives way
    curvature = sum(1 / body.radius for body in bodies)
    tilts = [body.softness / sum(b.softness for b in bodies) * curvature for body in bodies]
    A = sum(body.between(across, tilt) for body, tilt in zip(bodies, tilts, strict=True))
    A = A.transpose(0, 2, 1, 3).reshape(M * m, M * m)
    gap = _mean(across, lambda s: sum(b.radius - np.sqrt(b.radius**2 - s**2) for b in bodies))[
        :, None
    ]
    if crown is not None:
        heights = _mean(first.stations, crown)
        if not np.all(np.isfinite(heights)):
            raise ValueError(
                f"the crown is not finite on {first.stations[0]:g} <= z <= {first.stations[-1]:g} m"
            )
        gap = gap + heights
    gap = np.broadcast_to(gap, (M, m))
    area = 2 * np.outer(np.diff(across), np.diff(first.stations))
    p, approach = push_together(A, gap.ravel(), area.ravel(), load)
    p = p.reshape(M, m)
    if np.any(p[-1] > 0):
        z = first.stations[int(np.argmax(p[-1]))]
        raise ValueError(
            f"the contact is as wide as its patch, |s| <= {across[-1]:g} m, at z={z:g} m: widen it"
        )
    return PatchContact(across, first.stations, p, load, approach)


def _check(
    bodies: tuple[SurfaceCompliance, SurfaceCompliance], across: Array, load: float
) -> Array:
    across = np.asarray(across, float)
    first, second = bodies
    if not 0 < load < np.inf:
        raise ValueError(f"the load must be positive and finite, got load={load:g} N")
    if across.ndim != 1 or across.size < 3 or across[0] != 0 or not np.all(np.diff(across) > 0):
        raise ValueError(f"across grows from 0 over two cells or more, got {across}")
    if not across[-1] < min(body.radius for body in bodies):
        raise ValueError(f"the patch |s| <= {across[-1]:g} m must be narrower than both radii")
    if first.places != second.places:
        raise ValueError(
            f"bodies are loaded at as many places, got {first.places}, {second.places}"
        )
    same = first.stations.shape == second.stations.shape
    if not same or np.ptp(first.stations - second.stations) > SAME * np.ptp(first.stations):
        raise ValueError("both bodies need the same stations along z, up to a common shift")
    return across


def _mean(stations: Array, f: Callable[[Array], Array]) -> Array:
    """Means (cells,) of f between `stations`."""
    t, w = np.polynomial.legendre.leggauss(GAUSS)
    x = stations[:-1, None] + np.diff(stations)[:, None] * (t + 1) / 2
    return np.asarray(f(x) @ w / 2)
