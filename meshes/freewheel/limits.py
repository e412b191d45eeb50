"""Checks of a sector of a freewheel; all lengths in metres, as in the messages."""

import math
from collections.abc import Sequence
from itertools import pairwise

from meshes.contact.blocks import Point
from meshes.freewheel.races import FlatRace, RoundRace

STEEPEST = math.pi / 4  # angle psi up to which the roller's mesh bends
ASTRAY = 1 / 2  # relative to the roller's radius: largest gap or overlap with either race
ROOM = 2.0  # fine zones that fit between the contact and the end of the flat


def check_radii(rule: str, radii: Sequence[float], z: float) -> None:
    """ValueError unless z >= 3 is whole and the `radii` [m] are positive and ascending."""
    if not z >= 3 or z % 1 != 0:
        raise ValueError(f"a freewheel needs a whole number z >= 3 of rollers, got z={z:g}")
    ends = (0.0, *radii, math.inf)
    if not all(low < high for low, high in pairwise(ends)):
        found = ", ".join(f"{radius:g}" for radius in radii)
        raise ValueError(f"a freewheel's walls need 0 < {rule}, got {found} m")


def check_roller(r: float, centre: Point, z: int, *, flat: float, circle: float) -> None:
    """ValueError unless the roller fits between the races and does not overlap the next roller.

    `flat` and `circle` are the distances [m] of its centre from the two races.
    """
    if not 0 < r < math.inf:
        raise ValueError(f"a roller needs r > 0, got r={r:g} m")
    if not 0 <= math.atan2(*centre) <= STEEPEST:
        raise ValueError(
            "the roller's centre needs x >= 0 and to lie within 45 degrees of +y, got "
            f"({centre[0]:g}, {centre[1]:g}) m"
        )
    for race, distance in (("flat", flat), ("circle", circle)):
        if not abs(distance - r) <= ASTRAY * r:
            raise ValueError(
                f"the roller's centre must lie about r={r:g} m from the {race} it touches, within "
                f"r/2, got {distance:g} m"
            )
    if not math.hypot(*centre) * math.sin(math.pi / z) > r:
        raise ValueError(
            f"{z} rollers of r={r:g} m overlap each other with their centres at the radius "
            f"{math.hypot(*centre):g} m"
        )


def check_zones(r: float, cam: FlatRace, race: RoundRace, *, flat: float, circle: float) -> None:
    """ValueError unless the half-widths `flat` and `circle` [m] of the zones fit their bodies."""
    room = (cam.half_flat - abs(cam.at)) / ROOM
    if not room > 0:
        raise ValueError(
            f"the roller touches at x={cam.at:g} m, beyond the end of the flat at "
            f"x={cam.half_flat:g} m"
        )
    wall = abs(cam.apothem - cam.other)
    bound = min(r / 2, wall, room)
    if not 0 < flat <= bound:
        raise ValueError(
            "the fine zone on the flat needs 0 < zone <= r/2, the wall and half of what is left "
            f"to the end of the flat, here {bound:g} m, got {flat:g} m"
        )
    wall = race.touched * min(abs(math.log(race.other / race.touched)), race.pitch / 4)
    bound = min(r / 2, wall)
    if not 0 < circle <= bound:
        raise ValueError(
            "the fine zone on the circle needs 0 < zone <= r/2, about the wall and a quarter of "
            f"the pitch, here {bound:g} m, got {circle:g} m"
        )
