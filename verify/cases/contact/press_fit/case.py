"""Press fit: a race in its housing, two walls that contact alone joins (Lamé twice)."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import model_validator

from analytic.contact.checks import Assumption
from analytic.contact.press_fit import Wall, contact_pressures, pressure_of_overlap
from verify.cases.contact.press_fit import figures as shown
from verify.core.case import Case, FemResult, Output, Scan, Values
from verify.core.figures import Field
from verify.core.inputs import Inputs, quantity
from verify.judging.checks import Exact, Identity

if TYPE_CHECKING:
    from fem.contact.solution import ContactSolution

FITS: tuple[tuple[str, Assumption], ...] = (
    ("rings", "plane stress"), ("rings", "plane strain"), ("drawn", "plane strain"),
    ("shaft", "plane stress"),
)  # fmt: skip
SMOOTH = "smooth fields on curved quadratic cells: much sharper than 1 % at no cost"
MOST_CELLS = 400_000
LOUDEST = 1e-3  # share of the pressure up to which rounded positions may scatter it
AROUND = 150  # about the finest mesh's nodes on a quarter
EPS = float(np.finfo(np.float64).eps)
THINNEST = 0.04  # wall over r_f that the cells around are short against


class FitInputs(Inputs):
    """A ring pressed into another one, both under pressure; or a solid shaft in the outer one."""

    r_i: float = quantity(
        "19.44 mm", "mm", "r_i", "bore radius of the inner ring", gt=0, le=1e5,
        claims="huang2018:table1-r-e",
    )  # fmt: skip
    r_f: float = quantity(
        "26.23 mm", "mm", "r_f", "nominal radius of the fit", gt=0, le=1e5,
        claims="huang2018:table1-r-ed",
    )  # fmt: skip
    r_o: float = quantity("40 mm", "mm", "r_o", "rim radius of the outer ring", gt=0, le=1e5)
    delta: float = quantity(
        "15 µm", "µm", "δ", "interference, of the radii (half that of the diameters)", gt=0, le=1e6
    )
    p_i: float = quantity(
        "37 MPa", "MPa", "p_i", "pressure in the inner bore", omitted=0.0, ge=0, le=1e5
    )
    p_o: float = quantity(
        "5 MPa", "MPa", "p_o", "pressure on the outer rim", omitted=0.0, ge=0, le=1e5
    )
    E_i: float = quantity("206 GPa", "GPa", "E_i", "Young's modulus inside", gt=0, le=1e5)
    nu_i: float = quantity(0.3, "1", "ν_i", "Poisson's ratio inside", ge=0, le=0.45)
    E_o: float = quantity("70 GPa", "GPa", "E_o", "Young's modulus outside", gt=0, le=1e5)
    nu_o: float = quantity(0.33, "1", "ν_o", "Poisson's ratio outside", ge=0, le=0.45)
    R_p: float | None = quantity(
        None, "MPa", "R_p", "yield strength of the weaker wall, for the warning", omitted=None,
        gt=0, example="250 MPa",
    )  # fmt: skip

    @model_validator(mode="after")
    def _walls(self) -> "FitInputs":
        radii = ", ".join(f"{n} = {getattr(self, n) * 1e3:g} mm" for n in ("r_i", "r_f", "r_o"))
        if not self.r_i < self.r_f < self.r_o:
            raise ValueError(f"a fit needs r_i < r_f < r_o, got {radii}")
        wall = min(self.r_f - self.r_i, self.r_o - self.r_f)
        if wall < 1e-3 * self.r_f:
            raise ValueError(
                f"a wall of {wall * 1e3:g} mm is below a thousandth of r_f: a shell, got {radii}"
            )
        if self.delta > 0.01 * self.r_f or self.delta > 0.1 * wall:
            raise ValueError(
                f"delta = {self.delta * 1e6:g} µm exceeds a hundredth of r_f or a tenth of the "
                f"thinner wall, {wall * 1e3:g} mm: strains are not small"
            )
        return self

    @property
    def drawn(self) -> tuple[float, float]:
        """Rim of the inner and bore of the outer ring where the interference is drawn [m]."""
        return self.r_f + self.delta / 2, self.r_f - self.delta / 2


def walls(q: FitInputs, *, r_i: float, radii: tuple[float, float]) -> tuple[Wall, Wall]:
    """Inner and outer wall; `radii` are those of the inner one's rim and the outer one's bore."""
    return (
        Wall(r_i=r_i, r_o=radii[0], E=q.E_i, nu=q.nu_i),
        Wall(r_i=radii[1], r_o=q.r_o, E=q.E_o, nu=q.nu_o),
    )


def analytic(q: FitInputs) -> Values:
    values: dict[str, float] = {}
    for kind, a in FITS:
        p_i = 0.0 if kind == "shaft" else q.p_i
        radii = q.drawn if kind == "drawn" else (q.r_f, q.r_f)
        pair = walls(q, r_i=0.0 if kind == "shaft" else q.r_i, radii=radii)
        if kind == "drawn":
            p = pressure_of_overlap(*pair, p_i=p_i, p_o=q.p_o, assumption=a)
        else:
            p = float(contact_pressures(pair, q.delta, p_i=p_i, p_o=q.p_o, assumption=a)[0])
        values |= wall_values(q, pair, p, a, f"{kind}, {a}", p_i)
    values["none"] = 0.0
    values["load"] = max(q.p_i * q.r_i, q.p_o * q.r_o, values["rings, plane stress: p"] * q.r_f)
    return values


def wall_values(
    q: FitInputs, pair: tuple[Wall, Wall], p: float, a: Any, name: str, p_i: float
) -> dict[str, float]:
    """What both walls do under the contact pressure `p` on the inner one's rim."""
    inner, outer = pair
    loads = {"p_i": p_i, "p_o": p}, {"p_i": p * inner.r_o / outer.r_i, "p_o": q.p_o}
    found = {"p": p}
    u = {
        f"{side} {place}": float(wall.displacement(r, **load, assumption=a))
        for side, wall, load in (("inner", inner, loads[0]), ("outer", outer, loads[1]))
        for place, r in (("bore", wall.r_i), ("rim", wall.r_o))
    }
    hoop = {
        f"{side} {place}": float(wall.stresses(r, **load)[1])
        for side, wall, load in (("inner", inner, loads[0]), ("outer", outer, loads[1]))
        for place, r in (("bore", wall.r_i), ("rim", wall.r_o))
    }
    found |= {f"u, {place}": value for place, value in u.items()}
    found |= {f"hoop, {place}": value for place, value in hoop.items()}
    found["u scale"] = max(abs(value) for value in u.values())
    found["hoop scale"] = max(p, p_i, q.p_o, *(abs(value) for value in hoop.values()))
    found["U"] = sum(
        wall.strain_energy(**load, assumption=a) for wall, load in zip(pair, loads, strict=True)
    )
    return {f"{name}: {key}": value for key, value in found.items()}


def fem(q: FitInputs, level: int) -> FemResult:
    values: dict[str, float] = {}
    arrays: dict[str, Any] = {}
    fields: tuple[Field, ...] = ()
    u_it: dict[str, float] = {}
    worst = 0.0
    for kind, a in FITS:
        fit, name = fem_fit(q, level, kind, a), f"{kind}, {a}"
        found = read(q, fit, kind)
        values |= {f"{name}: {key}": value for key, value in found.items()}
        size = sizes(found)
        round_off = fit.plane.residual + EPS * q.r_f / q.delta
        worst = max(worst, round_off)
        u_it |= {f"{name}: {key}": round_off * size[key] for key in found}
        u_it[f"{name}: scatter"] = jitter(q, fit.touches[0].x.shape[1])
        if kind != "drawn":
            fields += (field(fit, name),)
        if name == "rings, plane stress":
            touch = fit.touches[0]
            turn = np.arctan2(touch.x[1], touch.x[0])
            order = np.argsort(turn)
            arrays["p along"] = np.interp(shown.TURNS, turn[order], touch.pressure[order])
            arrays |= {f"profile {k}": v for k, v in shown.across(q, fit.plane).items()}
    u_it |= {key: worst * float(np.abs(v).max()) for key, v in arrays.items()}
    return FemResult(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=fields)


def sizes(found: dict[str, float]) -> dict[str, float]:
    """What round-off of each value is a share of: the largest of its kind.

    Positions are rounded to EPS r_f, and their differences are what the interference is told by.
    """
    largest: dict[str, float] = {}
    for key, value in found.items():
        kind = key.split(",")[0]
        largest[kind] = max(largest.get(kind, 0.0), abs(value))
    return {key: largest[key.split(",")[0]] for key in found}


def jitter(q: FitInputs, around: int) -> float:
    """Pressure [Pa] that rounded positions make from node to node, `around` of them on a quarter.

    The inner wall, whose cells are shorter, is pushed from cell to cell by EPS r_f.
    """
    return EPS * q.E_i * around / (np.pi / 2)


def fem_fit(q: FitInputs, level: int, kind: str, assumption: Any) -> "ContactSolution":
    """Quarters of both walls, three cells around the inner one to two around the outer one."""
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle
    from fem.plane.material import Elastic
    from meshes.contact.disc import quarter_disc
    from meshes.join import join
    from meshes.ring.quarter import quarter_ring

    rim, bore = q.drawn if kind == "drawn" else (q.r_f, q.r_f)
    supports = {"outer.x=0": "x", "outer.y=0": "y"}
    pressures = {"outer.rim": q.p_o}
    if kind == "shaft":  # the quarter that touches the origin from below, moved to the rings' place
        fine: dict[str, Any] = {"zone": q.r_f / 2, "cells": 5, "refine": 2 * level}
        inner = quarter_disc(R=q.r_f, below=True, **fine).translated((0.0, q.r_f))
        supports |= {"inner.axis": "x", "inner.middle": "y"}
    else:
        inner = quarter_ring(r_i=q.r_i, r_o=rim, refine=3 * level)
        supports |= {"inner.x=0": "x", "inner.y=0": "y"}
        pressures["inner.bore"] = q.p_i
    fit = ContactProblem(
        join({"inner": inner, "outer": quarter_ring(r_i=bore, r_o=q.r_o, refine=2 * level)}),
        materials={"inner": Elastic(E=q.E_i, nu=q.nu_i), "outer": Elastic(E=q.E_o, nu=q.nu_o)},
        assumption=assumption,
        supports=supports,
        contacts=[
            Pair(
                slave="inner.surface" if kind == "shaft" else "inner.rim", master="outer.bore",
                slave_shape=Circle((0.0, 0.0), rim), master_shape=Circle((0.0, 0.0), bore, True),
                interference=0.0 if kind == "drawn" else q.delta, press_fit=kind == "drawn",
            )
        ],
    )  # fmt: skip
    return fit.solve(pressures=pressures)


def read(q: FitInputs, fit: "ContactSolution", kind: str) -> dict[str, float]:
    """Quantities of one fit by the names of `wall_values`."""
    touch, plane = fit.touches[0], fit.plane
    p = float(touch.p @ touch.weight / touch.weight.sum())
    push = touch.force[0]
    found = {
        "p": p,
        "scatter": float(np.sqrt((touch.p - p) ** 2 @ touch.weight / touch.weight.sum())),
        "U": 4 * fit.strain_energy,
        "outer balance": plane.reaction("outer.x=0")[0] + push - q.p_o * q.r_o,
    }
    if kind == "shaft":
        sides = {"inner rim": "inner.surface"}
        found["inner balance"] = plane.reaction("inner.axis")[0] - push
    else:
        sides = {"inner bore": "inner.bore", "inner rim": "inner.rim"}
        found["inner balance"] = plane.reaction("inner.x=0")[0] + q.p_i * q.r_i - push
    for place, name in (sides | {"outer bore": "outer.bore", "outer rim": "outer.rim"}).items():
        wall = plane.on_boundary(name)
        found[f"u, {place}"] = wall.mean(wall.polar()[0])
        found[f"hoop, {place}"] = wall.mean(wall.polar()[2])
    return found


def field(fit: "ContactSolution", name: str) -> Field:
    cells = fit.plane.cells()
    x, y = cells["points"][cells["cells"].astype(int)].mean(axis=1).T
    xx, yy, xy, _ = cells["stress"].T
    hoop = (xx * y**2 + yy * x**2 - 2 * xy * x * y) / (x**2 + y**2)
    return Field(
        name=name, points=cells["points"], cells=cells["cells"].astype(np.int64),
        point_data={"displacement": cells["displacement"]},
        cell_data={"stress": cells["stress"], "von_mises": cells["von_mises"],
                   "hoop_stress": hoop},
        units={"displacement": "m", "stress": "Pa", "von_mises": "Pa", "hoop_stress": "Pa"},
    )  # fmt: skip


def too_large(q: FitInputs) -> str:
    """Cells around must be short against the thinnest wall for the pressure to come out even."""
    wall = min(q.r_f - q.r_i, q.r_o - q.r_f)
    if wall < THINNEST * q.r_f:
        return (
            f"a wall of {wall * 1e3:.4g} mm is below {THINNEST:.0%} of r_f: these cells are too "
            "long for an even pressure on it, check it without --fem"
        )
    p = min(value for key, value in analytic(q).items() if key.endswith(": p"))
    if jitter(q, AROUND) > LOUDEST * p:
        return (
            f"delta = {q.delta * 1e6:.3g} µm is so little of r_f = {q.r_f * 1e3:.4g} mm that "
            f"rounded positions make more than {LOUDEST:g} of the pressure: check it without --fem"
        )
    thin = np.log(min(2 * q.r_f / (q.r_f + q.r_i), 2 * q.r_o / (q.r_o + q.r_f)))
    around = 12 * LEVELS[-1] * max(12.0, np.pi / 2 / np.sqrt(2 * thin))
    cells = around * LEVELS[-1] * (np.log(q.r_o / q.r_i) / 0.4 + 4)
    if cells <= MOST_CELLS:
        return ""
    return f"walls this thin need {cells:,.0f} cells, more than {MOST_CELLS:,}: check without --fem"


def warnings(q: FitInputs, v: Values) -> Sequence[str]:
    found = []
    for kind in ("rings", "shaft"):
        name = f"{kind}, plane stress"
        worst = max(
            abs(v[f"{name}: hoop, {place}"] + pressure)
            for place, pressure in (
                ("inner bore", q.p_i if kind == "rings" else v[f"{name}: p"]),
                ("inner rim", v[f"{name}: p"]), ("outer bore", v[f"{name}: p"]),
                ("outer rim", q.p_o),
            )
        )  # fmt: skip
        words = "the rings" if kind == "rings" else "the solid shaft's hub"
        if q.R_p is not None and worst > q.R_p:
            found.append(
                f"Tresca stress {worst / 1e6:.4g} MPa in {words} exceeds R_p = "
                f"{q.R_p / 1e6:.4g} MPa: the fit yields and loses pressure"
            )
        strain = worst / min(q.E_i, q.E_o)
        if strain > 2e-3 and q.R_p is None:
            found.append(
                f"strain reaches {strain:.2%} in {words}: most metals yield before; give R_p"
            )
    return found


def identity(kind: str, a: str, what: str, key: str, symbol: str, unit: str, **more: Any) -> Any:
    name = f"{kind}, {a}: {key}"
    return Identity(
        name=f"{what}, {shown.WORDS[kind]}, {a}", symbol=symbol, unit=unit, fem=name,
        **{"analytic": name, "demand": 1e-3, "demand_reason": SMOOTH, **more},
    )  # fmt: skip


PLACES = (
    ("inner bore", "inner ring's bore", "r_i"),
    ("inner rim", "inner wall's rim", "r_f"),
    ("outer bore", "outer wall's bore", "r_f"),
    ("outer rim", "outer wall's rim", "r_o"),
)
CHECKS = tuple(
    check
    for kind, a in FITS
    for check in (
        identity(kind, a, "contact pressure, mean", "p", "p", "MPa", formal=4),
        identity(kind, a, "contact pressure, rms scatter along the fit", "scatter", "Δp", "MPa",
                 formal=2, analytic="none", scale=f"{kind}, {a}: p"),
        *(
            identity(kind, a, f"displacement of the {words}", f"u, {place}", f"u_r({r})", "µm",
                     formal=4, scale=f"{kind}, {a}: u scale")
            for place, words, r in PLACES if (kind, place) != ("shaft", "inner bore")
        ),
        *(
            identity(kind, a, f"hoop stress at the {words}", f"hoop, {place}", f"σ_θ({r})", "MPa",
                     formal=2, scale=f"{kind}, {a}: hoop scale")
            for place, words, r in PLACES if kind == "rings"
        ),
        identity(kind, a, "strain energy", "U", "U", "J/m", formal=4),
        *(
            Exact(name=f"balance of the {wall} wall, {shown.WORDS[kind]}, {a}", symbol="ΣF_x",
                  unit="N/mm", fem=f"{kind}, {a}: {wall} balance", scale="load", bound=1e-9,
                  bound_reason="direct solve: machine epsilon times the condition of K")
            for wall in ("inner", "outer")
        ),
    )
)  # fmt: skip
LEVELS = (1, 2, 4)

PRESS_FIT = Case(
    id="contact-press-fit",
    title="Race pressed into its housing",
    paper="huang2018",
    place="Eq. 6, the formula behind it; Table 1, the outer race's radii",
    lead="Two walls meet along a whole circle, where their meshes do not match: contact has to "
    "carry an even pressure across. The interference is given once as a number and once drawn, as "
    "meshes that overlap; a solid shaft takes the race's place for the third.",
    inputs=FitInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    scans=(
        Scan(vary=("r_i=5mm,12mm,19.44mm", "E_o=70GPa,206GPa", "nu_i=0.2,0.3"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        Output(key="rings, plane stress: p", symbol="p", unit="MPa",
               what="contact pressure, short walls (plane stress)"),
        Output(key="rings, plane strain: p", symbol="p", unit="MPa",
               what="contact pressure, long walls (plane strain)"),
        Output(key="drawn, plane strain: p", symbol="p", unit="MPa",
               what="contact pressure, each wall on its own radius (plane strain)"),
        Output(key="shaft, plane stress: p", symbol="p", unit="MPa",
               what="contact pressure, solid shaft (plane stress)"),
        Output(key="rings, plane stress: u, inner bore", symbol="u_r(r_i)", unit="µm",
               what="displacement of the inner ring's bore (plane stress)"),
        Output(key="rings, plane stress: u, outer rim", symbol="u_r(r_o)", unit="µm",
               what="displacement of the outer ring's rim (plane stress)"),
        Output(key="rings, plane stress: hoop, inner bore", symbol="σ_θ(r_i)", unit="MPa",
               what="hoop stress at the inner ring's bore"),
        Output(key="rings, plane stress: hoop, outer bore", symbol="σ_θ(r_f)", unit="MPa",
               what="hoop stress at the outer ring's bore"),
        Output(key="rings, plane stress: U", symbol="U", unit="J/m",
               what="strain energy per length (plane stress)"),
    ),
    readings=(
        "δ is the interference of the radii, half that of the diameters",
        "the walls are taken once as short (plane stress) and once as long (plane strain)",
    ),
    assumptions=(
        "the paper gives no fit: housing (aluminium, 40 mm), δ and p_o are assumed; p_i is its 12 "
        "sprags of 3.4 kN on 9 mm, spread over the bore",
        "linear elasticity, small strain, no friction on the fit",
        "quarters with symmetry on both cuts",
    ),
    too_large=too_large,
    warnings=warnings,
    equations=shown.equations,
    sketch=shown.sketch,
    figures=shown.figures,
    pictures=shown.pictures,
)  # fmt: skip
