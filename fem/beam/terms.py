"""Terms of a geometrically exact frame besides its elements: contact, friction, springs."""

from typing import Protocol

from scipy.sparse import csc_array

from fem.beam.large_elements import Extended
from fem.beam.section import Array

Positions = Array | Extended


class Term(Protocol):
    """Forces that depend on the positions of a frame's nodes, and perhaps on their history.

    `fem.beam.large.LargeFrame` calls `start` once before a path begins in the reference state,
    `evaluate` in every Newton iteration, `settle` when Newton converged, then `accept`, or
    `reject` where the step is given up and a smaller one follows. Every x is an array (n, 3):
    current positions and the rotation of the nodes, zero in the reference state [length, rad],
    after `start` with the extended precision of the frame's displacements: stiff contact loses
    the last digits of its force otherwise.

    `dissipated` is the energy lost since `start`, up to the last `accept`.
    """

    dissipated: float = 0.0

    def start(self, x: Array) -> None:
        """Forget all history; `x` is the reference state."""

    def evaluate(self, x: Positions) -> tuple[float, Array, csc_array]:
        """Stored energy, internal force (3n,) = d energy/dx and tangent (3n, 3n) at `x`.

        The internal force is the load that balances the term: a spring that pulls a node
        back has it along the node's displacement. It represents the step from the last accepted
        state to `x` and must change no history, since Newton may pass any x in any order. With
        friction the force has no energy and the tangent need not be symmetric; the energy is
        then what could be won back.
        """
        ...

    def settle(self, x: Positions) -> bool:  # noqa: ARG002
        """Improve multipliers at the converged `x`; True if equilibrium must be found again.

        What it changes must be undone by `reject`.
        ConvergenceError (`fem.beam.large_balance`) rejects `x`: the step is abandoned.
        """
        return False

    def accept(self, x: Positions) -> None:
        """Take `x` as the new accepted state: history, multipliers and `dissipated` stand."""

    def reject(self) -> None:
        """Return to the last accepted state (multipliers that `settle` changed, for instance)."""
