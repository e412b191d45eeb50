r"""Finite line contact as independent slices (Winkler), each with Palmgren's law.

.. math:: s\, q_k = \max(0,\ \delta - z_k)^{10/9}, \qquad \sum_k q_k = W

z is the gap at the centre of each of n equal slices (crown, tilt and others, without the
parabola across), q the slices' forces. Slices do not interact: the ends of a flat roller carry the
same load as its middle, which is wrong; for a crowned roller the model is good and fast.

SI with the default compliance s, `palmgren.compliance`, under which a flat roller has Palmgren's
approach; any consistent units with another s.

References
----------
.. [1] T. A. Harris, M. N. Kotzalas, Rolling Bearing Analysis, 5th ed., CRC Press 2006, for this
   model; second-hand.
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
    """A roller with `gap` [m], (..., n), pressed by `load` [N] or to `approach` [m], each (...).

    `length` [m], relative radius R [m], contact modulus [Pa] and the slices' `compliance`
    [m^(10/9)/N] are (...), too; the default, Palmgren's, requires SI units. An approach that
    reaches nothing gives no force. ValueError for what makes no sense.

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
    """max(0, delta - z)^(10/9) of each slice and the delta at which they sum up to `total`.

    The norm h = (sum ...)^0.9 is convex and grows with delta, so Newton's steps from above never
    pass the root; it is linear where all gaps are equal.
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
    raise ArithmeticError(f"the iteration for the approach did not converge in {ITERATIONS} steps")


def _root(u: Array) -> Array:
    """u^(1/9), several times as fast as a power where u may be zero."""
    return np.asarray(np.cbrt(np.cbrt(u)))
