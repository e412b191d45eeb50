"""Thick rings: the races of a clutch under uniform pressure (Lamé)."""

from collections.abc import Mapping, Sequence
from typing import Any, Literal

import numpy as np
from pydantic import model_validator

from analytic.ring import lame
from verify.cases.ring.lame import figures as ring_shown
from verify.core.case import Case, Context, FemResult, Output, Scan, Values
from verify.core.figures import Field
from verify.core.inputs import Inputs, quantity
from verify.judging.checks import Exact, Identity, Order

Assumption = Literal["plane stress", "plane strain"]
ASSUMPTIONS: tuple[Assumption, ...] = ("plane stress", "plane strain")
SOLVES: tuple[tuple[Assumption, bool], ...] = (  # assumption, straight edges
    *((a, False) for a in ASSUMPTIONS),
    ("plane strain", True),
)
FAST = "smooth fields on curved quadratic cells: much sharper than 1 % at no cost"


class RingInputs(Inputs):
    """A ring under uniform pressure on both walls."""

    r_i: float = quantity(
        "19.44 mm", "mm", "r_i", "bore radius", gt=0, le=1e5, claims="huang2018:table1-r-e"
    )
    r_o: float = quantity(
        "26.23 mm", "mm", "r_o", "outer radius", gt=0, le=1e5, claims="huang2018:table1-r-ed"
    )
    p_i: float = quantity("100 MPa", "MPa", "p_i", "pressure in the bore", ge=-1e5, le=1e5)
    p_o: float = quantity(
        "30 MPa", "MPa", "p_o", "pressure on the rim", omitted=0.0, ge=-1e5, le=1e5
    )
    E: float = quantity("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    R_p: float | None = quantity(
        None, "MPa", "R_p", "yield strength, for the warning", omitted=None, gt=0,
        example="1200 MPa",
    )  # fmt: skip

    @model_validator(mode="after")
    def _wall(self) -> "RingInputs":
        if not self.r_i < self.r_o:
            raise ValueError(
                f"a ring needs r_i < r_o, got r_i = {self.r_i * 1e3:g} mm, "
                f"r_o = {self.r_o * 1e3:g} mm"
            )
        if self.r_o - self.r_i < 1e-3 * self.r_o:
            raise ValueError(
                f"a wall of {(self.r_o - self.r_i) * 1e3:g} mm is below a thousandth of r_o = "
                f"{self.r_o * 1e3:g} mm: a shell, not a thick ring"
            )
        if self.p_i == self.p_o == 0:
            raise ValueError("p_i and p_o are both 0 MPa: there is no load")
        return self


def loads(q: RingInputs) -> dict[str, Any]:
    """The arguments that all of Lamé's formulas share."""
    return {"r_i": q.r_i, "r_o": q.r_o, "p_i": q.p_i, "p_o": q.p_o}


def analytic(q: RingInputs) -> Values:
    radial, hoop = lame.stresses([q.r_i, (q.r_i + q.r_o) / 2, q.r_o], **loads(q))
    values: dict[str, Any] = {
        "bore hoop stress": hoop[0],
        "rim hoop stress": hoop[2],
        "mid-wall radial stress": radial[1],
        "mid-wall hoop stress": hoop[1],
        "axial stress": lame.axial_stress(nu=q.nu, ends="plane strain", **loads(q)),
        "stress scale": max(abs(q.p_i), abs(q.p_o), *np.abs(hoop)),
        "load": abs(q.p_i) * q.r_i + abs(q.p_o) * q.r_o,
    }
    for a in ASSUMPTIONS:
        for wall, r in (("bore", q.r_i), ("rim", q.r_o)):
            values[f"{wall} displacement, {a}"] = lame.radial_displacement(
                r, E=q.E, nu=q.nu, ends=a, **loads(q)
            )
        values[f"displacement scale, {a}"] = max(
            abs(values[f"bore displacement, {a}"]), abs(values[f"rim displacement, {a}"])
        )
        values[f"strain energy, {a}"] = lame.strain_energy(E=q.E, nu=q.nu, ends=a, **loads(q))
    return {key: float(value) for key, value in values.items()}


def fem(q: RingInputs, level: int) -> FemResult:
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.ring.quarter import quarter_ring

    values: dict[str, float] = {}
    arrays: dict[str, Any] = {}
    fields: tuple[Field, ...] = ()
    round_off = 0.0
    for a, straight in SOLVES:
        ring = solve_plane(
            quarter_ring(r_i=q.r_i, r_o=q.r_o, refine=level, straight=straight),
            materials=Elastic(E=q.E, nu=q.nu),
            assumption=a,
            supports={"x=0": "x", "y=0": "y"},
            pressures={"bore": q.p_i, "rim": q.p_o},
            degree=2,
        )
        kind = f"{a}, straight edges" if straight else a
        values[f"strain energy, {kind}"] = 4 * ring.strain_energy
        # without prescribed movement energy and potential differ by round-off alone
        round_off = max(round_off, abs(ring.potential_energy / ring.strain_energy + 1))
        round_off = max(round_off, ring.residual**0.5)  # of displacements, not of energies
        wall = ring.in_body()
        if a == "plane strain":
            arrays |= {f"{name}, {kind}": v for name, v in
                       (("x", wall.x), ("u", wall.u), ("weight", wall.weight))}  # fmt: skip
        if straight:
            continue
        bore, rim, middle = (ring.on_boundary(name) for name in ("bore", "rim", "middle"))
        values[f"bore displacement, {a}"] = bore.mean(bore.polar()[0])
        values[f"rim displacement, {a}"] = rim.mean(rim.polar()[0])
        values[f"bore hoop stress, {a}"] = bore.mean(bore.polar()[2])
        values[f"rim hoop stress, {a}"] = rim.mean(rim.polar()[2])
        values[f"mid-wall radial stress, {a}"] = middle.mean(middle.polar()[1])
        values[f"mid-wall hoop stress, {a}"] = middle.mean(middle.polar()[2])
        values[f"axial stress, {a}"] = wall.mean(wall.stress[3])
        push = q.p_i * q.r_i - q.p_o * q.r_o  # resultant of the pressures on a quarter, along x
        values[f"balance, {a}"] = ring.reaction("x=0")[0] + push
        if a == "plane strain":
            r = ring_shown.stations(q)
            across = ring.at(np.outer([np.cos(ring_shown.ASKEW), np.sin(ring_shown.ASKEW)], r))
            named = ("radial displacement", "radial stress", "hoop stress")
            arrays |= {f"profile, {n}": v for n, v in zip(named, across.polar(), strict=False)}
        cells = ring.cells()
        fields += (
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
    u_it |= {
        key: round_off * float(np.abs(array).max())
        for key, array in arrays.items() if key.startswith("profile")
    }  # fmt: skip
    return FemResult(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=fields)


def hoop_stress(cells: Mapping[str, Any]) -> Any:
    """Hoop stress (m,) about the origin from the mean stresses of the cells."""
    x, y = cells["points"][cells["cells"].astype(int)].mean(axis=1).T
    xx, yy, xy, _ = cells["stress"].T
    return (xx * y**2 + yy * x**2 - 2 * xy * x * y) / (x**2 + y**2)


def energy_errors(kind: str) -> Any:
    """Errors of the strain energy against Lamé, per level."""

    def errors(context: Context) -> tuple[list[float], list[float]]:
        exact = context.analytic[f"strain energy, {kind.partition(', straight')[0]}"]
        h, v = context.series(f"strain energy, {kind}")
        return h, [abs(value / exact - 1) for value in v]

    return errors


def displacement_errors(kind: str) -> Any:
    """Relative L2 errors of the displacement field against Lamé, per level."""

    def errors(context: Context) -> tuple[list[float], list[float]]:
        q = context.inputs
        found = []
        for result in context.fem:
            x, u, w = (result.arrays[f"{name}, {kind}"] for name in ("x", "u", "weight"))
            r = np.hypot(*x)
            exact = lame.radial_displacement(
                np.clip(r, q.r_i, q.r_o), E=q.E, nu=q.nu, ends="plane strain", **loads(q)
            )
            error = ((u - exact * x / r) ** 2).sum(axis=0) @ w
            found.append(float(np.sqrt(error / (exact**2 @ w))))
        return [result.h for result in context.fem], found

    return errors


def warnings(q: RingInputs, _values: Values) -> Sequence[str]:
    found: list[str] = []
    _, hoop = lame.stresses([q.r_i, q.r_o], **loads(q))
    radial = np.array([-q.p_i, -q.p_o])
    shear = np.maximum.reduce([abs(hoop - radial), abs(hoop), abs(radial)])  # Tresca, sigma_z = 0
    worst = int(np.argmax(shear))
    where, stress = ("bore", "rim")[worst], float(shear[worst])
    if q.R_p is not None and stress > q.R_p:
        found.append(
            f"Tresca stress {stress / 1e6:.4g} MPa at the {where} exceeds R_p = "
            f"{q.R_p / 1e6:.4g} MPa: the ring yields and Lamé no longer holds"
        )
    strain = stress / q.E
    if strain > 2e-3 and q.R_p is None:
        found.append(
            f"strain reaches {strain:.2%} at the {where}: most steels yield before; give R_p"
        )
    if strain > 1e-2:
        found.append(f"strain reaches {strain:.2%}: small-strain elasticity is off by about that")
    if q.r_o - q.r_i < 0.02 * q.r_o:
        found.append(
            f"the wall is {(q.r_o - q.r_i) / q.r_o:.1%} of r_o: out-of-roundness and bending, "
            "which Lamé leaves out, matter more than the pressure's own field"
        )
    return found


def identity(name: str, symbol: str, unit: str, **more: Any) -> Identity:
    return Identity(
        name=name, symbol=symbol, unit=unit, fem=name, demand=1e-3, demand_reason=FAST, **more
    )


CHECKS = (
    *(
        identity(f"{wall} displacement, {a}", f"u_r({r})", "µm", formal=4,
                 analytic=f"{wall} displacement, {a}", scale=f"displacement scale, {a}")
        for a in ASSUMPTIONS for wall, r in (("bore", "r_i"), ("rim", "r_o"))
    ),
    *(
        identity(f"strain energy, {a}", "U", "J/m", formal=4, analytic=f"strain energy, {a}")
        for a in ASSUMPTIONS
    ),
    *(
        identity(f"{key}, {a}", symbol, "MPa", formal=2, analytic=key, scale="stress scale")
        for a in ASSUMPTIONS
        for key, symbol in (
            ("bore hoop stress", "σ_θ(r_i)"),
            ("rim hoop stress", "σ_θ(r_o)"),
            ("mid-wall radial stress", "σ_r(r_m)"),
            ("mid-wall hoop stress", "σ_θ(r_m)"),
        )
    ),
    identity("axial stress, plane strain", "σ_z", "MPa", formal=4, analytic="axial stress",
             scale="stress scale"),
    *(
        Exact(name=f"balance of forces, {a}", symbol="ΣF_x", unit="N/mm", fem=f"balance, {a}",
              scale="load", bound=1e-9,
              bound_reason="direct solve: machine epsilon times the condition of K (below 1e7)")
        for a in ASSUMPTIONS
    ),
    *(
        Order(name=f"order of the strain energy, {a}", symbol="p", unit="1",
              errors=energy_errors(a), order=4, demand=0.025,
              demand_reason="4 within 0.1: twice the energy norm's order 2")
        for a in ASSUMPTIONS
    ),
    Order(name="order of the displacement in L2", symbol="p", unit="1",
          errors=displacement_errors("plane strain"), order=3),
    Order(name="order of the strain energy, straight edges", symbol="p", unit="1",
          errors=energy_errors("plane strain, straight edges"), order=2),
    Order(name="order of the displacement in L2, straight edges", symbol="p", unit="1",
          errors=displacement_errors("plane strain, straight edges"), order=2),
)  # fmt: skip

LAME = Case(
    id="ring-lame",
    title="Thick ring under uniform pressure",
    paper="huang2018",
    place="Eq. 6, the formula behind it",
    lead="Lamé's ring is the structural part of every race in these papers. Formula and finite "
    "elements solve the same problem here, so that what is left is discretisation error.",
    inputs=RingInputs,
    analytic=analytic,
    reference=fem,
    levels=(2, 4, 8, 16),
    scans=(
        Scan(
            vary=("r_i=5mm,12mm,19.44mm,24mm", "nu=0.1,0.3,0.45", "p_o=0MPa,30MPa,90MPa"),
            star=True,
        ),
    ),
    checks=CHECKS,
    outputs=(
        Output(key="bore displacement, plane stress", symbol="u_r(r_i)", unit="µm",
               what="bore displacement, thin ring (plane stress)"),
        Output(key="bore displacement, plane strain", symbol="u_r(r_i)", unit="µm",
               what="bore displacement, long ring (plane strain)"),
        Output(key="rim displacement, plane stress", symbol="u_r(r_o)", unit="µm",
               what="rim displacement, thin ring (plane stress)"),
        Output(key="rim displacement, plane strain", symbol="u_r(r_o)", unit="µm",
               what="rim displacement, long ring (plane strain)"),
        Output(key="bore hoop stress", symbol="σ_θ(r_i)", unit="MPa", what="hoop stress, bore"),
        Output(key="rim hoop stress", symbol="σ_θ(r_o)", unit="MPa", what="hoop stress, rim"),
        Output(key="mid-wall radial stress", symbol="σ_r(r_m)", unit="MPa",
               what="radial stress, mid-wall"),
        Output(key="axial stress", symbol="σ_z", unit="MPa",
               what="axial stress, long ring (plane strain)"),
        Output(key="strain energy, plane stress", symbol="U", unit="J/m",
               what="strain energy per length (plane stress)"),
    ),
    readings=(
        "pressures push on the wall: positive p_i opens the bore, positive p_o closes the rim",
        "the race is taken once as a thin ring (plane stress) and once as a long one (plane "
        "strain): the stresses in the plane are the same, displacements and energy are not",
    ),
    assumptions=(
        "linear elasticity, small strain",
        "pressure uniform around and along the ring",
        "a quarter with symmetry on both cuts",
    ),
    warnings=warnings,
    equations=ring_shown.equations,
    sketch=ring_shown.sketch,
    figures=ring_shown.figures,
    pictures=ring_shown.pictures,
)  # fmt: skip
