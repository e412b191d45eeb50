"""Races under n sprags: outer race pushed on its bore, inner race on its rim."""

from collections.abc import Sequence
from typing import Any

from verify.cases.ring.loads import figures as shown
from verify.cases.ring.loads.claims import checks
from verify.cases.ring.loads.fem import fem
from verify.cases.ring.loads.formulas import analytic
from verify.cases.ring.loads.inputs import InnerInputs, LoadsInputs, OuterInputs, too_large
from verify.cases.ring.loads.sketch import sketch
from verify.core.case import Case, Output, Scan, Values

YIELDING = 1.67  # p_0 over R_p at which a line contact yields below its surface (Tresca)
WIDE = 0.1  # a over the wall


def warnings(q: LoadsInputs, v: Values) -> Sequence[str]:
    found: list[str] = []
    limit = None if q.R_p is None else YIELDING * q.R_p
    if limit is not None and q.R_p is not None:
        if v["p_0"] > limit:
            found.append(
                f"p_0 = {v['p_0'] / 1e6:.4g} MPa exceeds {YIELDING:g} R_p = {limit / 1e6:.4g} MPa: "
                "the race yields below the contact"
            )
        if v["stress scale"] > q.R_p:
            found.append(
                f"hoop stress {v['stress scale'] / 1e6:.4g} MPa exceeds R_p = {q.R_p / 1e6:.4g} "
                "MPa: the race yields"
            )
    if q.R_p is None and v["p_0"] > 0.025 * q.E:
        found.append(
            f"p_0 = {v['p_0'] / 1e6:.4g} MPa is {v['p_0'] / q.E:.1%} of E: no steel bears that; "
            "give R_p"
        )
    if v["a/wall"] > WIDE:
        found.append(
            f"a is {v['a/wall']:.0%} of the wall: Hertz's half plane and his dent no longer hold"
        )
    if v["load"] > 0.1 * (q.r_o - q.r_i):
        found.append("the race moves by more than a tenth of its wall: small strain is left")
    return found


def outputs(delta: str, wall: str) -> tuple[Output, ...]:
    """What `check` prints."""
    return (
        Output(key="smeared", symbol=delta, unit="µm", what="deflection by Eq. 6"),
        Output(key="load", symbol="δ(0)", unit="µm", what=f"deflection of the {wall} at a load"),
        Output(key="between", symbol="δ(π/n)", unit="µm", what="between the loads"),
        Output(key="dent, wall", symbol="δ_H", unit="µm", what="dent to the wall's depth",
               judged=False),
        Output(key="Lamé + Hertz", symbol=f"{delta} + δ_H", unit="µm", what="Eq. 6 and the dent"),
        Output(key="windup", symbol="r", unit="1", what="that over the deflection at a load",
               judged=False),
        Output(key="ripple", symbol="Δδ/δ", unit="1", what="ripple over the mean"),
        Output(key="hoop between", symbol="σ_θ", unit="MPa", what=f"hoop stress, {wall}, between"),
        Output(key="far hoop load", symbol="σ_θ", unit="MPa",
               what="hoop stress, other wall, opposite a load"),
        Output(key="a", symbol="a", unit="µm", what="half-width of the contact", judged=False),
        Output(key="p_0", symbol="p_0", unit="MPa", what="peak pressure (Hertz)", judged=False),
    )  # fmt: skip


READINGS = (
    "n is the number of sprags, N the force of one of them, R and r are radii",
    "the race is a thin ring (plane stress), as Eq. 6 has it; the contact's half-width is a long "
    "roller's (plane strain)",
)
SHARED: dict[str, Any] = {
    "paper": "huang2018",
    "analytic": analytic,
    "reference": fem,
    "levels": (8, 12, 16),
    "assumptions": (
        "linear elasticity, small strain, forces along radii, no friction",
        "Hertz's pressure on every patch, along the arc; the other wall free",
        "half a pitch with symmetry on both cuts",
    ),
    "warnings": warnings,
    "too_large": too_large,
    "equations": shown.equations,
    "tables": shown.tables,
    "sketch": sketch,
    "figures": shown.figures,
    "pictures": shown.pictures,
}

OUTER = Case(
    id="ring-loads-outer",
    title="Outer race under its sprags",
    place="Eq. 6, δ_BE; Table 1",
    lead="Eq. 6 smears the forces of n sprags into a pressure. Finite elements of half a pitch and "
    "a Fourier ring, which agree, say what that costs at a load and between loads, with the local "
    "dent and without it.",
    inputs=OuterInputs,
    scans=(Scan(vary=("n=6,12,24,48", "r_o=22mm,26.23mm,32mm,45mm")),),
    checks=tuple(checks("bore", "rim", "δ_BE")),
    outputs=outputs("δ_BE", "bore"),
    readings=(
        *READINGS,
        "the sprag's radius at the outer race is not printed: it is taken as at the inner one",
    ),
    **SHARED,
)

INNER = Case(
    id="ring-loads-inner",
    title="Inner race under its sprags",
    place="Eq. 6, δ_BI; Table 1",
    lead="The inner race is pushed in on its rim. It is the thicker ring, and what Eq. 6 smears is "
    "more of what happens there.",
    inputs=InnerInputs,
    scans=(Scan(vary=("n=6,12,24,48", "r_i=4mm,7.21mm,8.5mm,9.5mm")),),
    checks=tuple(checks("rim", "bore", "δ_BI")),
    outputs=outputs("δ_BI", "rim"),
    readings=READINGS,
    **SHARED,
)
