"""Contact modulus and relative radius of two bodies in contact; any consistent units."""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, Assumption, pair_in_plane, positive


def contact_modulus(
    *, E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike, assumption: Assumption
) -> Array:
    r"""Contact modulus E* [stress], :math:`1/E^* = 1/E_1' + 1/E_2'`.

    E' is :math:`E/(1-\nu^2)` in plane strain (and in point contact), E in plane stress. One body
    may be rigid (infinite `E`); its `nu` then has no effect. Raises ValueError if a modulus is not
    positive.

    >>> flat = {"E_2": np.inf, "nu_2": 0.0, "assumption": "plane strain"}
    >>> float(contact_modulus(E_1=3.0, nu_1=-0.5, **flat))  # E / (1 - 1/4)
    4.0
    """
    soft_1, _, soft_2, _ = pair_in_plane(E_1, nu_1, E_2, nu_2, assumption)
    return np.asarray(1 / (soft_1 + soft_2))


def relative_radius(*, R_1: ArrayLike, R_2: ArrayLike) -> Array:
    """Relative radius R [length], 1/R = 1/R_1 + 1/R_2.

    R_2 is infinite for a flat and negative for the bore of a ring. Raises ValueError unless R_1 > 0
    and the bore is larger than R_1.

    >>> relative_radius(R_1=2.0, R_2=[-4.0, np.inf, 2.0]).tolist()  # in a bore, on a flat, a pair
    [4.0, 2.0, 1.0]
    """
    R_1 = positive(R_1, "the roller's radius", "m")
    R_2 = np.asarray(R_2, dtype=np.float64)
    if not np.all((R_2 > 0) | (-R_2 > R_1)):
        raise ValueError(
            f"R_2 must be positive or, for a bore, less than -R_1: got R_1={R_1} m, R_2={R_2} m"
        )
    return np.asarray(1 / (1 / R_1 + 1 / R_2))
