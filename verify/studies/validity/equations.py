"""Place of a formula in its paper, and its equation in the notation of the case."""

import re
from collections.abc import Sequence

from verify.core.case import Case
from verify.core.figures import Equation
from verify.core.results import Kind
from verify.papers.ledger import cited, papers
from verify.papers.numbers import numbers
from verify.studies.sweep.pairs import Pair, pairs

_PLACE = re.compile(
    r"(?:(?P<paper>[^\W\d_]+ \d{4}), )?(?P<where>Eqs?\. \d+(?:(?:, | and | to |-|–)\d+)*)"
)
_GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "eta": "η",
    "theta": "θ", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "rho": "ρ", "sigma": "σ",
    "tau": "τ", "varphi": "φ", "psi": "ψ", "omega": "ω", "Delta": "Δ", "Omega": "Ω",
}  # fmt: skip


def place(case: Case, pair: Pair) -> str:
    """Text with the paper and the equation number of a row.

    The number is taken from the name of the row or, if the name has none, from the ledger. If the
    ledger has none, the place that the case states is returned. If the name of the row contains a
    paper, this paper is returned; otherwise, the paper of the case.
    """
    found = _PLACE.search(pair.name)
    source = (found["paper"] if found else "") or cited(case.paper)
    known = [
        str(equation.number) for paper in papers() for equation in paper.equations
        if paper.cited == source and equation.test == f"{case.id}/{pair.name}"
    ]  # fmt: skip
    listed = f"Eq{'s' * (len(known) > 1)}. {', '.join(known)}" if known else case.place
    return f"{source}, {found['where'] if found else listed}"


def tex(case: Case, pair: Pair, shown: Sequence[Equation]) -> str:
    """TeX code of the row's formula, from the equations `shown`; empty if none or several match.

    An equation belongs to the row if its left side is the symbol of the row. If several formulas
    have this symbol, the equation must also have the equation number of the row.
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
    r"""Left side of a TeX equation in plain letters: \delta_{BE} becomes δ_BE."""
    left = text.partition("=")[0].strip()
    left = re.sub(r"\\([A-Za-z]+) ?", lambda m: _GREEK.get(m[1], f"\\{m[1]}"), left)
    return left.replace("{", "").replace("}", "").replace("\\", "")


def _bare(symbol: str) -> str:
    """Symbol without its arguments: α(T) becomes α."""
    return symbol.partition("(")[0].strip()
