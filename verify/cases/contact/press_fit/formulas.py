"""Formulas of a press fit: Lamé's two walls under the pressure that closes the interference."""

from typing import Any

import numpy as np

from analytic.contact.press_fit import (
    Wall,
    contact_pressures,
    interferences_lost,
    pressure_of_overlap,
)
from verify.case import Quantity
from verify.cases.contact.press_fit.inputs import FITS, FitInputs

LAME = "Lamé; behind Eq. 6"


class FitFormulas(FitInputs):
    """What both walls do, of one fit."""

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

    @Quantity("δ_0", "µm", "what p_i and p_o add to δ", role="step", source=LAME,
              tex=r"\frac{2 p_i r_f r_i^2}{E_i (r_f^2 - r_i^2)}"
              r" + \frac{2 p_o r_f r_o^2}{E_o (r_o^2 - r_f^2)}")  # fmt: skip
    def delta_0(self) -> float:
        nominal = self.of(FITS[0]).pair
        loads: dict[str, Any] = {"p_i": self.p_bore, "p_o": self.p_o}
        return -float(interferences_lost(nominal, **loads, assumption=self.ends)[0])

    @Quantity("p", "MPa", "contact pressure, mean", source=LAME,
              tex=r"\frac{\delta + \delta_0}{c_i + c_o}")  # fmt: skip
    def p(self) -> float:
        loads: dict[str, Any] = {"p_i": self.p_bore, "p_o": self.p_o, "assumption": self.ends}
        if self.walls == "drawn":
            return pressure_of_overlap(*self.pair, **loads)
        return float(contact_pressures(self.pair, self.delta, **loads)[0])

    @Quantity("Δp", "MPa", "contact pressure, rms scatter along the fit", source="symmetry")
    def scatter(self) -> float:
        return 0.0

    @Quantity("σ_i(r_i)", "MPa", "hoop stress at the inner ring's bore", source=LAME,
              safe="too high",
              tex=r"\frac{p_i (r_f^2 + r_i^2) - 2 p r_f^2}{r_f^2 - r_i^2}")  # fmt: skip
    def hoop_inner_bore(self) -> float:
        return self._hoop("inner", "bore")

    @Quantity("σ_i(r_f)", "MPa", "hoop stress at the inner wall's rim", source=LAME,
              safe="too high",
              tex=r"\frac{2 p_i r_i^2 - p (r_f^2 + r_i^2)}{r_f^2 - r_i^2}")  # fmt: skip
    def hoop_inner_rim(self) -> float:
        return self._hoop("inner", "rim")

    @Quantity("σ_o(r_f)", "MPa", "hoop stress at the outer wall's bore", source=LAME,
              safe="too high",
              tex=r"\frac{p (r_o^2 + r_f^2) - 2 p_o r_o^2}{r_o^2 - r_f^2}")  # fmt: skip
    def hoop_outer_bore(self) -> float:
        return self._hoop("outer", "bore")

    @Quantity("σ_o(r_o)", "MPa", "hoop stress at the outer wall's rim", source=LAME,
              safe="too high",
              tex=r"\frac{2 p r_f^2 - p_o (r_o^2 + r_f^2)}{r_o^2 - r_f^2}")  # fmt: skip
    def hoop_outer_rim(self) -> float:
        return self._hoop("outer", "rim")

    @Quantity("u_i(r_i)", "µm", "displacement of the inner ring's bore", source=LAME,
              tex=r"\frac{r_i}{E_i} (\sigma_i(r_i) + \nu_i p_i)")  # fmt: skip
    def u_inner_bore(self) -> float:
        return self._displacement("inner", "bore")

    @Quantity("u_i(r_f)", "µm", "displacement of the inner wall's rim", source=LAME,
              tex=r"\frac{r_f}{E_i} (\sigma_i(r_f) + \nu_i p)")  # fmt: skip
    def u_inner_rim(self) -> float:
        return self._displacement("inner", "rim")

    @Quantity("u_o(r_f)", "µm", "displacement of the outer wall's bore", source=LAME,
              tex=r"\frac{r_f}{E_o} (\sigma_o(r_f) + \nu_o p)")  # fmt: skip
    def u_outer_bore(self) -> float:
        return self._displacement("outer", "bore")

    @Quantity("u_o(r_o)", "µm", "displacement of the outer wall's rim", source=LAME,
              tex=r"\frac{r_o}{E_o} (\sigma_o(r_o) + \nu_o p_o)")  # fmt: skip
    def u_outer_rim(self) -> float:
        return self._displacement("outer", "rim")

    @Quantity("U", "J/m", "strain energy", source=LAME,
              tex=r"\pi (p_i r_i u_i(r_i) - p r_f u_i(r_f)"
              r" + p r_f u_o(r_f) - p_o r_o u_o(r_o))")  # fmt: skip
    def U(self) -> float:
        walls = zip(self.pair, self._loads.values(), strict=True)
        return sum(wall.strain_energy(**load, assumption=self.ends) for wall, load in walls)

    @property
    def pair(self) -> tuple[Wall, Wall]:
        """The inner wall, or the shaft, and the outer one."""
        rim, bore = self.surfaces
        return (
            Wall(r_i=self.bore, r_o=rim, E=self.E_i, nu=self.nu_i),
            Wall(r_i=bore, r_o=self.r_o, E=self.E_o, nu=self.nu_o),
        )

    @property
    def _loads(self) -> dict[str, dict[str, float]]:
        """Pressures on bore and rim of both walls; the force between them is one."""
        inner, outer = self.pair
        return {
            "inner": {"p_i": self.p_bore, "p_o": self.p},
            "outer": {"p_i": self.p * inner.r_o / outer.r_i, "p_o": self.p_o},
        }

    def _at(self, side: str, place: str) -> tuple[Wall, float, dict[str, float]]:
        wall = self.pair[side == "outer"]
        return wall, wall.r_o if place == "rim" else wall.r_i, self._loads[side]

    def _hoop(self, side: str, place: str) -> float:
        wall, r, load = self._at(side, place)
        return float(wall.stresses(r, **load)[1])

    def _displacement(self, side: str, place: str) -> float:
        wall, r, load = self._at(side, place)
        return float(wall.displacement(r, **load, assumption=self.ends))

    @property
    def hoops(self) -> tuple[float, float, float, float]:
        """Hoop stresses from the bore outward [Pa]."""
        return (self.hoop_inner_bore, self.hoop_inner_rim, self.hoop_outer_bore,
                self.hoop_outer_rim)  # fmt: skip

    @property
    def stress_scale(self) -> float:
        """The largest stress or pressure [Pa]."""
        return max(self.p, self.p_bore, self.p_o, *map(abs, self.hoops))

    @property
    def moved(self) -> float:
        """The largest displacement [m]."""
        return max(map(abs, (self.u_inner_bore, self.u_inner_rim, self.u_outer_bore,
                             self.u_outer_rim)))  # fmt: skip

    def stresses(self, r: Any) -> tuple[Any, Any]:
        """Radial and hoop stress (m,) at radii, the first half of which lies in the inner wall."""
        halves = zip(self.pair, np.split(r, 2), self._loads.values(), strict=True)
        radial, hoop = zip(*(w.stresses(x, **load) for w, x, load in halves), strict=True)
        return np.concatenate(radial), np.concatenate(hoop)
