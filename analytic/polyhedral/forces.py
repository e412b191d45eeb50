r"""Forces of pressure and hub on the polyhedral ring and its rollers (Belcin et al., Eqs. 13-16).

The middle of the flat lies under a roller, at the distance a (apothem) from the axis. The hub
touches the flat at the distance e from mid-flat, at the angle psi from its normal and at the radius
r + r_1:

.. math:: \tan\psi = \frac{e}{a}, \qquad r + r_1 = \frac{a}{\cos\psi}, \qquad
    a = \frac{d_i}{2} \cos\frac{\pi}{z} + \rho \left(1 - \cos\frac{\pi}{z}\right)

with the fillet radius rho of the corner (sharp corners in the paper); d_i is the diameter through
the rounded corners. The angle of the hub force R is phi_1 with the normal and psi + phi_1 with the
radius. The resultant of the pressure between two corners is that on the chord:

.. math:: F = p_2 b d_i \sin\frac{\pi}{z}, \qquad
    F_s = \frac{M_t}{z (r + r_1) \tan(\psi + \varphi_1)}, \qquad
    R = \frac{F_s}{\cos(\psi + \varphi_1)}, \qquad N = F + R \cos(\gamma + \varphi_1)

gamma = 0 projects R on the normal of the flat at the roller; gamma = psi (first design of the
paper) projects R on the radius through the hub contact. N neglects that the hoop force of the ring
carries a part of the load.

Angles in rad, otherwise any consistent units.

References
----------
.. [1] O. Belcin, I. Turcu, M. Pustan, Freewheeling Clutch and Polyhedral Ring, Eqs. 13-16.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, not_negative, positive


def apothem(*, d_i: ArrayLike, z: ArrayLike, rho: ArrayLike = 0.0) -> Array:
    """Distance [length] of the flats from the axis; rho must be less than d_i/2.

    >>> a = apothem(d_i=2.0, z=3, rho=[0.0, 0.5])
    >>> a.round(12).tolist()  # half of d_i/2, and half of the fillet more
    [0.5, 0.75]
    """
    d_i, cos = positive(d_i, "corner diameter d_i", "m"), np.cos(np.pi / corners(z))
    rho = not_negative(rho, "fillet rho", "m")
    if not np.all(rho < d_i / 2):
        raise ValueError(
            f"fillet rho must be less than d_i/2={d_i / 2} m, got {rho} m: it leaves no flat"
        )
    return np.asarray(d_i / 2 * cos + rho * (1 - cos))


def half_flat(*, d_i: ArrayLike, z: ArrayLike, rho: ArrayLike = 0.0) -> Array:
    """Distance [length] from the middle of a flat to its end, where the fillet begins."""
    a = apothem(d_i=d_i, z=z, rho=rho)
    return np.asarray((a - np.asarray(rho, dtype=np.float64)) * np.tan(np.pi / corners(z)))


def contact_angle(*, e: ArrayLike, apothem: ArrayLike) -> Array:
    """Angle psi [rad] between the normal of the flat and the radius through the hub contact."""
    e = positive(e, "distance e of the hub's contact", "m")
    return np.asarray(np.arctan(e / positive(apothem, "apothem", "m")))


def contact_radius(*, apothem: ArrayLike, psi: ArrayLike) -> Array:
    """Radius r + r_1 [length] of the hub contact; it is d_i/2 only in a sharp corner."""
    return np.asarray(positive(apothem, "apothem", "m") / np.cos(hub_angles(psi, 0.0)[0]))


def pressure_force(*, p_2: ArrayLike, b: ArrayLike, d_i: ArrayLike, z: ArrayLike) -> Array:
    """Resultant F [force] of the pressure on one side of the bore, including fillets (Eq. 13).

    >>> float(pressure_force(p_2=3.0, b=2.0, d_i=5.0, z=6).round(12))  # a hexagon's side is d_i/2
    15.0
    """
    p_2, b = finite(p_2, "pressure p_2", "Pa"), positive(b, "width b", "m")
    d_i = positive(d_i, "corner diameter d_i", "m")
    return np.asarray(p_2 * b * d_i * np.sin(np.pi / corners(z)))


def radial_force(
    *, M_t: ArrayLike, z: ArrayLike, lever: ArrayLike, psi: ArrayLike, phi_1: ArrayLike
) -> Array:
    """Radial component F_s [force] of the hub force per corner (Eq. 14; Eq. 15: lever d_i/2)."""
    psi, phi_1 = hub_angles(psi, phi_1)
    T = np.asarray(M_t) / (corners(z) * positive(lever, "lever of the hub's contact", "m"))
    return np.asarray(T / np.tan(psi + phi_1))


def contact_force(*, F_s: ArrayLike, psi: ArrayLike, phi_1: ArrayLike) -> Array:
    """Force R [force] between hub and flat from the radial component F_s (in Eq. 16)."""
    psi, phi_1 = hub_angles(psi, phi_1)
    return np.asarray(F_s / np.cos(psi + phi_1))


def normal_force(*, F: ArrayLike, R: ArrayLike, phi_1: ArrayLike, gamma: ArrayLike) -> Array:
    """Normal force N [force] on a roller from pressure and hub (Eq. 16).

    gamma [rad] is the angle from the normal of the flat to the direction on which R is projected.
    """
    return np.asarray(F + np.asarray(R) * np.cos(np.asarray(gamma) + np.asarray(phi_1)))


def corners(z: ArrayLike) -> Array:
    """Number of corners (and rollers) as an array; raises ValueError unless integer and >= 3."""
    z = np.asarray(z, dtype=np.float64)
    if not np.all((z >= 3) & (z == np.round(z)) & np.isfinite(z)):
        raise ValueError(f"the number of corners must be an integer of at least 3, got z={z}")
    return z


def hub_angles(psi: ArrayLike, phi_1: ArrayLike) -> tuple[Array, Array]:
    """Angles psi and phi_1 [rad] as arrays; raises ValueError unless the hub can push outwards."""
    psi, phi_1 = np.asarray(psi, dtype=np.float64), np.asarray(phi_1, dtype=np.float64)
    if not np.all((psi > 0) & (phi_1 >= 0) & (psi + phi_1 < np.pi / 2)):
        raise ValueError(
            "the hub force requires psi > 0, phi_1 >= 0 and psi + phi_1 < 90 deg, got "
            f"psi={np.degrees(psi)} deg, phi_1={np.degrees(phi_1)} deg"
        )
    return psi, phi_1
