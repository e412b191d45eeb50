"""Half a disc with a contact at an angle from +y, and rotation of meshes to this contact."""

import math
from dataclasses import replace

import numpy as np
from skfem.mesh import Mesh2D

from meshes.contact.blocks import Block, Point, mesh_blocks
from meshes.contact.fan import Outline, Zone, fan

INNER = 0.45  # over the radius: length of the inner part of the cut, on each side of the centre


def tilted_half_disc(*, R: float, tilt: float, zone: float, refine: int, cells: int = 6) -> Mesh2D:
    """Mesh of the half y >= 0 of the disc about the origin, fine at R (sin tilt, cos tilt).

    With `refine` 1, `cells` equal cells lie on each side of this point, over `zone` [unit of R] of
    the tangent; cells are larger outside. `refine` 2 halves all cells. Boundaries: "surface" (the
    arc), "inner" and "outer" (the section y = 0, up to and beyond 0.45 R from the centre) and
    "axis" (the radius to the fine point, inside the body). Body: "disc". Raises ValueError unless 0
    < zone <= R/2 and `tilt` is within 45 degrees.
    """
    if not 0 < zone <= R / 2 < math.inf:
        raise ValueError(
            f"the fine zone of a disc must have 0 < zone <= R/2, got zone={zone:g} m, R={R:g} m"
        )
    if not abs(tilt) <= math.pi / 4:
        raise ValueError(
            f"the tilt of a half disc must be at most 45 degrees, got {math.degrees(tilt):g}"
        )
    fine = Zone(zone, cells, refine)
    wide = _side(R, -abs(tilt), fine)
    narrow = _side(R, abs(tilt), fine, least=wide[1].edges[0].cells // refine)
    turn = 1 if tilt >= 0 else -1
    blocks = [b.mirrored(turn, 1) for b in narrow] + [b.mirrored(-turn, 1) for b in wide]
    return placed(mesh_blocks(blocks), turn=-tilt, shift=(R * math.sin(tilt), R * math.cos(tilt)))


def placed(mesh: Mesh2D, *, turn: float, shift: Point) -> Mesh2D:
    """Mesh rotated by `turn` [rad] about the origin, then shifted; names are unchanged."""
    c, s = math.cos(turn), math.sin(turn)
    moved = np.array([[c, -s], [s, c]]) @ mesh.doflocs + np.reshape(shift, (2, 1))
    return replace(mesh, doflocs=moved)


def _side(R: float, rise: float, zone: Zone, least: int = 1) -> list[Block]:
    """Blocks in x >= 0 of the disc about (0, -R), up to a section that rises by `rise` [rad]."""
    x, y = math.cos(rise), math.sin(rise)
    end, far = (R * x, R * (y - 1)), (INNER * R * x, R * (INNER * y - 1))
    outline = Outline(end, far, (0.0, -R), ("surface", "outer", "inner"), centre=-R)
    return fan(outline, zone, "disc", least=least)
