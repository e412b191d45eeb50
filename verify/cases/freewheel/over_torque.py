"""Figures of results over the torque, common to star and cup."""

import math
from typing import Any

import numpy as np

from analytic.freewheel.state import loaded
from verify.case import AlongLine
from verify.cases.freewheel.reference import ACROSS, GRID
from verify.core.case import Context
from verify.core.figures import Curves
from verify.form.plots import dashes, dots, line, plot

FINE = np.linspace(0.002, 1.0, 160)  # torques of the curves, over T
DEGREE = math.degrees(1.0)
WIDTH = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 201))  # x/a of a contact, more points at its ends


def angle(q: Any, *, ends: str) -> AlongLine:
    """Figure of the clamping angle over torque; the note on alpha_0 ends with the text `ends`."""
    return AlongLine(
        title="Clamping angle over torque", x=("T", "N m"), y=("α", "°"),
        curve=lambda T: loaded(q.clutch, T).alpha, reference="alpha_over_T", at=GRID * q.T,
        points=FINE * q.T, order=2, scale=q.alpha, scale_name="α(T)", neglects=True,
        note=f"At zero torque the angle is α_0 = {q.alpha_0 * DEGREE:.4g}°{ends}",
    )  # fmt: skip


def travel(q: Any) -> AlongLine:
    """Figure of the travel s of the roller's centre over torque."""
    return AlongLine(
        title="Travel of the roller's centre (Eq. 6)", x=("T", "N m"), y=("s", "µm"),
        curve=lambda T: loaded(q.clutch, T).s, reference="s_over_T", at=GRID * q.T,
        points=FINE * q.T, order=2, scale=q.s, scale_name="s(T)", neglects=True,
    )  # fmt: skip


def torsion(context: Context, *, printed: str, note: str) -> Curves:
    """Figure of the wind-up by exact rolling, by Eq. 7 as printed, and by finite elements.

    The legend describes the printed equation by the text `printed`.
    """
    q = context.inputs
    states = loaded(q.clutch, FINE * q.T)
    return plot(
        "Wind-up over torque: Eq. 7 as printed and exact rolling", "T [N m]", "φ [°]",
        line("exact rolling", FINE * q.T, states.phi * DEGREE),
        dashes(f"Eq. 7 as printed, {printed}", FINE * q.T, states.phi_printed * DEGREE, 1),
        dots("FE, from strain energy", GRID * q.T, context.fem[-1].arrays["phi_over_T"] * DEGREE),
        note=note,
    )  # fmt: skip


def bisector(context: Context, x: str, cam: str, race: str, note: str) -> Curves:
    """Figure over `x` (T or F_n): deviation of F_t/F_n at both contacts from tan(psi/2)."""
    T, N, psi, *_ = context.fem[-1].arrays["loads"]
    load = T if x.startswith("T") else N / 1e3
    on_cam, on_race = 1e3 * (context.fem[-1].arrays["shares"] / np.tan(psi / 2) - 1)
    return plot(
        "Deviation of F_t/F_n from tan(ψ/2) at both contacts", x, "(F_t/F_n)/tan(ψ/2) − 1 [10⁻³]",
        dots(f"FE, on the {cam}", load, on_cam),
        dots(f"FE, on the {race}", load, on_race, 2),
        line("rigid surfaces", [0.0, load[-1]], np.zeros(2)),
        y_bottom=None, note=note,
    )  # fmt: skip


def pressure(where: str) -> AlongLine:
    """Figure of the pressure on a part, divided by Hertz's peak, under the largest normal force."""
    return AlongLine(
        title=f"Pressure on the {where}, at the largest computed normal force",
        x=("x/a", "1"), y=("p/p_0", "1"),
        curve=lambda x: np.sqrt(1 - x**2), reference=f"p_on_{where}", at=ACROSS, points=WIDTH,
        order=1, scale=1.0, neglects=True,
        note="Only the shape of the pressure is compared: the half-width a follows from the "
             "moments of the computed pressure, and p_0 = 2P/(πa) from the line load P.",
    )  # fmt: skip
