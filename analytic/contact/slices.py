r"""Finite line contact by the slicing technique with interacting slices (Eqs. 2-5).

.. math:: \sum_k S_{jk} q_k = (\delta - z_j)^{10/9}

on loaded slices; on all other slices, q = 0 and the left side is at least max(0, delta - z)^(10/9).
q is the force of each of n equal slices, z the gap at its centre (from crown, tilt and form errors,
without the parabola across). S is the matrix of `slice_compliance`, by default with Love's weights
for Hertz's half-width under the mean line load W/l.

For a roller without crown, the load at the ends increases with the number of slices: the peak
pressure does not converge.

The default compliance, `palmgren.compliance`, requires SI units. With another compliance, any
consistent units are valid.

References
----------
.. [1] C. Huang, Y. Zhao, M. Liu (2018), Eqs. 2-5; Eq. 5 as printed measures y from the end.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact import lamina
from analytic.contact.checks import Array
from analytic.contact.slice_compliance import Kernel, compliance_matrix, love
from analytic.contact.slice_pivoting import carried
from analytic.contact.sliced import Cases, SlicedContact

CHUNK = 2**20  # matrix entries at once
ITERATIONS = 100
TOLERANCE = 1e-13


def press_slices(
    gap: ArrayLike,
    *,
    length: ArrayLike,
    R: ArrayLike,
    E_star: ArrayLike,
    load: ArrayLike | None = None,
    approach: ArrayLike | None = None,
    compliance: ArrayLike | None = None,
    kernel: Kernel | ArrayLike = love,
) -> SlicedContact:
    """Contact of a roller with `gap` [m], (..., n), under `load` [N] or at `approach` [m].

    All other arguments have the shape (...): `length` [m], relative radius R [m], contact modulus
    E_star [Pa] and the `compliance` of a slice [m^(10/9)/N]. The default compliance is Palmgren's
    and requires SI units. `kernel` is a function like `love` or a matrix of weights (n, n). If no
    slice touches at the given approach, all forces are zero. Raises ValueError for invalid
    arguments and ArithmeticError if the iteration fails.

    >>> roller = {"length": 1.0, "R": 1.0, "E_star": 1.0, "compliance": 1.5}
    >>> w = [[2.0, 1.0], [1.0, 2.0]]  # S = w/2; 512^(10/9) = 1024, 1^(10/9) = 1
    >>> press_slices([0.0, 511.0], approach=512.0, kernel=w, **roller).force.round(9).tolist()
    [1024.0, 0.0]
    >>> press_slices([0.0, 0.0], approach=512.0, kernel=w, **roller).force.round(9).tolist()
    [682.666666667, 682.666666667]
    """
    cases = Cases.of(
        gap, length=length, R=R, E_star=E_star, load=load, approach=approach, compliance=compliance
    )
    alone = lamina.press_laminae(
        cases.gap, length=cases.length, R=cases.R, E_star=cases.E_star, load=cases.load,
        approach=cases.approach, compliance=cases.compliance,
    )  # fmt: skip
    force, delta = np.zeros_like(alone.force), alone.approach.copy()
    touch = np.flatnonzero(alone.load > 0)
    step = max(1, CHUNK // cases.gap.shape[1] ** 2)
    for first in range(0, len(touch), step):
        part = touch[first : first + step]
        some = cases.some(part)
        if some.load is None:
            force[part] = _to_approach(some, kernel, alone.load[part])
        else:
            force[part], delta[part] = _to_load(some, kernel, delta[part])
    return cases.contact(force, delta)


press = press_slices  # its name in version 0.1


def _matrix(cases: Cases, kernel: Kernel | ArrayLike, load: Array) -> Array:
    """Matrix S of each case; Hertz's half-width is that under the mean line load."""
    n = cases.gap.shape[1]
    if callable(kernel):
        D = (cases.length / n)[:, None]
        b = np.sqrt(4 / np.pi * load / cases.length * cases.R / cases.E_star)[:, None]
        apart = np.arange(n)
        weights = kernel(apart * D, D, b)[:, np.abs(apart[:, None] - apart)]
    else:
        weights = np.asarray(kernel, dtype=np.float64)
        if weights.shape != (n, n):
            raise ValueError(
                f"weights must be a matrix ({n}, {n}) for the slices, got shape {weights.shape}"
            )
        weights = np.broadcast_to(weights, (len(load), n, n))
    return compliance_matrix(weights, compliance=cases.compliance)


def _to_approach(cases: Cases, kernel: Kernel | ArrayLike, load: Array) -> Array:
    """Forces at the given approach; the load, which has a small effect on S, is iterated."""
    assert cases.approach is not None
    under = np.maximum(cases.approach[:, None] - cases.gap, 0.0)
    wanted, carries = under ** (10 / 9), under > 0
    for _ in range(ITERATIONS):
        force, _ = carried(_matrix(cases, kernel, load), wanted, wanted, carries)
        before, load = load, force.sum(axis=1)
        if np.all(np.abs(load - before) <= TOLERANCE * load):
            return force
    raise ArithmeticError(
        f"the load at the given approach did not converge in {ITERATIONS} iterations"
    )


def _to_load(cases: Cases, kernel: Kernel | ArrayLike, delta: Array) -> tuple[Array, Array]:
    """Forces and approach under the given load: bracketed Newton's method for W^0.9."""
    assert cases.load is not None
    S, goal = _matrix(cases, kernel, cases.load), cases.load**0.9
    lowest = cases.gap.min(axis=1)
    flat = (cases.load * cases.compliance / cases.gap.shape[1]) ** 0.9  # at least about that
    z, at = cases.gap - lowest[:, None], np.maximum(delta - lowest, flat)
    low, high = np.zeros_like(at), np.full_like(at, np.inf)
    force, carries = np.zeros_like(z), at[:, None] > z
    left = np.arange(len(at))
    for _ in range(ITERATIONS):
        under, on = np.maximum(at[left, None] - z[left], 0.0), carries[left]
        root = np.cbrt(np.cbrt(under))
        force[left], growth = carried(S[left], under * root, 10 / 9 * root, on)
        carries[left] = on
        total = force[left].sum(axis=1)
        lacking = goal[left] - total**0.9
        low[left] = np.where(lacking > 0, at[left], low[left])
        high[left] = np.where(lacking < 0, at[left], high[left])
        ahead = lacking * total**0.1 / (0.9 * growth.sum(axis=1))
        settled = np.abs(ahead) <= TOLERANCE * at[left]
        left, ahead = left[~settled], ahead[~settled]
        if not len(left):
            return force, lowest + at
        step = np.minimum(at[left] + ahead, 4 * at[left])
        middle = np.where(np.isinf(high[left]), 2 * at[left], (low[left] + high[left]) / 2)
        at[left] = np.where((step > low[left]) & (step < high[left]), step, middle)
    raise ArithmeticError(
        f"the approach for the given load did not converge in {ITERATIONS} iterations"
    )
