"""What the report and `check` show of the whole clutch."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from verify.cases.polyhedral.locking.sketch import sketch as locked_sketch
from verify.core.case import Context, Output, Values
from verify.core.figures import Dots, Equation, Figure, Picture, Sketch
from verify.core.tex import factor, tex

MPa, mm, kN = 1e6, 1e-3, 1e3


def _chain(key: str, symbol: str, unit: str, what: str) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=False)


OUTPUTS = (
    # what a designer asks for
    _chain("margin", "S", "1", "margin: torque of elastic ring and rollers over the torque wanted"),
    Output(key="M series", symbol="M_el", unit="N m", what="torque of elastic ring and rollers"),
    Output(key="p series", symbol="p_need", unit="MPa", what="pressure for the torque wanted"),
    _chain("p_0 ring", "p_ring", "MPa",
           "Hertz pressure of rollers on the ring, under p_t or p_need, whichever is more"),
    _chain("p_0 race", "p_race", "MPa", "and on the race"),
    Output(key="fillet", symbol="σ_max", unit="MPa", what="hoop stress in the fillets under p_t"),
    _chain("fillet needed", "σ_need", "MPa", "hoop stress in the fillets under p_need"),
    Output(key="N series", symbol="N_el", unit="kN", what="force of a roller under p_t"),
    _chain("N wanted", "N_need", "kN", "force of a roller for the torque wanted"),
    # between which limits
    Output(key="M rigid", symbol="M_rigid", unit="N m", what="torque with rigid rollers, a bound"),
    _chain("M wide", "M_wide", "N m", "torque of a wide ring (plane strain)"),
    _chain("needed", "α_need", "deg", "wedge angle that rollers without a cage require"),
    _chain("slope", "α_ring", "deg", "steepest slope of the ring's outside under p_t, untouched"),
    _chain("M slope", "M_ring", "N m", "torque of rollers that nothing but that slope holds"),
    # the paper's chain
    _chain("beta", "β", "deg", "angle between rollers"),
    _chain("d_m", "d_m", "mm", "mean diameter of the ring (Eq. 6)"),
    _chain("j_D", "j_D", "mm", "clearance on the diameter (Eq. 7)"),
    _chain("apothem", "a_f", "mm", "distance of the flats from the axis"),
    _chain("psi", "ψ", "deg", "hub's contact off the flat's normal"),
    _chain("lever", "r + r_1", "mm", "lever of the hub's contact"),
    _chain("sigma_t", "σ_t", "MPa", "hoop stress of the round ring (Eq. 9)"),
    _chain("p_1", "p_1", "MPa", "its pressure (Eq. 10)"),
    _chain("K", "K", "1", "correction for the polygon, middle of the flats"),
    _chain("p_1r", "p_1r", "MPa", "pressure that reaches the rollers (Eq. 11)"),
    _chain("sigma_tr", "σ_tr", "MPa", "mean hoop stress in the corners then (Eq. 12)"),
    _chain("p_2", "p_2", "MPa", "blocking pressure that is left (Eq. 19)"),
    _chain("F", "F", "kN", "its force on a side (Eq. 13)"),
    _chain("hub share", "s", "1", "hub's share of N (Eq. 16); from 1 on it locks"),
    Output(key="M Eq. 20", symbol="M_20", unit="N m", what="torque by Eq. 20"),
    Output(key="M Eq. 21", symbol="M_21", unit="N m", what="torque of the first design, Eq. 21"),
    _chain("T", "T", "kN", "tangential force of the hub per corner, with M_20"),
    _chain("F_s", "F_s", "kN", "radial force of the hub (Eq. 14)"),
    _chain("R", "R", "kN", "force between hub and flat"),
    _chain("N", "N_16", "kN", "force of a roller (Eq. 16)"),
    Output(key="p Eq. 20", symbol="p_20", unit="MPa", what="pressure for that wanted, Eq. 20"),
)  # fmt: skip


def sketch(q: Any) -> Sketch:
    return locked_sketch(q.ring, d=q.d, e=q.e, p_t=q.p_t)


def equations(q: Any, v: Values) -> Sequence[Equation]:
    ring = q.ring
    side = rf"{q.z}\cdot {tex(ring.d_i / mm)}\cdot\sin\frac{{\pi}}{{{q.z}}}\cdot {tex(q.b / mm)}"
    grip = r"\mu" if q.alpha is None else r"\tan\frac{\alpha}{2}"
    torque, elastic = (tex(v[key]) if key in v else r"\infty" for key in ("M Eq. 20", "M series"))
    return (
        Equation(
            tex=r"\tan\psi = \frac{e}{a}",
            numbers=rf"= \frac{{{tex(q.e / mm)}}}{{{tex(v['apothem'] / mm)}}},\ \psi = "
            rf"{tex(np.degrees(v['psi']))}°",
            place="after Eq. 15; a the distance of the flats",
        ),
        Equation(
            tex=r"p_2 = p_t - K\,\frac{2\delta_1 E j_D}{d_i d_m}",
            numbers=rf"= {tex(q.p_t / MPa)} - {tex(v['K'])}\cdot {factor(v['p_1'] / MPa)} "
            rf"= {tex(v['p_2'] / MPa)}\ \mathrm{{MPa}}",
            place="Eq. 19",
        ),
        Equation(
            tex=rf"M_t = \frac{{{grip}\, D_i}}{{2}}\,"
            rf"\frac{{z d_i \sin(\pi/z)\, b\, p_2}}{{1 - s}},\quad "
            rf"s = \frac{{{grip}\, D_i \cos(\gamma + \varphi_1)}}"
            r"{2 (r + r_1)\sin(\psi + \varphi_1)}",
            numbers=rf"= \frac{{{tex(v['grip'])}\cdot {tex(q.D_i / mm)}}}{{2}}\cdot"
            rf"\frac{{{side}\cdot {factor(v['p_2'] / MPa)}}}{{1 - {tex(v['hub share'])}}} "
            rf"= {torque}\ \mathrm{{N\,m}}",
            place="Eqs. 17 and 20, corrected; s is the hub's share of N",
        ),
        Equation(
            tex=r"u_p\,p_t + \kappa u_{h1} N - u_N(a)\,N - \delta(N) = \frac{j_D}{2}, \quad "
            rf"M_t = {grip}\, N z \frac{{D_i}}{{2}}",
            numbers=rf"= {elastic}\ \mathrm{{N\,m}}",
            place="elastic ring and rollers: series",
        ),
    )


def figures(context: Context) -> Sequence[Figure]:
    """Torques side by side."""
    v = context.analytic
    named = {
        "M Eq. 21": "Eq. 21, first design", "M Eq. 20": "Eq. 20",
        "M rigid": "elastic ring, rigid rollers, series",
        "M series": "elastic ring and rollers, series",
    }  # fmt: skip
    items: list[tuple[str, float, float | None, str]] = [
        (name, v[key], None, "formula") for key, name in named.items() if key in v
    ]
    if not items:
        return ()
    if context.fem:
        found = context.fem[-1].values
        named = {"M rigid": "elastic ring, rigid rollers, FE", "M series": "ring and rollers, FE"}
        items += [(name, found[key], None, "fe") for key, name in named.items() if key in found]
    return (
        Dots(title="Torque under the pressure p_t", label="M_t [N m]", items=tuple(items),
             note="Eqs. 20 and 21 assign all of the blocking pressure to the rollers; the ring "
             "keeps its part, and rollers deflect."),
    )  # fmt: skip


def pictures(_: Any) -> Sequence[Picture]:
    return (
        Picture(field="driven", data="von_mises", symbol="σ_v", unit="MPa", factor=MPa, share=0.02,
                caption="Ring at its torque: pressure, hub (its symmetric part) and rollers; von "
                "Mises stress, coarse mesh"),
    )  # fmt: skip
