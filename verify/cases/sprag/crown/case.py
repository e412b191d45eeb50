"""What the crown's three parameters do to a sprag clutch's pressures (Secs. 4.1 and 4.2)."""

from verify.cases.sprag.clutch.advice import refusal as too_large_at_rest
from verify.cases.sprag.crown.claims import CHECKS
from verify.cases.sprag.crown.fem import LEVELS, fem
from verify.cases.sprag.crown.figures import equations, figures, sketch
from verify.cases.sprag.crown.formulas import analytic
from verify.cases.sprag.crown.messages import findings, summary, warnings
from verify.cases.sprag.crown.table2 import table_2
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import Case, Context, Output, Scan
from verify.core.figures import Table
from verify.core.references import BY_STRIPS


def too_large(q: EngagementInputs) -> str:
    if q.z_m == 0:
        return "without a crown there is nothing to compare; check it without --fem"
    if "N_max" not in analytic(q):
        return "the sprags roll over: no peak is left to compare; check it without --fem"
    return too_large_at_rest(q)


def tables(context: Context) -> tuple[Table, ...]:
    return (table_2(),) if context.is_paper else ()


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = False) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


CROWN = Case(
    id="sprag-crown",
    title="What the crown's parameters do",
    paper="huang2018",
    place="Eq. 1, Secs. 4.1 and 4.2, Figs. 11-14, Table 2",
    lead="Which load a crown suits, and what depth, length and drop make of the largest pressure "
    "of an engagement. What the paper's figures say of its crowns is judged under the forces of "
    "compiled engagements, and where it fits another force than theirs, that force is named.",
    inputs=EngagementInputs,
    analytic=analytic,
    method=BY_STRIPS, reference=fem,
    levels=LEVELS,
    quick=False,
    scans=(
        Scan(vary=("T=20N m,25N m,30N m",), star=True),
    ),
    checks=CHECKS,
    outputs=(
        output("A", "A", "µm", "depth of the logarithm in Eq. 1"),
        output("straight", "(1−K_2) l", "mm", "straight middle"),
        output("mean", "z̄", "µm", "mean drop over the length", judged=True),
        output("share", "e_z", "1", "% more mean drop by 1 % more z_m; K_1 the rest of 1 %",
               judged=True),
        output("end slice", "z_end", "µm", "drop at the middle of the end slices"),
        output("suits", "K_1 Q", "N", "load that a crown of this depth makes even (Lundberg)"),
        output("N", "N", "N", "normal force at rest with the yields, no springs"),
        output("p rest", "p", "MPa", "largest pressure at rest, inner race, by slices"),
        output("p even rest", "p_even", "MPa", "pressure at rest if the load were even"),
        output("N_max", "N_max", "N", "force of the first peak: two races on a spring"),
        output("K_1 suits", "N_max/Q", "1", "K_1 that suits the first peak"),
        output("p peak", "p_max", "MPa", "largest pressure at the first peak, by slices"),
        output("p mid peak", "p_mid", "MPa", "the same at mid-length", judged=True),
        output("p end peak", "p_end", "MPa", "pressure of the end slices at the first peak"),
        output("p even peak", "p_even", "MPa", "pressure at the first peak if the load were even"),
    ),
    readings=(
        "Eq. 1 is clipped and symmetric, its A is the factor before the logarithm (ledger: "
        "eq-1-a-undefined, eq-1-clipping)",
        "z_m is in millimetres: no unit is printed",
        "Q of Eq. 1 is one load for all torques, 3407 N: the static one at 25 N m of parts that do "
        "not yield; with their yields it is 3388 N. By another Q at each torque the best K_1 would "
        "not grow with it",
        "Fig. 12 is under a force of 2 to 4 kN, such as the static load, not under the first peak "
        "at 25 N m; which crowns it has is not printed: the eight that the paper prints "
        "anywhere are compared (ledger: fig-12-load)",
    ),
    assumptions=(
        "length, width, wedge angle, support and Q are identified, not printed: what rests on "
        "them is calibrated",
        "N_max of Eq. 19's crowns is a quadratic through 27 engagements: it changes by 2 % over "
        "all crowns, its residual moves p_max by less than 0.1 %",
        "at one's own clutch z_m of Eq. 19 is scaled by its own 2Q/(π l E')",
        "pressures by slices (Palmgren's law): ends that carry bear less there than on a "
        "half-space",
    ),
    findings=findings,
    summary=summary,
    warnings=warnings,
    too_large=too_large,
    equations=equations,
    tables=tables,
    sketch=sketch,
    figures=figures,
)  # fmt: skip
