"""Crowns compared: Lundberg's and Johns and Gohar's even pressure, and the paper's designs."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from analytic.contact import hertz_line
from analytic.contact.crown import johns_gohar, lundberg
from verify.cases.contact.roller import figures as roller_figures
from verify.cases.contact.roller import profiles
from verify.cases.contact.roller.accepted import Estimated
from verify.cases.contact.roller.case import ASSUMPTIONS, HALF_SPACE, READINGS
from verify.cases.contact.roller.formulas import by_strips, strip_values
from verify.cases.contact.roller.half_space import Pressed, pressed, stair, too_short
from verify.cases.contact.roller.inputs import DESIGNS, CrownedInputs, StripInputs
from verify.core.case import Case, Context, FemResult, Output, Scan, Values
from verify.core.figures import Array, Curve, Curves, Equation, Field, Figure, Picture
from verify.core.references import BY_HALF_SPACE
from verify.core.tex import tex
from verify.judging.checks import Accepted, Fact
from verify.judging.tolerance_checks import SUBJECT, Agreement, Deviation, Pair, demanded, suites

MPa, mm, um = roller_figures.MPa, roller_figures.mm, roller_figures.um
EVEN = {"Lundberg": "Lundberg's crown", "Johns": "Johns and Gohar's crown"}
FAR = 5.0  # half-widths from the ends, up to which an even pressure is one
FLAT = 0.01  # within this
BESIDE = "strips, as the finer model, with their acceptance figure of 0.3 %"
FITTED = "length and load are not printed but identified, and other loads have other winners"
FIRST, NEXT = 1e-5, 0.05
RESOLVED = 2e-3  # of the half-length: 9 µm of the paper's
NEAR_END = 0.1e-3  # m, nearly the half-width, from the ends
MID, AT_ENDS = 3e-3, 0.02  # of strips beside the half-space


def even_crowns(q: StripInputs) -> dict[str, Callable[[Array], Array]]:
    """The two crowns for an even pressure under F, as functions of y."""
    lund: dict[str, Any] = {"load": q.F, "length": q.L, "E_star": q.E_star}
    return {
        "Lundberg": lambda y: lundberg(y, **lund),
        "Johns": lambda y: johns_gohar(y, half_width=q.b, **lund),
    }


def designed(q: StripInputs, design: tuple[float, float, float]) -> CrownedInputs:
    """The roller with one of the paper's crowns, Q = F."""
    K_1, K_2, z_m = design
    kept = {name: getattr(q, name) for name in StripInputs.model_fields}
    return CrownedInputs(**kept, K_1=K_1, K_2=K_2, z_m=z_m, Q=q.F)


REFERENCES = {"Lundberg": profiles.lundberg, "Johns": profiles.johns_gohar}


def unevenness(found: Pressed) -> float:
    """Share of the load that would have to move for the line load to be even: no peak, no mesh."""
    line = found.contact.line_load
    return float(np.abs(line / line.mean() - 1).mean() / 2)


def near_end(found: Pressed) -> float:
    """Largest pressure [Pa] farther than NEAR_END from the ends."""
    y = found.contact.y
    inner = np.abs(y) <= found.q.L / 2 - NEAR_END
    return float(found.ridge[inner].max())


def label(design: tuple[float, float, float]) -> str:
    return f"({design[0]:g}, {design[1]:g}, {design[2] / um:g} µm)"


def analytic(q: StripInputs) -> Values:
    hertz = {"P": q.F / q.L, "R": q.R, "E_star": q.E_star}
    found = {
        "Hertz p0": float(hertz_line.peak_pressure(**hertz)),
        "Hertz b": float(hertz_line.half_width(**hertz)),
        "F": q.F,
    }
    for name, gap in even_crowns(q).items():
        found |= strip_values(q, name, gap)
    for design in DESIGNS:
        _, along = by_strips(q, q.n, designed(q, design).gap)
        found[f"{label(design)} peak"] = along.peak
    return found


def fem(q: StripInputs, level: int) -> FemResult:
    values: dict[str, float] = {}
    arrays: dict[str, Array] = {}
    u_it: dict[str, float] = {}
    fields: tuple[Field, ...] = ()
    for name, gap in REFERENCES.items():
        found = pressed(q, level, crown=gap(q))
        values |= {f"{name} {key}": value for key, value in found.values.items()}
        far = np.abs(found.contact.y) <= q.L / 2 - FAR * q.b
        even = found.ridge[far] / np.sqrt(q.F / q.L * q.E_star / (np.pi * q.R))
        values[f"{name} uneven"] = float(np.abs(even - 1).max())
        arrays |= {f"{name} {key}": value for key, value in found.arrays.items()}
        fields = (*fields, replace(found.field, name=name))
        beside = stair(found, level, crown=gap(q))
        u_it |= {f"{name} {key}": u for key, u in beside.items() if key != "peak"}  # nor its place
    for design in DESIGNS:
        found = pressed(designed(q, design), level)
        values[f"{label(design)} peak"] = found.values["peak"]
        values[f"{label(design)} near"] = near_end(found)
        values[f"{label(design)} uneven"] = unevenness(found)
        arrays |= {f"{label(design)} {key}": value for key, value in found.arrays.items()}
    return FemResult(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=fields)


def near_strips(name: str) -> Callable[[Any, Values], tuple[float, float] | None]:
    """Interval of an even load's pressure: its deviation from strips, and their acceptance figure.

    The pressure is written out anew: the row's own would excuse itself.
    """

    def found(q: StripInputs, v: Values) -> tuple[float, float] | None:
        if q.own:
            return None
        m = float(np.sqrt(q.F / q.L * q.E_star / (np.pi * q.R))) / v[f"{name} mid"]
        return m * (1 - MID) - 1, m * (1 + MID) - 1

    return found


def by_name(key: str, name: str) -> Callable[[Context], Pair]:
    """The strips' error in `key` under the crown `name`, which both ends or the middle show."""

    def pair(context: Context) -> Pair:
        v, own = context.series(f"{name} {key}")[1], context.analytic[f"{name} {key}"]
        return Pair(own, v[-1], 3 * abs(v[-1] - v[-2]), f"strips {own / v[-1] - 1:+.2%}")

    return pair


def uneven(name: str) -> Callable[[Context], tuple[float, float, str]]:
    def margin(context: Context) -> tuple[float, float, str]:
        v = context.series(f"{name} uneven")[1]
        return FLAT - v[-1], 3 * abs(v[-1] - v[-2]), f"even to {v[-1]:.2%}"

    return margin


def evenest(context: Context) -> tuple[float, float, str]:
    """How much more load would have to move for the next design, over the best's share."""
    found = _designs(context, "uneven")
    next_ = float(found[-1, 1:].min())
    words = f"{found[-1, 0]:.1%} of the load would have to move, next {next_:.1%}"
    return next_ / float(found[-1, 0]) - 1, _spread(found), f"{words}; {_peaks(context, 0)}"


def least_even(context: Context) -> tuple[float, float, str]:
    """How much more load would have to move for the worst design than for the next."""
    found = _designs(context, "uneven")
    next_ = float(np.delete(found[-1], 1).max())
    words = f"{found[-1, 1]:.1%} of the load would have to move, next {next_:.1%}"
    return float(found[-1, 1]) / next_ - 1, _spread(found), f"{words}; {_peaks(context, 1)}"


def _peaks(context: Context, design: int) -> str:
    """The design's largest pressures, and its place among all: it hangs on where one looks."""
    told = []
    for key, where in (("peak", "beyond d"), ("near", "beyond 0.1 mm")):
        found = _designs(context, key)[-1]
        place = int(np.argsort(np.argsort(found))[design]) + 1
        told.append(f"{found[design] / MPa:.0f} MPa {where}, {place} of {len(found)} upwards")
    return "; ".join(told)


def _designs(context: Context, key: str) -> Array:
    names = [f"{label(design)} {key}" for design in DESIGNS]
    return np.array([[r.values[name] for name in names] for r in context.fem])


def _spread(found: Array) -> float:
    return float(3 * np.abs(found[-1] / found[-2] - 1).max())


def straight(context: Context) -> tuple[float, float, str]:
    """How far the drop's start is moved by z_m, and is off (1 - K_2) l/2."""
    q = context.inputs
    y = np.linspace(0, q.L / 2, 20001)

    def start(K_2: float, z_m: float) -> float:
        z = designed(q, (1.0, K_2, z_m)).gap(y)
        return float(y[np.argmax(z > 0)])

    by_z = abs(start(0.7, 25e-6) - start(0.7, 5e-6))
    off = abs(start(0.4, 10e-6) - 0.6 * q.L / 2) + abs(start(0.7, 10e-6) - 0.3 * q.L / 2)
    moved = (by_z + off) / (q.L / 2)
    return moved, 2 * float(y[1]) / (q.L / 2), f"moved and off by {moved:.1e} of l/2"


def first_contact(context: Context) -> tuple[float, float]:
    """How far inside the straight middle and NEXT of the half-length beside it contact ends.

    The crown of Fig. 13a on strips, under FIRST of F.
    """
    q = context.inputs
    light = designed(q, (1, 0.4, 10e-6)).model_copy(update={"F": FIRST * q.F})
    solved, along = by_strips(light, q.n)
    outmost = float(np.abs(along.y[solved.carries]).max())
    return float(1 - light.K_2 + NEXT - outmost / (q.L / 2)), 1 / q.n


CHECKS = (
    *(
        Estimated(name=f"pressure at mid-length, {words}", symbol="p", unit="MPa",
                  fem=f"{name} mid", analytic="Hertz p0", formal=1, by=HALF_SPACE,
                  interval=near_strips(name), source=BESIDE, demand=0.01)
        for name, words in EVEN.items()
    ),
    *(
        Agreement(name=f"{what} of {words}, strips within {bound:.1%}", symbol=symbol, unit=unit,
                  pair=by_name(key, name), accepted=bound,
                  source=source, by=HALF_SPACE, **demanded(bound))
        for name, words in EVEN.items()
        for key, what, symbol, unit, bound, source in (
            ("mid", "pressure at mid-length", "p", "MPa", MID, SUBJECT),
            ("approach", "approach", "δ", "µm", MID, SUBJECT),
            ("ends", "load within d of the ends", "F_d", "N", AT_ENDS,
             suites("a third of the 6 % that the subject accepts of a flat roller")),
        )
    ),
    *(
        Accepted(
            name=f"pressure of {words} within {FLAT:.0%} of even, up to {FAR:g} b from the ends",
            symbol="p", unit="1", margin=uneven(name),
        )
        for name, words in EVEN.items()
    ),
    Accepted(
        name="Fig. 12: (1, 0.7, 0.01) is the evenest of the designs printed", symbol="q",
        unit="1", margin=evenest, fitted=FITTED,
        printed=("huang2018:fig12-best-k1", "huang2018:fig12-best-k2", "huang2018:fig12-best-zm"),
    ),
    Accepted(name="Fig. 12: (5, 0.7, 0.015) is the least even of the designs printed", symbol="q",
             unit="1", margin=least_even, fitted=FITTED),
    Deviation(name="the straight middle follows K_2, not z_m", symbol="Δl_s/l", unit="1",
              size=straight, accepted=RESOLVED,
              source=suites("9 µm of the paper's length, a cell of the half-space"),
              whole="l/2", by="crown", fem_needed=False,
              everywhere=True),
    Fact(name="at first only the straight middle is loaded", symbol="l_c/l", unit="1",
         margin=first_contact, fem_needed=False),
)  # fmt: skip

OUTPUTS = (
    Output(key="Hertz p0", symbol="p_0", unit="MPa", what="Hertz's of a load spread evenly"),
    Output(key="Hertz b", symbol="b", unit="µm", what="its half-width", judged=False),
    *(
        Output(key=f"{name} mid", symbol="p", unit="MPa", what=f"at mid-length, {words}, strips")
        for name, words in EVEN.items()
    ),
    *(
        Output(key=f"{label(design)} peak", symbol="p_max", unit="MPa",
               what=f"beyond d of the ends, (K_1, K_2, z_m) = {label(design)}, strips",
               judged=False)
        for design in DESIGNS
    ),
)  # fmt: skip
PROFILES = {  # Fig. 11: one parameter at a time
    "K_1": ((1, 0.7, 10e-6), (3, 0.7, 10e-6), (5, 0.7, 10e-6)),
    "K_2": ((1, 0.4, 10e-6), (1, 0.55, 10e-6), (1, 0.7, 10e-6)),
    "z_m": ((1, 0.7, 5e-6), (1, 0.7, 10e-6), (1, 0.7, 15e-6)),
}
COMPARED = (0, 1, 6, 3)  # of the designs, in Fig. 12's plot


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    found = [grown(q, varied) for varied in PROFILES]
    if context.fem:
        found += [designs(context), *map(partial(by_all, context), (0, 1)), even(context),
                  ends(context)]  # fmt: skip
    return found


def grown(q: StripInputs, varied: str) -> Figure:
    """Fig. 11: the crown as one of its parameters grows."""
    start = 0.85 if varied == "z_m" else 0.0  # where it shows
    y = np.linspace(start, 1.0, 301) * q.L / 2
    return Curves(
        title=f"Profiles as {varied} grows (Fig. 11)", x_label="y [mm]", y_label="z [µm]",
        curves=tuple(
            Curve(name=label(design), x=y / mm, y=designed(q, design).gap(y) / um, colour=i)
            for i, design in enumerate(PROFILES[varied])
        ),
        note="(K_1, K_2, z_m), the half y > 0, Q = F; the paper's figure was not to be had.",
    )  # fmt: skip


def designs(context: Context) -> Figure:
    """Fig. 12: pressures of several designs, strips and half-space."""
    q = context.inputs
    curves = []
    for i, design in enumerate(DESIGNS[k] for k in COMPARED):
        _, along = by_strips(q, q.n, designed(q, design).gap)
        curves.append(Curve(name=label(design), x=along.y / mm, y=along.p / MPa, colour=i))
        curves.append(
            roller_figures.half_space(context, "" if i else "half-space", f"{label(design)} ", i)
        )
    p_0 = context.analytic["Hertz p0"] / MPa
    return Curves(
        title="Pressure of the paper's designs (Fig. 12)", x_label="y [mm]", y_label="p [MPa]",
        curves=tuple(curves), y_top=1.25 * p_0, y_bottom=0.5 * p_0,
        note="Lines: strips; dots: half-space. (1, 0.7, 10 µm) is the evenest "
        "but for its ends, which carry load: there a half-space has no highest pressure.",
    )  # fmt: skip


def by_all(context: Context, design: int) -> Figure:
    """p(y) of all methods for one of the designs."""
    named = label(DESIGNS[design])
    roller = designed(context.inputs, DESIGNS[design])
    return roller_figures.pressures(context, roller, f"{named} ", f", {named}")


def even(context: Context) -> Figure:
    """Lundberg's and Johns and Gohar's pressure."""
    curves = []
    for i, (name, words) in enumerate(EVEN.items()):
        curve = roller_figures.half_space(context, words, f"{name} ", 2 * i)
        curves.append(replace(curve, y=curve.y * MPa / context.analytic["Hertz p0"]))
    return Curves(
        title="Crowns for an even pressure", x_label="y [mm]", y_label="p/p_0",
        curves=tuple(curves), y_bottom=0.9, y_top=1.1,
        note="Half-space, over Hertz's pressure of the load spread evenly.",
    )  # fmt: skip


def ends(context: Context) -> Figure:
    """The same within some half-widths of the end."""
    q, b = context.inputs, context.analytic["Hertz b"]
    curves = []
    for i, (name, words) in enumerate(EVEN.items()):
        y, p = (context.fem[-1].arrays[f"{name} {key}"] for key in "yp")
        near = (q.L / 2 - y < 10 * b) & (y < q.L / 2)
        curves.append(
            Curve(name=words, x=(q.L / 2 - y[near])[::-1] / b,
                  y=p[near][::-1] / context.analytic["Hertz p0"], colour=2 * i)
        )  # fmt: skip
    return Curves(
        title="Their ends", x_label="distance from the end over b", y_label="p/p_0",
        curves=tuple(curves), note="Half-space. Both rise before they fall: an even load needs a "
        "little more crown there than either has; Lundberg's has no floor at the very end.",
    )  # fmt: skip


def warnings(q: StripInputs, v: Values) -> Sequence[str]:
    if v["Hertz b"] > 0.05 * q.R_1:
        return (
            f"b = {v['Hertz b'] / mm:.4g} mm is {v['Hertz b'] / q.R_1:.1%} of the roller's radius "
            f"of {q.R_1 / mm:.4g} mm: a half-space it hardly is",
        )
    return ()


def equations(q: StripInputs, v: Values) -> Sequence[Equation]:
    A = q.F / (np.pi * q.L * q.E_star)
    end = float(even_crowns(q)["Johns"](np.array(q.L / 2)))
    return (
        Equation(tex=r"z = \frac{F}{\pi l E^*} \ln\frac{1}{1 - (2y/l)^2}",
                 numbers=rf"\frac{{F}}{{\pi l E^*}} = {tex(A / um)}\ \mathrm{{\mu m}}",
                 place="Lundberg"),
        Equation(tex=r"z = \frac{F}{\pi l E^*} \ln\frac{1}{1 - (1 - 0.6065\,b/l)(2y/l)^2}",
                 numbers=rf"z(l/2) = {tex(end / um)}\ \mathrm{{\mu m}}", place="Johns and Gohar"),
        Equation(tex=r"p_0 = \sqrt{\frac{F E^*}{\pi l R}}",
                 numbers=rf"= {tex(v['Hertz p0'] / MPa)}\ \mathrm{{MPa}}", place="even load"),
    )  # fmt: skip


def pictures(q: Any) -> Sequence[Picture]:
    (picture,) = roller_figures.pictures(q)
    return tuple(
        replace(picture, field=name, caption=f"{words}: {picture.caption}")
        for name, words in EVEN.items()
    )


CROWNS = Case(
    id="contact-roller-crowns",
    title="Crowns of a roller compared",
    paper="huang2018",
    place="Eq. 1, Figs. 11 and 12",
    lead="Lundberg's crown and Johns and Gohar's make the pressure even but for some half-widths "
    "at the ends; the paper's law with three parameters has a straight middle. All are pressed on "
    "a half-space under the load that they are made for.",
    inputs=StripInputs,
    analytic=analytic,
    method=BY_HALF_SPACE,
    reference=fem,
    levels=(16, 24, 32),
    scans=(Scan(vary=("F=1500N,3407N,6000N", "L=6mm,9mm"), star=True),),
    checks=CHECKS,
    outputs=OUTPUTS,
    readings=READINGS[:2],
    assumptions=ASSUMPTIONS[:4],
    warnings=warnings,
    equations=equations,
    sketch=lambda q: roller_figures.sketch(designed(q, DESIGNS[0])),
    figures=figures,
    pictures=pictures,
    too_large=too_short,
)
