"""Mesh of a sprag: a rectangle with fine zones at both contacts, mapped to the outline."""

from dataclasses import dataclass

import numpy as np
from skfem.mesh import Mesh2D

from meshes.contact.blocks import Block, Point
from meshes.contact.fan import Zone
from meshes.freewheel.bent import bent, flat_mesh
from meshes.freewheel.strip import Side, Strip
from meshes.sprag.profile import Array, Placed

BODY = "sprag"
ROUND_OFF = 1e-9  # relative to the half column's height: both halves meet exactly


@dataclass(frozen=True)
class Reach:
    """Lengths along an outline from its contact to the left and to the right flank."""

    left: float
    right: float

    @property
    def least(self) -> float:
        return min(self.left, self.right)

    @property
    def share(self) -> float:
        """Ratio of the shorter length to the mean of both lengths."""
        return 2 * self.least / (self.left + self.right)

    def stretched(self, share: Array, depth: Array) -> Array:
        """Lengths along the outline from the contact, for relative positions `share` from -1 to 1.

        -1 is the left flank and 1 is the right flank. At the relative `depth` 0 (the outline), the
        lengths on both sides are equal near the contact. From the `depth` 1 inwards, the length is
        a linear function of `share`.
        """
        end = np.where(share < 0, self.left, self.right)
        near = self.least * share + (end - self.least) * share**3
        far = ((1 + share) * self.right - (1 - share) * self.left) / 2
        # the power that gives the widest angles
        return near + np.minimum(depth, 1) ** 1.5 * (far - near)


def reaches(at: Placed) -> tuple[Reach, Reach]:
    """Lengths from the contacts to the flanks, along the spiral and along the arc."""
    sprag = at.sprag
    low, high = (abs(sprag.spiral_length(at.theta, end)) for end in sprag.below)
    left, right = (abs(end - at.phi) * sprag.r_e for end in sprag.above)
    return Reach(low, high), Reach(left, right)


def column_mesh(at: Placed, zones: tuple[Zone, Zone], *, order: int, straight: bool) -> Mesh2D:
    """Mesh of the sprag in the position `at`, fine at the inner and the outer contact.

    Boundaries: "inner", "outer", and the flanks "left" and "right". Body: "sprag".
    """
    half, height = at.sprag.b / 2, float(np.hypot(*np.subtract(at.outer, at.inner)))
    inner, outer = reaches(at)
    # both halves end on y = 0 in the same even cells
    blocks = [
        *_half("inner", inner, zones[0], half, height / 2, up=-1),
        *_half("outer", outer, zones[1], half, height / 2, up=1),
    ]
    mesh = flat_mesh(tuple(blocks), order)
    x, y = mesh.doflocs
    deep = min(half, height / 2)
    s_i, s_e = (
        reach.stretched(x / half, (height / 2 + up * y) / deep)
        for reach, up in ((inner, 1), (outer, -1))
    )
    low, high = at.sprag.along_spiral(at.theta, s_i), at.sprag.along_arc(at.phi, s_e)
    share = 1 / 2 + y / height
    places = at.placed((1 - share) * low + share * high)
    names = {name: name for name in ("inner", "outer", "left", "right")}
    return bent(mesh, places, names, straight=straight)


def _half(
    name: str, reach: Reach, zone: Zone, half: float, height: float, *, up: int
) -> list[Block]:
    """Blocks of the straight half column whose contact `name` is at y = `up` times `height`."""
    fine = Zone(zone.width * half / reach.least, zone.cells, zone.refine)
    left, right = (Side(((name, half),), flank) for flank in ("left", "right"))

    def placed(point: Point) -> Point:
        y = point[1] + height
        return point[0], up * y if y > ROUND_OFF * height else 0.0

    strip = Strip(left, right, height, "", BODY, fine)
    return [block.placed(placed) for block in strip.blocks()]
