r"""Logarithmic sprag between two races: triangle of the inner contact, angles of the line AB.

O is the axis of the clutch. The outer flank is a circle of the radius r_e about C_e. The inner
flank is a logarithmic spiral with the pole C_e,

.. math:: \rho(\theta) = \rho_0\,e^{m(\theta - \theta_0)},

so that the angle between the normal at the inner contact A, which passes through O, and the radius
C_eA is arctan(m) for every A. The outer contact B lies on the ray from O through C_e. Then (Eq. 10)

.. math::
    OC_e^2 = OA^2 + \rho^2 + \frac{2\,OA\,\rho}{\sqrt{1+m^2}}, \qquad
    \eta = \arcsin\frac{m\,OA}{OC_e\sqrt{1+m^2}}, \qquad \beta = \arctan m - \eta

where eta is the angle at C_e between C_eA and C_eO, and beta the angle at O between OA and OB.
(Sec. 2.1 of the paper defines eta as the angle between AB and AC_e, which is arctan(m) - nu.)

If only two forces act on a sprag, they act along its strut AB. The angle of AB with the normal at A
is nu, with the normal at B it is omega = nu - beta. If B is above O, A lies to the right of OB, and
the clutch locks if the inner race moves A to the left.

All lengths have the same unit, angles are in rad; all arguments broadcast.

References
----------
.. [1] C. Huang, Y. Zhao, M. Liu, Shock and Vibration 2018, 4190303, Eqs. 9 and 10.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, positive
from analytic.freewheel.rules import require


@dataclass(frozen=True, kw_only=True, eq=False)
class Triangle:
    """Polar radius rho [length] at the inner contact, angles eta at C_e and beta at O [rad]."""

    rho: Array
    eta: Array
    beta: Array


def triangle(*, OA: ArrayLike, OC_e: ArrayLike, m: ArrayLike) -> Triangle:
    """Triangle O A C_e of a spiral that touches a circle of the radius OA (Eq. 10).

    All values are nan if the pole of the spiral is not farther from O than A.

    >>> t = triangle(OA=3.0, OC_e=np.sqrt(17), m=1.0)  # 17 = 9 + 2 + 6
    >>> np.round([t.rho**2, np.tan(t.eta), np.tan(t.beta)], 12).tolist()
    [2.0, 0.6, 0.25]
    """
    OA, OC_e, m = (np.asarray(x, dtype=np.float64) for x in (OA, OC_e, m))
    along, across = OA / np.hypot(1, m), m * OA / np.hypot(1, m)
    meets = (OC_e > OA) & (OA > 0)
    root = np.sqrt(np.where(meets, OC_e**2 - across**2, np.nan))
    # rho = root - along without the difference of two near lengths
    rho = (OC_e - OA) * (OC_e + OA) / (root + along)
    return Triangle(
        rho=np.asarray(rho),
        eta=np.asarray(np.arctan2(across, root)),
        beta=np.asarray(np.arctan2(m * rho, np.hypot(1, m) * OA + rho)),
    )


def strut(*, OA: ArrayLike, OB: ArrayLike, beta: ArrayLike) -> tuple[Array, Array]:
    """Angles nu and omega [rad] between the strut AB and OA, OB (Eq. 10).

    >>> nu, omega = strut(OA=1.0, OB=np.sqrt(2), beta=np.pi / 4)  # right angle at A
    >>> round(float(np.degrees(nu)), 9), round(float(np.degrees(omega)), 9)
    (90.0, 45.0)
    """
    OA, OB, beta = (np.asarray(x, dtype=np.float64) for x in (OA, OB, beta))
    nu = np.arctan2(OB * np.sin(beta), OB * np.cos(beta) - OA)
    return np.asarray(nu), np.asarray(nu - beta)


@dataclass(frozen=True, kw_only=True, eq=False)
class LogSprag:
    """Logarithmic sprag between an inner race of radius R_i and a bore of R_e [length].

    m is the growth of the spiral, r_i its radius of curvature at first contact. Raises ValueError
    for sprags that cannot wedge.

    >>> sprag = LogSprag(R_i=11.11, R_e=19.44, m=0.08490, r_i=4.02)
    >>> round(float(np.degrees(sprag.nu_0)), 2)
    3.0
    """

    R_i: ArrayLike
    R_e: ArrayLike
    m: ArrayLike
    r_i: ArrayLike

    def __post_init__(self) -> None:
        R_i, R_e = positive(self.R_i, "race's radius R_i", "m"), positive(self.R_e, "R_e", "m")
        r_i = positive(self.r_i, "spiral's radius of curvature r_i", "m")
        require(R_i < R_e, "no room for the sprag: R_i must be below R_e", R_i=R_i, R_e=R_e)
        require(
            np.asarray(self.m) > 0, "no wedge: the spiral must grow, m must be positive", "",
            m=self.m,
        )  # fmt: skip
        positive(self.m, "spiral's m", "")
        require(
            self.OC_e < R_e,
            "no room for the sprag: its pole C_e must lie inside the bore, OC_e < R_e",
            OC_e=self.OC_e, R_e=R_e, r_i=r_i,
        )  # fmt: skip

    @classmethod
    def from_wedge_angle(
        cls, *, nu_0: ArrayLike, R_i: ArrayLike, R_e: ArrayLike, r_i: ArrayLike
    ) -> Self:
        """Sprag with the wedge angle nu_0 [rad] at first contact.

        The centre of curvature K of the spiral lies on the normal at A, and C_eK is perpendicular
        to C_eA. Therefore, C_e is the intersection of the ray OB with the circle of diameter AK.
        Raises ValueError if no such sprag exists.
        """
        nu, (R_i, R_e, r_i) = (
            positive(nu_0, "wedge angle nu_0", "rad"),
            (positive(x, "radius", "m") for x in (R_i, R_e, r_i)),
        )
        require(nu < np.pi / 2, "no wedge: nu_0 must be below pi/2", "rad", nu_0=nu)
        require(R_i < R_e, "no room for the sprag: R_i must be below R_e", R_i=R_i, R_e=R_e)
        beta = nu - np.arcsin(R_i / R_e * np.sin(nu))
        centre = R_i + r_i / 2
        # C_e on the circle: seen from its centre under 2 arctan(m) from K
        seen = centre * np.sin(beta) / (r_i / 2)
        require(
            seen < 1, "no spiral has this wedge angle: (2 R_i/r_i + 1) sin(beta) must be below 1",
            "", nu_0=nu, product=seen,
        )  # fmt: skip
        return cls(R_i=R_i, R_e=R_e, m=np.tan((np.arcsin(seen) + beta) / 2), r_i=r_i)

    @cached_property
    def rho_0(self) -> Array:
        """Polar radius [length] at first contact, r_i/sqrt(1 + m²)."""
        return np.asarray(np.asarray(self.r_i) / np.hypot(1, self.m))

    @cached_property
    def OC_e(self) -> Array:
        """Distance [length] of the pole from the axis at first contact."""
        R_i = np.asarray(self.R_i)
        return np.asarray(
            np.sqrt(R_i**2 + self.rho_0**2 + 2 * R_i * self.rho_0 / np.hypot(1, self.m))
        )

    @property
    def r_e(self) -> Array:
        """Radius [length] of the outer flank."""
        return np.asarray(np.asarray(self.R_e) - self.OC_e)

    @cached_property
    def first(self) -> Triangle:
        """Triangle at first contact."""
        return triangle(OA=self.R_i, OC_e=self.OC_e, m=self.m)

    @property
    def beta_0(self) -> Array:
        return self.first.beta

    @property
    def eta_0(self) -> Array:
        return self.first.eta

    @property
    def nu_0(self) -> Array:
        """Wedge angle [rad] at first contact, at the inner race."""
        return strut(OA=self.R_i, OB=self.R_e, beta=self.beta_0)[0]

    @property
    def omega_0(self) -> Array:
        """Wedge angle [rad] at first contact, at the outer race."""
        return strut(OA=self.R_i, OB=self.R_e, beta=self.beta_0)[1]
