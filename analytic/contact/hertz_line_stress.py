r"""Stresses in the half plane z > 0 under the elliptic pressure of a line contact.

With w = x + iz and the analytic function

.. math:: \Phi = \sqrt{a^2 - w^2} + i w = \frac{a^2}{\sqrt{a^2 - w^2} - i w}, \qquad
          \Phi' = \frac{i\Phi}{\sqrt{a^2 - w^2}}

the stresses are

.. math::
    \sigma_x + \sigma_z = -\frac{2 p_0}{a}\,\mathrm{Re}\,\Phi, \qquad
    \sigma_z - \sigma_x + 2 i \tau_{xz} = -\frac{2 p_0 z}{a}
    \left(\mathrm{Im}\,\Phi' - i\,\mathrm{Re}\,\Phi'\right).

This is McEwen's solution (Johnson sec. 4.2, Eq. 4.49) without the cancellation error far from the
contact. x runs along the surface from the middle of the contact, z into the body; tension is
positive.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 4.2.
.. [2] E. McEwen, Stresses in elastic cylinders in contact along a generatrix,
   Philosophical Magazine 40 (1949) 454-459.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, Assumption, finite, in_plane, not_negative, positive

GOLDEN = (1 + np.sqrt(5)) / 2


def stresses(
    x: ArrayLike, z: ArrayLike, *, a: ArrayLike, p_0: ArrayLike
) -> tuple[Array, Array, Array]:
    """Stresses sigma_x, sigma_z, tau_xz [stress] at x and depth z, in plane stress or plane strain.

    >>> sx, sz, _ = stresses(0.0, 0.75, a=1.0, p_0=1.0)  # sqrt(1 + z²) = 5/4
    >>> round(float(sx), 12), round(float(sz), 12)  # -(5/4 + 9/20 - 3/2), -1/(5/4)
    (-0.2, -0.8)
    """
    a, p_0 = positive(a, "half-width", "m"), positive(p_0, "peak pressure", "Pa")
    x, z = finite(x, "position", "m") / a, not_negative(z, "depth", "m") / a
    w = x + 1j * np.abs(z)  # a depth of -0.0 would land on the root's other side
    root = -1j * np.sqrt(w - 1) * np.sqrt(w + 1)
    phi = 1 / (root - 1j * w)
    at_edge = root == 0  # where z = 0, too, and the product vanishes
    slope = np.where(at_edge, 0.0, 1j * z * phi / np.where(at_edge, 1.0, root))
    mean, deviator = -p_0 * phi.real, -p_0 * slope.imag
    return mean - deviator, mean + deviator, np.asarray(p_0 * slope.real)


def transverse_stress(
    x: ArrayLike,
    z: ArrayLike,
    *,
    a: ArrayLike,
    p_0: ArrayLike,
    nu: ArrayLike,
    assumption: Assumption,
) -> Array:
    """Normal stress sigma_y out of the plane: nu (sigma_x + sigma_z) in plane strain, else 0."""
    in_plane(1.0, nu, assumption)
    sigma_x, sigma_z, _ = stresses(x, z, a=a, p_0=p_0)
    share = np.asarray(nu) if assumption == "plane strain" else 0.0
    return np.asarray(share * (sigma_x + sigma_z))


def largest_shear_stress(*, a: ArrayLike, p_0: ArrayLike) -> tuple[Array, Array]:
    r"""Largest in-plane shear stress [stress] and its depth [length] below mid-contact.

    On the axis, :math:`\tau/p_0 = t - t^2/\sqrt{1 + t^2}` with t = z/a. The maximum is at
    :math:`t^4 + t^2 = 1`: :math:`t = g^{-1/2}, \tau = g^{-5/2} p_0` with the golden ratio g =
    1.618, that is 0.300 p_0 at 0.786 a.
    """
    a, p_0 = positive(a, "half-width", "m"), positive(p_0, "peak pressure", "Pa")
    return p_0 * GOLDEN**-2.5, a * GOLDEN**-0.5
