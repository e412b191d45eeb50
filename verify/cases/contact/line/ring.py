"""A roller in a concave race whose rim is held: Hertz's line contact inside a ring."""

from dataclasses import replace
from typing import Any

import numpy as np

from analytic.contact import clamped_race, hertz_line, hertz_line_approach
from analytic.contact.disc_stress import shear_excess
from analytic.contact.hertz_line_stress import largest_shear_stress, tilted_shear_excess
from analytic.contact.pair_series import CATALAN, meeting_curvature
from analytic.contact.partial_slip import dundurs_beta
from verify.cases.contact.line import figures as contact_line_shown
from verify.cases.contact.line.checks import BALANCES, about, hertz_profile
from verify.cases.contact.line.fem import Pressed
from verify.cases.contact.line.inputs import RaceInputs, too_small
from verify.cases.contact.line.pair import BLUNT, TWO_BODY_OUTPUTS, all_warnings
from verify.core.case import Case, FemResult, Output, Scan, Values
from verify.judging.checks import Approximation

THICKEST = 8.0  # r_o/r_i
THINNEST = 0.08  # wall over r_i: the whole bore may touch, and half a minute goes by there


def analytic(q: RaceInputs) -> Values:
    R = float(hertz_line.relative_radius(R_1=q.R, R_2=-q.r_i))
    E_star = float(hertz_line.contact_modulus(**q.materials, assumption="plane strain"))
    a = float(hertz_line.half_width(P=q.P, R=R, E_star=E_star))
    p_0 = float(hertz_line.peak_pressure(P=q.P, R=R, E_star=E_star))
    shear, depth = largest_shear_stress(a=a, p_0=p_0)
    roller = float(
        hertz_line_approach.approach_to_centre(P=q.P, a=a, R=q.R, E_plane=q.E_1 / (1 - q.nu_1**2))
    )
    race = clamped_race.approach_to_rim(
        P=q.P, a=a, r_i=q.r_i, r_o=q.r_o, E=q.E_2, nu=q.nu_2, assumption="plane strain"
    )
    beta = float(dundurs_beta(**q.materials, assumption="plane strain"))
    kappa = meeting_curvature(R_1=q.R, R_2=-q.r_i, **q.materials, assumption="plane strain")
    return {
        "P": q.P, "P R": q.P * q.R, "R": R, "E*": E_star, "Hertz a": a, "Hertz p0": p_0,
        "Hertz approach": roller + race, "roller": roller, "race": race,
        "Hertz shear": float(shear), "Hertz depth": float(depth), "coupled": beta * kappa * a,
        "kappa a": kappa * a,
    }  # fmt: skip


def fem(q: RaceInputs, level: int) -> FemResult:
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle
    from fem.plane.material import Elastic
    from meshes.contact.disc import quarter_disc
    from meshes.contact.race import half_race
    from meshes.join import join

    def build(zone: float, cells: int, refine: int) -> ContactProblem:
        fine: dict[str, Any] = {"zone": zone, "cells": cells, "refine": refine}
        return ContactProblem(
            join({"roller": quarter_disc(R=q.R, **fine),
                  "race": half_race(r_i=q.r_i, r_o=q.r_o, **fine)}),
            materials={"roller": Elastic(E=q.E_1, nu=q.nu_1), "race": Elastic(E=q.E_2, nu=q.nu_2)},
            assumption="plane strain",
            supports={"roller.axis": "x", "race.axis": "x",
                      "roller.middle": "y", "race.rim": "xy"},
            contacts=[
                Pair(slave="roller.surface", master="race.bore",
                     slave_shape=Circle((0.0, q.R), q.R),
                     master_shape=Circle((0.0, q.r_i), q.r_i, hollow=True))
            ],
        )  # fmt: skip

    contact = Pressed(
        build, level, P=q.P, guess=q.guess, arc=q.R, softness=q.softness, cut="roller.middle"
    )
    return contact.result(level, ("roller.axis", "roller.middle"))


def too_large(q: RaceInputs) -> str:
    """Cells about the contact are carried far into a thick wall, and are coarse there.

    In a thin wall they are no longer than it all around the bore, any part of which may touch:
    the compliance of so many points takes minutes.
    """
    wall = q.r_o - q.r_i
    if wall < THINNEST * q.r_i:
        return (
            f"a wall of {wall * 1e3:.4g} mm is below {THINNEST:.0%} of r_i: finite elements as "
            "short as that all around the bore take minutes, check it without --fem"
        )
    if q.r_o > THICKEST * q.r_i:
        return (
            f"r_o = {q.r_o / q.r_i:.3g} r_i is more than {THICKEST:g} r_i: finite elements are "
            "not sharp in a block so large, check it without --fem"
        )
    return too_small(q)


def small(q: RaceInputs, v: Values) -> float:
    """(a/R)^2 + (a/wall)^2: what curvature and the held rim change, each counted once."""
    a = v["Hertz a"]
    return float((a / q.R) ** 2 + (a / (q.r_o - q.r_i)) ** 2)


def bounded(first: float) -> Any:
    """Interval of Hertz/FE - 1: `first` times beta kappa a, and `small` either way."""

    def interval(q: RaceInputs, v: Values) -> tuple[float, float] | None:
        coupled = v["coupled"]
        m = 1 / (1 + first * coupled) - 1
        return about(m, small(q, v) + abs(coupled) * v["Hertz a"] / q.smallest)

    return interval


def approach_bound(q: RaceInputs, v: Values) -> tuple[float, float] | None:
    """Half of `small`, as the brackets are 2 and more, and all that the materials couple."""
    return about(0.0, small(q, v) / 2 + abs(v["coupled"]))


def shear_bound(q: RaceInputs, v: Values) -> tuple[float, float] | None:
    """Both first-order terms; `small`, and what the materials couple, each counted once."""
    first = float(shear_excess(a=v["Hertz a"], R=q.R)) + tilted_shear_excess(v["kappa a"])
    return about(1 / (1 + first) - 1, small(q, v) + abs(v["coupled"]), least=BLUNT)


BOUND = "argued: (a/R)² of the curvature and (a/wall)² of the held rim, each once"

CHECKS = (
    Approximation(name="peak pressure, Hertz", symbol="p_0", unit="MPa", fem="p0",
                  analytic="Hertz p0", formal=2, interval=bounded(-(2 * CATALAN - 1 / 3) / np.pi),
                  source=BOUND),
    Approximation(name="half-width, Hertz", symbol="a", unit="µm", fem="a", analytic="Hertz a",
                  formal=2, interval=bounded(64 / (45 * np.pi)), source=BOUND),
    Approximation(name="approach of centre and rim", symbol="δ", unit="µm", fem="approach",
                  analytic="Hertz approach", formal=2, interval=approach_bound,
                  source="argued: half of (a/R)² + (a/wall)², and what unlike materials couple"),
    Approximation(name="largest shear stress, Hertz", symbol="τ_max", unit="MPa", fem="shear",
                  analytic="Hertz shear", formal=2, interval=shear_bound,
                  source="derived: −0.693 a/R of a flat, −0.093 κa of inclined pressure; (a/R)², "
                  "(a/wall)² and what unlike materials couple count once, 1e-3 at least"),
    hertz_profile(),
    *BALANCES,
)  # fmt: skip

RING = Case(
    id="contact-ring",
    title="Roller in a race",
    paper="huang2018",
    place="Eqs. 2-5, the line contact behind them (Hertz)",
    lead="A roller of the sprag's radius in the outer race. The bore bends the same way as the "
    "roller, which widens the contact, and the wall is some fifty half-widths thick; "
    "how far centre and held rim approach is derived from the ring's own Fourier series.",
    inputs=RaceInputs,
    analytic=analytic,
    reference=fem,
    levels=(2, 3, 4, 6),
    scans=(
        Scan(
            vary=("F=1000N,3407N,10000N,20000N", "r_i=8mm,12mm,19.44mm", "r_o=22mm,26.23mm,40mm"),
            star=True,
        ),
    ),
    checks=CHECKS,
    outputs=(
        *(replace(o, symbol="R'") if o.key == "R" else o for o in TWO_BODY_OUTPUTS),
        Output(
            key="Hertz approach",
            symbol="δ",
            unit="µm",
            what="approach of the roller's centre and the rim",
        ),
        Output(
            key="roller",
            symbol="δ_1",
            unit="µm",
            what="part of the approach, in the roller",
            judged=False,
        ),
        Output(
            key="race",
            symbol="δ_2",
            unit="µm",
            what="part of the approach, in the race",
            judged=False,
        ),
    ),
    readings=(
        "rollers are long: plane strain, E/(1 − ν²) of each",
        "the bore's curvature is taken off the roller's: 1/R − 1/r_i, of radii",
        "the approach is that of the roller's centre and the race's rim, which is held all around",
    ),
    assumptions=(
        "linear elasticity, no friction, ends of the roller left out",
        "the roller pressed from both sides: a quarter whose cut moves as a line",
        "one roller, the rim held all around in both directions: half a race",
        "contact acts along the normal of the surface on which the deformed bodies meet",
        "meshes have a vertex where a coarse solution says that contact ends",
    ),
    warnings=all_warnings,
    too_large=too_large,
    equations=contact_line_shown.ring_equations,
    sketch=contact_line_shown.ring_sketch,
    figures=contact_line_shown.two_body_figures,
    pictures=contact_line_shown.pictures,
)
