"""Figures of a uniform rotating shaft: sketch, errors, Campbell diagram."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.rotor.shafts import cowper
from verify.cases.rotor.shaft.inputs import BEAMS, MODES, RATIOS, THEORIES
from verify.core.case import Context
from verify.core.figures import Campbell, Curves, Figure, Refinement, Sketch, Table
from verify.form import sketches
from verify.form.plots import dashes, dots, line, plot
from verify.form.sketches import arrow, leader, shape

RPM = np.pi / 30
HZ = 2 * np.pi
mm = 1e-3
NAMES = {"euler": "Euler", "rayleigh": "Rayleigh", "timoshenko": "Timoshenko, Hutchinson's κ"}


def sketch(q: Any) -> Sketch:
    h, b = q.d_o / q.L / 2, q.d_i / q.L / 2
    box = np.array([[0, -h], [1, -h], [1, h], [0, h]])
    return sketches.sketch(
        f"shaft at {q.n / RPM:.5g} r/min", shape("body", box),
        [shape("hole", box * [1, b / h])] if b else [],
        shape("modelled", np.array([[0, b], [1, b], [1, h], [0, h]])),
        arrow((-0.08, 0.0), (1.08, 0.0), style="axis"),
        [arrow((x - 0.03, -h), (x + 0.03, -h), style="clamp") for x in (0.0, 1.0)],
        arrow((0.0, -h - 0.12), (1.0, -h - 0.12), f"L = {q.L / mm:.5g} mm", "dimension"),
        leader((0.75, h + 0.12), (0.7, h), f"d_o = {q.d_o / mm:.5g} mm"),
        leader((0.3, h + 0.12), (0.35, b), f"d_i = {q.d_i / mm:.5g} mm"),
    )  # fmt: skip


def frequencies(context: Context) -> Table:
    """Table of the frequencies of all theories and of the elastic body."""
    q = context.inputs
    rows = [
        (f"mode {j} {sense}",
         *(beam.whirl(j, sense) / HZ for beam in (q.euler, q.rayleigh, q, q.exact)),
         context.fem[-1].values[f"solid_whirl_{j}_{sense}"] / HZ if context.fem else None)
        for j in MODES for sense in ("backward", "forward")
    ]  # fmt: skip
    return Table(
        title=f"Frequencies at {q.n / RPM:.5g} r/min [Hz]",
        header=("", "Euler", "Rayleigh", "Timoshenko", "elasticity", "elastic body, FE"),
        rows=tuple(rows),
    )


def figures(context: Context) -> Sequence[Figure]:
    return (
        over_slenderness(context),
        campbell(context),
        *((refinement(context, p) for p in (4, 2)) if context.converging else ()),
    )


def over_slenderness(context: Context) -> Curves:
    """Figure of the errors of the theories against elasticity, over d/L."""
    q = context.inputs
    ratio = np.geomspace(0.02, 0.5, 33)
    exact = np.array([q.cylinder().whirl(np.pi * x / q.d_o)[0][0] for x in ratio])

    def error(theory: Any, kappa: float | None = None) -> Any:
        found = [q.shaft(L=q.d_o / x, kappa=kappa).whirl(1, theory=theory)[0] for x in ratio]
        return abs(np.array(found) / exact - 1) * 100

    curves = [line(NAMES[t], ratio, error(t), k) for k, t in enumerate(THEORIES)]
    curves.append(dashes("Timoshenko, Cowper's κ", ratio,
                         error("timoshenko", cowper(nu=q.nu, m=q.m)), 3))  # fmt: skip
    if context.fem:
        formula = np.array([q.shaft(L=q.d_o / x).whirl(1, theory="euler")[0] for x in RATIOS])
        curves.append(dots("Euler against the elastic body, FE", np.array(RATIOS),
                           abs(formula / context.fem[-1].arrays["limit"] - 1) * 100))  # fmt: skip
    return plot(
        "Error of the frequency of mode 1 at rest over d_o/L", "d_o/L", "|error| [%]", curves,
        y_log=True,
        note="The error is the difference from three-dimensional elasticity, for d_i/d_o = "
             f"{q.m:.3g}. Only with Hutchinson's shear coefficient does the error of Timoshenko's "
             "beam decrease with the fourth power of d_o/L.",
    )  # fmt: skip


def campbell(context: Context) -> Campbell:
    q = context.inputs
    top = 1.3 * q.exact.critical
    speeds = np.linspace(0, max(top, 1.1 * q.n), 41)
    lines, whirl, names = [], [], []
    for j in (1, 2):
        pairs = [q.shaft().whirl(j, Omega=n, theory="timoshenko") for n in speeds]
        for sense, sign, letter in ((1, -1, "B"), (0, 1, "F")):
            lines.append([p[sense] / HZ for p in pairs])
            whirl.append(sign)
            names.append(f"{j}{letter}")
    critical = q.critical
    peers = None
    if context.fem:
        v = context.fem[-1].values
        found = [
            v[f"solid_whirl_{j}_{sense}"] / HZ for j in (1, 2) for sense in ("forward", "backward")
        ]
        peers = (np.full(4, q.n / RPM), np.array(found))
    return Campbell(
        title="Campbell diagram of the shaft", x_label="n [r/min]", y_label="f [Hz]",
        speeds=speeds / RPM, frequencies=np.array(lines).T, whirl=tuple(whirl),
        names=tuple(names), excitations=(("n", 1 / 60),),
        critical=((critical / RPM, critical / HZ, f"{critical / RPM:.5g} r/min"),),
        peers=peers, peers_name="elastic body, FE",
        note="By Timoshenko's theory, forward whirl frequencies increase with the speed, backward "
             "whirl frequencies decrease.",
    )  # fmt: skip


def refinement(context: Context, order: int) -> Refinement:
    """Figure of the errors of those elements whose order of convergence is `order`."""
    q, first = context.inputs, "whirl_1_forward"
    series = {
        4: (("Euler", f"beam_euler_{first}", q.euler.whirl(1, "forward")),
            ("weak form", f"weak_timoshenko_{first}", q.whirl(1, "forward")),
            ("body", f"solid_{first}", q.exact.whirl(1, "forward"))),
        2: (("mode 1", f"beam_timoshenko_{first}", q.whirl(1, "forward")),
            ("mode 3", "beam_timoshenko_whirl_3_forward", q.whirl(3, "forward"))),
    }[order]  # fmt: skip
    errors = tuple(
        (name, abs(np.array(context.series(key)[1]) / exact - 1)) for name, key, exact in series
    )
    notes = {
        4: "Curves: Euler's beam elements, the weak form of Timoshenko's beam, and the elastic "
        "body. The elastic body has 1.5 cells along the shaft for each beam element.",
        2: "The order of convergence is 2, because the shape functions of Timoshenko's beam "
        "elements neglect inertia and the shear caused by inertia.",
    }
    return Refinement(
        title="Error of the whirl frequency against the exact value of the same theory, "
        + ("mode 1 forward" if order == 4 else "Timoshenko's beam elements"),
        x_label="beam elements along the shaft", y_label="relative error",
        cells=BEAMS / np.array([r.h for r in context.fem]), errors=errors, order=order,
        note=f"{notes[order]} Straight lines have the slope {order}.",
    )  # fmt: skip
