"""Rule that gives a verdict from errors; docs/verdicts.md explains it."""

from collections.abc import Sequence
from dataclasses import dataclass

from verify.core.verdicts import Safe, Verdict

CLASSES = (0.01, 0.02, 0.05, 0.10)  # of accuracy, relative
SHARP = 0.01  # largest detection limit of rows that show a formula to be exact
SAFE_SIDE_TOLERANCE = 0.02  # largest error on the unsafe side of a conservative formula


@dataclass(frozen=True)
class Point:
    """A relative error, formula/reference - 1, with its expanded uncertainty."""

    error: float
    U: float
    is_paper: bool = True  # at the inputs of the paper, not of a study

    @property
    def size(self) -> float:
        """Size of the error plus uncertainty: the largest error that the uncertainty allows."""
        return abs(self.error) + self.U


def above(points: Sequence[Point]) -> float:
    """Largest error above the reference, including uncertainty; 0 if there is none."""
    return max(0.0, *(p.error + p.U for p in points))


def below(points: Sequence[Point]) -> float:
    """Largest error below the reference as a positive number, including uncertainty."""
    return max(0.0, *(p.U - p.error for p in points))


def on_unsafe_side(points: Sequence[Point], safe: Safe) -> float:
    """Largest error on the unsafe side; if errors on both sides are unsafe, that of both sides."""
    high, low = above(points), below(points)
    return {Safe.ABOVE: low, Safe.BELOW: high, Safe.NEITHER: max(high, low)}[safe]


def accuracy(points: Sequence[Point]) -> float | None:
    """Smallest accuracy class that contains all errors and uncertainties; None if none does."""
    largest = max(p.size for p in points)
    return next((limit for limit in CLASSES if largest <= limit), None)


def judged(points: Sequence[Point], safe: Safe, *, has_range: bool) -> Verdict:
    """Verdict on a formula with known errors at one or more points.

    `has_range` states whether inputs other than the default are compared and all these points are
    solved.
    """
    if accuracy(points) is not None:
        return Verdict.ACCURATE if has_range else Verdict.PART
    unsafe = on_unsafe_side(points, safe)
    if unsafe <= SAFE_SIDE_TOLERANCE:
        return Verdict.CONSERVATIVE
    paper = [p for p in points if p.is_paper]
    holds_there = bool(paper) and accuracy(paper) is not None
    if holds_there or unsafe <= CLASSES[-1]:
        return Verdict.PART
    return Verdict.UNSAFE
