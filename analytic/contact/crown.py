r"""Crowns of rollers: drop of the profile from mid-length towards the ends.

Under a uniform load per length W/l, the indentation of a long contact decreases from the middle to
the position y by :math:`-\frac{W}{\pi l E^*}\ln[1 - (2y/l)^2]` (not valid near the ends). A crown
of that shape (Lundberg's) gives a uniform line load, but its drop is infinite at the ends. Johns
and Gohar limit the drop to the value that is required at the end. Fujiwara and Kawase use a
straight middle part and a drop z_m at the end:

.. math::
    z = -A \ln\left[1 - \left(1 - e^{-z_m/A}\right) t^2\right], \qquad
    A = \frac{K_1 Q}{\pi l E^*}, \qquad
    t = \max\left(0,\ \frac{|y| - l/2}{K_2\, l/2} + 1\right)

y runs along the axis from mid-length, |y| <= l/2. Any consistent units. E* is the contact modulus
of `hertz_line`; for steel on steel the paper's E' is 2 E*. Eq. 1 of the paper prints t without the
maximum, and y in place of |y|; as printed, the profiles of the two ends differ.

References
----------
.. [1] G. Lundberg, Elastische Berührung zweier Halbräume, Forschung auf dem Gebiete des
   Ingenieurwesens 10 (1939) 201-211.
.. [2] P. M. Johns, R. Gohar, Roller bearings under radial and eccentric loads, Tribology
   International 14 (1981) 131-136.
.. [3] H. Fujiwara, T. Kawase, Logarithmic profiles of rollers in roller bearings and optimization
   of the profiles, NTN Technical Review 75 (2007) 140-148.
.. [4] C. Huang, Y. Zhao, M. Liu (2018), Eq. 1.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, positive

END = np.exp(-0.5) / 2  # Johns and Gohar print 0.3033


def slice_centres(*, length: float, slices: int) -> Array:
    """Axial positions [length] of the centres of equal slices from mid-length, shape (slices,).

    Raises ValueError if slices < 1 or length <= 0.

    >>> slice_centres(length=8.0, slices=4).tolist()
    [-3.0, -1.0, 1.0, 3.0]
    """
    if slices < 1:
        raise ValueError(f"slices must be at least 1, got {slices}")
    return np.asarray(((np.arange(slices) + 0.5) / slices - 0.5) * positive(length, "length", "m"))


def lundberg(y: ArrayLike, *, load: ArrayLike, length: ArrayLike, E_star: ArrayLike) -> Array:
    r"""Drop [length] of Lundberg's crown (uniform line load under `load`); infinite at the ends.

    .. math:: z = \frac{W}{\pi l E^*} \ln\frac{1}{1 - (2y/l)^2}

    >>> round(float(lundberg(0.6, load=np.pi, length=2.0, E_star=0.5) / np.log(1 / 0.64)), 12)
    1.0
    """
    t, A = _position(y, length), _scale(load, length, E_star)
    with np.errstate(divide="ignore"):
        return np.asarray(-A * np.log1p(-(t**2)))


def johns_gohar(
    y: ArrayLike,
    *,
    load: ArrayLike,
    length: ArrayLike,
    half_width: ArrayLike,
    E_star: ArrayLike,
) -> Array:
    r"""Drop [length] of Johns and Gohar's crown; `half_width` b is Hertz's value under `load`.

    .. math:: z = \frac{W}{\pi l E^*}
        \ln\frac{1}{1 - \left(1 - \frac{0.3033\, b}{l/2}\right)(2y/l)^2}

    The constant is :math:`1/(2\sqrt e)`: under a uniform line load with Hertz's ellipse across, the
    indentation of a long contact is :math:`2\ln(2l/b) + 1` in the middle and
    :math:`\ln(4l/b) + 1/2` at the end, in units of :math:`W/(\pi l E^*)`. The drop at the end is
    the difference of both, :math:`\ln(l/b) + 1/2`. Raises ValueError unless b < l.

    >>> middle, end = johns_gohar([0.0, 1.0], load=np.pi, length=2.0, half_width=0.1, E_star=0.5)
    >>> abs(float(middle)), round(float(end - np.log(20)), 12)
    (0.0, 0.5)
    """
    b, length = positive(half_width, "half-width", "m"), positive(length, "length", "m")
    if not np.all(b < length):
        raise ValueError(f"half-width must be less than the length, got b={b} m, l={length} m")
    t, A = _position(y, length), _scale(load, length, E_star)
    return np.asarray(-A * np.log1p(-(1 - END * 2 * b / length) * t**2))


def logarithmic(
    y: ArrayLike,
    *,
    K_1: ArrayLike,
    K_2: ArrayLike,
    z_m: ArrayLike,
    load: ArrayLike,
    length: ArrayLike,
    E_star: ArrayLike,
) -> Array:
    r"""Drop [length] of the crown with three parameters (Eq. 1, corrected).

    K_1 multiplies the design load Q = `load`, K_2 in (0, 1] is the crowned fraction of the length,
    z_m [length] is the drop at the ends. K_1 = K_2 = 1 and infinite z_m give Lundberg's crown; if
    z_m is much smaller than A, the crown is the parabola :math:`z_m t^2`.

    >>> A = {"K_1": 1.0, "load": np.pi, "length": 2.0, "E_star": 0.5}  # A = 1
    >>> z = logarithmic([0.25, -0.75, 1.0], K_2=0.5, z_m=np.log(2), **A)  # t = 0, 1/2, 1
    >>> np.exp(-z).round(12).tolist()  # 1 - t²/2
    [1.0, 0.875, 0.5]
    """
    K_2, z_m = _crowned_part(K_2), positive(z_m, "drop z_m at the ends", "m")
    A = positive(K_1, "K_1", "") * _scale(load, length, E_star)
    along = _position(y, length)
    t, from_end = np.maximum((along - (1 - K_2)) / K_2, 0.0), np.minimum((1 - along) / K_2, 1.0)
    m = z_m / A
    lost = -np.expm1(-m) * t**2  # 1 less the argument of the logarithm
    with np.errstate(divide="ignore", over="ignore"):  # exp(-m) alone would underflow
        near_end = -np.logaddexp(np.log(from_end * (1 + t)), 2 * np.log(t) - m)
    drop = A * np.where(lost < 0.5, -np.log1p(-np.minimum(lost, 0.5)), near_end)
    return np.asarray(np.where(from_end > 0, np.minimum(drop, z_m), z_m))


def straight_length(*, K_2: ArrayLike, length: ArrayLike) -> Array:
    """Length of the straight middle part of the `logarithmic` crown: (1 - K_2) l for every z_m.

    >>> float(straight_length(K_2=0.75, length=8.0))
    2.0
    """
    return np.asarray((1 - _crowned_part(K_2)) * positive(length, "length", "m"))


def _position(y: ArrayLike, length: ArrayLike) -> Array:
    """Dimensionless position 2|y|/l; raises ValueError beyond the ends, except for rounding."""
    y, length = finite(y, "position", "m"), positive(length, "length", "m")
    t = 2 * np.abs(y) / length
    if not np.all(t <= 1 + 1e-12):
        raise ValueError(f"position must lie on the roller, |y| <= l/2, got y={y} m, l={length} m")
    return np.asarray(np.minimum(t, 1.0))


def _scale(load: ArrayLike, length: ArrayLike, E_star: ArrayLike) -> Array:
    load, length = positive(load, "load", "N"), positive(length, "length", "m")
    return np.asarray(load / (np.pi * length * positive(E_star, "contact modulus", "Pa")))


def _crowned_part(K_2: ArrayLike) -> Array:
    K_2 = np.asarray(K_2, dtype=np.float64)
    if not np.all((K_2 > 0) & (K_2 <= 1)):
        raise ValueError(f"K_2, the crowned fraction of the length, must lie in (0, 1], got {K_2}")
    return K_2
