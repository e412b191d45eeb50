"""Lines that all explanations contain: numbers with units, difference, detection limit."""

import math
from collections.abc import Callable
from dataclasses import dataclass

from verify.core.differences import difference, difference_texts, offset, percent
from verify.core.results import Kind, Row
from verify.judging import judge

Step = tuple[str, str]  # name of the step, and its derivation


@dataclass(frozen=True)
class Derivation:
    """Lines of the explanation that lead to a verdict, and the verdict.

    `u_num` has the unit of the row; it is None for a row without finite elements.
    """

    steps: tuple[Step, ...]
    verdict: judge.Verdict
    u_num: float | None = None


def long(value: float) -> str:
    """A number with twelve digits, so that small differences can be seen."""
    return f"{value:.12g}"


def short(value: float | None) -> str:
    """A number with four digits, sufficient to repeat a calculation."""
    return "unknown" if value is None else f"{value:.4g}"


def amount(value: float | None, unit: str, digits: Callable[[float], str] = short) -> str:
    """A number with its unit."""
    text = "unknown" if value is None else digits(value)
    return text if unit == "1" else f"{text} {unit}"


def demand(row: Row) -> float:
    """Required sensitivity of the row; by default, the required sensitivity of the suite."""
    return judge.DEMAND if row.demand is None else row.demand


def expanded(unit: str, u_num: float, u_ref: float, u_input: float, U: float) -> Step:
    """Line of the explanation: expanded uncertainty U from three standard uncertainties."""
    return (
        "U",
        f"2 √(u_num² + u_ref² + u_input²) = 2 √({short(u_num)}² + {short(u_ref)}² + "
        f"{short(u_input)}²) = {amount(U, unit)}",
    )


def difference_steps(row: Row, verdict: judge.Verdict, what: str) -> tuple[Step, ...]:
    """Lines of the explanation: scale, difference, test |d| ≤ U, and detection limit."""
    U, scale = verdict.tolerance, row.scale
    # as judged: the printed values were converted, which changes their last digit
    d = verdict.difference if row.difference is None else row.difference
    named = row.scale_name or "|reference|"
    lines = [("scale", f"{named} = {amount(scale, row.unit)}")]
    if d is None or U is None or scale is None:
        return (*lines, ("test", "a value is not finite: the solution did not converge"))
    lines += [
        ("d", f"{what} = {amount(offset(row), row.unit)}{_share(row)}"),
        ("test", f"|d| ≤ U, that is {short(abs(d))} ≤ {short(U)}: "
         f"{'holds' if abs(d) <= U else 'does not hold'}"),
        sharpness(row, verdict, f"(U + |d|)/scale = ({short(U)} + {short(abs(d))})/{short(scale)}"),
    ]  # fmt: skip
    return tuple(lines)


def _share(row: Row) -> str:
    """Text of the relative difference, in the form that all pages use."""
    found = difference(row)
    if found is None or row.kind is Kind.TREND:
        return ""
    text, _ = difference_texts(row)
    return f", {text}" if found.of else f", {text} of the reference"


def sharpness(row: Row, verdict: judge.Verdict, how: str) -> Step:
    """Line with the detection limit: smallest relative change that certainly makes the row fail."""
    if verdict.detects is None or not math.isfinite(verdict.detects):
        known = verdict.tolerance is not None and math.isfinite(verdict.tolerance)
        why = "the row fails already" if known else "the uncertainty is not finite"
        return ("detects", f"no detection limit: {why}")
    asked = demand(row)
    word = "meets" if verdict.detects <= asked else "misses"
    reason = row.demand_reason or "the suite's default"
    limit, most = (
        (short(verdict.detects), f"{asked:g}") if row.kind in (Kind.EXACT, Kind.TREND)
        else (percent(verdict.detects), percent(asked))
    )  # fmt: skip
    return ("detects", f"{how} = {limit}, which {word} the required {most} ({reason})")
