"""Readings, assumptions and warnings of rollers on races."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from verify.cases.contact.roller.inputs import MOST

if TYPE_CHECKING:
    from verify.cases.contact.roller.formulas import SlicedRoller

SETTLED = 5e-3  # change of pressure with twice the strips up to which there is no warning
READINGS = (
    "E' of Eq. 1 is E/(1 − ν²) for steel on steel, which equals 2 E*",
    "y = 0 is at mid-length, and the crown is equal at both ends",
    "s of Eq. 5 is Palmgren's constant for the whole length, to the power 1/0.9",
)
COUPLED = (
    "the weights w of Eq. 3 are influence coefficients of a half-space for Hertz's contact width: "
    "slices are coupled"
)
ASSUMPTIONS = (
    "the paper prints neither length nor loads: the length of 9 mm and the static load at 25 N m "
    "for a wedge angle of 3.15° are fitted (CALIBRATED). The rows compare models at these values "
    "and do not judge the paper",
    "no friction, small strain; both bodies are half-spaces with E*, continued beyond the ends",
    "the largest pressure is taken outside the end zones d, because the pressure of a half-space "
    "is unbounded at a loaded end",
    "the grid of the half-space is refined across and along the roller; the difference between "
    "neighbouring grids counts as iteration error",
    "the weights w are Love's influence coefficients for uniform pressure over Hertz's contact "
    "width under the mean line load; the exponent is 10/9 (Palmgren's law). With other influence "
    "functions for this width, or with the exponent 1, scaled to the same approach of the bodies, "
    "the pressures change by less than the rows can detect",
)


def of_contact(q: "SlicedRoller") -> Iterator[str]:
    """Warnings about loaded ends, about parts out of contact, and about too few strips."""
    if q.loaded_ends and q.p_largest > 1.005 * q.p_max:
        yield (
            f"an end is loaded: its pressure ({q.p_largest / 1e6:.4g} MPa with {q.n} strips) grows "
            "with every refinement, and the material yields; use p_d and the share of the load "
            "in the end zones d; a free end face reduces this load by about a quarter "
            "(contact-roller-end)"
        )
    if q.l_c < 0.98 * q.L * (1 - 1 / q.n):
        yield f"only {q.l_c * 1e3:.4g} mm of l = {q.L * 1e3:.4g} mm are in contact"
    pairs = ((q.twice.p_max, q.p_max), (q.twice.p_mid, q.p_mid))
    change = max((abs(twice / p - 1) for twice, p in pairs if p > 0), default=0.0)
    if change > SETTLED and q.n < MOST and not q.loaded_ends:  # under loaded ends no better
        yield f"{q.n} strips are too few: with twice as many, the pressure changes by {change:.1%}"


def of_materials(q: "SlicedRoller") -> Iterator[str]:
    """Warnings about pressures and materials for which the models are not valid."""
    largest = max(q.p_largest, q.p_max)
    if largest > 4e9:
        yield (
            f"{largest / 1e6:.4g} MPa exceeds 4000 MPa, the static load rating of "
            "hardened rollers (ISO 76): permanent indentations are expected"
        )
    yield from of_width(q.b, q.R_1)
    if min(q.E_1, q.E_2) < 180e9 or max(q.E_1, q.E_2) > 230e9:
        yield (
            "the slices use Palmgren's law for steel on steel; the moduli are not those of steel: "
            "use the strips"
        )


def of_width(b: float, R_1: float) -> Iterator[str]:
    """Warning if the contact is wide compared with the roller."""
    if b > 0.05 * R_1:
        yield (
            f"half-width b = {b * 1e3:.4g} mm is {b / R_1:.1%} of the radius of the roller, "
            f"{R_1 * 1e3:.4g} mm (more than 5 %): the model of a half-space becomes inaccurate"
        )
