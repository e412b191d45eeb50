"""Clutch under load: twist under a torque, displacements under all loads.

The deflections are linear in the displacements. Therefore, the potential is convex. The torque
increases progressively with the twist, so that Newton's method from a too large twist converges
monotonically to the root. For all loads together, the potential minus their work has one minimum.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.rotor.clutch import Array, SpragCoupling

STEPS = 200
ROUND_OFF = 1e-15
TOLERANCE = 1e-12  # relative to the twist, or to the loads
HALVINGS = 60


def preload_twist(
    clutch: SpragCoupling, *, T: ArrayLike, offset: ArrayLike = (0.0, 0.0, 0.0, 0.0)
) -> Array:
    """Twist g0 (...) [rad] under the torques T (...) [N m], at a fixed offset.

    `offset` (4,) contains dx, dy [m] and the tilts gx, gy [rad], which the bearings impose.
    Newton's method starts at the twist of a uniform clutch in closed form, increased until the
    deflection of every slice is at least that of the uniform clutch.

    >>> from analytic.rotor.clutch import even_angles
    >>> one = SpragCoupling(psi=even_angles(Z=4), R_i=1.0, nu=np.pi / 4, L=1.0, k_n=3.0)
    >>> round(float(preload_twist(one, T=12.0)), 12)
    1.0

    Raises
    ------
    ValueError
        If a torque is not positive, or the offset not four finite numbers.
    ArithmeticError
        If the twist does not converge to 1e-12 of the twist of a uniform clutch, or to round-off.
    """
    T, offset = np.asarray(T, dtype=np.float64), np.asarray(offset, dtype=np.float64)
    if not (np.isfinite(T).all() and (T > 0).all()):
        raise ValueError(
            f"T must be positive and finite, got {np.min(T):g} N m: without torque, "
            "the clutch has no preload"
        )
    if offset.shape != (4,) or not np.isfinite(offset).all():
        raise ValueError(f"offset must be four finite numbers (dx, dy, gx, gy), got {offset}")
    needed = (T / (clutch.Z * clutch.d_t * clutch.k_n)) ** (1 / clutch.n)
    untwisted = clutch.deformation(np.append(offset, 0.0))
    g = (needed - untwisted.min()) / clutch.d_t
    for _ in range(STEPS):
        force, slope = clutch.law(untwisted + clutch.d_t * g[..., None, None])
        excess = clutch.d_t * force.sum((-2, -1)) - T
        step = excess / (clutch.d_t**2 * slope.sum((-2, -1)))
        g = g - step
        # steps shorten quadratically, so that an error is far below the last one
        if (np.abs(step) <= TOLERANCE * needed / clutch.d_t + ROUND_OFF * np.abs(g)).all():
            return np.asarray(g)
    raise ArithmeticError(f"the twist under {np.max(T):g} N m did not converge in {STEPS} steps")


def under_torque(
    clutch: SpragCoupling, *, T: ArrayLike, offset: ArrayLike = (0.0, 0.0, 0.0, 0.0)
) -> Array:
    """Displacements q (..., 5) [m, rad] at a fixed offset under torques T (...) [N m]."""
    g = preload_twist(clutch, T=T, offset=offset)
    fixed = np.broadcast_to(np.asarray(offset, dtype=np.float64), (*g.shape, 4))
    return np.concatenate([fixed, g[..., None]], axis=-1)


def under_loads(clutch: SpragCoupling, loads: ArrayLike) -> Array:
    """Displacements q (5,) [m, rad] under `loads` (F_x, F_y, M_x, M_y, M_z) (5,) [N, N m].

    With one slice, the tilts are undetermined. Then, `loads` must not contain bending moments, and
    the tilts are zero.

    Raises
    ------
    ValueError
        If the loads are not five finite numbers with a positive torque.
    ArithmeticError
        If no equilibrium is found: too few sprags remain in contact.
    """
    P = np.asarray(loads, dtype=np.float64)
    if P.shape != (5,) or not np.isfinite(P).all() or P[4] <= 0:
        raise ValueError(f"loads must be five finite numbers with a positive torque, got {P}")
    if clutch.n_s == 1 and (P[2:4] != 0).any():
        raise ValueError("one slice cannot transmit a bending moment: n_s must be at least 2")
    free = [0, 1, 4] if clutch.n_s == 1 else [0, 1, 2, 3, 4]
    size = np.array([1.0, 1.0, clutch.L, clutch.L, clutch.d_t])  # levers, to scale residuals
    largest = np.abs(P / size).max()
    q = under_torque(clutch, T=P[4])
    for _ in range(STEPS):
        residual = clutch.loads(q) - P
        if np.abs(residual / size)[free].max() <= TOLERANCE * largest:
            return q
        K = clutch.stiffness(q)[np.ix_(free, free)] / np.outer(size[free], size[free])
        if np.linalg.cond(K) > 1e12:
            break
        step = np.zeros(5)
        step[free] = np.linalg.solve(K, -residual[free] / size[free]) / size[free]
        share = _shortened(clutch, q, step, P)
        if share == 0.0:
            break
        q = q + share * step
    raise ArithmeticError(
        f"no equilibrium under F = ({P[0]:g}, {P[1]:g}) N and T = {P[4]:g} N m: too few sprags "
        "remain in contact"
    )


def _shortened(clutch: SpragCoupling, q: Array, step: Array, P: Array) -> float:
    """Fraction of `step` at whose end the slope of the potential is below a limit; 0 if not found.

    The fraction is halved until the slope is at most 0.9 times the magnitude of the initial slope.
    Slopes are compared, because round-off affects values of the potential long before it affects
    loads.
    """
    slope = float((clutch.loads(q) - P) @ step)
    share = 1.0
    for _ in range(HALVINGS):
        if float((clutch.loads(q + share * step) - P) @ step) <= 0.9 * abs(slope):
            return share
        share /= 2
    return 0.0
