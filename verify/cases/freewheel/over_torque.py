"""Curves over the torque that star and cup have in common: angle, way of the rollers, torsion."""

import math

import numpy as np

from analytic.freewheel.state import State
from verify.cases.freewheel.torque.fem import GRID
from verify.core.case import Context
from verify.core.figures import Curve, Curves, Profile
from verify.judging.profiles import along

FINE = np.linspace(0.002, 1.0, 160)  # of T, where curves are drawn
DEGREE = math.degrees(1.0)


def angle(context: Context, states: State, marks: State, *, ends: str) -> Profile:
    """Clamping angle, beginning at alpha_0; `ends` closes the note."""
    values, u = along(context, "profile, alpha", formal=2, scale=1.0)
    q = context.inputs
    return Profile(
        title="Clamping angle over torque", x_label="T [N m]", y_label="α [°]",
        x=FINE * q.T, y=states.alpha * DEGREE, x_fem=GRID * q.T, y_fem=values * DEGREE,
        y_ref=marks.alpha * DEGREE, u=u * DEGREE, scale=context.analytic["alpha"] * DEGREE,
        scale_name="α(T)", neglects=True,
        note=f"It begins at α_0 = {context.analytic['alpha_0'] * DEGREE:.4g}°{ends}",
    )  # fmt: skip


def way(context: Context, states: State, marks: State) -> Profile:
    """Arc s of the roller's centre."""
    values, u = along(context, "profile, s", formal=2, scale=1.0)
    q = context.inputs
    return Profile(
        title="Way of the roller's centre (Eq. 6)", x_label="T [N m]", y_label="s [µm]",
        x=FINE * q.T, y=states.s * 1e6, x_fem=GRID * q.T, y_fem=values * 1e6, y_ref=marks.s * 1e6,
        u=u * 1e6, scale=context.analytic["s"] * 1e6, scale_name="s(T)", neglects=True,
    )  # fmt: skip


def torsion(context: Context, states: State, *, printed: str, note: str) -> Curves:
    """Exact rolling, Eq. 7 as `printed`, and what the energy of finite elements asks for."""
    q = context.inputs
    return Curves(
        title="Torsion over torque: Eq. 7 as printed and exact rolling", x_label="T [N m]",
        y_label="φ [°]",
        curves=(
            Curve(name="exact rolling", x=FINE * q.T, y=states.phi * DEGREE),
            Curve(name=f"Eq. 7 as printed, {printed}", x=FINE * q.T,
                  y=states.phi_printed * DEGREE, style="dashes", colour=1),
            Curve(name="FE, ∫dU/T", x=GRID * q.T,
                  y=context.fem[-1].arrays["profile, phi"] * DEGREE, style="dots"),
        ),
        note=note,
    )  # fmt: skip
