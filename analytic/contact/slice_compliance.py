r"""Mutual deflections of the slices of a line contact: weights w and the matrix S (Eq. 3).

.. math:: S_{jk} = \frac{n s\, w_{jk}}{\sum_{jk} w_{jk}}

The sum of all elements of S is n s for every w. The weights w only redistribute the load over the
slices; the compliance s of one slice determines the law of the whole contact.

The paper does not define w, and the reference that it cites was not available. `love` is the
displacement of a half-space under a uniform load on the rectangle D x 2b,

.. math::
    w(d) = G(d + D/2) - G(d - D/2), \qquad
    G(v) = v\,\mathrm{asinh}\frac bv + b\,\mathrm{asinh}\frac vb,

d being the distance along the centre line, D the length of a slice, b the half-width.

Other kernels of the same width (Hertz's ellipse across, the mean over the displaced slice) change
the peak pressure of the paper's crowned roller by 0.2 % or less with at least 41 slices, as long as
the peak is not in the end slices. Twice or half the width 2b changes the peak pressure by up to
1.3 % with 41 slices, and by 6 % with 101 slices if the peak moves to the ends. Therefore, the width
cannot be chosen freely.

References
----------
.. [1] C. Huang, Y. Zhao, M. Liu (2018), Eqs. 2 and 3.
.. [2] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 3.3 (Love).
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, positive

Kernel = Callable[[Array, Array, Array], Array]  # distance, length of a slice, half-width


def love(distance: ArrayLike, width: ArrayLike, half_width: ArrayLike) -> Array:
    """Love's weight w [length] at `distance` from the centre of a rectangle of `width` by 2b.

    >>> corner = np.log(1 + np.sqrt(2))  # a square of side 2: w(0) = 2 G(1) = 4 asinh 1
    >>> round(float(love(0.0, 2.0, 1.0) / corner), 12)
    4.0
    """
    d, D = finite(distance, "distance", "m"), positive(width, "length of a slice", "m")
    b = positive(half_width, "half-width", "m")

    def primitive(v: Array) -> Array:
        far = np.maximum(np.abs(v), 1e-300)  # v asinh(b/v) is 0 at 0, and even except for its sign
        return np.asarray(v * np.arcsinh(b / far) + b * np.arcsinh(v / b))

    return primitive(d + D / 2) - primitive(d - D / 2)


def compliance_matrix(weights: ArrayLike, *, compliance: ArrayLike) -> Array:
    """Matrix S (..., n, n) from symmetric `weights` (..., n, n) and the `compliance` s of a slice.

    Raises ValueError unless the weights are positive definite; otherwise, S has no unique solution.

    >>> compliance_matrix([[2.0, 1.0], [1.0, 2.0]], compliance=6.0).tolist()  # the sum is 2 times 6
    [[4.0, 2.0], [2.0, 4.0]]
    """
    w = finite(weights, "weights", "")
    if w.ndim < 2 or w.shape[-1] != w.shape[-2]:
        raise ValueError(f"weights must be a matrix (n, n), got shape {w.shape}")
    if not np.allclose(w, np.swapaxes(w, -1, -2), rtol=1e-10, atol=0):
        raise ValueError("weights must be symmetric, w_jk = w_kj (reciprocal theorem)")
    total = w.sum(axis=(-2, -1))
    try:
        np.linalg.cholesky(w)
    except np.linalg.LinAlgError:
        raise ValueError(
            "weights must be positive definite: the work of a load must be positive"
        ) from None
    scale = w.shape[-1] * positive(compliance, "compliance of a slice", "m^(10/9)/N") / total
    return np.asarray(w * scale[..., None, None])
