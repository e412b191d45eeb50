"""A wall of a press fit under its pressures: stresses and displacements of its two surfaces."""

from dataclasses import dataclass

from numpy.typing import ArrayLike

from analytic.contact.checks import Array, Assumption
from analytic.contact.press_fit import Wall


@dataclass(frozen=True, kw_only=True)
class LoadedWall:
    """A `wall` under pressures [stress] p_i in the bore and p_o on the rim.

    >>> shaft = Wall(r_i=0.0, r_o=1.0, E=2.0, nu=0.25)
    >>> loaded = LoadedWall(wall=shaft, p_i=0.0, p_o=1.0, assumption="plane stress")
    >>> loaded.hoop_bore, loaded.hoop_rim, loaded.u_rim
    (-1.0, -1.0, -0.375)
    """

    wall: Wall
    p_i: float
    p_o: float
    assumption: Assumption

    @property
    def hoop_bore(self) -> float:
        """Hoop stress [stress] at the bore; for a solid shaft, in its centre."""
        return float(self.stresses(self.wall.r_i)[1])

    @property
    def hoop_rim(self) -> float:
        """Hoop stress [stress] at the rim."""
        return float(self.stresses(self.wall.r_o)[1])

    @property
    def u_bore(self) -> float:
        """Displacement [length] of the bore, outward positive."""
        return self._displacement(self.wall.r_i)

    @property
    def u_rim(self) -> float:
        """Displacement [length] of the rim, outward positive."""
        return self._displacement(self.wall.r_o)

    @property
    def strain_energy(self) -> float:
        """Strain energy [stress x length²] per unit axial length."""
        return self.wall.strain_energy(p_i=self.p_i, p_o=self.p_o, assumption=self.assumption)

    def stresses(self, r: ArrayLike) -> tuple[Array, Array]:
        """Radial and hoop stress [stress] at the radii r."""
        return self.wall.stresses(r, p_i=self.p_i, p_o=self.p_o)

    def _displacement(self, r: float) -> float:
        found = self.wall.displacement(r, p_i=self.p_i, p_o=self.p_o, assumption=self.assumption)
        return float(found)
