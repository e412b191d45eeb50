"""What sectors of both kinds of roller freewheels have in common, by the names of their parts.

The cam has the flats, the race is round. `sense` is +1 for a star with flats in a ring and -1 for a
cup with flats around a shaft: what draws a roller into the wedge then turns the other way.
"""

from dataclasses import dataclass
from typing import Protocol


class OneClutch(Protocol):
    """Rollers of radius `r` between flats at a distance `flat` and a race of radius `race`, SI."""

    def __hash__(self) -> int: ...
    @property
    def sense(self) -> int: ...
    @property
    def race(self) -> float: ...
    @property
    def flat(self) -> float: ...
    @property
    def r(self) -> float: ...
    @property
    def r_b(self) -> float: ...
    @property
    def R_a(self) -> float: ...
    @property
    def z(self) -> int: ...
    @property
    def L(self) -> float: ...
    @property
    def T(self) -> float: ...
    @property
    def E(self) -> float: ...
    @property
    def nu(self) -> float: ...


@dataclass(frozen=True)
class Bodies:
    """Names of the bodies, of the touched surfaces, and of the boundaries that hold them."""

    cam: str
    race: str
    flat: str
    bore: str
    cam_held: str
    race_held: str


BODIES = {
    1: Bodies("star", "ring", "star.flat", "ring.bore", "star.bore", "ring.rim"),
    -1: Bodies("cup", "shaft", "cup.flat", "shaft.rim", "cup.rim", "shaft.bore"),
}
