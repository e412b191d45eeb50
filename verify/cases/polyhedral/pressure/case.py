"""The round ring behind the polyhedral one: pressure that takes up a clearance, thin and thick."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.polyhedral import expansion
from analytic.ring import lame
from verify.cases.polyhedral.inputs import RoundRing
from verify.cases.polyhedral.pressure import figures as shown
from verify.cases.polyhedral.pressure.figures import WALLS
from verify.core.case import Case, Context, FemResult, Output, Scan, Values
from verify.core.figures import Field
from verify.judging.checks import Approximation, Exact, Identity, Limit
from verify.judging.convergence import grid_convergence
from verify.judging.judge import numerical_uncertainty

DERIVED = "derived: Lamé's pressure is d_m²/(d_i d_e) times p_1, in plane stress"
SLACK = 1e-4  # of the closed forms that intervals are computed from
CELL = 1e-2  # of (wall/d_m)²: stress at the end of a cell, which spans more of ln r in thick walls
THICK = 0.15  # wall over d_m from which on meshes are twice as fine


def analytic(q: RoundRing) -> Values:
    wall = {"d_i": q.d_i, "d_e": q.d_e}
    d_m = expansion.mean_diameter(**wall)
    sigma_t = expansion.hoop_stress(j_D=q.j_D, d_m=d_m, E=q.E)
    p_1 = expansion.touching_pressure(j_D=q.j_D, **wall, E=q.E)
    values: dict[str, Any] = {
        "d_m": d_m, "sigma_t": sigma_t, "p_1": p_1,
        "K": expansion.many_corners_factor(**wall),
        "growth": expansion.growth(sigma_t=sigma_t, d_m=d_m, E=q.E),
        "Lamé force": q.E / 1000 * q.d_i / 2,
    }  # fmt: skip
    for ends in ("plane stress", "plane strain"):
        values[f"Lamé, {ends}"] = expansion.round_ring_pressure(
            j_D=q.j_D, **wall, E=q.E, nu=q.nu, ends=ends
        )
    # the growth of the mean diameter under p_1, which Eq. 8 takes for that of the outside
    values["Lamé growth, middle"] = 2 * lame.radial_displacement(
        q.d_m / 2, r_i=q.d_i / 2, r_o=q.d_e / 2, p_i=p_1, E=q.E, nu=q.nu, ends="plane stress"
    )
    return {key: float(value) for key, value in values.items()}


def fem(q: RoundRing, level: int) -> FemResult:
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.ring.quarter import quarter_ring

    fine = 2 if q.delta_1 > THICK * q.d_m else 1

    def expanded(d_i: float, d_e: float, assumption: Any) -> Any:
        """The ring under a pressure of E/1000 in its bore."""
        return solve_plane(
            quarter_ring(r_i=d_i / 2, r_o=d_e / 2, refine=level * fine),
            materials=Elastic(E=q.E, nu=q.nu),
            assumption=assumption,
            supports={"x=0": "x", "y=0": "y"},
            pressures={"bore": q.E / 1000},
        )

    values: dict[str, float] = {}
    fields: tuple[Field, ...] = ()
    round_off = 0.0
    for assumption in ("plane stress", "plane strain"):
        ring = expanded(q.d_i, q.d_e, assumption)
        rim, middle = ring.on_boundary("rim"), ring.on_boundary("middle")
        growth = 2 * rim.mean(rim.polar()[0])
        values[f"pressure, {assumption}"] = p = q.E / 1000 * q.j_D / growth
        round_off = max(round_off, ring.residual**0.5, abs(ring.potential_energy
                                                            / ring.strain_energy + 1))  # fmt: skip
        if assumption == "plane strain":
            continue
        cut = -ring.reaction("x=0")[0]  # the hoop force of one wall, pulling on the quarter
        values["balance"] = cut - q.E / 1000 * q.d_i / 2
        values["mean hoop stress"] = cut / q.delta_1 * p / (q.E / 1000)
        values["rim hoop stress"] = rim.mean(rim.polar()[2]) * p / (q.E / 1000)
        values["middle growth"] = q.j_D / growth * 2 * middle.mean(middle.polar()[0])
        cells = ring.cells()
        scale = p / (q.E / 1000)
        fields = (
            Field(
                name="ring", points=cells["points"], cells=cells["cells"].astype(np.int64),
                point_data={"displacement": cells["displacement"] * scale},
                cell_data={"von_mises": cells["von_mises"] * scale},
                units={"displacement": "m", "von_mises": "Pa"},
            ),
        )  # fmt: skip
    swept = []
    for share in WALLS:
        ring = expanded(q.d_m * (1 - share), q.d_m * (1 + share), "plane stress")
        rim = ring.on_boundary("rim")
        swept.append(q.E / 1000 * q.j_D / (2 * rim.mean(rim.polar()[0])))
    return FemResult(
        h=1 / level, values=values, u_it={k: round_off * abs(v) for k, v in values.items()},
        arrays={"swept": np.array(swept)}, fields=fields,
    )  # fmt: skip


def thin(context: Context) -> tuple[list[float], list[float], list[float]]:
    """Wall over mean diameter, error of p_1 beside finite elements, and its uncertainty."""
    q = context.inputs
    found = []
    for k, share in enumerate(WALLS):
        p_1 = float(
            expansion.touching_pressure(
                j_D=q.j_D, d_i=q.d_m * (1 - share), d_e=q.d_m * (1 + share), E=q.E
            )
        )
        p = [float(level.arrays["swept"][k]) for level in context.fem]
        grid = grid_convergence([r.h for r in context.fem], p, formal=4, scale=p[-1])
        found.append((share, p_1 / p[-1] - 1, numerical_uncertainty(grid, 0.0) / p[-1]))
    eps, d, u = (list(column) for column in zip(*found, strict=True))
    return eps, d, u


def about(m: float, slack: float = SLACK) -> tuple[float, float]:
    return m - slack, m + slack


CHECKS = (
    *(
        Identity(name=f"pressure that takes up the clearance, {a}", symbol="p", unit="MPa",
                 fem=f"pressure, {a}", analytic=f"Lamé, {a}", formal=4, demand=5e-4,
                 demand_reason="uniform pressure on a round ring: acceptance figure")
        for a in ("plane stress", "plane strain")
    ),
    Approximation(name="pressure of the thin ring, Eq. 10", symbol="p_1", unit="MPa",
                  fem="pressure, plane stress", analytic="p_1", formal=4,
                  interval=lambda _q, v: about(1 / v["K"] - 1), source=DERIVED),
    Approximation(name="hoop stress, Eq. 9, against the mean over the wall", symbol="σ_t",
                  unit="MPa", fem="mean hoop stress", analytic="sigma_t", formal=4,
                  interval=lambda _q, v: about(1 / v["K"] - 1),
                  source="derived: the mean over the wall is p d_i/(2 δ_1) whatever the pressure, "
                  "so that it errs as p_1 does"),
    Approximation(name="hoop stress, Eq. 9, against that of the outside", symbol="σ_t",
                  unit="MPa", fem="rim hoop stress", analytic="sigma_t", formal=2,
                  interval=lambda q, _v: about(
                      q.d_e / q.d_m - 1, SLACK + CELL * (q.delta_1 / q.d_m) ** 2),
                  source="derived: the free outside has the strain j_D/d_e; more by "
                  f"{CELL:g} (δ_1/d_m)² for stresses at the ends of cells"),
    Approximation(name="growth of the mean diameter, Eq. 8", symbol="Δd_m", unit="µm",
                  fem="middle growth", analytic="growth", formal=4,
                  interval=lambda q, v: about(
                      q.j_D / (v["Lamé growth, middle"] * v["K"]) - 1),
                  source="Lamé: growth of the mean diameter where the outside grows by j_D"),
    Limit(name="pressure of ever thinner rings, Eq. 10", symbol="p_1/p - 1", unit="1",
          points=thin, exponent=2),
    Exact(name="hoop force of a wall and the bore's pressure", symbol="ΣF_x", unit="N/mm",
          fem="balance", scale="Lamé force", bound=1e-9,
          bound_reason="direct solve: machine epsilon times the condition of K"),
)  # fmt: skip


def warnings(q: RoundRing, v: Values) -> Sequence[str]:
    found = []
    if q.R_p is not None and v["Lamé, plane stress"] * tresca(q) > q.R_p:
        found.append(
            f"Tresca stress {v['Lamé, plane stress'] * tresca(q) / 1e6:.4g} MPa in the bore "
            f"exceeds R_p = {q.R_p / 1e6:.4g} MPa: the ring yields before it has taken up "
            f"j_D = {q.j_D * 1e3:g} mm"
        )
    if q.R_p is None and q.straining > 3e-3:
        found.append(
            f"the ring strains by {q.straining:.2%} to take up the clearance: most steels yield "
            "before; give R_p"
        )
    return found


def tresca(q: RoundRing) -> float:
    """Largest hoop minus radial stress of a round ring, in the bore, over the pressure."""
    return 2 * q.d_e**2 / (q.d_e**2 - q.d_i**2)


PRESSURE = Case(
    id="polyhedral-pressure",
    title="Pressure that expands a round ring to its rollers",
    paper="belcin",
    place="Eqs. 6, 8-10",
    lead="Before the polygon: a plain round ring under pressure. The paper's thin ring is set "
    "beside Lamé's thick one, which finite elements solve too, and a sweep shows that both agree "
    "as the wall vanishes. Sizes are the project's: the paper prints none.",
    inputs=RoundRing,
    analytic=analytic,
    reference=fem,
    levels=(1, 2, 3, 4),
    scans=(
        Scan(vary=("delta_1=1mm,2mm,4mm,6mm,8mm,12mm", "nu=0.2,0.3,0.4"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        Output(key="d_m", symbol="d_m", unit="mm", what="mean diameter (Eq. 6)", judged=False),
        Output(key="sigma_t", symbol="σ_t", unit="MPa", what="hoop stress (Eq. 9)"),
        Output(key="p_1", symbol="p_1", unit="MPa", what="pressure of the thin ring (Eq. 10)"),
        Output(key="Lamé, plane stress", symbol="p", unit="MPa",
               what="pressure of the thick ring, plane stress (Lamé)"),
        Output(key="Lamé, plane strain", symbol="p", unit="MPa",
               what="pressure of the thick ring, plane strain (Lamé)"),
        Output(key="K", symbol="K", unit="1",
               what="thick over thin, plane stress: K of ever more corners", judged=False),
    ),
    readings=(
        "the clearance j_D is on the diameter and closes outside, where the rollers are",
        "the ring is narrow: plane stress; as a long one it takes 1/(1 - ν²) times the pressure",
    ),
    assumptions=("linear elasticity, small strain", "a quarter with symmetry on both cuts"),
    warnings=warnings,
    equations=shown.equations,
    sketch=shown.sketch,
    figures=shown.figures,
    pictures=shown.pictures,
)  # fmt: skip
