"""The published data as plain records for the report, with what the cases claim of them."""

from collections.abc import Mapping, Sequence
from typing import Any

from verify.core.case import Case
from verify.core.results import CaseResult
from verify.papers.ledger import papers
from verify.papers.paper_tables import claiming_inputs, claiming_rows, paper_tables


def ledgers(results: Sequence[CaseResult], cases: Sequence[Case]) -> dict[str, Any]:
    """Records of the ledgers and the papers' tables for `verify.core.results.Report`."""
    used = claimed(results, cases)
    return {
        "papers": tuple(_paper(p, used) for p in papers()),
        "equations": tuple(
            {"paper": p.key, **e.model_dump()} for p in papers() for e in p.equations
        ),
        "errata": tuple({"paper": p.key, **e.model_dump()} for p in papers() for e in p.errata),
        "published": tuple(
            {"paper": p.key, "claimed": used.get(f"{p.key}:{v.id}", []), **v.model_dump()}
            for p in papers()
            for v in p.values
        ),
        "tables": paper_tables(results, cases),
    }


def claimed(results: Sequence[CaseResult], cases: Sequence[Case]) -> Mapping[str, list[str]]:
    """Published values in use ("paper:id") and by what: inputs of cases and judged rows."""
    used = claiming_inputs(cases)
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
