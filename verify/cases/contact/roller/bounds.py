"""Errors that are expected of strips and slices before a half-space is solved."""

from typing import TYPE_CHECKING

from analytic.bounds.contact import roller
from analytic.bounds.contact.line import OnFlat
from verify.cases.contact.expected import expected

if TYPE_CHECKING:
    from verify.cases.contact.roller.formulas import StripRoller

Interval = roller.Interval | None

SLICED = 0.02  # acceptance of the slicing technique's pressures


def of_strips(q: "StripRoller", key: str, *, own: bool) -> Interval:
    """Interval of strips/half-space - 1 from the strips of `q` alone."""
    return roller.of_strips(
        q.neglected[key], value=getattr(q.strips, key), twice=getattr(q.twice, key), b=q.b,
        length=q.L, loaded=q.loaded_ends > 0, own=own,
    )  # fmt: skip


def of_disc(q: "StripRoller", key: str) -> Interval:
    """What Hertz neglects of a disc at mid-length, in "pressure" or "width"."""
    found = expected(getattr(OnFlat(q.b_mid / q.R), key), "")
    return (found.low, found.high) if found.sharp else None
