"""Roller freewheel: geometry, width and materials of its parts."""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact import hertz_line
from analytic.contact.checks import Array, in_plane, not_negative, positive
from analytic.freewheel.cam import Cam
from analytic.freewheel.geometry import InnerCam
from analytic.freewheel.rules import require

Star = Literal["annulus", "half space"]


@dataclass(frozen=True, kw_only=True, eq=False)
class ContactMaterial:
    """Young's modulus [stress], infinite for a rigid body, and Poisson's ratio of a part."""

    E: ArrayLike
    nu: ArrayLike

    @cached_property
    def plane(self) -> tuple[Array, Array]:
        """Elastic constants E' and nu' of plane strain."""
        return in_plane(self.E, self.nu, "plane strain")


Material = ContactMaterial  # its name in version 0.1


@dataclass(frozen=True, kw_only=True, eq=False)
class RollerClutch:
    """Cam, rollers of length L, inner part of bore radius r_b and outer part of rim radius R_a.

    The star of an inner cam is clamped on its bore. A shaft has a free bore and may be solid
    (r_b = 0). The rim is free. `star` selects the compliance model of the star, see `compliance`.
    Raises ValueError if a part has no wall.
    """

    cam: Cam
    L: ArrayLike
    r_b: ArrayLike
    R_a: ArrayLike
    roller: ContactMaterial
    inner: ContactMaterial
    outer: ContactMaterial
    star: Star = "annulus"

    def __post_init__(self) -> None:
        positive(self.L, "rollers' length L", "m")
        r_b = not_negative(self.r_b, "bore r_b", "m")
        R_a = positive(self.R_a, "rim R_a", "m")
        star = isinstance(self.cam, InnerCam)
        solid, hollow = (
            (self.cam.flat, self.cam.race) if star else (self.cam.race, self._corner_distance)
        )
        inner, outer = ("flats X", "bore R") if star else ("shaft R_s", "flats' corners")
        require(r_b < solid, f"inner part needs r_b below its {inner}", r_b=r_b, limit=solid)
        require(
            (r_b > 0) | (not star), "a star is clamped on its bore: r_b must be positive", r_b=r_b
        )
        require(R_a > hollow, f"outer part needs R_a above its {outer}", R_a=R_a, limit=hollow)
        if self.star not in get_args(Star):
            raise ValueError(f"star must be one of {', '.join(get_args(Star))}, got {self.star!r}")

    @property
    def _corner_distance(self) -> Array:
        return np.asarray(self.cam.flat / np.cos(np.pi / self.cam.count))

    @cached_property
    def _contacts(self) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        """Relative radius and contact modulus of the inner and of the outer contact."""
        r, race = self.cam.roller, self.cam.race
        radii = [hertz_line.relative_radius(R_1=r, R_2=-self.cam.sense * race), r]
        if isinstance(self.cam, InnerCam):
            radii.reverse()
        moduli = [
            hertz_line.contact_modulus(
                E_1=self.roller.E, nu_1=self.roller.nu, E_2=part.E, nu_2=part.nu,
                assumption="plane strain",
            )
            for part in (self.inner, self.outer)
        ]  # fmt: skip
        (R_i, R_o), (E_i, E_o) = radii, moduli
        return (R_i, E_i), (R_o, E_o)

    def half_widths(self, P: ArrayLike) -> tuple[Array, Array]:
        """Hertz's half-widths a_i, a_o [length] under P = N/L [force/length]; 0 without load."""
        P = np.asarray(P, dtype=np.float64)
        a_i, a_o = (np.sqrt(4 * P * R / (np.pi * E)) for R, E in self._contacts)
        return np.asarray(a_i), np.asarray(a_o)

    def pressures(self, P: ArrayLike) -> tuple[Array, Array]:
        """Hertz's peak pressures p_i, p_o [stress] under P = N/L [force/length]; 0 without load."""
        P = np.asarray(P, dtype=np.float64)
        p_i, p_o = (np.sqrt(P * E / (np.pi * R)) for R, E in self._contacts)
        return np.asarray(p_i), np.asarray(p_o)

    def loads_at_pressure(self, p: ArrayLike) -> tuple[Array, Array]:
        """Loads P = N/L [force/length] at which inner and outer contact have peak pressure p."""
        p = positive(p, "pressure", "Pa")
        P_i, P_o = (p**2 * np.pi * R / E for R, E in self._contacts)
        return np.asarray(P_i), np.asarray(P_o)

    def loads_at_half_width(self, a: ArrayLike) -> tuple[Array, Array]:
        """Loads P = N/L [force/length] at which inner and outer contact have the half-width a."""
        a = positive(a, "half-width", "m")
        P_i, P_o = (a**2 * np.pi * E / (4 * R) for R, E in self._contacts)
        return np.asarray(P_i), np.asarray(P_o)


Clutch = RollerClutch  # its name in version 0.1
