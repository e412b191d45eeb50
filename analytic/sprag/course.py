r"""Along the load path: turn of the races by rolling, elastic energy of a sprag.

.. math::
    \theta_i = \int \left[\frac{OB - OC_e}{OB} + \frac{OC_e\cos\beta - OA}{OA}\right] d\alpha_B,
    \qquad U = \int N\,dH

from no load to N; theta_i is the inner race's turn in its driving direction, outer race at rest.
The forces' work on a rigid sprag that rolls is zero, so that, without approximation but that of
the yields under N and not N_e on the outer side,

.. math:: T\,d\theta_i = n_s\,(N\,dH_i + N_e\,dH_e), \qquad N_e = N\,\frac{\cos\omega}{\cos\nu}.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array
from analytic.sprag.closure import Wedged, wedged
from analytic.sprag.clutch import Clutch

POINTS = 24  # of Gauss' rule
POWER = 5  # N goes as this power of the path, along which powers like N^0.9 are smooth


def rolled(clutch: Clutch, N: ArrayLike) -> Array:
    """Turn theta_i [rad] of the inner race against the outer from no load to N [N]."""
    on_way = _way(clutch, N)
    return _integral(on_way.rolling, on_way.alpha_b)


def energy(clutch: Clutch, N: ArrayLike) -> Array:
    """Elastic energy U [J] that one sprag and its share of the races hold under N [N]."""
    on_way = _way(clutch, N)
    return _integral(on_way.N, on_way.yields.H)


def _way(clutch: Clutch, N: ArrayLike) -> Wedged:
    """States at Gauss' points between no load and N, in the first dimension."""
    N = np.asarray(N, dtype=np.float64)
    x, _ = np.polynomial.legendre.leggauss(POINTS)
    dimensions = wedged(clutch, N).T.ndim
    share = (((1 + x) / 2) ** POWER).reshape(-1, *[1] * dimensions)
    return wedged(clutch, share * N)


def _integral(y: Array, x: Array) -> Array:
    """Integral of y dx over the first dimension, dx from the polynomial through all points."""
    at, weights = np.polynomial.legendre.leggauss(POINTS)
    values = np.polynomial.legendre.legvander(at, POINTS - 1)
    slopes = np.polynomial.legendre.legval(at, np.polynomial.legendre.legder(np.eye(POINTS))).T
    coefficients = (values * weights[:, None]).T * (np.arange(POINTS) + 0.5)[:, None]
    dx = np.tensordot(slopes @ coefficients, x, axes=1)
    return np.asarray(np.tensordot(weights, y * dx, axes=1))
