"""A roller's end face: finite elements of both bodies where a half-space has no face at all."""

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import model_validator
from scipy.interpolate import CubicSpline

from analytic.contact.edge import edge_exponent
from analytic.contact.half_space_roller import press_roller
from verify.case import Case, Context, FemResult, Output, Values
from verify.cases import contact_roller_shown as shown
from verify.cases.contact_roller_accepted import Accepted, Margin
from verify.cases.contact_roller_half_space import STRETCH
from verify.cases.contact_roller_inputs import Crown
from verify.checks import Approximation
from verify.inputs import quantity
from verify.shown import Array, Curve, Curves, Equation, Field, Figure, Picture, Shape, Sketch
from verify.tex import tex

if TYPE_CHECKING:
    from fem.fourier.compliance import SurfaceCompliance
    from fem.fourier.contact import PatchContact

MPa, mm = shown.MPa, shown.mm
CROWNS = ("flat", "crowned")
BODIES = {"end": "end face", "control": "both bodies go on"}
ACROSS = 4  # cells on Hertz's half-width, a level
WIDE = (1.5, 2.0, 3.0)  # of the half-width, the patch, until the contact fits
DEEP = 0.4  # of the half-width, the first cell at the end of the contact along the roller
HALF_SPACE = (64, 512)
FACE = 0.10  # of the load within d of the ends that the face takes at least
MOSTLY = 1 / 3  # of what the face takes, which the bodies' size stays below
EDGE = 1e-3  # distance from the ring's edge over its radius at which its slope is taken
EDGE_LEFT = 5e-3  # of the slope at the edge itself: terms of the order of these distances
EDGE_DRAWN = 5e-3


class EndInputs(Crown):
    """A roller between two equal races that go on beyond its ends."""

    overhang: float = quantity(
        "2 mm", "mm", "h", "length by which the races go on beyond each end", gt=0, le=1e3
    )

    @model_validator(mode="after")
    def _race(self) -> "EndInputs":
        if self.R_2 <= 0:
            raise ValueError(
                f"R_2 must be positive here, got R_2 = {self.R_2 / mm:g} mm: finite elements have "
                "a race that is a shaft"
            )
        if not 0.2 <= self.R_2 / self.R_1 <= 20:
            raise ValueError(
                f"radii may differ by a factor of 5 to 20, got R_1 = {self.R_1 / mm:g} mm, "
                f"R_2 = {self.R_2 / mm:g} mm"
            )
        if not 0.05 * self.L <= self.overhang <= 3 * self.L:
            raise ValueError(
                f"the overhang must be 0.05 to 3 lengths of the roller, got "
                f"h = {self.overhang / mm:g} mm, l = {self.L / mm:g} mm"
            )
        if not 0.2 <= self.L / self.R_1 <= 20:
            raise ValueError(
                f"the roller's length must be 0.2 to 20 radii, got l = {self.L / mm:g} mm, "
                f"R_1 = {self.R_1 / mm:g} mm"
            )
        return self


def profile(q: EndInputs, crown: str) -> Callable[[Array], Array]:
    """The gap along the roller, with its crown or none."""
    return q.gap if crown == "crowned" else np.zeros_like


def analytic(q: EndInputs) -> Values:
    found: dict[str, float] = {
        "F": q.F, "edge": edge_exponent(np.pi / 2), "less sharp": -edge_exponent(np.pi / 2),
        "one": 1.0, "R": q.R, "E*": q.E_star,
        "Hertz p0": math.sqrt(q.F / q.L * q.E_star / (np.pi * q.R)), "Hertz b": q.b,
    }  # fmt: skip
    for crown in CROWNS:
        contact = on_half_space(q, crown)
        line = contact.line_load
        found |= {
            f"{crown} mid": contact.mid_pressure,
            f"{crown} q mid": float((line[(len(line) - 1) // 2] + line[len(line) // 2]) / 2),
            f"{crown} ends": sum(contact.end_load(q.d)),
            f"{crown} share": sum(contact.end_load(q.d)) / q.F,
        }
    return found


def on_half_space(q: EndInputs, crown: str) -> Any:
    """The roller on a half-space, which knows no end face."""
    return press_roller(
        profile(q, crown), R=q.R, length=q.L, E_star=q.E_star, load=q.F, cells=HALF_SPACE
    )


def fem(q: EndInputs, level: int) -> FemResult:
    values: dict[str, float] = {}
    arrays: dict[str, Array] = {}
    race = compliance_fem(q, level, race=True, overhang=q.overhang)
    for name, overhang in (("end", 0.0), ("control", q.overhang)):
        roller = compliance_fem(q, level, race=False, overhang=overhang)
        for crown in CROWNS:
            found = contact_fem(q, level, (roller, race), crown)
            values |= read(q, found, f"{name} {crown}")
            arrays |= {
                f"{name} {crown} y": found.z, f"{name} {crown} q": found.line_load,
                f"{name} {crown} p": found.ridge,
            }  # fmt: skip
            if (name, crown) == ("end", "flat"):
                fields = (patch(found),)
    distance, pressure = edge_fem(level)
    values["edge slope"] = slope(distance, pressure)
    arrays |= {"edge distance": distance, "edge pressure": pressure}
    return FemResult(h=1 / level, values=values, arrays=arrays, fields=fields)


def stations_fem(q: EndInputs, level: int) -> Array:
    """Stations along the contact from mid-length to its end, where they are finest."""
    from meshes.revolution.section import stations

    return stations(start=q.L / 2, end=0.0, first=DEEP * q.b, growth=1.6, refine=level)


def compliance_fem(q: EndInputs, level: int, *, race: bool, overhang: float) -> "SurfaceCompliance":
    """How the race, or the roller, gives way; each pressed at opposite places."""
    from fem.fourier.compliance import harmonics, surface_compliance
    from fem.fourier.solid import FourierSolid
    from fem.plane.material import Elastic
    from meshes.revolution.cylinder import half_cylinder

    R, E, nu = (q.R_2, q.E_2, q.nu_2) if race else (q.R_1, q.E_1, q.nu_1)
    z, cell = stations_fem(q, level), q.b / (ACROSS * level)
    mesh = half_cylinder(R=R, contact=z, overhang=overhang, first=level * cell, refine=level)
    solid = FourierSolid(mesh, Elastic(E=E, nu=nu), {"start": "z"}, degree=2)
    orders = harmonics(places=2, highest=2 * np.pi * R / cell)
    return surface_compliance(solid, "rim", stations=z, orders=orders)


def contact_fem(q: EndInputs, level: int, bodies: Any, crown: str) -> "PatchContact":
    """The half y >= 0 of the roller on the race, under half the load."""
    from fem.fourier.contact import patch_contact

    for wide in WIDE:
        across = np.linspace(0.0, wide * q.b, round(wide * ACROSS * level) + 1)
        try:
            return patch_contact(bodies, across=across, load=q.F / 2, crown=profile(q, crown))
        except ValueError as error:
            if "as wide as its patch" not in str(error) or wide == WIDE[-1]:
                raise
    raise AssertionError


def read(q: EndInputs, found: "PatchContact", name: str) -> dict[str, float]:
    """Values of one contact under `name`."""
    q_mid = float(np.interp(0.0, found.z, found.line_load))
    ends = 2 * found.load_between(q.L / 2 - q.d, q.L / 2)
    return {
        f"{name} mid": found.ridge_at(0.0),
        f"{name} q mid": q_mid,
        f"{name} local": found.ridge_at(0.0) / math.sqrt(q_mid * q.E_star / (np.pi * q.R)),
        f"{name} ends": ends,
        f"{name} share": ends / q.F,
    }


def edge_fem(level: int) -> tuple[Array, Array]:
    """Pressure of a ring on a longer shaft of its material, near its edge, over the distance."""
    from skfem import MeshQuad1

    from fem.fourier.compliance import surface_compliance
    from fem.fourier.solid import FourierSolid
    from fem.plane.material import Elastic
    from meshes.revolution.cylinder import half_cylinder
    from meshes.revolution.section import stations

    fine: dict[str, Any] = {"first": 4e-5 / level, "growth": 1.5, "refine": 2}
    nodes = stations(start=1.0, end=0.0, **fine)
    z, orders = nodes[::2], np.array([0, 2, 4, 6, 8])
    shaft = half_cylinder(R=1.0, contact=nodes, overhang=0.5, first=fine["first"], refine=2)
    ring = MeshQuad1.init_tensor(stations(start=1.0, end=2.0, **fine), nodes)
    ring = ring.with_boundaries({"bore": lambda x: x[0] == 1, "start": lambda x: x[1] == 0})
    G = sum(
        surface_compliance(
            FourierSolid(mesh, Elastic(E=1.0, nu=0.3), {"start": "z"}, degree=2), name,
            stations=z, orders=orders,
        ).G[0, 0, :, 0]
        for mesh, name in ((shaft, "rim"), (ring, "bore"))
    )  # fmt: skip
    pressure = np.asarray(np.linalg.solve(G, np.diff(z)), dtype=np.float64)
    return 1 - (z[1:] + z[:-1]) / 2, pressure


def patch(found: "PatchContact") -> Field:
    """The patch of both halves with its pressure, stretched across."""
    s = np.concatenate([-found.across[:0:-1], found.across]) * STRETCH
    y = np.concatenate([-found.stations[:0:-1], found.stations])
    p = np.hstack([found.p[:, ::-1], found.p])
    p = np.vstack([p[::-1], p])
    points = np.column_stack([a.ravel() for a in np.meshgrid(y, s, indexing="ij")])
    i = np.arange(len(y) - 1)[:, None] * len(s) + np.arange(len(s) - 1)
    cells = np.stack([i, i + 1, i + len(s) + 1, i + len(s)], axis=-1).reshape(-1, 4)
    return Field(
        name="patch", points=points, cells=cells.astype(np.int64),
        cell_data={"pressure": p.T.ravel()}, units={"pressure": "Pa"},
    )  # fmt: skip


def local(q: EndInputs, _: Values) -> tuple[float, float]:
    """Hertz at the line load at mid-length: circles and the change of load along y are neglected.

    Each with a factor of one about the square of the half-width over the radius and half-length.
    """
    most = (q.b / q.R_1) ** 2 + (2 * q.b / q.L) ** 2 + 1e-3
    return -most, most


def face(crown: str) -> Margin:
    """What the end face takes off the load near it, beyond FACE."""

    def margin(context: Context) -> tuple[float, float, str]:
        here, on, U = _apart(context, "end", crown)
        beyond, _, _ = _apart(context, "control", crown)
        told = f"{here / on - 1:+.1%} of the half-space's, {here / beyond - 1:+.1%} of the control's"
        return 1 - here / on - FACE, U, told

    return margin


def mostly(crown: str) -> Margin:
    """How far what the bodies' size takes is below a share of what the end face does."""

    def margin(context: Context) -> tuple[float, float, str]:
        face_, on, U = _apart(context, "end", crown)
        size, _, U_size = _apart(context, "control", crown)
        left = MOSTLY * (1 - face_ / on) - abs(1 - size / on)
        return left, MOSTLY * U + U_size, f"{size / on - 1:+.1%} against {face_ / on - 1:+.1%}"

    return margin


def _apart(context: Context, name: str, crown: str) -> tuple[float, float, float]:
    v = context.series(f"{name} {crown} ends")[1]
    on = context.analytic[f"{crown} ends"]
    return v[-1], on, 3 * (max(v) - min(v)) / on


def slope(distance: Array, pressure: Array) -> float:
    """Slope of ln p over ln r at the edge: r in it, of first order, is extrapolated to nothing."""
    s = CubicSpline(np.log(distance[::-1]), np.log(pressure[::-1]))
    return float(2 * s(np.log(EDGE), 1) - s(np.log(2 * EDGE), 1))


CHECKS = (
    *(
        Approximation(
            name=f"pressure at mid-length over Hertz's at the line load there, {crown}, {words}",
            symbol="p/p_H", unit="1", fem=f"{name} {crown} local", analytic="one", formal=2,
            interval=local, demand=4e-3, demand_reason="cells across are even in pressure",
            source="argued: (b/R_1)² + (2b/l)², and 1e-3 of the cells")
        for name, words in list(BODIES.items())[:1] for crown in CROWNS
    ),
    *(
        Approximation(
            name=f"load within d of the ends, half-space, {crown}, {words}", symbol="F_d",
            unit="N", fem=f"{name} {crown} ends", analytic=f"{crown} ends", formal=1,
            interval=None, source="what a half-space costs is measured here")
        for name, words in BODIES.items() for crown in CROWNS
    ),
    *(
        Accepted(name=f"the end face takes {FACE:.0%} or more off the load near it, {crown}",
             symbol="F_d", unit="1", margin=face(crown))
        for crown in CROWNS
    ),
    *(
        Accepted(name=f"most of it is the face: the bodies' size costs less than a third, {crown}",
             symbol="F_d", unit="1", margin=mostly(crown))
        for crown in CROWNS
    ),
    Approximation(
        name="sharpness of a right-angled edge on its own material", symbol="λ − 1", unit="1",
        fem="edge slope", analytic="edge", formal=2,
        interval=lambda _q, _v: (-EDGE_LEFT, EDGE_LEFT),
        source="argued: terms of the order of the distance, 1 and 2 thousandths of the radius"),
)  # fmt: skip

OUTPUTS = (
    Output(key="Hertz p0", symbol="p_0", unit="MPa", what="Hertz's of a load spread evenly",
           judged=False),
    *(
        Output(key=f"{crown} {key}", symbol=symbol, unit=unit, what=f"{what}, {crown}, half-space",
               judged=key == "ends")
        for crown in CROWNS for key, symbol, unit, what in (
            ("mid", "p", "MPa", "pressure at mid-length"),
            ("ends", "F_d", "N", "load within d of both ends"),
        )
    ),
    Output(key="less sharp", symbol="1−λ", unit="1",
           what="exponent of the distance in the edge's pressure; 0.5 in a half-space"),
)  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    if not context.fem:
        return ()
    return (*(line_loads(context, crown) for crown in CROWNS), edge(context))


def line_loads(context: Context, crown: str) -> Figure:
    """Line load along half the roller: with an end face, without, and on a half-space."""
    q, arrays = context.inputs, context.fem[-1].arrays
    on = on_half_space(q, crown)
    half = on.y > 0
    curves = [Curve(name="half-space", x=on.y[half] / mm, y=on.line_load[half] / 1e3,
                    style="dashes", colour=4)]  # fmt: skip
    for i, (name, words) in enumerate(BODIES.items()):
        y, line = (arrays[f"{name} {crown} {key}"] for key in "yq")
        curves.append(Curve(name=f"FE, {words}", x=y / mm, y=line / 1e3, colour=i))
    return Curves(
        title=f"Line load towards the end, {crown}", x_label="y [mm]", y_label="q [N/mm]",
        curves=tuple(curves), y_top=1.7 * q.F / q.L / 1e3,
        note="Where both bodies go on, the half-space is nearly right; a free end face gives way, "
        "and the load goes to the middle.",
    )  # fmt: skip


def edge(context: Context) -> Figure:
    """Pressure of a ring near its edge on a longer shaft, with Williams' slope."""
    arrays = context.fem[-1].arrays
    d, p = arrays["edge distance"], arrays["edge pressure"]
    near = (d > EDGE / 20) & (d < 0.1)
    x, y = np.log10(d[near]), np.log10(p[near] / p[np.argmin(np.abs(d - EDGE_DRAWN))])
    at = np.array([x.min(), x.max()])
    k, middle = edge_exponent(np.pi / 2), float(np.log10(EDGE_DRAWN))
    return Curves(
        title="How sharp the edge of an end face is", x_label="log10 distance/radius",
        y_label="log10 p/p(0.005)",
        curves=(
            Curve(name="FE, ring on a longer shaft", x=x, y=y, style="dots"),
            Curve(name=f"slope {k:.3f}", x=at, y=k * (at - middle), colour=2),
            Curve(name="slope −0.5, half-space", x=at, y=-0.5 * (at - middle), style="dashes",
                  colour=4),
        ),
        note="Axisymmetric: near its edge a ring is a right angle on a flat, as the section of a "
        "roller along its axis is.",
    )  # fmt: skip


def sketch(q: EndInputs) -> Sketch:
    """Section along the axes: the roller between two races."""
    end, h = 1.6, min(q.overhang / q.L * 3.2, 1.6)
    r, race = 0.55, 1.0
    wide = end + h

    def box(x0: float, y0: float, x1: float, y1: float) -> Array:
        return np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])

    shapes = (
        Shape(style="text", points=shown.line((-4.2, 0.0))),
        Shape(style="text", points=shown.line((4.2, 0.0))),
        Shape(style="body", points=box(-wide, -r - race, wide, -r)),
        Shape(style="body", points=box(-wide, r, wide, r + race)),
        Shape(style="body", points=box(-end, -r, end, r)),
        Shape(style="modelled", points=box(0, -r - race, wide, -r)),
        Shape(style="modelled", points=box(0, -r, end, r)),
        Shape(style="axis", points=shown.line((-wide - 0.3, 0.0), (wide + 0.3, 0.0))),
        Shape(style="axis", points=shown.line((0.0, -r - race - 0.2), (0.0, r + race + 0.2))),
        Shape(
            style="load",
            points=shown.line((0.0, r + race + 0.7), (0.0, r + race + 0.1)),
            label=f"F = {q.F:.4g} N",
        ),
        Shape(style="load", points=shown.line((0.0, -r - race - 0.7), (0.0, -r - race - 0.1))),
        Shape(
            style="dimension",
            points=shown.line((end, -r - race - 0.6), (wide, -r - race - 0.6)),
            label=f"h = {q.overhang / mm:.4g} mm",
        ),
        Shape(
            style="leader",
            points=shown.line((-wide - 0.8, 0.35), (-end + 0.1, 0.25)),
            label=f"R_1 = {q.R_1 / mm:.4g} mm",
        ),
        Shape(
            style="leader",
            points=shown.line((-wide - 0.8, -1.2), (-wide + 0.1, -1.1)),
            label=f"R_2 = {q.R_2 / mm:.4g} mm",
        ),
        Shape(style="leader", points=shown.line((wide + 0.6, 0.3), (end, 0.2)), label="end face"),
    )
    return Sketch(title=f"roller, {q.L / mm:.4g} mm long, between two equal races, halves",
                  shapes=shapes)  # fmt: skip


def equations(_: EndInputs, v: Values) -> Sequence[Equation]:
    return (
        Equation(tex=r"p \propto r^{\lambda - 1},\quad \lambda(90^\circ)",
                 numbers=rf"= {tex(1 + v['edge'])}", place="Williams; Dundurs and Lee"),
        Equation(tex=r"F_d = 2\int_{l/2-d}^{l/2} q\,dy",
                 numbers=rf"= {tex(v['flat ends'])}\ \mathrm{{N}},\ "
                 rf"{tex(v['crowned ends'])}\ \mathrm{{N}}",
                 place="half-space: without and with the crown"),
    )  # fmt: skip


def pictures(_: EndInputs) -> Sequence[Picture]:
    return (
        Picture(field="patch", data="pressure", symbol="p", unit="MPa", factor=MPa,
                caption="Pressure on the patch of the roller without crown, with its end faces; "
                f"lengths across are drawn {STRETCH:.0f} times as long", displacement=""),
    )  # fmt: skip


def warnings(q: EndInputs, v: Values) -> Sequence[str]:
    found = []
    if v["crowned share"] > 1.2 * 2 * q.d / q.L or v["flat share"] > 1.2 * 2 * q.d / q.L:
        found.append(
            "a half-space puts more load on the ends than a roller's end face can carry: "
            "its pressures near a loaded end are too high"
        )
    return found


END = Case(
    id="contact-roller-end",
    title="End face of a roller",
    paper="huang2018",
    place="Eqs. 2-5, the half-space behind their weights",
    lead="Slices, strips and boundary elements take the roller for a half-space that goes on "
    "beyond its end. Finite elements of whole bodies, a Fourier series around the axes, say what "
    "that costs at a free end face; a control in which both bodies go on tells the face from the "
    "bodies' finite size.",
    inputs=EndInputs,
    analytic=analytic,
    fem=fem,
    levels=(2, 3, 4),
    checks=CHECKS,
    outputs=OUTPUTS,
    readings=(
        "the race goes on beyond the roller, as those of a clutch do",
        "the roller is pressed from two sides by equal races, and each race from two sides",
    ),
    assumptions=(
        "linear elasticity, no friction; solid cylinders with circular sections",
        "pressure acts along the common normal and is even in each cell of the patch",
        "harmonics around the axis are solved up to the width of a cell; those between are "
        "interpolated",
        "the edge's sharpness is that of a ring shrunk on a longer shaft, axisymmetric",
    ),
    warnings=warnings,
    equations=equations,
    sketch=sketch,
    figures=figures,
    pictures=pictures,
    quick=False,
)
