"""Checks of the dimensions of a freewheel sector; lengths in metres, also in the messages."""

import math
from collections.abc import Sequence
from itertools import pairwise

from meshes.contact.blocks import Point
from meshes.freewheel.races import FlatRace, RoundRace

STEEPEST = math.pi / 4  # angle psi up to which the roller's mesh bends
ASTRAY = 1 / 2  # relative to the roller's radius: largest gap or overlap with either race
ROOM = 2.0  # fine zones that fit between the contact and the end of the flat


def check_radii(rule: str, radii: Sequence[float], z: float) -> None:
    """Raise ValueError unless z >= 3 is whole and the `radii` [m] are positive and ascending."""
    if not z >= 3 or z % 1 != 0:
        raise ValueError(f"the number of rollers must be whole and z >= 3, got z={z:g}")
    ends = (0.0, *radii, math.inf)
    if not all(low < high for low, high in pairwise(ends)):
        found = ", ".join(f"{radius:g}" for radius in radii)
        raise ValueError(f"the radii of a freewheel must satisfy 0 < {rule}, got {found} m")


def check_roller(r: float, centre: Point, z: int, *, flat: float, circle: float) -> None:
    """Raise ValueError unless the roller fits between the races and beside the next roller.

    `flat` and `circle` are the distances [m] of the centre of the roller from the two races.
    """
    if not 0 < r < math.inf:
        raise ValueError(f"the radius of a roller must be positive and finite, got r={r:g} m")
    if not 0 <= math.atan2(*centre) <= STEEPEST:
        raise ValueError(
            "the roller's centre must have x >= 0 and lie within 45 degrees of +y, got "
            f"({centre[0]:g}, {centre[1]:g}) m"
        )
    for race, distance in (("flat", flat), ("circle", circle)):
        if not abs(distance - r) <= ASTRAY * r:
            raise ValueError(
                f"the roller's centre must be at the distance r={r:g} m, to within r/2, from the "
                f"{race}, got {distance:g} m"
            )
    if not math.hypot(*centre) * math.sin(math.pi / z) > r:
        raise ValueError(
            f"neighbouring rollers must not overlap, got {z} rollers of r={r:g} m with centres at "
            "the radius "
            f"{math.hypot(*centre):g} m"
        )


def check_zones(r: float, cam: FlatRace, race: RoundRace, *, flat: float, circle: float) -> None:
    """Raise ValueError unless fine zones of half-widths `flat` and `circle` [m] fit the bodies."""
    room = (cam.half_flat - abs(cam.at)) / ROOM
    if not room > 0:
        raise ValueError(
            f"the contact must be on the flat: it is at x={cam.at:g} m, the end of the flat at "
            f"x={cam.half_flat:g} m"
        )
    wall = abs(cam.apothem - cam.other)
    bound = min(r / 2, wall, room)
    if not 0 < flat <= bound:
        raise ValueError(
            f"the fine zone on the flat must be positive and at most {bound:g} m, got {flat:g} m: "
            "the limit is the smallest of r/2, the thickness of the wall, and half of the length "
            "to the end of the flat"
        )
    wall = race.touched * min(abs(math.log(race.other / race.touched)), race.pitch / 4)
    bound = min(r / 2, wall)
    if not 0 < circle <= bound:
        raise ValueError(
            f"the fine zone on the circle must be positive and at most {bound:g} m, got "
            f"{circle:g} m: the limit is about the smallest of r/2, the thickness of the wall, and "
            "a quarter of the pitch"
        )
