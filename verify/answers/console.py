"""First lines of `check` on the terminal: verdict, design value, margin, limiting criterion."""

from collections.abc import Sequence

from verify.answers.answer import Answer, Criterion, Quantity, Verdict
from verify.core import units
from verify.core.unit_systems import System, cells_in, text_in, unit_in

WHOLE = (1e4, 1e7)  # printed without decimals and without a power of ten
LARGE = 1000.0  # a margin beyond it is no information


def headline(name: str, answer: Answer, notes: Sequence[str], system: System = "mm") -> list[str]:
    """Lines with verdict, design value and margin.

    The `notes` follow the reasons of the verdict.
    """
    lines = [f"{name}: {answer.verdict}{_because(answer, system)}"]
    if answer.design is not None:
        lines.append(f"  design value: {_quantity(answer.design, system)}, {answer.design.what}")
    if (worst := answer.limiting) is not None and not answer.failures:
        lines.append(f"  margin: {margin(worst)}, limited by {_beside(worst, system)}")
    lines += [f"  {text}" for text in (*answer.reasons[1:], *answer.remarks)]
    return [text_in(line, system) for line in (*lines, *(f"  {note}" for note in notes))]


def limits(answer: Answer, system: System = "mm") -> list[tuple[str, ...]]:
    """Cells of every criterion: state, quantity, value, limit, margin, source."""
    found = [
        (_state(c), c.what, number(c.value, c.unit, system),
         f"{'≥' if c.minimum else '≤'} {number(c.limit, c.unit, system)}", f"margin {margin(c)}",
         ("assumed: " if c.assumed else "") + c.source + (f"; {c.doubt}" if c.doubt else ""))
        for c in answer.criteria
    ]  # fmt: skip
    return cells_in(found, system)


def _state(criterion: Criterion) -> str:
    if not criterion.is_met:
        return "NOT MET"
    return "undecided" if criterion.doubt else "ok"


def number(value: float, unit: str, system: System = "mm") -> str:
    """Text of a value [SI] in the display `unit`, converted to `system`, with four digits."""
    unit = unit_in(unit, system)
    size = value / units.factor(unit)
    text = f"{size:.0f}" if WHOLE[0] <= abs(size) < WHOLE[1] else f"{size:.4g}"
    return text if unit == "1" else f"{text} {unit}"


def margin(criterion: Criterion) -> str:
    """Text of a margin with three digits."""
    if criterion.margin >= LARGE:
        return f"above {LARGE:g}"
    return f"{criterion.margin:#.3g}".rstrip(".")


def _because(answer: Answer, system: System) -> str:
    if answer.verdict is Verdict.FAILS and not answer.failures:
        return f": {_beside(answer.limiting, system)}" if answer.limiting else ""
    return f": {answer.reasons[0]}" if answer.reasons else ""


def _quantity(quantity: Quantity, system: System) -> str:
    return f"{quantity.symbol} = {number(quantity.value, quantity.unit, system)}"


def _beside(criterion: Criterion, system: System) -> str:
    relation = "minimum" if criterion.minimum else "limit"
    return (
        f"{criterion.what}: {number(criterion.value, criterion.unit, system)}, {relation} "
        f"{number(criterion.limit, criterion.unit, system)}"
        f"{' (assumed)' if criterion.assumed else ''}"
    )
