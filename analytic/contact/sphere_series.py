r"""First correction to Hertz for spheres that are each pressed between two opposite contacts.

The displacement of a sphere under normal surface loads follows term by term from Legendre's series:
a normal stress :math:`2\mu P_n` moves the surface by c_n R P_n,

.. math:: c_n = \frac{2(1-\nu)n^2 + \nu n - 1 + 2\nu}{(n-1)(n^2 + (1+2\nu)n + 1 + \nu)}
          = \frac{2(1-\nu)}{n} + \frac{\nu(4\nu - 3)}{n^2} + \dots

For a point force P, the displacement is a sum of (2n + 1) c_n P_n. Its first term is that of the
half space with the chord d, its second term is a logarithm. Near the force,

.. math:: u = \frac{P}{\pi E'}\left[\frac1d - \frac{\lambda}{R}\ln\frac{d}{2R}
          + \frac{\text{const}}{R}\right],
          \qquad \lambda = \frac{(1-2\nu)^2}{2(1-\nu)}, \quad E' = \frac{E}{1-\nu^2}.

The angle between the surface and the direction of the force also adds a constant. The displacement
at x by a force at x' contains, with the same factor, (x - x') . x'/d² from the tangential component
of the force, and -(x - x') . x/d² from the tilt of the displaced surface; their sum is -1. The
logarithmic part of the displacements changes the effective shape of the contact of the half spaces.
Galin's integrals give the solution in closed form. With
:math:`\varepsilon = a \sum \lambda_i E^*/(E_i' R_i)`

.. math::
    P = \frac{4 E^* a^3}{3R}\left[1 - \frac{3\varepsilon}{2\pi}\right], \qquad
    p_0 = \frac{2 E^* a}{\pi R}\left[1 - \varepsilon\left(\frac{1}{2\pi} + \frac{\pi}{8}\right)
    \right].

Thus, under the same load, a exceeds Hertz's value by the fraction :math:`\varepsilon/2\pi`, and p_0
is lower by the fraction :math:`\pi\varepsilon/8`. The neglected terms are of the order (a/R_i)²
with factors below 1. For example, the fourth-power term of a circular profile changes P by the
fraction 2/5 (a/R)².

References
----------
.. [1] E. Sternberg, F. Rosenthal, The elastic sphere under concentrated loads, J. Appl. Mech. 19
   (1952) 413-421: the point force and its logarithm.
.. [2] A. I. Lur'e, Three-Dimensional Problems of the Theory of Elasticity, Interscience 1964:
   the sphere in Legendre's series.
.. [3] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 5.3: any profile of
   revolution.
"""

from dataclasses import dataclass
from math import cbrt, log, pi

import numpy as np
from scipy.optimize import brentq
from scipy.special import digamma

from analytic.contact.checks import poisson, positive


@dataclass(frozen=True)
class Sphere:
    """Radius [length] and material of a sphere.

    R is infinite for a half space; E [stress] is infinite for a rigid body.
    """

    R: float
    E: float
    nu: float

    def __post_init__(self) -> None:
        poisson(self.nu)
        for value, what, unit in ((self.R, "radius", "m"), (self.E, "Young's modulus", "Pa")):
            if not value > 0:
                raise ValueError(f"{what} must be positive, got {value} {unit}")

    @property
    def softness(self) -> float:
        """Compliance 1/E' [1/stress]."""
        return (1 - self.nu**2) / self.E

    @property
    def logarithm(self) -> float:
        """Compliance lambda/(E' R) [1/(stress length)]: factor of the logarithmic term."""
        return (1 - 2 * self.nu) ** 2 / (2 * (1 - self.nu)) * self.softness / self.R

    def sinking(self, a: float) -> float:
        """Displacement per load [length/force] of a sphere, minus that of a half-space.

        The load is Hertz's pressure on a contact of radius a. The displacement is that of the
        middle of the contact relative to the plane of symmetry half-way to the opposite contact,
        without the effect of the tilt of the surface.
        """
        if np.isinf(self.R):
            return 0.0
        mean_log = log(a / (2 * self.R)) + log(2) - 4 / 3
        rest = _rest(self.nu) / (4 * pi * (1 - self.nu)) * self.softness / self.R
        return rest - self.logarithm / pi * mean_log

    @property
    def tilted(self) -> float:
        """Displacement per load and curvature [1/stress], due to the tilt of the surface."""
        return (1 - 2 * self.nu) / (2 * pi * (1 - self.nu)) * self.softness


@dataclass(frozen=True)
class PressedSpheres:
    """Contact radius, peak pressure and approach of two spheres with the first correction to Hertz.

    The approach is that of the planes of symmetry of both spheres. Each `excess` is the relative
    excess over Hertz's value under the same load.
    """

    a: float
    p_0: float
    approach: float
    a_excess: float
    p_0_excess: float
    approach_excess: float


def pressed_spheres(one: Sphere, other: Sphere, *, P: float) -> PressedSpheres:
    """Solution for two spheres under the load P [force].

    At least one body must be elastic and at least one must have a finite radius.

    >>> ball, flat = Sphere(R=1.0, E=0.75, nu=0.5 - 1e-9), Sphere(R=np.inf, E=np.inf, nu=0)
    >>> pressed = pressed_spheres(ball, flat, P=4e-6 / 3)  # incompressible: no logarithm
    >>> round(pressed.a, 9), round(pressed.p_0 * pi, 9)
    (0.01, 0.02)
    """
    positive(P, "load", "N")
    soft, bent = one.softness + other.softness, 1 / one.R + 1 / other.R
    if not (soft > 0 and bent > 0):
        raise ValueError(
            "at least one body must be elastic, and at least one must have a finite radius"
        )
    strength = (one.logarithm + other.logarithm) / soft  # epsilon over a
    hertz = cbrt(0.75 * P * soft / bent)
    epsilon = hertz * strength
    wider, lower = epsilon / (2 * pi), -pi * epsilon / 8
    a = hertz * (1 + wider)
    flat = a**2 * bent * (1 - 4 * a * strength / (3 * pi) * (0.5 + log(2)))
    # the force acts along the common normal, whose curvature the softer body follows
    common = (other.softness / one.R - one.softness / other.R) / soft
    tilt = one.tilted * (1 / one.R - common) + other.tilted * (1 / other.R + common)
    approach = flat + P * (one.sinking(a) + other.sinking(a) - tilt)
    return PressedSpheres(
        a=a,
        p_0=2 * hertz * bent / (pi * soft) * (1 + lower),
        approach=approach,
        a_excess=wider,
        p_0_excess=lower,
        approach_excess=approach / (hertz**2 * bent) - 1,
    )


def load_excess(one: Sphere, other: Sphere, *, P: float) -> float:
    """Relative excess Q/P - 1 of a load Q over P [force].

    Under Q, the approach of the finite spheres equals Hertz's approach under P.

    >>> ball, flat = Sphere(R=1.0, E=0.75, nu=0.0), Sphere(R=np.inf, E=np.inf, nu=0)
    >>> excess = load_excess(ball, flat, P=4e-6 / 3)
    >>> moved = pressed_spheres(ball, flat, P=(1 + excess) * 4e-6 / 3).approach
    >>> first = pressed_spheres(ball, flat, P=4e-6 / 3)
    >>> bool(abs(moved * (1 + first.approach_excess) / first.approach - 1) < 1e-12)
    True
    """
    first = pressed_spheres(one, other, P=P)
    delta = first.approach / (1 + first.approach_excess)

    def missing(share: float) -> float:
        return pressed_spheres(one, other, P=share * P).approach / delta - 1

    return float(brentq(missing, 0.5, 3.0, xtol=1e-14)) - 1


def _rest(nu: float) -> float:
    """Displacement at the pole by two opposite unit forces, less 4(1 - nu) R/d and the logarithm.

    The unit is 1/(8 pi mu R). The even terms of the series count twice, the odd terms cancel. The
    subtracted parts are the first two orders in 1/n of the terms of the near force. The same two
    orders of the opposite force are included as the sums of (-1)^n and (-1)^n/n. The remainder is
    computed by digamma functions, from the partial fractions of (2n + 1) c_n.
    """
    two = 2 * (1 - 2 * nu) ** 2
    root = -(1 + 2 * nu) / 2 + 1j * np.sqrt(0.75 - nu**2)
    top = 2 * (1 - nu) * root**2 + nu * root - 1 + 2 * nu
    share = (2 * root + 1) * top / ((root - 1) * 2j * root.imag)
    tail = digamma(0.5) + 2 * np.real(share * digamma(1 - root / 2)) - two * digamma(1.0)
    uniform = (1 - 2 * nu) / (1 + nu) - 4 * (1 - nu)  # n = 0
    return float(2 * (1 - nu) - two * log(2) + 2 * uniform - tail)
