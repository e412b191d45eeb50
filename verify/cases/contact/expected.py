"""Expected errors of contact formulas, as intervals with which rows are judged."""

from analytic.bounds.contact.estimate import Estimate
from verify.case import Expected
from verify.judging import judge

FLOOR = 3e-4  # least slack of a relative error at a single load
BLUNT = 1e-3  # least slack for a line contact's shear stress, which is smoothed
SHARP = judge.DEMAND / 2  # slack up to which an estimate judges


def expected(
    known: Estimate, source: str, *, least: float = FLOOR, sharp: float = SHARP
) -> Expected:
    """Expected error of a formula: interval around `known` with a half-width of at least `least`.

    If the half-width of the interval exceeds `sharp`, the interval is too wide for the required
    sensitivity: the error of the formula is then displayed, but not judged.
    """
    slack = max(float(known.slack), least)
    return Expected(known.error - slack, known.error + slack, source, sharp=slack <= sharp)
