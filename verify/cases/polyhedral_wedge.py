"""A roller wedged between ring and race (Belcin et al., Eqs. 1-5) against contact with friction."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from analytic.contact import partial_slip
from analytic.polyhedral import wedging
from verify.case import Case, Context, Output, Values
from verify.cases import polyhedral_wedge_shown
from verify.cases.polyhedral_wedge_fem import LEVELS, fem
from verify.cases.polyhedral_wedge_inputs import WedgeInputs
from verify.cases.polyhedral_wedge_stick import FLATTEST, SHARES, TILT, small
from verify.checks import Approximation, Exact, Fact, Identity

BALANCED = "forces in balance, on any mesh"
STATICS = 1e-6  # of a value: what forces in balance may miss
MODEL = 2.0  # bound of what half planes leave out, over (a/R)²
REST = 1e-3  # of N: next to nothing
EXPELLED = 1e-6  # how close T/N is to tan(alpha/2) in the sweep
L2 = 0.03  # acceptance of tractions
EDGES = 0.01  # of the normal force: what may slip where N and T grow together


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


def too_much(q: WedgeInputs, _values: Values) -> tuple[float, float]:
    """Eq. 3 against a free roller, which uses tan(alpha/2)/mu of its friction."""
    m = 1 / q.wedged - 1
    return m - STATICS * (1 + m), m + STATICS * (1 + m)


def too_little(q: WedgeInputs, _values: Values) -> tuple[float, float]:
    """Eq. 4 against the same."""
    m = q.wedged - 1
    return m - STATICS, m + STATICS


def half_planes(q: WedgeInputs, _values: Values) -> tuple[float, float]:
    """What inclined surfaces do to the stick zone, and what half planes leave out of bodies."""
    geometry = small(q)
    tilt, size = geometry.a / (q.mu * q.R), geometry.a / q.R
    bound = tilt**2 + MODEL * size**2
    return -bound, bound


def held(context: Context) -> tuple[float, float]:
    """Nearly all of N is left with friction a per cent above tan(alpha/2)."""
    return float(context.fem[-1].arrays["around"][1] - (1 - 0.1)), 0.0


def let_out(context: Context) -> tuple[float, float]:
    """And next to nothing a per cent below."""
    return float(REST - context.fem[-1].arrays["around"][0]), 0.0


def over_angles(context: Context) -> tuple[float, float]:
    """T/(mu N) is tan(alpha/2)/mu to where the roller is squeezed out, and nothing is left then."""
    share, left, ratio = context.fem[-1].arrays["over angles"]
    mu = context.inputs.mu
    stays = wedging.holds(alpha=2 * np.arctan(share * mu), mu=mu)
    missed = np.where(stays, np.abs(ratio - share), EXPELLED / REST * np.abs(left))
    return float(EXPELLED - missed.max()), 0.0


def no_slip(context: Context) -> tuple[float, float]:
    """Less than `EDGES` of the normal force is on slipping nodes."""
    return float(EDGES - context.fem[-1].arrays["slipping"][0]), 0.0


def even(context: Context) -> tuple[float, float]:
    """The traction is tan(alpha/2) p within `L2`."""
    return float(L2 - context.fem[-1].arrays["slipping"][1]), 0.0


class PaperFact(Fact):
    """A fact about these inputs: rollers near their limit, or heavily loaded, may differ."""

    paper_only = True

    def rows(self, context: Context) -> list[Any]:
        return super().rows(context) if context.is_paper else []


def statics(name: str, symbol: str, unit: str, key: str, **more: Any) -> Identity:
    told: dict[str, Any] = {"demand": STATICS, "demand_reason": BALANCED} | more
    return Identity(name=name, symbol=symbol, unit=unit, fem=key, analytic=key, **told)


def printed(
    name: str, symbol: str, unit: str, key: str, fem: str, interval: Callable[..., Any]
) -> Approximation:
    return Approximation(
        name=name, symbol=symbol, unit=unit, analytic=key, fem=fem, interval=interval,
        source="statics of a free roller: it uses tan(α/2)/μ of its friction", demand=1e-5,
        demand_reason=BALANCED,
    )  # fmt: skip


SOLVER = "the solver's balance of a body that only contact holds"
CHECKS = (
    statics("friction force of a free roller", "T", "N", "T"),
    statics("torque of free rollers (Eq. 3, corrected)", "M_t", "N m", "M_free"),
    printed("torque of free rollers, Eq. 3 as printed", "M_t", "N m", "M_caged", "M_free",
            too_much),
    statics("torque of caged rollers (Eq. 3)", "M_t", "N m", "M_caged"),
    statics("cage force (Eq. 1)", "C", "N", "C", scale="N"),
    statics("normal force per torque, free (Eq. 5, corrected)", "N/M_t", "1/m", "N/M"),
    printed("normal force per torque, free, Eq. 4 as printed", "N/M_t", "1/m", "N/M caged", "N/M",
            too_little),
    statics("normal force per torque, caged (Eq. 4)", "N/M_t", "1/m", "N/M caged"),
    statics("least friction of a free roller (Eq. 2)", "μ_c", "1", "mu_c", demand=1e-4,
            demand_reason="bisection to five digits"),
    Fact(name="friction 1 % above tan(α/2) holds the roller (Eq. 2)", symbol="N", unit="1",
         margin=held),
    Fact(name="friction 1 % below tan(α/2) lets it out (Eq. 2)", symbol="N", unit="1",
         margin=let_out),
    Fact(name="T/(μN) over wedge angles, to the limit and beyond", symbol="T", unit="1",
         margin=over_angles),
    *(
        Approximation(name=f"stick half-width of a roller let go, T/(μN) = {k:g}", symbol="c/a",
                      unit="1", analytic=f"c/a, {k:g}", fem=f"c/a, {k:g}", formal=1,
                      interval=half_planes, source="argued: (a/(μR))² of the inclined surfaces, "
                      "2 (a/R)² of half planes")
        for k in SHARES
    ),
    PaperFact(name="N and T grow together: below 1 % of N slips", symbol="N_slip", unit="1",
              margin=no_slip),
    PaperFact(name="N and T grow together: traction within 3 % of tan(α/2) p in L2", symbol="q",
              unit="1", margin=even),
    Exact(name="balance along the bisector", symbol="ΣF", unit="N", fem="along", scale="N",
          bound=1e-9, bound_reason=SOLVER),
    Exact(name="balance of cut and contact", symbol="ΣF", unit="N", fem="across", scale="N",
          bound=1e-9, bound_reason=SOLVER),
    Exact(name="balance of cage and contact", symbol="ΣF", unit="N", fem="cage", scale="N",
          bound=1e-9, bound_reason=SOLVER),
    Exact(name="caged: all nodes at their limit", symbol="μp − q", unit="N", fem="unslipped",
          scale="N", bound=1e-10, bound_reason="Coulomb's law at every node, to round-off"),
)  # fmt: skip


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
    fem=fem,
    levels=LEVELS,
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
    equations=polyhedral_wedge_shown.equations,
    sketch=polyhedral_wedge_shown.sketch,
    figures=polyhedral_wedge_shown.figures,
    pictures=polyhedral_wedge_shown.pictures,
)  # fmt: skip
