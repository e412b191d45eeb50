"""Partial slip of two equal rollers (Cattaneo) and the cycle of a swinging force (Mindlin)."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from typing import Any, ClassVar

import numpy as np

from analytic.contact import hertz_line, partial_slip, tangential_cycle
from verify.case import Case, Context, Output, Values
from verify.cases import contact_slip_shown
from verify.cases.contact_slip_fem import SHARES, STAGES, fem
from verify.cases.contact_slip_inputs import SlipInputs
from verify.checks import Approximation, Exact, Fact, Identity
from verify.claims import FemClaim
from verify.results import Kind, Row

HALF_PLANES = 2e-4  # share of the half planes' own error below which they and the discs are one
MODEL = 2.0  # bound of that error over (a/R)²
AGREE = 1e-3  # two ways to one energy
L2 = 0.03  # acceptance of tractions
FE_SHARES = (0.4, 0.9)  # amplitudes whose slip strips the meshes resolve
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


def neglected(q: SlipInputs) -> float:
    """Bound of what half planes leave out of discs, as a share of a value.

    By symmetry a disc's tangential load does not change the gap, and terms odd in a/R vanish. Of
    order (a/R)² are the circle against the parabola, which steepens the profile by a quarter of
    (a/R)² at the edge, and the even parts x² + x'² of the two kernels, normal and tangential, each
    with a factor of a half or less about the logarithm. Half-widths enter squared in displacements
    and energies: all of it together stays below twice (a/R)².
    """
    return MODEL * (q.a / q.R) ** 2


@dataclass(frozen=True, kw_only=True)
class HalfPlanes(FemClaim):
    """Identity while discs are half planes to what a row can see, else an approximation."""

    kind = Kind.IDENTITY

    analytic: str

    def rows(self, context: Context) -> list[Row]:
        own = {f.name: getattr(self, f.name) for f in fields(self)}
        if neglected(context.inputs) <= HALF_PLANES:
            return Identity(**own).rows(context)
        demand = self.demanded(context)

        def interval(q: SlipInputs, _values: Values) -> tuple[float, float] | None:
            bound = neglected(q) + demand / 2  # nothing sharper is claimed of wide contacts
            return (-bound, bound) if neglected(q) <= demand / 4 else None

        source = f"±{MODEL:g} (a/R)², and half of the demand"
        return Approximation(**own, interval=interval, source=source).rows(context)


@dataclass(frozen=True, kw_only=True)
class Traction(Fact):
    """A traction's error in L2 below its acceptance, on the resolution made for it."""

    paper_only: ClassVar[bool] = True

    def rows(self, context: Context) -> list[Row]:
        return super().rows(context) if context.is_paper else []


def first_traction(q: SlipInputs, x: Any, k: float) -> Any:
    """Cattaneo's traction [Pa] at x under Q = k mu P."""
    return partial_slip.traction(x, Q=k * q.mu * q.P, a=q.a, **q.loads)


def cycle_traction(q: SlipInputs, x: Any, stage: float) -> Any:
    """Mindlin's traction [Pa] at x on the way down, at Q = `stage` Q_max."""
    Q_max = q.share * q.mu * q.P
    return tangential_cycle.traction(
        x, Q=stage * Q_max, Q_max=Q_max, a=q.a, branch="unloading", **q.loads
    )


def l2_margin(
    name: str, formula: Callable[..., Any], at: float, scale_at: float
) -> Callable[[Context], tuple[float, float]]:
    """Acceptance less the error in L2 against `formula`, over its norm at `scale_at`."""

    def margin(context: Context) -> tuple[float, float]:
        q = context.inputs
        x, found, weight = context.fem[-1].arrays[f"points, {name}"]
        error, norm = found - formula(q, x, at), formula(q, x, scale_at)
        return float(L2 - np.sqrt((error**2 @ weight) / (norm**2 @ weight))), 0.0

    return margin


def two_ways(context: Context) -> tuple[float, float]:
    """How far below `AGREE` the loop's area and the work of friction differ."""
    area, work = (context.series(key)[1][-1] for key in ("loop's area", "friction's work"))
    u = context.fem[-1].u_it["area by steps"]
    return AGREE - abs(area / work - 1), 2 * u / work


def step_order(context: Context) -> tuple[float, float]:
    """Order above 1.8 in which straight lines between steps approach the loop's area.

    Against friction's work, which is exact for any steps: a node slips under mu p alone, however
    far. What Simpson's rule leaves of the difference is the mesh's own jitter, and uncertain.
    """
    result = context.fem[-1]
    x, Q = result.arrays["loop, x"], result.arrays["loop, Q"]
    work, area = result.values["friction's work"], result.values["loop's area"]
    coarse, fine = (abs(abs(np.trapezoid(Q[::n], x[::n])) - work) for n in (4, 2))
    return float(np.log2(coarse / fine) - 1.8), float(2 * abs(area - work) / fine / np.log(2))


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
    Fact(name="cycle: both energies agree within 0.1 %", symbol="W", unit="1", margin=two_ways),
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
    fem=fem,
    levels=(24, 40, 56),
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
