"""Geometry of a polyhedral ring clutch, and checks that it can be built."""

from dataclasses import dataclass
from math import degrees, pi, sin

from analytic.contact.checks import not_negative, positive
from analytic.polyhedral import expansion, forces


@dataclass(frozen=True)
class PolyhedralParts:
    """Dimensions of ring, rollers, outer race and hub in the symbols of the paper [m].

    z rollers of diameter d are located between ring and race. Ring: d_i through the rounded
    corners, fillet radius rho, outside diameter d_e, width b. Race: D_i inside and, if needed, D
    outside. The hub touches each flat at the distance e from its middle. Raises ValueError for
    impossible dimensions.
    """

    z: int
    d_i: float
    d_e: float
    D_i: float
    d: float
    b: float
    e: float
    rho: float = 0.0
    D: float | None = None

    def __post_init__(self) -> None:
        positive(self.b, "width b of the ring", "m")
        not_negative(self.rho, "fillet rho", "m")
        forces.apothem(d_i=self.d_i, z=self.z, rho=self.rho)
        expansion.mean_diameter(d_i=self.d_i, d_e=self.d_e)
        self._rollers_fit()
        self._hub_touches_the_flat()
        if self.D is not None and not self.D_i < self.D:
            raise ValueError(f"D of the race must exceed D_i={self.D_i:g} m, got D={self.D:g} m")

    @property
    def j_D(self) -> float:
        """Diametral clearance j_D [m]."""
        return float(expansion.clearance(D_i=self.D_i, d_e=self.d_e, d=self.d))

    @property
    def d_m(self) -> float:
        """Mean diameter [m] of the ring at the corners."""
        return float(expansion.mean_diameter(d_i=self.d_i, d_e=self.d_e))

    @property
    def D_m(self) -> float | None:
        """Mean diameter [m] of the race, which no equation uses; None if D is not given."""
        if self.D is None:
            return None
        return float(expansion.mean_diameter(d_i=self.D_i, d_e=self.D))

    @property
    def delta_1(self) -> float:
        """Thickness [m] of the ring at the corners, where the ring is thinnest."""
        return (self.d_e - self.d_i) / 2

    @property
    def delta_mid(self) -> float:
        """Thickness [m] of the ring in the middle of a flat, under the roller."""
        return self.d_e / 2 - self.apothem

    @property
    def beta(self) -> float:
        """Angle [rad] between neighbouring rollers."""
        return 2 * pi / self.z

    @property
    def apothem(self) -> float:
        """Distance [m] of the flats from the axis."""
        return float(forces.apothem(d_i=self.d_i, z=self.z, rho=self.rho))

    @property
    def psi(self) -> float:
        """Angle psi [rad] from the normal of the flat to the radius through the hub contact."""
        return float(forces.contact_angle(e=self.e, apothem=self.apothem))

    def _rollers_fit(self) -> None:
        if not self.j_D > 0:
            raise ValueError(
                f"rollers do not fit: d must be below (D_i - d_e)/2={(self.D_i - self.d_e) / 2:g} m"
                f", got d={self.d:g} m"
            )
        pitch = (self.D_i - self.d) * sin(pi / self.z)
        if not self.d < pitch:
            raise ValueError(
                f"neighbouring rollers overlap: d must be below (D_i - d) sin(pi/z)={pitch:g} m "
                f"with z={self.z}, got d={self.d:g} m"
            )

    def _hub_touches_the_flat(self) -> None:
        half = float(forces.half_flat(d_i=self.d_i, z=self.z, rho=self.rho))
        positive(self.e, "distance e of the hub's contact from the middle of the flat", "m")
        if not self.e <= half * (1 + 1e-12):
            raise ValueError(
                f"hub must touch the flat: e must be at most {half:g} m, half the "
                f"length of the flat, got e={self.e:g} m"
            )

    def hub_must_release(self, phi_1: float) -> None:
        """Raise ValueError unless psi > phi_1 [rad]; otherwise, hub friction blocks the ring."""
        if not self.psi > phi_1:
            raise ValueError(
                f"hub locks: psi must exceed the friction angle, got psi={degrees(self.psi):g} "
                f"deg, phi_1={degrees(phi_1):g} deg; a larger e increases psi"
            )


Parts = PolyhedralParts  # its name in version 0.1
