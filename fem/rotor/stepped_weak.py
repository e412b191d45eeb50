"""Weak form of a stepped shaft as a beam, with nominal diameters or stiffness by the 45° rule."""

from itertools import pairwise

import numpy as np
from skfem import MeshLine

from fem.rotor.elements import Array
from fem.rotor.weak import WeakShaft, weak_shaft

CELLS = 10  # along the shaft, at least, times the level
CONE = 8  # in a cone of the 45° rule, times the level
WITH_CONES = 2  # times CELLS: else the cells' error, order four, hides that of the cones, order two
SAME = 1e-9  # over the length: stations that differ by less are one; of a count of cells: round-off


def stepped_weak(
    *, L: float, d_1: float, d_2: float, step: tuple[float, float], seats: tuple[float, float],
    k: float, reach: float, E: float, nu: float, rho: float, level: int,
) -> WeakShaft:  # fmt: skip
    """Solid, d_1 in diameter and d_2 between both places of `step`, on springs k [N/m] at `seats`.

    With a `reach` above zero the stiff diameter grows from d_1 by twice the distance from a step
    up to there. Cells are of their middle's diameter: rotary inertia stays where it is, without
    lumps.
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
    kappa = 6 * (1 + nu) ** 2 / (7 + 12 * nu + 4 * nu**2)  # Hutchinson's, solid
    own = weak_shaft(
        MeshLine(np.array(z)), bending=E * np.pi / 64 * stiff**4,
        shear=kappa * E / (2 * (1 + nu)) * np.pi / 4 * stiff**2,
        mass=rho * np.pi / 4 * d**2, rotary=rho * np.pi / 64 * d**4,
    )  # fmt: skip
    return own.on_springs(dict.fromkeys(seats, k))


def stations(L: float, inner: tuple[float, ...]) -> list[float]:
    """Ends of a shaft and the `inner` stations in order, one where some are the same.

    >>> stations(4.0, (3.0, 1.0, 1.0 + 1e-12))
    [0.0, 1.0, 3.0, 4.0]
    """
    found = [0.0]
    for z in sorted((*inner, L)):
        if z - found[-1] > SAME * L:
            found.append(z)
    return found
