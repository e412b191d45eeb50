"""Text of a verdict in a few sentences."""

import re
from collections.abc import Sequence

from verify.core.verdicts import SHARED, FormulaVerdict, Safe, Side, Verdict, VerdictRange
from verify.studies.validity.messages import number
from verify.verdicts.rule import CLASSES

SIDE = {Safe.ABOVE: "values above the reference are safe",
        Safe.BELOW: "values below the reference are safe",
        Safe.NEITHER: "neither higher nor lower values are safe"}  # fmt: skip
ONLY = ", which are the only inputs compared"
VALUES = re.compile(r" \(\d+ values\)")  # numbers of points, which the ranges state
SMALLEST = 1e-4  # relative: below it an error or its bar is not printed


def sentences(found: FormulaVerdict) -> str:
    """Sentences with the accuracy or the error of a formula, its range, and its safe side."""
    has_better = found.is_of_part or found.error is None or found.verdict is Verdict.EXACT
    readings = f"the interpretations (readings) that the paper permits give {found.readings}"
    return joined((
        *_head(found), "" if has_better else f"the formula is {SHARED}", found.caution,
        readings if found.readings else "",
    ))  # fmt: skip


def joined(parts: Sequence[str]) -> str:
    """Non-empty `parts` joined as sentences; the last sentence has no full stop."""
    first, *others = filter(None, parts)
    return ". ".join((first, *(one[0].upper() + one[1:] for one in others)))


def _head(found: FormulaVerdict) -> Sequence[str]:
    match found.verdict:
        case Verdict.EXACT:
            largest = percent(max(found.above or 0.0, found.below or 0.0))
            return (f"exact within its idealisation: the largest error is {largest}",)
        case Verdict.ACCURATE:
            over = f"accurate within {percent(found.within)} over {_studied(found)}"
            return over, _unsafe(found)
        case Verdict.PART:
            own, part = _error(found), _part(found)
            first = (own, *part) if _is_outside(found) else (*part, own)
            return *first, _unsafe(found)
        case Verdict.WRONG:
            return _wrong(found)
        case _:
            left = f" (comparisons without a result: {found.unsolved})" if found.unsolved else ""
            only = left if found.points else ONLY
            is_over = found.verdict is Verdict.CONSERVATIVE and found.ranges
            over = f" over {_studied(found)}" if is_over else ""
            is_alone = _one_at_a_time(found) and not any(map(constant, found.ranges))
            alone = " (one input varied at a time)" if is_alone and not over else ""
            largest = sides(found.above or 0.0, found.below or 0.0)
            errors = f"{found.verdict.value}{over}: the values are {largest} the reference{alone}"
            return errors, f"{_error(found)}{only}", SIDE[found.safe]


def _unsafe(found: FormulaVerdict) -> str:
    """Text of the largest error on the unsafe side over all points; both sides if none is safe."""
    if found.safe is Safe.NEITHER:
        both = sides(found.above or 0.0, found.below or 0.0) if found.points else ""
        return f"the values are {both} the reference" if both else ""
    is_low = found.safe is Safe.ABOVE
    largest = (found.below if is_low else found.above) or 0.0
    if largest < SMALLEST:
        return "all errors are on the safe side"
    most = "up to" if any(map(_is_star, found.ranges)) else "at most"
    side = f"too {'low' if is_low else 'high'}, which is the unsafe side"
    stated = None if found.verdict is Verdict.ACCURATE else found.error
    others = "other" if stated is not None and (stated > 0) is is_low else "some"
    return f"{others} values are {most} {percent(largest)} {side}"


def _is_star(one: VerdictRange) -> bool:
    """Whether a study varied several inputs one at a time; combinations may have larger errors."""
    return one.is_star and len(one.studied) > 1


def _one_at_a_time(found: FormulaVerdict) -> bool:
    """Whether all studies of several inputs varied them one at a time."""
    several = [one for one in found.ranges if len(one.studied) > 1]
    return bool(several) and all(map(_is_star, several))


def _wrong(found: FormulaVerdict) -> Sequence[str]:
    """Sentences on the effect of a misprint, alone and together with the error of the formula."""
    if found.error is None:
        return (f"wrong as printed: {found.limited_by}",)
    largest = sides(found.above or 0.0, found.below or 0.0) if found.points else ""
    over = f"over all points, the values are {largest} the reference" if largest else ""
    if found.misprint is None or signed(found.misprint) == signed(found.error):
        return f"wrong as printed: {_error(found)}", over
    alone = f"wrong as printed: the misprint alone changes the value by {signed(found.misprint)}"
    return alone, _error(found).replace("the error is", "the total error is"), over


def signed(value: float) -> str:
    """A relative number in per cent with its sign: "+4.7 %", "−31 %", "under 0.01 %"."""
    size = percent(abs(value))
    return size if abs(value) < SMALLEST else f"{'+' if value > 0 else '−'}{size}"


def percent(value: float | None) -> str:
    """A relative number in per cent with two digits: "0.42 %", "under 0.01 %", "290 %"."""
    if value is None:
        return "–"
    if abs(value) < SMALLEST:
        return "under 0.01 %"
    return f"{100 * value:.0f} %" if abs(value) >= 1 else f"{100 * value:.2g} %"


def _studied(found: FormulaVerdict) -> str:
    """Text of all studied ranges; with unsolved points, of the ranges within the largest limit."""
    if found.unsolved:
        return "; in a further study, over ".join(
            dict.fromkeys(_range(one) for one in _widest(found) if one.inside)
        )
    over = dict.fromkeys((one.case, one.over) for one in found.ranges)
    cases = {case for case, _ in over}
    return "; in a further study, over ".join(
        f"{VALUES.sub('', text)}{f' ({case})' if len(cases) > 1 else ''}" for case, text in over
    )


def _error(found: FormulaVerdict) -> str:
    if found.error is None or found.U is None:
        return "the error is not known"
    bar = f" ± {percent(found.U)}" if found.U >= SMALLEST else ""
    return f"the error is {signed(found.error)}{bar} {_default(found)}"


def _default(found: FormulaVerdict) -> str:
    """The text "at the default inputs", with the case if several cases are evidence."""
    judged = found.rows if found.is_of_part else found.model_rows
    cases = {row.partition("/")[0] for row in judged}
    of = f" of {found.worst_row.partition('/')[0]}" if len(cases) > 1 else ""
    return f"at the default inputs{of}"


def sides(high: float, low: float) -> str:
    """Text of the largest errors above and below, the larger one first: "up to 34 % below"."""
    both = sorted([(high, "above"), (low, "below")], reverse=True)
    return " and ".join(f"up to {percent(size)} {side}" for size, side in both if size >= SMALLEST)


def _part(found: FormulaVerdict) -> Sequence[str]:
    if not found.points:
        return (f"accurate within {percent(found.within)} at the default inputs{ONLY}",)
    if found.within is not None:
        missing = [
            one.words for one in found.design if not one.spanned and one.case not in found.own_only
        ]
        own = " and ".join(found.own_only)
        return (
            f"accurate within {percent(found.within)} over {_studied(found)}",
            f"comparisons without a result: {found.unsolved}" if found.unsolved else "",
            f"no study covers the complete design range {', '.join(missing)}" if missing else "",
            f"in {own}, the formula was compared only at the default inputs" if own else "",
        )  # fmt: skip
    widest = _widest(found)
    best = [one for one in widest if one.inside]
    if not best:
        return ("accurate only at the default inputs",)
    limit = percent(best[0].limit)
    where = "; in a further study, for ".join(dict.fromkeys(map(_range, best)))
    inside, points = (sum(getattr(one, n) for one in widest) for n in ("inside", "points"))
    few = f"the error is within {limit} at {inside} of the {points} points, for {where}"
    if _is_outside(found):
        return (few,)
    return (few if 2 * inside < points else f"accurate within {limit} for {where}",)


def _widest(found: FormulaVerdict) -> list[VerdictRange]:
    """Range of each study within the largest limit."""
    return [one for one in found.ranges if one.limit == found.ranges[-1].limit]


def _is_outside(found: FormulaVerdict) -> bool:
    """Whether the error at the default inputs exceeds the widest accuracy class."""
    return found.error is not None and abs(found.error) + (found.U or 0.0) > CLASSES[-1]


def _range(one: VerdictRange) -> str:
    """Text of the range of one study within a limit, with dimensionless ratios."""
    box = ", ".join(map(side_in_words, one.box))
    alone = "" if not one.is_star or len(one.box) < 2 else " (one input varied at a time)"
    held = f" at {constant(one)}" if constant(one) else ""
    return (
        f"{box}{alone}{held} in {one.case} (points within this limit: {one.inside} of {one.points})"
    )


def constant(one: VerdictRange) -> str:
    """Text of the constant inputs that differ from the default, "z = 8", or an empty text."""
    return one.over.partition(", at ")[2]


def side_in_words(one: Side) -> str:
    """Text of a range with its unit, and with its dimensionless ratio if one is declared."""
    ends = f"{one.symbol} {_span(one.low, one.high)}{'' if one.unit == '1' else f' {one.unit}'}"
    return f"{ends} ({one.ratio} {_span(*one.ratio_ends)})" if one.ratio else ends


def _span(low: float, high: float) -> str:
    return number(low) if low == high else f"{number(low)} to {number(high)}"
