"""Wedged rollers of constant torque under successive axial loads, with the history of friction.

The roller stays in its place: where it creeps out under friction, the ring turns on.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.wedge.drive import axial_unit
from fem.wedge.flat import Sector, State
from fem.wedge.flat_start import Start, after
from fem.wedge.pulled import HARDER, Borne, Pulled, creeping, sector, slipping

Array = NDArray[np.float64]

CORRECTIONS = 2  # of a place under another torque


@dataclass(frozen=True)
class Held:
    """The clutch under its torque and axial forces; the unit of F_z is the friction left by F_t."""

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
        """On from `state` to an axial load; NotFoundError if no rest is found under it."""
        return creeping(self.there, state, axial_forces=self._rim(share * self.unit))

    def at_once(self, force: float) -> State:
        """The state under an axial force [N/m] that comes with the torque, from no load."""
        return self.there.at(self.rest.drags, axial_forces=self._rim(force))

    def follow(self, shares: Sequence[float]) -> list[State]:
        """The states under axial loads one after the other, from rest on."""
        states, state = [], self.rest
        for share in shares:
            state = self.to(share, state)
            states.append(state)
        return states

    def walk(self, share: float, cycles: int) -> Array:
        """Rotation (cycles,) [m] of the ring's bore in each cycle of one axial amplitude."""
        state, drags = self.rest, [self.rest.drags[1]]
        for _ in range(cycles):
            state = self.to(-share, self.to(share, state))
            drags.append(state.drags[1])
        return np.diff(drags)

    def rows(self, shares: Sequence[float], states: Sequence[State]) -> Array:
        """Share and contact loads of each state (m, 9).

        F_t/N and F_z/N of cam and ring, N and T over those at rest, the part of N that slips, and
        the largest u_z [m].
        """
        N, found = Borne.by(self.rest).N.mean(), []
        for share, state in zip(shares, states, strict=True):
            b, along = Borne.by(state), state.solution.along
            assert along is not None
            found.append([
                share, *(b.F_t / b.N), *(b.F_z / b.N), b.N.mean() / N,
                state.torque / self.rest.torque, slipping(state).mean(), np.abs(along.u).max(),
            ])  # fmt: skip
        return np.array(found)

    def _rim(self, force: float) -> dict[str, float]:
        return {self.one.q.names.race_held: force}


def under_torque(there: Pulled, near: Start, T: float, cells: int) -> Start:
    """Where the clutch lies under the torque of `there`, from where it lies under `T` [N m]."""
    if there.T == T:
        return near
    now = near.scaled((there.T / T) ** HARDER)
    for _ in range(CORRECTIONS):
        state = now.state(there.q, cells)
        now = after(state).scaled((there.T / (state.torque * there.L)) ** HARDER)
    return now
