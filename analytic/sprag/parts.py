"""Dimensions and material of a sprag clutch, which determine its compliance (Eqs. 6 to 8)."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact import hertz_line
from analytic.contact.checks import Array, not_negative, poisson, positive
from analytic.freewheel.rules import require, rollers
from analytic.ring import rotating
from analytic.ring.smeared import race_deflection
from analytic.sprag.compliance import Compliance
from analytic.sprag.compression import sprag_compression
from analytic.sprag.geometry import LogSprag
from analytic.sprag.laws import Law, palmgren_law, plane_law


@dataclass(frozen=True, kw_only=True, eq=False)
class SpragClutchParts:
    """Parts of a clutch: n_s sprags of length l and width b between two rings of one material.

    The rings extend from R_id to R_i and from R_e to R_ed. SI units. The density `rho` [kg/m³] and
    the speed `omega` [rad/s] determine the growth of the outer race. Raises ValueError if a race
    has no wall or sprags overlap.
    """

    sprag: LogSprag
    n_s: int
    l: ArrayLike  # noqa: E741
    b: ArrayLike
    R_id: ArrayLike
    R_ed: ArrayLike
    E: ArrayLike
    nu: float
    rho: ArrayLike = 7850.0
    omega: ArrayLike = 0.0

    def __post_init__(self) -> None:
        R_i, R_e = np.asarray(self.sprag.R_i), np.asarray(self.sprag.R_e)
        positive(self.l, "sprags' length l", "m")
        b, n_s = positive(self.b, "sprags' width b", "m"), rollers(self.n_s)
        R_id, R_ed = positive(self.R_id, "bore R_id", "m"), positive(self.R_ed, "rim R_ed", "m")
        require(R_id < R_i, "the inner race needs R_id below R_i", R_id=R_id, R_i=R_i)
        require(R_ed > R_e, "the outer race needs R_ed above R_e", R_ed=R_ed, R_e=R_e)
        pitch = 2 * R_i * np.sin(np.pi / n_s)
        require(
            b < pitch, "sprags touch each other: b must be below their pitch on the inner race",
            b=b, pitch=pitch,
        )  # fmt: skip
        positive(self.E, "Young's modulus", "Pa")
        poisson(self.nu)
        positive(self.rho, "density", "kg/m³")
        not_negative(self.omega, "speed omega", "rad/s")

    @property
    def E_star(self) -> Array:
        """Contact modulus E* [Pa]."""
        return hertz_line.contact_modulus(
            E_1=self.E, nu_1=self.nu, E_2=self.E, nu_2=self.nu, assumption="plane strain"
        )

    @property
    def R_contact_i(self) -> Array:
        """Relative radius [m] of the spiral on the inner race, at first contact."""
        return hertz_line.relative_radius(R_1=self.sprag.r_i, R_2=self.sprag.R_i)

    @property
    def R_contact_e(self) -> Array:
        """Relative radius [m] of the outer flank in the bore of the outer race."""
        return hertz_line.relative_radius(R_1=self.sprag.r_e, R_2=-np.asarray(self.sprag.R_e))

    @property
    def d_ce(self) -> Array:
        """Growth [m] of the bore of the outer race by rotation (Eq. 8)."""
        omega = np.asarray(self.omega, dtype=np.float64)
        grown = rotating.radial_displacement(
            self.sprag.R_e, r_i=self.sprag.R_e, r_o=self.R_ed, rho=self.rho,
            omega=np.where(omega > 0, omega, 1.0), E=self.E, nu=self.nu,
            assumption="plane stress",
        )  # fmt: skip
        return np.where(omega > 0, grown, 0.0)

    def compliance(self, *, contact_i: Law, contact_e: Law) -> Compliance:
        """Compliance of the clutch with the given contact laws."""
        sprag, (race_i, race_e) = self.sprag, self._races("plane stress")
        return Compliance(
            contact_i=contact_i, contact_e=contact_e, race_i=race_i, race_e=race_e,
            sprag=sprag_compression(
                N=1.0, R_i=sprag.R_i, R_e=sprag.R_e, b=self.b, l=self.l, E=self.E
            ),
            d_ce=self.d_ce,
        )  # fmt: skip

    def _races(self, ends: Literal["plane stress", "plane strain"]) -> tuple[Array, Array]:
        """Compliances [m/N] of both races as rings in plane stress or plane strain (Eq. 6)."""
        sprag, P = self.sprag, 1 / np.asarray(self.l)
        inner = race_deflection(
            P=P, n=self.n_s, r_i=self.R_id, r_o=sprag.R_i, E=self.E, nu=self.nu, loaded="rim",
            ends=ends,
        )  # fmt: skip
        outer = race_deflection(
            P=P, n=self.n_s, r_i=sprag.R_e, r_o=self.R_ed, E=self.E, nu=self.nu, loaded="bore",
            ends=ends,
        )  # fmt: skip
        return inner, outer

    def palmgren(self) -> Compliance:
        """Compliance with Palmgren's law at both contacts."""
        law = palmgren_law(l=self.l)
        return self.compliance(contact_i=law, contact_e=law)

    def plane(self) -> Compliance:
        """Compliance of long bodies (plane strain) with Hertz's line contacts.

        The deflection of the sprag is taken from each contact to half the height of the sprag. It
        already contains the compression as a bar, which Eq. 7 would add a second time. The races
        deflect locally down to the depth of their walls, and as rings.
        """
        sprag, half = self.sprag, (np.asarray(self.sprag.R_e) - np.asarray(self.sprag.R_i)) / 2
        inner = plane_law(
            l=self.l, r=sprag.r_i, R=sprag.R_i, E=self.E, nu=self.nu, depth_sprag=half,
            depth_race=np.asarray(sprag.R_i) - np.asarray(self.R_id),
        )  # fmt: skip
        outer = plane_law(
            l=self.l, r=sprag.r_e, R=-np.asarray(sprag.R_e), E=self.E, nu=self.nu,
            depth_sprag=half, depth_race=np.asarray(self.R_ed) - np.asarray(sprag.R_e),
        )  # fmt: skip
        race_i, race_e = self._races("plane strain")
        return Compliance(
            contact_i=inner, contact_e=outer, race_i=race_i, race_e=race_e, sprag=0.0,
            d_ce=self.d_ce,
        )  # fmt: skip


Parts = SpragClutchParts  # its name in version 0.1
