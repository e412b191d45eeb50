"""Lateral buckling of an accordion spring: Haringx's column, the elastica, finite elements."""

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from analytic.spring import column, frame, stability
from analytic.spring.elastica import Elastica
from verify.cases.spring.buckling import figures as shown
from verify.cases.spring.buckling.fem import SWEPT, fem
from verify.cases.spring.buckling.inputs import DRIFT, MANY, RATIO, TAILS, BucklingInputs
from verify.cases.spring.sketch import sketch
from verify.core.case import Case, Context, Output, Scan, Values
from verify.core.results import Row
from verify.judging.checks import Accepted, Approximation, Identity, Limit
from verify.judging.tolerance_checks import Agreement, Pair, suites

MOST = 24  # segments of an elastica that a check has time for
SEARCHED = np.linspace(0.05, 0.75, 15)  # of the free length, for critical points
CUBE = 1e-3  # of the exponent, which strain and shear change by (b/L_1)^2
KNOWN = (1e-3, 0.015)  # least and largest share of U_cr within which end effects are known
SPREAD = 0.005  # of U_cr over a fourfold thickness
HINGED_TO = 0.7  # of the free length
NOT_FOUND = "no equilibrium of the elastica was found on the way to a critical point"
NOISE = 1e-5  # rounding of finite elements of slender springs, times what it is seen as


def elastica(q: BucklingInputs, tail: frame.Tail) -> Elastica:
    EA = q.E * q.h * q.b
    GA = 5 / 6 * EA / (2 * (1 + q.nu))
    return Elastica(frame.pieces(**q.path, tail=tail), EI=EA * q.b**2 / 12, EA=EA, GA=GA)


@lru_cache(maxsize=8)
def critical_point(q: BucklingInputs, tail: frame.Tail) -> Values:
    """The critical point of the elastica with a free head, and its drift before.

    Empty where the determinant keeps its sign in all states of the path. ArithmeticError where a
    state is not found, which says nothing about the spring. Small steps first, since slender
    springs buckle early.
    """
    line = elastica(q, tail)
    load = line.linear_load()
    start = load * _flexibility(q, tail) / q.length
    steps = np.concatenate([min(start, 0.05) * np.linspace(0.5, 1.5, 3), SEARCHED])
    found = stability.critical(line, "free", np.unique(steps) * q.length)
    if found is None:
        return {}
    values = {f"U_cr, {tail}": found.U, f"F_cr, {tail}": found.F}
    values[f"F_lin, {tail}"] = load
    values[f"k_y, {tail}"] = stability.lateral_stiffness(line.unloaded())
    state = line.unloaded()
    for share in sorted({*np.linspace(0.2, 0.8, 4), *DRIFT}):
        state = line.pushed((share * q.P, 0.0), state)
        if share in DRIFT:
            values[f"drift {share:g} P, {tail}"] = state.drift
    return values


def _flexibility(q: BucklingInputs, tail: frame.Tail) -> float:
    return 1 / frame.stiffness(**q.path, **q.strip, head="guided", tail=tail, theory="shear")


def analytic(q: BucklingInputs) -> Values:
    unit = column.unit(L1=q.L1, radius=q.R, alpha=q.alpha, **q.strip)
    values = {
        "unit turn": float(1 / unit.turn), "unit axial": float(1 / unit.axial),
        "unit lateral": float(1 / unit.lateral), "L": q.length,
    }  # fmt: skip
    heads: tuple[column.Head, ...] = ("free", "hinged", "guided")
    for head in heads:
        xi = float(column.critical_shortening(head, **q.path, b=q.b, nu=q.nu))
        if math.isfinite(xi):
            values[f"Haringx U, {head}"] = xi * q.length
            values[f"Haringx F, {head}"] = float(column.critical_force(head, **q.path, **q.strip))
    if q.n <= MOST:
        for tail in TAILS:
            with suppress(ArithmeticError):  # values are missing; `too_large` and `warnings` say so
                values |= critical_point(q, tail)
    if q.F is not None:
        values["deflection"] = q.F / frame.stiffness(
            **q.path, **q.strip, head="guided", tail="arc", theory="shear"
        )
    return values


def too_large(q: BucklingInputs) -> str:
    if q.n > MOST:
        return (
            f"n = {q.n} segments are more than {MOST}: the elastica takes too long; Haringx's "
            "column is right within 3 % there, check it without --fem"
        )
    heads = math.isfinite(float(column.critical_shortening("free", **q.path, b=q.b, nu=q.nu)))
    try:
        if heads and all(critical_point(q, tail) for tail in TAILS):
            return ""
    except ArithmeticError as error:
        return f"{NOT_FOUND} ({error}): check it without --fem"
    return (
        "this spring is too short to buckle sideways before its leaves meet: there is nothing "
        "to compare, check it without --fem"
    )


def swept(context: Context, name: str) -> Any:
    """An array of the level on which sweeps are made."""
    return next(r.arrays[name] for r in context.fem if name in r.arrays)


def spread(context: Context) -> Pair:
    """Largest and least U_cr over thicknesses on one centre line."""
    b, U, _ = swept(context, "by b").T
    apart = float(np.ptp(U) / U.mean())
    z = context.inputs.length / b
    words = f"{apart:.2%} while L_0/b falls from {z[0]:.0f} to {z[-1]:.0f}"
    return Pair(float(U.max()), float(U.min()), NOISE * float(U.min()), words)


def by_cube(context: Context) -> Pair:
    """The exponent of b in F_cr, between neighbours where it is farthest from three, and three."""
    b, _, F = np.log(swept(context, "by b")).T
    slope = np.diff(F) / np.diff(b)
    worst = float(slope[np.abs(slope - 3).argmax()])
    return Pair(worst, 3.0, NOISE, f"slope {worst:.5f}")


def one_ratio(context: Context) -> tuple[float, float, str]:
    """How much more than a factor of five U_cr/L_0 of springs with the same L_0/b differs."""
    xi = swept(context, "same ratio")
    return (float(xi.max() / xi.min() - 5), 0.01,
            f"U_cr/L_0 from {xi.min():.2%} to {xi.max():.1%} at L_0/b = {RATIO:g}")  # fmt: skip


def stays(tail: str) -> Callable[[Context], tuple[float, float, str]]:
    """The least determinant of a free head's path over that at rest: zero at a critical point."""

    def margin(context: Context) -> tuple[float, float, str]:
        F, U, _, left = swept(context, f"free, {tail}").T
        k = int(left.argmin())
        share = U[-1] / context.inputs.length
        return float(left[k]), 1e-3, (
            f"{left[k]:.1%} of the determinant is left at {F[k]:.3g} N, none is lost up to "
            f"{share:.0%} of the length"
        )  # fmt: skip

    return margin


def hinged(tail: str) -> Callable[[Context], tuple[float, float, str]]:
    """The same of a hinged head on the guided path."""

    def margin(context: Context) -> tuple[float, float, str]:
        left = swept(context, f"guided, {tail}")[:, 3]
        return float(left.min()), 1e-3, f"{left.min():.0%} of the determinant is left"

    return margin


def many_units(context: Context) -> tuple[list[float], list[float], list[float]]:
    """Haringx over finite elements with more and more units, over the shortening itself.

    The ends that are no units are 1/n of the spring, and the shortening is as 1/n^2.
    """
    q = context.inputs
    xi = column.critical_shortening("free", **q.path | {"n": np.array(MANY)}, b=q.b, nu=q.nu)
    d = xi / swept(context, "many") - 1
    return xi.tolist(), d.tolist(), (NOISE * (np.array(MANY) / 10) ** 2).tolist()


@dataclass(frozen=True, kw_only=True)
class PaperLimit(Limit):
    """A limit of the formula, told once: on the paper's strip."""

    paper_only = True

    def rows(self, context: Context) -> list[Row]:
        return super().rows(context) if context.is_paper else []


def warnings(q: BucklingInputs, v: Values) -> Sequence[str]:
    found = []
    if (free := v.get("Haringx U, free")) is None:
        return ["too short to buckle sideways, whatever holds the head"]
    if q.F is not None:
        U, least = v["deflection"], min(free, *(v.get(f"U_cr, {t}", free) for t in TAILS))
        for head, limit in (("free", least), ("hinged", v.get("Haringx U, hinged"))):
            if limit is not None and limit < U:
                found.append(
                    f"F = {q.F:g} N compresses by {U * 1e3:.3g} mm; with a {head} head the "
                    f"spring buckles at {limit * 1e3:.3g} mm: the head needs a guide"
                )
    if q.n > MOST:
        found.append(f"more than {MOST} segments: by Haringx's column alone")
    elif missing := [tail for tail in TAILS if f"U_cr, {tail}" not in v]:
        found.append(f"no critical point of the elastica was found, tail {' and '.join(missing)}")
    return found


WHERE: dict[frame.Tail, str] = {"arc": "tail held at its arc", "mid-leaf": "tail held at mid-leaf"}
CHECKS = (
    *(
        Identity(name=f"stiffness of a middle unit, {what}", symbol=symbol, unit=unit,
                 analytic=f"unit {key}", fem=f"unit {key}", formal=4, demand=5e-4,
                 demand_reason="one unit, a few curved elements")
        for key, symbol, unit, what in (
            ("turn", "1/a_B", "N m", "against a couple"),
            ("axial", "1/a_C", "N/mm", "along"), ("lateral", "1/a_S", "N/mm", "across"),
        )
    ),
    *(
        Identity(name=f"{what}, {where}", symbol=symbol, unit=unit, analytic=f"{key}, {tail}",
                 fem=f"{key}, {tail}", formal=4, demand=1e-3,
                 demand_reason="exact elastica and exact beam")
        for tail, where in WHERE.items()
        for key, symbol, unit, what in (
            ("U_cr", "U_cr", "mm", "displacement at which the spring with a free head buckles"),
            ("F_cr", "F_cr", "N", "force at which the spring with a free head buckles"),
            ("F_lin", "F_lin", "N", "linear buckling load of the undeformed spring"),
            ("k_y", "k_y", "N/mm", "lateral stiffness of the guided head, unloaded"),
            *((f"drift {share:g} P", "u_y", "mm", f"drift of a free head under {share:g} P")
              for share in DRIFT),
        )
    ),
    *(
        Approximation(name=f"Haringx's column, {where}", symbol="U_cr", unit="mm",
                      analytic="Haringx U, free", fem=f"U_cr, {tail}", formal=4,
                      interval=None, source="measured: ends that are no units")
        for tail, where in WHERE.items()
    ),
    PaperLimit(name="Haringx's column with ever more units, tail held at its arc", symbol="U_cr",
               unit="1", points=many_units, exponent=0.5),
    Agreement(name="the buckling force grows with the cube of the thickness", symbol="q", unit="1",
              pair=by_cube, accepted=CUBE / 3,
              source=suites("strain and shear change it by (b/L_1)², far less"), by="theory"),
    Agreement(name="U_cr is the same for a fourfold thickness on one centre line", symbol="U_cr",
              unit="mm", pair=spread, accepted=SPREAD,
              source=suites("half of the 1 % that rows are asked for")),
    Accepted(name="springs of one L_0/b buckle at displacements that differ fivefold",
             symbol="U_cr/L_0", unit="1", margin=one_ratio,
             printed=("wang2023:rule-length-thickness-max",)),
    *(
        Accepted(name=f"a free head drifts without a critical point, {where}", symbol="det",
                 unit="1", margin=stays(tail))
        for tail, where in WHERE.items()
    ),
    *(
        Accepted(name=f"a spring with a hinged head does not buckle up to {HINGED_TO:.0%} of L_0, "
                      f"{where}", symbol="det", unit="1", margin=hinged(tail))
        for tail, where in WHERE.items()
    ),
)  # fmt: skip

BUCKLING = Case(
    id="spring-buckling",
    title="Lateral buckling of an accordion spring",
    paper="wang2023",
    place="Sec. 3, Eq. 13, Fig. 11 (lateral displacement)",
    lead="How far a spring can be pressed before only a guide keeps its head in line: Haringx's "
    "column of the spring's own units, the exact elastica of its leaves and arcs, and "
    "geometrically exact beams.",
    inputs=BucklingInputs,
    analytic=analytic,
    reference=fem,
    levels=(4, SWEPT, 16),
    scans=(Scan(vary=("n=8,10,14", "b=0.1mm,0.2mm"), star=True),),
    checks=CHECKS,
    outputs=(
        Output(
            key="U_cr, arc",
            symbol="U_cr",
            unit="mm",
            what="buckling with a free head, tail held at its arc",
        ),
        Output(key="F_cr, arc", symbol="F_cr", unit="N", what="the force there"),
        Output(
            key="U_cr, mid-leaf",
            symbol="U_cr",
            unit="mm",
            what="buckling with a free head, tail held at mid-leaf",
        ),
        Output(key="F_cr, mid-leaf", symbol="F_cr", unit="N", what="the force there"),
        Output(
            key="Haringx U, free",
            symbol="U_cr",
            unit="mm",
            what="buckling with a free head, by Haringx's column",
        ),
        Output(key="Haringx F, free", symbol="F_cr", unit="N", what="the force there"),
        Output(
            key="Haringx U, hinged",
            symbol="U_cr",
            unit="mm",
            judged=False,
            what="buckling with a hinged head, by Haringx's column",
        ),
        Output(
            key="Haringx U, guided",
            symbol="U_cr",
            unit="mm",
            judged=False,
            what="buckling of a guided spring between its ends, by Haringx's column",
        ),
        Output(
            key="k_y, arc",
            symbol="k_y",
            unit="N/mm",
            what="lateral stiffness of the guided head, unloaded",
        ),
        Output(
            key="deflection",
            symbol="U_w",
            unit="mm",
            judged=False,
            what="displacement at F, head guided, small displacements",
        ),
    ),
    readings=(
        "a free head: the force keeps its direction and acts at O, which moves sideways and turns",
        "buckles: pressed with its head guided and released, the head can move without a change "
        "of load; what the guide exerted stays as a dead load",
        "r is the inner radius: the centre line of the arcs has r + b/2",
    ),
    assumptions=(
        "leaves do not touch: the paper's spring buckles before they do",
        "narrow strip: E I without 1 − ν², which forces carry and displacements do not",
        "tail clamped, at the end of its arc or in the middle of its leaf",
    ),
    warnings=warnings,
    too_large=too_large,
    equations=shown.equations,
    tables=shown.tables,
    sketch=sketch,
    figures=shown.figures,
)
