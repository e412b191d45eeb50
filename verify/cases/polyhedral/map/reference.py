"""Finite-element results of the map of K: half a sector of every ring."""

import numpy as np

from verify.case import Level
from verify.cases.polyhedral.fem import UNIT, factors_fem, in_fillet_fem, pressed_fem
from verify.cases.polyhedral.map.inputs import FLATS, PRESSED, MapInputs, Size
from verify.core.figures import Array

LEVELS = (1, 2, 3)
MAPPED = 2  # the level on which the whole of the maps is solved
DEFINITIONS = ("mid", "mean", "corner")


def solve(q: MapInputs, level: int) -> Level:
    """Results for all numbers of flats, on the mesh of `level`.

    Level MAPPED also contains both maps; the last level also contains the load-transfer ratios.
    """
    arrays: dict[str, Array] = {}
    if level == MAPPED:
        for name, rings in (("wall", q.by_wall), ("fillet", q.by_fillet)):
            arrays[name] = np.array([_per_p_1(q, ring, level)[0] for ring in rings])
    if level == LEVELS[-1]:
        arrays["efficiency"] = efficiency_fem(q)
    reference = np.array([_per_p_1(q, ring, level) for ring in q.at_middle])
    arrays["reference"] = reference[:, :3]
    arrays["fillet stress"] = reference[:, 3]
    values = {
        f"K_{name}_{z}": 1 / row[k]
        for z, row in zip(FLATS, reference, strict=True)
        for k, name in enumerate(DEFINITIONS)
    }
    return Level(h=1 / level, values=values, arrays=arrays)


def _per_p_1(q: MapInputs, size: Size, level: int) -> tuple[float, ...]:
    """1/K by each of its three definitions, and the ratio of the fillet stress to σ_t."""
    one = q.ring(size)
    solved = pressed_fem(one, level, "plane stress")
    thin = 2 * one.delta_1 * q.E / (one.d_i * one.d_m)  # p_1 over j_D
    u = factors_fem(one, solved)
    p = UNIT / 2 / u["mid"]  # per j_D, once the middle of the flats has taken up the clearance
    stress = in_fillet_fem(one, solved) * p / UNIT / (q.E / one.d_m)
    return (*(2 * thin * u[name] / UNIT for name in DEFINITIONS), stress)


def efficiency_fem(q: MapInputs) -> Array:
    """Array (m,): fraction of a pressure increment that the rollers carry, by number of flats."""
    from verify.cases.polyhedral.locking.fem import locked_fem

    found = []
    for size in q.at_middle:
        one = q.ring(size)
        p = PRESSED * q.touching(size[1])
        contact = locked_fem(one, 1, d=q.roller(one.z), e=0.5 * one.half_flat, p=p)
        low, high = (contact.force(k * p) for k in (0.9, 1.1))
        found.append((high - low) / (0.2 * p * one.d_i * np.sin(one.half_angle)))
    return np.array(found)
