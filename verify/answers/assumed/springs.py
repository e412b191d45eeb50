"""Assumed inputs of accordion springs and of their design task."""

from analytic.spring import energy, frame
from analytic.spring.wide_leaf import width_factor
from verify.answers.assumed.materials import STEEL
from verify.answers.assumed.rules import Assumption, Given

STROKE = 0.6  # of the free length
THICKNESSES = ["0.05 mm", "0.06 mm", "0.08 mm", "0.09 mm", "0.1 mm", "0.11 mm", "0.12 mm",
               "0.15 mm", "0.2 mm", "0.25 mm", "0.3 mm"]  # fmt: skip
LEAVES, ARCS = (0.37, 0.52, 41), (0.013, 0.024, 7)  # ranges and numbers of L_1 and r over L_max


def stiffening(g: Given) -> float:
    """Ratio of the bending stiffness of the leaves as plates to that of narrow strips [1]."""
    leaf = energy.leaf_length(L1=g.L1, r=g.r, b=g.b, alpha=g.alpha)
    return float(width_factor(g.h, leaf, nu=g.nu))


def stroke(g: Given) -> float:
    """Largest displacement [m] of the force-displacement curve: 0.6 of the free length."""
    return STROKE * frame.free_length(n=g.n, b=g.b, r=g.r, L1=g.L1, alpha=g.alpha)


def span(g: Given, shares: tuple[float, float, int]) -> str:
    """Range of a length in the format of a TOML file, in proportion to L_max.

    `shares` are the lowest and the highest length divided by L_max, and the number of lengths.
    """
    low, high, count = shares
    return f"{low * g.wedge * 1e3:.4g} mm : {high * g.wedge * 1e3:.4g} mm : {count}"


ARC_ANGLE = Assumption(name="alpha", value="80 deg", source="Wang 2023, Sec. 1.2",
                       usual=("77 deg", "83 deg"))  # fmt: skip

SPRING_ACCORDION = (ARC_ANGLE, *STEEL)
SPRING_CURVE = (
    ARC_ANGLE,
    *STEEL,
    Assumption(name="width_factor", value=stiffening, usual=(1.0, 1.0988),
               source="stiffness of a leaf as a plate of width h (Timoshenko, Theory of Plates "
                      "and Shells)"),
    Assumption(name="mu", value=0.15, usual=(0.1, 0.2),
               source="Wang 2023, friction coefficient of the finite-element model"),
    Assumption(name="stroke", value=stroke, source="0.6 of the free length L_0"),
)  # fmt: skip

DESIGN_SPRING = (
    *STEEL,
    Assumption(name="sigma", value="500 MPa", usual=("400 MPa", "1000 MPa"),
               source="typical: a third of the tensile strength 1500 MPa of cold-rolled spring "
               "strip (EN 10151, 1.4310 C1500), for repeated bending"),
    Assumption(name="e_max", value="3 %", source="Wang 2023, Eq. 11"),
    Assumption(name="ratio_min", value=0.3, source="Wang 2023, Eq. 12"),
    Assumption(name="ratio_max", value=0.6, source="Wang 2023, Eq. 12"),
    Assumption(name="n", value=lambda _: [6, 8, 10, 12, 14, 16],
               source="typical: 6 to 16 segments, around the numbers of Wang 2023"),
    Assumption(name="b", value=lambda _: THICKNESSES,
               source="typical: thicknesses of cold-rolled strip"),
    Assumption(name="L1", value=lambda g: span(g, LEAVES),
               source="0.37 to 0.52 of L_max, around the proportion of Wang 2023"),
    Assumption(name="r", value=lambda g: span(g, ARCS),
               source="0.013 to 0.024 of L_max, around the proportion of Wang 2023"),
    Assumption(name="alpha", value=lambda _: "77 deg : 83 deg : 7",
               source="Wang 2023, Sec. 1.2: 80 deg, ± 3 deg"),
)  # fmt: skip
