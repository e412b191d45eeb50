r"""Second moments of a bent line, leaf by leaf and arc by arc, in closed form.

If the bending couple of a plane strip is an affine function of the position of the section,
:math:`M = w \cdot v` with :math:`v = (1, x, y)`, its strain energy is
:math:`\tfrac12 w^T G w/(E I)`. Therefore, the compliances of a spring are the second moments

.. math:: G = \int v\,v^T ds, \qquad D = \int t\,t^T ds

of its centre line with the tangent t; D is needed for the axial and shear energy. For a leaf from
v_0 to v_1 of length L, and for an arc of radius R about (x_c, y_c) from the polar angle psi_0 to
psi_1,

.. math::
    G = \frac{L}{6}(2 v_0 v_0^T + v_0 v_1^T + v_1 v_0^T + 2 v_1 v_1^T), \qquad
    G = B \Big[R \int q\,q^T |d\psi|\Big] B^T, \quad v = B q, \quad q = (1, \cos\psi, \sin\psi)

All functions broadcast: lengths and angles have a common shape, which is the leading shape of G.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Wire:
    """Second moments `G` (..., 3, 3) of (1, x, y) and `D` (..., 2, 2) of the tangent.

    The moments of a line are the sums over its parts. `length` is G_00.
    """

    G: Array
    D: Array

    def __add__(self, other: "Wire") -> "Wire":
        return Wire(self.G + other.G, self.D + other.D)

    def __sub__(self, other: "Wire") -> "Wire":
        return Wire(self.G - other.G, self.D - other.D)

    @property
    def length(self) -> Array:
        return np.asarray(self.G[..., 0, 0])


def leaf(start: Array, heading: ArrayLike, length: ArrayLike) -> tuple[Wire, Array]:
    """Second moments of a straight piece from `start` (..., 2), and its end point.

    >>> wire, end = leaf(np.zeros(2), np.pi / 2, 3.0)  # along y: L^3/3 about its end
    >>> round(float(wire.G[2, 2]), 12), end.round(12).tolist()
    (9.0, [0.0, 3.0])
    """
    heading, length = np.asarray(heading, float), np.asarray(length, float)
    t = np.stack([np.cos(heading), np.sin(heading)], axis=-1)
    end = start + length[..., None] * t
    v, w = _with_one(start), _with_one(end)
    G = 2 * _dyad(v, v) + _dyad(v, w) + _dyad(w, v) + 2 * _dyad(w, w)
    size = length[..., None, None]
    return Wire(np.asarray(size / 6 * G), np.asarray(size * _dyad(t, t))), np.asarray(end)


def arc(start: Array, heading: ArrayLike, radius: ArrayLike, turn: ArrayLike) -> tuple[Wire, Array]:
    """Second moments of an arc from `start` (..., 2) with angle `turn` [rad], and its end point.

    >>> wire, end = arc(np.zeros(2), np.pi / 2, 2.0, -np.pi / 2)  # a quarter circle
    >>> end.round(12).tolist(), round(float(wire.G[2, 2]), 12) == round(2 * np.pi, 12)
    ([2.0, 2.0], True)
    """
    heading, radius, turn = (np.asarray(v, float) for v in (heading, radius, turn))
    side = np.sign(turn)
    first = heading - side * np.pi / 2  # the polar angle at the start
    last = first + turn
    centre = start - radius[..., None] * _unit(first)
    end = centre + radius[..., None] * _unit(last)
    one: Array = abs(turn)
    c = side * (np.sin(last) - np.sin(first))
    s = side * (np.cos(first) - np.cos(last))
    cc = one / 2 + side * (np.sin(2 * last) - np.sin(2 * first)) / 4
    cs = side * (np.sin(last) ** 2 - np.sin(first) ** 2) / 2
    Q = radius[..., None, None] * _matrix([[one, c, s], [c, cc, cs], [s, cs, one - cc]])
    zero, x, y = np.zeros_like(one), centre[..., 0], centre[..., 1]
    B = _matrix([[zero + 1, zero, zero], [x, radius, zero], [y, zero, radius]])
    G = B @ Q @ np.swapaxes(B, -1, -2)
    return Wire(G, radius[..., None, None] * _matrix([[one - cc, -cs], [-cs, cc]])), end


def _unit(angle: Array) -> Array:
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def _with_one(place: Array) -> Array:
    return np.concatenate([np.ones_like(place[..., :1]), place], axis=-1)


def _dyad(a: Array, b: Array) -> Array:
    return a[..., :, None] * b[..., None, :]


def _matrix(rows: list[list[Array]]) -> Array:
    """Matrix (..., k, k) whose entries are arrays of one shape (...)."""
    flat = np.broadcast_arrays(*(entry for row in rows for entry in row))
    k = len(rows)
    return np.stack(flat, axis=-1).reshape(*flat[0].shape, k, k)
