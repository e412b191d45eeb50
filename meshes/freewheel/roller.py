"""Roller with contacts at two points of its rim, at an angle of less than half a turn."""

import math

import numpy as np
from skfem.mesh import Mesh2D

from meshes.contact.blocks import Point
from meshes.contact.fan import Zone
from meshes.contact.roller import half_blocks
from meshes.freewheel.bent import Places, bent, flat_mesh

NAMES = {"near": "inner", "far": "outer"}


def bent_roller(
    *,
    r: float,
    centre: Point,
    rays: tuple[float, float],
    zones: tuple[Zone, Zone],
    order: int,
    straight: bool,
) -> Mesh2D:
    """Mesh of the disc of radius `r` about `centre`, fine at two points of its rim.

    The points are on the `rays` [rad] from the centre, clockwise from +y; the angle from the second
    to the first ray is about half a turn. Boundaries: "inner" and "outer", the halves of the rim
    about the two points, in the order of `rays` and `zones`. Body: "roller". The centre is a
    vertex.
    """
    half = half_blocks(r, zones)
    mesh = flat_mesh((*half, *(block.mirrored(1, -1) for block in half)), order)
    x, y = mesh.doflocs
    radius, angle = np.hypot(x, y), np.arctan2(y, x)
    inner, outer = rays
    # the fine places, at half a turn and at 0, each move by half of the difference from half a turn
    lack = math.pi - (inner - outer)
    angle += math.pi / 2 - outer + lack / 2 * (1 - _bend(angle, radius / r))
    places = radius * np.array([np.cos(angle), np.sin(angle)]) + np.reshape(centre, (2, 1))
    return bent(mesh, places, NAMES, straight=straight)


def _bend(angle: Places, share: Places) -> Places:
    """Even function of `angle`: on the rim, 1 at 0 and -1 at half a turn; at the centre, 0."""
    c = np.cos(angle)
    return (3 * c - c**3) / 2 * share**2 * (2 - share**2)
