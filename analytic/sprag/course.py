r"""Integrals over the load path: wind-up of the races by rolling, elastic energy of a sprag.

.. math::
    \theta_i = \int OC_e\left[\frac{\cos\beta}{OA} - \frac{1}{OB}\right] d\alpha_B
             + \int \frac{\sin\beta}{OA}\,dOC_e, \qquad U = \int N\,dH

from no load to N. theta_i is the angle of the inner race in the driving direction, with the outer
race at rest and both contacts rolling. The second integral is due to the outward motion of the
sprag, which is not exactly along the normal at A. Relative to the first integral, it is of the
order nu beta.

The work of the forces on the motion of a rigid sprag is zero. Therefore,

.. math:: T\,d\theta_i = n_s\,(N\,dH_i + N_e\,dH_e), \qquad N_e = N\,\frac{\cos\omega}{\cos\nu},

exactly. With N in place of N_e, as in U, the relative error is about (nu² - omega²)/4.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array
from analytic.sprag.closure import Wedged, wedged
from analytic.sprag.clutch import SpragClutch

PANELS, POINTS = 32, 4  # of the path, and of Gauss' rule in each
POWER = 5  # N is this power of the path, along which powers like N^0.9 are smooth
AT, WEIGHTS = np.polynomial.legendre.leggauss(POINTS)


def rolled(clutch: SpragClutch, N: ArrayLike) -> Array:
    """Rotation theta_i [rad] of the inner against the outer race, from no load to N [N]."""
    on_way = _way(clutch, N)
    per_turn = on_way.OC_e * (np.cos(on_way.beta) / on_way.OA - 1 / on_way.OB)
    per_way = np.asarray(np.sin(on_way.beta) / on_way.OA)
    return _integral(per_turn, on_way.alpha_b) + _integral(per_way, on_way.OC_e)


def energy(clutch: SpragClutch, N: ArrayLike) -> Array:
    """Elastic energy U [J] of one sprag and of its share of the races, under N [N]."""
    on_way = _way(clutch, N)
    return _integral(on_way.N, on_way.yields.H)


def work(clutch: SpragClutch, N: ArrayLike) -> Array:
    """Work [J] of N on the inner and of N_e on the outer deflections of one sprag."""
    on_way = _way(clutch, N)
    inner = _integral(on_way.N, on_way.yields.inner)
    return np.asarray(inner + _integral(on_way.N_e, on_way.yields.outer))


def _way(clutch: SpragClutch, N: ArrayLike) -> Wedged:
    """States at Gauss points between no load and N, (panels, points, ...)."""
    N = np.asarray(N, dtype=np.float64)
    path = (np.arange(PANELS)[:, None] + (1 + AT) / 2) / PANELS
    dimensions = wedged(clutch, N).T.ndim
    return wedged(clutch, (path**POWER).reshape(PANELS, POINTS, *[1] * dimensions) * N)


def _integral(y: Array, x: Array) -> Array:
    """Integral of y dx along the path, with polynomials through the points of each panel."""
    legendre = np.polynomial.legendre
    slopes = legendre.legval(AT, legendre.legder(np.eye(POINTS))).T
    dx = slopes @ np.linalg.inv(legendre.legvander(AT, POINTS - 1))
    return np.asarray(np.einsum("k,pk...,kj,pj...->...", WEIGHTS, y, dx, x, optimize=True))
