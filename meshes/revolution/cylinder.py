"""Half-sections of cylinders in contact on a part of their length, fine at the contact's end."""

import math

import numpy as np
from numpy.typing import ArrayLike
from skfem import MeshQuad1

from meshes.revolution.section import chain, section, stations

ALONG, DOWN = 1.6, 2.0  # ratios of successive cells along the rim and below it, coarsest mesh


def half_cylinder(
    *,
    R: float,
    contact: ArrayLike,
    overhang: float = 0.0,
    bore: float = 0.0,
    first: float,
    refine: int = 1,
) -> MeshQuad1:
    """Mesh of the half z >= 0 of a cylinder of radius `R`, in contact on a part of its length.

    `contact` contains the ascending z of the nodes in contact, from 0 to the end of the contact.
    Beyond this end, the cylinder continues by `overhang`, and the first cell has the size of the
    last contact cell. Cells below the rim have the depth `first`; cells further inside are larger.
    `refine` 2 halves the depths of all cells and the lengths of the cells beyond the contact, but
    not the lengths in `contact`. All lengths have the same unit. Boundaries: "rim", "axis" or
    "bore", "start" (z = 0) and "end". Body: "body". Raises ValueError unless 0 <= bore < R,
    overhang >= 0, and `contact` ascends from 0.
    """
    z = np.asarray(contact, float)
    if not 0 <= bore < R < math.inf:
        raise ValueError(f"the bore must satisfy 0 <= bore < R, got bore={bore:g} m, R={R:g} m")
    if not 0 <= overhang < math.inf:
        raise ValueError(f"overhang must be finite and not negative, got overhang={overhang:g} m")
    if z.ndim != 1 or z.size < 2 or z[0] != 0 or not np.all(np.diff(z) > 0):
        raise ValueError(f"the stations of contact must ascend from 0, got {z}")
    if overhang > 0:
        last = min(refine * float(z[-1] - z[-2]), overhang)
        end = float(z[-1]) + overhang
        beyond = stations(start=float(z[-1]), end=end, first=last, growth=ALONG, refine=refine)
        z = chain([z, beyond])
    below = stations(start=R, end=bore, first=first, growth=DOWN, refine=refine)
    return section(r=below, z=z)
