"""Wedged rollers under constant torque and successive axial loads, with the history of friction.

The roller remains in its position: rotation of the ring compensates the creep of the roller.
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
    """Clutch under its torque and successive axial forces.

    Axial forces are given relative to `unit`, the largest that friction permits in addition to F_t.
    """

    one: Pulled
    there: Sector
    rest: State

    @classmethod
    def at(cls, one: Pulled, start: Start, cells: int, mu: float) -> "Held":
        there = sector(one.q, start, cells, mu, driven=False)
        return cls(one, there, there.rest(start.drags))

    @property
    def unit(self) -> float:
        """Force F_z [N/m] of a roller at which the resultant of F_t and F_z is mu N.

        The forces refer to the normals of the mesh.
        """
        return axial_unit(self.one, self.rest)

    def to(self, share: float, state: State) -> State:
        """State under the axial load `share` x `unit`, continuing from `state`.

        Raises NotFoundError without equilibrium.
        """
        return creeping(self.there, state, axial_forces=self._rim(share * self.unit))

    def at_once(self, force: float) -> State:
        """State under an axial force [N/m] applied together with the torque, from zero load."""
        return self.there.at(self.rest.drags, axial_forces=self._rim(force))

    def follow(self, shares: Sequence[float]) -> list[State]:
        """States under the successive axial loads `shares` x `unit`, beginning at rest."""
        states, state = [], self.rest
        for share in shares:
            state = self.to(share, state)
            states.append(state)
        return states

    def walk(self, share: float, cycles: int) -> Array:
        """Displacement (cycles,) [m] of the bore of the ring in each cycle of the axial load.

        In each cycle, the axial load is `share` x `unit`, then -`share` x `unit`.
        """
        state, drags = self.rest, [self.rest.drags[1]]
        for _ in range(cycles):
            state = self.to(-share, self.to(share, state))
            drags.append(state.drags[1])
        return np.diff(drags)

    def rows(self, shares: Sequence[float], states: Sequence[State]) -> Array:
        """Axial load and contact loads of each state (m, 9).

        The columns are the axial load divided by `unit`; F_t/N of cam and ring; F_z/N of cam and
        ring; N and T, both relative to the values at rest; the share of N at slipping nodes; and
        the largest absolute u_z [m].
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
    """Approximate state of the clutch under the torque `there.T`.

    It is calculated from `near`, the approximate state under the torque `T` [N m].
    """
    if there.T == T:
        return near
    now = near.scaled((there.T / T) ** HARDER)
    for _ in range(CORRECTIONS):
        state = now.state(there.q, cells)
        now = after(state).scaled((there.T / (state.torque * there.L)) ** HARDER)
    return now
