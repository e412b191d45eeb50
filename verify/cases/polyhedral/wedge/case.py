"""A roller wedged between ring and race (Belcin et al., Eqs. 1-5) against contact with friction."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.contact import partial_slip
from analytic.polyhedral import wedging
from verify.cases.polyhedral.wedge import figures
from verify.cases.polyhedral.wedge.claims import CHECKS
from verify.cases.polyhedral.wedge.fem import LEVELS, fem
from verify.cases.polyhedral.wedge.inputs import WedgeInputs
from verify.cases.polyhedral.wedge.stick import FLATTEST, SHARES, TILT, small
from verify.core.case import Case, Output, Scan, Values


def analytic(q: WedgeInputs) -> Values:
    angle, clutch = {"alpha": q.alpha}, {"z": q.z, "D_i": q.D_i}
    values: dict[str, Any] = {
        "a": q.a, "p_0": q.p_0, "N": q.N, "share": q.wedged, "mu_c": least_friction(q),
        "alpha_max": wedging.largest_angle(mu=q.mu),
        "M_caged": wedging.largest_torque(N=q.N, mu=q.mu, **clutch),
        "C": wedging.cage_force(N=q.N, mu=q.mu, **angle),
        "N/M caged": wedging.least_normal_force(M_t=1.0, mu=q.mu, **clutch),
    }  # fmt: skip
    if wedging.holds(mu=q.mu, **angle):
        values |= {
            "T": wedging.tangential_force(N=q.N, **angle),
            "M_free": wedging.torque(N=q.N, **angle, **clutch),
            "N/M": wedging.normal_force(M_t=1.0, **angle, **clutch),
        }
    for k in SHARES:
        a = small(q).a
        values[f"c/a, {k:g}"] = partial_slip.stick_half_width(Q=k, P=1.0, mu=1.0, a=a) / a
    return {key: float(value) for key, value in values.items()}


def least_friction(q: WedgeInputs) -> float:
    """The friction for which Eq. 1 leaves nothing, its sides being linear in it."""
    low, high = 0.25, 0.75
    at = [float(wedging.cage_force(N=q.N, alpha=q.alpha, mu=mu)) for mu in (low, high)]
    return low - at[0] * (high - low) / (at[1] - at[0])


def warnings(q: WedgeInputs, v: Values) -> Sequence[str]:
    found: list[str] = []
    if "M_free" not in v:
        found.append(
            f"tan(α/2) = {np.tan(q.half):.4g} is not below μ = {q.mu:g} (Eq. 2): a free roller "
            "is squeezed out of the wedge and carries no torque"
        )
    elif q.wedged > 0.9:
        found.append(
            f"tan(α/2) = {q.wedged:.3f} μ: friction a tenth lower lets the roller out of the wedge"
        )
    if q.p_lim is not None and q.p_0 > q.p_lim:
        found.append(
            f"p_0 = {q.p_0 / 1e6:.4g} MPa exceeds p_lim = {q.p_lim / 1e6:.4g} MPa: the surfaces "
            "yield"
        )
    if q.p_lim is None and q.p_0 > 0.02 * q.E:
        found.append(
            f"p_0 = {q.p_0 / 1e6:.4g} MPa is {q.p_0 / q.E:.1%} of E: most steels yield before; "
            "give p_lim"
        )
    return found


def too_large(q: WedgeInputs) -> str:
    if q.wedged < 1:
        return ""
    return (
        f"tan(α/2) = {np.tan(q.half):.4g} is not below μ = {q.mu:g}: the roller is squeezed out, "
        "and there is no equilibrium to compute; check it without --fem"
    )


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = True) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


WEDGE = Case(
    id="polyhedral-wedge",
    title="Roller wedged between ring and race",
    paper="belcin",
    place="Eqs. 1-5",
    lead="A roller in a wedge stays where tan(α/2) is below μ, and then friction on it is no more "
    "than N tan(α/2): the printed torque μ N z D_i/2 is that of rollers which a cage holds back "
    "until they slip. An elastic roller on an elastic race with friction says the same.",
    inputs=WedgeInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    scans=(
        Scan(vary=("alpha=4deg,6deg,8deg", "N=500N,1500N,4000N"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        output("M_free", "M_t", "N m", "torque of z free rollers under N"),
        output("M_caged", "M_t,max", "N m", "torque at which z caged rollers slip (Eq. 3)"),
        output("T", "T", "N", "tangential force at either contact of a free roller"),
        output("share", "tan(α/2)/μ", "1", "part of its friction that a free roller uses",
               judged=False),
        output("alpha_max", "α_max", "deg", "wedge angle below which a free roller stays",
               judged=False),
        output("mu_c", "μ_c", "1", "least friction that holds a free roller"),
        output("C", "C", "N", "force that pulls a roller out of the wedge (Eq. 1)"),
        output("a", "a", "µm", "half-width of the contacts (Hertz)", judged=False),
        output("p_0", "p_0", "MPa", "peak pressure of the contacts (Hertz)", judged=False),
    ),
    readings=(
        "α is the full angle between both tangents: each normal is α/2 off the roller's middle "
        "plane",
        "D_i is a diameter: the lever of T is D_i/2",
        "N and T are forces at one contact of one roller, and z rollers carry the torque",
        "a free roller is held by its contacts alone; a cage force acts along the bisector",
        "rollers are long: plane strain, which moves Hertz's half-width alone",
    ),
    assumptions=(
        "α, μ, N, d and b are yours: the paper prints no number for them, nor an equation for α",
        "ring and race are alike flats about the roller: half of it is modelled, its cut on the "
        "bisector; the race's convexity changes the contact's width, not the statics",
        "roller and race of one material: tangential forces leave the pressure alone; on a rigid "
        "flat pressing alone would make nearly all of the contact slip",
        "gap and pressure act along the flat race's normal, so that a roller which slides stays "
        "in the same wedge; along the deformed surfaces between both where the stick zone is "
        "measured",
        "the stick zone is measured under a load of its own, small enough for Cattaneo's half "
        f"planes: a/(μR) = {TILT:g}, a/R at most {FLATTEST:g}",
        "roller without weight, one coefficient of friction, no rate",
    ),
    warnings=warnings,
    too_large=too_large,
    equations=figures.equations,
    sketch=figures.sketch,
    figures=figures.figures,
    pictures=figures.pictures,
)  # fmt: skip
