"""Checks of the dimensions of a sprag sector; lengths in metres, also in the messages."""

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
    """Raise ValueError unless z >= 3 is whole and the `radii` [m] are positive and ascending."""
    if not z >= 3 or z % 1 != 0:
        raise ValueError(f"the number of sprags must be whole and z >= 3, got z={z:g}")
    if not all(low < high for low, high in pairwise((0.0, *radii, math.inf))):
        found = ", ".join(f"{radius:g}" for radius in radii)
        raise ValueError(
            f"the radii of a sprag clutch must satisfy 0 < R_id < R_i < R_e < R_ed, got {found} m"
        )


def check_place(at: Placed, R_i: float, R_e: float) -> None:
    """Raise ValueError unless the sprag is approximately between the races."""
    if not max(abs(at.turn), abs(math.atan2(*at.pole))) <= FURTHEST:
        raise ValueError(
            "the pole of a sprag must be within 45 degrees of +y and its rotation within 45 "
            f"degrees, got ({at.pole[0]:g}, {at.pole[1]:g}) m and {math.degrees(at.turn):g} degrees"
        )
    for where, place, radius in (("inner", at.inner, R_i), ("outer", at.outer, R_e)):
        if not abs(math.hypot(*place) - radius) <= ASTRAY * (R_e - R_i):
            raise ValueError(
                f"the sprag must reach the {where} race at the radius {radius:g} m, to within a "
                f"quarter of R_e - R_i, got the radius {math.hypot(*place):g} m"
            )


def check_beside(at: Placed, pitch: float) -> None:
    """Raise ValueError if neighbouring sprags, spaced by `pitch` [rad], overlap."""
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
            f"sprags of the width b={sprag.b:g} m must not overlap: at the radius "
            f"{radius[widest]:g} m, a sprag needs {math.degrees(width[widest]):.4g} degrees, "
            f"but only {math.degrees(pitch):.4g} degrees are available"
        )


def check_flank(where: str, reach: Reach) -> None:
    """Raise ValueError if the contact is too close to a flank for cells between them."""
    if not reach.share >= NEAREST:
        raise ValueError(
            f"the sprag touches the {where} race at {reach.least:g} m from a flank, but this "
            f"distance must be at least {NEAREST * reach.least / reach.share:g} m: "
            "make the sprag wider or rotate it less"
        )


def check_zone(where: str, race: RoundRace, room: float, zone: float) -> None:
    """Raise ValueError unless the half-width `zone` [m] fits the race and the flank."""
    wall = race.touched * min(abs(math.log(race.other / race.touched)), race.pitch / 4)
    bound = min(room / ROOM, wall)
    if not 0 < zone <= bound:
        raise ValueError(
            f"the fine zone at the {where} contact must be positive and at most {bound:g} m, got "
            f"{zone:g} m: the limit is about the smallest of the thickness of the wall, a quarter "
            "of the pitch, and 3/4 of the distance to the flank"
        )
