r"""Sideways buckling of an accordion spring: critical points of its elastica.

The spring is compressed with its head guided. If the head is released sideways, the force of the
guide acts on it as a dead load. The head can then move without a change of load if a part of
`State.J` is singular: the displacements of the tail, relative to the head, no longer depend on the
freedom of the head. Beyond this displacement, only the guide keeps the head in place. The lateral
stiffness of the guided head is the stiffness against the guide.

There is no earlier bifurcation on this path. A head that is free from the beginning drifts
immediately, because its force bends the spring more to one side than to the other; the drift grows
without limit near the same force.

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
    """Zero if a head of this freedom can move under the loads that it has."""
    rows, columns = FREEDOM[head]
    return float(np.linalg.det(state.J[np.ix_(rows, columns)]))


def lateral_stiffness(state: State) -> float:
    """Of a guided head against a movement along y [force/length], in its state."""
    # the tail, seen from the head, then moves by -y
    exerted = np.linalg.solve(state.J[:, [COUPLE, F_X, F_Y]], np.array([0.0, 0.0, -1.0]))
    return float(exerted[2])


def critical(line: Elastica, head: Head, U: Iterable[float]) -> State | None:
    """The first critical point of a `head` that is released, on the guided path through U [length].

    None if there is no critical point up to the last U. Steps as for `Elastica.path`.
    """
    near = [line.unloaded()]
    for u in U:
        here = line.displaced("guided", u, near)
        if len(near) == 2 and determinant(here, head) * determinant(near[-1], head) <= 0:
            return _located(line, head, near[-1], here)
        near = [near[-1], here]
    return None


def _located(line: Elastica, head: Head, before: State, after: State) -> State:
    """Root between two states of different sign: secant method with bracketing (Illinois)."""
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
