r"""First corrections to Hertz for two discs, each pressed from both sides (asymptotic expansion).

Disc 1 lies above the contact, disc 2 below; R is the relative radius, s_i = E*/E_i' the share of
disc i in the compliance. The deformed surfaces meet on a parabola of curvature

.. math:: \kappa = \frac{s_2}{R_1} - \frac{s_1}{R_2},

to which the pressure is normal. Each correction of the kernel :math:`2/(\pi E^*) \ln|x - x'|` or of
the gap changes the effective profile of Hertz's half planes from :math:`x^2/(2R)` to
:math:`(1 + \alpha)\,x^2/(2R) + \gamma x^4`. The resulting peak pressure and half-width are

.. math:: \frac{p_0}{p_H} = 1 + \frac{\alpha + \gamma R a^2}{2}, \qquad
          \frac{w}{a_H} = 1 - \frac{\alpha}{2} - \gamma R a^2,

where w = 2 sqrt(int q x² / int q) is the half-width from the moments of the pressure. Contributions
to alpha and gamma R:

- the discs, as in `disc_series`: :math:`a^2/4 \sum s_i/R_i^2` and :math:`R/8 \sum R_i^{-3}`;
- the gap along the inclined normal is longer by the fraction kappa² x²: it adds :math:`\kappa^2/2`
  to gamma R;
- the pressure's component along x, kappa x' q, moves the surfaces along x, which closes the gap
  by kappa x: kernel :math:`\kappa^2 x x' \ln|x - x'|`, hence :math:`\kappa^2 a^2`, -kappa²/3;
- the load extends disc i along x by :math:`2 P x/(\pi E_i' R_i)`, one half by the curvature of its
  rim, one half by the opposite load: :math:`-\kappa a^2 (s_1/R_1 - s_2/R_2)`;
- normals connect points at x_1 and :math:`x_2 = x_1 + \kappa x_1^3/(2R)`: with x in the middle of
  both, this adds :math:`-\kappa^2/4` to the sum for p_0.

If the materials differ (Dundurs' beta), normal and tangential displacements are coupled already for
half planes. The kernel :math:`\beta\kappa|x - x'|/E^*` then has effects of first order,

.. math:: -\beta\kappa a\,\frac{2G - 1/3}{\pi} \text{ in } p_0, \qquad
          +\beta\kappa a\,\frac{64}{45\pi} \text{ in } w,

with Catalan's constant G. Neglected terms: (a/R)⁴ (for equal discs with the factors -0.057 in p_0
and 0.129 in w, from `disc`), (beta kappa a)² (second order of the same kernel, factors 0.108 and
0.103), and beta kappa a (a/R)².
"""

from dataclasses import dataclass

import numpy as np

from analytic.contact.checks import Assumption, in_plane, positive
from analytic.contact.partial_slip import dundurs_beta
from analytic.contact.two_bodies import contact_modulus, relative_radius

CATALAN = 0.915965594177219


@dataclass(frozen=True, kw_only=True)
class Excess:
    """Relative excess of the true value over Hertz's value under the same load, split by order."""

    first: float  # of the order beta a/R
    second: float  # of the order (a/R)²

    @property
    def total(self) -> float:
        """Sum of the terms of both orders."""
        return self.first + self.second


def excess(
    *,
    a: float,
    R_1: float,
    R_2: float,
    E_1: float,
    nu_1: float,
    E_2: float,
    nu_2: float,
    assumption: Assumption,
) -> tuple[Excess, Excess]:
    """Relative excesses [1] of peak pressure and half-width (by moments) over Hertz's values.

    `a` is Hertz's half-width; an infinite R_2 is a flat.

    >>> steel = {"E_1": 2.0, "nu_1": 0.3, "E_2": 2.0, "nu_2": 0.3, "assumption": "plane strain"}
    >>> p, w = excess(a=0.1, R_1=1.0, R_2=1.0, **steel)  # as on a rigid flat: 3/16, -1/4
    >>> round(p.total, 12), round(w.total, 12)
    (0.001875, -0.0025)
    """
    a, R_1 = float(positive(a, "half-width", "m")), float(positive(R_1, "radius", "m"))
    R_2 = float(R_2)
    if not R_2 > 0:
        raise ValueError(f"R_2 must be positive: two discs or a disc on a flat, got R_2={R_2} m")
    materials = {"E_1": E_1, "nu_1": nu_1, "E_2": E_2, "nu_2": nu_2}
    kappa = meeting_curvature(R_1=R_1, R_2=R_2, **materials, assumption=assumption)
    s_1, s_2 = shares(**materials, assumption=assumption)
    b_1, b_2, R = 1 / R_1, 1 / R_2, float(relative_radius(R_1=R_1, R_2=R_2))
    beta = float(dundurs_beta(**materials, assumption=assumption))
    discs, circles = (s_1 * b_1**2 + s_2 * b_2**2) / 8, R * (b_1**3 + b_2**3) / 8
    stretch = kappa * (s_1 * b_1 - s_2 * b_2) / 2
    askew = kappa * (s_1 - s_2) / (8 * R)  # w is measured halfway between x_1 and x_2
    p = discs + circles / 2 + kappa**2 / 3 - stretch
    w = -discs - circles - 2 / 3 * kappa**2 + kappa**2 / 2 + stretch + askew
    coupled = beta * kappa * a
    return (
        Excess(first=-coupled * (2 * CATALAN - 1 / 3) / np.pi, second=p * a**2),
        Excess(first=coupled * 64 / (45 * np.pi), second=w * a**2),
    )


def left_out(
    *,
    a: float,
    R_1: float,
    R_2: float,
    E_1: float,
    nu_1: float,
    E_2: float,
    nu_2: float,
    assumption: Assumption,
) -> float:
    r"""Bound (no unit) of the terms that both excesses neglect; e is a over the smaller radius.

    .. math:: \frac{e^4}{8} + \frac{(\beta\kappa a)^2}{4} + \frac{|\beta\kappa a|\, e^2}{2}

    The factor 1/8 is about the largest of the known factors of e⁴ (0.129 for the half-width of
    equal discs). The factor 1/4 is about twice the known one, to cover other coupling terms of this
    order. The factor 1/2 is not computed: it assumes that the discs change the first-order term as
    they change the pressure.

    >>> steel = {"E_1": 2.0, "nu_1": 0.3, "E_2": 2.0, "nu_2": 0.3, "assumption": "plane strain"}
    >>> round(left_out(a=0.1, R_1=1.0, R_2=1.0, **steel), 12)
    1.25e-05
    """
    materials = {"E_1": E_1, "nu_1": nu_1, "E_2": E_2, "nu_2": nu_2}
    kappa = meeting_curvature(R_1=R_1, R_2=R_2, **materials, assumption=assumption)
    coupled = abs(float(dundurs_beta(**materials, assumption=assumption)) * kappa * a)
    e = a / min(R_1, R_2)
    return e**4 / 8 + coupled**2 / 4 + coupled * e**2 / 2


def shares(
    *, E_1: float, nu_1: float, E_2: float, nu_2: float, assumption: Assumption
) -> tuple[float, float]:
    """Shares s_i = E*/E_i' (no unit) that the bodies have in the compliance; they add up to 1."""
    E_star = contact_modulus(E_1=E_1, nu_1=nu_1, E_2=E_2, nu_2=nu_2, assumption=assumption)
    both = ((E_1, nu_1), (E_2, nu_2))
    s_1, s_2 = (float(E_star / in_plane(E, nu, assumption)[0]) for E, nu in both)
    return s_1, s_2


def meeting_curvature(
    *,
    R_1: float,
    R_2: float,
    E_1: float,
    nu_1: float,
    E_2: float,
    nu_2: float,
    assumption: Assumption,
) -> float:
    """Curvature kappa [1/length] of the deformed contact line, positive if concave towards body 1.

    R_2 is negative for a bore.

    >>> like = {"E_1": 1.0, "nu_1": 0.3, "E_2": 1.0, "nu_2": 0.3, "assumption": "plane strain"}
    >>> meeting_curvature(R_1=1.0, R_2=4.0, **like), meeting_curvature(R_1=1.0, R_2=-4.0, **like)
    (0.375, 0.625)
    """
    s_1, s_2 = shares(E_1=E_1, nu_1=nu_1, E_2=E_2, nu_2=nu_2, assumption=assumption)
    return s_2 / R_1 - s_1 / R_2
