"""Figures of the accordion spring: bending moments, and readings that the paper leaves open."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from analytic.spring import frame
from analytic.spring.moments import moment_diagram
from verify.cases.spring.claims import left_open
from verify.cases.spring.inputs import strip_of
from verify.core.case import Context
from verify.core.figures import Dots, Picture, Profile, Table
from verify.judging.profiles import along
from verify.papers.digits import half_last_digit
from verify.papers.ledger import published

MPa, mm = 1e6, 1e-3
PRINTED = ("k1-theory", "k1-fea", "k1-test")


class Combination(NamedTuple):
    """One combination of readings that the paper leaves open, with its stiffness [N/m]."""

    tail: frame.Tail
    head: frame.Head
    radius: str
    wide: bool
    k: float


def combinations(q: Any) -> list[Combination]:
    """Combinations of all readings of tail, head, arc radius and strip that the paper permits."""
    return [
        Combination(tail, head, radius, wide, frame.stiffness(
            **path, **strip_of(q), head=head, tail=tail, plane_strain=wide))
        for tail, head, radius, path in left_open(q) for wide in (False, True)
    ]  # fmt: skip


def moments(context: Context) -> Iterator[Profile]:
    """Figure of bending moments by Eqs. 1-5; dots are values of straight elements at the joints."""
    if not context.converging:
        return
    q = context.inputs
    spring = {"n": q.n, "L1": q.L1, "r": q.r, "b": q.b, "alpha": q.alpha}
    s, m = moment_diagram(**spring, per_piece=17)
    _, ends = moment_diagram(**spring, per_piece=2)
    at, reference = s.reshape(-1, 17)[:, -1], ends.reshape(-1, 2)[:, -1]
    scale = float(abs(m).max())
    values, u = along(context, "moments", formal=2.0, scale=scale)
    yield Profile(
        title="Bending moment divided by the force, along the spring",
        x_label="arc length from the head [mm]",
        y_label="M/F [mm]", x=s / mm, y=m / mm, x_fem=at / mm, y_fem=values / mm,
        y_ref=reference / mm, u=u / mm, scale=scale / mm,
        note="Line: Eqs. 1, 3 and 5. Dots: frame of straight elements, at the joints of leaves and "
        "arcs, where statics determines the moments exactly. The lower diagram therefore shows "
        "round-off only.",
    )  # fmt: skip


def open_questions(context: Context) -> Iterator[Dots]:
    """Figure of k_1 by all readings that the paper leaves open, with the printed values."""
    q = context.inputs
    items: list[tuple[str, float, float | None, str]] = []
    for name in PRINTED if context.is_paper else ():
        entry = published(f"wang2023:{name}")
        half = half_last_digit(entry.printed) if entry.kind == "theory" else None
        items.append((f"printed, {entry.kind}", entry.value, half, "paper"))
    items.append(("Eqs. 1-9", q.k1 / 1e3, None, "formula"))
    if context.fem:
        curved = context.series("k_V_paper")[1][-1]
        items.append(("FE, centre line of Eqs. 1-9", curved / 1e3, None, "fe"))
    for one in combinations(q):
        if one.tail == "arc":
            strip = "wide strip" if one.wide else "narrow strip"
            items.append((f"head {one.head}, {one.radius}, {strip}", one.k / 1e3, None, "formula"))
    yield Dots(
        title="k_1 for readings that the paper leaves open", label="k_1 [N/mm]", items=tuple(items),
        note="k_1 by the force method, tail clamped at its arc. The paper's text leaves open "
        "whether the head is free or guided, whether the arcs have the radius r or r + b/2, and "
        "whether the strip is narrow or wide. The table below contains all sixteen readings.",
    )  # fmt: skip


def sensitivity(q: Any) -> Table:
    """Table of k_1 for all 16 combinations of tail, head, radius and strip."""
    return Table(
        title="k_1 [N/mm] for all readings of supports, radius and strip",
        header=("tail clamped at", "head", "arc radius", "strip", "k_1 [N/mm]"),
        rows=tuple(
            (one.tail, one.head, one.radius, "E I/(1 − ν²)" if one.wide else "E I",
             round(one.k / 1e3, 4))
            for one in combinations(q)
        ),
        note="The first row has the assumptions of Eqs. 1-9. No value is fitted. A reading that is "
        "chosen because it gives a printed number counts as calibrated.",
    )  # fmt: skip


def bending_stress(q: Any) -> Picture:
    """Picture of the bending stress in the spring of the paper."""
    return Picture(
        field="paper's centre line", data="bending_stress", symbol="σ_b", unit="MPa", factor=MPa,
        width=q.h, caption="Bending stress 6 M/(h b²) under 1 N (positive stress is tension in the "
        "left face, seen from head to tail)",
    )  # fmt: skip
