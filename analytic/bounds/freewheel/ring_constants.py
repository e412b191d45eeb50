r"""Constants k of the deflection of rings and clamped discs under line loads (transfer matrices).

For a wave cos(m theta) of the displacements u, v and of S = r sigma_r, Q = r tau (divided by E'),
Hooke's law and the two equations of equilibrium are, with t = ln r,

.. math::
    u' &= -\nu u - \nu m v + (1 - \nu^2) S, & S' &= u + m v + \nu S - m Q, \\
    v' &= m u + v + 2 (1 + \nu) Q, & Q' &= m (u + m v + \nu S) - Q.

Their coefficients are constant. Therefore, the matrix exponential gives the transfer from the
clamped or free wall to the loaded wall. There, a pressure p causes :math:`u = C_m p r/E'`. For a
body without another wall, C_m is

.. math:: C_m^\infty = \frac{b}{m - 1} + \frac{2 - b}{m + 1}, \qquad
          b = \frac{1 + \nu}{2} \text{ of a disc}, \quad \frac{3 - \nu}{2} \text{ around a hole}.

Under n loads P, the deflection of the wall is P/(pi E') (2 ln(r/a) + k + ...). With m = n, 2n, ...,

.. math:: k = 2\ln\frac{2}{n} + 1 + \frac{n C_0}{2} + n\sum_m (C_m - C_m^\infty)
          - b\,h(-\tfrac 1n) - (2 - b)\,h(\tfrac 1n), \qquad h(x) = \psi(1 + x) - \psi(1),

where psi is the digamma function. The constants are independent of the formulas in
`analytic.freewheel`.

References
----------
.. [1] S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed., McGraw-Hill 1970, art. 27.
"""

import math
from collections.abc import Callable
from functools import cache

import numpy as np
from scipy.linalg import expm
from scipy.special import digamma

from analytic.contact.checks import Array

COUPLED = 16.0  # m ln(ratio) above which no wave reaches the other wall, exp(-2 m ln(ratio))


@cache
def clamped_disc(*, ratio: float, n: int, nu: float) -> float:
    """Constant k of a disc under n loads on its rim r_o; the bore r_o/`ratio` is clamped.

    >>> shallow, deep = (clamped_disc(ratio=s, n=8, nu=0.4) for s in (1.2, 3.0))
    >>> shallow < deep  # less material deflects less
    True
    """
    far = math.log(ratio)

    def answer(m: int) -> float:
        moved, pressed = _transfer(m, far, nu)[:, 2:].reshape(2, 2, 2)
        return _answer(m, moved, pressed)

    return _constant(n, far, (1 + nu) / 2, answer)


@cache
def free_ring(*, ratio: float, n: int, nu: float) -> float:
    """Constant k of a ring with r_o/r_i = `ratio` under n loads on its bore, with a free rim.

    >>> thin, thick = (free_ring(ratio=s, n=8, nu=0.4) for s in (1.2, 3.0))
    >>> thin > thick
    True
    """
    far = math.log(ratio)

    def answer(m: int) -> float:
        moved, pressed = _transfer(m, -far, nu)[:, :2].reshape(2, 2, 2)
        return -_answer(m, moved, pressed)

    return _constant(n, far, (3 - nu) / 2, answer)


def _constant(n: int, far: float, b: float, answer: Callable[[int], float]) -> float:
    """Constant k from `answer`, which returns C_m; `far` is ln(r_o/r_i)."""
    coupled = sum(
        answer(m) - b / (m - 1) - (2 - b) / (m + 1)
        for m in range(n, math.floor(COUPLED / far) + 1, n)
    )
    below, above = digamma(1 - 1 / n) - digamma(1), digamma(1 + 1 / n) - digamma(1)
    closed = 2 * math.log(2 / n) + 1 - b * below - (2 - b) * above
    return float(closed + n * (answer(0) / 2 + coupled))


def _transfer(m: int, t: float, nu: float) -> Array:
    """Transfer matrix of u, v, S/s, Q/s over the distance t in ln r, with s = m, or 1 if m = 0."""
    s = max(m, 1)
    rates = np.array([
        [-nu, -nu * m, (1 - nu**2) * s, 0],
        [m, 1, 0, 2 * (1 + nu) * s],
        [1 / s, m / s, nu, -m],
        [m / s, m * m / s, m * nu, -1],
    ])  # fmt: skip
    return np.asarray(expm(rates * t))


def _answer(m: int, moved: Array, pressed: Array) -> float:
    """Displacement u under S = 1, Q = 0, from the displacements and tractions of two solutions."""
    if m == 0:  # the second solution is a twist, with neither u nor S
        return float(moved[0, 0] / pressed[0, 0])
    return float(moved[0] @ np.linalg.solve(pressed, [1 / m, 0.0]))
