"""Two rollers under given forces: the upper one's cut is moved until the contact carries them."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from verify.cases.contact.errors import fem_errors
from verify.cases.contact.slip.inputs import SlipInputs

if TYPE_CHECKING:
    from fem.contact.problem import ContactProblem
    from fem.contact.solution import ContactSolution

Array = NDArray[np.float64]

HIT = 1e-12  # of P, within which loads are met


class Rollers:
    """Two equal half discs whose cuts move as rigid lines; loads are met by a secant method."""

    def __init__(self, q: SlipInputs, problem: "ContactProblem") -> None:
        self.q, self.problem = q, problem
        self.pressed, self.flexibility = self._press()

    def at(self, cut: Array, after: "ContactSolution | None") -> "ContactSolution":
        """The state with the upper cut moved by `cut` (x, y) [m]."""
        moved = {"upper.middle": {"x": float(cut[0]), "y": float(cut[1])}}
        return self.problem.solve(displacements=moved, after=after)

    def loaded(
        self, Q: float, cut: Array, after: "ContactSolution"
    ) -> tuple["ContactSolution", Array]:
        """The state under Q and P [N/m], one step on from `after`, and the cut's place.

        `cut` is where to start looking (Broyden's method).
        """
        target, flexibility = np.array([Q, -self.q.P]), self.flexibility
        state = self.at(cut, after)
        for _ in range(50):
            missing = target - state.touches[0].force
            if np.abs(missing).max() <= HIT * self.q.P:
                return state, cut
            step = flexibility @ missing
            cut = cut + step
            state = self.at(cut, after)
            gained = missing - (target - state.touches[0].force)
            miss = step - flexibility @ gained
            flexibility = flexibility + np.outer(miss, step @ flexibility) / (
                step @ flexibility @ gained
            )
        raise fem_errors().NotFoundError(
            f"loads not met after 50 steps: forces still miss by {np.abs(missing).max():.2e} N/m"
        )

    def _press(self) -> tuple[tuple["ContactSolution", Array], Array]:
        """The state under P alone, with x held, and a first guess of the flexibility."""
        q, y = self.q, self.q.width**2 / self.q.R
        touched = self.at(np.array([0.0, -y]), None)
        y *= q.P / touched.touches[0].normal_force  # secant from the origin
        self.flexibility = np.eye(2) * y / q.P
        # by symmetry pressing alone brings no tangential traction, whatever its steps
        state, cut = self.loaded(0.0, np.array([0.0, -y]), touched)
        slope = self.at(cut * 1.001, state).touches[0].normal_force - q.P
        return (state, cut), np.eye(2) * abs(cut[1]) * 1e-3 / slope
