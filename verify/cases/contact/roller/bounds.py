"""Errors that are expected of strips and slices before a half-space is solved."""

from math import isfinite
from typing import TYPE_CHECKING

from verify.cases.contact.line.checks import about

if TYPE_CHECKING:
    from verify.cases.contact.roller.formulas import StripRoller

Interval = tuple[float, float] | None

LEAST = 1e-4  # of a model error: nothing sharper is claimed
OWN = 1e-3  # nor this for inputs of the user, for which nobody chose strips and grids
LOADED = 3e-3  # nor this, there, where an end carries, of which no expansion speaks
SLENDER = 0.03  # of the length, the half-width up to which the expansion is trusted there
WIDEST = 0.01  # and beyond the suite's demand: an interval that judges nothing
TIMES = 2.0  # within which the strips' own estimate of what they neglect holds
SLICED = 0.02  # acceptance of the slicing technique's pressures


def of_strips(q: "StripRoller", key: str, *, own: bool) -> Interval:
    """Interval of strips/half-space - 1 from the strips of `q` alone.

    From half to twice of what they neglect, and either way what is left of strips whose error is
    of first order, twice what they change as there are twice as many; under a loaded end, where
    more of them need not be better, that change once. None where no estimate is known. `own` are
    inputs of the user.
    """
    left, value = -q.neglected[key], getattr(q.strips, key)
    if not isfinite(left) or not value:
        return None
    if own and q.b > SLENDER * q.L:
        return None
    loaded = q.loaded_ends > 0
    change = abs(getattr(q.twice, key) / value - 1)
    least = LEAST if not own else LOADED if loaded else OWN
    cut = (1 if loaded else 2) * change + least
    low, high = sorted((left / TIMES, TIMES * left))
    if own and high - low + 2 * cut > WIDEST:
        return None
    return low - cut, high + cut


def of_disc(q: "StripRoller", coefficient: float) -> Interval:
    """What Hertz neglects of a disc, (a/R)²; the next term, (a/R)⁴, counts once."""
    e = q.b_mid / q.R
    return about(coefficient * e**2, e**4)
