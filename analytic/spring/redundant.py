"""Response of an accordion spring with supports and closed pairs of tip and leaf.

Force method: five forces X = (F_x, F_y, M_0, C_h, C_t), three at the head and the contact force of
each pair, do work on the displacements d with E I d = A X. At a support or a closed pair, d is
zero.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from analytic.spring.loops import Array, Line, Pair
from analytic.spring.wire import Wire

Theory = Literal["bending", "thin", "shear"]

END_COUPLES = np.array(
    [[0.0, 0, 1], [0, -1, 0], [1, 0, 0]]
)  # couples of F_x, F_y, M_0 at (1, x, y)
END_FORCES = np.array([[1.0, 0], [0, 1], [0, 0]])
PAIRS = 3  # first row of the pairs


@dataclass(frozen=True)
class Response:
    """Response of a spring with E I = 1: stiffness k, forces X, closing rates of both pairs.

    Forces and rates are per force F.
    """

    k: Array
    X: Array
    rates: Array


def response(A: Array, held: list[int], touching: tuple[int, ...]) -> Response:
    """Response to the force with support reactions and contact forces of closed pairs.

    `held` are the indices of the support reactions in X. `touching` are the numbers of the closed
    pairs: 0 at the head, 1 at the tail.
    """
    active = [0, *held, *(PAIRS + i for i in touching)]
    unit = np.zeros((*A.shape[:-2], len(active), 1))
    unit[..., 0, 0] = 1.0
    solved = np.linalg.solve(A[..., active, :][..., :, active], unit)[..., 0]
    X = np.zeros(A.shape[:-1])
    X[..., active] = solved / solved[..., :1]
    rates = -(A[..., PAIRS:, :] @ X[..., None])[..., 0]
    return Response(np.asarray(solved[..., 0], float), X, rates)


def compliances(shape: Line, b: Array, nu: Array, theory: Theory) -> Array:
    """Compliance matrix A (..., 5, 5) for F_x, F_y, M_0 and both pairs, with E I = 1."""
    axial = b**2 / 12 * (theory != "bending")
    shear = b**2 / 12 * (12 / 5) * (1 + nu) * (theory == "shear")

    def energy(w: Array, f: Array, wire: Wire, v: Array, g: Array) -> Array:
        D = (axial - shear)[..., None, None] * wire.D
        D = D + (shear * wire.length)[..., None, None] * np.eye(2)
        return np.asarray(w @ wire.G @ np.swapaxes(v, -1, -2) + f @ D @ np.swapaxes(g, -1, -2))

    A = np.zeros((*shape.whole.length.shape, 5, 5))
    A[..., :PAIRS, :PAIRS] = energy(END_COUPLES, END_FORCES, shape.whole, END_COUPLES, END_FORCES)
    for i, pair in ((PAIRS, shape.head), (PAIRS + 1, shape.tail)):
        w, f = pair.moment[..., None, :], pair.force[..., None, :]
        A[..., :PAIRS, i] = energy(END_COUPLES, END_FORCES, pair.loop, w, f)[..., 0]
        A[..., i, :PAIRS] = A[..., :PAIRS, i]
        A[..., i, i] = energy(w, f, pair.with_tip, w, f)[..., 0, 0]
    return A


def turn(pair: Pair, couple: Array) -> Array:
    """Relative rotation of tip and leaf towards each other per force F, with E I = 1."""
    sums = pair.loop.G[..., 0, :]
    side = -np.sign((sums * pair.moment).sum(axis=-1))
    return np.asarray(side * (sums * couple).sum(axis=-1))
