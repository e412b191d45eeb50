r"""Line contact under a tangential force below the limit of friction (Cattaneo, Mindlin).

The normal load P is constant; the tangential force Q per unit length increases from zero to less
than mu P. The contact sticks over |x| < c and slips in the strips outside:

.. math::
    \frac{c}{a} = \sqrt{1 - \frac{Q}{\mu P}}, \qquad
    q(x) = \mu p_0\left[\sqrt{1 - \frac{x^2}{a^2}}
           - \frac{c}{a}\sqrt{1 - \frac{x^2}{c^2}}\,\right],

where the second root counts only for |x| < c. `E_star` is the contact modulus of `hertz_line`. Any
consistent units.

Range: as for Hertz. In addition, tangential tractions must not change the pressure: Dundurs'
constant beta (`dundurs_beta`) must be zero. It is zero for bodies of equal material, but not for a
compressible body on a rigid one. Then, the formulas are an approximation with an error that
increases with |beta|.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, ch. 7.
.. [2] R. D. Mindlin, H. Deresiewicz, Elastic spheres in contact under varying oblique forces,
   Journal of Applied Mechanics 20 (1953) 327-344: the rule of superposition for a changing Q.
"""

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import hyp2f1

from analytic.contact.checks import Array, Assumption, finite, not_negative, pair_in_plane, positive


def stick_half_width(*, Q: ArrayLike, P: ArrayLike, mu: ArrayLike, a: ArrayLike) -> Array:
    """Half-width c [length] of the stick zone.

    >>> float(stick_half_width(Q=0.75, P=1.0, mu=1.0, a=2.0))  # sqrt(1 - 3/4) = 1/2
    1.0
    """
    share = _share(Q, P, mu)
    return np.asarray(positive(a, "half-width", "m") * np.sqrt(1 - share))


def traction(x: ArrayLike, *, Q: ArrayLike, P: ArrayLike, mu: ArrayLike, a: ArrayLike) -> Array:
    """Shear traction q [stress] at x in the first loading; its integral over x is Q.

    >>> load = {"Q": 0.75 * np.pi / 2, "P": np.pi / 2, "mu": 1.0, "a": 1.0}  # p_0 = 1, c = 1/2
    >>> traction([0.0, 0.8, 1.5], **load).round(12).tolist()
    [0.5, 0.6, 0.0]
    """
    c, x = stick_half_width(Q=Q, P=P, mu=mu, a=a), finite(x, "position", "m")
    a = np.asarray(a, dtype=np.float64)
    limit = np.asarray(mu) * 2 * np.asarray(P) / (np.pi * a**2)  # mu p_0 / a
    lens, stuck = (np.sqrt(np.maximum(w**2 - x**2, 0.0)) for w in (a, c))
    return np.asarray(limit * (lens - stuck))


def slip(
    x: ArrayLike,
    *,
    Q: ArrayLike,
    P: ArrayLike,
    mu: ArrayLike,
    a: ArrayLike,
    E_star: ArrayLike,
) -> Array:
    r"""Relative slip [length] of the surfaces at x in the first loading; 0 in the stick zone.

    .. math:: s(x) = \frac{\mu p_0}{a E^*}\left[|x|\sqrt{x^2 - c^2} - c^2
              \operatorname{arcosh}\frac{|x|}{c}\right], \qquad c \le |x| \le a,

    the integral from c of :math:`\frac{2\mu p_0}{aE^*}\sqrt{x^2 - c^2}`, the difference of the
    tangential strains of both surfaces.
    """
    c, x = stick_half_width(Q=Q, P=P, mu=mu, a=a), np.abs(finite(x, "position", "m"))
    a = np.asarray(a, dtype=np.float64)
    if not np.all(x <= a):
        raise ValueError(f"x must lie in the contact, |x| <= a = {a} m, got {x} m")
    t = np.maximum(x / c, 1.0)
    scale = 2 * np.asarray(mu) * np.asarray(P) / (np.pi * a**2)  # mu p_0 / a
    growth = c**2 * (t * np.sqrt(t**2 - 1) - np.arccosh(t))
    return np.asarray(scale * growth / positive(E_star, "contact modulus", "Pa"))


def rigid_displacement_beyond_stick(
    *, Q: ArrayLike, P: ArrayLike, mu: ArrayLike, E_star: ArrayLike
) -> Array:
    r"""Tangential displacement [length] of the bodies, minus the value for complete stick.

    The total displacement contains an undetermined logarithm of the size of the bodies. The part
    caused by slip is local and does not contain it. With k = Q/(mu P), it is

    .. math:: \frac{\mu P}{\pi E^*}\left[k + (1-k)\ln(1-k)\right],

    the difference of two displacements in the middle of the contact, -2/(pi E*) times the integral
    of q ln|x|: one for the traction q of partial slip (`traction`), the other for the traction of
    complete stick, :math:`Q/(\pi\sqrt{a^2 - x^2})`.
    """
    k = _share(Q, P, mu)
    bracket = k**2 / 2 * hyp2f1(1, 1, 3, k)  # the same without cancellation at small k
    scale = np.asarray(mu) * np.asarray(P) / (np.pi * positive(E_star, "contact modulus", "Pa"))
    return np.asarray(scale * bracket)


def dundurs_beta(
    *, E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike, assumption: Assumption
) -> Array:
    r"""Dundurs' constant beta (no unit): coupling of tangential tractions and pressure.

    .. math:: \beta = \frac{(1-\nu_2')/E_2' - (1-\nu_1')/E_1'}{2\,(1/E_1' + 1/E_2')}

    with E' and nu' of plane stress or plane strain; at most one body may be rigid.

    >>> one = {"E_1": 1.0, "nu_1": 0.3, "assumption": "plane strain"}
    >>> float(dundurs_beta(**one, E_2=1.0, nu_2=0.3))
    0.0
    """
    soft_1, cross_1, soft_2, cross_2 = pair_in_plane(E_1, nu_1, E_2, nu_2, assumption)
    difference = (1 - cross_2) * soft_2 - (1 - cross_1) * soft_1
    return np.asarray(difference / (2 * (soft_1 + soft_2)))


def _share(Q: ArrayLike, P: ArrayLike, mu: ArrayLike) -> Array:
    P, mu = positive(P, "load per length", "N/m"), positive(mu, "coefficient of friction", "")
    Q = not_negative(Q, "tangential force per length", "N/m")
    if not np.all(mu * P > Q):
        raise ValueError(
            f"Q must be below the friction limit mu P = {mu * P} N/m, got {Q} N/m: the contact "
            "slides"
        )
    return np.asarray(Q / (mu * P))
