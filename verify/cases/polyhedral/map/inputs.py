"""Inputs of the map of K: rings with different numbers of flats, walls and fillets."""

from typing import Self

import numpy as np
from pydantic import model_validator

from verify.case import given
from verify.cases.polyhedral.inputs import PolygonRing, RoundRing

FLATS = (3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 24, 48)
WALLS = (0.0125, 0.025, 0.05, 0.1, 0.15, 0.2)  # walls over the outer diameter
SHARES = (0.125, 0.25, 0.5, 1.0, 2.0)  # fillet over wall
THICKEST = 0.15  # wall over outer diameter
PRESSED = 1.5  # over the touching pressure, for the load-transfer ratio
Size = tuple[int, float, float]  # flats, wall [m], fillet [m]


class MapInputs(RoundRing):
    """Inputs of rings with varied number of flats, wall and fillet.

    ρ is fixed in the map over walls, δ_1 in the map over fillets.
    """

    rho: float = given("2 mm", "mm", "ρ", "fillet radius of the corners of the bore", gt=0, le=1e4)
    d: float = given("10 mm", "mm", "d", "diameter of the rollers", gt=0, le=1e5)

    @model_validator(mode="after")
    def _varied(self) -> Self:
        thickest = min(THICKEST, 0.45 / (1 + max(SHARES)))
        if self.delta_1 > thickest * self.d_e:
            raise ValueError(
                f"the fillets of the map leave no flat: δ_1 must be at most {thickest:.3g} d_e = "
                f"{thickest * self.d_e * 1e3:.4g} mm, got {self.delta_1 * 1e3:g} mm"
            )
        largest = 0.9 * (0.5 - max(WALLS)) * self.d_e
        if self.rho > largest:
            raise ValueError(
                f"the fillets leave no flat in the thickest walls of the map: ρ must be at most "
                f"{largest * 1e3:.4g} mm, got {self.rho * 1e3:g} mm"
            )
        return self

    @property
    def by_wall(self) -> list[Size]:
        """Rings of the first map, row by row, with the fillet of the inputs."""
        return [(z, share * self.d_e, self.rho) for share in WALLS for z in FLATS]

    @property
    def by_fillet(self) -> list[Size]:
        """Rings of the second map, row by row, with the wall of the inputs."""
        return [(z, self.delta_1, share * self.delta_1) for share in SHARES for z in FLATS]

    @property
    def at_middle(self) -> list[Size]:
        """Rings with the wall and fillet of the inputs, one for each number of flats."""
        return [(z, self.delta_1, self.rho) for z in FLATS]

    def ring(self, size: Size) -> PolygonRing:
        """The ring of the map with the given `size`: number of flats, wall, fillet radius."""
        z, delta_1, rho = size
        return PolygonRing(
            d_e=self.d_e, j_D=self.j_D, E=self.E, nu=self.nu, z=z, delta_1=delta_1, rho=rho
        )

    def touching(self, wall: float) -> float:
        """Pressure [Pa] that closes the clearance of a thin round ring with this wall [m]."""
        return 2 * wall * self.E * self.j_D / ((self.d_e - 2 * wall) * (self.d_e - wall))

    def roller(self, z: int) -> float:
        """Diameter [m] of z rollers: d of the inputs, or less if such rollers do not fit."""
        sine = float(np.sin(np.pi / z))
        return min(self.d, 0.9 * (self.d_e + self.j_D) * sine / (1 - sine))
