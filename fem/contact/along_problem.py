"""Contact with friction along the surface and along z: the plane problem extended by u_z."""

from collections.abc import Callable
from contextlib import suppress

import numpy as np

from fem.contact.along import Along, Pull
from fem.contact.along_bodies import AlongBodies
from fem.contact.along_interface import AlongInterface
from fem.contact.along_step import AlongStep
from fem.contact.bodies import Bodies
from fem.contact.complementarity import OPEN, Rest
from fem.contact.cone_descent import Descent, sticking
from fem.contact.cone_newton import SlidingError
from fem.contact.cone_reach import missing
from fem.contact.cone_system import EXACT, State
from fem.contact.errors import NoEquilibriumError, NotFoundError
from fem.contact.interface import Interface, Surfaces
from fem.plane.discretisation import Array, Indices
from fem.plane.material import Assumption

RUNAWAY = 100.0  # times the deformation of surfaces: beyond small displacements

Before = tuple[Rest, AlongStep]


class AlongProblem:
    """Bodies and contact along z, in addition to the plane problem."""

    def __init__(
        self, bodies: Bodies, along: Along, surfaces: Surfaces, plane: Interface,
        assumption: Assumption,
    ) -> None:  # fmt: skip
        if assumption != "plane strain":
            raise ValueError(
                f"displacements along z require the assumption 'plane strain', got {assumption!r}"
            )
        self.bodies = AlongBodies(bodies, along, surfaces.unknowns)
        self.bodies.pull({}, {})  # contradicting supports are an error from the start
        self._of: tuple[Interface, AlongInterface] = plane, AlongInterface(self.bodies, plane)
        self._of[1].check_held()

    def solve(
        self,
        plane: Interface,
        w: Array,
        e: Array,
        pull: Pull,
        before: Before | None,
        closing: tuple[Indices, Array],
        in_plane: Callable[[], Rest],
    ) -> tuple[Rest, AlongStep]:
        """State in the plane and state along z under all loads.

        In the plane, `w` are the gaps and slips without contact forces, and `e` the loads on the
        rigid motions. `pull` is the load along z. `in_plane` calculates the state in the plane
        without friction along z. Gaps of the normal rows in `closing` close in this step, each
        after its given fraction of the step.
        """
        interface = self._interface(plane)
        w_z, e_z = interface.loaded(pull)
        slips = np.zeros(w_z.size) if before is None else before[1].slips
        slips = slips + self._closing(interface, w_z, slips, before, closing)
        w_z = w_z - slips
        descent = Descent(interface.cone, np.concatenate([w, w_z]), np.concatenate([e, e_z]))
        idle = before is None or not np.any(before[1].traction)
        if idle and not (np.any(w_z) or np.any(e_z)):
            rest = in_plane()
            at = _joined(rest, np.zeros(w_z.size), np.zeros(e_z.size))
            residual, _, moved = interface.cone.judged(descent.w_0, descent.e, at)
        else:
            at = self._found(descent, e.size, before, in_plane)
            residual, states, moved = interface.cone.judged(descent.w_0, descent.e, at)
            if not residual.largest <= EXACT:
                raise NotFoundError(
                    "the solution violates the contact laws by more than the tolerance "
                    f"{EXACT:g}: {residual}"
                )
            rest = Rest(at.multipliers[: w.size], at.motion[: e.size], states, ())
        step = AlongStep(
            interface=interface, pull=pull, traction=at.multipliers[w.size :],
            shift=at.motion[e.size :], w=moved[w.size :], slips_before=slips, residual=residual,
        )  # fmt: skip
        self._check_small(plane, rest, step)
        return rest, step

    def _found(
        self, descent: Descent, motions: int, before: Before | None, in_plane: Callable[[], Rest]
    ) -> State:
        """Contact forces and motions that satisfy the equations of the friction cone.

        Raises NoEquilibriumError if the friction cone cannot balance the loads, and NotFoundError
        if no solution is found.
        """
        missed = missing(descent.cone, descent.e)
        if np.any(missed):
            raise NoEquilibriumError(
                f"{self._who(missed, motions)}, and no admissible contact forces balance "
                "the loads: friction along the surface and along z together is at most mu "
                "times the pressure"
            )
        try:
            return descent.solve(_starts(descent, before, in_plane))
        except SlidingError as slide:
            raise NotFoundError(
                f"no equilibrium was found: {self._who(slide.carried, motions)}, and continues to "
                f"slide or roll. Methods tried: {slide}"
            ) from None

    def _interface(self, plane: Interface) -> AlongInterface:
        if self._of[0] is not plane:
            self._of = plane, AlongInterface(self.bodies, plane)
        return self._of[1]

    def _closing(
        self, interface: AlongInterface, w_z: Array, slips: Array, before: Before | None,
        closing: tuple[Indices, Array],
    ) -> Array:  # fmt: skip
        """Slips (r,) along z that surfaces add before their gaps close; zero for other nodes."""
        cone, r = interface.cone, slips.size
        B, D = cone.B[-r:, -r:] if r else cone.B[:0, :0], interface.C @ self.bodies.shifts
        trial = w_z - slips
        if before is not None:
            trial = trial + B @ before[1].traction + D @ before[1].shift
        at = np.searchsorted(cone.rough, closing[0])
        held = np.abs(D[at]).sum(axis=1) == 0
        found = np.zeros(r)
        found[at[held]] = closing[1][held] * trial[at[held]]
        return found

    def _who(self, amplitudes: Array, motions: int) -> str:
        """Description of the rigid motion or the shift along z with the largest amplitude."""
        plane, along = amplitudes[:motions], amplitudes[motions:]
        if along.size and np.linalg.norm(along) >= np.linalg.norm(plane):
            return self.bodies.named(along)
        return self.bodies.bodies.named(plane)

    def _check_small(self, plane: Interface, rest: Rest, step: AlongStep) -> None:
        """Raise NotFoundError if bodies slide along z by much more than they deform.

        Such a state is in equilibrium, but outside the range of small displacements.
        """
        if not step.shift.size:
            return
        closed = rest.states[step.interface.cone.rough] != OPEN
        slip = np.abs(step.w / plane.sizes[step.interface.cone.rough])[closed].max(initial=0.0)
        pushed = self.bodies.compliance(step.interface.C.T @ step.traction)
        pressed = self.bodies.bodies.compliance(plane.C.T @ rest.multipliers)
        size = np.abs(pushed).max() + np.abs(pressed).max() + np.abs(step.pull.u_0).max()
        if slip > RUNAWAY * size:
            raise NotFoundError(
                "no equilibrium with small displacements was found: "
                f"{self.bodies.named(step.shift)}; in the solution, the slip along z is "
                f"{slip:.3g}, while surfaces deform by only {size:.3g}"
            )


def _joined(rest: Rest, traction: Array, shift: Array) -> State:
    return State(np.concatenate([rest.multipliers, traction]), np.concatenate([rest.motion, shift]))


def _starts(descent: Descent, before: Before | None, in_plane: Callable[[], Rest]) -> list[State]:
    """Initial states for the iteration.

    These are the equilibrium of the plane with all nodes sticking along z, if it is found, and the
    state of the previous step.
    """
    starts = []
    with suppress(ArithmeticError):
        rest = in_plane()
        plane = State(rest.multipliers, rest.motion)
        starts.append(sticking(descent.cone, descent.w_0, descent.e, plane))
    if before is not None:
        starts.append(_joined(before[0], before[1].traction, before[1].shift))
    return starts
