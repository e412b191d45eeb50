r"""Singularity of the pressure at a free edge that presses on a flat of the same material.

Consider the axial section at the end face of a roller without crown, on a race that continues
beyond the end: a right-angled corner on a half-plane, without friction. The stresses are
proportional to :math:`r^{\lambda-1}`. The exponent lambda in (0, 1) follows from the condition that
both faces have equal pressures and equal displacements (Williams' eigenfunctions). For the right
angle, :math:`\lambda - 1 = -0.226`. If the roller, too, is replaced by a half-space, the exponent
is :math:`-1/2`. It depends only on the angle: the moduli cancel, because both bodies have the same
material.

References
----------
.. [1] M. L. Williams, Stress singularities resulting from various boundary conditions in angular
   corners of plates in extension, J. Appl. Mech. 19 (1952) 526-528.
.. [2] J. Dundurs, M. S. Lee, Stress concentration at a sharp edge in contact problems, J.
   Elasticity 2 (1972) 109-112.
"""

import numpy as np
from scipy.optimize import brentq

from analytic.contact.checks import Array

HALF_PLANE = np.pi


def edge_exponent(angle: float) -> float:
    """Exponent lambda - 1 of r in the pressure near an edge with this `angle` [rad], at least pi/2.

    Raises ValueError outside [pi/2, pi).

    >>> round(edge_exponent(np.pi / 2), 3)
    -0.226
    """
    if not np.pi / 2 <= angle < HALF_PLANE:
        raise ValueError(f"the angle of the edge must lie in [pi/2, pi), got {angle} rad")

    def gap(p: float) -> float:
        return _opening(p, angle) + _opening(p, HALF_PLANE)

    return float(brentq(gap, 0.5 + 1e-9, 1 - 1e-9)) - 1


def _opening(p: float, angle: float) -> float:
    r"""Outward displacement of the loaded face of a wedge under the pressure r^(p - 1).

    Airy's function :math:`r^{p+1}[c_1\cos(p+1)t + c_2\sin(p+1)t + c_3\cos(p-1)t + c_4\sin(p-1)t]`,
    is loaded at t = 0 and free at t = angle. Only the terms with :math:`\kappa + 1` cause a normal
    displacement of the face. As the shear stress is zero, only :math:`c_4` remains.
    """
    rows: list[Array] = []
    for t in (0.0, angle):
        a, b = (p + 1) * t, (p - 1) * t
        rows.append((p + 1) * p * np.array([np.cos(a), np.sin(a), np.cos(b), np.sin(b)]))
        rows.append(
            p * np.array([(p + 1) * np.sin(a), -(p + 1) * np.cos(a),
                          (p - 1) * np.sin(b), -(p - 1) * np.cos(b)])
        )  # fmt: skip
    return float(np.linalg.solve(np.array(rows), [1.0, 0.0, 0.0, 0.0])[3])
