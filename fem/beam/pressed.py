"""Frame whose end has large displacements along x: equilibrium path, reactions at the guided end.

Springs of thin strip have axial and bending stiffnesses that differ by many powers of ten. Strains
are therefore computed from differences of displacements in extended precision, and the stiffnesses
of the head from strains.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from scipy.sparse.linalg import splu

from fem.beam.curved import solve_curved_frame
from fem.beam.large import LargeFrame
from fem.beam.large_state import BeamState
from fem.beam.section import Array, Indices, Section

PLACES = 1e-11  # of a load, displacement or stiffness: nodes' places, rounded in double precision
Freedom = Literal["free", "hinged"]


@dataclass(frozen=True, eq=False)
class PressedFrame:
    """Frame of quadratic `elements` (m, 3), clamped at the node `tail`, displaced at `head`."""

    points: Array
    elements: Indices
    section: Section
    head: int
    tail: int

    @property
    def stiffness(self) -> float:
        """Stiffness along x of an otherwise free head, for small displacements [force/length]."""
        solved = solve_curved_frame(
            self.points, self.elements, sections=self.section, supports={self.tail: "xyr"},
            loads={self.head: (1.0, 0.0, 0.0)},
        )  # fmt: skip
        return -1 / (2 * solved.potential_energy)

    def frame(self, head: str) -> LargeFrame:
        """Frame in which the components `head` of the head are fixed ("yr": guided along x)."""
        supports = {self.tail: "xyr", self.head: head}
        return LargeFrame(self.points, self.elements, sections=self.section, supports=supports)

    @cached_property
    def guided(self) -> LargeFrame:
        return self.frame("yr")

    def compressed(self, U: Iterable[float], since: BeamState | None = None) -> list[BeamState]:
        """Equilibrium states at displacements `U` of the guided head, from rest or from `since`."""
        one = {self.head: {"x": 1.0}}
        return list(self.guided.displaced(one, U, since=since).states)

    def force(self, state: BeamState) -> float:
        """Force on the head along x."""
        return float(state.reactions[self.head, 0])

    def head_stiffness(self, state: BeamState) -> tuple[Array, Array]:
        """Stiffness (3, 3) of the head after release in `state`, and its round-off error (3, 3).

        The stiffness is the force and couple on the head per small displacement and rotation. The
        round-off error is taken from the asymmetry and from the change in the last correction. Only
        the frame without its head is solved, so that the system is regular at the buckling load of
        the frame. Residuals are computed from strains in extended precision, because K u has large
        round-off for thin strips.
        """
        e = self.guided.elements
        strain, _, t = e.strains(state.exact)
        S, stress = e.increments(strain, t), e.moduli * strain
        size = 3 * e.count
        head, tail = (3 * node + np.arange(3) for node in (self.head, self.tail))
        free = np.ones(size, bool)
        free[[*head, *tail]] = False
        symmetric = {"diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}
        K = e.tangent_stiffness(S, strain, t, stress)[free][:, free]
        factor = splu(K.tocsc(), permc_spec="MMD_AT_PLUS_A", **symmetric)
        moved = np.zeros((3, size), np.longdouble)
        moved[range(3), head] = 1.0
        forces, smallest = np.zeros((3, size)), np.inf
        A = e.geometric(strain, t, stress)
        while True:
            before = forces[:, head]
            forces = np.array([
                e.change_with(S, A, u.reshape(-1, 3)) for u in moved
            ])  # fmt: skip
            step = factor.solve(-forces[:, free].T).T
            change = float(abs(step).max())
            if not change < smallest / 2:
                return self._rounded(forces[:, head], before)
            smallest = change
            moved[:, free] += step

    def _rounded(self, S: Array, before: Array) -> tuple[Array, Array]:
        """Symmetric stiffness (3, 3) and its round-off error, taken from the worst entry."""
        size = np.sqrt(abs(np.outer(np.diag(S), np.diag(S))))
        worst = float((np.maximum(abs(S - S.T), abs(S - before)) / size).max())
        return (S + S.T) / 2, worst * size

    def determinant(self, state: BeamState, head: Freedom) -> float:
        """Determinant of the stiffness of a "free" or "hinged" head in a loaded state."""
        return let_go(self.head_stiffness(state)[0], head)

    def lateral_stiffness(self, state: BeamState) -> tuple[float, float]:
        """Lateral stiffness of the guided head along y, and its round-off error [force/length]."""
        S, rounding = self.head_stiffness(state)
        return float(S[1, 1]), float(rounding[1, 1]) + PLACES * abs(float(S[1, 1]))

    def critical_displacement(self, until: float, first: float) -> float | None:
        """Head displacement at the first critical point of the guided frame, or None.

        The result is None if no critical point lies below the displacement `until`. At the critical
        point, the tangent stiffness ceases to be positive definite. Arc-length control passes limit
        points, at which displacement control fails. The path begins with the displacement `first`.
        All displacements are lengths.
        """
        path = self.guided.along_arc(
            None, moved={self.head: {"x": 1.0}}, first=first,
            until=lambda state: state.negative > 0 or state.factor > until,
        )  # fmt: skip
        found = [point.factor for point in self.guided.buckling(path)]
        return min((U for U in found if until > U), default=None)


def let_go(S: Array, head: Freedom) -> float:
    """Determinant of the rows and columns of S (3, 3) for the free components of the head.

    S is the stiffness of the head. A "free" head can move along x and y and rotate; a "hinged" head
    cannot move along y.
    """
    moving = [0, 2] if head == "hinged" else [0, 1, 2]
    return float(np.linalg.det(S[np.ix_(moving, moving)]))
