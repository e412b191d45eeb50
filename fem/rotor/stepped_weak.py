"""Weak form of a stepped shaft as a beam, with nominal diameters or stiffness by the 45° rule."""

from itertools import pairwise

import numpy as np
from skfem import MeshLine

from fem.rotor.elements import Array
from fem.rotor.weak import WeakShaft, weak_shaft

CELLS = 10  # least number of cells along the shaft, times the level
CONE = 8  # number of cells in a cone of the 45° rule, times the level
WITH_CONES = 2  # factor on CELLS: the error of the cells (order 4) must not hide that of the cones
SAME = 1e-9  # relative to the length: stations that differ by less are equal; also a cell count


def stepped_weak(
    *, L: float, d_1: float, d_2: float, step: tuple[float, float], seats: tuple[float, float],
    k: float, reach: float, E: float, nu: float, rho: float, level: int,
) -> WeakShaft:  # fmt: skip
    """Solid shaft on springs k [N/m] at `seats`, with the diameter d_2 between two steps.

    Outside the two positions `step`, the diameter is d_1. If `reach` > 0, the diameter for the
    stiffness is d_1 plus twice the distance from a step, up to the distance `reach`. Each cell has
    the diameter at its middle. Rotary inertia is distributed, without lumped inertia.
    """
    first, last = step
    z = [0.0]
    for low, high in pairwise(stations(L, (*seats, first, first + reach, last - reach, last))):
        depth = min((low + high) / 2 - first, last - (low + high) / 2)
        cells = (WITH_CONES if reach else 1) * CELLS * (high - low) / L
        n = CONE if 0 < depth < reach else int(np.ceil(cells - SAME))
        z += np.linspace(low, high, level * n + 1)[1:].tolist()
    inwards = np.minimum(m := (np.array(z[1:]) + z[:-1]) / 2, first + last - m) - first
    d: Array = np.where(inwards > 0, d_2, d_1)
    stiff = np.where(inwards > 0, np.minimum(d, d_1 + 2 * inwards), d) if reach else d
    kappa = 6 * (1 + nu) ** 2 / (7 + 12 * nu + 4 * nu**2)  # Hutchinson, solid circle
    own = weak_shaft(
        MeshLine(np.array(z)), bending=E * np.pi / 64 * stiff**4,
        shear=kappa * E / (2 * (1 + nu)) * np.pi / 4 * stiff**2,
        mass=rho * np.pi / 4 * d**2, rotary=rho * np.pi / 64 * d**4,
    )  # fmt: skip
    return own.on_springs(dict.fromkeys(seats, k))


def stations(L: float, inner: tuple[float, ...]) -> list[float]:
    """Ascending axial positions: ends of a shaft and `inner` positions, without duplicates.

    >>> stations(4.0, (3.0, 1.0, 1.0 + 1e-12))
    [0.0, 1.0, 3.0, 4.0]
    """
    found = [0.0]
    for z in sorted((*inner, L)):
        if z - found[-1] > SAME * L:
            found.append(z)
    return found
