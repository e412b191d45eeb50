"""A drawn-cup roller clutch under torque: an outer cam, whose rollers go through at last."""

from collections.abc import Sequence

import numpy as np

from verify.cases.freewheel.cup import figures
from verify.cases.freewheel.cup.claims import CHECKS
from verify.cases.freewheel.cup.fem import LEVELS, fem
from verify.cases.freewheel.cup.inputs import CupInputs
from verify.cases.freewheel.cup.model import FRICTION, HARD, analytic, at_summit
from verify.core.case import Case, Output, Values

THIN = 0.2  # wall at the corners over X_o below which a cup is a thin one
NEAR = 0.9  # of the largest torque, beyond which little compliance decides
LITTLE = 0.02  # of it, below which states hardly reach
WIDEST = 0.2  # a/r up to which these meshes are made


def warnings(q: CupInputs, v: Values) -> Sequence[str]:
    found = []
    if np.tan(v["alpha_0"]) > FRICTION:
        found.append(
            f"tan α_0 = {np.tan(v['alpha_0']):.3g} is more than the friction {FRICTION:g} that "
            "oiled steel hardly exceeds: the rollers do not grip"
        )
    p = max(v["p_i"], v["p_o"])
    if p > HARD:
        found.append(
            f"pressure {p / 1e6:.4g} MPa exceeds the {HARD / 1e6:g} MPa of static contact of "
            "hardened rollers (ISO 76)"
        )
    wall = q.R_a - q.corner
    if wall < THIN * q.X_o:
        found.append(
            f"the cup's wall of {wall * 1e3:.3g} mm at its corners bends: rings that enclose it "
            "say little, give R_a of the housing that bears it"
        )
    return found


def too_large(q: CupInputs) -> str:
    v, top = analytic(q), at_summit(q)
    share = q.T / v["T summit"]
    if not LITTLE < share < NEAR:
        return (
            f"T is {share:.3g} of the largest torque {v['T summit']:.4g} N m, not between "
            f"{LITTLE:g} and {NEAR:g}; check it without --fem"
        )
    wide = max(float(top.a_i), float(top.a_o)) / q.r
    if wide > WIDEST:
        return (
            f"contacts are {wide:.3g} r wide at the largest torque, beyond {WIDEST:g}; check it "
            "without --fem"
        )
    return ""


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = True) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


CUP = Case(
    id="freewheel-cup",
    title="Drawn-cup roller clutch under torque",
    paper="nagler2021",
    place="Eqs. 2-7, for an outer cam",
    lead="Flats in the cup instead of on a star: load draws the rollers towards ψ = 0, the angle "
    "falls, and the torque has a largest value before the rollers go through between shaft and "
    "cup. One pitch of shaft, roller and cup with friction at both races follows the torque over "
    "its summit, and its energy says the torsion.",
    inputs=CupInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    checks=CHECKS,
    outputs=(
        output("alpha_0", "α_0", "deg", "clamping angle without load (Eq. 4 for a cup)"),
        output("alpha", "α(T)", "deg", "clamping angle under torque (Eq. 5 for a cup)"),
        output("F_t/N", "tan α", "1", "friction that holds the rollers under torque alone"),
        output("N", "F_n", "N", "normal force at either contact of a roller"),
        output("F_t", "F_t", "N", "tangential force at either contact (Eq. 3 for a cup)",
               judged=False),
        output("s", "s", "µm", "way of the rollers' centres about the axis (Eq. 6)"),
        output("phi", "φ", "deg", "torsion by exact rolling (Eq. 7, corrected)"),
        output("phi printed", "φ", "deg", "torsion, Eq. 7 as printed, with R_s and X_o"),
        output("d_i", "d_i", "µm", "approach of roller and shaft"),
        output("d_o", "d_o", "µm", "approach of roller and cup"),
        output("p_i", "p_i", "MPa", "peak pressure on the shaft (Hertz)"),
        output("p_o", "p_o", "MPa", "peak pressure on the cup (Hertz)"),
        output("a_i", "a_i", "µm", "half-width of the contact on the shaft (Hertz)"),
        output("a_o", "a_o", "µm", "half-width of the contact on the cup (Hertz)"),
        output("T summit", "T_max", "N m", "largest torque, at pop-through of the rollers"),
        output("N summit", "F_n", "N", "normal force there", judged=False),
        output("alpha summit", "α", "deg", "clamping angle there", judged=False),
        output("p summit", "p", "MPa", "larger peak pressure there (Hertz)", judged=False),
        output("through", "d_i + d_o", "µm", "approaches at which rollers go through, "
               "R_s + 2r − X_o", judged=False),
        output("share", "d/d_max", "1", "part of these at the largest torque", judged=False),
    ),
    readings=(
        "ψ is the angle between the cup's flat's normal and the roller's centre, α its half; load "
        "lowers it",
        "the race is the shaft: R_s is the lever of F_t, wherever a star's formulas have R",
        "T and N: the torque of the whole clutch, the forces of one roller",
        "rollers are long: plane strain",
    ),
    assumptions=(
        "the paper treats inner cams alone: this cup is synthetic, α_0 = 3.5° by choice; its "
        "formulas are the paper's with the wedge turned inside out",
        "real drawn cups are thin and sit in a housing that bears them: cup and housing are one "
        "body here, up to R_a, without the fit between them",
        "shaft and cup are free but for the torque, all of one steel, elastic at any pressure: "
        "the largest torque is one of geometry, pressures there are beyond what steel bears",
        "finite elements: one pitch, small displacements about the place where the roller lies; "
        "the roller neither creeps nor turns there; friction twice what it needs",
        "ways and energies between the states by splines over the normal force",
        "the cup's formula takes it for a ring with a bore of the flats' area; expected errors: "
        "the cup lies between rings with the bores X_o and X_o/cos(π/z), a column under the flat; "
        "Hertz errs by (a/r)²; tangential forces turn the shaft by 0.5 to 1 tan²α more",
    ),
    warnings=warnings,
    too_large=too_large,
    equations=figures.equations,
    sketch=figures.sketch,
    figures=figures.figures,
    pictures=figures.pictures,
)  # fmt: skip
