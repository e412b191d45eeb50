r"""Geometry of the polyhedral ring: a polygonal bore with rounded corners and a circular rim.

The middle of one flat lies on the x axis (theta = 0), a corner at theta = pi/z. The corner diameter
d_i is measured at the bottom of the fillet. The polygon without fillets has

.. math:: R_u = \frac{d_i}{2} + \rho\left(\frac{1}{\cos(\pi/z)} - 1\right), \qquad
          \text{apothem } R_u\cos\frac{\pi}{z}.

Points of the plane are complex numbers. Any consistent unit of length.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array, positive

Complex = NDArray[np.complex128]


@dataclass(frozen=True, kw_only=True)
class Sector:
    """Ring of z equal sectors, represented by one half sector, 0 <= theta <= pi/z.

    >>> hexagon = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> round(hexagon.apothem, 4), round(hexagon.straight, 4)
    (31.4449, 17.0)
    """

    z: int  # corners
    d_e: float  # outside diameter
    d_i: float  # corner diameter, at the fillet
    rho: float  # fillet radius

    def __post_init__(self) -> None:
        if not (float(self.z).is_integer() and self.z >= 3):
            raise ValueError(
                f"the number of corners must be an integer of at least 3, got z={self.z}"
            )
        positive(self.d_e, "the outside diameter d_e", "m")
        positive(self.d_i, "the corner diameter d_i", "m")
        positive(self.rho, "the fillet radius rho", "m")
        if self.d_i >= self.d_e:
            raise ValueError(
                f"the wall vanishes: d_i must be below d_e, got d_i={self.d_i} m, d_e={self.d_e} m"
            )
        if self.rho >= self.d_i / 2:
            raise ValueError(
                f"fillet radius rho must be less than d_i/2, got rho={self.rho} m, d_i={self.d_i} "
                "m: the fillets leave no flat"
            )

    @property
    def half_angle(self) -> float:
        """Half angle pi/z [rad] of a sector."""
        return np.pi / self.z

    @property
    def r_e(self) -> float:
        """Outside radius [length]."""
        return self.d_e / 2

    @property
    def R_u(self) -> float:
        """Distance [length] of the corners of the polygon without fillets from the centre."""
        return float(self.d_i / 2 + self.rho * (1 / np.cos(self.half_angle) - 1))

    @property
    def apothem(self) -> float:
        """Distance [length] of the flats from the centre."""
        return float(self.R_u * np.cos(self.half_angle))

    @property
    def fillet_centre(self) -> float:
        """Distance [length] of the centre of the fillet from that of the ring."""
        return self.d_i / 2 - self.rho

    @property
    def straight(self) -> float:
        """Half the straight length [length] of a flat, without the fillets."""
        return float(self.fillet_centre * np.sin(self.half_angle))

    @property
    def half_bore(self) -> float:
        """Arc length [length] of the bore of a half sector: half a flat and half a fillet."""
        return float(self.straight + self.rho * self.half_angle)

    def bore(self, s: Array) -> Complex:
        """Points of the bore at the arc length s from the middle of the flat, up to `half_bore`."""
        turn = (s - self.straight) / self.rho
        arc = self.fillet_centre * np.exp(1j * self.half_angle) + self.rho * np.exp(1j * turn)
        return np.where(s <= self.straight, self.apothem + 1j * s, arc)

    def normal(self, s: Array) -> Complex:
        """Unit normals into the ring at the arc length s from mid-flat."""
        turn = np.clip((s - self.straight) / self.rho, 0, self.half_angle)
        return np.asarray(np.exp(1j * turn))
