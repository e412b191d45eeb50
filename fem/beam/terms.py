"""Terms of a geometrically exact frame besides its elements: contact, friction, springs."""

from typing import Protocol

from scipy.sparse import csc_array

from fem.beam.large_elements import Extended
from fem.beam.section import Array

Positions = Array | Extended


class Term(Protocol):
    """Forces that depend on the positions of the nodes of a frame, and possibly on their history.

    `fem.beam.large.LargeFrame` calls `start` before a path begins in the reference state,
    `evaluate` in every Newton iteration, `settle` after convergence, and then `accept`; or
    `reject`, if a smaller step replaces the step. Every x is an array (n, 3):
    current positions and the rotation of the nodes, zero in the reference state [length, rad],
    after `start` with the extended precision of the displacements of the frame: otherwise, the
    force of a stiff contact would lose its last digits.

    `dissipated` is the energy lost since `start`, up to the last `accept`.
    """

    dissipated: float = 0.0

    def start(self, x: Array) -> None:
        """Forget all history; `x` is the reference state."""

    def evaluate(self, x: Positions) -> tuple[float, Array, csc_array]:
        """Stored energy, internal force (3n,) = d energy/dx and tangent (3n, 3n) at `x`.

        The internal force is the load in balance with the term: if a spring pulls a node back, the
        force has the direction of the displacement. It represents the step from the last accepted
        state to `x` and must not change the history, because Newton's method can evaluate any x in
        any order. With friction, the force has no potential and the tangent may be asymmetric; the
        energy is then the recoverable part.
        """
        ...

    def settle(self, x: Positions) -> bool:  # noqa: ARG002
        """Improve multipliers at the converged `x`; True if equilibrium must be found again.

        What it changes must be undone by `reject`.
        ConvergenceError (`fem.beam.large_balance`) rejects `x`: the step is abandoned.
        """
        return False

    def accept(self, x: Positions) -> None:
        """Accept `x` as the new state: history, multipliers and `dissipated` become final."""

    def reject(self) -> None:
        """Return to the last accepted state (multipliers that `settle` changed, for instance)."""
