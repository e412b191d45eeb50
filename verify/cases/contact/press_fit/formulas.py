"""Formulas of a press fit: two walls (Lamé) under the pressure that closes the interference."""

from typing import Any

import numpy as np

from analytic.contact.loaded_wall import LoadedWall
from analytic.contact.press_fit import (
    Wall,
    contact_pressures,
    interferences_lost,
    pressure_of_overlap,
)
from verify.case import Quantity, shared
from verify.cases.contact.press_fit.inputs import FITS, FitInputs

LAME = "Lamé; basis of Eq. 6"


class FitFormulas(FitInputs):
    """Pressure, stresses and displacements of a press fit of two walls."""

    @Quantity(
        "c_i", "µm/MPa", "compliance of the inner wall's rim, plane stress", role="step",
        source=LAME,
        tex=r"\frac{r_f}{E_i} \left(\frac{r_f^2 + r_i^2}{r_f^2 - r_i^2} - \nu_i\right)",
    )  # fmt: skip
    def c_i(self) -> float:
        wall = self.pair[0]
        return -float(wall.displacement(wall.r_o, p_i=0, p_o=1, assumption=self.ends))

    @Quantity(
        "c_o", "µm/MPa", "compliance of the outer wall's bore, plane stress", role="step",
        source=LAME,
        tex=r"\frac{r_f}{E_o} \left(\frac{r_o^2 + r_f^2}{r_o^2 - r_f^2} + \nu_o\right)",
    )  # fmt: skip
    def c_o(self) -> float:
        wall = self.pair[1]
        return float(wall.displacement(wall.r_i, p_i=1, p_o=0, assumption=self.ends))

    @Quantity("δ_0", "µm", "increase of the interference due to p_i and p_o", role="step",
              source=LAME,
              tex=r"\frac{2 p_i r_f r_i^2}{E_i (r_f^2 - r_i^2)}"
              r" + \frac{2 p_o r_f r_o^2}{E_o (r_o^2 - r_f^2)}")  # fmt: skip
    def delta_0(self) -> float:
        nominal = self.of(FITS[0]).pair
        loads: dict[str, Any] = {"p_i": self.p_bore, "p_o": self.p_o}
        return -float(interferences_lost(nominal, **loads, assumption=self.ends)[0])

    @Quantity("p", "MPa", "mean contact pressure", source=LAME,
              tex=r"\frac{\delta + \delta_0}{c_i + c_o}")  # fmt: skip
    def p(self) -> float:
        loads: dict[str, Any] = {"p_i": self.p_bore, "p_o": self.p_o, "assumption": self.ends}
        if self.walls == "overlapping rings":
            return pressure_of_overlap(*self.pair, **loads)
        return float(contact_pressures(self.pair, self.delta, **loads)[0])

    @Quantity("Δp", "MPa", "rms scatter of the contact pressure along the fit", source="symmetry")
    def scatter(self) -> float:
        return 0.0

    hoop_inner_bore = Quantity(
        "σ_i(r_i)", "MPa", "hoop stress at the inner wall's bore", source=LAME, safe="too high",
        tex=r"\frac{p_i (r_f^2 + r_i^2) - 2 p r_f^2}{r_f^2 - r_i^2}",
    ).reads(lambda q: q.loaded[0].hoop_bore)  # fmt: skip
    hoop_inner_rim = Quantity(
        "σ_i(r_f)", "MPa", "hoop stress at the inner wall's rim", source=LAME, safe="too high",
        tex=r"\frac{2 p_i r_i^2 - p (r_f^2 + r_i^2)}{r_f^2 - r_i^2}",
    ).reads(lambda q: q.loaded[0].hoop_rim)  # fmt: skip
    hoop_outer_bore = Quantity(
        "σ_o(r_f)", "MPa", "hoop stress at the outer wall's bore", source=LAME, safe="too high",
        tex=r"\frac{p (r_o^2 + r_f^2) - 2 p_o r_o^2}{r_o^2 - r_f^2}",
    ).reads(lambda q: q.loaded[1].hoop_bore)  # fmt: skip
    hoop_outer_rim = Quantity(
        "σ_o(r_o)", "MPa", "hoop stress at the outer wall's rim", source=LAME, safe="too high",
        tex=r"\frac{2 p r_f^2 - p_o (r_o^2 + r_f^2)}{r_o^2 - r_f^2}",
    ).reads(lambda q: q.loaded[1].hoop_rim)  # fmt: skip
    u_inner_bore = Quantity(
        "u_i(r_i)", "µm", "displacement of the inner wall's bore", source=LAME,
        tex=r"\frac{r_i}{E_i} (\sigma_i(r_i) + \nu_i p_i)",
    ).reads(lambda q: q.loaded[0].u_bore)  # fmt: skip
    u_inner_rim = Quantity(
        "u_i(r_f)", "µm", "displacement of the inner wall's rim", source=LAME,
        tex=r"\frac{r_f}{E_i} (\sigma_i(r_f) + \nu_i p)",
    ).reads(lambda q: q.loaded[0].u_rim)  # fmt: skip
    u_outer_bore = Quantity(
        "u_o(r_f)", "µm", "displacement of the outer wall's bore", source=LAME,
        tex=r"\frac{r_f}{E_o} (\sigma_o(r_f) + \nu_o p)",
    ).reads(lambda q: q.loaded[1].u_bore)  # fmt: skip
    u_outer_rim = Quantity(
        "u_o(r_o)", "µm", "displacement of the outer wall's rim", source=LAME,
        tex=r"\frac{r_o}{E_o} (\sigma_o(r_o) + \nu_o p_o)",
    ).reads(lambda q: q.loaded[1].u_rim)  # fmt: skip

    @Quantity("U", "J/m", "strain energy", source=LAME,
              tex=r"\pi (p_i r_i u_i(r_i) - p r_f u_i(r_f)"
              r" + p r_f u_o(r_f) - p_o r_o u_o(r_o))")  # fmt: skip
    def U(self) -> float:
        return sum(wall.strain_energy for wall in self.loaded)

    @property
    def pair(self) -> tuple[Wall, Wall]:
        """Both walls of the fit: the inner wall (or the shaft), then the outer wall."""
        rim, bore = self.surfaces
        return (
            Wall(r_i=self.bore, r_o=rim, E=self.E_i, nu=self.nu_i),
            Wall(r_i=bore, r_o=self.r_o, E=self.E_o, nu=self.nu_o),
        )

    @shared
    def loaded(self) -> tuple[LoadedWall, LoadedWall]:
        """Both walls under their pressures; the forces on both sides of the fit are equal."""
        inner, outer = self.pair
        p = self.p
        return (
            LoadedWall(wall=inner, p_i=self.p_bore, p_o=p, assumption=self.ends),
            LoadedWall(wall=outer, p_i=p * inner.r_o / outer.r_i, p_o=self.p_o,
                       assumption=self.ends),
        )  # fmt: skip

    @property
    def hoops(self) -> tuple[float, float, float, float]:
        """Hoop stresses [Pa]: bore and rim of the inner wall, bore and rim of the outer wall."""
        inner, outer = self.loaded
        return inner.hoop_bore, inner.hoop_rim, outer.hoop_bore, outer.hoop_rim

    @property
    def stress_scale(self) -> float:
        """Largest absolute hoop stress or pressure [Pa]."""
        return max(self.p, self.p_bore, self.p_o, *map(abs, self.hoops))

    @property
    def moved(self) -> float:
        """Largest radial displacement [m] of both walls."""
        return max(abs(u) for wall in self.loaded for u in (wall.u_bore, wall.u_rim))

    def stresses(self, r: Any) -> tuple[Any, Any]:
        """Radial and hoop stresses [Pa], shape (m,), at radii `r` [m].

        The first half of `r` lies in the inner wall, the second half in the outer wall.
        """
        halves = zip(self.loaded, np.split(r, 2), strict=True)
        radial, hoop = zip(*(wall.stresses(x) for wall, x in halves), strict=True)
        return np.concatenate(radial), np.concatenate(hoop)
