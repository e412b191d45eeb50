"""The whole clutch, parts to torque: the paper's formulas and the elastic ring."""

from collections.abc import Sequence
from math import atan, inf, isfinite
from typing import Any

import numpy as np

from analytic.contact.checks import Assumption
from analytic.polyhedral import bore_pressure, wedging
from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.design import Clutch
from analytic.polyhedral.locking import Roller, RollerContact
from analytic.polyhedral.parts import Parts
from analytic.polyhedral.rim_slope import steepest
from analytic.polyhedral.sector import Sector
from verify.cases.polyhedral.clutch import figures
from verify.cases.polyhedral.clutch.claims import CHECKS, slack
from verify.cases.polyhedral.clutch.fem import DrivenRing
from verify.cases.polyhedral.clutch.inputs import ClutchInputs
from verify.cases.polyhedral.clutch.stress import in_fillet
from verify.cases.polyhedral.fem import largest_in_fillet, whole
from verify.cases.polyhedral.warnings import of_fillets
from verify.core.case import Case, FemResult, Scan, Values
from verify.core.figures import Field

LEVELS = (1, 2, 3, 4)
WIDE = 2.0  # walls: wider rings are not in plane stress all along
STATIC_RATING = 4.0e9  # Pa, ISO 76: roller bearings at their static load rating


def sector(q: ClutchInputs) -> Sector:
    """Half a sector for the series."""
    return Sector(z=q.z, d_e=q.d_e, d_i=q.ring.d_i, rho=q.rho)


def grip(q: ClutchInputs) -> float:
    """Tangential over normal force of the rollers: tan(α/2) if they stay, else μ, the limit."""
    from analytic.polyhedral.wedging import holds  # of both sides: a load

    if q.alpha is None or not holds(alpha=q.alpha, mu=q.mu):
        return q.mu
    return float(np.tan(q.alpha / 2))


def driven(
    q: ClutchInputs, *, rigid: bool = False, assumption: Assumption = "plane stress",
    share: float | None = None,
) -> Driven:  # fmt: skip
    """The locked ring that its hub turns; rollers as elastic as the ring, or rigid.

    `share` is another tangential over normal force than `grip`.
    """
    own = {} if rigid else {"E": q.E, "nu": q.nu}
    contact = RollerContact(sector(q), Roller(d=q.d, j_D=q.j_D, **own), q.E, q.nu, assumption)
    grips = grip(q) if share is None else share
    return Driven(contact, grip=grips, D_i=q.D_i, e=q.e, tan_phi=q.tan_phi)


def paper(q: ClutchInputs, **readings: Any) -> Clutch:
    """The paper's formulas, corrected, in one of their readings."""
    rho = readings.pop("rho", q.rho)
    parts = Parts(z=q.z, d_i=q.ring.d_i, d_e=q.d_e, D_i=q.D_i, d=q.d, b=q.b, e=q.e, rho=rho)
    return Clutch(
        parts, p_t=q.p_t, E=q.E, nu=q.nu, mu=q.mu, phi_1=atan(q.tan_phi), alpha=q.alpha,
        M_wanted=q.M_t, **readings,
    )  # fmt: skip


def analytic(q: ClutchInputs) -> Values:
    """The chain's values; what is without a limit, or not defined, is left out."""
    ring = sector(q)
    K = bore_pressure.stiffness_factors(sector=ring, nu=q.nu, assumption="plane stress").mid
    full = paper(q, K=K)
    first = paper(q, K=1.0, lever="d_i/2", gamma="radius", rho=0.0)
    hub, stiff, lever = driven(q), driven(q, rigid=True), q.b * q.z * q.D_i / 2
    stays = q.alpha is None or bool(wedging.holds(alpha=q.alpha, mu=q.mu))
    N, N_rigid = (rollers.force(q.p_t) if stays else 0.0 for rollers in (hub, stiff))
    N_t = q.M_t / (hub.grip * lever) if stays else inf
    slope = steepest(sector=ring, field=bore_pressure.pressed(ring))[0] * q.p_t / q.E
    offered, wide = driven(q, share=np.tan(slope / 2)), driven(q, assumption="plane strain")
    parts = full.parts
    values = {
        "beta": parts.beta, "d_m": parts.d_m, "j_D": parts.j_D, "apothem": parts.apothem,
        "psi": parts.psi, "lever": full.arm, "sigma_t": full.sigma_t, "p_1": full.p_1, "K": K,
        "p_1r": full.p_1r, "sigma_tr": full.sigma_tr, "p_2": full.p_2, "F": full.F,
        "hub share": full.hub_share, "M Eq. 20": full.M_t, "T": full.T, "F_s": full.F_s,
        "R": full.R, "N": full.N, "p Eq. 20": full.p_required, "M Eq. 21": first.M_t,
        "kappa": hub.kappa, "grip": hub.grip, "touch": q.j_D / 2 / hub.contact.growth,
        "N series": N * q.b, "M series": hub.grip * N * lever,
        "M rigid": stiff.grip * N_rigid * lever,
        "p series": hub.required_pressure(N_t) if stays else inf,
        "margin": hub.grip * N * lever / q.M_t, "N wanted": N_t * q.b,
        "fillet": in_fillet(hub, N, q.p_t),
        "slope": slope, "M slope": offered.grip * offered.force(q.p_t) * lever,
        "M wide": wide.grip * wide.force(q.p_t) * lever if stays else 0.0,
        "needed": 2 * np.arctan(hub.grip), "side": q.p_t * q.ring.d_i * np.sin(ring.half_angle),
    }  # fmt: skip
    carried = [load for load in (N, N_t) if isfinite(load)]
    if carried:  # under p_t, or where the torque is reached if that takes more
        values |= {"p_0 ring": pressure(q, max(carried), q.d_e / 2),
                   "p_0 race": pressure(q, max(carried), -q.D_i / 2)}  # fmt: skip
    if isfinite(values["p series"]):
        values["fillet needed"] = in_fillet(hub, N_t, values["p series"])
    if 0 < N < inf:
        values |= {"slack": slack(q, hub, N) * hub.force_sensitivity(N),
                   "slack p": slack(q, hub, N_t) * hub.pressure_sensitivity(N_t),
                   "driven": abs(1 - in_fillet(hub, 0.0, q.p_t) / values["fillet"])}  # fmt: skip
    if 0 < N_rigid < inf:
        values["slack rigid"] = slack(q, stiff, N_rigid) * stiff.force_sensitivity(N_rigid)
    return {key: float(value) for key, value in values.items() if isfinite(value)}


def pressure(q: ClutchInputs, N: float, R_2: float) -> float:
    """Hertz's largest pressure [Pa] of a roller under N [N/m] against the radius R_2 [m]."""
    curvature = 2 / q.d + 1 / R_2
    return float(np.sqrt(N * curvature * q.E / (1 - q.nu**2) / (2 * np.pi)))


def fem(q: ClutchInputs, level: int) -> FemResult:
    hub = DrivenRing(q, level, grip=grip(q), elastic=True)
    N, N_t = hub.N, q.M_t / (grip(q) * q.b * q.z * q.D_i / 2)
    if not isfinite(N):
        raise ArithmeticError("the hub's lift locks the rollers: pressure does not limit N")
    p = hub.pressure(N_t)
    state = hub.at(q.p_t, N)
    rest = hub.ring.balance(q.p_t, hub.push(N))
    values = {
        "N series": N * q.b, "M series": grip(q) * N * q.b * q.z * q.D_i / 2, "p series": p,
        "fillet": largest_in_fillet(q.ring, state.plane, q.p_t, name="ring.fillet"),
        "balance x": rest[0], "balance y": rest[1],
        "moment": q.b * q.z * moment(q, hub.push(N)) - grip(q) * N * q.b * q.z * q.D_i / 2,
    }  # fmt: skip
    if isfinite(N_rigid := DrivenRing(q, level, grip=grip(q), elastic=False).N):
        values["M rigid"] = grip(q) * N_rigid * q.b * q.z * q.D_i / 2
    u_it = {key: 1e-9 * abs(value) for key, value in values.items()}
    fields = (drawn_fem(q, N),) if level == LEVELS[-1] else ()
    return FemResult(h=1 / level, values=values, u_it=u_it, fields=fields)


def drawn_fem(q: ClutchInputs, N: float) -> Field:
    """Ring and rollers under p_t and what belongs to N [N/m], on a coarse mesh."""
    coarse = DrivenRing(q, 1, grip=grip(q), elastic=True).at(q.p_t, N).plane.cells()
    return whole("driven", q.z, coarse, von_mises=(coarse["von_mises"], "Pa"))


def moment(q: ClutchInputs, push: tuple[float, float]) -> float:
    """Moment [N] about the axis of a hub force (normal, along the flat) [N/m] at e."""
    return q.e * push[0] - q.ring.apothem * push[1]


def warnings(q: ClutchInputs, v: Values) -> Sequence[str]:
    found = []
    if q.alpha is not None and not wedging.holds(alpha=q.alpha, mu=q.mu):
        found.append(
            f"the rollers are expelled: tan(α/2) = {np.tan(q.alpha / 2):.4g} is not below μ = "
            f"{q.mu:g}; without a cage they carry nothing"
        )
    elif q.p_t <= v["p_1r"]:
        found.append(
            f"p_t = {q.p_t / 1e6:.4g} MPa is not above p_1r = {v['p_1r'] / 1e6:.4g} MPa: the ring "
            "does not reach its rollers, no torque"
        )
    elif "M series" not in v:
        found.append(
            "once it touches, the hub alone wedges the rollers ever further: strength limits the "
            "torque, pressure does not; a larger e or a smaller μ leads back"
        )
    elif v["margin"] < 1:
        found.append(
            f"elastic ring and rollers carry {v['M series']:.4g} N m, less than the "
            f"{q.M_t:.4g} N m that are wanted: p_t must be {v['p series'] / 1e6:.4g} MPa, under "
            f"which the fillets carry {v['fillet needed'] / 1e6:.4g} MPa"
        )
    if v["needed"] > v["slope"]:
        found.append(
            "without a cage a wedge angle is required of "
            f"{np.degrees(v['needed']):.3g}°; available are "
            f"{np.degrees(v['slope']):.2g}° under p_t, which carry {v['M slope']:.3g} N m: a "
            "cage transmits the remainder"
        )
    if q.b > WIDE * q.delta_1 and "M wide" in v:
        found.append(
            f"b/δ_1 = {q.b / q.delta_1:.3g}: neither plane stress, as taken, nor plane "
            f"strain, which gives {v['M wide']:.4g} N m; rollers press more on the ends"
        )
    if v["hub share"] >= 1:
        found.append(
            f"the hub's share of N is {v['hub share']:.3g} by Eq. 16: friction that locks, Eqs. "
            "17 to 20 set no limit to the torque"
        )
    worst = max(v.get("p_0 ring", 0.0), v.get("p_0 race", 0.0))
    if worst > STATIC_RATING:
        found.append(
            f"p_0 = {worst / 1e6:.4g} MPa on the rollers is beyond 4000 MPa, the static rating of "
            "hardened rollers (ISO 76)"
        )
    found += of_fillets(v["fillet"], E=q.E, R_p=q.R_p, when=" under p_t")
    return found


def too_large(q: ClutchInputs) -> str:
    """Rows compare forces of rollers that pressure limits."""
    if q.alpha is not None and not wedging.holds(alpha=q.alpha, mu=q.mu):
        return "the rollers are expelled: there is no torque to compare, check it without --fem"
    hub = driven(q)
    N = hub.force(q.p_t)
    if not isfinite(N):
        return "pressure does not limit the torque: nothing to compare, check it without --fem"
    if not hub.rises(q.M_t / (hub.grip * q.b * q.z * q.D_i / 2)):
        return (
            f"no pressure holds M_t = {q.M_t:.4g} N m, the hub wedges the rollers ever further: "
            "nothing to compare, check it without --fem"
        )
    if 1e-3 * q.p_t * q.ring.d_i > N:
        return (
            f"p_t = {q.p_t / 1e6:.4g} MPa hardly reaches the rollers: there is no torque to "
            "compare, check it without --fem"
        )
    return ""


CLUTCH = Case(
    id="polyhedral-clutch",
    title="Polyhedral ring clutch, from its parts to its torque",
    paper="belcin",
    place="Eqs. 3-4, 6-21",
    lead="Every value of the paper's chain from dimensions, friction and pressure, and the torque "
    "that is left when ring and rollers are elastic, which finite elements confirm. The corrected "
    "Eq. 21 promises several times as much. Sizes and loads are the project's.",
    inputs=ClutchInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    scans=(
        Scan(
            vary=("p_t=25MPa,30MPa,45MPa,60MPa", "delta_1=3mm,4mm,5mm", "mu=0.06,0.08,0.1"),
            star=True,
        ),
    ),
    checks=CHECKS,
    outputs=figures.OUTPUTS,
    readings=(
        "misprints corrected: the side of the polygon for its arc (13, 17, 20, 21), no factor "
        "β/360 in Eq. 21",
        "Eq. 20: K of the middle of the flats, lever apothem/cos ψ, γ = 0; Eq. 21: K = 1, lever "
        "d_i/2, γ = ψ, corners without fillets",
        "rollers with a wedge angle α carry N tan(α/2); without one they are at the limit μ N, as "
        "in Eqs. 4 and 17 to 21: α = 2 arctan μ, no force of a cage. What a cage adds to the "
        "race's torque does not pass through the ring",
        "the hub's force R leans by φ_1 towards the flat's middle: it makes ψ + φ_1 with the "
        "radius through its contact, as Eq. 14 has it",
        "series: complex potentials of the ring; unit pressure and unit hub force lift the middle "
        "of the flats by u_p and u_h1, a roller's force presses it back by u_N(a) N, its own dent "
        "included, and is squeezed by δ(N); κ = R/N",
        "margin and pressure for the torque wanted are those of elastic ring and rollers",
    ),
    assumptions=(
        "linear elasticity, small strain; ring and rollers in plane stress, the race rigid; rigid "
        "rollers set an upper bound of the torque",
        "friction at the rollers turns the ring against the hub: by symmetry it lifts nothing "
        "above the middle of the flats",
        "the hub's force at e counts as half of it on each side of the flat's middle",
    ),
    warnings=warnings,
    too_large=too_large,
    equations=figures.equations,
    sketch=figures.sketch,
    figures=figures.figures,
    pictures=figures.pictures,
)  # fmt: skip
