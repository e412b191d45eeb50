"""Tables of the page of a sweep."""

from collections.abc import Iterator, Sequence

import numpy as np

from verify.app.sweep.verdicts import limit_named, place, share
from verify.core import units
from verify.core.figures import Table
from verify.studies.sweep.axes import Axis, Tolerance
from verify.studies.sweep.indices import Estimate, Indices
from verify.studies.sweep.messages import box_in_words, break_in_words, error_with_bar
from verify.studies.sweep.outcome import Course, Outcome
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.region import LIMITS, Region
from verify.studies.sweep.tables import largest, quantities, reasons, statuses, with_unit

MOST_LINES = 200  # of the table of points
MOST_COLUMNS = 6  # rows whose errors stand in it
About = Sequence[Region] | Indices


def overview(plan: Plan, results: Sequence[tuple[Course, About, str]], room: int) -> Table:
    """Table with one line per row, the row with the largest error first."""
    rows = []
    for course, about, _ in results:
        n = largest(course)
        counts = about.within if isinstance(about, Indices) else about
        rows.append((
            course.pair.name, "none" if n is None else error_with_bar(course, n),
            "" if n is None else place(plan, n),
            *(share(one.inside, one.inside + one.outside + one.undecided) for one in counts),
        ))  # fmt: skip
    note = "The formula with the largest error is first; shares are relative to the solved points."
    if len(results) > room:
        note += (
            f" Figures are drawn for the first {room} of {len(results)} formulas; all numbers "
            "are in "
            "points.csv."
        )
    heads = tuple(f"within {100 * limit:g} %" for limit in LIMITS)
    return Table(
        title="Formulas", header=("formula", "largest error", "at", *heads), rows=tuple(rows),
        note=note if len(results) > 1 else "Shares are relative to the solved points.",
    )  # fmt: skip


def regions_table(plan: Plan, found: Sequence[Region]) -> Table:
    header = (
        "limit",
        "inside",
        "undecided",
        "outside",
        "no result",
        "range in which all points are inside",
    )
    rows = [(limit_named(r), r.inside, r.undecided, r.outside, r.unsolved, box_in_words(plan, r))
            for r in found]  # fmt: skip
    ends = [break_in_words(plan, r) for r in found]
    if not any(ends):
        return Table(title="Region of validity", header=header, rows=tuple(rows))
    return Table(
        title="Region of validity", header=(*header, "bounded by"),
        rows=tuple((*row, end) for row, end in zip(rows, ends, strict=True)),
    )  # fmt: skip


def moments(about: Indices) -> Table:
    rows = []
    for what, scatter, unit in quantities(about):
        values = (scatter.mean, scatter.sd, scatter.low, scatter.median, scatter.high)
        cells = (f"{v / units.factor(unit):.5g}" if np.isfinite(v) else "–" for v in values)
        rows.append((with_unit(what, unit), *cells))
    some = any(one.unsolved for one in about.within)
    lost = "Statistics of the solved points only." * some
    if about.dropped:
        lost += (f" {about.dropped} of {about.dropped + about.rows} base points, or points derived "
                 "from them, have no result; the indices are computed without these "
                 "points.")  # fmt: skip
    return Table(
        title="Scatter", rows=tuple(rows), note=lost.strip(),
        header=("", "mean", "standard deviation", "2.5 %", "50 %", "97.5 %"),
    )  # fmt: skip


def sensitivity(about: Indices) -> Iterator[Table]:
    rows: list[tuple[str, ...]] = []
    for what, scatter, _ in quantities(about):
        rows += [
            (what, one.tolerance.symbol, _estimate(one.first), _estimate(one.total))
            for one in scatter.ranked
        ]
        if scatter.why:
            rows.append((what, "–", scatter.why, "–"))
    yield Table(
        title="Sensitivity to the inputs", rows=tuple(rows),
        header=("", "input", "first order, with interval", "total, with interval"),
        note="First order: share of the variance that the input causes alone. Total: share "
             "including all "
        "interactions with other inputs. Intervals have a probability of 95 % (by resampling).",
    )  # fmt: skip


def _estimate(one: Estimate) -> str:
    return f"{one.value:.2f} ({one.low:.2f} to {one.high:.2f})"


def points(found: Outcome, order: Sequence[Course]) -> Table:
    """Table of the first points: varied inputs, status, errors of the rows with large errors."""
    plan, listed = found.solved.plan, order[:MOST_COLUMNS]
    varied: Sequence[Axis | Tolerance] = plan.axes or plan.tolerances
    single = listed[0] if len(found.courses) == 1 else None
    heads = [with_unit(v.symbol, v.unit) for v in varied]
    if single:
        heads += [with_unit(x, single.pair.unit) for x in ("formula", single.pair.by or "FE")]
    heads += ["error" if single else f"error of {c.pair.name}" for c in listed]
    rows = []
    why = reasons(found)
    for n, (row, status) in enumerate(zip(plan.points, statuses(found), strict=True)):
        if n == MOST_LINES:
            break
        cells = [f"{v.in_unit(x):.6g}" for v, x in zip(varied, row, strict=True)]
        if single:
            factor = units.factor(single.pair.unit)
            cells += [_number(v[n] / factor) for v in (single.formula, single.fe)]
        cells += [error_with_bar(c, n) if np.isfinite(c.error[n]) else "–" for c in listed]
        rows.append((*cells, status + f": {why[n]}" * bool(why[n])))
    many = (
        f"The first {len(rows)} of {len(plan.points):,} points are listed. "
        if len(plan.points) > len(rows)
        else ""
    )
    most = len(listed)
    some = (
        (f"Errors are listed for the {most} formulas with the largest errors. ")
        if len(order) > most
        else ""
    )
    return Table(
        title="Points", header=(*heads, "state"), rows=tuple(rows),
        note=f"{many}{some}All points with all values are in points.csv.",
    )  # fmt: skip


def _number(value: float) -> str:
    return f"{value:.6g}" if np.isfinite(value) else "–"
