"""Digests of the inputs of each part of a report.

A part with an unchanged digest is not made again. Date, commit and duration of a run are not part
of the digest: a file that is not made again states those of an earlier run. The first page, the
provenance and `results.json` always state those of the last run.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from importlib.metadata import version
from typing import Any

from reports import explorer
from reports.html import anchors
from reports.links import FOLDER, OTHERS, path_of
from reports.picture_cache import LIBRARIES as DRAWING
from reports.picture_cache import opengl
from verify.core.results import Report

LIBRARIES = (*DRAWING, "jinja2", "latex2mathml", "markupsafe", "meshio", "typst", "xlsxwriter")
PAPER, BOOK = "PDF", "workbook"  # names of parts


@dataclass(frozen=True)
class Origins:
    """Digests of the code of reports, and of all data on which each case of the suite depends."""

    code: str
    cases: Mapping[str, str]


def page_of(case: str) -> str:
    """Name of the part that is the page of a case."""
    return f"page {case}"


def fields_of(case: str) -> str:
    """Name of the part that contains the files of a case for ParaView."""
    return f"fields {case}"


def section(name: str) -> str:
    """Name of the part that is the page of a section."""
    return f"section {name}"


def part_of(path: str) -> str:
    """Name of the part to which a page belongs."""
    name = path.removeprefix(f"{FOLDER}/").removesuffix(".html")
    return section(name) if path_of(name) == path and name in OTHERS.values() else page_of(name)


def digests(report: Report, origins: Origins | None, form: str) -> dict[str, str]:
    """Digest of each part; empty without origins, or if a case has no origin."""
    if origins is None or any(case.id not in origins.cases for case in report.cases):
        return {}
    libraries = [f"{name} {version(name)}" for name in LIBRARIES]
    common = [origins.code, form, opengl(), *libraries]
    return {part: _digest([common, made_of]) for part, made_of in _parts(report, origins)}


def _digest(value: Any) -> str:
    return sha256(repr(value).encode()).hexdigest()


def _parts(report: Report, origins: Origins) -> Iterator[tuple[str, Any]]:
    """Inputs of each part in addition to the code of reports."""
    cases = [(case.id, origins.cases[case.id]) for case in report.cases]
    places, rows = anchors(report.rows), _digest(report.rows)
    explored = explorer.places(report, places)
    ledgers = [report.papers, report.errata, report.searches, report.verdicts]
    frame = [
        report.papers,
        bool(report.caught and not report.caught.missing),
        bool(report.drift),
        bool(report.studies),
        bool(report.crosschecks),
    ]
    for i, (case, key) in enumerate(cases):
        yield fields_of(case), key
        own = [
            [one for one in kind if one.case == case] for kind in (report.validity, report.budgets)
        ]
        verdicts = [v for v in report.verdicts if case in v.cases]
        linked = [
            (places.get(row), explored.get(row))
            for v in verdicts
            for row in (*v.rows, *v.model_rows)
        ]
        checks = [(k, c) for k, c in enumerate(report.crosschecks) if c.case == case]
        near = [name for name, _ in cases[max(i - 1, 0) : i + 2]]
        linked += [(name, at) for name, at in explored.items() if name.partition("/")[0] == case]
        yield page_of(case), [i, near, key, own, verdicts, linked, checks, frame]
    tables = [report.tables, report.equations, report.published, report.errata, report.papers]
    yield section("explorer"), [report.studies, report.validity, report.verdicts, places, frame]
    yield section("rows"), [rows, [(c.id, c.title) for c in report.cases], frame]
    yield section("papers"), [tables, places, frame]
    yield section("errata"), [ledgers, frame]
    yield section("solvers"), [report.crosschecks, places, frame]
    yield section("faults"), [report.caught, frame]
    yield section("since"), [report.drift, places, frame]
    shown = [(c.id, c.title, c.inputs, c.values, c.tables) for c in report.cases]
    yield BOOK, [rows, shown, tables, report.verdicts, report.crosschecks]
    records = [report.validity, report.budgets, report.drift, report.caught]
    yield PAPER, [cases, tables, ledgers, records, report.verdicts, report.crosschecks]
