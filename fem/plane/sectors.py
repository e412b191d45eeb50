"""Plane sectors of a cyclic body: evaluation, and assembly of the complete body."""

from collections.abc import Mapping

import numpy as np

from fem.plane.discretisation import Array, Indices
from fem.plane.samples import Samples
from fem.plane.solution import PlaneSolution

DEGREE = 8  # of the polynomial along a fillet
FINE = 2001  # points among which its largest value is sought


def radial(body: PlaneSolution, r: float, theta: Array) -> Array:
    """Radial displacement (m,) [length] at the radius `r` [length], angles `theta` (m,) [rad]."""
    direction = np.array([np.cos(theta), np.sin(theta)])
    return np.asarray((body.at(r * direction).u * direction).sum(axis=0))


def largest_hoop_stress(side: Samples, centre: Array, end: float, p: float) -> float:
    """Largest hoop stress [stress] along a fillet, from a fitted polynomial.

    The fillet is loaded by the pressure p. The fillet extends over the angle `end` [rad] about its
    centre, from the direction of the x axis. The normal stress is minus the pressure. The hoop
    stress is therefore the sum of both normal stresses plus p, for any directions of the axes.
    """
    turn = np.arctan2(*(side.x - centre[:, None])[::-1]) / end
    stress = side.stress[0] + side.stress[1] + p
    fit = np.polynomial.Polynomial.fit(turn, stress, DEGREE, domain=[0, 1])
    return float(fit(np.linspace(0, 1, FINE)).max())


def all_sectors(half: Mapping[str, Array], z: int) -> tuple[Array, Array, Indices]:
    """Points (n, 2), displacements (n, 2) and cells of 2 z copies of half a sector.

    The half sector is mirrored at the x axis, and both halves are rotated by multiples of 2 pi/z.
    """
    points, moved, cells = half["points"], half["displacement"], half["cells"].astype(np.int64)
    turned: list[tuple[Array, Array]] = []
    for k in range(z):
        c, s = np.cos(2 * np.pi * k / z), np.sin(2 * np.pi * k / z)
        turn = np.array([[c, s], [-s, c]])
        for mirror in (1.0, -1.0):
            flip = np.array([1.0, mirror])
            turned.append((points * flip @ turn, moved * flip @ turn))
    return (
        np.vstack([x for x, _ in turned]),
        np.vstack([u for _, u in turned]),
        np.vstack([cells + len(points) * k for k in range(2 * z)]),
    )
