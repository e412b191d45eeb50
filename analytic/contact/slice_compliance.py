r"""Mutual deflections of the slices of a line contact: weights w and the matrix S (Eq. 3).

.. math:: S_{jk} = \frac{n s\, w_{jk}}{\sum_{jk} w_{jk}}

The sum of S is n s whatever w is: w only redistributes the load over the slices, s, the compliance
of one slice, alone sets the law of the whole.

The paper does not define w, and the work cited for it was not available. `love` is the displacement
of a half-space under a uniform load on the rectangle D x 2b,

.. math::
    w(d) = G(d + D/2) - G(d - D/2), \qquad
    G(v) = v\,\mathrm{asinh}\frac bv + b\,\mathrm{asinh}\frac vb,

d being the distance along the centre line, D the length of a slice, b the half-width.

Other kernels of the same width (Hertz's ellipse across, the mean over the slice that sinks) change
the peak of the paper's crowned roller by 0.2 % or less from 41 slices on, as long as it is not in
the end slices. Twice or half the width moves it by up to 1.3 % with 41 slices and, where it takes
the peak to the ends, by 6 % with 101: the width is no free choice.

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
    """Love's w [length] at `distance` from the middle of a rectangle `width` along, 2b across.

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
    """S of symmetric `weights` (..., n, n) and the slices' compliance s, (...).

    ValueError unless the weights are positive definite; otherwise, S has no unique solution.

    >>> compliance_matrix([[2.0, 1.0], [1.0, 2.0]], compliance=6.0).tolist()  # the sum is 2 times 6
    [[4.0, 2.0], [2.0, 4.0]]
    """
    w = finite(weights, "weights", "")
    if w.ndim < 2 or w.shape[-1] != w.shape[-2]:
        raise ValueError(f"weights must be a matrix (n, n), got shape {w.shape}")
    if not np.allclose(w, np.swapaxes(w, -1, -2), rtol=1e-10, atol=0):
        raise ValueError("weights must be symmetric, w_jk = w_kj (reciprocity of work)")
    total = w.sum(axis=(-2, -1))
    try:
        np.linalg.cholesky(w)
    except np.linalg.LinAlgError:
        raise ValueError("weights must be positive definite: a load may not lift itself") from None
    scale = w.shape[-1] * positive(compliance, "compliance of a slice", "m^(10/9)/N") / total
    return np.asarray(w * scale[..., None, None])
