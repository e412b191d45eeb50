r"""Lateral buckling of an accordion spring: critical points of its elastica.

The spring is compressed with a guided head. If the lateral guide is removed, the force of the guide
still acts on the head, as a dead load. At a critical point, the head can move without a change of
load: a part of `State.J` is singular. Beyond this displacement, the spring is stable only with the
guide. The lateral stiffness of the guided head is the stiffness against a movement along y.

On this path, there is no bifurcation before the first critical point. A head that is free from the
beginning drifts immediately, because the force along x bends the spring more to one side than to
the other. The drift increases without limit near the force of the critical point.

References
----------
.. [1] S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, 2nd ed., McGraw-Hill 1961, ch. 2.
"""

from collections.abc import Iterable

import numpy as np

from analytic.spring.elastica import COUPLE, F_X, F_Y, TURN, Elastica, Head, State

# under a dead force along x: fixed components of the tail (rotation, x, y), free ones of the head
# change
FREEDOM = {
    "free": ((0,), (TURN,)),
    "hinged": ((0, 2), (TURN, F_Y)),
    "guided": ((0, 2), (COUPLE, F_Y)),
}
SHARP, SECANTS = 1e-10, 30  # of the displacement


def determinant(state: State, head: Head) -> float:
    """Determinant that is zero if a head of the kind `head` can move at constant loads."""
    rows, columns = FREEDOM[head]
    return float(np.linalg.det(state.J[np.ix_(rows, columns)]))


def lateral_stiffness(state: State) -> float:
    """Lateral stiffness [force/length] of a guided head along y in the given state."""
    # the tail, seen from the head, then moves by -y
    exerted = np.linalg.solve(state.J[:, [COUPLE, F_X, F_Y]], np.array([0.0, 0.0, -1.0]))
    return float(exerted[2])


def critical(line: Elastica, head: Head, U: Iterable[float]) -> State | None:
    """First critical point of a head of the kind `head` on the path of the guided head.

    The path leads through the displacements `U` [length]; their steps should be at most a twentieth
    of the length of the spring, as in `Elastica.path`. None if there is no critical point up to the
    last U.
    """
    near = [line.unloaded()]
    for u in U:
        here = line.displaced("guided", u, near)
        if len(near) == 2 and determinant(here, head) * determinant(near[-1], head) <= 0:
            return _located(line, head, near[-1], here)
        near = [near[-1], here]
    return None


def _located(line: Elastica, head: Head, before: State, after: State) -> State:
    """State between two others at which the determinant is zero, by a bracketing secant method."""
    a, b = (determinant(state, head) for state in (before, after))
    for _ in range(SECANTS):
        u = (before.U * b - after.U * a) / (b - a)
        here = line.displaced("guided", u, [before, after])
        c = determinant(here, head)
        if abs(after.U - before.U) < SHARP * after.U or abs(c) <= SHARP * max(abs(a), abs(b)):
            break
        if c * b < 0:
            before, a = after, b
        else:
            a /= 2
        after, b = here, c
    return here
