r"""Approach of bodies in line contact.

In plane problems, the displacement under a load increases with the logarithm of the distance.
Therefore, an approach is defined only between the contact and a stated point. All approaches are
positive and apply to one body with the modulus E under the load P per unit length. The approaches
of two bodies are added.

On the axis below an elliptic pressure, with S = sqrt(a² + z²),

.. math:: \sigma_z = -\frac{p_0 a}{S}, \qquad
          \sigma_x = -\frac{p_0}{a}\left(S + \frac{z^2}{S} - 2z\right).

The integral of the strain :math:`(\sigma_z - \nu'\sigma_x)/E'` has a closed form. E' and nu' are E
and nu in plane stress, :math:`E/(1-\nu^2)` and :math:`\nu/(1-\nu)` in plane strain.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 5.6.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, Assumption, in_plane, not_negative, positive


def approach_to_depth(
    d: ArrayLike,
    *,
    P: ArrayLike,
    a: ArrayLike,
    E: ArrayLike,
    nu: ArrayLike,
    assumption: Assumption,
) -> Array:
    r"""Approach [length] of the middle of the contact and the point at the depth d below it.

    The formula is exact for a half plane under an elliptic pressure at every d:

    .. math:: \delta = \frac{2P}{\pi E'}\left[\operatorname{arsinh}\frac{d}{a}
              - \nu'\,\frac{d}{d + \sqrt{a^2 + d^2}}\right]

    >>> steel = {"E": 2.0, "nu": 0.25, "assumption": "plane stress"}
    >>> d = approach_to_depth(0.75, P=np.pi, a=1.0, **steel)  # arsinh 3/4 = ln 2; 1/4 * 3/8
    >>> round(float(d - np.log(2)), 12)
    -0.09375
    """
    scale, nu_plane, a = _scale(P, a, E, nu, assumption)
    d = not_negative(d, "depth", "m") / a
    return np.asarray(scale * (np.arcsinh(d) - nu_plane * d / (d + np.sqrt(1 + d**2))))


def approach_to_far_depth(
    d: ArrayLike,
    *,
    P: ArrayLike,
    a: ArrayLike,
    E: ArrayLike,
    nu: ArrayLike,
    assumption: Assumption,
) -> Array:
    r"""Limit of `approach_to_depth` for d much larger than a, with an error of the order (a/d)².

    .. math:: \delta \to \frac{P}{\pi E'}\left[2\ln\frac{2d}{a} - \nu'\right]
    """
    scale, nu_plane, a = _scale(P, a, E, nu, assumption)
    return np.asarray(scale * (np.log(2 * positive(d, "depth", "m") / a) - nu_plane / 2))


def approach_to_centre(*, P: ArrayLike, a: ArrayLike, R: ArrayLike, E_plane: ArrayLike) -> Array:
    r"""Approach [length] of the contact and the centre of a disc loaded at two opposite points.

    .. math:: \delta = \frac{P}{\pi E'}\left[2\ln\frac{4R}{a} - 1\right]

    with E' = `E_plane`. Poisson's ratio has an effect only through E'. The relative error is of the
    order (a/R)²: `disc_series.approach` contains the next term, `disc` all terms.
    """
    P, E_plane = positive(P, "load per length", "N/m"), positive(E_plane, "modulus", "Pa")
    a, R = positive(a, "half-width", "m"), positive(R, "radius", "m")
    if not np.all(a < R):
        raise ValueError(f"the half-width must be less than the radius, got a={a} m, R={R} m")
    return np.asarray(P / (np.pi * E_plane) * (2 * np.log(4 * R / a) - 1))


def _scale(
    P: ArrayLike, a: ArrayLike, E: ArrayLike, nu: ArrayLike, assumption: Assumption
) -> tuple[Array, Array, Array]:
    E_plane, nu_plane = in_plane(positive(E, "Young's modulus", "Pa"), nu, assumption)
    scale = 2 * positive(P, "load per length", "N/m") / (np.pi * E_plane)
    return scale, nu_plane, positive(a, "half-width", "m")
