"""Geometry of a polyhedral ring clutch, and checks that it can be built."""

from dataclasses import dataclass
from math import degrees, pi, sin

from analytic.contact.checks import not_negative, positive
from analytic.polyhedral import expansion, forces


@dataclass(frozen=True)
class PolyhedralParts:
    """Ring, rollers, outer race and hub in the paper's symbols; lengths in m.

    z rollers of diameter d between the ring (d_i through the real corners, fillet rho, outside
    d_e, width b) and the race (D_i inside, D outside, if it matters); the hub touches each flat at
    e from its middle. ValueError for impossible dimensions.
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
            raise ValueError(f"race needs D above D_i={self.D_i:g} m, got D={self.D:g} m")

    @property
    def j_D(self) -> float:
        """Clearance [m] on the diameter."""
        return float(expansion.clearance(D_i=self.D_i, d_e=self.d_e, d=self.d))

    @property
    def d_m(self) -> float:
        """Mean diameter [m] of the ring in the corners."""
        return float(expansion.mean_diameter(d_i=self.d_i, d_e=self.d_e))

    @property
    def D_m(self) -> float | None:
        """Mean diameter [m] of the race, if its outside is known; no equation uses it."""
        if self.D is None:
            return None
        return float(expansion.mean_diameter(d_i=self.D_i, d_e=self.D))

    @property
    def delta_1(self) -> float:
        """Thickness [m] of the ring in the corners, its least."""
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
        """Angle [rad] from the flat's normal to the radius through the hub's contact."""
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
                f"hub must touch the flat: e must be at most {half:g} m, half its length, "
                f"got e={self.e:g} m"
            )

    def hub_must_release(self, phi_1: float) -> None:
        """ValueError unless psi > phi_1 [rad]: otherwise, friction of the hub blocks the ring."""
        if not self.psi > phi_1:
            raise ValueError(
                f"hub locks: psi must exceed the angle of friction, got psi={degrees(self.psi):g} "
                f"deg, phi_1={degrees(phi_1):g} deg; a larger e raises psi"
            )


Parts = PolyhedralParts  # its name in version 0.1
