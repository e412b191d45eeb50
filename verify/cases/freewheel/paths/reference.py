"""Finite elements of a freewheel along the rig's load paths, from rest to rest with their history.

Load cases 1 and 2 keep the torque: the roller stays in its place, and where friction lets it creep
out the ring turns on. Axial loads count at the torque that is asked for. In load case 3 rollers
roll on by more than their contacts are wide; each torque has a place and a mesh of its own, where
both loads come on together.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fem.wedge.drive import Drive, axial_unit
from fem.wedge.flat import Sector, State
from fem.wedge.flat_place import Place
from fem.wedge.flat_start import Start, after
from fem.wedge.pulled import (
    HARDER,
    Borne,
    Pulled,
    ample,
    at_torque,
    creeping,
    sector,
    slipping,
)
from verify.case import Level
from verify.cases.freewheel.pulled_sector import field, one_pulled

Array = NDArray[np.float64]

LEVELS = (3, 4, 5)  # cells on the half-width of the fine zones
RAMP = (0.3, 0.6, 0.95)  # of the limit of the axial load, load case 1
GROWING = (0.3, -0.45, 0.6, -0.75, 0.9, -0.95)  # and at the extremes of load case 2
QUIET, LOUD, CYCLES = 0.4, 0.8, 4  # amplitudes that stay the same, and for how long
MU_REQ = {1.0: "mu_req_high", 0.3: "mu_req_low"}  # by sines of load case 3
SOLVED = 1e-6  # of mu_req
CORRECTIONS = 2  # of a place under another torque
OTHERS = (0.6, 0.9)  # and further ones, of the figure alone
TOGETHER = 0.95  # of the way to the limit in load case 3: what comes from no load at once


@dataclass(frozen=True)
class Held:
    """The clutch under its torque and axial forces, in a unit of what friction leaves for F_z."""

    one: Pulled
    there: Sector
    rest: State

    @classmethod
    def at(cls, one: Pulled, start: Start, cells: int, mu: float) -> "Held":
        there = sector(one.q, start, cells, mu, driven=False)
        return cls(one, there, there.rest(start.drags))

    @property
    def unit(self) -> float:
        """F_z [N/m] with which F_t makes mu N by the normals of the mesh, and the torque."""
        return axial_unit(self.one, self.rest)

    def to(self, share: float, state: State) -> State:
        """On from `state` to an axial load; NotFoundError where no rest is found under it."""
        return creeping(self.there, state, axial_forces={"ring.rim": share * self.unit})


def solve(q: Any, level: int) -> Level:
    """One level of all paths; on the finest the loads at slip."""
    one = one_pulled(q)
    start = at_torque(one, level)
    held, drive = Held.at(one, start, level, q.mu), Drive.at(one, start, level)
    ramp, growing = follow(held, RAMP), follow(held, GROWING)
    values = in_phase(q, start, level)
    u_it = dict.fromkeys(values, SOLVED)
    values["F_1"], u_it["F_1"] = drive.load(drive.along(RAMP))
    arrays = {
        "ramp": rows(held, RAMP, ramp), "growing": rows(held, GROWING, growing),
        "own": np.array([
            math.tan(held.rest.place.psi / 2), held.rest.torque * q.L, held.unit * q.z * q.L,
        ]),
    }  # fmt: skip
    if level != LEVELS[0]:
        arrays["cycles"] = np.array([walk(held, share) for share in (QUIET, LOUD)])
    if level == LEVELS[-1]:
        last = drive if q.T_critical == q.T else critical(q, start, level)
        arrays["slips"] = np.array([
            drive.load(drive.along(GROWING)), last.load(last.together(TOGETHER)),
        ])  # fmt: skip
        coarse = Held.at(one, at_torque(one, LEVELS[0]), LEVELS[0], q.mu)
        arrays["walks"] = np.array([walk(coarse, share) for share in OTHERS])
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=(field(growing[-1]),))


def in_phase(q: Any, near: Start, cells: int) -> dict[str, float]:
    """Load case 3: required friction at the sines of `MU_REQ`."""
    values = {}
    for share, key in MU_REQ.items():
        there = one_pulled(q.model_copy(update={"T": q.T_m + share * q.T, "F_ax": share * q.F_ax}))
        start = under(there, near, q.T, cells)
        mu = ample(there, Place.overlapping(there.q, *start.d))
        own = Held.at(there, start, cells, mu)
        force = {"ring.rim": there.F_ax * own.rest.torque / (q.z * there.T)}
        state = own.there.at(own.rest.drags, axial_forces=force)
        values[key] = float(Borne.by(state).required.mean())
    return values


def critical(q: Any, near: Start, cells: int) -> Drive:
    """The clutch at the torque of load case 3 at which the least amplitude slips."""
    there = replace(one_pulled(q), T=q.T_critical)
    return Drive.at(there, under(there, near, q.T, cells), cells)


def under(there: Pulled, near: Start, T: float, cells: int) -> Start:
    """Where the clutch lies under the torque of `there`, from where it lies under `T` [N m]."""
    if there.T == T:
        return near
    now = near.scaled((there.T / T) ** HARDER)
    for _ in range(CORRECTIONS):
        state = now.state(there.q, cells)
        now = after(state).scaled((there.T / (state.torque * there.L)) ** HARDER)
    return now


def follow(held: Held, shares: Sequence[float]) -> list[State]:
    states, state = [], held.rest
    for share in shares:
        state = held.to(share, state)
        states.append(state)
    return states


def walk(held: Held, share: float) -> Array:
    """How far (CYCLES,) [m] the ring's bore turns on in each cycle of one axial amplitude."""
    state, drags = held.rest, [held.rest.drags[1]]
    for _ in range(CYCLES):
        state = held.to(-share, held.to(share, state))
        drags.append(state.drags[1])
    return np.diff(drags)


def rows(held: Held, shares: Sequence[float], states: Sequence[State]) -> Array:
    """Of each state (m, 9) its share and what it bears.

    F_t/N and F_z/N of star and ring, N and T over those at rest, the part of N that slips, and the
    largest u_z [m].
    """
    N, found = Borne.by(held.rest).N.mean(), []
    for share, state in zip(shares, states, strict=True):
        b, along = Borne.by(state), state.solution.along
        assert along is not None
        found.append([
            share, *(b.F_t / b.N), *(b.F_z / b.N), b.N.mean() / N,
            state.torque / held.rest.torque, slipping(state).mean(), np.abs(along.u).max(),
        ])  # fmt: skip
    return np.array(found)
