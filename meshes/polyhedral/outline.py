"""Outline of half a sector of a polyhedral ring: its corners, and lines across its wall."""

import math
from dataclasses import dataclass

from meshes.contact.blocks import Point


@dataclass(frozen=True)
class Outline:
    """Half a sector of a ring with a bore that is a regular polygon with `z` rounded corners.

    The middle of a side is at the angle 0, the corner at pi/z. `d_e` is the outside diameter, `d_i`
    the diameter of the circle through the rounded corners, `fillet` the radius of the corners. All
    lengths have the same unit.
    """

    z: int
    d_e: float
    d_i: float
    fillet: float

    def __post_init__(self) -> None:
        if not self.z >= 3 or self.z % 1 != 0:
            raise ValueError(f"the number of sides must be whole and z >= 3, got z={self.z:g}")
        if not 0 < self.d_i < self.d_e < math.inf:
            raise ValueError(
                "the diameters of a polyhedral ring must satisfy 0 < d_i < d_e, got "
                f"d_i={self.d_i:g} m, d_e={self.d_e:g} m"
            )
        if not 0 < self.fillet < self.r_i:
            raise ValueError(
                f"the fillet must satisfy 0 < fillet < d_i/2, got fillet={self.fillet:g} m, "
                f"d_i/2={self.r_i:g} m: a sharp corner has infinite stress, and a fillet of d_i/2 "
                "makes the bore round"
            )

    @property
    def r_e(self) -> float:
        return self.d_e / 2

    @property
    def r_i(self) -> float:
        return self.d_i / 2

    @property
    def angle(self) -> float:
        """Angle [rad] from the middle of a side to the corner, and angle of half the fillet."""
        return math.pi / self.z

    @property
    def apothem(self) -> float:
        """Distance from the centre of the ring to the middle of a side."""
        return self.r_i * math.cos(self.angle) + self.fillet * (1 - math.cos(self.angle))

    @property
    def half_flat(self) -> float:
        """Length from the middle of a side to its end at the fillet."""
        return (self.r_i - self.fillet) * math.sin(self.angle)

    @property
    def fillet_centre(self) -> Point:
        return self.on_corner_ray(self.r_i - self.fillet)

    def on_corner_ray(self, r: float) -> Point:
        """Point at the radius `r` on the ray through the corner."""
        return r * math.cos(self.angle), r * math.sin(self.angle)

    def above(self, s: float) -> Point:
        """Outer end of the line across the wall that starts on the flat at `s`.

        The direction of the line is between the normal of the flat and the radius of the ring,
        nearer to the normal.
        """
        normal, radius = math.asin(s / self.r_e), math.atan2(s, self.apothem)
        turn = normal + (radius - normal) / 3
        return self.r_e * math.cos(turn), self.r_e * math.sin(turn)

    def wall(self, s: float) -> float:
        """Length of the line across the wall that starts on the flat at `s`."""
        return math.dist((self.apothem, s), self.above(s))
