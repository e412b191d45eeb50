"""The published data as plain records for the report, with what the cases claim of them."""

from collections.abc import Mapping, Sequence
from typing import Any

from verify.case import Case
from verify.inputs import meta
from verify.published.ledger import papers
from verify.results import CaseResult


def ledgers(results: Sequence[CaseResult], cases: Sequence[Case]) -> dict[str, Any]:
    """Records of `papers`, `equations`, `errata` and `published` for `verify.results.Report`."""
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
    }


def claimed(results: Sequence[CaseResult], cases: Sequence[Case]) -> Mapping[str, list[str]]:
    """Published values in use ("paper:id") and by what: inputs of cases and judged rows."""
    used: dict[str, list[str]] = {}
    for case in cases:
        for name, field in case.inputs.model_fields.items():
            if reference := meta(field)["claims"]:
                used.setdefault(reference, []).append(f"{case.id} input {name}")
    for result in results:
        for row in result.rows:
            for entry in row.published:
                used.setdefault(f"{entry.document}:{entry.id}", []).append(row.id)
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
