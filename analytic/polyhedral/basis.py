r"""Functions of z-fold symmetry, singular in the hole or in the image of the hole beyond the rim.

A potential of the ring is :math:`\phi = \zeta F(\omega)` with :math:`\omega = (\zeta/r_e)^z` and F
real on the real axis. One sector of the ring is one revolution of omega. F is expanded in

- powers :math:`(\omega\,\omega_a)^k` and :math:`(\omega_a/\omega)^k`, where omega_a is omega at the
  apothem,
- simple poles at omega_j and at their images 1/omega_j in the rim.

The analytic continuation of the walls into the hole jumps where the continuations of flat and
fillet meet: along the radii of the fillet to its tangent points, and from its centre along the ray
through the corner. The poles are placed along these lines. Towards the tangent points, where the
curvature jumps and the solution has a weak singularity, their spacing decreases exponentially [1]_.

References
----------
.. [1] A. Gopal, L. N. Trefethen, Solving Laplace problems with corner singularities via rational
   functions, SIAM J. Numer. Anal. 57 (2019) 2074-2094, DOI 10.1137/19M125947X.
"""

from dataclasses import dataclass

import numpy as np

from analytic.contact.checks import Array
from analytic.polyhedral.sector import Complex, Sector

DEEPEST = 200.0  # -ln omega_a, whose square must be a number
INSIDE = 40.0  # ln of the omega_a over that of a pole, beyond which poles are powers
CLOSEST = 1e-4  # relative to the arc: distance of the last pole from its tangent point


@dataclass(frozen=True)
class Basis:
    """Basis functions of the potential: powers, real poles on the corner rays, pairs of poles.

    `pairs` contains one pole of each conjugate pair.
    """

    z: int
    omega_a: float
    powers: int
    rays: Array
    pairs: Complex

    def values(self, omega: Complex) -> tuple[Complex, Complex]:
        """Values F and z omega F' of every function at the points omega, (points, functions)."""
        parts = [self._powers(omega)]
        parts += [_pole(omega, p) for p in (self.rays, 1 / self.rays)]
        for p in (self.pairs, 1 / self.pairs):
            (one, d_one), (other, d_other) = _pole(omega, p), _pole(omega, p.conj())
            parts += [(one + other, d_one + d_other), (1j * (one - other), 1j * (d_one - d_other))]
        return np.hstack([F for F, _ in parts]), self.z * np.hstack([dF for _, dF in parts])

    def _powers(self, omega: Complex) -> tuple[Complex, Complex]:
        k = np.arange(self.powers + 1)
        up, down = (omega * self.omega_a)[:, None] ** k, (self.omega_a / omega)[:, None] ** k[1:]
        return np.hstack([up, down]), np.hstack([k * up, -k[1:] * down])


def basis_of(sector: Sector, *, density: float) -> Basis:
    """Basis with `density` poles per e-fold increase of the distance from the corner.

    Raises ArithmeticError if omega at the apothem is too small for floating-point numbers.
    """
    if sector.z * np.log(sector.r_e / sector.apothem) > DEEPEST:
        raise ArithmeticError(
            "the series cannot be evaluated for this number of corners and wall thickness: "
            f"z={sector.z}, d_e={sector.d_e:g} m, d_i={sector.d_i:g} m; use a round bore"
        )
    corner = np.exp(1j * sector.half_angle)
    arc = sector.rho * sector.half_angle
    sharpness = density * max(1.0, 0.8 / np.tan(np.pi / 2 - sector.half_angle))
    wall = sector.r_e - sector.d_i / 2
    near, far = 0.6 * min(sector.rho, arc, 2.5 * wall), 0.35 * sector.d_i
    far = min(far, sector.d_i / 2 - sector.apothem * np.exp(-INSIDE / sector.z))
    depth = np.geomspace(near, far, 2 + int(sharpness * np.log(far / near)))
    radius = (sector.d_i / 2 - depth) / sector.r_e
    reach = arc * np.geomspace(CLOSEST, 0.8, int(2 + density * np.log(1 / CLOSEST) / 2))
    pairs = (sector.apothem + 1j * sector.straight - reach) / sector.r_e
    return Basis(
        z=sector.z,
        omega_a=float((sector.apothem / sector.r_e) ** sector.z),
        powers=int(5 * density),
        rays=((radius * corner) ** sector.z).real,
        pairs=np.asarray(pairs**sector.z, dtype=np.complex128),
    )


def _pole(omega: Complex, p: Array | Complex) -> tuple[Complex, Complex]:
    """Function p/(omega - p), and omega times its derivative."""
    share = 1 / (omega[:, None] - p)
    return p * share, -p * omega[:, None] * share**2
