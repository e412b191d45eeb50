"""Rotating race: the outer race's growth at speed (Eq. 8) beside what the sprags do to it."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.ring import rotating
from analytic.ring.smeared import race_deflection
from verify.cases.ring.lame.case import ASSUMPTIONS, FAST, hoop_stress
from verify.cases.ring.rotation import figures as shown
from verify.cases.ring.rotation.inputs import RotationInputs
from verify.core.case import Case, Context, FemResult, Output, Scan, Values
from verify.core.figures import Field
from verify.core.results import Kind, Row, Status
from verify.judging import judge
from verify.judging.checks import Exact, Identity, Order
from verify.judging.claims import Claim


def ring(q: RotationInputs) -> dict[str, Any]:
    """The arguments that all formulas of the rotating ring share."""
    return {"r_i": q.r_i, "r_o": q.r_o, "rho": q.rho, "omega": q.omega, "nu": q.nu}


def analytic(q: RotationInputs) -> Values:
    values: dict[str, Any] = {}
    for a in ASSUMPTIONS:
        radial, hoop = rotating.stresses(
            [q.r_i, (q.r_i + q.r_o) / 2, q.r_o], assumption=a, **ring(q)
        )
        bore, rim = rotating.radial_displacement([q.r_i, q.r_o], E=q.E, assumption=a, **ring(q))
        values |= {
            f"bore growth, {a}": bore,
            f"rim growth, {a}": rim,
            f"bore hoop stress, {a}": hoop[0],
            f"rim hoop stress, {a}": hoop[2],
            f"mid-wall radial stress, {a}": radial[1],
            f"strain energy, {a}": rotating.strain_energy(E=q.E, assumption=a, **ring(q)),
        }
    smeared = race_deflection(P=q.P, n=q.n, r_i=q.r_i, r_o=q.r_o, E=q.E, nu=q.nu, loaded="bore")
    ratio = values["bore growth, plane stress"] / smeared
    values |= {
        "under the sprags": smeared,
        "ratio": ratio,
        "1 %": q.omega * np.sqrt(0.01 / ratio),
        "10 %": q.omega * np.sqrt(0.1 / ratio),
        "load": q.rho * q.omega**2 * (q.r_o**3 - q.r_i**3) / 3,
    }
    return {key: float(value) for key, value in values.items()}


def fem(q: RotationInputs, level: int) -> FemResult:
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.ring.quarter import quarter_ring

    values: dict[str, float] = {}
    arrays: dict[str, Any] = {}
    fields: tuple[Field, ...] = ()
    round_off = 0.0
    pull = q.rho * q.omega**2
    for a in ASSUMPTIONS:
        race = solve_plane(
            quarter_ring(r_i=q.r_i, r_o=q.r_o, refine=level),
            materials=Elastic(E=q.E, nu=q.nu),
            assumption=a,
            supports={"x=0": "x", "y=0": "y"},
            body_forces=lambda x: pull * x,
        )
        round_off = max(round_off, race.residual**0.5)
        bore, rim, middle = (race.on_boundary(name) for name in ("bore", "rim", "middle"))
        values |= {
            f"bore growth, {a}": bore.mean(bore.polar()[0]),
            f"rim growth, {a}": rim.mean(rim.polar()[0]),
            f"bore hoop stress, {a}": bore.mean(bore.polar()[2]),
            f"rim hoop stress, {a}": rim.mean(rim.polar()[2]),
            f"mid-wall radial stress, {a}": middle.mean(middle.polar()[1]),
            f"strain energy, {a}": 4 * race.strain_energy,
            # what acts on a quarter along x: rho omega² times the integral of x
            f"balance, {a}": race.reaction("x=0")[0] + pull * (q.r_o**3 - q.r_i**3) / 3,
        }
        if a == "plane stress":
            across = race.at(
                np.outer([np.cos(shown.ASKEW), np.sin(shown.ASKEW)], shown.stations(q))
            )
            named = ("radial displacement", "radial stress", "hoop stress")
            arrays |= {f"profile, {n}": v for n, v in zip(named, across.polar(), strict=False)}
            cells = race.cells()
            fields = (
                Field(
                    name=a, points=cells["points"], cells=cells["cells"].astype(np.int64),
                    point_data={"displacement": cells["displacement"]},
                    cell_data={"stress": cells["stress"], "von_mises": cells["von_mises"],
                               "hoop_stress": hoop_stress(cells)},
                    units={"displacement": "m", "stress": "Pa", "von_mises": "Pa",
                           "hoop_stress": "Pa"},
                ),
            )  # fmt: skip
    u_it = {key: round_off * abs(value) for key, value in values.items()}
    u_it |= {key: round_off * float(np.abs(array).max()) for key, array in arrays.items()}
    return FemResult(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=fields)


@dataclass(frozen=True, kw_only=True)
class Small(Claim):
    """Eq. 8 against Eq. 6: told, as the paper prints neither a speed nor a density."""

    kind = Kind.FACT

    @property
    def needs_fem(self) -> bool:
        return False

    def rows(self, context: Context) -> list[Row]:
        q, v = context.inputs, context.analytic
        words = (
            f"{v['ratio']:.2%} at {q.omega * 30 / np.pi:.6g} r/min; 1 % at "
            f"{v['1 %'] * 30 / np.pi:.5g}, 10 % at {v['10 %'] * 30 / np.pi:.5g} r/min"
        )
        told = judge.Verdict(Status.SHOWN, f"no speed and no density are printed: {words}")
        return [self._row(context.case, Kind.FACT, told, analytic=v["ratio"])]


def identity(name: str, symbol: str, unit: str, *, formal: float) -> tuple[Identity, ...]:
    return tuple(
        Identity(name=f"{name}, {a}", symbol=symbol, unit=unit, fem=f"{name}, {a}",
                 analytic=f"{name}, {a}", formal=formal, demand=1e-3, demand_reason=FAST,
                 scale=f"bore hoop stress, {a}" if unit == "MPa" else "")
        for a in ASSUMPTIONS
    )  # fmt: skip


def energy_errors(a: str) -> Any:
    """Errors of the strain energy against the formula, per level."""

    def errors(context: Context) -> tuple[list[float], list[float]]:
        h, v = context.series(f"strain energy, {a}")
        exact = context.analytic[f"strain energy, {a}"]
        return h, [abs(value / exact - 1) for value in v]

    return errors


CHECKS = (
    *identity("bore growth", "δ_ce", "µm", formal=4),
    *identity("rim growth", "u_r(R_ed)", "µm", formal=4),
    *identity("strain energy", "U", "J/m", formal=4),
    *identity("bore hoop stress", "σ_θ(R_e)", "MPa", formal=2),
    *identity("rim hoop stress", "σ_θ(R_ed)", "MPa", formal=2),
    *identity("mid-wall radial stress", "σ_r(r_m)", "MPa", formal=2),
    *(
        Exact(name=f"balance of forces, {a}", symbol="ΣF_x", unit="N/mm", fem=f"balance, {a}",
              scale="load", bound=1e-9,
              bound_reason="parabolas for circles: their moment errs by less than (cell's angle)^4")
        for a in ASSUMPTIONS
    ),
    *(
        Order(name=f"order of the strain energy, {a}", symbol="p", unit="1",
              errors=energy_errors(a), order=4, demand=0.025,
              demand_reason="4 within 0.1: twice the energy norm's order 2")
        for a in ASSUMPTIONS
    ),
    Small(name="growth at speed over the race's deflection under the sprags (Eq. 8 over Eq. 6)",
          symbol="δ_ce/δ_BE", unit="1"),
)  # fmt: skip


def warnings(q: RotationInputs, v: Values) -> Sequence[str]:
    found: list[str] = []
    stress = v["bore hoop stress, plane stress"]
    if q.R_p is not None and stress > q.R_p:
        found.append(
            f"hoop stress {stress / 1e6:.4g} MPa at the bore exceeds R_p = {q.R_p / 1e6:.4g} MPa: "
            "the race yields"
        )
    if q.R_p is None and stress / q.E > 2e-3:
        found.append(f"strain reaches {stress / q.E:.2%} at the bore: most steels yield; give R_p")
    if v["ratio"] > 0.01:
        found.append(
            f"the bore grows by {v['ratio']:.2%} of what the sprags push it out: Eq. 8 counts from "
            f"{v['1 %'] * 30 / np.pi:.5g} r/min on (1 %)"
        )
    return found


ROTATION = Case(
    id="ring-rotation",
    title="Rotating race",
    paper="huang2018",
    place="Eq. 8; Table 1, the outer race's radii",
    lead="At speed the outer race grows by itself, which takes sprags out of contact. Formula and "
    "finite elements solve the same problem; beside them stands what the sprags' forces do to the "
    "same race. Neither a speed nor a density is printed: both are inputs of this project.",
    inputs=RotationInputs,
    analytic=analytic,
    reference=fem,
    levels=(2, 4, 8, 12),
    scans=(
        Scan(vary=("r_i=5mm,12mm,19.44mm,24mm", "nu=0.1,0.3,0.45"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        Output(key="bore growth, plane stress", symbol="δ_ce", unit="µm",
               what="growth of the bore (Eq. 8, plane stress)"),
        Output(key="bore growth, plane strain", symbol="δ_ce", unit="µm",
               what="growth of the bore, long race (plane strain)"),
        Output(key="bore hoop stress, plane stress", symbol="σ_θ", unit="MPa",
               what="hoop stress, bore"),
        Output(key="strain energy, plane stress", symbol="U", unit="J/m",
               what="strain energy per length (plane stress)"),
        Output(key="under the sprags", symbol="δ_BE", unit="µm",
               what="deflection of the same bore under the sprags (Eq. 6)", judged=False),
        Output(key="ratio", symbol="δ_ce/δ_BE", unit="1", what="growth over it", judged=False),
        Output(key="1 %", symbol="n", unit="r/min", what="speed at which that is 1 %",
               judged=False),
        Output(key="10 %", symbol="n", unit="r/min", what="speed at which that is 10 %",
               judged=False),
    ),
    readings=(
        "the n of Eq. 8 is a speed in r/min, its ρ a density: πn/30 is the angular speed",
        "Eq. 8 is the bore's growth of a thin ring (plane stress); a long one (plane strain) grows "
        "otherwise",
    ),
    assumptions=(
        "linear elasticity, small strain",
        "steady rotation, walls free of load",
        "a quarter with symmetry on both cuts",
    ),
    warnings=warnings,
    equations=shown.equations,
    sketch=shown.sketch,
    figures=shown.figures,
    pictures=shown.pictures,
)  # fmt: skip
