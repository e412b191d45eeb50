"""Accordion spring beyond its free stage: the tips that touch (Wang et al. 2023, Eq. 10)."""

import math
from collections.abc import Sequence
from typing import Any

from analytic.spring import energy, frame
from analytic.spring.stages import stages
from analytic.spring.wide_leaf import width_factor
from verify.cases.spring.inputs import too_slender
from verify.cases.spring.stages import figures
from verify.cases.spring.stages.fem import ENDS, Ends, fem
from verify.cases.spring.stages.inputs import StagesInputs
from verify.cases.spring.stages.readings import (
    ACCEPTED,
    FITTED,
    MET,
    PaperReading,
    chosen,
    keeps,
    tables,
)
from verify.core.case import Case, Context, Output, Scan, Values
from verify.judging.checks import Exact, Identity, Order
from verify.judging.published_checks import PrintedMeasurement

QUANTITIES = (
    ("k1", "k_1", "N/mm", "stiffness k_1"),
    ("F_A", "F_A", "N", "force at A"),
    ("U_A", "U_A", "mm", "displacement at A"),
    ("k2", "k_2", "N/mm", "stiffness k_2"),
)
SECOND = (("U_B", "U_B", "mm", "displacement where the second tip touches"),
          ("k3", "k_3", "N/mm", "stiffness k_3 with both tips in touch"))  # fmt: skip
LATER = (Ends("hinged", "mid-leaf"), Ends("guided", "arc"), Ends("free", "arc"))
LINEAR = 0.1  # U_A over L_0 up to which lengths may be taken as unchanged
PARALLEL = math.radians(5)
ROUND_OFF = 1e-9
OTHER_WIDTH = 0.005  # between the factor given and that of a leaf


def analytic(q: StagesInputs) -> Values:
    values: dict[str, float] = {"one newton": 1.0}
    spring: dict[str, Any] = {**q.path, "b": q.b, "h": q.h, "E": q.E, "nu": q.nu}
    for ends in ENDS:
        s = stages(**spring, head=ends.head, tail=ends.tail, normal=ends.normal, theory="thin",
                   width_factor=q.factor)  # fmt: skip
        for key in ("k1", "F_A", "U_A", "k2", "U_B", "F_B", "k3"):
            values[f"{ends}, {key}"] = float(getattr(s, key))
    held = Ends(q.head, q.tail)
    for key in ("k1", "F_A", "U_A", "k2", "U_B", "F_B", "k3"):
        values[key] = values[f"{held}, {key}"]
    own = figures.own(q)
    values |= {"gap": float(own.gap), "tilt": float(own.tilt)}
    values["intercept"] = values["F_A"] - values["k2"] * values["U_A"]
    values["L0"] = frame.free_length(n=q.n, b=q.b, r=q.r, L1=q.L1, alpha=q.alpha)
    values["U_A/L0"] = values["U_A"] / values["L0"]
    bend = 6 * float(energy.curvature_factor(b=q.b, r=q.r)) / (q.h * q.b**2)
    values["stress at A"] = bend * float(own.top_couple)
    if q.width_factor is None:
        values |= {f"{key} wide": q.widest * values[key] for key in ("k1", "F_A", "k2")}
    if q.F is not None:
        values["U_w"] = float(figures.own(q, theory="thin").displacement(q.F))
        values["margin"] = values["U_A"] - values["U_w"]
    most = q.widest if q.width_factor is None else q.width_factor
    guided = figures.own(q, head="guided", tail="mid-leaf", width_factor=most)
    values |= {"guided k1": float(guided.k1), "guided k2": float(guided.k2)}
    reading = chosen(q)
    values |= {"reading k1": reading.k1, "reading k2": reading.k2,
               "reading intercept": float(reading.stages.intercept)}  # fmt: skip
    return values


def warnings(q: StagesInputs, v: Values) -> Sequence[str]:
    found = []
    if v["U_A/L0"] > LINEAR:
        found.append(
            f"U_A is {v['U_A/L0']:.0%} of the free length: linear theory takes lengths and levers "
            "as unchanged, so that point A and k_2 are references, not the spring's true curve"
        )
    if abs(v["tilt"]) > PARALLEL:
        found.append(
            f"at A the leaf is {abs(math.degrees(v['tilt'])):.1f}° from parallel to the tip: the "
            "force between them leans as far from the spring's axis, which is neglected"
        )
    leaf = (q.L1 + 2 * q.R * math.cos(q.alpha)) / math.sin(q.alpha)
    wide = float(width_factor(q.h, leaf, nu=q.nu))
    if q.width_factor is not None and abs(wide / q.width_factor - 1) > OTHER_WIDTH:
        found.append(
            f"width_factor = {q.width_factor:.5g}, but leaves of this width and length are "
            f"stiffened by {wide:.5g}: forces change by {wide / q.width_factor - 1:+.1%}"
        )
    if q.width_factor is None and q.h > 10 * q.b:
        found.append(
            f"a strip {q.h / q.b:.0f} times as wide as thick lies between E I and E I/(1 - ν²): "
            f"forces and stiffnesses may be up to {q.widest - 1:.1%} above (give width_factor)"
        )
    if q.F is not None and v["F_A"] < q.F:
        which = "both tips touch" if v["F_B"] < q.F else "a tip touches"
        k = v["k3"] if v["F_B"] < q.F else v["k2"]
        found.append(
            f"F = {q.F:g} N is beyond A ({v['F_A']:.4g} N): {which}, and the stiffness is "
            f"{k / 1e3:.4g} N/mm there"
        )
    if q.R_p is not None and v["stress at A"] > q.R_p:
        found.append(
            f"bending stress {v['stress at A'] / 1e6:.4g} MPa at A exceeds R_p = "
            f"{q.R_p / 1e6:.4g} MPa: the loops yield before the tips touch"
        )
    return found


def chord_errors(context: Context) -> tuple[list[float], list[float]]:
    """Errors of the frame's k_2 against the closed form, per level."""
    key = f"{ENDS[0]}, k2"
    h, v = context.series(key)
    return h, [abs(value / context.analytic[key] - 1) for value in v]


CHORDS = "a nodal frame is exact but for the chords of its arcs"
CHECKS = (
    *(
        Identity(name=f"{words}, {ends}", symbol=symbol, unit=unit, analytic=f"{ends}, {key}",
                 fem=f"{ends}, {key}", formal=2, demand=5e-4, demand_reason=CHORDS)
        for ends in ENDS for key, symbol, unit, words in QUANTITIES
    ),
    *(
        Identity(name=f"{words}, {ends}", symbol=symbol, unit=unit, analytic=f"{ends}, {key}",
                 fem=f"{ends}, {key}", formal=2, demand=5e-4, demand_reason=CHORDS)
        for ends in LATER for key, symbol, unit, words in SECOND
    ),
    *(
        Exact(name=f"force of a link that is closed at A, {ends}", symbol="C", unit="N",
              fem=f"{ends}, push", scale=f"{ends}, F_A", bound=ROUND_OFF,
              bound_reason="the two lines meet at A but for round-off")
        for ends in ENDS
    ),
    Order(name="order of the straight elements in k_2", symbol="p", unit="1", errors=chord_errors,
          order=2),
    *(
        PaperReading(name=f"{words} of the reading chosen by k_1 beside Eq. 10", symbol=symbol,
                 unit=unit, margin=keeps(key, figure), fem_needed=False, fitted=FITTED,
                 printed=printed)
        for key, figure, symbol, unit, words, printed in (
            ("k1", MET, "k_1", "N/mm", "k_1", ("wang2023:k1-fea",)),
            ("k2", ACCEPTED, "k_2", "N/mm", "k_2", ("wang2023:k2-fea",)),
            ("U", ACCEPTED, "U_A", "mm", "displacement at A", ()),
            ("F", ACCEPTED, "F_A", "N", "force at A", ()),
        )
    ),
    *(
        PrintedMeasurement(name=f"{words} of that reading against the {what}", symbol=symbol,
                           unit=unit, analytic=f"reading {key}", reference=f"wang2023:{printed}")
        for key, symbol, unit, words, what, printed in (
            ("k1", "k_1", "N/mm", "k_1", "paper's test", "k1-test"),
            ("k2", "k_2", "N/mm", "k_2", "paper's test", "k2-test"),
            ("intercept", "c_2", "N", "constant of the second line", "paper's line",
             "eq10-ab-intercept"),
        )
    ),
    *(
        PrintedMeasurement(name=f"{key[0]}_{key[1]} of a guided wide strip against the {what}",
                           symbol=f"{key[0]}_{key[1]}", unit="N/mm", analytic=f"guided {key}",
                           reference=f"wang2023:{key}-{printed}")
        for key in ("k1", "k2") for what, printed in (("paper's shell model", "fea"),
                                             ("paper's test", "test"))
    ),
)  # fmt: skip

OUTPUTS = (
    Output(key="k1", symbol="k_1", unit="N/mm", what="stiffness before the tips touch"),
    Output(key="F_A", symbol="F_A", unit="N", what="force where the first tip touches"),
    Output(key="U_A", symbol="U_A", unit="mm", what="displacement there"),
    Output(key="k2", symbol="k_2", unit="N/mm", what="stiffness beyond"),
    Output(key="intercept", symbol="c_2", unit="N", what="the second line's force at U = 0",
           judged=False),
    Output(key="U_B", symbol="U_B", unit="mm", what="displacement where the second tip touches",
           judged=False),
    Output(key="gap", symbol="g_0", unit="mm", what="gap of the tips", judged=False),
    Output(key="U_A/L0", symbol="U_A/L_0", unit="1", what="share of the free length",
           judged=False),
    Output(key="stress at A", symbol="σ_A", unit="MPa", judged=False,
           what="bending stress at A, inside the apex of a loop"),
    Output(key="k1 wide", symbol="k_1", unit="N/mm", what="the same with E I/(1 − ν²)",
           judged=False),
    Output(key="F_A wide", symbol="F_A", unit="N", what="the same with E I/(1 − ν²)",
           judged=False),
    Output(key="k2 wide", symbol="k_2", unit="N/mm", what="the same with E I/(1 − ν²)",
           judged=False),
    Output(key="U_w", symbol="U_w", unit="mm", what="displacement at F", judged=False),
    Output(key="margin", symbol="U_A − U_w", unit="mm", judged=False,
           what="what is left until a tip touches"),
)  # fmt: skip

STAGES = Case(
    id="spring-stages",
    title="Accordion spring beyond its free stage",
    paper="wang2023",
    place="Sec. 2, Eq. 10; Table 1",
    lead="Where the free tips of head and tail touch their neighbours (point A), and how much "
    "stiffer the spring is from there on: closed forms beside a frame with rigid links. Linear "
    "theory on both sides.",
    inputs=StagesInputs,
    analytic=analytic,
    reference=fem,
    levels=(4, 8, 16, 32),
    scans=(
        Scan(vary=("n=6,10,14", "b=0.05mm,0.1mm,0.2mm", "alpha=70deg,80deg"), star=True),
    ),
    checks=CHECKS,
    outputs=OUTPUTS,
    readings=(
        "head and tail are whole leaves: the force acts in the middle of the head's, the tail's is "
        "held in its middle (mid-leaf) or along its whole length (arc)",
        "r is measured inside: the arcs' centre line has r + b/2",
        "a tip's corner touches the face of the leaf: b/2 of the tip and b/(2 sin α) of the leaf "
        "are taken from the gap",
        "the force between tip and leaf acts along the axis: at A the leaf has turned until it is "
        "parallel to the tip; the normal of the unloaded leaf instead changes U_A by 1 % and k_2 "
        "by 1 % (rows \"normal of the leaf\")",
        "of what the paper leaves open one reading is chosen by k_1 alone; what it says of k_2 and "
        "of A is calibrated",
    ),
    assumptions=(
        "small displacements, although U_A is half of the paper's free length",
        "no friction between tip and leaf; no other parts touch",
        "bending and axial force; the strip is narrow (E I) unless a width factor is given",
    ),
    warnings=warnings,
    too_large=too_slender,
    equations=figures.equations,
    tables=tables,
    sketch=figures.sketch,
    figures=figures.figures,
    pictures=figures.pictures,
)  # fmt: skip
