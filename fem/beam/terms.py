"""Additional terms of a geometrically exact frame: contact, friction, springs."""

from typing import Protocol

from scipy.sparse import csc_array

from fem.beam.large_elements import Extended
from fem.beam.section import Array

Positions = Array | Extended


class Term(Protocol):
    """Forces that depend on the positions of the nodes of a frame, and possibly on their history.

    `fem.beam.large.LargeFrame` calls `start` before a path begins in the reference state,
    `evaluate` in every Newton iteration, and `settle` after convergence. Then it calls `accept`, or
    `reject` if the step is repeated with a smaller size. Every x is an array (n, 3) of current
    positions and rotations of the nodes [length, rad]; the rotation is zero in the reference state.
    After `start`, x has the extended precision of the displacements of the frame: with double
    precision, the force of a stiff contact would lose its last digits.

    `dissipated` is the energy dissipated since `start`, up to the last `accept`.
    """

    dissipated: float = 0.0

    def start(self, x: Array) -> None:
        """Clear all history; `x` is the reference state."""

    def evaluate(self, x: Positions) -> tuple[float, Array, csc_array]:
        """Stored energy, internal force (3n,) = d energy/dx and tangent (3n, 3n) at `x`.

        The internal force is the load in balance with the term: if a spring pulls a node back, the
        force has the direction of the displacement. The result applies to the step from the last
        accepted state to `x`. The function must not change the history, because Newton's method can
        evaluate any x in any order. With friction, the force has no potential and the tangent may
        be asymmetric; the energy is then the recoverable part.
        """
        ...

    def settle(self, x: Positions) -> bool:  # noqa: ARG002
        """Improve multipliers at the converged `x`; return True if Newton's method must run again.

        The multipliers are Lagrange multipliers, for example contact forces. `reject` must be able
        to undo all changes. Raises ConvergenceError (`fem.beam.large_balance`) to reject `x`: the
        step is then repeated with a smaller size.
        """
        return False

    def accept(self, x: Positions) -> None:
        """Accept `x` as the new state: history, multipliers and `dissipated` become final."""

    def reject(self) -> None:
        """Restore the last accepted state; for example, undo what `settle` changed."""
