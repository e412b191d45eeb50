r"""Constants k in the approach of a part, which are added to the logarithmic term.

Under z line loads P on equally spaced Hertz patches of half-width a on a wall of radius r, the
deflection of the wall at each load, in the direction of the load, is

.. math:: \delta = \frac{P}{\pi E'}\left[2\ln\frac{r}{a} + k + c\,\frac{a}{r}\right] + O(a^2),
          \qquad c = \mp\frac{2}{3}(1 - \nu')

(upper sign for a bore). The load is a series of waves m = z, 2z, ... with the factor 2 J_1(m
a/r)/(m a/r). The terms of order 1/m of the deflection give the logarithm. The next terms, -/+(1 -
nu')/(2 m²), give c, because the mean distance from the middle of the patch, weighted by the
semi-elliptic pressure, is 4 a/(3 pi). The remainder does not contain a. k is computed by
`LoadedRace` for one narrow patch. The stresses in a ring under given loads do not depend on nu'.
Therefore, k is linear in nu'. For a star with a clamped bore, k is computed from the four powers of
r in `clamped_race`.
"""

from collections.abc import Callable
from functools import cache, partial

import numpy as np
from numpy.polynomial.chebyshev import Chebyshev
from numpy.typing import ArrayLike

from analytic.contact.checks import Array
from analytic.ring.fourier_ring import Wall
from analytic.ring.loaded_race import LoadedRace

PATCH = 2e-3  # a/r of the patch from which k is read; its square is neglected
NODES = 32  # of the interpolation over many ratios, at most
TERMS = 400  # waves of a star; the remainder falls with 1/m² and is added
SOLID = 1e6  # ratio of a shaft without bore


def race_constant(*, ratio: ArrayLike, n: ArrayLike, nu: ArrayLike, loaded: Wall) -> Array:
    """Constants k of a ring with r_o/r_i = `ratio` under n loads on one wall.

    `nu` is Poisson's ratio of Hooke's law in the plane.

    >>> k = race_constant(ratio=[1.2, 2.0], n=8, nu=0.4, loaded="bore")
    >>> bool(k[0] > k[1])  # a thin ring deflects more
    True
    """
    ratio = np.minimum(np.asarray(ratio, dtype=np.float64), SOLID)
    at_0, at_1 = (_over_ratios(partial(_race, nu=nu, loaded=loaded), ratio, n) for nu in (0.0, 0.4))
    return np.asarray(at_0 + np.asarray(nu) / 0.4 * (at_1 - at_0))


def star_constant(*, ratio: ArrayLike, n: ArrayLike, nu: ArrayLike) -> Array:
    """Constants k of a disc under n loads on its rim, clamped on a bore r_i = r_o/`ratio`."""
    ratio, nu = np.broadcast_arrays(np.asarray(ratio, dtype=np.float64), np.asarray(nu))
    found = np.empty(np.broadcast_shapes(ratio.shape, np.shape(n)))
    for value in np.unique(nu):
        every = _over_ratios(partial(_star, nu=float(value)), ratio, n)
        found = np.where(nu == value, every, found)
    return found


def _over_ratios(function: Callable[..., float], ratio: Array, n: ArrayLike) -> Array:
    """Values of `function` at ratio and n; many values are interpolated over ln(ratio - 1)."""
    ratio, n = np.broadcast_arrays(ratio, np.asarray(n))
    found = np.empty(ratio.shape)
    for count in np.unique(n):
        here = n == count
        place = np.log(ratio[here] - 1)
        places, back = np.unique(place, return_inverse=True)

        def at(x: Array, count: int = int(count)) -> Array:
            return np.array([function(float(1 + np.exp(v)), n=count) for v in x])

        width = places[-1] - places[0]
        nodes = min(NODES, 8 + int(8 * width))  # 1e-9 of k, see the test
        if places.size > nodes:
            domain = [places[0], places[-1]]
            found[here] = Chebyshev.interpolate(at, nodes - 1, domain=domain)(place)
        else:
            found[here] = at(places)[back]
    return found


@cache
def _race(ratio: float, *, n: int, nu: float, loaded: Wall) -> float:
    r_i, r_o = (1.0, ratio) if loaded == "bore" else (1 / ratio, 1.0)
    race = LoadedRace(
        r_i=r_i, r_o=r_o, E=1.0, nu=nu, assumption="plane stress",
        loaded=loaded, n=n, P=np.pi, a=PATCH,
    )  # fmt: skip
    towards = 1.0 if loaded == "bore" else -1.0
    bracket = towards * race.displacement(1.0, 0.0)
    return float(bracket + 2 * np.log(PATCH) - PATCH * curvature_term(nu=nu, loaded=loaded))


def curvature_term(*, nu: ArrayLike, loaded: Wall) -> Array:
    """Constants c of the term a/r."""
    return np.asarray((-1 if loaded == "bore" else 1) * 2 / 3 * (1 - np.asarray(nu)))


@cache
def _star(ratio: float, *, n: int, nu: float) -> float:
    s = 1 / ratio
    m = n * np.arange(1.0, TERMS + 1)
    uniform = (1 - nu**2) * (1 - s**2) / ((1 + s**2) + nu * (1 - s**2))  # Lamé, fixed at the bore
    delta = _clamped_waves(m, s, nu) - 2 / m
    tail = delta[-1] * TERMS  # sum of c/k² beyond TERMS is c/TERMS
    return float(2 * np.log(2 / n) + 1 + n * (uniform / 2 + delta.sum() + tail))


def _clamped_waves(m: Array, s: float, nu: float) -> Array:
    """Dimensionless displacements E' U/(p r_o) under pressures cos(m theta), m >= 2, on the rim.

    The rim has the radius 1; the bore of radius s is clamped. The solution consists of the powers
    of `clamped_race`; powers that decrease outwards are scaled to 1 at the bore.
    """
    k, one = (3 - nu) / (1 + nu), np.ones(m.size)
    U = np.array([one, one, k - m - 1, k + m - 1])
    V = np.array([-one, one, k + m + 1, m - 1 - k])
    e = np.array([m - 1, -m - 1, m + 1, 1 - m])
    at_rim = np.where(e > 0, 1.0, s ** np.maximum(-e, 0.0))
    at_bore = np.where(e > 0, s ** np.maximum(e, 0.0), 1.0)
    pressed = at_rim * (e * U + nu * (U + m * V))
    sheared = at_rim * (e * V - V - m * U)
    A = np.array([pressed, sheared, at_bore * U, at_bore * V]).transpose(2, 0, 1)
    b = np.tile([1 - nu**2, 0.0, 0.0, 0.0], (m.size, 1))
    c = np.linalg.solve(A, b[..., None])[..., 0]
    return np.asarray((c * (at_rim * U).T).sum(axis=1))
