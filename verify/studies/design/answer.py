"""The answer of `freewheel design` for a spring: chosen spring, margin, limiting criterion."""

from verify.answers.answer import Answer, Criterion, Quantity
from verify.studies.design.console import geometry, verdict
from verify.studies.design.limits import Limit
from verify.studies.design.outcome import Outcome

NOTHING = "no candidate meets all limits"


def answer(outcome: Outcome) -> Answer:
    """Answer of a design task: "holds" if a spring was chosen and finite elements confirm it."""
    if outcome.chosen is None:
        return Answer(design=None, failures=(NOTHING,))
    i, s = outcome.candidate, outcome.search
    stiffness = Quantity(key="k1", symbol="k_1", value=float(s.formulas.k1[i]), unit="N/mm",
                         what=f"stiffness of {geometry(s, i)}")  # fmt: skip
    criteria = tuple(_criterion(limit, i) for limit in s.judged.limits)
    return Answer(design=stiffness, criteria=criteria, failures=_rejected(outcome),
                  unknowns=_unconfirmed(outcome))  # fmt: skip


def _criterion(limit: Limit, i: int) -> Criterion:
    return Criterion(
        key=limit.key, what=limit.what, value=float(limit.value[i]) - limit.offset,
        limit=limit.bound - limit.offset, unit=limit.unit, source=limit.source,
        minimum=limit.least,
    )  # fmt: skip


def _rejected(outcome: Outcome) -> tuple[str, ...]:
    if not outcome.verified or outcome.verified[outcome.chosen or 0].fits:
        return ()
    chosen = outcome.verified[outcome.chosen or 0]
    return (f"finite elements reject the chosen spring: {verdict(chosen)}",)


def _unconfirmed(outcome: Outcome) -> tuple[str, ...]:
    if all(v.agrees for v in outcome.verified):
        return ()
    return ("finite elements do not confirm the formula of every member of the front",)
