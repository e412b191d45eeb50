"""Races of a sector, one round and one with a flat, mapped from a strip.

Angles are measured from the y axis, clockwise: x = r sin(angle), y = r cos(angle). In the plane of
angle and ln r, a round race is a strip; this map preserves angles.
"""

import math
from dataclasses import dataclass

import numpy as np
from skfem.mesh import Mesh2D

from meshes.contact.fan import Zone
from meshes.freewheel.bent import Places, bent, flat_mesh
from meshes.freewheel.strip import Side, Strip


@dataclass(frozen=True)
class RoundRace:
    """Sector of a ring between the radii `touched`, at the roller, and `other`.

    The sector has the width `pitch` [rad] and is centred on the ray at `angle` [rad] through the
    contact. `names` are those of the circle in contact, of the other circle, and of the body.
    """

    touched: float
    other: float
    pitch: float
    angle: float
    names: tuple[str, str, str]

    def mesh(self, zone: Zone, *, order: int, straight: bool) -> Mesh2D:
        """Mesh with fine cells about the contact; `zone` is measured along the circle `touched`."""
        surface, base, body = self.names
        fine = Zone(zone.width / self.touched, zone.cells, zone.refine)
        left, right = (Side(((surface, self.pitch / 2),), cut) for cut in ("left", "right"))
        thick = math.log(self.other / self.touched)
        up = -1 if thick > 0 else 1
        blocks = Strip(left, right, abs(thick), base, body, fine).blocks()
        mesh = flat_mesh(tuple(block.mirrored(1, up) for block in blocks), order)
        turned, ln = mesh.doflocs
        places = _polar(self.touched * np.exp(ln), self.angle + turned)
        return bent(mesh, places, _outline(mesh), straight=straight)


@dataclass(frozen=True)
class FlatRace:
    """Sector between the flat y = `apothem` and the circle `other`, symmetric about the y axis.

    The sector of a polygon has the width `pitch` [rad]. If its corner is beyond the radius `tip`,
    the circle of this radius cuts it. The contact is at x = `at`. `names` are as for the round
    race; "tip" is the circle that cuts the corner.
    """

    apothem: float
    other: float
    pitch: float
    at: float
    names: tuple[str, str, str]
    tip: float = math.inf

    @property
    def half_flat(self) -> float:
        """Length from the middle of the flat to its end."""
        corner = self.apothem * math.tan(self.pitch / 2)
        return min(corner, math.sqrt(self.tip**2 - self.apothem**2))

    @property
    def half_outline(self) -> float:
        """Length of the outline from the middle of the flat to the section at half a pitch."""
        if self.apothem / math.cos(self.pitch / 2) <= self.tip:
            return self.half_flat
        return self.half_flat + self.tip * (self.pitch / 2 - self._end)

    @property
    def _end(self) -> float:
        """Angle of the end of the flat [rad]."""
        return math.atan(self.half_flat / self.apothem)

    def mesh(self, zone: Zone, *, order: int, straight: bool) -> Mesh2D:
        """Mesh with fine cells about the contact; `zone` is measured along the flat."""
        surface, base, body = self.names
        left, right = (self._side(sign, surface) for sign in (-1, 1))
        radius = math.hypot(self.apothem, self.at)
        thick = math.log(self.other / radius)
        up = -1 if thick > 0 else 1
        # depth for which the cells at the contact are as long as wide
        blocks = Strip(left, right, radius * abs(thick), base, body, zone).blocks()
        mesh = flat_mesh(tuple(block.mirrored(1, up) for block in blocks), order)
        places = self._places(mesh, radius * thick)
        return bent(mesh, places, _outline(mesh), straight=straight)

    def _side(self, sign: int, surface: str) -> Side:
        parts = [(surface, self.half_flat)]
        if self.half_flat < self.half_outline:
            parts.append(("tip", self.half_outline))
        cut = "right" if sign > 0 else "left"
        return Side(tuple((name, end - sign * self.at) for name, end in parts), cut)

    def _places(self, mesh: Mesh2D, thick: float) -> Places:
        """Positions of nodes on rays through the origin; ln r is uniform from outline to circle."""
        x, y = mesh.doflocs
        along = x + self.at
        over = np.maximum(np.abs(along) - self.half_flat, 0)
        flat = np.clip(along, -self.half_flat, self.half_flat)
        angle = np.arctan(flat / self.apothem) + np.sign(along) * over / self.tip
        outline = np.hypot(self.apothem, flat)
        share = y / thick
        return _polar(outline ** (1 - share) * self.other**share, angle)


def _outline(mesh: Mesh2D) -> dict[str, str]:
    """Names of the boundaries that are not inside the body."""
    return {name: name for name in mesh.boundaries if name != "axis"}


def _polar(r: Places, angle: Places) -> Places:
    return r * np.array([np.sin(angle), np.cos(angle)])
