"""A verdict as one sentence."""

from verify.core.verdicts import FormulaVerdict, Safe, Verdict

SIDE = {Safe.ABOVE: "a higher value is safe", Safe.BELOW: "a lower value is safe",
        Safe.NEITHER: "neither side is safe"}  # fmt: skip
SMALLEST = 1e-4  # relative: what is shown of an error or of its bar
SHARED = (
    "compared with a model that makes the same simplifications: the error against the real part is "
    "not known"
)


def sentence(found: FormulaVerdict) -> str:
    """What an engineer needs first: the accuracy or the error, where, and on which side."""
    has_better = found.is_of_part or found.error is None or found.verdict is Verdict.EXACT
    return _head(found) if has_better else f"{_head(found)}; {SHARED}"


def _head(found: FormulaVerdict) -> str:
    match found.verdict:
        case Verdict.EXACT:
            largest = percent(max(found.above or 0.0, found.below or 0.0))
            return f"exact in its own idealisation; difference found: {largest}"
        case Verdict.ACCURATE:
            return f"accurate within {percent(found.within)} over {_studied(found)}"
        case Verdict.PART:
            return f"{_part(found)}; {_error(found)}"
        case Verdict.WRONG if found.error is None:
            return "wrong as printed; the size of the error was not computed"
        case Verdict.WRONG:
            return f"wrong as printed; {_error(found)}"
        case _:
            return f"{found.verdict.value}: {_sides(found)}; {_error(found)}; {SIDE[found.safe]}"


def percent(value: float | None) -> str:
    """A relative number in per cent with two digits: "0.42 %", "under 0.01 %", "290 %"."""
    if value is None:
        return "–"
    if abs(value) < SMALLEST:
        return "under 0.01 %"
    return f"{100 * value:.0f} %" if abs(value) >= 1 else f"{100 * value:.2g} %"


def _studied(found: FormulaVerdict) -> str:
    return "; ".join(dict.fromkeys(one.over for one in found.ranges))


def _error(found: FormulaVerdict) -> str:
    if found.error is None or found.U is None:
        return "no error is known"
    sign = "+" if found.error > 0 else "−"
    size = percent(abs(found.error))
    shown = size if abs(found.error) < SMALLEST else f"{sign}{size}"
    bar = f" ± {percent(found.U)}" if found.U >= SMALLEST else ""
    return f"{shown}{bar} at the case's own inputs"


def _sides(found: FormulaVerdict) -> str:
    """The largest errors, that of the larger side first."""
    sides = [(found.above or 0.0, "above"), (found.below or 0.0, "below")]
    told = [
        f"up to {percent(size)} {side}"
        for size, side in sorted(sides, reverse=True) if size >= SMALLEST
    ]  # fmt: skip
    return " and ".join(told)


def _part(found: FormulaVerdict) -> str:
    if not found.points:
        limit = percent(found.within)
        return f"accurate within {limit} at the case's own inputs, the only ones compared"
    best = next((one for one in reversed(found.ranges) if one.inside), None)
    if best is None:
        return "accurate at the case's own inputs alone"
    return f"accurate within {percent(best.limit)} in {best.case} for {best.words}"
