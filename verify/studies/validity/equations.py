"""Equation of a paper for the formula of a row, in the notation of the case."""

import re
from collections.abc import Sequence

from verify.core.case import Case
from verify.core.figures import Equation
from verify.core.results import Kind
from verify.papers.ledger import cited, papers
from verify.papers.numbers import numbers
from verify.studies.sweep.pairs import Pair, pairs

_NUMBERS = re.compile(r"Eqs?\. ([\d, and-]*\d)")
_GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "eta": "η",
    "theta": "θ", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "rho": "ρ", "sigma": "σ",
    "tau": "τ", "varphi": "φ", "psi": "ψ", "omega": "ω", "Delta": "Δ", "Omega": "Ω",
}  # fmt: skip


def place(case: Case, pair: Pair) -> str:
    """The equation and paper of a row, by its name or the ledger; otherwise those of the case."""
    named = f"{case.id}/{pair.name}"
    known = [
        f"Eq. {equation.number}" for paper in papers() for equation in paper.equations
        if paper.key == case.paper and equation.test == named
    ]  # fmt: skip
    found = _NUMBERS.search(pair.name)
    where = ", ".join(known) or (found[0] if found else "")
    paper = cited(case.paper)
    return f"{where}, {paper}" if where else f"{paper}, {case.place}"


def tex(case: Case, pair: Pair, shown: Sequence[Equation]) -> str:
    """The formula of an approximation as the case writes it; empty if that is not certain.

    An equation is used if its left side is the symbol of the row. If several formulas have this
    symbol, it is that of the row with the same equation number of the paper.
    """
    if "printed" in pair.name:
        return ""
    symbol = _bare(pair.symbol)
    mine = [e for e in shown if "=" in e.tex and _left(e.tex) == symbol]
    rivals = {
        p.analytic for p in pairs(case)
        if p.kind is Kind.APPROXIMATION and _bare(p.symbol) == symbol
    }  # fmt: skip
    if len(rivals) > 1:
        asked = numbers(pair.name)
        mine = [e for e in mine if asked and asked & numbers(e.place)]
    return mine[0].tex if len(mine) == 1 else ""


def _left(text: str) -> str:
    r"""The left side of an equation as plain letters: \delta_{BE} is δ_BE."""
    left = text.partition("=")[0].strip()
    left = re.sub(r"\\([A-Za-z]+) ?", lambda m: _GREEK.get(m[1], f"\\{m[1]}"), left)
    return left.replace("{", "").replace("}", "").replace("\\", "")


def _bare(symbol: str) -> str:
    """A symbol without its arguments: α(T) is α."""
    return symbol.partition("(")[0].strip()
