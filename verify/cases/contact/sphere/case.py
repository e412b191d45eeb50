"""Point contact: a sphere on a rigid flat and on another sphere (Hertz), and what he neglects."""

from collections.abc import Callable, Sequence

from scipy.optimize import brentq

from analytic.contact import hertz_point
from analytic.contact.sphere_series import Sphere, pressed_spheres
from verify.cases.contact.sphere import figures as shown
from verify.cases.contact.sphere.fem import fem
from verify.cases.contact.sphere.inputs import PAIRS, WORDS, SphereInputs
from verify.core.case import Case, Output, Scan, Values
from verify.judging.checks import Approximation, Exact
from verify.judging.judge import DEMAND

BODIES = {"flat": ("upper",), "sphere": ("upper", "lower")}
ORDER = "first correction for finite spheres ± (a/R)² of the smaller one, 2e-4 at least"
SURFACE = (
    "± a/R: against the curved surface the pressure tilts by r/R, which bears on the axis with the "
    "tilt's share of p_0"
)
SHARP = "design limit for contact figures"


def analytic(q: SphereInputs) -> Values:
    values: dict[str, float] = {"load": q.P}
    for pair in PAIRS:
        hertz, (one, other) = q.hertz(pair), q.bodies(pair)
        a, delta = q.a(pair), float(hertz_point.approach(**hertz))
        p_0 = float(hertz_point.peak_pressure(**hertz))
        finite = pressed_spheres(one, other, P=q.P)

        values |= {
            f"{pair}: a": a, f"{pair}: p_0": p_0, f"{pair}: approach": delta,
            f"{pair}: load": float(hertz_point.load(**_stiffness(hertz), delta=delta)),
            f"{pair}: a, finite": finite.a, f"{pair}: p_0, finite": finite.p_0,
            f"{pair}: approach, finite": finite.approach,
            f"{pair}: a, excess": finite.a_excess, f"{pair}: p_0, excess": finite.p_0_excess,
            f"{pair}: approach, excess": finite.approach_excess,
            f"{pair}: load, excess": load_excess(one, other, P=q.P),
        }  # fmt: skip
        for body, sphere in zip(BODIES[pair], (one, other), strict=False):
            shear, depth = hertz_point.largest_shear_stress(a=a, p_0=p_0, nu=sphere.nu)
            values |= {f"{pair}: {body} shear": float(shear), f"{pair}: {body} depth": float(depth)}
    return values


def _stiffness(hertz: dict[str, float]) -> dict[str, float]:
    return {"R": hertz["R"], "E_star": hertz["E_star"]}


def load_excess(one: Sphere, other: Sphere, *, P: float) -> float:
    """Relative excess of the load that moves finite spheres by Hertz's approach under `P`."""
    first = pressed_spheres(one, other, P=P)
    delta = first.approach / (1 + first.approach_excess)

    def missing(share: float) -> float:
        return pressed_spheres(one, other, P=share * P).approach / delta - 1

    return float(brentq(missing, 0.5, 3.0, xtol=1e-14)) - 1


Interval = Callable[[SphereInputs, Values], tuple[float, float] | None]


def finite(pair: str, key: str) -> Interval:
    """What the first correction for finite spheres says of Hertz, and the next order about it.

    From the correction alone: a wrong Hertz leaves the interval instead of taking it along. Where
    the next order is more than half the default demand there is no sharp estimate.
    """

    def interval(q: SphereInputs, v: Values) -> tuple[float, float] | None:
        m = 1 / (1 + v[f"{pair}: {key}, excess"]) - 1
        unknown = q.beyond(pair) * (1.5 if key == "load" else 1.0)  # P goes with delta^(3/2)
        unknown = max(unknown, 2e-4)  # nothing sharper is claimed
        return (m - unknown, m + unknown) if unknown <= DEMAND / 2 else None

    return interval


def tilt(pair: str) -> Interval:
    def interval(q: SphereInputs, _values: Values) -> tuple[float, float] | None:
        wide = q.beyond(pair) ** 0.5
        wide = max(wide, 5e-3)  # nothing sharper is claimed
        return (-wide, wide) if wide <= 0.02 else None

    return interval


def warnings(q: SphereInputs, v: Values) -> Sequence[str]:
    found = []
    for pair in PAIRS:
        wide = q.beyond(pair) ** 0.5
        if wide > 0.05:
            error = v[f"{pair}: approach"] / v[f"{pair}: approach, finite"] - 1
            found.append(
                f"a/R = {wide:.2g} {WORDS[pair]}: Hertz's approach is off by about {error:.1%}, "
                f"his pressure by {v[f'{pair}: p_0'] / v[f'{pair}: p_0, finite'] - 1:.1%}"
            )
        shear = max(v[f"{pair}: {body} shear"] for body in BODIES[pair])
        if q.R_p is not None and shear > q.R_p / 2:
            found.append(
                f"shear stress {shear / 1e6:.4g} MPa {WORDS[pair]} exceeds R_p/2 = "
                f"{q.R_p / 2e6:.4g} MPa: it yields below the surface (Tresca)"
            )
        softest = q.E_1 if pair == "flat" else min(q.E_1, q.E_2)
        if q.R_p is None and v[f"{pair}: p_0"] > 0.02 * softest:
            found.append(
                f"p_0 = {v[f'{pair}: p_0'] / 1e6:.4g} MPa {WORDS[pair]} is "
                f"{v[f'{pair}: p_0'] / softest:.1%} of E: hardened steel yields before; give R_p"
            )
    return found


def too_large(q: SphereInputs) -> str:
    """The approach must stand out of the round-off of the larger sphere's coordinates."""
    ratio = max(q.R_1, q.R_2) / (q.a("sphere") ** 2 / q.hertz("sphere")["R"])
    if ratio <= 1e9:
        return ""
    return (
        f"an approach of R/{ratio:.1g} drowns in the round-off of the larger sphere's "
        "coordinates: check without --fem"
    )


CHECKS = tuple(
    check
    for pair in PAIRS
    for check in (
        *(
            Approximation(
                name=f"{what} {WORDS[pair]}", symbol=symbol, unit=unit, analytic=f"{pair}: {key}",
                fem=f"{pair}: {key}", formal=formal, interval=finite(pair, key), source=ORDER,
                demand=demand, demand_reason=SHARP,
            )
            for what, key, symbol, unit, demand, formal in (
                ("contact radius", "a", "a", "mm", 1e-3, 2),
                ("peak pressure", "p_0", "p_0", "MPa", 5e-4, 2),
                ("approach", "approach", "δ", "µm", 1e-3, 2),
                # at a given approach the pressure's edge, a square root, moves between nodes
                ("force at Hertz's approach", "load", "P(δ)", "N", 2e-3, 1.5),
            )
        ),
        *(
            Approximation(
                name=f"largest shear stress {WORDS[pair]}, {body} body", symbol="τ_max", unit="MPa",
                analytic=f"{pair}: {body} shear", fem=f"{pair}: {body} shear", formal=2,
                interval=tilt(pair), source=SURFACE, demand=0.04,
                demand_reason="an estimate of first order in a/R",
            )
            for body in BODIES[pair]
        ),
        *(
            Exact(
                name=f"balance of the {body} sphere {WORDS[pair]}", symbol="ΣF_y", unit="N",
                fem=f"{pair}: {body} balance", scale="load", bound=1e-7,
                bound_reason="direct solve: machine epsilon times the condition of K, with cells "
                "from a/50 to R",
            )
            for body in BODIES[pair]
        ),
    )
)  # fmt: skip

SPHERE = Case(
    id="contact-sphere",
    title="Sphere on a flat and on another sphere",
    paper="huang2018",
    place="Eqs. 2-5, the contact behind them (Hertz); Table 1, radii of sprag and race",
    lead="Hertz takes each sphere for a half space with a parabola on it. Against whole spheres, "
    "pressed from both sides, his radius and pressure err by a share of a/R that the logarithm of "
    "the sphere's own solution predicts, his approach by the finite distance to its middle.",
    inputs=SphereInputs,
    analytic=analytic,
    reference=fem,
    levels=(2, 4, 8),
    scans=(
        Scan(vary=("P=2N,16N,100N,500N,2000N", "R_2=4.02mm,11.11mm"), star=True),
    ),
    checks=CHECKS,
    outputs=tuple(
        Output(key=f"{pair}: {key}", symbol=symbol, unit=unit, what=f"{what}, {WORDS[pair]}",
               judged=judged)
        for pair in PAIRS
        for key, symbol, unit, what, judged in (
            ("a", "a", "mm", "contact radius", True),
            ("p_0", "p_0", "MPa", "peak pressure", True),
            ("approach", "δ", "µm", "approach of far points, Hertz", True),
            ("approach, finite", "δ", "µm", "approach of the equators, first correction", False),
            ("upper shear", "τ_max", "MPa", "largest shear stress below the surface", True),
            ("upper depth", "z", "mm", "its depth", False),
        )
    ),
    readings=(
        "R is each sphere's own radius; the relative one enters Hertz",
        "E/(1 − ν²) of each body: around a point no direction is free of strain",
        "the approach is that of the planes half-way to the opposite contact, not of points at "
        "infinity",
    ),
    assumptions=(
        "no friction, small strain",
        "load and second material are assumed; the radii are those of the paper's sprag and inner "
        "race, as if they were balls",
        "every sphere is pressed by the same load from the opposite side",
    ),
    too_large=too_large,
    warnings=warnings,
    equations=shown.equations,
    sketch=shown.sketch,
    figures=shown.figures,
    pictures=shown.pictures,
)  # fmt: skip
