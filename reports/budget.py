"""Error budgets: figures and texts about why formulas differ from finite elements."""

from collections.abc import Sequence
from dataclasses import dataclass
from textwrap import wrap

from markupsafe import Markup

from reports import svg
from reports.axes import WIDTH, Axes
from reports.formats import MINUS
from verify.core.results import BudgetPart, CaseBudget, Kind, RowBudget

LINE, THICK, TOP, BELOW = 23.0, 11.0, 12.0, 40.0
LEFT, RIGHT = 118.0, 92.0  # of names, and of numbers beyond the axis
NARROW, HALF = 18, 6.5  # letters that a name has room for, and half a line of them
TALL = 31.0  # of a waterfall with names of two lines
NUMERICAL = ("discretisation", "iteration", "contact law")  # one column of many rows
TOTAL, REMAINDER = "difference", "remainder"


@dataclass(frozen=True)
class Bar:
    """A bar of a waterfall chart from `start` to `end`, with half-width `u` at its end [%]."""

    name: str
    start: float
    end: float
    u: float
    label: str
    css: str


SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
MOST = 10  # rows side by side
UNKNOWN = "no cause is known that would explain the difference"
NONE = "none"  # start of the reason why a cause has no contribution
UNSEEN = 1e-3  # of the difference: a part without a bar
SMALL = 1e-3  # per cent: below, powers of ten


def percent(value: float | None, u: float | None = None) -> str:
    """Text of a relative number in per cent with its half-width, such as "−24.8 ± 3·10⁻⁵ %"."""
    if value is None:
        return "–"
    sign = {True: MINUS, False: "+"}[value < 0] if value else ""
    bar = "" if not u else f" ± {_digits(100 * u, 1)}"
    return f"{sign}{_digits(100 * abs(value), 3)}{bar} %"


def _digits(size: float, digits: int) -> str:
    """Text of a number >= 0 with `digits`; below SMALL, with one digit and a power of ten."""
    if not size:
        return "0"
    if size >= SMALL:
        rounded = float(f"{size:.{digits - 1}e}")
        return f"{rounded:#.{digits}g}".rstrip(".") if rounded < 10**digits else f"{rounded:.0f}"
    mantissa, _, exponent = f"{size:.0e}".partition("e")
    return f"{mantissa}·10{str(int(exponent)).translate(SUPERSCRIPTS)}"


def counted(row: RowBudget) -> list[BudgetPart]:
    """Measured contributions to the difference; shared assumptions of both models are omitted."""
    return [p for p in row.parts if p.contribution is not None and not p.shared]


def steps(row: RowBudget) -> list[Bar]:
    """Bars of the waterfall chart: difference, contributions of the causes, remainder."""
    at = 100 * row.total
    found = [Bar(TOTAL, 0.0, at, 100 * (row.U or 0.0), percent(row.total), "total")]
    for part in counted(row):
        c, u = part.contribution or 0.0, part.u or 0.0
        if max(abs(c), u) < UNSEEN * abs(row.total):
            continue  # it is in the table
        found.append(Bar(_label(part, row), at, at - 100 * c, 100 * u, percent(c), "part"))
        at -= 100 * c
    left = percent(row.remainder)
    rest = Bar(REMAINDER, 0.0, 100 * row.remainder, 100 * row.u, left, "rest")
    return [*found, rest]


def _label(part: BudgetPart, row: RowBudget) -> str:
    """Name of a bar: the cause; if the cause has several parts, the name of the part."""
    alike = sum(other.cause == part.cause for other in counted(row))
    return part.cause if alike == 1 else part.what.partition(":")[0]


def waterfall(row: RowBudget) -> Markup:
    """Waterfall chart of a row: each bar starts from the end of the bar above it."""
    found = steps(row)
    reach = [(bar.start, bar.end - bar.u, bar.end + bar.u) for bar in found]
    low, high = (f(0.0, *(f(*r) for r in reach)) for f in (min, max))
    line = TALL if any(len(bar.name) > NARROW for bar in found) else LINE
    height = TOP + line * len(found) + BELOW
    axes = Axes(
        (LEFT, TOP, WIDTH - RIGHT, height - BELOW), (low, high if high > low else low + 1.0),
        (float(len(found)), 0.0),
    )  # fmt: skip
    for i, bar in enumerate(found):
        axes.body += _drawn(axes, i, bar, line, last=i >= len(found) - 2)
    axes.body.append(svg.line(axes.X(0.0), TOP, axes.X(0.0), height - BELOW, "axis"))
    axes.base(svg.ticks(*axes.x, 4), svg.plain)
    axes.titles("formula/FE − 1 [%]", "")
    label = f"{row.quantity}: {found[0].label}, of which {found[-1].label} remain"
    return svg.drawing(WIDTH, height, axes.body, label, "chart waterfall")


def _drawn(axes: Axes, i: int, bar: Bar, line: float, *, last: bool) -> list[Markup]:
    y, (x_0, x_1) = axes.Y(i + 0.5), (axes.X(bar.start), axes.X(bar.end))
    left, right = min(x_0, x_1), max(x_0, x_1)
    name = wrap(bar.name, NARROW, max_lines=2, placeholder="…")
    found = [
        *(
            svg.text(LEFT - 8, y + 4 + HALF * (2 * k - len(name) + 1), words, "tick", "end")
            for k, words in enumerate(name)
        ),
        svg.rectangle(left, y - THICK / 2, max(right - left, 0.8), THICK, bar.css),
        svg.text(WIDTH, y + 4, bar.label, "tick", "end"),
    ]
    if not last:  # the next bar starts where this one ends
        found.append(svg.line(x_1, y + THICK / 2, x_1, y + line - THICK / 2, "grid"))
    if axes.X(bar.end + bar.u) - axes.X(bar.end - bar.u) > 1:
        found.append(svg.line(axes.X(bar.end - bar.u), y, axes.X(bar.end + bar.u), y, "whisker"))
    return found


def headline(one: CaseBudget) -> RowBudget | None:
    """Row that is drawn as a waterfall chart; None if there is none."""
    return next((row for row in one.rows if row.headline), None)


def lines(row: RowBudget) -> list[tuple[str, str, str]]:
    """Lines of text about a row: cause, changed quantity of the computation, contribution."""
    found = [(TOTAL, "formula and finite elements, all causes included", percent(row.total, row.U))]
    found += [(p.cause, *_contribution(p)) for p in row.parts if not p.shared]
    found += [
        ("both causes", f"both causes removed at once: “{'” and “'.join(joint.causes)}”",
         f"{percent(joint.value)} beyond the sum of both contributions" if joint.value is not None
         else joint.note)
        for joint in row.joints
    ]  # fmt: skip
    left = percent(row.remainder, row.u)
    found.append(
        (REMAINDER, "part that no computation explains: error of the formula itself", left)
    )
    beside = [(p.cause, f"{p.what} (assumption of both sides, not part of the sum)", _number(p))
              for p in row.parts if p.shared]  # fmt: skip
    return [*found, *beside]


def _contribution(part: BudgetPart) -> tuple[str, str]:
    if part.contribution is None:
        label = dict.fromkeys(filter(None, (part.what, part.note)))
        text = "; ".join(label)
        return text if part.what or text.startswith(NONE) else f"{NONE}: {text}", "–"
    return part.what, _number(part)


def _number(part: BudgetPart) -> str:
    return part.note if part.contribution is None else percent(part.contribution, part.u)


@dataclass(frozen=True)
class Compact:
    """Table of several rows: the causes are the `header`.

    `of` is the number of rows among which `rows` were selected.
    """

    header: Sequence[str]
    rows: Sequence[tuple[RowBudget, Sequence[str]]]
    of: int


def compact(one: CaseBudget) -> Compact | None:
    """Table of at most MOST approximations, those with the largest remainders.

    It does not contain the row that is drawn; None if there is no other approximation.
    """
    rows = [r for r in one.rows if r.kind is Kind.APPROXIMATION and not r.headline]
    if not rows:
        return None
    count = len(rows)
    kept = sorted(rows, key=lambda row: -abs(row.remainder))[:MOST]
    rows = [row for row in rows if row in kept]
    heads = list(dict.fromkeys(_head(p) for row in rows for p in counted(row)))
    return Compact(heads, [(row, [_sum(row, head) for head in heads]) for row in rows], count)


def _head(part: BudgetPart) -> str:
    """Head of the column that contains a contribution."""
    return "numerical" if part.cause in NUMERICAL else part.cause


def _sum(row: RowBudget, head: str) -> str:
    mine = [p.contribution or 0.0 for p in counted(row) if _head(p) == head]
    return percent(sum(mine)) if mine else "–"


def identities(one: CaseBudget) -> str:
    """Sentence about the rows whose formula and finite elements solve the same problem."""
    rows = [row for row in one.rows if row.kind is Kind.IDENTITY]
    if not rows:
        return ""
    inside = sum(row.within is True for row in rows)
    worst = max(rows, key=lambda row: abs(row.remainder))
    return (
        f"For {inside} of {len(rows)} identities, the remainder is within the errors of mesh and "
        "iteration and the tolerance of the row. The largest remainder is "
        f"{percent(worst.remainder, worst.u)}, in the row “{worst.quantity}”, whose difference is "
        f"{percent(worst.total, worst.U)}."
    )


def outside(one: CaseBudget) -> list[RowBudget]:
    """Identities whose remainder is not explained by the known causes."""
    return [row for row in one.rows if row.within is False]


def left(one: CaseBudget) -> str:
    """Sentence about the rows whose difference the computations do not explain, by reason."""
    reasons = dict.fromkeys(row.why for row in one.rows if not row.apart)
    return " ".join(
        f"The differences of these rows are not decomposed ({why or UNKNOWN}): "
        f"“{'”; “'.join(row.quantity for row in one.rows if not row.apart and row.why == why)}”."
        for why in reasons
    )
