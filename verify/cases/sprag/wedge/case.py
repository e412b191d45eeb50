"""A logarithmic sprag wedged between its races (Huang, Zhao, Liu, Eqs. 6, 7, 9, 10)."""

from verify.cases.sprag.inputs import WedgeInputs
from verify.cases.sprag.wedge import figures as shown
from verify.cases.sprag.wedge import messages as words
from verify.cases.sprag.wedge.claims import CHECKS
from verify.cases.sprag.wedge.fem import LEVELS, fem
from verify.cases.sprag.wedge.model import analytic
from verify.core.case import Case, Output, Scan


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = True) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


WEDGE = Case(
    id="sprag-wedge",
    title="Logarithmic sprag wedged between its races",
    paper="huang2018",
    place="Eqs. 6, 7, 9, 10",
    lead="A sprag turns between two races as its contacts, its body and the races yield: wedge "
    "angle, normal force, rotation and turn of the races through the stroke. One pitch of both "
    "races and a free sprag between them bears the closure of Eqs. 9 and 10 out, once all that "
    "yields on the inner side counts; as printed the sprag turns an eighth too little for the "
    "same yields, while Palmgren's law with Eqs. 6 and 7 yields a quarter too much.",
    inputs=WedgeInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    scans=(
        Scan(
            vary=("T=12.5N m,25N m,37.5N m", "R_ed=23mm,26.23mm,32mm"),
            only=(
                "T_i/N_i against the strut's tan ν (Eq. 10), at N_0",
                "normal force (Eq. 10), at T", "rotation of the sprags, at T",
                "rotation as the paper has it", "torque n_s N tan(ν) OA, at N_0",
                "all yields of elastic bodies, at N_0", "Eq. 6 alone for the outer race",
                "mean displacement of the outer race (Eq. 6 as printed",
                "peak pressure on the inner race (Hertz), at N_0",
                "peak pressure on the outer race (Hertz), at N_0", "excess of N_e over N_i",
            ),
            star=True,
        ),
    ),
    checks=CHECKS,
    outputs=(
        output("nu_0", "ν_0", "deg", "wedge angle at the inner contact without load",
               judged=False),
        output("nu", "ν(T)", "deg", "wedge angle under torque, at the inner contact (Eq. 10)"),
        output("omega", "ω(T)", "deg", "wedge angle under torque, at the outer contact (Eq. 10)"),
        output("m", "m", "1", "growth of the spiral", judged=False),
        output("r_e", "r_e", "mm", "radius of the outer flank", judged=False),
        output("N", "N(T)", "N", "normal force of a sprag on the inner race (Eq. 10)"),
        output("T_i", "T_i", "N", "tangential force of a sprag on the inner race", judged=False),
        output("H", "H(T)", "µm", "all that yields under a sprag, elastic bodies"),
        output("alpha", "α(T)", "deg", "rotation of the sprags, elastic bodies"),
        output("alpha plane", "α(T)", "deg", "with half planes and Eq. 6 for long races"),
        output("alpha composite", "α(T)", "deg", "with Palmgren's law, Eqs. 6 and 7"),
        output("alpha printed", "α(T)", "deg", "the same with Eqs. 9, 10 as printed"),
        output("theta", "θ(T)", "deg", "turn of the inner race against the outer, by rolling"),
        output("T_roll", "T_r", "N m", "torque at which a contact reaches a flank of the sprag",
               judged=False),
        output("p_i", "p_i", "MPa", "peak pressure on the inner race (Hertz)"),
        output("p_e", "p_o", "MPa", "peak pressure on the outer race (Hertz)"),
        output("a_i", "a_i", "µm", "half-width of the contact on the inner race (Hertz)"),
        output("a_e", "a_o", "µm", "half-width of the contact on the outer race (Hertz)"),
    ),
    readings=(
        "r_i of Table 1 is the spiral's radius of curvature at first contact",
        "a normal force acts where the compressed surfaces meet: OA and OB are lever arms, with "
        "half of each contact's yield (Eq. 9)",
        "the triangle of Eq. 10 belongs to the unstrained spiral: all that yields on the inner "
        "side counts",
        "T is the torque of the whole clutch, N the force of one sprag on the inner race",
        "sprags and races are long: plane strain, against the thin rings of Eq. 6",
    ),
    assumptions=(
        "the sprag is a column of the width b with rounded ends; l, b and ν_0 are identified, E "
        "and ν assumed, as the paper prints none of them",
        "finite elements: one pitch, both races free to breathe, bodies drawn as they are "
        "compressed; friction five times what the sprag needs",
        "quantities between five states by splines over ln N, below the first by a power",
        "elastic yields: races under single loads (Fourier series), the sprag under two opposed "
        "forces (complex potentials) where its contacts are",
        "expected errors: contacts beside the column's middle bend it, its ends roll on; "
        "tangential forces turn the races by 0.4 to 1.2 tan²ν more; Hertz errs by (a/r)²",
        "small strains: forces act at the ends as drawn; that bending moves these sideways is left "
        "out of the balance",
    ),
    findings=words.findings,
    summary=words.summary,
    warnings=words.warnings,
    too_large=words.too_large,
    equations=shown.equations,
    sketch=shown.sketch,
    figures=shown.figures,
    pictures=shown.pictures,
)  # fmt: skip
