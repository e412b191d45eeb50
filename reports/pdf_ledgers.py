"""Tables of the papers, errata, equations and printed numbers, for the PDF."""

from collections.abc import Mapping, Sequence
from typing import Any

from reports.erratum_names import erratum_name
from reports.html import cited, partly
from reports.paper_rows import printed_row
from reports.pdf_case import maths
from reports.pdf_tables import Data, prose
from reports.richtext import runs
from verify.core.results import PaperCell, PaperTable, Report

STATES = {
    "implemented": "implemented, with a check that fails if the implementation is wrong",
    "argued": "omitted, with a stated reason",
    "missing": "not implemented yet",
}


def ledgers(report: Report, places: Mapping[str, str]) -> Data:
    named = {p["key"]: cited(p) for p in report.papers}
    erratum = {(e["paper"], e["id"]): f"erratum-{i}" for i, e in enumerate(report.errata)}
    return {
        "tables": [paper_table(t, named[t.paper], places, erratum) for t in report.tables],
        "partly": partly(report),
        "errata": len(report.errata),
        "tested": sum(bool(e["test"]) for e in report.errata),
        "papers": [
            {
                "cited": named[p["key"]],
                "title": p["title"],
                "counts": {k: p[k] for k in ("equations", "values", "claimed", *STATES)},
                "errata": [erratum_data(e, erratum) for e in _of(report.errata, p)],
                "equations": [_equation(e) for e in _of(report.equations, p)],
                "numbers": [_number(v) for v in _of(report.published, p) if v["claimed"]],
            }
            for p in report.papers
        ],
        "states": [[k, words, sum(p[k] for p in report.papers)] for k, words in STATES.items()],
    }


def _of(entries: Sequence[Mapping[str, Any]], paper: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    return [entry for entry in entries if entry["paper"] == paper["key"]]


def paper_table(
    table: PaperTable,
    paper: str,
    places: Mapping[str, str],
    erratum: Mapping[tuple[str, str], str],
    *,
    shortened: bool = False,
) -> Data:
    def linked(names: Sequence[str]) -> list[Data]:
        known = ((name, erratum.get((table.paper, name))) for name in names)
        return [
            {"name": prose(erratum_name(name)), "label": label} for name, label in known if label
        ]

    def row(cells: Sequence[PaperCell]) -> Data:
        found = printed_row(cells)
        return {
            "printed": [prose(cell.text) for cell in cells],
            "claims": [
                {"label": places.get(c.row), "name": prose(c.name), "status": c.status.value,
                 "formulas": [runs(c.beside(cell) if k in c.columns else "")
                              for k, cell in enumerate(cells)],
                 "fem": runs(c.fem)}
                for c in (found.first if shortened else found.claims)
            ],
            "more": len(found.further) if shortened else 0,
            "inputs": [{"column": i.column, "words": prose(i.words)} for i in found.inputs],
            "errata": linked(found.errata),
        }  # fmt: skip

    return {
        "name": f"{paper}, {table.name}",
        "caption": prose(table.caption),
        "header": [prose(x) for x in table.header],
        "rows": [row(cells) for cells in table.rows],
        "note": prose(table.note),
        "errata": linked(table.errata),
    }


def erratum_data(e: Mapping[str, Any], erratum: Mapping[tuple[str, str], str]) -> Data:
    return {
        "label": erratum[e["paper"], e["id"]],
        "id": e["id"],
        "name": prose(erratum_name(e["id"])),
        "place": e["place"],
        "printed": maths(e["printed_tex"]) or prose(e["printed"]),
        "right": maths(e["right_tex"]) or prose(e["right"]),
        "evidence": prose(e["evidence"]),
        "test": e["test"],
    }


def _equation(e: Mapping[str, Any]) -> Data:
    return {
        "number": e["number"],
        "what": prose(e["what"]),
        "tex": maths(e["tex"]),
        "status": e["status"],
        "code": e["code"],
        "test": e["test"],
        "note": prose(e["note"]),
    }


def _number(v: Mapping[str, Any]) -> list[list[Any]]:
    unit = v["unit"] if v["unit"] != "1" else ""
    return [
        prose(v["what"]), prose(v["printed"]), prose(unit), runs(v["place"]),
        prose("; ".join(v["claimed"])),
    ]  # fmt: skip
