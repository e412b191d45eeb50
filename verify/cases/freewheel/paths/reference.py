"""Finite elements of a freewheel along the rig's load paths: static states with friction history.

In load cases 1 and 2 the torque is constant: the roller stays in its position, and the ring
rotates as the roller creeps. Computed axial loads are scaled from the torque of the mesh to the
given torque. In load case 3 rollers travel by more than the width of their contacts: each torque
has a separate position and mesh, on which both loads are applied together.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np

from fem.wedge.drive import Drive
from fem.wedge.flat_place import Place
from fem.wedge.flat_start import Start
from fem.wedge.held import Held, under_torque
from fem.wedge.pulled import Borne, ample, at_torque
from verify.case import Level
from verify.cases.freewheel.pulled_sector import field, one_pulled

LEVELS = (3, 4, 5)  # cells on the half-width of the fine zones
RAMP = (0.3, 0.6, 0.95)  # axial loads over their limit, load case 1
GROWING = (0.3, -0.45, 0.6, -0.75, 0.9, -0.95)  # and at the peaks of the axial load, load case 2
QUIET, LOUD, CYCLES = 0.4, 0.8, 4  # constant amplitudes and their number of cycles
MU_REQ = {1.0: "mu_req_high", 0.3: "mu_req_low"}  # by sines of load case 3
SOLVED = 1e-6  # relative tolerance of mu_req
OTHERS = (0.6, 0.9)  # further sines, for the figure only
TOGETHER = 0.95  # load of the first step over the limit load, in load case 3


def solve(q: Any, level: int) -> Level:
    """Results of all paths on one mesh; on the finest mesh also the loads at slip."""
    one = one_pulled(q)
    start = at_torque(one, level)
    held, drive = Held.at(one, start, level, q.mu), Drive.at(one, start, level)
    ramp, growing = held.follow(RAMP), held.follow(GROWING)
    values = in_phase(q, start, level)
    u_it = dict.fromkeys(values, SOLVED)
    values["F_1"], u_it["F_1"] = drive.load(drive.along(RAMP))
    arrays = {
        "ramp": held.rows(RAMP, ramp), "growing": held.rows(GROWING, growing),
        "at rest": np.array([
            math.tan(held.rest.place.psi / 2), held.rest.torque * q.L, held.unit * q.z * q.L,
        ]),
    }  # fmt: skip
    if level != LEVELS[0]:
        arrays["cycles"] = np.array([held.walk(share, CYCLES) for share in (QUIET, LOUD)])
    if level == LEVELS[-1]:
        last = drive if q.T_critical == q.T else critical(q, start, level)
        arrays["slips"] = np.array([
            drive.load(drive.along(GROWING)), last.load(last.together(TOGETHER)),
        ])  # fmt: skip
        coarse = Held.at(one, at_torque(one, LEVELS[0]), LEVELS[0], q.mu)
        arrays["walks"] = np.array([coarse.walk(share, CYCLES) for share in OTHERS])
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=(field(growing[-1]),))


def in_phase(q: Any, near: Start, cells: int) -> dict[str, float]:
    """Required friction of load case 3 at the phases whose sines are the keys of `MU_REQ`."""
    values = {}
    for share, key in MU_REQ.items():
        there = one_pulled(q.model_copy(update={"T": q.T_m + share * q.T, "F_ax": share * q.F_ax}))
        start = under_torque(there, near, q.T, cells)
        mu = ample(there, Place.overlapping(there.q, *start.d))
        own = Held.at(there, start, cells, mu)
        state = own.at_once(there.F_ax * own.rest.torque / (q.z * there.T))
        values[key] = float(Borne.by(state).required.mean())
    return values


def critical(q: Any, near: Start, cells: int) -> Drive:
    """Drive at `T_critical`, the torque of load case 3 at which the smallest load causes slip."""
    there = replace(one_pulled(q), T=q.T_critical)
    return Drive.at(there, under_torque(there, near, q.T, cells), cells)
