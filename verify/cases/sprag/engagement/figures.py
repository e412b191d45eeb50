"""Figures of an engagement: forces over time, energies, pressures, convergence."""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from verify.cases.contact.roller.inputs import DESIGNS
from verify.cases.sprag.engagement.formulas import swing
from verify.cases.sprag.engagement.pressures import pressures
from verify.cases.sprag.engagement.reference import ORDER
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import Context
from verify.core.figures import Array, Bars, Equation, Figure, Refinement, Sketch
from verify.form import sketches
from verify.form.plots import dashes, dots, line, plot
from verify.form.sketches import arrow, shape, text

ms, kN, mm = 1e-3, 1e3, 1e-3
FEW = 45  # dots of a curve
ENERGIES = {
    "elastic": "contacts, races and sprags", "kinetic": "kinetic energy", "damping": "damping",
    "support": "support", "friction": "friction",
}  # fmt: skip


def motion() -> Iterator[Equation]:
    """Equations of motion, which the Runge-Kutta steps solve."""
    yield Equation(
        tex=r"I_{bi}\ddot\theta_i = T - n_s OA\,T_i - C_{rl}(\dot\theta_i - \dot\theta_e)",
        place="Eq. 16, lever arms corrected",
    )  # fmt: skip
    yield Equation(
        tex=r"I_{be}\ddot\theta_e = n_s OB\,T_e - k_{out}\theta_e "
        r"- C_{rl}(\dot\theta_e - \dot\theta_i)", place="Eq. 16, with the support",
    )  # fmt: skip
    yield Equation(
        tex=r"m_g OC_g\ddot\varphi = -N\sin(\beta+\gamma) + T_i\cos(\beta+\gamma) "
        r"+ N\sin\gamma - T_e\cos\gamma", place="Eq. 14",
    )  # fmt: skip
    yield Equation(
        tex=r"I_g(\ddot\alpha - \ddot\varphi) = b_i T_i + b_e T_e - (h_i - h_e) N "
        r"+ K_r(\alpha_{max} - \alpha)", place="Eq. 14, sign of the springs corrected",
    )  # fmt: skip


def sketch(_q: EngagementInputs) -> Sketch:
    """Sketch of two races, with the sprags as a spring and a damper, and of the support."""
    turn = np.linspace(0, 2 * math.pi, 61)

    def disc(x: float) -> Array:
        return np.column_stack([x + 0.22 * np.cos(turn), 1.0 * np.sin(turn)])

    def zigzag(x: float, to: float, y: float) -> Array:
        at = np.linspace(x, to, 11)
        up = np.array([0, 0, 0.14, -0.14, 0.14, -0.14, 0.14, -0.14, 0.14, 0, 0])
        return np.column_stack([at, y + up])

    def box(x: float, to: float, y: float) -> tuple[Array, Array]:
        m = (x + to) / 2
        cup = np.array([[m + 0.3, y + 0.16], [m - 0.2, y + 0.16], [m - 0.2, y - 0.16],
                        [m + 0.3, y - 0.16]])  # fmt: skip
        return cup, np.array([[m + 0.1, y - 0.13], [m + 0.1, y + 0.13]])

    cup, piston = box(0.22, 2.78, -0.45)
    shapes = (
        shape("body", disc(0)), shape("body", disc(3)), shape("line", zigzag(0.22, 2.78, 0.45)),
        arrow((0.22, -0.45), (1.3, -0.45), style="line"), shape("line", cup), shape("line", piston),
        arrow((1.6, -0.45), (2.78, -0.45), style="line"), shape("line", zigzag(3.22, 5.0, 0.0)),
        arrow((5.0, 0.8), (5.0, -0.8), style="clamp"), arrow((-1.6, 0.0), (-0.25, 0.0), "T"),
        text((0.0, 1.25), "I_bi, θ_i"), text((3.0, 1.25), "I_be, θ_e"),
        text((1.5, 0.85), "n_s sprags: N(α)"), text((1.5, -0.85), "C_rl"),
        text((4.1, 0.4), "k_out"),
    )  # fmt: skip
    return sketches.sketch(
        "model of the engagement: two races, the sprags between them as a spring and a damper, "
        "and the support of the outer race. The force of the sprags grows with the wind-up",
        shapes,
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    if not context.converging:
        return ()
    found: list[Figure] = [forces(context), apart(context), energies(context), turns(context)]
    found += pressures(context)
    if context.is_paper:
        found += [refined(context), crowns(context)]
    return found


def forces(context: Context) -> Figure:
    """Figure of N(t) by all models (Fig. 8)."""
    q, last = context.inputs, context.fem[-1].arrays
    every = max(len(last["LSODA t"]) // FEW, 1)
    races = swing(q)
    return plot(
        "Normal force of a sprag (Fig. 8)", "t [ms]", "N [kN]",
        line("Runge-Kutta steps, Eqs. 11-16", last["t"] / ms, last["N"] / kN),
        dots("LSODA, contacts that always roll", last["LSODA t"][::every] / ms,
             last["LSODA N"][::every] / kN),
        dashes("at rest, with springs", races.t / ms, context.analytic["N"] / kN, 2),
        dashes("without damping, outer race fixed", last["undamped t"] / ms,
               last["undamped N"] / kN, 3),
        dashes("rigid races (Liu)", last["rigid t"] / ms, last["rigid N"] / kN, 1),
        note="The LS/DYNA results of the paper are not available.",
    )  # fmt: skip


def apart(context: Context) -> Figure:
    """Figure of the differences of the force between the models over time."""
    q, last = context.inputs, context.fem[-1]
    top, races = last.values["N_max"], swing(q)
    t = last.arrays["t"]
    spring = np.interp(t, races.t, races.N) - last.arrays["N"]
    lsoda = last.arrays["LSODA beside"] - last.arrays["LSODA N"]
    floor = 1e-10

    def share(d: Array) -> Array:
        return np.asarray(np.log10(np.maximum(np.abs(d) / top, floor)))

    return plot(
        "Difference between the Runge-Kutta steps and other models", "t [ms]", "lg(|ΔN|/N_max)",
        line("from LSODA with events", last.arrays["LSODA t"] / ms, share(lsoda)),
        line("from two races on a spring", t / ms, share(spring), 1), y_bottom=-10.0, y_top=0.0,
        note="The model of two races on a spring uses N_e/N_i by statics and massless sprags.",
    )  # fmt: skip


def energies(context: Context) -> Figure:
    """Figure of the energies into which the input work is converted, stacked over time."""
    last = context.fem[-1].arrays
    t, below, curves = last["t"] / ms, np.zeros_like(last["t"]), []
    for colour, (key, words) in enumerate(ENERGIES.items()):
        below = below + last[key]
        curves.append(line(f"+ {words}" if colour else words, t, below, colour))
    put_in = last["torque"] + last["blades"]
    every = max(len(t) // FEW, 1)
    curves.append(dots("work of torque and springs", t[::every], put_in[::every], 5))
    return plot("Energies, stacked", "t [ms]", "E [J]", curves,
                note="The dots (work of torque and springs) lie on the uppermost line: the "
                "energies balance.")  # fmt: skip


def turns(context: Context) -> Figure:
    last = context.fem[-1].arrays
    t = last["t"] / ms
    return plot(
        "Rotations of races and sprags", "t [ms]", "angle [deg]",
        (
            line(words, t, np.degrees(last[key]), colour)
            for colour, (key, words) in enumerate((
                ("theta_i", "θ_i, inner race"), ("theta_e", "θ_e, outer race"),
                ("alpha", "α, sprags"),
            ))
        ),
    )  # fmt: skip


def refined(context: Context) -> Figure:
    return Refinement(
        title="Error of N(t) over the time step", x_label="steps per 10 µs",
        y_label="largest |ΔN|/N_max", cells=1 / np.array(ORDER),
        errors=(("N(t)", context.fem[-1].arrays["order"]),), order=4,
        note="The reference has steps of 1/16 of the given time step.",
    )  # fmt: skip


def crowns(context: Context) -> Figure:
    none, *found = context.fem[-1].arrays["crowns"]
    return Bars(
        title="Largest force with each crown", label="increase of N_max by the "
        "crown [%]",
        items=tuple(
            (f"({K_1:.3g}, {K_2:.3g}, {z_m / mm:.3g} mm)", 100 * (N / none - 1), f"{N:.0f} N")
            for (K_1, K_2, z_m), N in zip(DESIGNS, found, strict=True)
        ),
        note=f"Crowns are denoted by (K_1, K_2, z_m). N_max without a crown is {none:.0f} N.",
    )  # fmt: skip
