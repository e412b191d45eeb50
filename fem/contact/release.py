"""Contact of bodies without sufficient supports: rigid motions on springs that are relaxed.

Springs resist the rigid motions. With stiff springs, the solution is unique. The springs are made
weaker in steps, and the solution is followed until the springs carry no load.
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
    """Method of relaxed springs for a contact system with gaps `w_0` (n,) and loads `e` (k,).

    `changes` lists the number of rows that changed their state in each iteration; `pivoted` has one
    entry for each solution by Lemke's method.
    """

    system: ContactSystem
    w_0: Array
    e: Array
    changes: list[int] = field(default_factory=list)
    pivoted: list[int] = field(default_factory=list)
    finer: float = 1.0  # factor of the tolerances of states

    def rest(self, states: States, springs: tuple[float, ...]) -> Solution:
        """Solution from given initial states, on weaker and weaker springs, then without springs.

        Raises NotFoundError if no method solves a step, or if motions continue to grow.
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
        raise NotFoundError(
            f"contact forces differ from the loads by {missed:.1e}; the largest force is {size:.1e}"
        )

    def _settled(self, motion: Array, share: float, states: States) -> Solution:
        """Solution on springs of relative stiffness `share` that are unloaded at `motion` (k,)."""
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
        raise NotFoundError(
            "neither active sets nor Lemke's method solve the contact problem with springs"
        )
