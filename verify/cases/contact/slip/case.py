"""Partial slip of two equal rollers (Cattaneo) and the cycle of a swinging force (Mindlin)."""

from collections.abc import Sequence
from typing import Any

from analytic.contact import hertz_line, partial_slip, tangential_cycle
from verify.cases.contact.slip import figures as contact_slip_shown
from verify.cases.contact.slip.claims import (
    AGREE,
    HALF_PLANES,
    HalfPlanes,
    Traction,
    cycle_traction,
    first_traction,
    l2_margin,
    neglected,
    step_order,
    two_ways,
)
from verify.cases.contact.slip.fem import SHARES, STAGES, fem
from verify.cases.contact.slip.inputs import SlipInputs
from verify.core.case import Case, Output, Scan, Values
from verify.judging.checks import Exact, Fact
from verify.judging.tolerance_checks import Agreement, suites

FE_SHARES = (0.5, 0.9)  # amplitudes whose slip strips the meshes resolve
SECANT = "loads are met within 1e-12 of P, and states within 1e-11"


def analytic(q: SlipInputs) -> Values:
    limit, moved = q.mu * q.P, {**q.loads, "E_star": q.E_star}
    Q_max = q.share * limit
    relative = float(hertz_line.relative_radius(R_1=q.R, R_2=q.R))
    values: dict[str, Any] = {
        "half-width": q.a,
        "peak pressure": hertz_line.peak_pressure(P=q.P, R=relative, E_star=q.E_star),
        "load": q.P, "limit": limit, "amplitude": Q_max, "couple": q.P * q.R,
        "stick at Q_max": partial_slip.stick_half_width(Q=Q_max, a=q.a, **q.loads),
        "beyond stick": partial_slip.rigid_displacement_beyond_stick(Q=Q_max, **moved),
        "left at Q = 0": tangential_cycle.rigid_displacement_beyond_stick(
            Q=0.0, Q_max=Q_max, branch="unloading", **moved
        ),
        "energy": tangential_cycle.dissipation(Q_max=Q_max, **moved),
    }  # fmt: skip
    beyond = {k: partial_slip.rigid_displacement_beyond_stick(Q=k * limit, **moved) for k in SHARES}
    for k in SHARES:
        values[f"stick, k = {k:g}"] = partial_slip.stick_half_width(Q=k * limit, a=q.a, **q.loads)
        values[f"beyond chord, k = {k:g}"] = beyond[k] - k / SHARES[-1] * beyond[SHARES[-1]]
    return {key: float(value) for key, value in values.items()}


def warnings(q: SlipInputs, v: Values) -> Sequence[str]:
    found: list[str] = []
    if neglected(q) > HALF_PLANES * 10:
        found.append(
            f"a/R = {q.a / q.R:.3g}: the rollers are no half planes, the formulas miss up to "
            f"{neglected(q):.1%}"
        )
    if q.hardness is not None and v["peak pressure"] > q.hardness:
        found.append(
            f"p_0 = {v['peak pressure'] / 1e6:.4g} MPa exceeds p_lim = {q.hardness / 1e6:.4g} MPa: "
            "the surfaces yield, contact and slip strips grow"
        )
    if q.hardness is None and v["peak pressure"] > 0.02 * q.E:
        found.append(
            f"p_0 = {v['peak pressure'] / 1e6:.4g} MPa is {v['peak pressure'] / q.E:.1%} of E: "
            "most steels yield before; give p_lim"
        )
    if q.mu > 0.5:
        found.append(
            f"μ = {q.mu:g}: friction this high brings the largest shear stress to the surface, "
            "and yielding there before sliding"
        )
    return found


def too_large(q: SlipInputs) -> str:
    low, high = FE_SHARES
    if low <= q.share <= high:
        return ""
    return (
        f"Q/(μP) = {q.share:g}: the meshes resolve slip and stick of amplitudes from {low:g} to "
        f"{high:g}; check it without --fem"
    )


def half_planes(name: str, symbol: str, unit: str, key: str, **more: Any) -> HalfPlanes:
    keys: dict[str, Any] = {"fem": key, "analytic": key, "formal": 1} | more
    return HalfPlanes(name=name, symbol=symbol, unit=unit, **keys)


STICK: dict[str, Any] = {"demand": 2e-3, "demand_reason": "the stick zone is known to 0.2 %"}
CHECKS = (
    *(
        half_planes(f"stick half-width, Q/(μP) = {k:g}", "c", "µm", f"stick, k = {k:g}", **STICK)
        for k in SHARES
    ),
    half_planes("stick half-width at Q_max", "c", "µm", "stick at Q_max", **STICK),
    *(
        Traction(name=f"traction within 3 % in L2, Q/(μP) = {k:g}", symbol="q", unit="1",
                 margin=l2_margin(f"k = {k:g}", first_traction, k, k))
        for k in SHARES
    ),
    *(
        half_planes(f"displacement beyond the chord, Q/(μP) = {k:g}", "δ − δ_c", "nm",
                    f"beyond chord, k = {k:g}")
        for k in SHARES[:-1]
    ),
    *(
        Traction(name=f"cycle: traction within 3 % in L2, Q/Q_max = {s:g}", symbol="q", unit="1",
                 margin=l2_margin(f"Q/Q_max = {s:g}", cycle_traction, s, 1.0))
        for s in STAGES
    ),
    half_planes("cycle: displacement left at Q = 0", "δ(0)", "nm", "left at Q = 0"),
    half_planes("cycle: energy lost, work of friction", "W", "µJ/m", "friction's work",
                analytic="energy"),
    half_planes("cycle: energy lost, area of the loop", "∮Q dδ", "µJ/m", "loop's area",
                analytic="energy"),
    Agreement(name="cycle: both energies agree within 0.1 %", symbol="W", unit="J/m",
              pair=two_ways, accepted=AGREE,
              source=suites("two sums over one solution"), by="friction's work", everywhere=True),
    Fact(name="cycle: order of the loop's area in its steps above 1.8", symbol="p", unit="1",
         margin=step_order),
    Exact(name="cycle: one step or many", symbol="Δq", unit="MPa", fem="steps",
          scale="peak pressure", bound=1e-9, bound_reason=SECANT),
    Exact(name="cycle: closes", symbol="Δq", unit="MPa", fem="closure", scale="peak pressure",
          bound=1e-9, bound_reason=SECANT),
    Exact(name="sliding: Q = μP", symbol="Q − μP", unit="N/mm", fem="sliding force", scale="limit",
          bound=1e-10, bound_reason="every node at its limit of friction, to round-off"),
    Exact(name="balance of both cuts", symbol="ΣF", unit="N/mm", fem="balance of cuts",
          scale="load", bound=1e-9, bound_reason=SECANT),
    Exact(name="balance of cut and contact", symbol="ΣF", unit="N/mm", fem="passed on",
          scale="load", bound=1e-9, bound_reason=SECANT),
    Exact(name="balance of moments, cut and contact", symbol="ΣM", unit="N", fem="moment",
          scale="couple", bound=1e-9, bound_reason=SECANT),
)  # fmt: skip

SLIP = Case(
    id="contact-slip",
    title="Partial slip and the cycle of a swinging force",
    paper="huang2018",
    place="Eqs. 11-14, what lies between stick and slip",
    lead="Before a sprag slides, its contact slips at the edges and sticks in the middle. Cattaneo "
    "and Mindlin say where, how far, and what a cycle costs; two elastic rollers pressed together "
    "and pushed sideways say whether that holds.",
    inputs=SlipInputs,
    analytic=analytic,
    reference=fem,
    levels=(24, 40, 56),
    scans=(Scan(vary=("share=0.3,0.6,0.9", "mu=0.1,0.2"), star=True),),
    checks=CHECKS,
    outputs=(
        Output(key="half-width", symbol="a", unit="µm", what="half-width of the contact",
               judged=False),
        Output(key="peak pressure", symbol="p_0", unit="MPa", what="peak pressure", judged=False),
        Output(key="amplitude", symbol="Q_max", unit="N/mm", what="amplitude of the force",
               judged=False),
        Output(key="stick at Q_max", symbol="c", unit="µm", what="stick half-width at Q_max"),
        Output(key="beyond stick", symbol="δ(Q_max)", unit="nm",
               what="displacement by slip at Q_max", judged=False),
        Output(key="left at Q = 0", symbol="δ(0)", unit="nm",
               what="displacement left when Q has gone back to 0"),
        Output(key="energy", symbol="W", unit="µJ/m", what="energy lost in a cycle, per length"),
    ),
    readings=(
        "R is the rollers' radius, and both are elastic: relative radius R/2, 1/E* = 2 (1 − ν²)/E",
        "long rollers: plane strain, and P, Q per unit length",
        "one coefficient of friction, for sticking and for sliding",
        "Q is the force that passes through the contact, not the sum on both rollers",
    ),
    assumptions=(
        "equal materials: tangential forces do not change the pressure (Dundurs' β = 0)",
        "small strain; P held while Q changes; no wear, no rate",
        "two half discs, each held along its cut: half planes up to terms of (a/R)²",
        "P and Q are met to 1e-12 by the cut's displacements (secant steps)",
        "P, μ and ν are not the paper's: μ from a usual lubricated steel contact, P so that "
        "a/R = 0.01",
        "stick half-width: from the moments of q, (c/a)² = 4 M₂/(M₀ a²) − 1",
        "displacements count beyond the chord from 0 to Q = 0.8 μP: the elastic part, linear in "
        "Q, drops out without being known",
    ),
    warnings=warnings,
    too_large=too_large,
    equations=contact_slip_shown.equations,
    sketch=contact_slip_shown.sketch,
    figures=contact_slip_shown.figures,
    pictures=contact_slip_shown.pictures,
)  # fmt: skip
