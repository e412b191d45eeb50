"""Axial load at which a wedged roller slips, from states with the ring displaced along z.

The limit is obtained from solved states only. First, the rim of the ring is displaced so that
the axial load follows a given path. Then the rim is displaced further, until no loaded node of one
contact sticks and the resultant friction of this contact is mu N.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from fem.contact.errors import NotFoundError
from fem.wedge.flat import Sector, State
from fem.wedge.flat_start import Start
from fem.wedge.pulled import EDGES, Borne, Pulled, creeping, lever_left, sector, yielding

STEP = 0.25  # step of the rim along z, over the deflection of parts at the limit
MOBILISED = 1e-6  # relative to the axial force: largest growth by the cone where a contact slips
MET = 2e-3  # relative to the limit, within which loads of a path are met
MOST = 40  # steps
# Halving the steps again and again adds 1.5 to 2.1 times what the last halving did, measured down
# to a thirty-second of the deflection.
HALVINGS = 2.5


@dataclass(frozen=True)
class Driven:
    """Contact state with the displacement `u` [m] of the rim of the ring along z."""

    state: State
    u: float

    @property
    def force(self) -> float:
        """Axial force [N/m] of one roller on the star."""
        return float(Borne.on_mesh(self.state).F_z[0])


@dataclass(frozen=True)
class Drive:
    """Clutch under its torque, with the rim of the ring displaced along z.

    The roller remains in its position: rotation of the ring compensates the creep of the roller.
    """

    one: Pulled
    there: Sector
    rest: State

    @classmethod
    def at(cls, one: Pulled, start: Start, cells: int) -> "Drive":
        there = sector(one.q, start, cells, one.mu, driven=True)
        return cls(one, there, there.rest(start.drags))

    @property
    def unit(self) -> float:
        """Force F_z [N/m] of a roller at which the resultant of F_t and F_z is mu N.

        The forces refer to the normals of the mesh.
        """
        return axial_unit(self.one, self.rest)

    @cached_property
    def way(self) -> float:
        """Displacement [m] of the rim of the ring along z under the force `unit`, without slip."""
        return yielding(self.one, self.there, self.rest)

    def along(self, shares: Sequence[float]) -> Driven:
        """State at the end of a load path: from rest through the axial loads `shares` x `unit`."""
        at = Driven(self.rest, 0.0)
        for share in shares:
            at = self._to(share * self.unit, at)
        return at

    def together(self, share: float) -> Driven:
        """State after applying torque and axial load together, from zero load.

        The axial displacement is the deflection under `share` x `unit`.
        """
        u = share * self.way
        rim = self._rim(u)
        first = self.there.at(self.rest.drags, axial_displacements=rim)
        return Driven(creeping(self.there, first, axial_displacements=rim), u)

    def load(self, at: Driven) -> tuple[float, float]:
        """Axial load [N] of the whole clutch at slip from the state `at`, and its uncertainty.

        It applies to the given torque, and to the clamping angle of the clutch under this torque.
        """
        one, R = self.one, self.one.q.race
        lever, doubt = self.lever(at)
        own = lever_left(one.mu, self.rest.place) / lever_left(one.mu, self.rest.start)
        missed = self._steep * abs(self.rest.torque * one.L / one.T - 1)
        return lever * own * one.T / R, (doubt + missed * lever) * own * one.T / R

    def lever(self, at: Driven) -> tuple[float, float]:
        """Ratio F_ax R/T at slip from the state `at`, and its uncertainty."""
        (coarse, _), (fine, left) = (self._slip(at, step) for step in (2 * STEP, STEP))
        return fine, HALVINGS * abs(fine - coarse) + (left + self._steep * EDGES) * fine

    def left(self, at: Driven) -> float:
        """Relative increase of the axial force that friction permits at the N and F_t of `at`."""
        b = Borne.on_mesh(at.state)
        force = b.F_z * (1, -1)
        if not np.all(force > 0):
            return np.inf
        bound = np.sqrt(np.maximum((self.one.mu * b.N) ** 2 - b.F_t**2, 0.0))
        return float((bound / force).min()) - 1

    @property
    def _steep(self) -> float:
        """Value of -d ln(lever)/d ln(tan alpha) at the limit."""
        return 1 + 1 / lever_left(self.one.mu, self.rest.start) ** 2

    def _slip(self, at: Driven, step: float) -> tuple[float, float]:
        """Largest ratio F_ax R/T up to slip, and the value of `left` at slip."""
        largest, ahead = 0.0, 0.0
        for _ in range(MOST):
            new = self._onward(at, step * self.way, ahead)
            ahead = new.state.drags[1] - at.state.drags[1]
            at, left = new, self.left(new)
            largest = max(largest, new.force * self.one.q.z * self.one.q.race / new.state.torque)
            if new.state.solution.slides and left <= MOBILISED:
                return largest, left
        raise NotFoundError(
            f"no slip was found: after {MOST} steps of the ring along z, friction still permits a "
            f"relative increase of the axial force by {left:.1e}"
        )

    def _to(self, force: float, at: Driven) -> Driven:
        """State under an axial force [N/m], by the secant method."""
        slope = self.unit / self.way
        for _ in range(MOST):
            missing = force - at.force
            if abs(missing) <= MET * self.unit:
                return at
            new = self._onward(at, missing / slope)
            slope = (new.force - at.force) / (new.u - at.u)
            at = new
            if not slope > 0:
                break
        raise NotFoundError(
            f"the axial force {force:.4g} N/m was not reached: the difference is {missing:.1e} N/m"
        )

    def _onward(self, at: Driven, du: float, ahead: float = 0.0) -> Driven:
        u = at.u + du
        return Driven(creeping(self.there, at.state, ahead, axial_displacements=self._rim(u)), u)

    def _rim(self, u: float) -> dict[str, float]:
        return {self.one.q.names.race_held: u}


def axial_unit(one: Pulled, rest: State) -> float:
    """Largest axial force F_z [N/m] of a roller that friction permits in addition to F_t at rest.

    The state `rest` gives F_t. The force is calculated for the normals of the mesh.
    """
    return rest.torque / (one.q.z * one.q.race) * lever_left(one.mu, rest.start)
