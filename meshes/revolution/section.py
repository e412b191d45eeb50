"""Half-sections of solid and hollow cylinders with cells between given radii and axial stations."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray
from skfem import MeshQuad1

from meshes.contact.grading import beta, cells_along

Array = NDArray[np.float64]


def section(*, r: ArrayLike, z: ArrayLike) -> MeshQuad1:
    """Mesh of rectangular cells with edges at the ascending radii `r` >= 0 and positions `z`.

    Boundaries: "axis" (if the first r is 0) or "bore", "rim", "start" (first z) and "end". Body:
    "body". Raises ValueError unless r and z have at least two ascending values, and no r is
    negative.
    """
    r, z = _growing(r, "r"), _growing(z, "z")
    if r[0] < 0:
        raise ValueError(f"radii must not be negative, got r={r[0]:g} m")
    mesh = MeshQuad1.init_tensor(r, z)
    return mesh.with_boundaries({
        "axis" if r[0] == 0 else "bore": lambda x: x[0] == r[0],
        "rim": lambda x: x[0] == r[-1],
        "start": lambda x: x[1] == z[0],
        "end": lambda x: x[1] == z[-1],
    }).with_subdomains({"body": np.arange(mesh.nelements)})  # fmt: skip


def stations(*, start: float, end: float, first: float, growth: float, refine: int = 1) -> Array:
    """Ascending stations between `start`, where the cell size is `first`, and `end`.

    `end` may be above or below `start`. Away from `start`, a cell is at most `growth` times as long
    as the previous cell. At a large distance, sizes become constant. `refine` 2 halves all cells,
    and so on. Raises ValueError unless 0 < first <= |end - start|.
    """
    length = abs(end - start)
    if not 0 < first <= length < np.inf or not growth > 1 or refine < 1:
        raise ValueError(
            "stations require 0 < first <= |end - start|, growth > 1 and refine >= 1, got "
            f"first={first:g} m, |end - start|={length:g} m, growth={growth:g}, refine={refine}"
        )
    n = cells_along(length=length, first=first, growth=growth)
    b = beta(length=length, first=first, cells=n)
    e = ((b + 1) / (b - 1)) ** (1 - np.arange(refine * n + 1) / (refine * n))
    far = b * (e - 1) / (e + 1)  # from the far end, as a share of the length
    found = end - (end - start) * far
    found[0], found[-1] = start, end
    return np.asarray(found if end > start else found[::-1])


def chain(parts: Sequence[Array]) -> Array:
    """Ascending stations of several parts; each part must start at the end of the previous part."""
    for before, after in pairwise(parts):
        if before[-1] != after[0]:
            raise ValueError(
                "each part of stations must start at the end of the previous part, which is "
                f"{before[-1]:g} m, got {after[0]:g} m"
            )
    return np.concatenate([parts[0], *(part[1:] for part in parts[1:])])


def _growing(values: ArrayLike, name: str) -> Array:
    found = np.asarray(values, float)
    if found.ndim != 1 or found.size < 2 or not np.all(np.diff(found) > 0):
        raise ValueError(f"stations {name} must have two or more ascending values, got {found}")
    return found
