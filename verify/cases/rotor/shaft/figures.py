"""What the report shows of a uniform turning shaft: equations, errors, Campbell diagram."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.rotor.shafts import cowper
from verify.cases.rotor.shaft.fem import BEAMS, MODES, RATIOS, THEORIES
from verify.core.case import Context, Values
from verify.core.figures import (
    Campbell,
    Curve,
    Curves,
    Equation,
    Figure,
    Refinement,
    Shape,
    Sketch,
    Table,
)
from verify.core.tex import tex

RPM = np.pi / 30
HZ = 2 * np.pi
mm = 1e-3
NAMES = {"euler": "Euler", "rayleigh": "Rayleigh", "timoshenko": "Timoshenko, Hutchinson's κ"}


def sketch(q: Any) -> Sketch:
    h, b = q.d_o / q.L / 2, q.d_i / q.L / 2
    box = np.array([[0, -h], [1, -h], [1, h], [0, h]])
    shapes = [Shape(style="body", points=box)]
    if b:
        shapes.append(Shape(style="hole", points=box * [1, b / h]))
    shapes += [Shape(style="modelled", points=np.array([[0, b], [1, b], [1, h], [0, h]]))]
    shapes += [Shape(style="axis", points=np.array([[-0.08, 0.0], [1.08, 0.0]]))]
    shapes += [
        Shape(style="clamp", points=np.array([[x - 0.03, -h], [x + 0.03, -h]])) for x in (0.0, 1.0)
    ]
    shapes += [
        Shape(style="dimension", points=np.array([[0.0, -h - 0.12], [1.0, -h - 0.12]]),
              label=f"L = {q.L / mm:.5g} mm"),
        Shape(style="leader", points=np.array([[0.75, h + 0.12], [0.7, h]]),
              label=f"d_o = {q.d_o / mm:.5g} mm"),
        Shape(style="leader", points=np.array([[0.3, h + 0.12], [0.35, b]]),
              label=f"d_i = {q.d_i / mm:.5g} mm"),
    ]  # fmt: skip
    return Sketch(title=f"shaft at {q.n / RPM:.5g} r/min", shapes=tuple(shapes))


def equations(q: Any, v: Values) -> Sequence[Equation]:
    s = q.shaft()
    return (
        Equation(
            tex=r"\omega^2\,(\rho A + \rho I k^2) - 2\Omega\omega\,\rho I k^2 = EIk^4,"
            r"\quad k = \frac{\pi}{L}",
            numbers=rf"\omega = {tex(v['rayleigh 1 forward'])},\ "
            rf"-{tex(v['rayleigh 1 backward'])}\ \mathrm{{rad/s}}",
            place="Rayleigh, mode 1",
        ),
        Equation(
            tex=r"(\kappa GAk^2 - \rho A\omega^2)(\kappa GA + EIk^2 + 2\Omega\omega\rho I - "
            r"\rho I\omega^2) = (\kappa GAk)^2",
            numbers=rf"\omega = {tex(v['timoshenko 1 forward'])},\ "
            rf"-{tex(v['timoshenko 1 backward'])}\ \mathrm{{rad/s}}",
            place="Timoshenko, mode 1",
        ),
        Equation(
            tex=r"\kappa = \frac{6(1+\nu)^2(1+m^2)^2}{(7+12\nu+4\nu^2)(1+m^2)^2 + "
            r"4(5+6\nu+2\nu^2)m^2},\quad m = \frac{d_i}{d_o}",
            numbers=rf"= {tex(s.kappa, 5)}",
            place="Hutchinson 2001, Eqs. 43 and 45",
        ),
    )


def tables(context: Context) -> Sequence[Table]:
    v = context.analytic
    rows = [
        (f"mode {j} {way}",
         *(v[f"{t} {j} {way}"] / HZ for t in THEORIES), v[f"exact {j} {way}"] / HZ,
         context.fem[-1].values[f"solid {j} {way}"] / HZ if context.fem else None)
        for j in MODES for way in ("backward", "forward")
    ]  # fmt: skip
    return (
        Table(
            title=f"Frequencies at {context.inputs.n / RPM:.5g} r/min [Hz]",
            header=("", "Euler", "Rayleigh", "Timoshenko", "elasticity", "elastic body, FE"),
            rows=tuple(rows),
        ),
    )


def figures(context: Context) -> Sequence[Figure]:
    return (
        over_slenderness(context),
        campbell(context),
        *((refinement(context, p) for p in (4, 2)) if context.converging else ()),
    )


def over_slenderness(context: Context) -> Curves:
    """Errors of the theories against elasticity, over d/L."""
    q = context.inputs
    ratio = np.geomspace(0.02, 0.5, 33)
    exact = np.array([q.cylinder().whirl(np.pi * x / q.d_o)[0][0] for x in ratio])

    def error(theory: Any, kappa: float | None = None) -> Any:
        found = [q.shaft(L=q.d_o / x, kappa=kappa).whirl(1, theory=theory)[0] for x in ratio]
        return abs(np.array(found) / exact - 1) * 100

    curves = [Curve(name=NAMES[t], x=ratio, y=error(t), colour=k) for k, t in enumerate(THEORIES)]
    curves.append(
        Curve(name="Timoshenko, Cowper's κ", x=ratio, style="dashes", colour=3,
              y=error("timoshenko", cowper(nu=q.nu, m=q.m)))
    )  # fmt: skip
    if context.fem:
        formula = np.array([q.shaft(L=q.d_o / x).whirl(1, theory="euler")[0] for x in RATIOS])
        curves.append(
            Curve(name="Euler over the elastic body, FE", x=np.array(RATIOS), style="dots",
                  y=abs(formula / context.fem[-1].arrays["limit"] - 1) * 100)
        )  # fmt: skip
    return Curves(
        title="Error of mode 1 at rest over the shaft's slenderness", x_label="d_o/L",
        y_label="|error| [%]", curves=tuple(curves), y_log=True,
        note=f"Against three-dimensional elasticity, d_i/d_o = {q.m:.3g}. Only Hutchinson's "
        "coefficient makes the error fall with the fourth power.",
    )  # fmt: skip


def campbell(context: Context) -> Campbell:
    q = context.inputs
    top = 1.3 * context.analytic["exact critical"]
    speeds = np.linspace(0, max(top, 1.1 * q.n), 41)
    lines, whirl, names = [], [], []
    for j in (1, 2):
        pairs = [q.shaft().whirl(j, Omega=n, theory="timoshenko") for n in speeds]
        for way, sign, letter in ((1, -1, "B"), (0, 1, "F")):
            lines.append([p[way] / HZ for p in pairs])
            whirl.append(sign)
            names.append(f"{j}{letter}")
    critical = context.analytic["timoshenko critical"]
    peers = None
    if context.fem:
        v = context.fem[-1].values
        found = [v[f"solid {j} {way}"] / HZ for j in (1, 2) for way in ("forward", "backward")]
        peers = (np.full(4, q.n / RPM), np.array(found))
    return Campbell(
        title="Campbell diagram of the shaft", x_label="n [r/min]", y_label="f [Hz]",
        speeds=speeds / RPM, frequencies=np.array(lines).T, whirl=tuple(whirl),
        names=tuple(names), excitations=(("n", 1 / 60),),
        critical=((critical / RPM, critical / HZ, f"{critical / RPM:.5g} r/min"),),
        peers=peers, peers_name="elastic body, FE",
        note="Timoshenko's beam: forward whirl above, backward whirl below.",
    )  # fmt: skip


def refinement(context: Context, order: int) -> Refinement:
    """Errors of mode 1 forward against each model's own exact value, of one order."""
    v = context.analytic
    series = {
        4: (("Euler", "beam euler 1 forward", "euler 1 forward"),
            ("weak form", "weak timoshenko 1 forward", "timoshenko 1 forward"),
            ("body", "solid 1 forward", "exact 1 forward")),
        2: (("mode 1", "beam timoshenko 1 forward", "timoshenko 1 forward"),
            ("mode 3", "beam timoshenko 3 forward", "timoshenko 3 forward")),
    }[order]  # fmt: skip
    errors = tuple(
        (name, abs(np.array(context.series(key)[1]) / v[of] - 1)) for name, key, of in series
    )
    notes = {
        4: "Euler's elements, the weak form of Timoshenko's beam, and the elastic body, which has "
        "half as many cells again along the shaft.",
        2: "Timoshenko's closed-form elements leave inertia out of their shape functions, and "
        "with it the shear that it makes.",
    }
    return Refinement(
        title="Error against the same theory's exact value, "
        + ("mode 1 forward" if order == 4 else "Timoshenko's elements"),
        x_label="beam elements along the shaft", y_label="relative error",
        cells=BEAMS / np.array([r.h for r in context.fem]), errors=errors, order=order,
        note=f"{notes[order]} Lines: slope {order}.",
    )  # fmt: skip
