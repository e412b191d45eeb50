"""Environment of the page templates, with their filters."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import jinja2
from markupsafe import Markup

from reports import (
    budget,
    caught,
    crosscheck,
    explorer_tables,
    formats,
    readings,
    second,
    signature,
    since,
    validity,
)
from reports.advice import CORRECTED
from reports.compiled import COMPILED
from reports.convergence import convergence, on_meshes
from reports.equations import Equations
from reports.erratum_names import erratum_name
from reports.figures import plot
from reports.first_page import groups
from reports.in_short import where
from reports.paper_rows import printed_table, used_as_inputs
from reports.row_lines import failed_first
from reports.sketch import sketch
from reports.verdicts import (
    at_paper,
    errata_in_verdicts,
    may_be_used,
    not_to_be_used,
    short_words,
    sides,
    slug,
)
from verify.core.figures import LIMITS_TITLE, Table
from verify.core.results import CaseResult, Row, Status

HERE = Path(__file__).parent / "templates"
NAMED_IN_MENU = 3  # cases, at most, that the menu names one by one
LONG_LIST = 18  # inputs; longer lists have two columns


@dataclass(frozen=True)
class Cause:
    """Rows of one case that failed, or were not run, for the same reason."""

    reason: str
    rows: Sequence[Row]


def causes(rows: Sequence[Row], status: Status) -> list[Cause]:
    """Rows with this status, grouped by case and reason."""
    found: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        if row.status is status:
            found.setdefault((row.case, row.reason), []).append(row)
    return [Cause(reason, group) for (_, reason), group in found.items()]


def columns(table: Table) -> list[list[tuple[str, bool]]]:
    """Cells of a table as pairs: the text, and whether the cell is a number.

    All numbers of a column have the same number of decimals.
    """
    shown = []
    for column in zip(*table.rows, strict=True):
        numbers = [formats.number(x) for x in column if isinstance(x, float)]
        decimals = max((len(x.partition(".")[2]) for x in numbers if "e" not in x), default=0)
        shown.append([
            (f"{x:.{decimals}f}".replace("-", formats.MINUS), True)
            if isinstance(x, float) and "e" not in formats.number(x)
            else (formats.number(x), isinstance(x, int | float))
            for x in column
        ])  # fmt: skip
    return [list(row) for row in zip(*shown, strict=True)]


def environment(equations: Equations) -> jinja2.Environment:
    """Environment of the page templates; `equations` collects the formulas of the pages."""
    env = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE), autoescape=True, trim_blocks=True,
        lstrip_blocks=True, undefined=jinja2.StrictUndefined, bytecode_cache=COMPILED,
        optimized=False,  # constants are not filtered by the equations of another page
    )  # fmt: skip
    env.filters |= {
        "symbol": formats.symbol, "prose": formats.prose, "power": formats.power,
        "maths": equations.maths, "number": formats.number, "written": formats.written,
        "values": formats.values, "difference": formats.difference, "tolerance": formats.tolerance,
        "relative": formats.relative, "fraction": formats.fraction, "percents": formats.percents,
        "order": formats.order, "signature": signature.signature,
        "convergence": convergence, "on_meshes": on_meshes,
        "sketch": sketch, "plot": plot, "printed_table": printed_table,
        "used_as_inputs": used_as_inputs,
        "causes": causes, "failed_first": failed_first,
        "columns": columns,
        "validity_figure": validity.figure, "validity_limits": validity.limits,
        "share": caught.share, "moved": caught.moved, "green": caught.green,
        "only_listed": caught.only_listed, "survivors": caught.survivors,
        "in_words": caught.in_words, "interval": caught.interval, "stale": caught.stale,
        "signed": validity.signed, "validity_over": validity.common,
        "reading_found": readings.found, "chance": readings.chance,
        "drift_summary": since.summary, "drift_shown": since.shown, "drift_more": since.left_out,
        "drift_tighter": since.tighter, "drift_tighter_more": since.tighter_left_out,
        "waterfall": budget.waterfall, "percent": budget.percent,
        "budget_headline": budget.headline, "budget_lines": budget.lines,
        "budget_compact": budget.compact, "budget_identities": budget.identities,
        "budget_outside": budget.outside, "budget_left": budget.left,
        "cross_problems": crosscheck.problems, "cross_solvers": crosscheck.solvers,
        "cross_counts": crosscheck.counts_in_words,
        "cross_left": crosscheck.left_out, "second_value": second.value, "spaced": formats.spaced,
        "second_difference": second.difference, "second_meshes": second.meshes,
        "linked": formats.linked,
        "printed": printed, "counts": lambda case: present(case.rows), "anchor": _anchor,
        "reproduce": reproduce, "where": where, "at_paper": at_paper, "sides": sides,
        "short_words": short_words, "slug": slug, "not_to_be_used": not_to_be_used,
        "may_be_used": may_be_used,
        "grouped": groups, "erratum_name": erratum_name, "errata_in_verdicts": errata_in_verdicts,
        "study_head": explorer_tables.head, "study_lines": explorer_tables.lines,
    }  # fmt: skip
    env.globals |= {
        "LONG_LIST": LONG_LIST,
        "limits_title": LIMITS_TITLE,
        "NAMED_IN_MENU": NAMED_IN_MENU,
        "CORRECTED": CORRECTED,
        "CHANGED": caught.NAMES,
        "explored": {},  # places on the page of the explorer, which a run of one page has not
    }
    return env


def printed(row: Row, kind: str) -> Markup:
    """Printed values of one `kind` for a row, as text."""
    return formats.prose(", ".join(p.printed for p in row.published if p.kind == kind))


def _anchor(case: CaseResult) -> str:
    return f"case-{case.id}"


def reproduce(case: CaseResult) -> str:
    if case.name:
        return case.command
    init = case.command.replace("freewheel verify", "freewheel init", 1)
    return (
        f"{case.command}\n{init} > my.toml    # then edit it for your part\n"
        "freewheel check --fem my.toml"
    )


def present(rows: Sequence[Row]) -> list[tuple[Status, int]]:
    count = Counter(row.status for row in rows)
    return [(status, count[status]) for status in Status if count[status]]
