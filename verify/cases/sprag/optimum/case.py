"""The best crown of a sprag clutch: the paper's optimisation by kriging, at both its torques."""

from collections.abc import Sequence
from typing import Any

from verify.cases.sprag.clutch import advice
from verify.cases.sprag.clutch.sketch import sketch
from verify.cases.sprag.optimum import figures
from verify.cases.sprag.optimum.claims import checks
from verify.cases.sprag.optimum.fem import LEVELS, fem
from verify.cases.sprag.optimum.formulas import analytic
from verify.cases.sprag.optimum.inputs import Optimum25Inputs, Optimum40Inputs, OptimumInputs
from verify.core.case import Case, Output, Values
from verify.core.references import BY_SEARCHES

MOST_STEPS = 50_000  # of an engagement, of which a study has hundreds


def too_large(q: OptimumInputs) -> str:
    if said := advice.refusal(q):
        return said
    if q.mu_s < analytic(q)["mu_req"]:
        return "the sprags slip: no crown mends that"
    if q.t_end / q.dt > MOST_STEPS:
        return f"t_end/dt = {q.t_end / q.dt:.4g} is above {MOST_STEPS} steps of an engagement"
    return ""


def findings(q: OptimumInputs, v: Values) -> Sequence[str]:
    """What formulas can say of the crown at hand; the best one is found with --fem."""
    found = [
        f"the crown at hand is Lundberg's for {v['K_1 Q']:.4g} N, straight over "
        f"{v['straight'] * 1e3:.3g} mm of {q.l * 1e3:g} mm"
    ]
    if "N" in v:
        ends = "carry" if v["static end"] > 0 else "carry nothing"
        found.append(
            f"at rest under T a sprag bears {v['N']:.4g} N, {v['static peak'] / 1e6:.4g} MPa at "
            f"most, its ends {ends}; an engagement bears up to twice the force"
        )
    return found


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = False) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


SHARED: dict[str, Any] = {
    "paper": "huang2018",
    "analytic": analytic,
    "reference": fem,
    "method": BY_SEARCHES,
    "levels": LEVELS,
    "outputs": (
        output("Q", "Q", "N", "load that all crowns are made for, without yields"),
        output("K_1 Q", "K_1 Q", "N", "load whose Lundberg crown the one at hand follows"),
        output("A", "A", "µm", "its depth, by which the drop grows"),
        output("straight", "l (1 − K_2)", "mm", "its straight middle"),
        output("z_end", "z_end", "µm", "its drop at the middle of the end slices"),
        output("N", "N", "N", "normal force at rest under the torque"),
        output("static peak", "p", "MPa", "largest pressure at rest, by slices", judged=True),
        output("static mid", "p(0)", "MPa", "pressure at mid-length at rest", judged=True),
        output("designs", "", "1", "designs of the full factorial"),
    ),
    "readings": (
        "Pre_max is the largest pressure of the inner contacts' slices at the largest force",
        "z_m is in millimetres; Q is the static load at 25 N m of bodies that don't yield, "
        "T/(z R_i tan ν_0), at both torques; with their yields a sprag bears less",
        "Eq. 20: a full quadratic, a Matérn 5/2 process on what it leaves; neither is printed",
        "the genetic algorithm has Gray codes, tournaments of two, one-point crossover, and keeps "
        "its best; none of these is printed",
    ),
    "assumptions": (
        "inputs that the paper lacks are those of sprag-clutch, identified or assumed",
        "the end slice and all others are kriged apart, as squares of pressures, which go with "
        "forces; the larger counts",
        "of the largest force of an engagement the contact's pressure is that of statics",
    ),
    "quick": False,
    "findings": findings,
    "too_large": too_large,
    "equations": figures.equations,
    "sketch": sketch,
    "tables": figures.tables,
    "figures": figures.figures,
}  # fmt: skip

OPTIMUM_25 = Case(
    id="sprag-optimum",
    title="Optimal crown of a sprag clutch, 25 N m",
    place="Sec. 3, Sec. 4.2.1, Eqs. 17-21, Figs. 9, 10, 15, 16, Table 2",
    lead="The crown (K_1, K_2, z_m) whose engagement has the lowest largest pressure: 125 "
    "engagements, kriging, a genetic algorithm and differential evolution, and the engagements "
    "themselves where these end. A search without surrogate stands beside them, and the "
    "half-space, on which the crowns that are best by slices let their ends carry.",
    inputs=Optimum25Inputs,
    checks=checks(25),
    **SHARED,
)

OPTIMUM_40 = Case(
    id="sprag-optimum-40",
    title="Optimal crown of a sprag clutch, 40 N m",
    place="Sec. 3, Sec. 4.2.2, Eqs. 17-20, 22, Figs. 17, 18",
    lead="The same under the larger torque, for crowns made for the same load, and beside the "
    "smaller: what changes with the torque.",
    inputs=Optimum40Inputs,
    checks=checks(40),
    **SHARED,
)
