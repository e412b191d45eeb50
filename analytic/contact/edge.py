r"""Singularity of the pressure at a free edge that presses on a flat of the same material.

Near the end face of a roller without crown, on a race that goes on, the section along the axis is
a right angle on a half-plane, without friction. Stresses go as :math:`r^{\lambda-1}` with the
lambda in (0, 1) for which both bodies, free of tractions but for equal pressures, open by equal
amounts (Williams' eigenfunctions). For the right angle :math:`\lambda - 1 = -0.226`; a half-space
that goes on beyond the end, too, has :math:`-1/2`. Only the angle is relevant: both bodies being of
one material, their moduli cancel.

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
    """Exponent lambda - 1 of r in the pressure of an edge of this `angle` [rad], pi/2 or more.

    ValueError outside [pi/2, pi).

    >>> round(edge_exponent(np.pi / 2), 3)
    -0.226
    """
    if not np.pi / 2 <= angle < HALF_PLANE:
        raise ValueError(f"the edge's angle must lie in [pi/2, pi), got {angle} rad")

    def gap(p: float) -> float:
        return _opening(p, angle) + _opening(p, HALF_PLANE)

    return float(brentq(gap, 0.5 + 1e-9, 1 - 1e-9)) - 1


def _opening(p: float, angle: float) -> float:
    r"""Displacement of a wedge's loaded face, away from it, for r^(p - 1) of unit pressure.

    Airy's function :math:`r^{p+1}[c_1\cos(p+1)t + c_2\sin(p+1)t + c_3\cos(p-1)t +
    c_4\sin(p-1)t]`, loaded at t = 0 and free at t = angle. On the face only the parts with
    :math:`\kappa + 1` move it along its normal: :math:`c_4` alone, the shear being zero.
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
