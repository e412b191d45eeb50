"""Readings, assumptions and warnings of rollers on races."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from verify.cases.contact.roller.inputs import MOST

if TYPE_CHECKING:
    from verify.cases.contact.roller.formulas import SlicedRoller

SETTLED = 5e-3  # change of pressure with twice the strips up to which there is no warning
READINGS = (
    "E' of Eq. 1 is E/(1 − ν²) for steel on steel: 2 E*",
    "y counts from mid-length, and the crown is the same at both ends",
    "s of Eq. 5 is Palmgren's constant to the power 1/0.9, for the whole length",
)
COUPLED = "the weights w of Eq. 3 are a half-space's on Hertz's width: slices deflect each other"
ASSUMPTIONS = (
    "length and loads are not printed: 9 mm and the static load at 25 N m for a wedge angle of "
    "3.15° are identified (CALIBRATED); models are compared at these values, and the paper is not "
    "judged",
    "no friction, small strain; both bodies half-spaces of E*, which continue beyond the ends",
    "the largest pressure is that outside the end zones d: in a half-space the pressure of a "
    "loaded end is unbounded",
    "the half-space is refined like a mesh, in cells across and along the roller; the difference "
    "of neighbouring grids counts as iteration",
    "weights w as Love has them for a uniform pressure on Hertz's width of the mean load, and the "
    "exponent 10/9 of Palmgren's law: other kernels of that width, or an exponent of 1 through the "
    "same approach, change pressures by less than these rows resolve",
)


def of_contact(q: "SlicedRoller") -> Iterator[str]:
    """Loaded ends, parts out of contact, too few strips."""
    if q.loaded_ends and q.p_largest > 1.005 * q.p_max:
        yield (
            f"an end carries load: its pressure ({q.p_largest / 1e6:.4g} MPa with {q.n} strips) "
            "grows with every refinement, and the material yields; use p_d and the share of the "
            "ends; a free end face reduces it by about a quarter (contact-roller-end)"
        )
    if q.l_c < 0.98 * q.L * (1 - 1 / q.n):
        yield f"only {q.l_c * 1e3:.4g} mm of l = {q.L * 1e3:.4g} mm are in contact"
    pairs = ((q.twice.p_max, q.p_max), (q.twice.p_mid, q.p_mid))
    change = max((abs(twice / p - 1) for twice, p in pairs if p > 0), default=0.0)
    if change > SETTLED and q.n < MOST and not q.loaded_ends:  # under loaded ends no better
        yield f"{q.n} strips are few: with twice as many the pressure changes by {change:.1%}"


def of_materials(q: "SlicedRoller") -> Iterator[str]:
    """Pressures and bodies that the models are not for."""
    largest = max(q.p_largest, q.p_max)
    if largest > 4e9:
        yield (
            f"{largest / 1e6:.4g} MPa is beyond 4000 MPa, the static rating of "
            "hardened rollers (ISO 76): expect permanent indentations"
        )
    yield from of_width(q.b, q.R_1)
    if min(q.E_1, q.E_2) < 180e9 or max(q.E_1, q.E_2) > 230e9:
        yield (
            "Palmgren's law behind the slices is for steel on steel, which these bodies are not: "
            "use the strips"
        )


def of_width(b: float, R_1: float) -> Iterator[str]:
    """Warning if the contact is wide compared with the roller."""
    if b > 0.05 * R_1:
        yield (
            f"b = {b * 1e3:.4g} mm is {b / R_1:.1%} of the roller's "
            f"radius of {R_1 * 1e3:.4g} mm: it is hardly a half-space"
        )
