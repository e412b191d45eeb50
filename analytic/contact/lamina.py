r"""Finite line contact as independent slices (Winkler), each with Palmgren's law.

.. math:: s\, q_k = \max(0,\ \delta - z_k)^{10/9}, \qquad \sum_k q_k = W

z is the gap at the centre of each of n equal slices (from crown, tilt and form errors, without the
parabola across), q is the force of each slice. The slices do not interact. For a roller without
crown, the ends carry the same load as the middle, which is wrong; for a crowned roller, the model
is accurate and fast.

The default compliance s, `palmgren.compliance`, gives Palmgren's approach for a roller without
crown and requires SI units. With another s, any consistent units are valid.

References
----------
.. [1] T. A. Harris, M. N. Kotzalas, Rolling Bearing Analysis, 5th ed., CRC Press 2006, for this
   model; cited from secondary sources.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array
from analytic.contact.sliced import Cases, SlicedContact

CHUNK = 2**15  # gaps at once, which stay in the processor's cache
ITERATIONS = 100
TOLERANCE = 1e-14


def press_laminae(
    gap: ArrayLike,
    *,
    length: ArrayLike,
    R: ArrayLike,
    E_star: ArrayLike,
    load: ArrayLike | None = None,
    approach: ArrayLike | None = None,
    compliance: ArrayLike | None = None,
) -> SlicedContact:
    """Contact of a roller with `gap` [m], (..., n), under `load` [N] or at `approach` [m].

    All other arguments have the shape (...): `length` [m], relative radius R [m], contact modulus
    E_star [Pa] and the `compliance` of a slice [m^(10/9)/N]. The default compliance is Palmgren's
    and requires SI units. If no slice touches at the given approach, all forces are zero. Raises
    ValueError for invalid arguments.

    >>> roller = {"length": 1.0, "R": 1.0, "E_star": 1.0, "compliance": 1.0}
    >>> contact = press_laminae([0.0, 511.0, 600.0], approach=512.0, **roller)  # 2^9 - 511 = 1^9
    >>> contact.force.round(9).tolist(), round(float(contact.load), 9)
    ([1024.0, 1.0, 0.0], 1025.0)
    """
    cases = Cases.of(
        gap, length=length, R=R, E_star=E_star, load=load, approach=approach, compliance=compliance
    )
    if cases.load is None:
        assert cases.approach is not None
        under = np.maximum(cases.approach[:, None] - cases.gap, 0.0)
        return cases.contact(under * _root(under) / cases.compliance[:, None], cases.approach)
    deflection = cases.load * cases.compliance  # of a single slice, to the power 10/9
    force, delta = np.empty_like(cases.gap), np.empty_like(deflection)
    step = max(1, CHUNK // cases.gap.shape[1])
    for first in range(0, len(delta), step):
        part = slice(first, first + step)
        force[part], delta[part] = _carry(cases.gap[part], deflection[part])
    force /= cases.compliance[:, None]
    return cases.contact(force, delta)


press = press_laminae  # its name in version 0.1


def _carry(gap: Array, total: Array) -> tuple[Array, Array]:
    """max(0, delta - z)^(10/9) of each slice, and the delta for which their sum is `total`.

    The function h = (sum ...)^0.9 is convex and increases with delta. Therefore, Newton's steps
    from above never pass the root. If all gaps are equal, h is linear.
    """
    lowest = gap.min(axis=1)
    z, goal = gap - lowest[:, None], total**0.9
    delta = np.minimum(z.mean(axis=1) + goal / gap.shape[1] ** 0.9, goal)  # by Jensen; one slice
    for _ in range(ITERATIONS):
        under = np.maximum(delta[:, None] - z, 0.0)
        root = _root(under)
        carried = np.einsum("ij,ij->i", under, root)
        step = (carried - goal * carried**0.1) / root.sum(axis=1)
        if np.all(np.abs(step) <= TOLERANCE * delta):
            return under * root, lowest + delta
        delta -= step
    raise ArithmeticError(
        f"the approach for the given load did not converge in {ITERATIONS} iterations"
    )


def _root(u: Array) -> Array:
    """u^(1/9), computed several times faster than by a general power."""
    return np.asarray(np.cbrt(np.cbrt(u)))
