"""Position of a roller between a flat and a round race, and data of one pitch.

The cam is the part with the flats. `sense` is +1 for flats inside a ring and -1 for flats around a
shaft, for which a roller is wedged by the opposite direction of rotation.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D

Array = NDArray[np.float64]


class Names(NamedTuple):
    """Names of bodies, of contact surfaces, and of boundaries with supports."""

    cam: str
    race: str
    flat: str
    bore: str
    cam_held: str
    race_held: str


@dataclass(frozen=True)
class Pitch:
    """Data of z rollers of radius `r` between flats and a race, in SI units.

    `flat` is the distance of the flats from the axis, `race` the radius of the race. `mesh`
    generates the mesh of a pitch for a position of the roller, the half-widths of the contacts and
    the number of cells.
    """

    sense: int
    race: float
    flat: float
    r: float
    r_b: float
    R_a: float
    z: int
    E: float
    nu: float
    names: Names
    mesh: "Callable[[Place, tuple[float, float], int], Mesh2D]"

    @property
    def rigid_angle(self) -> float:
        """Angle psi [rad] without load."""
        return math.acos((self.flat + self.sense * self.r) / (self.race - self.sense * self.r))

    def arc(self, psi: Array, to_race: Array) -> Array:
        """Length [m] of the arc of the roller's centre about the axis, relative to the cam.

        The arc begins at the position without load. `psi` [rad] is the angle of the roller,
        `to_race` [m] the approach of roller and race.
        """
        rho = self.race - self.sense * self.r + self.sense * to_race
        return np.asarray(rho * (psi - self.rigid_angle) * self.sense)


@dataclass(frozen=True)
class Place:
    """Centre of the roller: `x` [m] along the flat and `y` [m] along its normal."""

    q: Pitch
    x: float
    y: float

    @property
    def psi(self) -> float:
        """Angle at the axis between the normal of the flat and the centre of the roller [rad]."""
        return math.atan2(self.x, self.y)

    @property
    def d_i(self) -> float:
        """Approach [m] of roller and inner part."""
        return self._approaches[0]

    @property
    def d_o(self) -> float:
        """Approach [m] of roller and outer part."""
        return self._approaches[1]

    @property
    def to_race(self) -> float:
        """Approach [m] of roller and race."""
        return self.d_o if self.q.sense > 0 else self.d_i

    @property
    def _approaches(self) -> tuple[float, float]:
        q = self.q
        to_flat = q.sense * (q.flat + q.sense * q.r - self.y)
        to_race = q.sense * (math.hypot(self.x, self.y) - (q.race - q.sense * q.r))
        return (to_flat, to_race) if q.sense > 0 else (to_race, to_flat)

    @classmethod
    def overlapping(cls, q: Pitch, d_i: float, d_o: float) -> "Place":
        """Position in which the inner contact overlaps by `d_i` and the outer by `d_o` [m]."""
        to_flat, to_race = (d_i, d_o) if q.sense > 0 else (d_o, d_i)
        y = q.flat + q.sense * q.r - q.sense * to_flat
        return cls(q, math.sqrt((q.race - q.sense * q.r + q.sense * to_race) ** 2 - y**2), y)
