"""Finite elements of a user's clutch: under its torque, with shifted flats and with F_ax."""

import math

import numpy as np
from numpy.typing import NDArray

from fem.wedge.flat_moved import angle_with_flats
from fem.wedge.flat_start import Start
from fem.wedge.pulled import Pulled
from fem.wedge.slip_limit import Limit
from verify.case import Level
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.cases.freewheel.fem import pitch
from verify.cases.freewheel.reference import LEVELS, SPLINE, field
from verify.cases.freewheel.star import Star
from verify.cases.freewheel.sweep import sweep

Array = NDArray[np.float64]

LEFT = 1e-5  # tolerance of dalpha/dX for the last step to the torque
GRID = np.linspace(0.1, 1.0, 10)  # torques of the compared profiles, over T
AROUND = (0.99, 1.01)  # friction over mu_req: slips, holds


def solve(q: ClutchInputs, level: int) -> Level:
    """Results on one mesh: sweep over torque, shifted flats; on the finest mesh also slip."""
    one, T = q.as_star, q.T
    states = sweep(one, level)
    place = states.place(T)
    start = states.start(T)
    low, high = (
        angle_with_flats(pitch(one), start, one.X + dX, level, T=T, L=one.L)
        for dX in (-q.off, q.off)
    )
    grid = GRID * T
    places = [states.place(t) for t in grid]
    values = {
        "alpha": place.psi / 2, "N": states.at("N", T),
        "phi": states.torsion_by_energy(np.array([T]))[0], "dalpha_dX": (high - low) / (2 * q.off),
    }  # fmt: skip
    arrays = {
        "alpha_over_T": np.array([p.psi / 2 for p in places]),
        "phi_over_T": states.torsion_by_energy(grid),
        "moved": np.array([low, place.psi / 2, high]),
    }
    if level == LEVELS[-1]:
        arrays["around"] = around(q, one, start)
    u_it = {key: SPLINE * abs(float(v)) for key, v in values.items()}
    u_it["dalpha_dX"] = LEFT * abs(values["dalpha_dX"])
    return Level(
        h=1 / level, values={k: float(v) for k, v in values.items()},
        u_it={k: float(v) for k, v in u_it.items()}, arrays=arrays, fields=(field(states.last),),
    )  # fmt: skip


def around(q: ClutchInputs, one: Star, start: Start) -> Array:
    """Array (2,): 1 if the clutch holds, 0 if it slips, with friction `AROUND` times mu_req.

    mu_req follows from the clamping angle by finite elements.
    """
    given = Pulled(pitch(one), L=one.L, T=one.T, F_ax=q.F_ax, mu=q.mu)
    limit = Limit(given, start, start.drags)
    needed = limit.tan * math.hypot(1.0, q.F_ax * q.R / q.T)
    return np.array([float(limit.bears(share * needed)) for share in AROUND])
