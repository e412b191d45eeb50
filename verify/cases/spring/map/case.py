"""Where Eqs. 1-9 of the accordion spring hold: radius, displacement, what holds the head."""

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from analytic.spring import energy, frame
from analytic.spring.elastica import Elastica
from verify.cases.spring.map import figures as map_figures
from verify.cases.spring.map.fem import MAPPED, deep_fem, fem
from verify.cases.spring.map.inputs import (
    DEEP_ANGLES,
    DEEP_SEGMENTS,
    SHARES,
    Cell,
    MapInputs,
    points,
)
from verify.cases.spring.sketch import sketch
from verify.core.case import Case, Context, Output, Scan, Values
from verify.core.figures import Figure
from verify.jobs.deep_results import measured
from verify.judging.checks import Accepted, Approximation, Identity
from verify.judging.published_checks import Contradiction
from verify.judging.tolerance_checks import Agreement, Pair, demanded, suites
from verify.papers.ledger import published

MOST = 24  # segments of an elastica that a check has time for
CLAIMED, FROM = 0.10, 240.0  # the paper's error at larger L_0/b
THIRD = 1 / 3
TEST_FORCE = 11.0  # N, the largest of Sec. 4
NOT_FOUND = f"no equilibrium of the guided elastica was found up to {SHARES[-1]:.0%} of its length"
NOISE = 1e-4  # of the maps' finite elements
WAY = 0.01  # of the force at the end of a straight way


@lru_cache(maxsize=4)
def pressed(q: MapInputs) -> Values:
    """The exact forces of a guided head at the shares of its length, and aside.

    Empty where Newton's method finds no state on the way, whatever the reason: `too_large` and
    `warnings` then say that there is no result, and nothing about the spring.
    """
    try:
        return _pressed(q)
    except ArithmeticError:
        return {}


def _pressed(q: MapInputs) -> Values:
    EA = q.E * q.h * q.b
    line = Elastica(
        frame.pieces(**q.path), EI=EA * q.b**2 / 12, EA=EA, GA=5 / 6 * EA / (2 * (1 + q.nu))
    )
    steps = np.unique([*np.linspace(0.075, SHARES[0], 4), 0.45, *SHARES])
    states = dict(zip(steps, line.path("guided", steps * q.length), strict=True))
    values = {f"F, {share:g}": states[share].F for share in SHARES}
    near = [line.unloaded()]
    for part in np.linspace(0.25, 1, 4):
        near = [*near[-1:], line.displaced("guided", part * q.x_r, near, aside=part * q.y_r)]
    values |= {"F_x, aside": near[-1].F, "F_y, aside": float(near[-1].head[3])}
    values["F_x, straight"] = line.path("guided", np.linspace(0.25, 1, 4) * q.x_r)[-1].F
    return values


def analytic(q: MapInputs) -> Values:
    k1 = float(energy.stiffness(**Cell(q.n, q.b, q.r, q.L1, q.alpha).eqs, h=q.h, E=q.E))
    values = {"k1": k1, "L": q.length}
    values |= {f"k1 U, {share:g}": k1 * share * q.length for share in SHARES}
    if q.n <= MOST:
        values |= pressed(q)
    U = (TEST_FORCE - published("wang2023:eq10-ab-intercept").value) / (
        published("wang2023:k2-fea").value * 1e3
    )
    values["error at the tests' force"] = 1 - k1 * U / TEST_FORCE
    return values


def too_large(q: MapInputs) -> str:
    if q.n > MOST:
        return f"n = {q.n} segments are more than {MOST}: check it without --fem"
    return "" if pressed(q) else f"{NOT_FOUND}: check it without --fem"


def mapped(context: Context, name: str) -> Any:
    """An array of the level on which maps are made."""
    return next(r.arrays[name] for r in context.fem if name in r.arrays)


def errors(q: MapInputs, cells: list[list[Cell]], k: Any) -> Any:
    """Eqs. 1-9 over finite elements less one (rows, columns, 3); NaN where there is none."""
    k1 = np.array([[float(energy.stiffness(**c.eqs, h=q.h, E=q.E)) if c.b < c.r else np.nan
                    for c in row] for row in cells])  # fmt: skip
    with np.errstate(divide="ignore"):
        return np.where(k > 0, k1[..., None] / k - 1, np.nan)


def within_claim(context: Context) -> tuple[float, float, str]:
    """What is left of 10 % at L_0/b from 240 on, at small displacement."""
    q = context.inputs
    cells = points(q, deep=False)["slender"]
    m = errors(q, cells, mapped(context, "slender"))[..., 0]
    z = np.array([[c.length / c.b for c in row] for row in cells])
    worst = float(np.nanmax(np.abs(m[z > FROM * 0.999])))
    return CLAIMED - worst, NOISE, f"{worst:.1%} at most"


def falls(context: Context) -> tuple[float, float, str]:
    """Least step by which the error at small displacement falls as b does, on one centre line."""
    q = context.inputs
    b, z, k = mapped(context, "on line").T
    k1 = np.array([
        float(energy.stiffness(**Cell(q.n, t, q.R - t / 2, q.L1, q.alpha).eqs, h=q.h, E=q.E))
        for t in b
    ])  # fmt: skip
    m = np.abs(k1 / k - 1)
    words = f"from {m[-1]:.1%} at L_0/b = {z[-1]:.0f} to {m[0]:.1%} at {z[0]:.0f}"
    return float(np.diff(m).min()), NOISE, words


def let_loose(context: Context) -> tuple[float, float, str]:
    """What a third of Eq. 9's force leaves above that of a free head at 0.3 of the length."""
    F = [r.values["F, free"] for r in context.fem]
    promised = context.analytic[f"k1 U, {SHARES[0]:g}"]
    words = f"{F[-1]:.3g} N, Eq. 9 promises {promised:.3g} N"
    return THIRD - F[-1] / promised, 3 * abs(F[-1] - F[-2]) / promised, words


def way(context: Context) -> Pair:
    """The forces at the end of the straight and the slanted way."""
    v = context.fem[-1].values
    m = v["F_x, straight"] / v["F_x, aside"] - 1
    words = f"{m:+.2%}; across, the spring holds {v['F_y, aside'] / v['F_x, aside']:+.1%} of it"
    return Pair(v["F_x, straight"], v["F_x, aside"], NOISE * v["F_x, aside"], words)


def warnings(q: MapInputs, v: Values) -> Sequence[str]:
    found = [NOT_FOUND] if v.get(f"F, {SHARES[0]:g}") is None and q.n <= MOST else []
    for share in SHARES:
        if F := v.get(f"F, {share:g}"):
            m = v[f"k1 U, {share:g}"] / F - 1
            if abs(m) > 0.02:
                found.append(
                    f"at {share:.0%} of the length Eq. 9 is {m:+.1%} off the guided spring's force"
                    " (leaves that touch not counted)"
                )
    return found


CHECKS = (
    *(
        Identity(name=f"force of the guided head at {share:.0%} of its length", symbol="F",
                 unit="N", analytic=f"F, {share:g}", fem=f"F, {share:g}", formal=4, demand=1e-3,
                 demand_reason="exact elastica and exact beam")
        for share in SHARES
    ),
    Identity(name="force along, where the roller's way ends", symbol="F_x", unit="N",
             analytic="F_x, aside", fem="F_x, aside", formal=4, demand=1e-3,
             demand_reason="exact elastica and exact beam"),
    Identity(name="force across, where the roller's way ends", symbol="F_y", unit="N",
             analytic="F_y, aside", fem="F_y, aside", formal=4, scale="F_x, aside", demand=1e-3,
             demand_reason="exact elastica and exact beam"),
    *(
        Approximation(name=f"Eq. 9 at {share:.0%} of the length, head guided", symbol="F",
                      unit="N", analytic=f"k1 U, {share:g}", fem=f"F, {share:g}", formal=4,
                      interval=None, source="measured: radius, guide and displacement")
        for share in SHARES
    ),
    Accepted(name="Eqs. 1-9 are within 10 % from L_0/b = 240 on, n <= 24, small displacement",
             symbol="k_1", unit="1", margin=within_claim, printed=("wang2023:k1-error-large-z",)),
    Accepted(name="error of Eqs. 1-9 at small displacement falls as L_0/b grows on one centre line",
             symbol="k_1", unit="1", margin=falls,
             printed=("wang2023:k1-error-large-z", "wang2023:rule-length-thickness-max")),
    Accepted(name="a free head bears less than a third of Eq. 9's force at 30 % of the length",
             symbol="F", unit="1", margin=let_loose),
    Agreement(name="a straight way stands for the roller's within 1 % of the force", symbol="F_x",
              unit="N", pair=way, accepted=WAY,
              source=suites("as far off as rows may be"), **demanded(WAY)),
    Contradiction(name="Eq. 9 against Eq. 10 at the tests' largest force", symbol="e_r", unit="%",
                  analytic="error at the tests' force", reference="wang2023:theory-fea-error-max",
                  erratum="wang2023:theory-error-six-percent"),
)  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    """The maps as solved; on the paper's numbers as measured more finely, where that was done."""
    q, finer = context.inputs, measured(DEEP_MAP) if context.is_paper else None
    if not context.fem:
        return ()
    found, over = [], []
    first = 0
    for name, cells in points(q, deep=finer is not None).items():
        if finer is None:
            k = mapped(context, name)
        else:
            parts = finer.parts[first : first + len(cells)]
            k = np.array([part.arrays["cells"] for part in parts])
            first += len(cells)
        m = errors(q, cells, k)
        found += map_figures.maps(name, m, finer.date if finer else "")
        over.append((np.array([[c.b / c.R for c in row] for row in cells]), m[..., 0]))
    return (*found, map_figures.radius(over))


MAP = Case(
    id="spring-map",
    title="Where Eqs. 1-9 of the accordion spring hold",
    paper="wang2023",
    place="Eqs. 1-9, Eqs. 12 and 13, Fig. 10; Sec. 1.2, Fig. 5 (way of the roller)",
    lead="The formula's error over thickness, segments, leaves and angle: at small displacement, "
    "where only the arcs' radius counts, and at the displacements that Eq. 12 allows, by "
    "geometrically exact beams without contact.",
    inputs=MapInputs,
    analytic=analytic,
    reference=fem,
    levels=(4, MAPPED, 16),
    scans=(
        Scan(vary=("n=8,10,14", "b=0.1mm,0.2mm"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        Output(key="k1", symbol="k_1", unit="N/mm", what="stiffness by Eqs. 1-9", judged=False),
        *(
            Output(key=f"F, {share:g}", symbol="F", unit="N",
                   what=f"force of the guided head at {share:.0%} of its length")
            for share in SHARES
        ),
        *(
            Output(key=f"k1 U, {share:g}", symbol="k_1 U", unit="N", what="the same by Eq. 9")
            for share in SHARES
        ),
        Output(key="F_x, straight", symbol="F_x", unit="N", judged=False,
               what="at the end of a straight way of the roller"),
        Output(key="F_x, aside", symbol="F_x", unit="N", what="at the end of its slanted way"),
        Output(key="F_y, aside", symbol="F_y", unit="N", what="and across"),
    ),
    readings=(
        "r is the inner radius: Eqs. 1-9 take it for the arcs' radius, finite elements r + b/2",
        "Eqs. 1-9 leave the head free to turn and to move sideways, a roller's slot guides it",
    ),
    assumptions=(
        "leaves do not touch: at 60 % of the length those of the paper's spring have touched",
        "narrow strip: E I without 1 − ν², on both sides",
        "the roller's way begins where the spring is unloaded, its head does not turn",
    ),
    warnings=warnings,
    too_large=too_large,
    equations=map_figures.equations,
    tables=map_figures.tables,
    sketch=sketch,
    figures=figures,
)  # fmt: skip

DEEP_MAP = Case(
    id="spring-map-deep",
    title="Where Eqs. 1-9 of the accordion spring hold, finer",
    paper="wang2023",
    place="Eqs. 1-9, Eqs. 12 and 13, Fig. 10",
    lead="The maps of spring-map with every number of segments and angle between.",
    inputs=MapInputs,
    analytic=lambda _: {},
    reference=deep_fem,
    levels=tuple(range(len(DEEP_SEGMENTS) + len(DEEP_ANGLES))),
    checks=(),
    outputs=(),
)  # fmt: skip
