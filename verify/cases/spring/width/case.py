"""Accordion spring as a strip of finite width: the paper's shell model (Wang et al. 2023)."""

from collections.abc import Callable, Sequence

from analytic.spring import frame
from analytic.spring.wide_leaf import TERMS, width_factor
from verify.cases.spring.stages.readings import PaperReading
from verify.cases.spring.width import claims
from verify.cases.spring.width import figures as shown
from verify.cases.spring.width.fem import ENDS, LEVELS, RATIOS, WIDE, fem, widths_of_both
from verify.cases.spring.width.inputs import WidthInputs
from verify.core.case import Case, Context, Output, Scan, Values
from verify.judging.checks import Approximation, Identity, Limit
from verify.judging.published_checks import PrintedMeasurement
from verify.judging.tolerance_checks import BOTH_WAYS, Agreement, Pair, PaperAgreement, suites

MOST = 30  # segments that shells are solved for
FOIL = 3000  # thicknesses in a leaf's length, beyond which narrow shells are ill-conditioned
PLATE = 3.0  # widths over the thickness from which a leaf is a plate
SLENDER = 0.2  # of a leaf's length, that an arc is long


def analytic(q: WidthInputs) -> Values:
    f = float(width_factor(q.h, q.leaf, nu=q.nu))
    values = {"one": 1.0, "f": f, "f wide": q.widest, "h/l": q.h / q.leaf}
    for tail, head in {*ENDS, (q.tail, q.head)}:
        for name, plane_strain in (("k narrow", False), ("k wide", True)):
            values[f"{tail}, {head}, {name}"] = frame.stiffness(
                **q.path, **q.strip, tail=tail, head=head, theory="shear",
                plane_strain=plane_strain,
            )  # fmt: skip
        values[f"{tail}, {head}, k"] = f * values[f"{tail}, {head}, k narrow"]
    for name in ("k", "k narrow", "k wide"):
        values[name] = values[f"{q.tail}, {q.head}, {name}"]
    for ratio in RATIOS:
        leaf, coarse = (
            float(width_factor(ratio, 1.0, nu=q.nu, terms=terms)) for terms in (TERMS, TERMS // 2)
        )
        values |= {f"leaf {ratio:g}": leaf, f"left {ratio:g}": (coarse - leaf) / leaf}
    return values


def warnings(q: WidthInputs, _: Values) -> Sequence[str]:
    found = []
    if q.h < PLATE * q.b:
        found.append(
            f"a strip {q.h / q.b:.2g} times as wide as thick is no plate: its factor is nearer to 1"
        )
    elif q.h < q.leaf:
        found.append(
            f"a strip {q.h / q.leaf:.2g} times as wide as a leaf is long: its arcs, which cannot "
            f"curve across, stiffen it more than a leaf, by at most {q.widest - 1:.1%} in all "
            "(measure it with --fem)"
        )
    if q.R * q.alpha > SLENDER * q.leaf:
        found.append(
            f"arcs {q.R * q.alpha / q.leaf:.0%} as long as leaves: a leaf's factor says little of "
            "such a spring (measure it with --fem)"
        )
    return found


def too_large(q: WidthInputs) -> str:
    if q.leaf > FOIL * q.b:
        return (
            f"leaves {q.leaf / q.b:.0f} times as long as thick are more than {FOIL}: shells of "
            "such foils are ill-conditioned, and a leaf's plate is exact but for its arcs"
        )
    if q.n <= MOST:
        return ""
    return (
        f"n = {q.n} segments are more than the {MOST} that shells are solved for: the factor does "
        f"not depend on n, check it with n = {MOST}"
    )


def estimated(q: WidthInputs, _values: Values) -> tuple[float, float] | None:
    """The figure that the estimate is accepted with at the paper's width; none is at one's own."""
    return (-claims.ESTIMATE, claims.ESTIMATE) if q == WidthInputs() else None


def agrees(
    name: str, pair: Callable[[Context], Pair], accepted: float, why: str, by: str = ""
) -> Agreement:
    """Two factors that are the same but for `accepted`."""
    return Agreement(
        name=name, symbol="f", unit="1", pair=pair, accepted=accepted, source=suites(why), by=by
    )


HELD = "a shell with held edges is a beam"
PLATES = "a thin leaf is Kirchhoff's plate"
HALF = "half of the 1 % that rows are asked for"
THEORY = "what a shell's theory leaves of a thin solid, and no more"
FITTED = "these ends were chosen because they meet the printed stiffness"
CHECKS = (
    *(
        Identity(name=f"shell with held edges, tail held at {tail}, head {head}", symbol="k",
                 unit="N/mm", analytic=f"{tail}, {head}, k wide", fem=f"{tail}, {head}, held",
                 formal=4, demand=5e-4, demand_reason=HELD)
        for tail, head in ENDS
    ),
    Identity(name="shell with held edges and plane stress", symbol="k_EI", unit="N/mm",
             analytic="k narrow", fem="narrow", formal=4, demand=5e-4, demand_reason=HELD),
    *(
        Identity(name=f"factor of a leaf {ratio:g} times as wide as long", symbol="f", unit="1",
                 analytic=f"leaf {ratio:g}", fem=f"leaf {ratio:g}", residual=f"left {ratio:g}",
                 demand=5e-4, demand_reason=PLATES)
        for ratio in RATIOS
    ),
    Approximation(name="factor of the spring by one leaf's", symbol="f", unit="1", analytic="f",
                  fem="f", interval=estimated,
                  source=suites("half of what case spring-curve may be off by"),
                  demand=2 * claims.ESTIMATE, demand_reason=BOTH_WAYS),
    claims.PaperLimit(name="a narrow spring is in plane stress", symbol="f", unit="1",
                      points=claims.narrow, exponent=None, demand=1e-3,
                      demand_reason="a fifth of the acceptance figure"),
    Limit(name="a wide spring is in plane strain but for edges as wide as leaves are long",
          symbol="f", unit="1", points=claims.wide, exponent=1.0, demand=1e-3,
          demand_reason="a fifth of the acceptance figure"),
    agrees("the narrowest spring within 0.5 % of plane stress", claims.at_end(0), claims.LIMIT,
           HALF),
    agrees(f"a spring {WIDE[-1]:g} times as wide as its leaves within 0.5 % of plane strain",
           claims.at_end(-1), claims.LIMIT, HALF),
    *(
        agrees(f"loop as a shell and as solids, {what}", claims.solids(name), claims.SOLID,
               THEORY, by="solids")
        for name, what in zip(widths_of_both(WidthInputs()), (
            "20 times as wide as thick", "100 times as wide as thick", "at the spring's width"
        ), strict=True)
    ),
    agrees("one leaf's factor within 0.1 % of the spring's", claims.estimate, claims.ESTIMATE,
           "half of what case spring-curve may be off by"),
    agrees("one leaf's factor within 0.5 % of the spring's over all widths", claims.estimates,
           claims.SWEEP, HALF),
    agrees("the factor is the same however the ends are held", claims.ends, claims.HEAD,
           "half of what one leaf's factor may miss", by="the softest way"),
    agrees("the factor is the same for a head under a uniform force", claims.uniform,
           claims.UNIFORM, "a tenth of what the ends may do", by="a uniform force"),
    PaperAgreement(name="the factor that case spring-curve takes", symbol="f", unit="1",
                   pair=claims.taken, accepted=claims.TAKEN,
                   source=suites("a fifth of the 1 % that rows are asked for")),
    PaperReading(name="k_1 of the shell, head free, tail held at mid-leaf, beside the paper's",
                 symbol="k_1", unit="1", margin=claims.meets("mid-leaf", "free"), fitted=FITTED),
    *(
        PrintedMeasurement(name=f"k_1, head {head}, tail held at {tail}, against the {what}",
                           symbol="k_1", unit="N/mm", analytic=f"{tail}, {head}, k",
                           reference=f"wang2023:k1-{printed}")
        for tail, head in ENDS
        for printed, what in (("fea", "paper's shell model"), ("test", "paper's test"))
    ),
)  # fmt: skip

WIDTH = Case(
    id="spring-width",
    title="Accordion spring as a strip of finite width",
    paper="wang2023",
    place="Sec. 2, shell model; h in I = h b³/12",
    lead="How much stiffer than E I the width makes the spring: a shell of the whole spring, "
    "solids of a loop, and a leaf as a plate by Ritz's method, between a beam in plane stress and "
    "an endless strip in plane strain.",
    inputs=WidthInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    scans=(
        Scan(vary=("h=14mm,28mm,56mm", "n=6,10"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        Output(key="f", symbol="f", unit="1", what="factor of one leaf, the estimate"),
        Output(key="f wide", symbol="1/(1 − ν²)", unit="1", what="factor at most, 1 at least",
               judged=False),
        Output(key="h/l", symbol="h/l", unit="1", what="width over a leaf's length", judged=False),
        Output(key="k", symbol="k_1", unit="N/mm", what="stiffness with that factor"),
        Output(key="k narrow", symbol="k_EI", unit="N/mm", what="stiffness of a narrow strip"),
        Output(key="k wide", symbol="k_PE", unit="N/mm", what="stiffness of an endless strip"),
    ),
    readings=(
        "the force moves a line across the head that stays straight, as a roller's",
        "r is the inner radius: the centre line of the arcs has r + b/2",
        "where the tail is held and what the head may do is not printed: all four are shown",
    ),
    assumptions=(
        "small displacements, no contact",
        "the tail is clamped over the whole width, edges are free",
        "symmetric about the middle of the width",
    ),
    warnings=warnings,
    too_large=too_large,
    equations=shown.equations,
    tables=shown.tables,
    sketch=shown.sketch,
    figures=shown.figures,
    pictures=shown.pictures,
)  # fmt: skip
