"""Contents of the papers as records for the report, with the related rows of the cases."""

from collections.abc import Mapping, Sequence
from typing import Any

from verify.core.results import CaseResult
from verify.papers.ledger import papers
from verify.papers.paper_tables import claiming_rows, paper_tables


def ledgers(results: Sequence[CaseResult], inputs: Mapping[str, Sequence[str]]) -> dict[str, Any]:
    """Records of the papers and their tables for `verify.core.results.Report`.

    `inputs` lists the inputs of the cases that equal a printed value, by "paper:id".
    """
    used = claimed(results, inputs)
    return {
        "papers": (*(_paper(p, used) for p in papers()), *_other_sources(results)),
        "equations": tuple(
            {"paper": p.key, **e.model_dump()} for p in papers() for e in p.equations
        ),
        "errata": tuple({"paper": p.key, **e.model_dump()} for p in papers() for e in p.errata),
        "published": tuple(
            {"paper": p.key, "claimed": used.get(f"{p.key}:{v.id}", []), **v.model_dump()}
            for p in papers()
            for v in p.values
        ),
        "tables": paper_tables(results, inputs),
    }


def sources(results: Sequence[CaseResult]) -> dict[str, Any]:
    """Sources for a report that contains only cases outside the suite; its tables are empty."""
    found = tuple(_other_sources(results))
    return {"papers": found} | dict.fromkeys(("equations", "errata", "published", "tables"), ())


def _other_sources(results: Sequence[CaseResult]) -> list[dict[str, Any]]:
    """Books and papers of cases outside the suite, for which there is no file of contents."""
    keys = {paper.key for paper in papers()}
    none = ("values", "claimed", "equations", "errata", "implemented", "argued", "missing")
    return [
        {"key": source, "authors": source, "title": "", "source": "", "year": None, "doi": ""}
        | dict.fromkeys(none, 0)
        for source in dict.fromkeys(result.paper for result in results) if source not in keys
    ]  # fmt: skip


def claimed(
    results: Sequence[CaseResult], inputs: Mapping[str, Sequence[str]]
) -> Mapping[str, list[str]]:
    """Printed values in use ("paper:id": inputs and judged rows that use the value)."""
    used = {reference: list(names) for reference, names in inputs.items()}
    for reference, rows in claiming_rows(results).items():
        used.setdefault(reference, []).extend(row.id for row in rows)
    return used


def _paper(paper: Any, used: Mapping[str, list[str]]) -> dict[str, Any]:
    count = {
        s: sum(e.status == s for e in paper.equations) for s in ("implemented", "argued", "missing")
    }
    return {
        "key": paper.key, "authors": paper.authors, "title": paper.title, "source": paper.source,
        "year": paper.year, "doi": paper.doi, "values": len(paper.values),
        "claimed": sum(f"{paper.key}:{v.id}" in used for v in paper.values),
        "equations": len(paper.equations), "errata": len(paper.errata), **count,
    }  # fmt: skip
