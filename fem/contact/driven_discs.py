"""Two bodies under given forces: the section of the upper body is displaced until they are met."""

import numpy as np

from fem.contact.errors import NotFoundError
from fem.contact.problem import ContactProblem
from fem.contact.solution import ContactSolution
from fem.plane.discretisation import Array

HIT = 1e-12  # relative to P, within which loads are met


class DrivenDiscs:
    """Two bodies with friction whose sections move as rigid lines; a secant method meets the loads.

    `problem` has the boundary "upper.middle" with prescribed motion, and one pair of surfaces. P
    [N/m] acts along -y; `approach` [m] is the approximate displacement of the section by P.
    """

    def __init__(self, problem: ContactProblem, *, P: float, approach: float) -> None:
        self.problem, self.P = problem, P
        self.pressed, self.flexibility = self._press(approach)

    def at(self, cut: Array, after: ContactSolution | None) -> ContactSolution:
        """The state with the upper cut moved by `cut` (x, y) [m]."""
        moved = {"upper.middle": {"x": float(cut[0]), "y": float(cut[1])}}
        return self.problem.solve(displacements=moved, after=after)

    def loaded(self, Q: float, cut: Array, after: ContactSolution) -> tuple[ContactSolution, Array]:
        """The state under Q and P [N/m], one step after `after`, and the position of the section.

        `cut` is the start of the search (Broyden's method). NotFoundError if the loads are not met.
        """
        target, flexibility = np.array([Q, -self.P]), self.flexibility
        state = self.at(cut, after)
        for _ in range(50):
            missing = target - state.touches[0].force
            if np.abs(missing).max() <= HIT * self.P:
                return state, cut
            step = flexibility @ missing
            cut = cut + step
            state = self.at(cut, after)
            gained = missing - (target - state.touches[0].force)
            miss = step - flexibility @ gained
            flexibility = flexibility + np.outer(miss, step @ flexibility) / (
                step @ flexibility @ gained
            )
        raise NotFoundError(
            f"loads not reached in 50 steps: forces differ by {np.abs(missing).max():.2e} N/m"
        )

    def _press(self, y: float) -> tuple[tuple[ContactSolution, Array], Array]:
        """The state under P alone, with x fixed, and an initial estimate of the flexibility."""
        touched = self.at(np.array([0.0, -y]), None)
        y *= self.P / touched.touches[0].normal_force  # secant from the origin
        self.flexibility = np.eye(2) * y / self.P
        # by symmetry pressing alone brings no tangential traction, whatever its steps
        state, cut = self.loaded(0.0, np.array([0.0, -y]), touched)
        slope = self.at(cut * 1.001, state).touches[0].normal_force - self.P
        return (state, cut), np.eye(2) * abs(cut[1]) * 1e-3 / slope
