r"""Bending waves of a cylinder: exact frequency equation of Pochhammer, Chree and Gazis.

The displacements follow from three potentials with the radial functions Z = J_1, Y_1 of alpha r and
beta r (I_1, K_1 if the square of alpha or beta is negative),

.. math::
    u = \nabla\Phi + \nabla\times(\psi e_z) + \nabla\times\nabla\times(\chi e_z),\quad
    \alpha^2 = w^2/c_1^2 - k^2,\quad \beta^2 = w^2/c_2^2 - k^2,

with Phi = Z(alpha r) cos t sin kz, psi = Z(beta r) sin t sin kz, chi = Z(beta r) cos t cos kz. The
condition of stress-free walls gives a determinant of order 3 (solid) or 6 (hollow).

References
----------
.. [1] L. Pochhammer, Über die Fortpflanzungsgeschwindigkeiten kleiner Schwingungen in einem
   unbegrenzten isotropen Kreiscylinder, J. reine angew. Math. 81 (1876) 324-336.
.. [2] D. C. Gazis, Three-dimensional investigation of the propagation of waves in hollow circular
   cylinders, J. Acoust. Soc. Am. 31 (1959) 568-578.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq
from scipy.special import iv, ivp, jv, jvp, kv, kvp, yv, yvp

Array = NDArray[np.float64]
STEPS = 400  # of the search for the first change of sign


def bending_frequency(
    *, k: float, r_o: float, E: float, nu: float, rho: float, r_i: float = 0.0
) -> float:
    """Lowest angular frequency [1/time] of bending waves of the wave number k.

    It is also the frequency of a cylinder of length j pi/k whose ends are fixed in the transverse
    direction and free axially. The search ends at the frequency of the shear wave with this k,
    which is higher. Raises ValueError unless 0 <= r_i < r_o and k > 0, ArithmeticError if no root
    is found.

    >>> w = bending_frequency(k=0.1, r_o=1.0, E=1.0, nu=0.3, rho=1.0)
    >>> round(w / 0.1**2, 2)  # near sqrt(E I/(rho A)) = r_o/2 of a thin bar
    0.5
    """
    if not (0 <= r_i < r_o < np.inf and 0 < k < np.inf):
        raise ValueError(
            f"a bending wave must have 0 <= r_i < r_o and k > 0, got r_i={r_i:g}, r_o={r_o:g} m, "
            f"k={k:g} 1/m"
        )
    walls = (r_o, r_i) if r_i else (r_o,)
    top = 0.999 * k * np.sqrt(E / (2 * (1 + nu) * rho))

    def value(w: float) -> float:
        return _determinant(w, k, walls, E, nu, rho)

    w = np.linspace(top / STEPS, top, STEPS)
    signs = np.sign([value(x) for x in w])
    change = np.flatnonzero(signs[1:] != signs[:-1])
    if not change.size:
        raise ArithmeticError(
            f"no bending wave with k={k:g} 1/m was found below the frequency of the shear wave"
        )
    a, b = w[change[0]], w[change[0] + 1]
    return float(brentq(value, a, b, xtol=1e-14 * b, rtol=1e-14))


def _determinant(
    w: float, k: float, walls: tuple[float, ...], E: float, nu: float, rho: float
) -> float:
    """Determinant of the stresses on the walls, with columns scaled to unit length."""
    lam, mu = E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))
    squares = rho * w**2 / (lam + 2 * mu) - k**2, rho * w**2 / mu - k**2
    kinds = range(len(walls))
    columns = [
        np.concatenate([_stresses(which, squares, k, kind, r, lam, mu) for r in walls])
        for which in ("Phi", "psi", "chi")
        for kind in kinds
    ]
    unit = [column / np.linalg.norm(column) for column in columns]
    return float(np.linalg.det(np.column_stack(unit)))


def _stresses(
    which: str, squares: tuple[float, float], k: float, kind: int, r: float, lam: float, mu: float
) -> Array:
    """Amplitudes (3,) of the stresses rr, rt, rz at r from the potential `which`."""
    q = squares[0] if which == "Phi" else squares[1]
    Z, D = _radial(q, r, kind)
    DD = -D / r + (1 / r**2 - q) * Z  # Bessel's equation
    if which == "Phi":
        U, dU, V, dV, dW = D, DD, -Z / r, Z / r**2 - D / r, k * D
        volume = -(q + k**2) * Z
    elif which == "psi":
        U, dU, V, dV, dW = Z / r, D / r - Z / r**2, -D, -DD, 0.0
        volume = 0.0
    else:
        U, dU, V, dV = -k * D, -k * DD, k * Z / r, k * (D / r - Z / r**2)
        dW, volume = q * D, 0.0  # W = q Z
    return np.array([
        lam * volume + 2 * mu * dU, mu * (dV - (V + U) / r), mu * (k * U + dW)
    ])  # fmt: skip


def _radial(q: float, r: float, kind: int) -> tuple[float, float]:
    """Radial function Z of order 1 and dZ/dr; q is the square of the radial wave number."""
    s = float(np.sqrt(abs(q)))
    value, slope = (
        ((jv, jvp), (yv, yvp))[kind] if q > 0 else ((iv, ivp), (kv, kvp))[kind]
    )  # fmt: skip
    return float(value(1, s * r)), s * float(slope(1, s * r))
