"""Position of a roller between a flat and a round race, and the parts of one pitch.

The cam has the flats. `sense` is +1 for flats inside a ring and -1 for flats around a shaft, for
which the direction of rotation that wedges a roller is reversed.
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
    """Names of the bodies, of the touched surfaces, and of the boundaries that hold them."""

    cam: str
    race: str
    flat: str
    bore: str
    cam_held: str
    race_held: str


@dataclass(frozen=True)
class Pitch:
    """z rollers of the radius `r` between flats at a distance `flat` and a race `race`, all SI.

    `mesh` makes a pitch at a position, for contacts of given half-widths and number of cells.
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
        """The angle psi [rad] without load."""
        return math.acos((self.flat + self.sense * self.r) / (self.race - self.sense * self.r))

    def arc(self, psi: Array, to_race: Array) -> Array:
        """Arc [m] of the roller's centre about the axis relative to the cam, from no load on.

        `psi` [rad] is its angle, `to_race` [m] the approach of roller and race.
        """
        rho = self.race - self.sense * self.r + self.sense * to_race
        return np.asarray(rho * (psi - self.rigid_angle) * self.sense)


@dataclass(frozen=True)
class Place:
    """Centre of the roller: `x`, `y` [m] along the flat and along its normal."""

    q: Pitch
    x: float
    y: float

    @property
    def psi(self) -> float:
        """Angle at the axis between the flat's normal and the roller's centre [rad]."""
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
        """The place in which the contacts overlap by these."""
        to_flat, to_race = (d_i, d_o) if q.sense > 0 else (d_o, d_i)
        y = q.flat + q.sense * q.r - q.sense * to_flat
        return cls(q, math.sqrt((q.race - q.sense * q.r + q.sense * to_race) ** 2 - y**2), y)
