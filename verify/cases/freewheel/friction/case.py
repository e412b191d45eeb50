"""Friction criterion of a freewheel with axial load (Nagler, Lohrengel, Eqs. 1, 2, 8 to 10)."""

from collections.abc import Sequence

from analytic.freewheel import criterion
from verify.cases.freewheel.friction import figures
from verify.cases.freewheel.friction.claims import CHECKS
from verify.cases.freewheel.friction.fem import LEVELS, fem
from verify.cases.freewheel.friction.formulas import analytic, both_contacts
from verify.cases.freewheel.pulled import Pulled
from verify.core.case import Case, Output, Scan, Values

CLOSE = 0.02  # of tan(alpha): friction that near leaves no axial load worth measuring


def warnings(q: Pulled, v: Values) -> Sequence[str]:
    found: list[str] = []
    light = str(criterion.traffic_light(v["safety"]))
    if "F_lim" not in v:
        found.append(
            f"tan α = {v['mu_t']:.4g} is not below μ = {q.mu:g} (Eq. 1): the torque alone lets the "
            "rollers out, no axial load needed"
        )
    elif light != "green":
        found.append(
            f"μ/μ_req = {v['safety']:.3g}, {light}: the clutch slips along its axis; it bears "
            f"F_ax = {v['F_lim']:.4g} N"
        )
    if v["e"] * 6 > q.L:
        found.append(
            f"the axial forces tilt the rollers: e = {v['e'] * 1e3:.3g} mm is beyond L/6, one end "
            "lifts off"
        )
    return found


def findings(_q: Pulled, v: Values) -> Sequence[str]:
    if "F_lim" not in v:
        return ("slips under the torque alone: friction is less than the wedge asks for",)
    holds = v["safety"] >= 1
    beyond = (
        f"beyond F_ax = {v['F_lim']:.4g} N it slips along the axis and turns by "
        f"{v['creep']:.3g} times that, or lets the rollers out within {v['u_out'] * 1e3:.2g} mm"
    )
    said = "holds" if holds else "slips"
    return (f"{said}: μ/μ_req = {v['safety']:.4g}, {criterion.traffic_light(v['safety'])}", beyond)


def too_large(q: Pulled) -> str:
    v = analytic(q)
    low, _ = both_contacts(q, v)
    if v["mu_t"] * (1 + CLOSE) / (1 + low) < q.mu:
        return q.refusal()
    return (
        f"tan α = {v['mu_t']:.4g} is not below μ = {q.mu:g} by {CLOSE:.0%} or more: the torque "
        "alone lets the rollers out, or nearly so; check it without --fem"
    )


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = True) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


FRICTION = Case(
    id="freewheel-friction",
    title="Friction criterion of a freewheel with axial load",
    paper="nagler2021",
    place="Eqs. 1, 2, 8-10",
    lead="The wedge says what friction rollers need, tan α, and an axial load adds to it at right "
    "angles. An elastic clutch with friction in a cone slips where that says so, under the torque "
    "and along the axis. Beyond the limit it turns as well: slip has the direction of the "
    "resultant.",
    inputs=Pulled,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    scans=(
        Scan(vary=("T=13N m,26N m", "F_ax=300N,600N,1200N"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        output("mu_req", "μ_req", "1", "required friction (Eqs. 8, 9)"),
        output("safety", "μ/μ_req", "1", "available over required friction: it holds from 1 on",
               judged=False),
        output("F_lim", "F_ax,lim", "N", "axial load on the clutch at which it slips (Eq. 9)"),
        output("mu_t", "tan α", "1", "required friction without axial load (Eq. 1)"),
        output("alpha", "α", "deg", "clamping angle under T", judged=False),
        output("N", "F_n", "N", "normal force at either contact of a roller"),
        output("F_t", "F_t", "N", "tangential force at either contact"),
        output("F_a", "F_a", "N", "axial force at either contact, F_ax/z"),
        output("creep", "R dφ/du_z", "1", "creep of the ring's bore over axial slip at the limit"),
        output("u_out", "u_out", "mm", "axial slip after which nothing is left of the torque, "
               "ring held", judged=False),
        output("e", "e", "mm", "shift of F_n along the roller by the couple of its axial forces",
               judged=False),
        output("peak", "1 + 6e/L", "1", "peak of the line load over its mean, by that",
               judged=False),
        output("pressure", "p_1/p", "1", "and of Hertz's pressure", judged=False),
    ),
    readings=(
        "T and F_ax are of the whole clutch, F_n, F_t and F_a of one contact of one roller: Eq. 8 "
        "has F_a = F_ax/z where Eq. 9 has F_ax",
        "α is half the angle between flat and ring at the roller, that under load",
        "the lever of F_t is the ring's bore radius R",
        "μ_req has a symbol of its own: Eq. 8 calls it tan α, which is F_t/F_n (Eq. 1)",
        "at μ = μ_req the clutch holds, as Eqs. 1 and 8 and the classes have it; not Eqs. 9, 10",
    ),
    assumptions=(
        "dimensions, μ and F_ax are yours: the paper prints none for its clutches; this clutch is "
        "synthetic, at the rig's largest torque",
        "finite elements have u_z(x, y) beside plane strain: long rollers, the axial load spread "
        "evenly on the ring's rim, rollers free along the axis, the star clamped on its shaft",
        "the axial forces of a roller are a couple 2 r cos α F_a that tilts it: F_n moves by e "
        "along it to either side. Neither the criterion nor elements that are alike along the "
        "axis contain that: e and the peak are outputs of a linear line load, judged by nothing",
        "contacts keep their places and normals: displacements are small against the radii. Where "
        "friction is measured the roller is steered to stay where it is",
        "the drive keeps the torque up beyond the limit, or holds the ring: both are shown",
        "one coefficient of friction, no rate, no oil; the couples of all rollers cancel on star "
        "and ring",
    ),
    findings=findings,
    warnings=warnings,
    too_large=too_large,
    equations=figures.equations,
    tables=figures.tables,
    sketch=figures.sketch,
    figures=figures.figures,
    pictures=figures.pictures,
)  # fmt: skip
