"""Accordion spring, linear part: Eqs. 1-9 of Wang et al. 2023 and the curved frame behind them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from analytic.spring import energy, frame
from verify.cases.spring import figures as spring_shown
from verify.cases.spring import readings as spring_readings
from verify.cases.spring.inputs import AccordionInputs, SpringInputs, strip_of
from verify.core.case import Case, Context, FemResult, Output, Portion, Scan, Values
from verify.core.figures import Field, Table
from verify.judging.checks import Approximation, Identity, Order
from verify.judging.published_checks import Contradiction, PrintedMeasurement, PrintedTheory

if TYPE_CHECKING:
    from fem.beam.section import FrameSolution, Section
    from meshes.line import LineMesh

HEADS: tuple[frame.Head, ...] = ("free", "hinged", "guided")
TAILS: tuple[frame.Tail, ...] = ("arc", "mid-leaf")
HOLDS: tuple[frame.Hold, ...] = ("clamped", "hinged")
HEAD_SUPPORTS = {"free": "", "hinged": "y", "guided": "yr"}
TAIL_SUPPORTS = {"clamped": "xyr", "hinged": "xy"}
L0_OVER_B = 240  # Eq. 13
TEST_FORCE = 11.0  # N, the largest of Sec. 4
MOST_SLENDER = 16_000  # unfolded length over thickness
ROUND_OFF = 10 * float(np.finfo(float).eps)  # of sums over hundreds of elements
OWN = "paper's lengths"  # the shape that Eqs. 1-9 speak of
FREE_STAGE = 11.95 / 25.6  # where Eq. 10's branches meet, over L_0 of the true centre line


@dataclass(frozen=True)
class Shape:
    """Centre line and ends of a frame that is paired."""

    path: dict[str, Any]
    head: frame.Head
    tail: frame.Tail
    hold: frame.Hold = "clamped"

    @property
    def ends(self) -> dict[str, Any]:
        """The ends as the force method names them."""
        return {"head": self.head, "tail": self.tail, "hold": self.hold}


def shapes(q: AccordionInputs) -> dict[str, Shape]:
    """Every end condition on the true centre line, and the paper's own spring."""
    found = {OWN: Shape(q.paper_path, "free", "arc")}
    for head, tail, hold in product(HEADS, TAILS, HOLDS):
        if (head, hold) != ("free", "hinged"):  # that one swings freely
            how = "" if hold == "clamped" else " hinged"
            found[f"head {head}, tail{how} at {tail}"] = Shape(q.path, head, tail, hold)
    return found


NAMES = tuple(shapes(AccordionInputs()))


def analytic(q: AccordionInputs) -> Values:
    eqs: dict[str, Any] = {
        "n": q.n,
        "b": q.b,
        "h": q.h,
        "r": q.r,
        "L1": q.L1,
        "alpha": q.alpha,
        "E": q.E,
    }
    values = {"k1": float(energy.stiffness(**eqs))}
    for name, shape in shapes(q).items():
        for theory in ("thin", "shear"):
            values[f"{name}, {theory}"] = frame.stiffness(
                **shape.path, **strip_of(q), **shape.ends, theory=theory
            )
    wide: dict[str, Any] = {
        "n": q.n,
        "L1": q.L1,
        "radius": q.R,
        "alpha": q.alpha,
        "plane_strain": True,
    }
    values["k wide"] = frame.stiffness(**wide, **strip_of(q), head="free", tail="arc")
    values["k clean"] = frame.stiffness(**q.path, **strip_of(q))
    values["L0"] = frame.free_length(n=q.n, b=q.b, r=q.r, L1=q.L1, alpha=q.alpha)
    # the reading that is kindest to the rule: inner radius, without the leaves' own thickness
    shortest = frame.end_point(**q.paper_path, tail="mid-leaf")[0]
    values["shortest L0/b"] = shortest / q.b
    tested = TEST_FORCE if q.F is None else q.F
    values["stress at the tests' force"] = float(
        energy.bending_stress(F=tested, b=q.b, h=q.h, r=q.r, L1=q.L1)
        / energy.curvature_factor(b=q.b, r=q.r)  # kindly, as of a straight bar
    )
    if q.F is not None:
        values["deflection"] = q.F / values["k1"]
        values["stress"] = float(energy.bending_stress(F=q.F, b=q.b, h=q.h, r=q.r, L1=q.L1))
    return values


def fem(q: AccordionInputs, level: int) -> FemResult:
    from fem.beam.straight import solve_frame
    from meshes.spring.path import accordion

    values, u_it, fields = {}, {}, []
    for name, shape in shapes(q).items():
        line = line_fem(shape, level)
        points, chords = line.chords
        thin, _ = sections_fem(q)
        straight = solve_frame(points, chords, sections=thin, **held_and_pulled(shape, line))
        curved = curved_fem(q, shape, line)
        for kind, solved in (("straight", straight), ("curved", curved)):
            values[f"{name}, {kind}"], u_it[f"{name}, {kind}"] = stiffness(solved)
        if name == OWN:
            ends = [piece.end for piece in accordion(**shape.path, tail=shape.tail)]
            moments = moments_at(ends, straight)
            u_it["moments"] = float(abs(moments).max()) * straight.residual**0.5
        stress = -6 * curved.section_forces[..., 2].mean(axis=1) / (q.h * q.b**2)
        fields.append(
            Field(
                name=name, points=line.points, cells=line.elements[:, :2],
                point_data={"displacement": curved.u[:, :2]}, cell_data={"bending_stress": stress},
                units={"displacement": "m", "bending_stress": "Pa"},
            )
        )  # fmt: skip
    return FemResult(
        h=1 / level, values=values, u_it=u_it, arrays={"moments": moments}, fields=tuple(fields[:2])
    )


def stiffness_fem(q: AccordionInputs, level: int) -> FemResult:
    """The stiffness that Eqs. 1-9 are for: the paper's own spring, of curved elements."""
    shape = shapes(q)[OWN]
    k, u_it = stiffness(curved_fem(q, shape, line_fem(shape, level)))
    key = f"{OWN}, curved"
    return FemResult(h=1 / level, values={key: k}, u_it={key: u_it})


def line_fem(shape: Shape, level: int) -> "LineMesh":
    """The centre line of `shape` in quadratic elements, `level` along each arc."""
    from meshes.spring.centre_line import centre_line

    return centre_line(**shape.path, tail=shape.tail, per_arc=level, per_leaf=max(1, level // 2))


def curved_fem(q: AccordionInputs, shape: Shape, line: "LineMesh") -> "FrameSolution":
    """The frame of curved elements under 1 N."""
    from fem.beam.curved import solve_curved_frame

    _, stubby = sections_fem(q)
    return solve_curved_frame(
        line.points, line.elements, sections=stubby, **held_and_pulled(shape, line)
    )


def sections_fem(q: AccordionInputs) -> tuple["Section", "Section"]:
    """The strip's section without shear, and with it."""
    from fem.beam.section import Section

    A, I = q.b * q.h, q.h * q.b**3 / 12  # noqa: E741
    G = q.E / (2 * (1 + q.nu))
    return Section(EA=q.E * A, EI=q.E * I), Section(EA=q.E * A, EI=q.E * I, GA=G * A * 5 / 6)


def held_and_pulled(shape: Shape, line: "LineMesh") -> dict[str, Any]:
    """Supports and the force of 1 N by the nodes of `line`."""
    tail, head = line.nodes["tail"], line.nodes["head"]
    supports = {tail: TAIL_SUPPORTS[shape.hold], head: HEAD_SUPPORTS[shape.head]}
    return {"supports": supports, "loads": {head: (1.0, 0.0, 0.0)}}


def stiffness(solved: "FrameSolution") -> tuple[float, float]:
    """Stiffness [N/m] of a frame under 1 N, and its uncertainty by round-off."""
    k = -1 / (2 * solved.potential_energy)
    return k, abs(k) * max(solved.residual, ROUND_OFF)  # shares of energy


def moments_at(places: Sequence[tuple[float, float]], solved: Any) -> Any:
    """Bending moments (m,) under 1 N where elements end at `places`, counted as in Eqs. 1-5.

    There a moment is positive that turns the way of the force, clockwise.
    """
    ends, moments = solved.stations[:, 1], -solved.section_forces[:, 1, 2]
    return np.array([moments[np.hypot(*(ends - at).T).argmin()] for at in places])


def too_large(q: SpringInputs) -> str:
    """Elements of a frame this slender bend by less than what round-off makes of its movement."""
    leaf = q.L1 / math.sin(q.alpha) + 2 * q.R / math.tan(q.alpha)
    slender = q.n * (leaf + 2 * q.R * q.alpha) / q.b
    if slender <= MOST_SLENDER:
        return ""
    return (
        f"n = {q.n} segments unfold to {slender:,.0f} times the thickness, more than "
        f"{MOST_SLENDER:,}: finite elements lose too many digits there, check it without --fem"
    )


def neglected(q: AccordionInputs, _: Values) -> tuple[float, float]:
    """What axial force and shear add to the compliance, known to a tenth of itself."""
    bending, shear = (
        frame.stiffness(**q.paper_path, **strip_of(q), theory=theory)
        for theory in ("bending", "shear")
    )
    m = bending / shear - 1
    return 0.9 * m, 1.1 * m


def chord_errors(context: Context) -> tuple[list[float], list[float]]:
    """Errors of the straight-element frame against the closed form, per level."""
    name = "head free, tail at arc"
    exact = context.analytic[f"{name}, thin"]
    h, v = context.series(f"{name}, straight")
    return h, [abs(value / exact - 1) for value in v]


def warnings(q: AccordionInputs, v: Values) -> Sequence[str]:
    found = []
    if v["L0"] / q.b > L0_OVER_B:
        found.append(
            f"L_0/b = {v['L0'] / q.b:.4g} is above {L0_OVER_B} (Eq. 13): the paper expects the "
            "head to move sideways and the formula to lose accuracy"
        )
    if abs(v["k1"] / v["k clean"] - 1) > 0.01:
        found.append(
            f"Eqs. 1-9 take the inner radius for the centre line: {v['k1'] / v['k clean'] - 1:+.1%}"
            f" against the true centre line ({v['k clean'] / 1e3:.4g} N/mm)"
        )
    if q.h > 10 * q.b:
        found.append(
            f"a strip {q.h / q.b:.0f} times as wide as thick lies between E I and E I/(1 - ν²): "
            f"k_1 may be up to {1 / (1 - q.nu**2) - 1:.1%} above"
        )
    if q.b > 0.3 * q.R:
        found.append(
            f"b/(r + b/2) = {q.b / q.R:.2f}: no thin strip; run with --fem for the curved bar"
        )
    if q.F is not None:
        share = v["deflection"] / v["L0"]
        if share > FREE_STAGE:
            found.append(
                f"F = {q.F:g} N asks for {share:.1%} of the free length: the paper's spring left "
                f"its free stage at {FREE_STAGE:.0%}, where leaves touch and Eqs. 1-9 end"
                + (", and Eq. 12 allows 60 %" if share > 0.6 else "")
            )
        if q.R_p is not None and v["stress"] > q.R_p:
            found.append(
                f"bending stress {v['stress'] / 1e6:.4g} MPa at F = {q.F:g} N exceeds R_p = "
                f"{q.R_p / 1e6:.4g} MPa: the loops yield"
            )
    return found


def tables(context: Context) -> Sequence[Table]:
    return (sensitivity(context.inputs), *spring_readings.tables(context))


def sensitivity(q: AccordionInputs) -> Table:
    """What the paper leaves open: tail, head, radius and strip, all 16 combinations."""
    rows = tuple(
        (tail, head, radius, "E I/(1 − ν²)" if wide else "E I", round(k / 1e3, 4))
        for tail, head, radius, wide, k in spring_shown.combinations(q)
    )
    return Table(
        title="What the paper leaves open: k_1 [N/mm] for every combination",
        header=("tail held at", "head", "arc radius", "strip", "k_1 [N/mm]"),
        rows=rows,
        note="The first row is Eqs. 1-9. Nothing here is fitted; a row chosen because it meets a "
        "printed number would be calibrated.",
    )


FRAME_REASON = "a nodal frame is exact but for the chords of its arcs"
EQ9_SOURCE = "axial and shear energy of the force method, within a tenth of itself"

CHECKS = (
    PrintedTheory(name="stiffness by Eqs. 1-9", symbol="k_1", unit="N/mm", analytic="k1",
                  reference="wang2023:k1-theory"),
    PrintedMeasurement(name="Eqs. 1-9 against the paper's shell model", symbol="k_1", unit="N/mm",
                       analytic="k1", reference="wang2023:k1-fea"),
    PrintedMeasurement(name="Eqs. 1-9 against the paper's test", symbol="k_1", unit="N/mm",
                       analytic="k1", reference="wang2023:k1-test"),
    Approximation(name="Eqs. 1-9 against the curved beam", symbol="k_1", unit="N/mm",
                  analytic="k1", fem=f"{OWN}, curved", formal=4, interval=neglected,
                  source=EQ9_SOURCE, demand=5e-4,
                  demand_reason="frame elements are to settle 0.05 %",
                  printed=("wang2023:k1-theory", "wang2023:k1-fea", "wang2023:k1-test")),
    Contradiction(name="yield strength against the largest test force", symbol="σ", unit="MPa",
                  analytic="stress at the tests' force", reference="wang2023:yield-strength",
                  erratum="wang2023:yield-strength"),
    Contradiction(name="L_0/b of the paper's own spring against its limit", symbol="L_0/b",
                  unit="1", analytic="shortest L0/b",
                  reference="wang2023:rule-length-thickness-max",
                  erratum="wang2023:eq-13-own-spring"),
    *(
        Identity(name=f"stiffness, {name}: straight elements", symbol="k", unit="N/mm",
                 analytic=f"{name}, thin", fem=f"{name}, straight", formal=2, demand=5e-4,
                 demand_reason=FRAME_REASON)
        for name in NAMES
    ),
    *(
        Identity(name=f"stiffness, {name}: curved elements", symbol="k", unit="N/mm",
                 analytic=f"{name}, shear", fem=f"{name}, curved", formal=4, demand=5e-4,
                 demand_reason=FRAME_REASON)
        for name in NAMES
    ),
    Order(name="order of the straight elements", symbol="p", unit="1", errors=chord_errors,
          order=2),
)  # fmt: skip

OUTPUTS = (
    Output(key="k1", symbol="k_1", unit="N/mm", what="stiffness by Eqs. 1-9 (inner radius)"),
    Output(key="k clean", symbol="k", unit="N/mm", what="true centre line, E I"),
    Output(
        key="k wide",
        symbol="k",
        unit="N/mm",
        judged=False,
        what="true centre line, E I/(1 − ν²), which case spring-continuum judges",
    ),
    Output(key="L0", symbol="L_0", unit="mm", what="free length over all", judged=False),
    Output(key="deflection", symbol="Δ", unit="mm", what="deflection at F, by Eqs. 1-9"),
    Output(
        key="stress",
        symbol="σ",
        unit="MPa",
        judged=False,
        what="bending stress at F, inside the apex of a loop",
    ),
)

ACCORDION = Case(
    id="spring-accordion",
    title="Accordion spring, free stage, as a frame",
    paper="wang2023",
    place="Sec. 1.2, Eqs. 1-9; Table 1",
    lead="The energy formula for the stiffness before leaves touch, beside two frame models of "
    "its centre line: straight closed-form elements and curved quadratic ones.",
    inputs=AccordionInputs,
    analytic=analytic,
    reference=fem,
    levels=(4, 8, 16, 32),
    portions=(
        Portion(name="k_1", fem=stiffness_fem, levels=(4, 8, 16), keys=(f"{OWN}, curved",)),
    ),
    scans=(
        Scan(vary=("n=4:16:7", "b=0.05mm,0.1mm,0.2mm,0.3mm,0.4mm"), only=("Eqs. 1-9",)),
        Scan(
            vary=("r=0.2mm,0.45mm,0.8mm,1.2mm", "alpha=65deg:85deg:5", "L1=6mm,9mm,11.6mm,16mm"),
            only=("Eqs. 1-9",), star=True,
        ),
        Scan(
            vary=("n=4,10,16", "b=0.05mm,0.1mm,0.4mm", "alpha=65deg,80deg"),
            only=("straight elements", "curved elements"), star=True,
        ),
    ),
    checks=CHECKS,
    outputs=OUTPUTS,
    readings=(
        "r is the inner radius and stands for the centre line's in the arcs of Eqs. 1-9, although "
        "L_2 uses r + b/2, as printed: 3.2 % of the paper's k_1 against the true centre line",
        "2 L_1/sin α in Eq. 3 is 2 (L_1/2)/sin α, and h/2 there is b/2",
        "the signs of Eq. 3 alternate from unit to unit; T_0 of the text is T_1 = F (L_1/2 + r)",
        "the head is free to turn and to move sideways, the tail is clamped at the end of its arc",
    ),
    assumptions=(
        "small displacements, no contact between leaves",
        "bending only in Eqs. 1-9; axial force and shear enter the frames",
        "narrow strip: E I without 1 − ν²",
    ),
    warnings=warnings,
    too_large=too_large,
    equations=spring_shown.equations,
    tables=tables,
    sketch=spring_shown.sketch,
    figures=spring_shown.accordion_figures,
    pictures=spring_shown.frame_pictures,
)  # fmt: skip
