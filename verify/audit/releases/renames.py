"""Rows renamed since a release, found in the list of renamed rows or by equal numbers."""

import math
import re
from collections.abc import Collection, Mapping, Sequence

from verify.audit.releases.row_changes import CONVERGENCE
from verify.audit.releases.store import Kept
from verify.audit.releases.thresholds import SOLVE_TOL
from verify.cases.names import present_name
from verify.core.results import NAME, Change

SAME_RUN = 1e-9  # relative, of all numbers of a row on the same processor

Numbers = Sequence[float | None]


def renamed_rows(
    before: Mapping[str, Kept], now: Mapping[str, Kept], whole: Collection[str]
) -> dict[str, str]:
    """Renamed rows since a release (new id: old id).

    Listed names have priority. Otherwise, a row is renamed if exactly one row with the same case,
    kind, unit and values fits.
    """
    gone = [i for i in before if i not in now and case_of(i) in whole]
    found = {
        new: old for old in gone
        if (new := present_name(old)) in now and _may_be(old, new, before[old], now[new])
    }  # fmt: skip
    for is_same in (_same_run, _same_value):
        for new in (i for i in now if i not in before and i not in found):
            fits = [
                old for old in gone
                if old not in found.values() and _may_be(old, new, before[old], now[new])
                and is_same(before[old], now[new])
            ]  # fmt: skip
            if len(fits) == 1:
                found[new] = fits[0]
    return found


def _may_be(old: str, new: str, was: Kept, now: Kept) -> bool:
    """Whether two rows have the same case, kind and unit."""
    is_order = [name.endswith(CONVERGENCE) for name in (old, new)]
    return (
        case_of(old) == case_of(new)
        and is_order[0] == is_order[1]
        and (was.kind, was.unit) == (now.kind, now.unit)
    )


def _same_run(was: Kept, now: Kept) -> bool:
    """Whether all numbers are equal, as in runs on the same processor."""
    return _repeats(
        *([x.analytic, x.reference, x.difference, x.u_num] for x in (was, now)), tol=SAME_RUN
    )


def _same_value(was: Kept, now: Kept) -> bool:
    """Whether compared values or margins of a fact are equal, except for processor effects."""
    values = [[x.analytic, x.reference] for x in (was, now)]
    if any(v is not None for v in values[0]):
        return _repeats(*values, tol=SOLVE_TOL)
    return _repeats([was.difference], [now.difference], tol=SOLVE_TOL)


def _repeats(was: Numbers, now: Numbers, *, tol: float) -> bool:
    return any(v is not None for v in was) and all(
        (a is None and b is None)
        or (a is not None and b is not None and math.isclose(a, b, rel_tol=tol))
        for a, b in zip(was, now, strict=True)
    )


def name_change(old: str, new: str) -> Change:
    """Record of a changed name of a row.

    If the new name states another figure, the change counts as loosened, because the row may claim
    less.
    """
    figures = [re.findall(r"\d+(?:\.\d+)?(?= ?%)", name) for name in (old, new)]
    return Change(
        row=new, aspect=NAME, was=old.partition("/")[2], now=new.partition("/")[2],
        loosened=figures[0] != figures[1],
    )  # fmt: skip


def case_of(row_id: str) -> str:
    """Id of the case in the id of a row."""
    return row_id.partition("/")[0]
