"""The page of a solved sweep."""

import re
import time
from collections import Counter
from collections.abc import Iterator, Sequence

from reports.design import Tile
from reports.sweep import Formula, Panels, Picture, SweepPage
from verify.app.sweep import figures
from verify.app.sweep.page_tables import (
    About,
    moments,
    overview,
    points,
    regions_table,
    sensitivity,
)
from verify.app.sweep.verdicts import grid_in_words, sample_in_words, unit_after
from verify.core.figures import Table
from verify.core.results import Kind
from verify.studies.sweep.axes import Axis, Tolerance
from verify.studies.sweep.console_table import worst
from verify.studies.sweep.indices import Indices, indices
from verify.studies.sweep.outcome import Course, Outcome
from verify.studies.sweep.pairs import LEVELS
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.point import code_of
from verify.studies.sweep.region import regions
from verify.studies.sweep.run import versions
from verify.studies.sweep.tables import FAILED, REFUSED, SOLVED, largest, reasons, statuses
from verify.verdicts.of_sweep import verdict_in_words

MOST_REASONS = 6
MOST_DRAWN, ROOM = 20, 40_000  # rows with pictures, and points in all of them: a page has its size
_NUMBER = re.compile(r"\d[\d.,]*(?:e[-+]?\d+)?")
KINDS = {
    Kind.IDENTITY: "an exact solution of the same model",
    Kind.APPROXIMATION: "an approximation: its error is measured",
}


def page(found: Outcome, command: str) -> SweepPage:
    """All content of the page; `command` repeats the sweep."""
    plan = found.solved.plan
    order = worst(found)
    room = max(1, min(MOST_DRAWN, ROOM // max(len(plan.points), 1)))
    results = [(c, *_result(plan, c)) for c in order]
    return SweepPage(
        name=plan.name,
        kicker=f"Sweep of {plan.case.id}",
        meta=f"{plan.case.title} · " + time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime()),
        tiles=_tiles(found),
        problems=list(_problems(found)),
        lead=_lead(plan),
        overview=overview(plan, results, room),
        formulas=[
            _formula(plan, course, about, verdict, number=k, drawn=k <= room)
            for k, (course, about, verdict) in enumerate(results, start=1)
        ],
        points=points(found, order),
        varied=[(v.symbol, v.what, _spread(v)) for v in plan.axes or plan.tolerances],
        inputs=_held(plan),
        facts=list(_facts(found)),
        command=command,
        files=_files(plan),
    )


def _result(plan: Plan, course: Course) -> tuple[About, str]:
    """Regions (grid) or sensitivity indices (sample) of a row, and their summary in words."""
    if plan.base:
        about = indices(plan, course)
        return about, sample_in_words(about)
    found = regions(plan, course)
    verdict = verdict_in_words(plan, course)
    summary = grid_in_words(plan, course, found)
    return found, f"Verdict over this sweep: {verdict}. {summary}" if verdict else summary


def _tiles(found: Outcome) -> Sequence[Tile]:
    counts = Counter(statuses(found))
    tiles = [Tile(number=f"{len(found.problems):,}", words="points"),
             Tile(number=f"{counts[SOLVED]:,}", words="solved")]  # fmt: skip
    if n := counts[REFUSED]:
        tiles.append(
            Tile(number=f"{n:,}", words="rejected: inputs outside their range", css="is-note")
        )
    if n := counts[FAILED]:
        tiles.append(Tile(number=f"{n:,}", words="failed", css="is-fail"))
    return [
        *tiles,
        Tile(
            number=str(len(found.courses)),
            words=f"formula{'s' * (len(found.courses) > 1)} compared",
        ),
    ]


def _problems(found: Outcome) -> Iterator[str]:
    """Reasons for points without a result, the most frequent reason first."""
    groups: dict[str, list[str]] = {}
    for reason in filter(None, reasons(found)):  # reasons that differ in numbers are one
        groups.setdefault(_NUMBER.sub("#", reason), []).append(reason.removeprefix("inputs: "))
    every = sorted(groups.values(), key=len, reverse=True)
    for some in every[:MOST_REASONS]:
        such = ", such as" * (len(set(some)) > 1)
        yield f"{len(some):,} point{'s' * (len(some) > 1)}{such}: {some[0]}"
    if more := every[MOST_REASONS:]:
        yield f"{sum(map(len, more)):,} more points for {len(more)} other reasons, see points.csv"


def _lead(plan: Plan) -> str:
    kind = (
        f"A Sobol sample of {plan.base:,} base points within the tolerances"
        if plan.base
        else "One input at a time; the other inputs have the values of the file"
        if plan.star
        else "All combinations"
    )
    return (
        f"{kind}. An error is formula minus finite elements, in per cent of the finite-element "
        "value or of the reference value stated below a formula. A point is within a limit "
        "if its whole error bar (95 %) is within the limit, and undecided if the bar crosses "
        "the limit."
    )


def _formula(
    plan: Plan, course: Course, about: About, verdict: str, *, number: int, drawn: bool
) -> Formula:
    pair = course.pair
    tables: Sequence[Table]
    shown: Sequence[Picture] = ()
    more: Sequence[Panels] = ()
    some = drawn and largest(course) is not None
    if isinstance(about, Indices):
        tables = [moments(about), *sensitivity(about)]
        shown = figures.of_sample(plan, course, about) if some else ()
    else:
        tables = [regions_table(plan, about)]
        shown = figures.of_grid(plan, course, about) if some else ()
        more = figures.panels(plan, course) if some else ()
    of = f"the case's reference value “{pair.scale}”" if pair.scale else (
        f"the value by {pair.by or 'finite elements'}"
    )  # fmt: skip
    return Formula(
        anchor=f"row-{number}", name=pair.name,
        symbol=pair.symbol, kind=KINDS[pair.kind], verdict=verdict, tables=tables, figures=shown,
        panels=more, note=f"Errors are in per cent of {of}.", opened=number == 1,
    )  # fmt: skip


def _spread(v: Axis | Tolerance) -> str:
    if isinstance(v, Tolerance):
        return f"{v.in_unit(v.nominal):.6g} ± {v.in_unit(v.off):.4g}{unit_after(v.unit)}"
    ends = f"{v.in_unit(v.values[0]):.4g} to {v.in_unit(v.values[-1]):.4g}{unit_after(v.unit)}"
    inside = ""
    if v.nominal is not None:
        inside = f"; in the file {v.in_unit(v.nominal):.4g}{unit_after(v.unit)}"
    if v.nominal is not None and not v.values[0] <= v.nominal <= v.values[-1]:
        inside += ", outside"
    ratios = " in equal ratios" * (v.spacing == "log")
    return f"{ends}, {len(v.values)} values{ratios}{inside}"


def _held(plan: Plan) -> Sequence[tuple[str, str, str]]:
    return [
        (v.symbol, v.what, v.value if isinstance(v.value, str)
         else f"{v.value:.6g}{unit_after(v.unit)}")
        for v in plan.inputs.display() if v.name not in plan.names
    ]  # fmt: skip


def _facts(found: Outcome) -> Iterator[tuple[str, str]]:
    solved = found.solved
    part, timing = solved.part, solved.timing
    levels = ", ".join(str(level) for level in part.levels[:LEVELS])
    yield "finite elements", f"{part.name or 'all of the case'}, levels {levels}"
    yield "error bar", "expanded uncertainty (95 %) of the finite elements, from the three levels"
    yield "solved now", f"{timing.points:,} points; {timing.known:,} were stored already"
    if timing.points:
        yield (
            "time",
            (
                f"{timing.wall:.3g} s with {timing.workers} process{'es' * (timing.workers > 1)}, "
                f"{timing.busy / timing.points:.3g} s a point"
            ),
        )
        yield "share of the time not spent solving", f"{100 * max(timing.overhead, 0):.2g} %"
    formulas, fe = code_of(solved.plan.case, part)
    yield "code of the formulas", formulas[:12]
    yield "code of the finite elements", fe[:12]
    yield "libraries", versions(part)


def _files(plan: Plan) -> Sequence[tuple[str, str]]:
    table = (
        ("sensitivity.csv", "scatter of the results, and Sobol indices")
        if plan.base
        else ("validity.csv", "regions within each limit, and the inputs that bound them")
    )
    return [("points.csv", "every point with all values"), table,
            ("sweep.json", "everything, for programs")]  # fmt: skip
