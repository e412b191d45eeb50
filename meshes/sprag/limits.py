"""Checks of a sector of a sprag clutch; all lengths in metres, as in the messages."""

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from meshes.freewheel.races import RoundRace
from meshes.sprag.column import Reach
from meshes.sprag.profile import Placed

ASTRAY = 1 / 4  # over the gap between the races: largest gap or overlap of the sprag with either
FURTHEST = math.pi / 4  # largest rotation of a sprag, and angle of its pole from +y [rad]
ROOM = 4 / 3  # fine zones that fit between the contact and the flank
NEAREST = 1 / 4  # of half the outline: smallest distance of a contact from the flank
ALONG = 41  # points of a flank that are compared with the next sprag's


def check_radii(radii: Sequence[float], z: float) -> None:
    """ValueError unless z >= 3 is whole and the `radii` [m] are positive and ascending."""
    if not z >= 3 or z % 1 != 0:
        raise ValueError(f"a sprag clutch needs a whole number z >= 3 of sprags, got z={z:g}")
    if not all(low < high for low, high in pairwise((0.0, *radii, math.inf))):
        found = ", ".join(f"{radius:g}" for radius in radii)
        raise ValueError(f"a sprag clutch's walls need 0 < R_id < R_i < R_e < R_ed, got {found} m")


def check_place(at: Placed, R_i: float, R_e: float) -> None:
    """ValueError unless the sprag is approximately between the races."""
    if not max(abs(at.turn), abs(math.atan2(*at.pole))) <= FURTHEST:
        raise ValueError(
            "a sprag is drawn with its pole within 45 degrees of +y and turned by up to 45 "
            f"degrees, got ({at.pole[0]:g}, {at.pole[1]:g}) m and {math.degrees(at.turn):g} degrees"
        )
    for where, place, radius in (("inner", at.inner, R_i), ("outer", at.outer, R_e)):
        if not abs(math.hypot(*place) - radius) <= ASTRAY * (R_e - R_i):
            raise ValueError(
                f"the sprag must reach about to the {where} race at {radius:g} m, within a quarter "
                f"of R_e - R_i, got {math.hypot(*place):g} m"
            )


def check_beside(at: Placed, pitch: float) -> None:
    """ValueError unless neighbouring sprags, at the `pitch` [rad], do not overlap."""
    sprag, share = at.sprag, np.linspace(0, 1, ALONG)
    flanks = []
    for theta, phi in zip(sprag.below, sprag.above, strict=True):
        low, high = sprag.along_spiral(theta, np.zeros(1)), sprag.along_arc(phi, np.zeros(1))
        x, y = at.placed((1 - share) * low + share * high)
        flanks.append((np.hypot(x, y), np.arctan2(x, y)))
    (r_left, left), (r_right, right) = flanks
    radius = np.linspace(max(r_left.min(), r_right.min()), min(r_left.max(), r_right.max()), ALONG)
    width = np.interp(radius, r_right, right) - np.interp(radius, r_left, left)
    widest = int(np.argmax(width))
    if not width[widest] < pitch:
        raise ValueError(
            f"sprags of the width b={sprag.b:g} m overlap each other: at the radius "
            f"{radius[widest]:g} m, a sprag needs {math.degrees(width[widest]):.4g} degrees, "
            f"available are {math.degrees(pitch):.4g}"
        )


def check_flank(where: str, reach: Reach) -> None:
    """ValueError if the contact is too near to a flank for cells between them."""
    if not reach.share >= NEAREST:
        raise ValueError(
            f"the sprag touches the {where} race {reach.least:g} m from a flank: its contact needs "
            f"{NEAREST * reach.least / reach.share:g} m, make it wider or turn it less"
        )


def check_zone(where: str, race: RoundRace, room: float, zone: float) -> None:
    """ValueError unless the half-width `zone` [m] fits the race's wall and pitch, and the flank."""
    wall = race.touched * min(abs(math.log(race.other / race.touched)), race.pitch / 4)
    bound = min(room / ROOM, wall)
    if not 0 < zone <= bound:
        raise ValueError(
            f"the {where} contact's fine zone needs 0 < zone <= about the wall, a quarter of the "
            f"pitch and 3/4 of the distance to the flank, here {bound:g} m, got {zone:g} m"
        )
