"""Permissible change of a number since a release.

A stated number is identical on every processor: any difference is reported. Stated numbers are
requirements, and acceptance limits, bounds, printed digits, and ends or widths of intervals that
are literals in the source.

The last digits of a computed number (a value, a bound from a condition number, an interval from a
series) depend on the processor. More digits depend on it if equations are badly conditioned. A
difference is reported if it exceeds the numerical error of the row in both runs and 10 % of the
band of the row.

A record does not state to which kind a number belongs; this is determined from the digits of the
number (module digits). A number is treated as stated if it is stated in one of the runs: if an
estimate is replaced by a literal, or a literal by an estimate, the source has changed.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass

from verify.audit.releases.digits import RECORDED_TOL, is_literal, is_printed, is_stated
from verify.audit.releases.store import Kept
from verify.judging.judge import COVERAGE

BAND_SHARE = 0.1  # of the row's band
ROUND_OFF = 1e-10  # over the row's scale: closed formulas on any processor
SOLVE_TOL = 1e-6  # relative, of solved values whose error is not recorded: 4e-9 between processors
RELATIVE_ROUND_OFF = 1e-15  # of figures over the scale


@dataclass(frozen=True)
class Figure:
    """A limit of a row, such as its requirement, before and now; an increase loosens the row.

    A difference is reported if it exceeds `limit`. A figure that no longer exists is considered
    loosened. A `stated` figure is printed with all digits that differ.
    """

    aspect: str
    was: float | None
    now: float | None
    limit: float
    stated: bool

    @property
    def is_loosened(self) -> bool:
        """Whether the figure has increased or no longer exists."""
        return self.was is not None and (self.now is None or self.now - self.was > self.limit)

    @property
    def is_tightened(self) -> bool:
        """Whether the figure has decreased."""
        if self.was is None or self.now is None:
            return False
        return self.was - self.now > self.limit


def figures(was: Kept, now: Kept) -> Iterator[Figure]:
    """Requirement, bound, acceptance limit and reference uncertainty of a row, before and now."""
    error = relative_error(was, now)
    limit = RECORDED_TOL * (was.demand or 0.0) + RELATIVE_ROUND_OFF
    demanded = _either_literal(was.demand, now.demand)
    yield Figure("demand", was.demand, now.demand, limit, demanded)
    yield _figure("bound", was.bound, now.bound, _either_stated(was.bound, now.bound), 0.0)
    accepted = _either_literal(was.accepted, now.accepted)
    yield _figure("acceptance", was.accepted, now.accepted, accepted, error)
    printed = any(is_printed(u) for u in (was.u_ref, now.u_ref))
    old, new = _relative(was.u_ref, was.scale), _relative(now.u_ref, now.scale)
    yield _figure("reference", old, new, printed, error / COVERAGE)


def _figure(
    aspect: str, was: float | None, now: float | None, stated: bool, error: float
) -> Figure:
    size = abs(was or 0.0)
    limit = RECORDED_TOL * size if stated else max(error, BAND_SHARE * size)
    return Figure(aspect, was, now, limit + RELATIVE_ROUND_OFF, stated)


def is_wider(
    old: tuple[float, float] | None, new: tuple[float, float] | None, error: float
) -> bool:
    """Whether `new` extends beyond `old` at an end, or is wider than `old` if a width is stated.

    `error` is the numerical error of the row, with the same scale as the interval. The centre of an
    interval with a stated width may be computed.
    """
    if old is None or new is None:
        return old is not None
    rounding = RECORDED_TOL * max(map(abs, (*old, *new)))
    width, new_width = old[1] - old[0], new[1] - new[0]
    computed = max(error, BAND_SHARE * width / 2)
    for was, now, beyond in ((old[0], new[0], old[0] - new[0]), (old[1], new[1], new[1] - old[1])):
        if beyond > rounding + (0.0 if _either_literal(was, now) else computed):
            return True
    stated = is_stated(width, rounding) or is_stated(new_width, rounding)
    return stated and new_width - width > 2 * rounding


def _either_stated(was: float | None, now: float | None) -> bool:
    return is_stated(was) or is_stated(now)


def _either_literal(was: float | None, now: float | None) -> bool:
    return is_literal(was) or is_literal(now)


def numerical_error(was: Kept, now: Kept) -> float:
    """Expanded numerical error of both runs together, in the unit of the row.

    For a balance, it is computed from the tolerances. For a fact, it is computed from the
    uncertainties of the margin, which are stored as tolerances. For other rows, `u_num` is used.
    """
    if was.kind in ("exact", "fact"):
        return math.hypot(was.tolerance or 0.0, now.tolerance or 0.0)
    return COVERAGE * math.hypot(was.u_num or 0.0, now.u_num or 0.0)


def relative_error(was: Kept, now: Kept) -> float:
    """Expanded numerical error of both runs relative to the scale; zero if unknown."""
    if was.u_num is None or now.u_num is None:
        return 0.0
    return _relative(numerical_error(was, now), was.scale) or 0.0


def half_width(row: Kept) -> float | None:
    """Half of the permissible range of the difference of a row, relative to its scale.

    The range is that of the interval, of the acceptance limit or of the tolerance.
    """
    if row.interval is not None:
        return (row.interval[1] - row.interval[0]) / 2
    return row.accepted if row.accepted is not None else _relative(row.tolerance, row.scale)


def value_limit(was: Kept, now: Kept) -> float:
    """Permissible change of a formula or finite-element value, in the unit of the row.

    This is the numerical error of both runs or 10 % of the narrower band, whichever is larger. It
    is zero if a row has neither.
    """
    if was.kind == "fact":
        return margin_limit(was, now)
    bands = [(half_width(row) or 0.0) * (row.scale or 0.0) for row in (was, now)]
    return max(numerical_error(was, now), BAND_SHARE * min(bands))


def scale_limit(was: Kept, now: Kept) -> float:
    """Permissible change of the scale, in the unit of the row.

    This is the numerical error of both runs or 10 % of the scale at the release, whichever is
    larger.
    """
    scale = abs(was.scale or 0.0)
    return max(relative_error(was, now), BAND_SHARE) * scale


def margin_limit(was: Kept, now: Kept) -> float:
    """Permissible change of the margin of a fact, in the unit of the row.

    This is the numerical error of the margin, or 10 % of the margin at the release, whichever is
    larger.
    """
    error = math.hypot(was.tolerance or 0.0, now.tolerance or 0.0)
    return max(error, BAND_SHARE * abs(was.difference or 0.0))


def sensitivity_limit(row: Kept) -> float:
    """Permissible increase of a detection limit or an uncertainty, relative to the scale.

    This is 10 % of the band. For an identity, whose tolerance is its uncertainty, it is 10 % of the
    required sensitivity.
    """
    if row.kind == "fact":
        return 0.0
    is_banded = row.interval is not None or row.accepted is not None
    return BAND_SHARE * ((half_width(row) if is_banded else row.demand) or 0.0)


def _relative(u: float | None, scale: float | None) -> float | None:
    return None if u is None or not scale else u / scale
