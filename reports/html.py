"""The report as one self-contained page: no network, no script."""

from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import jinja2
from markupsafe import Markup

from reports import drawing, formats
from verify.results import Report, Status

HERE = Path(__file__).parent / "templates"
WORDS = {
    Status.FAIL: "outside the tolerance, not sharp or not converged",
    Status.SKIP: "not run",
    Status.NOTE: "a printed value shown wrong, with its ledger entry",
    Status.CALIBRATED: "fitted: no evidence",
    Status.SHOWN: "compared; the reference has no stated uncertainty",
    Status.PASS: "within a tolerance that was derived",
}


def page(report: Report) -> str:
    """HTML of the whole run."""
    env = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE), autoescape=True, trim_blocks=True,
        lstrip_blocks=True, undefined=jinja2.StrictUndefined,
    )  # fmt: skip
    glyphs = formats.Glyphs()
    env.filters |= {
        "symbol": formats.symbol, "power": formats.power, "maths": glyphs.maths,
        "signature": drawing.signature, "convergence": drawing.convergence,
        "number": formats.number, "values": formats.values,
    }  # fmt: skip
    body = env.get_template("report.html.j2").render(
        report=report,
        statuses=tuple(Status),
        words=WORDS,
        counts=Counter(row.status for row in report.rows),
        relaxed=[row for row in report.rows if row.demand is not None and row.demand > 0.01],
        anchors={row.id: f"row-{i}" for i, row in enumerate(report.rows)},
        sketch=drawing.sketch,
        published_by_paper=_by_paper(report),
        css=Markup((HERE / "report.css").read_text("utf-8")),  # noqa: S704 - the project's own file
    )
    return body.replace("<!--glyphs-->", glyphs.symbols())


def _by_paper(report: Report) -> Mapping[str, list[Mapping[str, Any]]]:
    found: dict[str, list[Mapping[str, Any]]] = {p["key"]: [] for p in report.papers}
    for value in report.published:
        found[value["paper"]].append(value)
    return found
