"""Single panels: a rectangle, and a part of a circular cylinder."""

import math

from meshes.shell.strip import swept_path
from meshes.shell.surface import ShellMesh
from meshes.spring.path import Piece


def rectangle(*, length: float, width: float, along: int, across: int) -> ShellMesh:
    """From x = 0 ("head") to x = `length` ("tail"), z = 0 ("middle") to z = `width` ("edge").

    Normals point along -y.
    """
    if not length > 0:
        raise ValueError(f"length must be positive, got {length:g}")
    leaf = Piece("leaf", 0.0, 0.0, 0.0, length, 0.0, 1)
    return swept_path([leaf], width=width, per_arc=1, per_leaf=along, across=across)


def cylinder_panel(
    *,
    radius: float,
    angle: float,
    width: float,
    around: int,
    across: int,
    finest: float | None = None,
) -> ShellMesh:
    """From the crown (0, `radius`, z) ("head") over `angle` [rad] towards +x ("tail").

    z = 0 is "middle" and z = `width` "edge", with cells from `finest` on as in `swept_path`.
    Normals point to the axis.
    """
    if not (radius > 0 and 0 < angle <= math.pi / 2):
        raise ValueError(
            f"needs a positive radius and an angle in (0, 90] deg, got radius={radius:g}, "
            f"angle={math.degrees(angle):g} deg"
        )
    arc = Piece("arc", 0.0, radius, 0.0, radius * angle, -angle, 1)
    return swept_path([arc], width=width, per_arc=around, per_leaf=1, across=across, finest=finest)
