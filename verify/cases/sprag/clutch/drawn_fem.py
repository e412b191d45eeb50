"""Profile of the sprag computed point by point: a second method for its state."""

import math

import numpy as np

from analytic.sprag.drawn import Drawn, Sizes, crown_drop, middles
from verify.cases.sprag.inputs import SpragInputs
from verify.core.figures import Array


def places(q: SpragInputs, n: int) -> Array:
    """Centres [m] of n equal parts of a sprag, measured from mid-length."""
    return middles(q.l, n)


def crowned(q: SpragInputs, n: int) -> Array:
    """Drop [m] of the crown at `places`; the design load is Q or, by default, the static load."""
    if q.z_m == 0:
        return np.zeros(n)
    Q = q.Q or q.T / (q.z * q.R_i * math.tan(q.nu_0))
    A = 2 * q.K_1 * Q * (1 - q.nu**2) / (math.pi * q.l * q.E)
    return crown_drop(places(q, n), length=q.l, A=A, K_2=q.K_2, z_m=q.z_m)


def drawn(q: SpragInputs, points: int, *, rigid: bool = False, printed: bool = False) -> Drawn:
    """Numerical profile with `points` points per radian.

    The races are rigid if `rigid`; Eqs. 9 and 10 apply as printed if `printed`.
    """
    sizes = Sizes(
        R_id=q.R_id, R_i=q.R_i, R_e=q.R_e, R_ed=q.R_ed, r_i=q.r_i, m=float(np.asarray(q.sprag.m)),
        z=q.z, l=q.l, b=q.b, E=q.E, nu=q.nu, density=q.density, omega=q.n,
        gap=crowned(q, q.slices),
    )  # fmt: skip
    return Drawn(sizes, points, rigid=rigid, printed=printed)
