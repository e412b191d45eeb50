"""Assumed inputs of roller freewheels and of polyhedral ring clutches."""

import math
from functools import partial

from verify.answers.assumed.materials import CONTACT_PRESSURE, ROLLER_FRICTION, STEEL
from verify.answers.assumed.rules import Assumption, Given

WEDGE, NARROW, WIDE = (math.radians(angle) for angle in (7.0, 6.0, 8.0))  # between flat and race
SPACING = 2.2  # of the rollers' centres, over their diameter
CUP_RIM = 1.17  # outer radius of a cup with its housing, over the radius of its corners
STAR_RING, STAR_BORE = 1.27, 0.66  # outer radius of the ring over R, bore over X
FEWEST_ROLLERS, MOST_ROLLERS = 3, 100


def is_star(g: Given) -> bool:
    """Whether the clutch has an inner cam (flats on the inner part)."""
    return bool(g.kind == "inner cam")


def centres(g: Given) -> float:
    """Radius [m] of the pitch circle of the rollers."""
    return float(g.R - g.r if is_star(g) else g.R + g.r)


def rollers(g: Given) -> int:
    """Number of rollers on the pitch circle for a spacing of 2.2 roller diameters."""
    z: int = round(2 * math.pi * centres(g) / (SPACING * 2 * g.r))
    return min(max(z, FEWEST_ROLLERS), MOST_ROLLERS)


def flats(g: Given, wedge: float = WEDGE) -> float:
    """Distance X [m] of the flats from the axis for the given wedge angle [rad]."""
    sign = -1 if is_star(g) else 1
    return float(centres(g) * math.cos(wedge) + sign * g.r)


def outer_radius(g: Given) -> float:
    """Outer radius R_a [m] of the outer part."""
    return float(STAR_RING * g.R if is_star(g) else CUP_RIM * g.X / math.cos(math.pi / g.z))


FREEWHEEL_CLUTCH = (
    Assumption(name="z", value=rollers,
               source="typical: roller spacing of 2.2 roller diameters on the pitch circle"),
    Assumption(name="X", value=flats, usual=(partial(flats, wedge=WIDE),
                                             partial(flats, wedge=NARROW)),
               source="typical: wedge angle of 7 deg between flat and race (6 to 8 deg): X = "
               "(R - r) cos 7° - r for an inner cam, (R + r) cos 7° + r for an outer cam"),
    Assumption(name="R_a", value=outer_radius,
               source="typical: 1.27 R for a ring around an inner cam, 1.17 X/cos(π/z) for a cup "
               "with its housing"),
    Assumption(name="r_b", value=lambda g: STAR_BORE * g.X if is_star(g) else 0.0,
               source="typical: 0.66 X for an inner cam; the shaft inside an outer cam is solid"),
    Assumption(name="F_ax", value="0 N", source="no axial load is given"),
    ROLLER_FRICTION,
    *STEEL,
    CONTACT_PRESSURE,
)  # fmt: skip

CLEARANCE, LARGE, SMALL = 0.0006, 0.0009, 0.0003  # j_D over D_i
WALL, FILLET, HUB = 0.05, 0.2, 0.53  # over d_e, d and half a flat


def ring_diameter(g: Given, clearance: float = CLEARANCE) -> float:
    """Outer diameter [m] of the ring with a diametral clearance of `clearance` times D_i."""
    return float((1 - clearance) * g.D_i - 2 * g.d)


def hub_contact(g: Given) -> float:
    """Distance [m] from the contact point of the hub to the middle of a flat."""
    corner = g.d_e / 2 - g.delta_1
    return float(HUB * (corner - g.rho) * math.sin(math.pi / g.z))


POLYHEDRAL_CLUTCH = (
    Assumption(name="p_t", value="30 MPa", usual=("20 MPa", "40 MPa"),
               source="typical: pressure of industrial hydraulics, 20 to 40 MPa"),
    Assumption(name="z", value=6, usual=(5, 8), source="typical: six rollers"),
    Assumption(name="d_e", value=ring_diameter, usual=(partial(ring_diameter, clearance=LARGE),
                                                       partial(ring_diameter, clearance=SMALL)),
               source="typical: D_i - 2 d less a clearance of 0.0006 D_i on the diameter (0.0003 "
               "to 0.0009)"),
    Assumption(name="delta_1", value=lambda g: WALL * g.d_e, source="typical: 0.05 d_e"),
    Assumption(name="rho", value=lambda g: FILLET * g.d, source="typical: 0.2 d"),
    Assumption(name="e", value=hub_contact, source="typical: 0.53 of half a flat of the bore"),
    ROLLER_FRICTION,
    Assumption(name="tan_phi", value=0.05, usual=(0.03, 0.1),
               source="typical: lubricated steel on steel, 0.03 to 0.10"),
    *STEEL,
)  # fmt: skip
