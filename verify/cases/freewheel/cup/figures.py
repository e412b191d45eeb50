"""Figures of a drawn-cup roller clutch under torque."""

import math
from collections.abc import Iterator
from functools import partial

import numpy as np

from analytic.freewheel.state import RollerClutchState, at_normal_force
from verify.case import converged
from verify.cases.freewheel import over_torque
from verify.cases.freewheel.cup.inputs import Cup
from verify.cases.freewheel.over_torque import DEGREE
from verify.core.case import Context
from verify.core.figures import Array, Curves, Sketch
from verify.form import sketches
from verify.form.case import Drawing
from verify.form.plots import dashes, dots, line, plot
from verify.form.sketches import arrow, leader, shape, text

FORCES = np.linspace(1e-4, 1.0, 160)  # over the largest normal force of the states

TILTS = "F_t/F_n deviates from tan(ψ/2), because the surfaces tilt under the normal force."
ROLLED = "The stiffness decreases as the torque increases, and is zero at the largest torque."


def sketch(q: Cup) -> Sketch:
    """Sketch of one pitch, to scale: shaft, roller, cup, angle psi between contact normals."""
    cam, half = q.cam, math.pi / q.z
    x, y = (float(v) for v in cam.centre(d_i=0.0, d_o=0.0))
    psi, unit = 2 * float(cam.alpha0), 1 / q.X_o
    turn = np.linspace(-half, half, 61)

    def arc(r: float, at: float = 0.0) -> Array:
        return np.asarray(r * unit * np.column_stack([np.sin(turn + at), np.cos(turn + at)]))

    right = q.corner * unit * np.array([math.sin(half), math.cos(half)])
    cup = np.vstack([arc(q.R_a), right, right * [-1, 1]])
    shaft = np.vstack([arc(q.R_s, psi), arc(q.r_b, psi)[::-1]])
    around = np.linspace(0, 2 * np.pi, 91)
    centre, out = unit * np.array([x, y]), np.array([math.sin(psi), math.cos(psi)])
    roller = centre + q.r * unit * np.column_stack([np.cos(around), np.sin(around)])
    at_cup, at_shaft = centre + np.array([0, q.r * unit]), centre - q.r * unit * out
    top, low, force = q.R_a * unit, q.r_b * unit, 0.55 * min(q.R_s - q.r_b, q.R_a - q.X_o) * unit
    side = 1.12 * q.corner * unit * math.sin(half)
    return sketches.sketch(
        f"one of {q.z} pitches, to scale. Anticlockwise rotation of the shaft draws the roller to "
        "the left, towards the middle of the flat, where the gap is narrowest. Both cut faces of "
        "the pitch have equal radial and circumferential displacements (cyclic symmetry)",
        shape("modelled", cup), shape("modelled", shaft),
        shape("body", roller),
        arrow((0.0, 0.9 * low), (0.0, 1.05 * top), style="axis"),
        arrow(0.9 * low * out, 1.03 * top * out, style="axis"),
        arrow(at_cup + np.array([0, force]), at_cup, "F_n"),
        arrow(at_shaft - force * out, at_shaft),
        leader((side, q.R_s * unit * 0.8), arc(q.R_s, psi)[42], f"R_s = {q.R_s * 1e3:.4g} mm"),
        leader((side, y * unit * 0.97), centre, f"r = {q.r * 1e3:.4g} mm"),
        leader((side, 1.12), (0.7 * right[0], 1.0), f"X_o = {q.X_o * 1e3:.8g} mm"),
        text((0.25, 1.09 * top), f"ψ = 2α_0 = {psi * DEGREE:.4g}°"),
    )  # fmt: skip


def figures(q: Cup) -> Iterator[Drawing]:
    """Figures: torque and angle over the normal force; values over torque; pressures."""
    yield converged(_torques)
    yield converged(_angles)
    yield over_torque.angle(q, ends="; load reduces the angle.")
    yield converged(partial(over_torque.torsion, printed="s/R_s + s/X_o", note=ROLLED))
    yield over_torque.travel(q)
    yield converged(
        partial(over_torque.bisector, x="F_n [kN]", cam="cup", race="shaft", note=TILTS)
    )
    yield over_torque.pressure("cup")
    yield over_torque.pressure("shaft")


def _course(context: Context) -> RollerClutchState:
    return at_normal_force(context.inputs.clutch, FORCES * context.fem[-1].arrays["loads"][1][-1])


def _torques(context: Context) -> Curves:
    T, N, *_ = context.fem[-1].arrays["loads"]
    states, q = _course(context), context.inputs
    below = states.N[q.z * q.R_s * states.N * math.tan(float(q.cam.alpha0)) < 1.25 * states.T.max()]
    return plot(
        "Torque over normal force, up to the largest torque and beyond", "F_n [kN]", "T [N m]",
        line("z R_s F_n tan α", states.N / 1e3, states.T),
        dashes("constant angle α_0", below / 1e3,
               q.z * q.R_s * below * math.tan(float(q.cam.alpha0)), 1),
        dots("FE", N / 1e3, T),
        note="In the finite elements, the approach of the contacts is prescribed, so that states "
             "beyond the largest torque are found. In these states, the torque decreases as the "
             "normal force increases: under a constant torque, the rollers pop through.",
    )  # fmt: skip


def _angles(context: Context) -> Curves:
    _, N, psi, *_ = context.fem[-1].arrays["loads"]
    states = _course(context)
    return plot(
        "Clamping angle over normal force", "F_n [kN]", "α [°]",
        line("Eq. 5 for a cup", states.N / 1e3, states.alpha * DEGREE),
        dots("FE", N / 1e3, psi / 2 * DEGREE),
        y_bottom=0.0,
        note="Load reduces the angle. At α = 0 the roller is at the middle of the flat and pops "
             "through.",
    )  # fmt: skip
