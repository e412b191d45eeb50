"""The page of a spring design, in the units of the task."""

import time
from collections.abc import Sequence

from reports.design import DesignPage, Tile
from verify.app.design.figures import figures
from verify.cases.spring.stages.inputs import StagesInputs
from verify.cases.spring.stages.sketch import sketch
from verify.core import units
from verify.core.figures import Sketch, Table
from verify.studies.design.console import (
    FRONT,
    geometry,
    in_unit,
    rounded,
    spare,
    verdict,
    warnings,
)
from verify.studies.design.inputs import SWEEPS
from verify.studies.design.limits import Limit
from verify.studies.design.nearest import Relaxation
from verify.studies.design.outcome import Outcome
from verify.studies.design.records import COLUMNS, columns
from verify.studies.design.search import Search

STEPS = (
    "Every combination of n, b, α, r and L_1 is a candidate. The paper fixes b and n, varies "
    "L_1 and r, and derives α from the wedge (Fig. 12). Shapes into which no strip can be bent, "
    "b ≥ r or 2 r ≥ L_1, are excluded.",
    "The free length L_0 of a candidate follows from its shape, U_w = L_0 − L_w from the task, "
    "and Δ = F_w/k_1 from "
    "the energy of the free stage (Eqs. 1-8, on the centre line and with the end conditions of "
    "the task"
    ").",
    "A candidate must meet the limits of |U_w − Δ|/Δ (Eq. 11), U_w/L_0 (Eq. 12) and L_0/b (Eq. "
    "13), "
    "and must fit into the wedge (Fig. 12).",
    "In addition to the paper, the leaves must not touch before U_w, and the spring must not "
    "buckle sideways. The bending stress "
    "inside the loops, the height of the spring and the change of k_1 with the tolerance of the "
    "strip must be "
    "within their limits.",
    "The Pareto front contains the feasible candidates that no other candidate dominates in "
    "stress, L_0, "
    "U_A/U_w and |k_1/k_w − 1|, with k_w = F_w/U_w. A longer front is reduced to 20 members: "
    "the best in each "
    "criterion, the member closest to the ideal point, then repeatedly the member with the largest "
    "distance from the selected members. Every axis is scaled to the front.",
    "Finite elements judge each member. A curved frame verifies k_1 within a third of the "
    "deviation that Eq. 11 "
    "allows. A geometrically exact beam with contact of the leaves verifies Eq. 11 itself, with "
    "the "
    "actual displacement under F_w.",
    "The selected member is the one closest to the ideal point among the members that finite "
    "elements accept.",
)


def page(outcome: Outcome, command: str) -> DesignPage:
    """All content of the page."""
    s = outcome.search
    chosen = outcome.chosen is not None
    return DesignPage(
        name=s.task.name,
        meta=time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime())
        + " · after Wang et al. 2023, Eqs. 11-13 and Fig. 12",
        tiles=_tiles(outcome),
        failure=_failure(outcome),
        warnings=warnings(outcome) if chosen else (),
        lead=_lead(outcome) if chosen else "",
        sketch=_sketch(outcome) if chosen else None,
        chosen=_values(s, outcome.candidate) if chosen else (),
        limits=_limits(s, outcome.candidate if chosen else None),
        front=_front(outcome) if chosen else None,
        relaxations=_relaxations(s),
        figures=figures(outcome),
        steps=STEPS,
        inputs=_inputs(s),
        command=command,
    )


def _tiles(outcome: Outcome) -> Sequence[Tile]:
    s = outcome.search
    feasible = int(s.judged.feasible.sum())
    found = [
        Tile(number=f"{len(s.springs):,}", words="candidates"),
        Tile(number=f"{feasible:,}", words="feasible", css="" if feasible else "is-fail"),
        Tile(number=f"{len(s.front)}", words="on the front"),
    ]
    if outcome.verified:
        accepted = sum(v.agrees and v.fits for v in outcome.verified)
        words = f"of {len(s.members)} accepted by finite elements"
        css = "is-pass" if accepted else "is-fail"
        found.append(Tile(number=str(accepted), words=words, css=css))
    return found


def _failure(outcome: Outcome) -> Sequence[str]:
    if outcome.passed:
        return ()
    if outcome.chosen is None:
        return ("No candidate meets all limits.",)
    v = outcome.verified[outcome.chosen]
    if not v.fits:
        return (f"Member {outcome.chosen + 1} by finite elements: {verdict(v)} (Eq. 11).",)
    off = [k + 1 for k, v in enumerate(outcome.verified) if not v.agrees]
    return (f"The stiffness by the formula disagrees with finite elements for the members {off}.",)


def _lead(outcome: Outcome) -> str:
    shape = geometry(outcome.search, outcome.candidate)
    member = f"Member {(outcome.chosen or 0) + 1} of the front: {shape}."
    if not outcome.verified:
        return f"{member} It was not judged by finite elements."
    v = outcome.verified[outcome.chosen or 0]
    return (
        f"{member} Finite elements: k_1 = {v.k1 / 1e3:.4g} N/mm, formula {v.deviation:+.2%}; "
        f"F_w causes a displacement of {v.delta * 1e3:.4g} mm, so that (U_w − Δ)/Δ = "
        f"{v.e_r:+.2%}: {verdict(v)}."
    )


def _sketch(outcome: Outcome) -> Sketch:
    s, i, q = outcome.search.springs, outcome.candidate, outcome.search.task.demands
    spring = StagesInputs(
        n=int(s.n[i]), b=float(s.b[i]), h=q.h, r=float(s.r[i]), L1=float(s.L1[i]),
        alpha=float(s.alpha[i]), E=q.E, nu=q.nu, head=q.head, tail=q.tail,
        width_factor=float(outcome.search.formulas.f[i]),
    )  # fmt: skip
    return sketch(spring)


WORDS = {
    "n": ("n", "segments"), "b": ("b", "thickness"), "L1": ("L_1", "length of head and tail"),
    "r": ("r", "inner radius of the arcs"), "alpha": ("α", "angle of the arcs"),
    "L0": ("L_0", "free length"), "U_w": ("U_w", "working displacement"),
    "Delta": ("Δ", "computed displacement, F_w/k_1"), "k1": ("k_1", "stiffness"),
    "f": ("f", "width factor"),
    "k1_eqs_1_9": ("k_1", "stiffness by Eqs. 1-9 in the paper's interpretation"),
    "U_A": ("U_A", "displacement at which leaves touch"), "F_A": ("F_A", "force at U_A"),
    "k2": ("k_2", "stiffness beyond U_A"), "stress": ("σ", "bending stress at F_w"),
}  # fmt: skip


def _values(s: Search, i: int) -> Sequence[tuple[str, str, str]]:
    values = columns(s)
    return [
        (*WORDS[name], f"{values[name][i]:.5g}{'' if unit == '1' else f' {unit}'}")
        for name, unit in COLUMNS
    ]


def _limits(s: Search, i: int | None) -> Table:
    rows = []
    for limit in s.judged.limits:
        bound = f"{limit.sign} {in_unit(limit, limit.bound - limit.offset)}"
        value = "" if i is None else in_unit(limit, float(limit.value[i]) - limit.offset)
        room = "" if i is None else spare(limit, i)
        rows.append((limit.symbol, value, bound, room, limit.source))
    return Table(
        title="Limits of the spring",
        header=("limit", "value", "", "reserve", "source"),
        rows=tuple(rows),
    )


def _front(outcome: Outcome) -> Table:
    s, values = outcome.search, columns(outcome.search)
    unit_of = dict(COLUMNS)
    heads = [symbol if unit_of[name] == "1" else f"{symbol} [{unit_of[name]}]"
             for name, symbol, _ in FRONT]  # fmt: skip
    fem = ("k_1 FE [N/mm]", "formula minus FE [%]", "Δ FE [mm]", "e_r FE [%]", "")
    rows = []
    for rank, i in enumerate(s.members):
        cells = [
            int(values[name][i]) if name == "n" else round(float(values[name][i]), digits)
            for name, _, digits in FRONT
        ]
        row: list[str | float | None] = [rank + 1, *cells]
        if outcome.verified:
            v = outcome.verified[rank]
            row += [round(v.k1 / 1e3, 5), round(100 * v.deviation, 3), round(v.delta * 1e3, 3),
                    round(100 * v.e_r, 2), verdict(v)]  # fmt: skip
        rows.append(tuple(row))
    return Table(
        title="Pareto front", header=("member", *heads, *(fem if outcome.verified else ())),
        rows=tuple(rows),
        note="Pareto-optimal springs in stress, L_0, U_A/U_w and |k_1/k_w − 1|; the spring "
             "closest to the "
        "ideal point is first. --choose selects another member. All candidates are in "
        "candidates.csv.",
    )  # fmt: skip


def _relaxations(s: Search) -> Sequence[Table]:
    if not s.nearest:
        return ()
    nearest = geometry(s, s.nearest[0].candidate)
    found = [
        Table(
            title="Limits violated by the closest candidate",
            note=f"The candidate is {nearest}; its largest excess is the lowest of all candidates.",
            header=("limit", "value", "required", "excess", "source"),
            rows=tuple((r.limit.symbol, in_unit(r.limit, r.needed), _bound(r),
                        f"{100 * r.excess:.3g} %", r.limit.source) for r in s.nearest),
        )
    ]  # fmt: skip
    if s.relaxations:
        found.append(
            Table(
                title="Relaxing one of these limits makes a spring feasible",
                header=("limit to relax", "from", "to", "spring that becomes feasible"),
                rows=tuple((f"{r.limit.key}, {r.limit.what}", in_unit(r.limit, r.given),
                            rounded(r), geometry(s, r.candidate)) for r in s.relaxations),
            )
        )  # fmt: skip
    return found


def _bound(r: Relaxation) -> str:
    limit: Limit = r.limit
    return f"{limit.sign} {in_unit(limit, r.given)}"


def _inputs(s: Search) -> Sequence[tuple[str, str, str]]:
    found = [
        (v.symbol, v.what, v.value if isinstance(v.value, str)
         else f"{v.value:.6g}{'' if v.unit == '1' else f' {v.unit}'}")
        for v in s.task.demands.display()
    ]  # fmt: skip
    for name, sweep in SWEEPS.items():
        values = [value / units.factor(sweep.unit) for value in s.task.ranges[name]]
        ends = f"{values[0]:.6g}" if len(values) == 1 else f"{values[0]:.6g} to {values[-1]:.6g}"
        unit = "" if sweep.unit == "1" else f" {sweep.unit}"
        many = f", {len(values)} values" if len(values) > 1 else ""
        found.append((sweep.symbol or name, f"{sweep.what}{many}", f"{ends}{unit}"))
    return found
