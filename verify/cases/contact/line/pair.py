"""Two rollers with parallel axes: Hertz's line contact between bodies of one size."""

from collections.abc import Sequence
from typing import Any

from analytic.contact import hertz_line, hertz_line_approach, pair_series
from analytic.contact.disc_stress import shear_excess
from analytic.contact.hertz_line_stress import largest_shear_stress, tilted_shear_excess
from verify.cases.contact.line import figures as contact_line_shown
from verify.cases.contact.line.checks import BALANCES, about, hertz_profile
from verify.cases.contact.line.fem import Pressed
from verify.cases.contact.line.inputs import PairInputs, too_small
from verify.cases.contact.line.unlike import UNLIKE, WHERE, unlike, unlike_values
from verify.cases.contact.line.warnings import warnings
from verify.core.case import Case, FemResult, Output, Scan, Values
from verify.judging.checks import Approximation

BLUNT = 1e-3  # of Hertz's shear over the finite elements': smoothed stresses are no sharper


def analytic(q: PairInputs) -> Values:
    R = float(hertz_line.relative_radius(R_1=q.R_1, R_2=q.R_2))
    E_star = float(hertz_line.contact_modulus(**q.materials, assumption="plane strain"))
    a = float(hertz_line.half_width(P=q.P, R=R, E_star=E_star))
    p_0 = float(hertz_line.peak_pressure(P=q.P, R=R, E_star=E_star))
    shear, depth = largest_shear_stress(a=a, p_0=p_0)
    approach = sum(
        float(hertz_line_approach.approach_to_centre(P=q.P, a=a, R=R_i, E_plane=E / (1 - nu**2)))
        for R_i, E, nu in ((q.R_1, q.E_1, q.nu_1), (q.R_2, q.E_2, q.nu_2))
    )
    kappa = pair_series.meeting_curvature(
        R_1=q.R_1, R_2=q.R_2, **q.materials, assumption="plane strain"
    )
    p, w = pair_series.excess(a=a, R_1=q.R_1, R_2=q.R_2, **q.materials, assumption="plane strain")
    return {
        "P": q.P, "P R": q.P * q.R_1, "R": R, "E*": E_star, "Hertz a": a, "Hertz p0": p_0,
        "Hertz approach": approach, "Hertz shear": float(shear), "Hertz depth": float(depth),
        "series p0": p_0 * (1 + p.total), "series a": a * (1 + w.total),
        "excess p0": p.total, "excess a": w.total, "coupled": abs(p.first) + abs(w.first),
        "kappa a": kappa * a, **unlike_values(q),
    }  # fmt: skip


def fem(q: PairInputs, level: int) -> FemResult:
    soft = {f", {WHERE}": pair_fem(unlike(q), level)}
    return pair_fem(q, level).result(level, ("upper.axis", "upper.middle"), soft)


def pair_fem(q: PairInputs, level: int) -> Pressed:
    """Quarters of both rollers under the load."""
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle
    from fem.plane.material import Elastic
    from meshes.contact.disc import quarter_disc
    from meshes.join import join

    def build(zone: float, cells: int, refine: int) -> ContactProblem:
        fine: dict[str, Any] = {"zone": zone, "cells": cells, "refine": refine}
        return ContactProblem(
            join({"upper": quarter_disc(R=q.R_1, **fine),
                  "lower": quarter_disc(R=q.R_2, below=True, **fine)}),
            materials={"upper": Elastic(E=q.E_1, nu=q.nu_1), "lower": Elastic(E=q.E_2, nu=q.nu_2)},
            assumption="plane strain",
            supports={"upper.axis": "x", "lower.axis": "x",
                      "upper.middle": "y", "lower.middle": "y"},
            contacts=[
                Pair(slave="upper.surface", master="lower.surface",
                     slave_shape=Circle((0.0, q.R_1), q.R_1),
                     master_shape=Circle((0.0, -q.R_2), q.R_2))
            ],
        )  # fmt: skip

    return Pressed(
        build, level, P=q.P, guess=q.guess, arc=q.R_1, softness=q.softness, cut="upper.middle"
    )


def second_order(key: str) -> Any:
    """Interval of Hertz/FE - 1 for p_0 or a: the series, whose next terms count once.

    These are the square of its terms, and the first-order one times a/R.
    """

    def interval(q: PairInputs, v: Values) -> tuple[float, float] | None:
        e = v["Hertz a"] / q.smallest
        m = 1 / (1 + v[f"excess {key}"]) - 1
        return about(m, (v["coupled"] + e**2) ** 2 + v["coupled"] * e)

    return interval


def approach_bound(q: PairInputs, v: Values) -> tuple[float, float] | None:
    """The brackets, 4 and more, change by about (a/R)^2 and by what the materials couple."""
    return about(0.0, (v["Hertz a"] / q.smallest) ** 2 / 2 + v["coupled"])


def shear_bound(q: PairInputs, v: Values) -> tuple[float, float] | None:
    """Both first-order terms; (a/R)^2, of equal discs 0.57 of it, and the coupling count once."""
    first = float(shear_excess(a=v["Hertz a"], R=q.R_1)) + tilted_shear_excess(v["kappa a"])
    e = v["Hertz a"] / q.smallest
    return about(1 / (1 + first) - 1, e**2 + v["coupled"], least=BLUNT)


SERIES = "derived series of two discs; its next terms count once, 3e-4 at least"

CHECKS = (
    Approximation(name="peak pressure, Hertz", symbol="p_0", unit="MPa", fem="p0",
                  analytic="Hertz p0", formal=2, interval=second_order("p0"), source=SERIES),
    Approximation(name="half-width, Hertz", symbol="a", unit="µm", fem="a", analytic="Hertz a",
                  formal=2, interval=second_order("a"), source=SERIES),
    Approximation(name="approach of the centres, Hertz", symbol="δ", unit="µm", fem="approach",
                  analytic="Hertz approach", formal=2, interval=approach_bound,
                  source="argued: (a/R)²/2 and the coupling of unlike materials, 3e-4 at least"),
    Approximation(name="largest shear stress, Hertz", symbol="τ_max", unit="MPa", fem="shear",
                  analytic="Hertz shear", formal=2, interval=shear_bound,
                  source="derived: −0.693 a/R_1 of a flat, −0.093 κa of inclined pressure; (a/R)² "
                  "and what unlike materials couple count once, 1e-3 at least"),
    *UNLIKE,
    hertz_profile(),
    *BALANCES,
)  # fmt: skip

TWO_BODY_OUTPUTS = (
    Output(key="R", symbol="R", unit="mm", what="relative radius", judged=False),
    Output(key="E*", symbol="E*", unit="GPa", what="contact modulus", judged=False),
    Output(key="Hertz p0", symbol="p_0", unit="MPa", what="peak pressure, Hertz"),
    Output(key="Hertz a", symbol="a", unit="µm", what="half-width, Hertz"),
    Output(key="Hertz shear", symbol="τ_max", unit="MPa", what="largest shear stress, Hertz"),
    Output(key="Hertz depth", symbol="z", unit="µm", what="its depth, Hertz", judged=False),
)


def all_warnings(q: Any, v: Values) -> Sequence[str]:
    return warnings(q, v["Hertz a"], v["Hertz p0"], v["Hertz shear"])


PAIR = Case(
    id="contact-pair",
    title="Two rollers with parallel axes",
    paper="huang2018",
    place="Eqs. 2-5, the line contact behind them (Hertz)",
    lead="A sprag's nose on the inner race, as two elastic rollers of different size. What Hertz "
    "neglects here is derived to the second order in a/R, with the inclination of the surface on "
    "which the bodies meet, and finite elements must fall on it.",
    inputs=PairInputs,
    analytic=analytic,
    reference=fem,
    levels=(2, 3, 4, 6),
    scans=(Scan(vary=("F=300N,1000N,3407N,10000N,20000N", "R_2=4.02mm,11.11mm,50mm"), star=True),),
    checks=CHECKS,
    outputs=(
        *TWO_BODY_OUTPUTS,
        Output(
            key="series p0",
            symbol="p_0",
            unit="MPa",
            what="peak pressure, second order",
            judged=False,
        ),
        Output(
            key="series a", symbol="a", unit="µm", what="half-width, second order", judged=False
        ),
        Output(key="Hertz approach", symbol="δ", unit="µm", what="approach of the centres"),
    ),
    readings=(
        "rollers are long: plane strain, E/(1 − ν²) of each",
        "R_1 and R_2 are radii, and their curvatures add up",
        "the approach is that of the centres, each roller being pressed from its far side, too",
    ),
    assumptions=(
        "linear elasticity, no friction, ends of the rollers left out",
        "each roller pressed from both sides: quarters whose cuts move as lines",
        "contact acts along the normal of the surface on which the deformed bodies meet",
        "meshes have a vertex where a coarse solution says that contact ends",
    ),
    warnings=all_warnings,
    too_large=too_small,
    equations=contact_line_shown.pair_equations,
    sketch=contact_line_shown.pair_sketch,
    figures=contact_line_shown.two_body_figures,
    pictures=contact_line_shown.pictures,
)
