"""Single panels: a rectangle, and a part of a circular cylinder."""

import math

from meshes.shell.strip import swept_path
from meshes.shell.surface import ShellMesh
from meshes.spring.path import Piece


def rectangle(*, length: float, width: float, along: int, across: int) -> ShellMesh:
    """Mesh of a rectangle from x = 0 to x = `length` and from z = 0 to z = `width`.

    Boundaries: "head" (x = 0), "tail" (x = `length`), "middle" (z = 0) and "edge" (z = `width`).
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
    """Mesh of a cylinder panel from the crown (0, `radius`, z) over `angle` [rad] towards +x.

    Boundaries: "head" (the crown), "tail" (the other end), "middle" (z = 0) and "edge" (z =
    `width`). At the edge, cells have the size `finest`, see `swept_path`. Normals point to the
    axis.
    """
    if not (radius > 0 and 0 < angle <= math.pi / 2):
        raise ValueError(
            f"radius must be positive and angle must be in (0, 90] deg, got radius={radius:g}, "
            f"angle={math.degrees(angle):g} deg"
        )
    arc = Piece("arc", 0.0, radius, 0.0, radius * angle, -angle, 1)
    return swept_path([arc], width=width, per_arc=around, per_leaf=1, across=across, finest=finest)
