r"""Exact transfer matrix and dynamic stiffness of a rotating Timoshenko shaft.

For r, phi ~ e^{i omega t} on a shaft that rotates at Omega, with phi = theta_y - i theta_x,

.. math::
    r' = \varphi + \frac{Q}{\kappa G A},\quad \varphi' = \frac{M}{EI},\quad
    Q' = -\rho A\omega^2 r,\quad
    M' = -Q - \rho I(\omega^2 - 2\Omega\omega)\varphi,

where the polar moment of a circular section is 2 I. A piece of length l has the dimensionless
numbers

.. math::
    s = \frac{EI}{\kappa G A l^2},\quad b = \frac{\rho A\omega^2 l^4}{EI},\quad
    t = \frac{\rho l^2(\omega^2 - 2\Omega\omega)}{E};

s = 0 without shear (Rayleigh), and t = 0 without rotary inertia (Euler).
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
TERMS = 20  # of the entire functions: on pieces as short as `pieces` makes them beyond round-off


def transfer(*, s: ArrayLike, b: ArrayLike, t: ArrayLike, at: ArrayLike = 1.0) -> Array:
    """Transfer matrix (..., 4, 4) of (r/l, phi, Q l²/EI, M l/EI) over the fraction `at` of l.

    With p = (r, M) and o = (phi, Q), the state satisfies p' = B o, o' = C p, so that p'' = BC p and
    o'' = CB o. By the Cayley-Hamilton theorem, cosh and sinh of a root of BC both have the
    form x + y BC.

    >>> float(transfer(s=0.0, b=0.0, t=0.0)[0, 3])  # r = M l²/2EI, a cantilever under a moment
    0.5
    """
    s, b, t, z = np.broadcast_arrays(*(np.asarray(v, dtype=np.float64) for v in (s, b, t, at)))
    c0, c1, h0, h1 = _entire(trace=-(s * b + t) * z**2, det=b * (s * t - 1) * z**4)
    c1, h0, h1 = c1 * z**2, h0 * z, h1 * z**3
    T = np.empty((*s.shape, 4, 4))
    T[..., 0, 0], T[..., 0, 3] = c0 - c1 * s * b, c1
    T[..., 3, 0], T[..., 3, 3] = c1 * b, c0 - c1 * t
    T[..., 1, 1], T[..., 1, 2] = c0 - c1 * t, -c1
    T[..., 2, 1], T[..., 2, 2] = -c1 * b, c0 - c1 * s * b
    T[..., 0, 1], T[..., 0, 2] = h0 - h1 * (s * b + t), h0 * s - h1 * (s**2 * b + 1)
    T[..., 3, 1], T[..., 3, 2] = -h0 * t + h1 * (b + t**2), -h0 + h1 * (s * b + t)
    T[..., 1, 0], T[..., 1, 3] = h1 * b, h0 - h1 * t
    T[..., 2, 0], T[..., 2, 3] = -h0 * b + h1 * s * b**2, -h1 * b
    return T


def _entire(*, trace: Array, det: Array) -> tuple[Array, Array, Array, Array]:
    """Coefficients of cosh(X^1/2) = c0 + c1 X and sinh(X^1/2) X^-1/2 = h0 + h1 X."""
    x, y = np.ones_like(trace), np.zeros_like(trace)  # X^k = x + y X
    c0, c1, h0, h1 = x.copy(), y.copy(), x.copy(), y.copy()
    factorial = 1.0
    for k in range(1, TERMS):
        x, y = -det * y, x + trace * y
        factorial *= 2 * k * (2 * k - 1)
        c0, c1 = c0 + x / factorial, c1 + y / factorial
        h0, h1 = h0 + x / (factorial * (2 * k + 1)), h1 + y / (factorial * (2 * k + 1))
    return c0, c1, h0, h1


def dynamic_stiffness(*, s: ArrayLike, b: ArrayLike, t: ArrayLike) -> Array:
    """Symmetric dynamic stiffness (..., 4, 4): end forces per end displacements (r/l, phi).

    Forces are in EI/l², moments in EI/l; those of the near end come first.

    >>> D = dynamic_stiffness(s=0.0, b=0.0, t=0.0)
    >>> [round(float(d), 9) for d in D[0]]  # the beam's 12, 6, -12, 6
    [12.0, 6.0, -12.0, 6.0]
    """
    T = transfer(s=s, b=b, t=t)
    over = T[..., :2, 2:]
    det = over[..., 0, 0] * over[..., 1, 1] - over[..., 0, 1] * over[..., 1, 0]
    inverse = np.empty_like(over)
    inverse[..., 0, 0], inverse[..., 1, 1] = over[..., 1, 1] / det, over[..., 0, 0] / det
    inverse[..., 0, 1], inverse[..., 1, 0] = -over[..., 0, 1] / det, -over[..., 1, 0] / det
    D = np.empty_like(T)
    D[..., :2, :2], D[..., 2:, 2:] = inverse @ T[..., :2, :2], T[..., 2:, 2:] @ inverse
    D[..., :2, 2:] = -inverse
    D[..., 2:, :2] = -np.swapaxes(inverse, -1, -2)
    return (D + np.swapaxes(D, -1, -2)) / 2


def pieces(*, s: ArrayLike, b: ArrayLike, t: ArrayLike) -> NDArray[np.int64]:
    r"""Number of equal pieces of a shaft, each without a natural frequency below omega if clamped.

    By Poincaré's inequality, with \|r'\|² <= 2\|r' - phi\|² + 2\|phi\|², the energy of a clamped
    piece stays positive where 2 s b <= pi² and 2 b/pi² + t <= pi². If the shaft is divided into n
    pieces, each of them has s n², b/n⁴ and t/n².

    >>> int(pieces(s=0.0, b=20.0, t=0.0)), int(pieces(s=0.0, b=16 * 48.7, t=0.0))  # pi⁴/2 = 48.70
    (1, 2)
    """
    s, b, t = (np.asarray(v, dtype=np.float64) for v in (s, b, t))
    shear = 2 * s * b / np.pi**2
    bending = (t + np.sqrt(t**2 + 8 * b)) / (2 * np.pi**2)
    count: NDArray[np.int64] = np.ceil(np.sqrt(np.maximum(shear, bending))).astype(np.int64)
    return np.maximum(count, 1)
