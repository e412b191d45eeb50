"""Output of `freewheel design`: counts, reasons of rejection, Pareto front, selected spring."""

import math
from collections.abc import Sequence

import numpy as np

from verify.core import units
from verify.core.console import aligned
from verify.core.terminal import print_wrapped
from verify.core.unit_systems import System, cells_in, ratio, text_in, unit_in
from verify.studies.design.fem import Verified
from verify.studies.design.limits import Limit
from verify.studies.design.nearest import Relaxation
from verify.studies.design.outcome import Outcome
from verify.studies.design.records import COLUMNS, columns, violations
from verify.studies.design.search import Search

ACCEPTED = "accepted"
WIDE = 1.005  # width factor from which a warning is given
FRONT = (("n", "n", 0), ("b", "b", 4), ("L1", "L_1", 3), ("r", "r", 3), ("alpha", "α", 2),
         ("L0", "L_0", 3), ("U_w", "U_w", 3), ("k1", "k_1", 5), ("U_A", "U_A", 3),
         ("stress", "σ", 1))  # fmt: skip


def print_outcome(outcome: Outcome, system: System = "mm") -> None:
    """Print counts of candidates and violations, and the Pareto front or required relaxations."""
    s = outcome.search
    feasible = int(s.judged.feasible.sum())
    print(f"{s.task.name}: {len(s.springs):,} candidates, {feasible:,} feasible")
    for line in aligned(
        cells_in([("limit", "", "", "violated by"), *map(_reason, *_reasons(s))], system)
    ):
        print_wrapped(f"  {line}")
    if outcome.chosen is None:
        print_nothing(s, system)
        return
    more = len(s.front) > len(s.members)
    print_wrapped(
        f"front: {len(s.front)} Pareto-optimal springs in stress, L_0, margin to A and stiffness"
        + (f", {len(s.members)} of them listed" if more else "")
    )
    for line in aligned(front_table(outcome, system)):
        print_wrapped(f"  {line}")
    print_chosen(outcome, system)
    for warning in warnings(outcome):
        print_wrapped(text_in(f"warning: {warning}", system))


def front_table(outcome: Outcome, system: System = "mm") -> list[tuple[str, ...]]:
    """Table of the Pareto front: lines of symbols and units, then one line per spring."""
    s, values = outcome.search, columns(outcome.search)
    unit_of = dict(COLUMNS) | {"n": ""}
    target = {name: unit_in(unit_of[name], system) for name, _, _ in FRONT}
    scale = {name: ratio(unit_of[name], target[name]) if target[name] else 1.0 for name in target}
    fem = bool(outcome.verified)
    lines = [
        (
            "",
            *(symbol for _, symbol, _ in FRONT),
            *(("k_1 FE", "minus FE", "Δ FE", "e_r FE", "") if fem else ()),
        ),
        (
            "",
            *target.values(),
            *((unit_in("N/mm", system), "", unit_in("mm", system), "", "") if fem else ()),
        ),
    ]
    for rank, i in enumerate(s.members):
        cells = [f"{rank + 1}{'*' if rank == outcome.chosen else ''}"]
        cells += [
            _decimal(values[name][i] * scale[name], digits, scale[name])
            for name, _, digits in FRONT
        ]
        lines.append((*cells, *(by_fem(outcome.verified[rank], system) if fem else ())))
    return lines


def _decimal(value: float, digits: int, scale: float) -> str:
    """Text of a number that was multiplied by `scale`; `digits` are the decimals before this."""
    return f"{value:.{max(0, digits - round(math.log10(scale)))}f}"


def by_fem(v: Verified, system: System = "mm") -> tuple[str, ...]:
    """Table cells with the finite-element results of one spring; the last cell is the verdict."""
    stiffness, length = (ratio(unit, unit_in(unit, system)) for unit in ("N/mm", "mm"))
    return (
        _decimal(v.k1 / 1e3 * stiffness, 5, stiffness), f"{100 * v.deviation:+.3f} %",
        _decimal(v.delta * 1e3 * length, 3, length), f"{100 * v.e_r:+.2f} %",
        text_in(verdict(v), system),
    )  # fmt: skip


def verdict(v: Verified) -> str:
    """First reason why finite elements reject a spring, such as the error of k_1; or "accepted"."""
    if not v.agrees:
        return f"k_1 beyond ±{100 * v.limit:.2g} %"
    if v.curve.touches <= v.U_w:
        return f"leaves touch at {v.curve.touches * 1e3:.3g} mm"
    if v.too_high:
        return f"height {v.curve.height * 1e3:.4g} mm"
    if v.unsolved:
        return f"no equilibrium found beyond {v.curve.U[-1] * 1e3:.3g} mm"
    if v.overstressed:
        return f"stress {v.stress / 1e6:.4g} MPa"
    return ACCEPTED if v.fits else f"|e_r| beyond {100 * v.e_max:.2g} %"


def warnings(outcome: Outcome) -> list[str]:
    """Warnings on the selected spring."""
    s, i = outcome.search, outcome.candidate
    q, f = s.task.demands, s.formulas
    found = []
    if q.width_factor is None and f.f[i] > WIDE:
        found.append(
            f"width of the strip: {f.f[i] - 1:+.1%} stiffness by the plate theory of a leaf; arcs "
            "increase this difference, up to 1/(1 - ν²) (see case spring-width)"
        )
    if abs(f.k1_eqs_1_9[i] / f.k1[i] - 1) > q.e_max:
        found.append(
            f"Eqs. 1-9 as printed give k_1 = {f.k1_eqs_1_9[i] / 1e3:.4g} N/mm, "
            f"{f.k1_eqs_1_9[i] / f.k1[i] - 1:+.1%}: inner radius, free head, tail clamped at arc"
        )
    if outcome.verified:
        v = outcome.verified[outcome.chosen or 0]
        if (reason := verdict(v)) != ACCEPTED:
            what = "do not verify" if v.unsolved else "reject"
            found.append(f"finite elements {what} the selected spring: {reason}")
    if outcome.verified and not any(v.agrees and v.fits for v in outcome.verified):
        found.append("finite elements accept no member of the front")
    return found


def print_chosen(outcome: Outcome, system: System) -> None:
    """Print every limit with the value and the margin of the selected spring."""
    s, i = outcome.search, outcome.candidate
    print_wrapped(
        text_in(f"selected: member {s.members.tolist().index(i) + 1}, {geometry(s, i)}", system)
    )
    for line in aligned(cells_in([_limit_line(limit, i) for limit in s.judged.limits], system)):
        print_wrapped(f"  {line}")


def print_nothing(s: Search, system: System) -> None:
    """Print the candidate closest to feasible and the limits that would have to be relaxed."""
    if not s.nearest:
        print("no candidate is feasible: a spring requires b < r and 2 r < L1")
        return
    i = s.nearest[0].candidate
    nearest = f"no candidate is feasible; the closest is {geometry(s, i)}, which violates"
    print_wrapped(text_in(nearest, system))
    for line in aligned(cells_in([_relaxed(r) for r in s.nearest], system)):
        print_wrapped(f"  {line}")
    if s.relaxations:
        print("each of these relaxations alone would make one spring feasible")
        alone = [(*_relaxed(r), geometry(s, r.candidate)) for r in s.relaxations]
        for line in aligned(cells_in(alone, system)):
            print_wrapped(f"  {line}")


def geometry(s: Search, i: int) -> str:
    """Segments and dimensions of candidate `i` as one line of text."""
    g = s.springs
    alpha = g.alpha[i] / units.factor("deg")
    return (
        f"n = {g.n[i]}, b = {g.b[i] * 1e3:.4g} mm, L1 = {g.L1[i] * 1e3:.5g} mm, "
        f"r = {g.r[i] * 1e3:.4g} mm, alpha = {alpha:.4g} deg"
    )


def in_unit(limit: Limit, value: float) -> str:
    """`value` [SI] as text in the unit of the limit's input."""
    if np.isinf(value):
        return "∞"
    number = f"{value / units.factor(limit.unit):.4g}"
    return number if limit.unit == "1" else f"{number} {limit.unit}"


def _reasons(s: Search) -> tuple[Sequence[Limit], Sequence[int]]:
    counts = violations(s)
    return s.judged.limits, [counts[limit.key] for limit in s.judged.limits]


def _reason(limit: Limit, count: int) -> tuple[str, ...]:
    bound = in_unit(limit, limit.bound - limit.offset)
    return limit.symbol, f"{limit.sign} {bound}", limit.source, f"{count:,}"


def _limit_line(limit: Limit, i: int) -> tuple[str, ...]:
    value = in_unit(limit, float(limit.value[i]) - limit.offset)
    bound = in_unit(limit, limit.bound - limit.offset)
    return limit.what, limit.symbol, value, f"{limit.sign} {bound}", f"margin {spare(limit, i)}"


def spare(limit: Limit, i: int) -> str:
    """Margin of candidate `i` to the limit, in percent of the bound; "∞" for an infinite value."""
    room = -float(limit.excess[i])
    return "∞" if np.isinf(room) else f"{100 * room:.3g} %"


def _relaxed(r: Relaxation) -> tuple[str, ...]:
    limit = r.limit
    return (
        limit.what, f"{limit.symbol} {limit.sign} {in_unit(limit, r.given)} ({limit.source})",
        f"relax {limit.key} from {in_unit(limit, r.given)} to {rounded(r)}"
        if r.possible else f"needs {rounded(r)}, beyond the allowed {limit.key}",
        f"{100 * r.excess:.3g} % beyond",
    )  # fmt: skip


def rounded(r: Relaxation) -> str:
    """Required bound in its unit, as text, rounded so that the candidate is admitted."""
    value = r.needed / units.factor(r.limit.unit)
    step = 10.0 ** (np.floor(np.log10(abs(value))) - 3) if value else 1.0
    steps = np.round(value / step, 9)  # round-off does not make a number fractional
    whole = np.floor(steps) if r.limit.least else np.ceil(steps)
    number = f"{whole * step:.4g}"
    return number if r.limit.unit == "1" else f"{number} {r.limit.unit}"
