"""A roller freewheel with a flat star under torque (Nagler, Lohrengel, Eqs. 2 to 7)."""

from collections.abc import Sequence

from verify.cases.freewheel.inputs import StarInputs
from verify.cases.freewheel.torque import figures
from verify.cases.freewheel.torque.claims import CHECKS
from verify.cases.freewheel.torque.fem import LEVELS, fem
from verify.cases.freewheel.torque.model import analytic
from verify.core.case import Case, Output, Scan, Values

WIDE = 0.12  # a/r up to which these finite elements, small in displacements, are asked
HARD = 4000e6  # Pa, what hardened rollers bear in static contact (ISO 76)
BENT = 0.1  # of the ring's wall: by how much more it bends, its forces move along it
BEYOND, EDGE = 1.1, 4.0  # of those approaches; half-widths up to the flat's corner
FRICTION = 0.1  # what oiled steel hardly exceeds


def warnings(_q: StarInputs, v: Values) -> Sequence[str]:
    found = []
    if v["F_t/N"] > FRICTION:
        found.append(
            f"tan α(T) = {v['F_t/N']:.3g} is more than the friction {FRICTION:g} that oiled steel "
            "hardly exceeds: the clutch slips"
        )
    p = max(v["p_i"], v["p_o"])
    if p > HARD:
        found.append(
            f"pressure {p / 1e6:.4g} MPa exceeds the {HARD / 1e6:g} MPa of static contact of "
            "hardened rollers (ISO 76)"
        )
    return found


def too_large(q: StarInputs) -> str:
    v = analytic(q)
    wide = max(v["a_i at N"], v["a_o at N"]) / q.r
    if wide > WIDE:
        return (
            f"contacts are {wide:.3g} r wide under T/(z R tan α_0), beyond {WIDE:g}: displacements "
            "are not small; check it without --fem"
        )
    wall = q.R_a - q.R
    if v["d_o at N"] > BENT * wall:
        return (
            f"the ring deflects by {v['d_o at N'] * 1e6:.4g} µm under T/(z R tan α_0), more than "
            f"{BENT:g} of its wall of {wall * 1e3:.4g} mm: displacements are not small; check it "
            "without --fem"
        )
    d = BEYOND * v["d_i at N"], BEYOND * v["d_o at N"]
    x = float(q.cam.centre(d_i=d[0], d_o=d[1])[0])
    left = float(q.cam.corner) - x
    if left < EDGE * v["a_i at N"]:
        return (
            f"under T/(z R tan α_0) the rollers come within {left * 1e3:.3g} mm of the flats' "
            "corners; check it without --fem"
        )
    return ""


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = True) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


TORQUE = Case(
    id="freewheel-torque",
    title="Roller freewheel under torque",
    paper="nagler2021",
    place="Eqs. 2-7",
    lead="Rollers wedged between the flats of a star and a ring move on as the contacts deflect: "
    "clamping angle, normal force, way and torsion over torque, with the paper's Eqs. 3 to 7 "
    "corrected. One pitch of star, roller and ring with friction at both races says the same, and "
    "its energy says the torsion without any thought of rolling.",
    inputs=StarInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    scans=(
        Scan(vary=("T=6.5N m,13N m,26N m,39N m", "R_a=19mm,21mm,30mm"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        output("alpha_0", "α_0", "deg", "clamping angle without load (Eq. 4, corrected)"),
        output("alpha", "α(T)", "deg", "clamping angle under torque (Eq. 5, corrected)"),
        output("F_t/N", "tan α", "1", "friction that holds the rollers under torque alone",
               judged=False),
        output("N", "F_n", "N", "normal force at either contact of a roller"),
        output("F_t", "F_t", "N", "tangential force at either contact (Eq. 3, corrected)",
               judged=False),
        output("s", "s", "µm", "way of the rollers' centres about the axis (Eq. 6)"),
        output("phi", "φ", "deg", "wind-up angle by exact rolling (Eq. 7, corrected)"),
        output("phi printed", "φ", "deg", "torsion, Eq. 7 as printed"),
        output("phi small", "φ", "deg", "torsion for small angles, 2 s/R", judged=False),
        output("d_i", "d_i", "µm", "approach of roller and star"),
        output("d_o", "d_o", "µm", "approach of roller and ring"),
        output("p_i", "p_i", "MPa", "peak pressure on the star (Hertz)"),
        output("p_o", "p_o", "MPa", "peak pressure on the ring (Hertz)"),
        output("a_i", "a_i", "µm", "half-width of the contact on the star (Hertz)"),
        output("a_o", "a_o", "µm", "half-width of the contact on the ring (Hertz)"),
    ),
    readings=(
        "α is half the angle ψ between the flat's normal and the roller's centre: half the wedge",
        "R is the bore radius of the outer ring wherever the paper writes r_OR",
        "d = f + u: only the whole approach of a contact can be compared, flattening and "
        "structure together",
        "T and N: the torque of the whole clutch, the forces of one roller",
        "rollers are long: plane strain",
    ),
    assumptions=(
        "the paper prints no dimensions of its clutches A and B, and 5 µm of X turn α_0 by 0.08°: "
        "this clutch is synthetic, with α_0 = 3.5° by choice",
        "the star is clamped on its shaft, the ring free but for the torque, all of one steel",
        "finite elements: one pitch, small displacements about the place where the roller lies; "
        "the roller neither creeps nor turns there; friction twice what it needs",
        "ways and energies between six states by splines, below the first by a power",
        "expected errors: the star lies among a layer and two discs, and the torque winds it up; "
        "Hertz errs by (a/r)²; tangential forces turn the ring by 0.5 to 1 tan²α more",
    ),
    warnings=warnings,
    too_large=too_large,
    equations=figures.equations,
    sketch=figures.sketch,
    figures=figures.figures,
    pictures=figures.pictures,
)  # fmt: skip
