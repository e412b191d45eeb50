"""Expected errors of contact formulas as intervals that rows are judged by."""

from analytic.bounds.contact.estimate import Estimate
from verify.case import Expected
from verify.judging import judge

FLOOR = 3e-4  # least slack of a relative error at a single load
BLUNT = 1e-3  # least slack for a line contact's shear stress, which is smoothed
SHARP = judge.DEMAND / 2  # slack up to which an estimate judges


def expected(
    known: Estimate, source: str, *, least: float = FLOOR, sharp: float = SHARP
) -> Expected:
    """The interval of an estimate whose slack is `least` at least.

    Not sharp where it is wider than the row requires: the bodies are then too small for an
    estimate, and the formula's error is measured.
    """
    slack = max(float(known.slack), least)
    return Expected(known.error - slack, known.error + slack, source, sharp=slack <= sharp)
