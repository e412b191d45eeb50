"""Contact of bodies supported by contact only: rigid motions on springs that are released.

Springs resist the motions; on stiff springs, the solution is unique. A sequence of ever weaker
springs follows this solution until they carry no load.
"""

from dataclasses import dataclass, field

import numpy as np

from fem.contact.active_sets import Solution, States, exchanged
from fem.contact.errors import NotFoundError
from fem.contact.friction_lcp import FrictionLcp
from fem.contact.residual import residual
from fem.contact.system import ContactSystem
from fem.plane.discretisation import Array

SPRINGS = (1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7)  # of the stiffness of the contact
WEAKEST_SPRING = 1e-12
RELEASED = 1e-13  # relative to the forces on rigid motions: remaining force of the springs
NEUTRAL = 1e-6  # relative to the forces on rigid motions: error of facets relative to the surface
MAX_RELEASES = 60
ACCEPTED_RESIDUAL = 1e-9


@dataclass(frozen=True)
class Release:
    """The method of released springs for a system under `w_0` (n,), `e` (k,).

    `changes` lists the number of rows that changed their state in each exchange; `pivoted` is the
    number of solutions by Lemke's method.
    """

    system: ContactSystem
    w_0: Array
    e: Array
    changes: list[int] = field(default_factory=list)
    pivoted: list[int] = field(default_factory=list)
    finer: float = 1.0  # factor of the tolerances of states

    def rest(self, states: States, springs: tuple[float, ...]) -> Solution:
        """The solution from given states, on ever weaker springs, then without springs.

        NotFoundError if none of the methods solves a step, or if motions continue to grow.
        """
        system, motion = self.system, np.zeros(self.system.D.shape[1])
        for share in springs if motion.size else (0.0,):
            multipliers, motion, states = self._settled(motion, share, states)
        missed, size = system.missed(self.e, multipliers)
        nothing, share = system.loads_at_round_off(self.w_0), springs[-1]
        for _ in range(MAX_RELEASES):
            if missed <= RELEASED * size:
                return multipliers, motion, states
            multipliers, motion, states = self._settled(motion, share, states)
            before = missed
            missed, size = system.missed(self.e, multipliers)
            if missed > before / 2:
                if missed <= max(NEUTRAL * size, nothing):
                    return multipliers, motion, states  # a neutral motion is unchanged
                share = max(share / 10, WEAKEST_SPRING)  # a gap still has to close
        raise NotFoundError(f"contact forces still miss the loads by {missed:.1e} of {size:.1e}")

    def _settled(self, motion: Array, share: float, states: States) -> Solution:
        """The solution on springs that pull back to `motion` (k,)."""
        spring = self.system.springs(share)
        e = self.e + spring @ motion
        try:
            return exchanged(self.system, self.w_0, e, spring, states, self.changes, self.finer)
        except NotFoundError:
            if not self.system.rough.size:
                raise
        for found in FrictionLcp(self.system, self.w_0, e, spring).candidates():
            free = e - spring @ found[1]
            missed = residual(self.system, self.w_0, free, found[0], found[1])
            if missed.largest <= ACCEPTED_RESIDUAL:
                self.pivoted.append(len(self.changes))
                return found
        raise NotFoundError("neither active sets nor Lemke's method solve the problem on springs")
