r"""Expected errors of Eq. 6 of Huang 2018 and of Hertz's approach, for a race under n loads.

Eq. 6 gives the mean deflection of the Fourier ring. The formula adds the approach h_a. The
reference is the deflection u at a place, minus the local approach h. Therefore, the error is

.. math:: m = \frac{\bar u + h_a}{u - h} - 1 .

Both approaches are integrated along the axis of the contact from McEwen's stresses.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 4.2.
"""

import numpy as np
from scipy.integrate import quad

ACCEPTED = 1e-3  # of finite elements against the Fourier ring
PART = 0.05  # relative to the displacement at a load: a ratio to less has no meaning

Interval = tuple[float, float]


def smeared_error(
    *, mean: float, at: float, load: float, indentation: float = 0.0, added: float = 0.0
) -> Interval | None:
    """Interval of the error of the displacement of a loaded wall by Eq. 6.

    The formula is `mean` + `added`, and the reference is `at` - `indentation`. The displacements
    [length] are those of the loaded wall: `mean` by Eq. 6, `at` at the evaluated place, and `load`
    under a load. The relative tolerance is ACCEPTED. None if `at` - `indentation` is less than PART
    times `load`.

    >>> low, high = smeared_error(mean=1.1, at=1.5, load=1.5, indentation=0.5)
    >>> round(low, 6), round(high, 6)
    (0.0989, 0.1011)
    """
    reference = at - indentation
    if abs(reference) < PART * load:
        return None
    ratio = (mean + added) / reference
    slack = ACCEPTED * abs(ratio)
    return ratio - 1 - slack, ratio - 1 + slack


def integrated_dent(depth: float, *, P: float, a: float, E: float, nu: float) -> float:
    """Shortening [length] of the line from mid-contact to the point at `depth`; plane stress.

    The body is a half plane. The load P per length is elliptic over the half-width a.
    """
    p_0 = 2 * P / (np.pi * a)

    def strain(z: float) -> float:
        root = np.hypot(a, z)
        sigma_z = -p_0 * a / root
        sigma_x = -p_0 * ((a**2 + 2 * z**2) / (a * root) - 2 * z / a)
        return float(sigma_z - nu * sigma_x) / E

    return -float(quad(strain, 0.0, depth, points=(a,))[0])
