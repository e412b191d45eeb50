"""Content of the first page for each paper and each design task."""

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from reports.advice import advised
from reports.in_short import named
from verify.core.results import CaseResult, PaperTable, Report
from verify.core.verdicts import FormulaVerdict, Verdict

MOST_NAMED = 2  # quantities of a line
FILE = Path(__file__).parent / "first_page.toml"


@dataclass(frozen=True)
class PaperPart:
    """A paper with its claims, verdicts, tables with numbers, errata and cases."""

    key: str
    cited: str
    title: str
    part: str
    claim: str
    place: str
    verdicts: Sequence[FormulaVerdict]
    tables: Sequence[PaperTable]
    errata: Sequence[Mapping[str, Any]]
    cases: Sequence[CaseResult]


@dataclass(frozen=True)
class Group:
    """Printed or corrected formulas with one verdict, error and evidence: one line of a table."""

    formulas: Sequence[FormulaVerdict]

    @property
    def first(self) -> FormulaVerdict:
        """Formula whose verdict and evidence are printed in the line."""
        return self.formulas[0]

    @property
    def name(self) -> str:
        """Names of the equations, such as "Eqs. 1, 2, 4"."""
        numbers = [v.name.removeprefix("Eq. ") for v in self.formulas]
        if len(numbers) == 1:
            return self.first.name
        return f"Eqs. {', '.join(numbers)}"

    @property
    def what(self) -> str:
        """Quantities that the equations give; only the first MOST_NAMED are listed."""
        each = list(dict.fromkeys(v.what for v in self.formulas))
        more = len(each) - MOST_NAMED
        return "; ".join(each[:MOST_NAMED]) + (f"; and {more} more" if more > 0 else "")


def groups(verdicts: Sequence[FormulaVerdict]) -> list[Group]:
    """Groups of formulas with the same verdict and evidence; definitions are omitted."""
    found: dict[tuple[object, ...], list[FormulaVerdict]] = {}
    for v in verdicts:
        if v.verdict is Verdict.DEFINITION:
            continue
        same = v.form, v.verdict, v.words, v.error, v.instead, v.rows, v.model_rows
        is_equation = v.name.startswith("Eq. ") and (v.rows or v.model_rows)
        found.setdefault(same if is_equation else (v.id,), []).append(v)
    return [Group(one) for one in found.values()]


@dataclass(frozen=True)
class Task:
    """A question of a designer, with the formulas that answer it, the command, and examples."""

    what: str
    formulas: Sequence[FormulaVerdict]
    tool: str
    cases: Sequence[str]  # cases of this run whose pages answer the question for the paper's inputs


@cache
def stated() -> Mapping[str, Any]:
    """Content of the file of claims and tasks."""
    return tomllib.loads(FILE.read_text("utf-8"))


def paper_parts(report: Report) -> list[PaperPart]:
    """Papers of a run, in the order of their ledgers."""
    about, short = {one["key"]: one for one in stated()["papers"]}, named(report.papers)
    return [
        _part(report, about[paper["key"]], paper, short[paper["key"]])
        for paper in report.papers if paper["key"] in about
    ]  # fmt: skip


def _part(
    report: Report, one: Mapping[str, str], paper: Mapping[str, Any], cited: str
) -> PaperPart:
    key = one["key"]
    verdicts = [v for v in advised(report.verdicts) if v.paper == key]
    changed = {e for v in verdicts for e in v.errata}
    return PaperPart(
        key=key, cited=cited, title=paper["title"], part=one["part"], claim=one["claim"],
        place=one["place"], verdicts=verdicts,
        tables=[t for t in report.tables if t.paper == key and compared(t)],
        errata=[e for e in report.errata if e["paper"] == key and e["id"] in changed],
        cases=[c for c in report.cases if c.paper == key],
    )  # fmt: skip


def compared(table: PaperTable) -> bool:
    """Whether rows of the suite are compared with numbers of the table."""
    return any(cell.rows for cells in table.rows for cell in cells)


def tasks(report: Report) -> Mapping[str, list[Task]]:
    """Tasks by machine part (such as "roller clutch"), with the verdicts of their formulas."""
    known = {v.id: v for v in advised(report.verdicts)}
    present = {case.id for case in report.cases}
    found: dict[str, list[Task]] = {}
    for one in stated()["tasks"]:
        formulas = [known[name] for name in one["formulas"] if name in known]
        cases = [name for name in one["cases"] if name in present]
        found.setdefault(one["part"], []).append(Task(one["what"], formulas, one["tool"], cases))
    return found
