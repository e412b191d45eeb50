"""A roller between rigid flats: Hertz's line contact, and the disc he simplifies."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.contact import disc_stress, hertz_line, hertz_line_approach
from analytic.contact.disc import disc_under_load
from analytic.contact.hertz_line_stress import largest_shear_stress
from verify.cases.contact.line import figures as contact_line_shown
from verify.cases.contact.line.checks import (
    BALANCES,
    FLOOR,
    LIMITS,
    SHARP,
    Coefficient,
    ProfileError,
    about,
    l2_errors,
    relative_uncertainty,
)
from verify.cases.contact.line.fem import Pressed
from verify.cases.contact.line.inputs import FlatInputs, too_small
from verify.cases.contact.line.warnings import warnings
from verify.core.case import Case, Context, FemResult, Output, Scan, Values
from verify.core.figures import Figure
from verify.judging.checks import Approximation, Fact, Identity, Limit

SWEEP = (0.015, 0.03, 0.06, 0.1, 0.15)  # Hertz's a/R
WIDEST = SWEEP[-1]
DEPTH = 5e-3  # of the depth of the largest shear


def analytic(q: FlatInputs) -> Values:
    E_plane = q.E / (1 - q.nu**2)
    values: dict[str, float] = {"P": q.P, "P R": q.P * q.R, "zero": 0.0, "one": 1.0}
    loads = {"": q.P} | {f", a/R = {e:g}": swept_load(q, e) for e in SWEEP}
    for where, P in loads.items():
        a = float(hertz_line.half_width(P=P, R=q.R, E_star=E_plane))
        p_0 = float(hertz_line.peak_pressure(P=P, R=q.R, E_star=E_plane))
        approach = hertz_line_approach.approach_to_centre(P=P, a=a, R=q.R, E_plane=E_plane)
        disc = disc_under_load(P=P, R=q.R, E_plane=E_plane)
        values |= {
            f"Hertz a{where}": a,
            f"Hertz p0{where}": p_0,
            f"Hertz approach{where}": float(approach),
            f"disc a{where}": disc.moment_width,
            f"disc p0{where}": disc.p_0,
            f"disc approach{where}": disc.approach,
        }
    disc = disc_under_load(P=q.P, R=q.R, E_plane=E_plane)
    shear, depth = disc_stress.largest_shear_stress(disc=disc)
    hertz_shear, hertz_depth = largest_shear_stress(a=values["Hertz a"], p_0=values["Hertz p0"])
    return values | {
        "a/R": values["Hertz a"] / q.R, "edge": disc.a, "disc shear": shear, "disc depth": depth,
        "Hertz shear": float(hertz_shear), "Hertz depth": float(hertz_depth),
    }  # fmt: skip


def fem(q: FlatInputs, level: int) -> FemResult:
    swept = {f", a/R = {e:g}": disc_fem(q, swept_load(q, e), e * q.R, level) for e in SWEEP}
    return disc_fem(q, q.P, q.guess, level).result(level, ("axis", "middle"), swept)


def swept_load(q: FlatInputs, ratio: float) -> float:
    """The load [N/m] for which Hertz's a/R is `ratio`."""
    return float(np.pi / 4 * ratio**2 * q.R / q.softness)


def disc_fem(q: FlatInputs, P: float, guess: float, level: int) -> Pressed:
    """The quarter of the disc on the flat y = 0 under the load P [N/m]."""
    from fem.contact.pairs import Obstacle, Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle, Flat
    from fem.plane.material import Elastic
    from meshes.contact.disc import quarter_disc

    def build(zone: float, cells: int, refine: int) -> ContactProblem:
        return ContactProblem(
            quarter_disc(R=q.R, zone=zone, cells=cells, refine=refine),
            materials=Elastic(E=q.E, nu=q.nu),
            assumption="plane strain",
            supports={"axis": "x", "middle": "y"},
            obstacles={"flat": Obstacle(Flat())},
            contacts=[
                Pair(slave="surface", master="flat", slave_shape=Circle((0.0, q.R), q.R))
            ],
        )  # fmt: skip

    return Pressed(build, level, P=P, guess=guess, arc=q.R, softness=q.softness, cut="middle")


def exact_pressure(context: Context, x: Any) -> Any:
    """The disc's pressure on its own arc."""
    q = context.inputs
    disc = disc_under_load(P=q.P, R=q.R, E_plane=q.E / (1 - q.nu**2))
    return disc.pressure(x) * np.sqrt(1 - (x / q.R) ** 2)


def series(coefficient: float, where: str = "") -> Any:
    """Interval of Hertz/FE - 1: coefficient (a/R)^2, known up to (a/R)^4, which counts once."""

    def interval(_: FlatInputs, v: Values) -> tuple[float, float] | None:
        e = WIDEST if where else v["a/R"]
        return about(coefficient * e**2, e**4, least=0.0 if where else FLOOR)

    return interval


def approach_series(where: str = "") -> Any:
    """The same for the approach: 9/16 (a/R)^2 in the bracket of the logarithm."""

    def interval(_: FlatInputs, v: Values) -> tuple[float, float] | None:
        e = WIDEST if where else v["a/R"]
        bracket = float(2 * np.log(4 / e) - 1)
        return about(-9 / 16 * e**2 / bracket, e**4, least=0.0 if where else FLOOR)

    return interval


def shear_series(_: FlatInputs, v: Values) -> tuple[float, float] | None:
    """What the opposite flat and the circle add to the shear, up to (a/R)^2, which counts once."""
    e = v["a/R"]
    m = 1 / (1 + float(disc_stress.shear_excess(a=e, R=1.0))) - 1
    return about(m, e**2, least=1e-3)


def depth_margin(context: Context) -> tuple[float, float]:
    """Where stresses that jump from cell to cell are largest follows no order: their spread counts.

    Three times that of the last three levels, as for any series without an order.
    """
    depths = np.array(context.series("depth")[1][-3:]) / context.analytic["disc depth"]
    return DEPTH - float(abs(depths[-1] - 1)), 3 * float(np.ptp(depths))


def deviations(key: str) -> Any:
    """Hertz/FE - 1 over a/R with the finest values and their uncertainty."""

    def points(context: Context) -> tuple[list[float], list[float], list[float]]:
        d, u = [], []
        for e in SWEEP:
            where = f"{key}, a/R = {e:g}"
            v = context.series(where)[1][-1]
            d.append(context.analytic[f"Hertz {where}"] / v - 1)
            u.append(relative_uncertainty(context, where))
        return list(SWEEP), d, u

    return points


NAMES = {"p0": ("peak pressure", "p_0", "MPa"), "a": ("half-width", "a", "µm"),
         "approach": ("approach of flat and centre", "δ", "µm")}  # fmt: skip
SERIES = "derived series of the disc; its next term, taken as 1 × (a/R)⁴"
INTERVALS = {"p0": series(-3 / 16), "a": series(1 / 4), "approach": approach_series()}
WIDE = {"p0": series(-3 / 16, "wide"), "a": series(1 / 4, "wide"),
        "approach": approach_series("wide")}  # fmt: skip
AT = f", a/R = {WIDEST:g}"

CHECKS = (
    *(
        Identity(name=f"{name}{where}, disc", symbol=symbol, unit=unit, fem=f"{key}{where}",
                 analytic=f"disc {key}{where}", formal=2, demand=SHARP[key], demand_reason=LIMITS)
        for where in ("", AT) for key, (name, symbol, unit) in NAMES.items()
    ),
    ProfileError(name="pressure profile, error in L2, disc", symbol="e_2", unit="1", fem="L2",
                 analytic="zero", scale="one", formal=1, demand=0.03, demand_reason=LIMITS,
                 errors=l2_errors(exact_pressure)),
    Identity(name="largest shear stress, disc", symbol="τ_max", unit="MPa", fem="shear",
             analytic="disc shear", formal=2),
    Fact(name=f"depth of the largest shear stress within {DEPTH:.1%} of the disc's", symbol="z",
         unit="1", margin=depth_margin),
    *(
        Approximation(name=f"{name}{where}, Hertz", symbol=symbol, unit=unit, fem=f"{key}{where}",
                      analytic=f"Hertz {key}{where}", formal=2, interval=intervals[key],
                      source=SERIES)
        for where, intervals in (("", INTERVALS), (AT, WIDE))
        for key, (name, symbol, unit) in NAMES.items()
    ),
    Approximation(name="largest shear stress, Hertz", symbol="τ_max", unit="MPa", fem="shear",
                  analytic="Hertz shear", formal=2, interval=shear_series,
                  source="derived: −0.693 a/R from the opposite flat and the circle; the next "
                  "term, taken as 1 × (a/R)²"),
    *(
        Limit(name=f"{name}, Hertz as a/R vanishes", symbol="d_0", unit="1",
              points=deviations(key), exponent=2, demand=SHARP[key], demand_reason=LIMITS)
        for key, (name, _, _) in NAMES.items() if key != "approach"
    ),
    *(
        Coefficient(name=f"{name}, Hertz over (a/R)²", symbol="c", unit="1",
                    points=deviations(key), theory=theory, demand=0.2,
                    demand_reason="tells the derived term from its parts, of a third and more")
        for (key, (name, _, _)), theory in zip(NAMES.items(), (-3 / 16, 1 / 4), strict=False)
    ),
    *BALANCES,
)  # fmt: skip

OUTPUTS = (
    Output(key="Hertz p0", symbol="p_0", unit="MPa", what="peak pressure, Hertz"),
    Output(key="disc p0", symbol="p_0", unit="MPa", what="peak pressure, disc"),
    Output(key="Hertz a", symbol="a", unit="µm", what="half-width, Hertz"),
    Output(key="disc a", symbol="a", unit="µm", what="half-width of the moments, disc"),
    Output(key="Hertz approach", symbol="δ", unit="µm",
           what="approach of one flat and the centre, Hertz with 2 ln(4R/a) − 1"),
    Output(key="disc approach", symbol="δ", unit="µm", what="the same, disc"),
    Output(key="Hertz shear", symbol="τ_max", unit="MPa", what="largest shear stress, Hertz"),
    Output(key="disc shear", symbol="τ_max", unit="MPa", what="the same, disc"),
    Output(key="Hertz depth", symbol="z", unit="µm", what="its depth, Hertz", judged=False),
    Output(key="disc depth", symbol="z", unit="µm", what="its depth, disc"),
    Output(key="a/R", symbol="a/R", unit="1", what="half-width over radius", judged=False),
)  # fmt: skip


def all_warnings(q: FlatInputs, v: Values) -> Sequence[str]:
    return warnings(q, v["Hertz a"], v["Hertz p0"], v["Hertz shear"])


def figures(context: Context) -> Sequence[Figure]:
    if not context.converging:
        return ()
    neglected = {key: deviations(key)(context) for key in ("p0", "a")}
    return contact_line_shown.flat_figures(context, exact_pressure, neglected)


FLAT = Case(
    id="contact-flat",
    title="Roller between rigid flats",
    paper="huang2018",
    place="Eqs. 2-5, the line contact behind them (Hertz)",
    lead="Hertz replaces a roller by a half plane and its circle by a parabola. Beside him stands "
    "the disc without these simplifications, which finite elements must meet; a sweep over a/R "
    "measures what Hertz's simplifications cost and finds the derived 3/16 (a/R)² of p_0.",
    inputs=FlatInputs,
    analytic=analytic,
    reference=fem,
    levels=(2, 3, 4, 6),
    scans=(Scan(vary=("F=100N:30000N:6:log", "nu=0,0.3,0.45"), star=True),),
    checks=CHECKS,
    outputs=OUTPUTS,
    readings=(
        "rollers are long: plane strain, E/(1 − ν²)",
        "the load per length is F/L, and R a radius",
        "the approach is that of one flat and the roller's centre; two flats approach by twice it",
    ),
    assumptions=(
        "linear elasticity, no friction, ends of the roller left out",
        "the other flat presses as much: a quarter whose cut through the centre moves as a line",
        "half-width from the moments of the pressure, 2 √(∫p x²/∫p), which is Hertz's a for his "
        "pressure",
        "meshes have a vertex where a coarse solution says that contact ends",
    ),
    warnings=all_warnings,
    too_large=too_small,
    equations=contact_line_shown.flat_equations,
    sketch=contact_line_shown.flat_sketch,
    figures=figures,
    pictures=contact_line_shown.pictures,
)
