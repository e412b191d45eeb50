"""What `freewheel design` prints: counts and reasons, the front, the chosen spring."""

from collections.abc import Sequence

import numpy as np

from verify import units
from verify.design.limits import Limit
from verify.design.nearest import Relaxation
from verify.design.outcome import Outcome
from verify.design.records import columns, violations
from verify.design.search import Search
from verify.told import aligned

FRONT = (("n", "n", 0), ("b", "b", 4), ("L1", "L_1", 3), ("r", "r", 3), ("alpha", "α", 2),
         ("L0", "L_0", 3), ("U_w", "U_w", 3), ("k1", "k_1", 5), ("U_A", "U_A", 3),
         ("stress", "σ", 1))  # fmt: skip


def print_outcome(outcome: Outcome) -> None:
    """The search in counts, why candidates fall out, and the front or what it would take."""
    s = outcome.search
    feasible = int(s.judged.feasible.sum())
    print(f"{s.task.name}: {len(s.springs):,} candidates, {feasible:,} feasible")
    for line in aligned([("limit", "", "", "violated by"), *map(_reason, *_reasons(s))]):
        print(f"  {line}")
    if outcome.chosen is None:
        print_nothing(s)
        return
    print(f"front: {len(s.front)} springs that none beats in stress, L_0, room to A and stiffness"
          f"{f', {len(s.members)} of them spread over it' if len(s.front) > len(s.members) else ''}")  # fmt: skip
    for line in aligned(front_table(outcome)):
        print(f"  {line}")
    print_chosen(outcome)


def front_table(outcome: Outcome) -> list[tuple[str, ...]]:
    """The members of the front as cells, a head of names and units first."""
    s, values = outcome.search, columns(outcome.search)
    unit_of = {"b": "mm", "L1": "mm", "r": "mm", "alpha": "deg", "L0": "mm", "U_w": "mm",
               "k1": "N/mm", "U_A": "mm", "stress": "MPa", "n": ""}  # fmt: skip
    fem = ["FE", "deviation", ""] if outcome.verified else []
    head = ["", *(symbol for _, symbol, _ in FRONT), *fem]
    below = ["", *(unit_of[name] for name, _, _ in FRONT), *(["N/mm", "", ""] if fem else [])]
    lines = [tuple(head), tuple(below)]
    for rank, i in enumerate(s.members):
        mark = "*" if rank == outcome.chosen else ""
        cells = [f"{rank + 1}{mark}"]
        cells += [f"{values[name][i]:.{digits}f}" for name, _, digits in FRONT]
        if outcome.verified:
            v = outcome.verified[rank]
            cells += [f"{v.k1 / 1e3:.5f}", f"{100 * v.deviation:+.3f} %",
                      "agrees" if v.agrees else f"disagrees: more than ±{100 * v.limit:.2g} %"]  # fmt: skip
        lines.append(tuple(cells))
    return lines


def print_chosen(outcome: Outcome) -> None:
    """Every limit beside the chosen spring's value."""
    assert outcome.chosen is not None
    s = outcome.search
    i = int(s.members[outcome.chosen])
    nearest = " (nearest to the best of everything)" if outcome.chosen == 0 else ""
    print(f"chosen: member {outcome.chosen + 1}{nearest}")
    for line in aligned([_kept(limit, i) for limit in s.judged.limits]):
        print(f"  {line}")


def print_nothing(s: Search) -> None:
    """Which candidate comes nearest, and what would have to give way."""
    if not s.nearest:
        print("nothing is feasible: no candidate is a spring, which needs b < r and 2 r < L1")
        return
    i = s.nearest[0].candidate
    print(f"nothing is feasible; the nearest is {geometry(s, i)}, which violates")
    for line in aligned([_relaxed(r) for r in s.nearest]):
        print(f"  {line}")
    if s.relaxations:
        print("one of these alone would admit a spring")
        for line in aligned([(*_relaxed(r), geometry(s, r.candidate)) for r in s.relaxations]):
            print(f"  {line}")


def geometry(s: Search, i: int) -> str:
    """A candidate in a few words."""
    g = s.springs
    alpha = g.alpha[i] / units.factor("deg")
    return (
        f"n = {g.n[i]}, b = {g.b[i] * 1e3:.4g} mm, L1 = {g.L1[i] * 1e3:.5g} mm, "
        f"r = {g.r[i] * 1e3:.4g} mm, alpha = {alpha:.4g} deg"
    )


def in_unit(limit: Limit, value: float) -> str:
    """A value of a limit's input [SI] in its unit."""
    number = f"{value / units.factor(limit.unit):.4g}"
    return number if limit.unit == "1" else f"{number} {limit.unit}"


def _reasons(s: Search) -> tuple[Sequence[Limit], Sequence[int]]:
    counts = violations(s)
    return s.judged.limits, [counts[limit.key] for limit in s.judged.limits]


def _reason(limit: Limit, count: int) -> tuple[str, ...]:
    bound = in_unit(limit, limit.bound - limit.offset)
    return limit.symbol, f"{limit.sign} {bound}", limit.source, f"{count:,}"


def _kept(limit: Limit, i: int) -> tuple[str, ...]:
    value = in_unit(limit, float(limit.value[i]) - limit.offset)
    bound = in_unit(limit, limit.bound - limit.offset)
    room = f"{-100 * float(limit.excess[i]):.3g} % to spare"
    return limit.what, limit.symbol, value, f"{limit.sign} {bound}", room


def _relaxed(r: Relaxation) -> tuple[str, ...]:
    limit = r.limit
    return (
        limit.what, f"{limit.symbol} {limit.sign} {in_unit(limit, r.given)} ({limit.source})",
        f"relax {limit.key} from {in_unit(limit, r.given)} to {rounded(r)}",
        f"{100 * r.excess:.3g} % beyond",
    )  # fmt: skip


def rounded(r: Relaxation) -> str:
    """The bound that is needed, in its unit, rounded to the side that admits the candidate."""
    value = r.needed / units.factor(r.limit.unit)
    step = 10.0 ** (np.floor(np.log10(abs(value))) - 3) if value else 1.0
    whole = np.floor(value / step) if r.limit.least else np.ceil(value / step)
    number = f"{whole * step:.4g}"
    return number if r.limit.unit == "1" else f"{number} {r.limit.unit}"
