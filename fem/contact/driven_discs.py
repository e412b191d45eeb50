"""Two bodies in contact; the section of the upper body is displaced so that given forces act."""

import numpy as np

from fem.contact.errors import NotFoundError
from fem.contact.problem import ContactProblem
from fem.contact.solution import ContactSolution
from fem.plane.discretisation import Array

HIT = 1e-12  # relative to P, within which loads are met


class DrivenDiscs:
    """Two bodies in contact with friction; the upper section is displaced so that given forces act.

    The section is displaced without deformation. A secant method finds the displacement. `problem`
    has the boundary "upper.middle" with prescribed motion, and one pair of surfaces. P [N/m] acts
    along -y; `approach` [m] is the approximate displacement of the section by P.
    """

    def __init__(self, problem: ContactProblem, *, P: float, approach: float) -> None:
        self.problem, self.P = problem, P
        self.pressed, self.flexibility = self._press(approach)

    def at(self, cut: Array, after: ContactSolution | None) -> ContactSolution:
        """Contact state for the displacement `cut` (x, y) [m] of the upper section."""
        moved = {"upper.middle": {"x": float(cut[0]), "y": float(cut[1])}}
        return self.problem.solve(displacements=moved, after=after)

    def loaded(self, Q: float, cut: Array, after: ContactSolution) -> tuple[ContactSolution, Array]:
        """Contact state under Q and P [N/m], and the displacement of the upper section.

        The step begins at the state `after`. `cut` is the initial displacement of the search
        (Broyden's method). Raises NotFoundError if the search does not reach the loads.
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
            "the loads were not reached in 50 steps: the contact forces still differ from the "
            f"loads by up to {np.abs(missing).max():.2e} N/m"
        )

    def _press(self, y: float) -> tuple[tuple[ContactSolution, Array], Array]:
        """Contact state under P alone and displacement of the section; estimated flexibility."""
        touched = self.at(np.array([0.0, -y]), None)
        y *= self.P / touched.touches[0].normal_force  # secant from the origin
        self.flexibility = np.eye(2) * y / self.P
        # by symmetry pressing alone brings no tangential traction, whatever its steps
        state, cut = self.loaded(0.0, np.array([0.0, -y]), touched)
        slope = self.at(cut * 1.001, state).touches[0].normal_force - self.P
        return (state, cut), np.eye(2) * abs(cut[1]) * 1e-3 / slope
