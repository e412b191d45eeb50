"""Equations of the theory pages, from the ledgers of the papers and the code of the cases.

Each equation is stated as printed, with its errata, its corrected form and its verdict.
The equations of a case are those that its formulas compute.
"""

import json
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from verify.cases.registry import find
from verify.papers.entries import Equation, Erratum
from verify.papers.ledger import Paper, papers
from verify.papers.numbers import numbers

ROOT = Path(__file__).parents[2]
PAGES = ROOT / "docs" / "theory" / "_generated"
CASES = {
    "rings": ("ring-lame", "ring-loads-outer", "ring-rotation"),
    "contact": (
        "contact-flat", "contact-pair", "contact-slip", "contact-sphere", "contact-press-fit",
        "contact-roller",
    ),
    "freewheel": ("freewheel-torque", "freewheel-cup", "freewheel-friction"),
    "sprag": ("sprag-wedge", "sprag-engagement", "sprag-friction", "sprag-crown"),
    "rotor": ("rotor-clutch", "rotor-shaft"),
    "spring": ("spring-accordion", "spring-stages", "spring-width", "spring-buckling"),
    "polyhedral": ("polyhedral-pressure", "polyhedral-locking", "polyhedral-clutch"),
}  # fmt: skip
API = ("analytic.", "fem.", "meshes.")


def setup(app: Any) -> dict[str, bool]:
    app.connect("builder-inited", write)
    return {"parallel_read_safe": True}


def write(_app: Any) -> None:
    """Write the files that the theory pages include."""
    PAGES.mkdir(parents=True, exist_ok=True)
    verdicts = json.loads((ROOT / "verify" / "measured" / "verdicts.json").read_text("utf-8"))
    of_equation = {entry["id"]: entry for entry in verdicts}
    for paper in papers():
        (PAGES / f"{paper.key}.txt").write_text("\n".join(_paper(paper, of_equation)), "utf-8")
    for subject, cases in CASES.items():
        text = "\n".join(line for case in cases for line in _case(case))
        (PAGES / f"{subject}-cases.txt").write_text(text, "utf-8")


def _paper(paper: Paper, verdicts: Mapping[str, Any]) -> Iterator[str]:
    about = {erratum.id: numbers(erratum.place) for erratum in paper.errata}
    for equation in paper.equations:
        entry = verdicts.get(f"{paper.key}/Eq. {equation.number}, printed")
        yield from _equation(equation, entry)
        for erratum in paper.errata:
            if equation.number in about[erratum.id]:
                yield from _erratum(erratum)
        if right := verdicts.get(f"{paper.key}/Eq. {equation.number}, corrected"):
            yield f"**Verdict of the corrected form:** {_verdict(right)}\n"
    others = [erratum for erratum in paper.errata if not about[erratum.id]]
    if others:
        yield "### Further errata\n"
        for erratum in others:
            yield f"- {_text(erratum.place)}: printed “{_text(erratum.printed)}”. "
            yield f"  Right: {_text(erratum.right)}."


def _equation(equation: Equation, verdict: Mapping[str, Any] | None) -> Iterator[str]:
    yield f"### Eq. {equation.number}: {_text(equation.what)}\n"
    yield _math(equation.tex)
    if verdict:
        yield f"**Verdict as printed:** {_verdict(verdict)}\n"
    if equation.note:
        yield f"{_text(equation.note)}.\n"
    if equation.code.startswith(API):
        yield f"Code: {{py:obj}}`{equation.code}`\n"


def _erratum(erratum: Erratum) -> Iterator[str]:
    yield f":::{{admonition}} Erratum: {_text(erratum.place)}\n:class: erratum\n"
    yield f"**Printed:** {_text(erratum.printed)}\n"
    yield f"**Right:** {_text(erratum.right)}\n"
    if erratum.right_tex:
        yield _math(erratum.right_tex)
    yield f"{_text(erratum.evidence)}\n"
    yield ":::\n"


def _case(name: str) -> Iterator[str]:
    case = find(name)
    inputs = case.inputs()
    yield f"### {case.title}\n"
    yield f"Case `{name}`. {_text(case.lead)}\n"
    for equation in case.equations(inputs, case.analytic(inputs)):
        yield _math(equation.tex)


def _verdict(entry: Mapping[str, Any]) -> str:
    words = _text(entry["words"])
    return words if words.startswith(entry["verdict"]) else f"{entry['verdict']}: {words}"


def _math(tex: str) -> str:
    return f"```{{math}}\n{tex}\n```\n"


def _text(words: str) -> str:
    """Plain text with the special characters of Markdown escaped."""
    return re.sub(r"([\\`*_{}\[\]<>$|#])", r"\\\1", words)
