r"""Finite line contact by semi-analytic strips: Hertz's ellipse across, half-space along y.

A roller is divided into n equal strips of width D = l/n along its axis y. In each strip, the
pressure across is Hertz's ellipse with the half-width of this strip and is constant over D,

.. math::
    b_k = \sqrt{\frac{4q_kR}{\pi E^*}}, \qquad p_k = \frac{2q_k}{\pi b_k}, \qquad
    \sum_k C_{jk}(b_k)\, q_k \ge \delta - z_j, \quad q_j \ge 0, \quad
    D\sum_k q_k = W,

with equality where q_j > 0; C_jk (`strip_influence`) is the displacement of the middle line of
strip j by the elliptic pressure of strip k on a half-space, both bodies together. z is the gap from
crown, tilt and form errors, without the parabola x²/2R. Any consistent units.

Range: frictionless, small strain, b much smaller than R and than the length over which q changes;
`strip_error.neglected` estimates the error. If the ends of the roller carry load (no crown), the
peak pressure does not converge as strips become narrower; only the pressure at mid-length and the
loads on parts of finite length converge. The half-space continues beyond the end faces of the
roller.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, secs. 4.2 and 5.6.
.. [2] J. J. Kalker, On elastic line contact, J. Appl. Mech. 39 (1972) 1125-1132 (slender
   contacts; the strips are the leading order of this theory).
"""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.checks import Array, finite, positive
from analytic.contact.strip_newton import Solved, solve

AT_ONCE = 40_000  # loads in work at a time: the cache holds them


@dataclass(frozen=True)
class Strips:
    """Solved contacts: q, half_width, pressure and carries are (..., n), the other arrays (...).

    q is the line load [N/m], and pressure [Pa] is the pressure in the middle of each strip.
    half_width is b [m], approach is delta [m], load is W [N]. `residual` is the larger of two
    relative errors: violation of the contact conditions over the largest displacement, and error of
    the load. gap, length, R and E_star are the input values.
    """

    q: Array
    half_width: Array
    pressure: Array
    carries: NDArray[np.bool_]
    approach: Array
    load: Array
    residual: Array
    gap: Array
    length: Array
    R: Array
    E_star: Array

    @property
    def peak(self) -> Array:
        """Largest pressure [Pa] of the strips, (...)."""
        return np.asarray(self.pressure.max(axis=-1))

    @property
    def mid(self) -> Array:
        """Pressure [Pa] at mid-length, (...); between two strips, their root mean square.

        p² is proportional to q, which is smooth at mid-length.
        """
        n = self.q.shape[-1]
        middle = self.pressure[..., (n - 1) // 2] ** 2 + self.pressure[..., n // 2] ** 2
        return np.asarray(np.sqrt(middle / 2))


def press_strips(
    gap: ArrayLike,
    *,
    length: ArrayLike,
    R: ArrayLike,
    E_star: ArrayLike,
    load: ArrayLike | None = None,
    approach: ArrayLike | None = None,
    tolerance: float = 1e-10,
    workers: int = 1,
) -> Strips:
    """Solved contacts of rollers of length l, under a given `load` or at a given `approach`.

    `gap` (..., n) is the height z [m] at the centres of the strips. length, relative radius R [m],
    contact modulus E_star [Pa], load [N] or approach [m] are (...). All arguments are broadcast. If
    no strip touches at the given approach, the load is zero. `tolerance` is relative to the largest
    displacement and to the load; at 1e-8, the error of the loads is below 1e-7. `workers` threads
    solve the cases, each with one BLAS thread. Raises ValueError for invalid input and for a
    contact that is wider than the roller is long, ArithmeticError if a case does not converge.

    >>> load = 100 * np.pi * 1e-4
    >>> roller = press_strips(np.zeros(400), length=100.0, R=1.0, E_star=4.0, load=load)
    >>> round(float(roller.half_width[200]), 3), round(float(roller.mid), 3)  # Hertz: 0.01, 0.02
    (0.01, 0.02)
    """
    if not 1e-12 <= tolerance <= 1e-4:
        raise ValueError(f"tolerance must lie in [1e-12, 1e-4], got {tolerance}")
    z, length, R, E_star, given = _cases(gap, length, R, E_star, load, approach)
    shape, n = z.shape[:-1], z.shape[-1]
    D = length / n
    height, line = D**2 / (2 * np.pi * R), np.pi * E_star * D**2 / (4 * R)
    lowest = z.min(axis=-1)
    h = ((z - lowest[..., None]) / height[..., None]).reshape(-1, n)
    if approach is None:
        total = (given / (line * D)).ravel()
        _refuse_wide(total / n, n)
        solved = _in_parts(
            lambda at: solve(h[at], tolerance=tolerance, total=total[at]), h, workers
        )
    else:
        Delta = ((given - lowest) / height).ravel()
        _refuse_wide(Delta / 8, n)  # at b = l/2 all along Delta is 6 s; at 8 s b is surely beyond
        solved = _in_parts(
            lambda at: solve(h[at], tolerance=tolerance, Delta=Delta[at]), h, workers
        )
    _refuse_wide(solved.s.sum(axis=-1) / np.maximum((solved.s > 0).sum(axis=-1), 1), n)
    s = solved.s.reshape(*shape, n)
    q, root = s * line[..., None], np.sqrt(s)
    return Strips(
        q=q,
        half_width=root * D[..., None],
        pressure=root * (E_star * D / (2 * R))[..., None],
        carries=s > 0,
        approach=solved.Delta.reshape(shape) * height + lowest if approach is None else given,
        load=q.sum(axis=-1) * D,
        residual=solved.residual.reshape(shape),
        gap=z,
        length=length,
        R=R,
        E_star=E_star,
    )


press = press_strips  # its name in version 0.1


def _cases(
    gap: ArrayLike,
    length: ArrayLike,
    R: ArrayLike,
    E_star: ArrayLike,
    load: ArrayLike | None,
    approach: ArrayLike | None,
) -> tuple[Array, Array, Array, Array, Array]:
    """Gap (..., n), length, R, E_star and load or approach (...), checked and broadcast."""
    z = finite(gap, "gap", "m")
    if z.ndim == 0 or z.shape[-1] == 0:
        raise ValueError(
            f"gap must have one height per strip along its last axis, got shape {z.shape}"
        )
    if load is not None and approach is None:
        given = positive(load, "load", "N")
    elif approach is not None and load is None:
        given = finite(approach, "approach", "m")
    else:
        raise ValueError("exactly one of load [N] and approach [m] must be given")
    scalars = (
        positive(length, "length", "m"),
        positive(R, "relative radius", "m"),
        positive(E_star, "contact modulus", "Pa"),
        given,
    )
    try:
        shape = np.broadcast_shapes(z.shape[:-1], *(a.shape for a in scalars))
    except ValueError:
        shapes = ", ".join(str(a.shape) for a in scalars)
        raise ValueError(
            "gap (without its last axis, the strips), length, R, E_star, and load or approach must "
            f"have compatible shapes, got gap {z.shape} and the others in this order: {shapes}"
        ) from None
    l_, R, E_star, given = (np.broadcast_to(a, shape) for a in scalars)
    return np.broadcast_to(z, (*shape, z.shape[-1])), l_, R, E_star, given


def _in_parts(part: Callable[[slice], Solved], h: Array, workers: int) -> Solved:
    """Result of `part` for all slices of the cases, concatenated."""
    cases, n = h.shape
    size = max(1, AT_ONCE // n)
    parts = [slice(i, i + size) for i in range(0, cases, size)]
    if workers > 1 and len(parts) > 1:
        with ThreadPoolExecutor(workers) as pool:
            solved = list(pool.map(part, parts))
    else:
        solved = [part(at) for at in parts]
    if not solved:
        return Solved(np.empty((0, n)), np.empty(0), np.empty(0), 0)
    return Solved(
        np.concatenate([p.s for p in solved]),
        np.concatenate([p.Delta for p in solved]),
        np.concatenate([p.residual for p in solved]),
        max(p.iterations for p in solved),
    )


def _refuse_wide(s: Array, n: int) -> None:
    """Raise ValueError if b = sqrt(s) D exceeds half the length n D; s is a mean per case, (N,)."""
    wide = np.sqrt(np.maximum(s, 0.0)) / n
    if np.any(wide > 0.5):
        case = int(np.argmax(wide))
        raise ValueError(
            "a line contact must be longer than wide: the half-width must be at most half the "
            f"length, got b/l = {wide[case]:.3g} in case {case}"
        )
