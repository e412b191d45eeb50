"""Formulas of a race under n sprags: Hertz's contact, Fourier series, Eq. 6, indentation."""

import numpy as np

from analytic.contact import hertz_line, hertz_line_approach
from analytic.ring import loaded_race, race_work, smeared
from analytic.ring.fourier_ring import State
from analytic.ring.loaded_race import LoadedRace
from verify.case import Quantity, shared
from verify.cases.ring.loads.inputs import LoadsInputs


class SpragLoads(LoadsInputs):
    """Eq. 6 with local indentation, and the Fourier-series solution under the same loads."""

    @Quantity("δ_6", "µm", "deflection", equation="6")
    def smeared(self) -> float:
        return self.by_smearing()

    @Quantity("δ(0)", "µm", "deflection of the loaded surface under a sprag",
              source="Fourier series of the ring")  # fmt: skip
    def load(self) -> float:
        return float(self.outward * self._points.u_r[0])

    @Quantity("δ(π/n)", "µm", "deflection of the loaded surface between sprags",
              source="Fourier series of the ring")  # fmt: skip
    def between(self) -> float:
        return float(self.outward * self._points.u_r[1])

    @Quantity(
        "u_r(0)",
        "µm",
        "deflection of the unloaded surface at the angle of a sprag",
        source="Fourier series of the ring",
    )
    def far_load(self) -> float:
        return float(self.outward * self._points.u_r[2])

    @Quantity("u_r(π/n)", "µm", "deflection of the unloaded surface between sprags",
              source="Fourier series of the ring")  # fmt: skip
    def far_between(self) -> float:
        return float(self.outward * self._points.u_r[3])

    @Quantity(
        "δ_m",
        "µm",
        "mean deflection of the loaded surface",
        source="Fourier series of the ring",
        role="step",
    )
    def mean(self) -> float:
        ring = self.race()
        return float(self.outward * ring.ring.mean_displacement(ring.r))

    @Quantity("a", "µm", "half-width of the contact", source="Hertz", role="step",
              tex=r"\sqrt{\frac{8 P R_{rel} (1 - \nu^2)}{\pi E}}")  # fmt: skip
    def a(self) -> float:
        return self.hertz[0]

    @Quantity("p_0", "MPa", "peak pressure", source="Hertz", role="step",
              tex=r"\frac{2 P}{\pi a}")  # fmt: skip
    def p_0(self) -> float:
        return self.hertz[1]

    @Quantity(
        "R_rel", "mm", "relative radius of curvature of the contact", source="Hertz", role="step"
    )
    def R_rel(self) -> float:
        R_2 = -self.r_i if self.loaded == "bore" else self.r_o
        return float(hertz_line.relative_radius(R_1=self.R, R_2=R_2))

    @Quantity("p_n", "MPa", "first harmonic of the pressure, m = n",
              source="Fourier series of the ring", role="step",
              tex=r"\frac{n P}{\pi r} \frac{2 J_1(n a/r)}{n a/r}")  # fmt: skip
    def p_n(self) -> float:
        return self.n * self.P / (np.pi * self.radius) * float(
            loaded_race.share(self.n * self.a / self.radius)
        )  # fmt: skip

    @Quantity("δ_H", "µm", "local indentation relative to a point one wall thickness deep",
              role="step",
              source="Hertz's contact, plane stress",
              tex=r"\frac{2 P}{\pi E} \left(\ln\left(\frac{d}{a} + \sqrt{1 + \frac{d^2}{a^2}}"
              r"\right) - \nu \frac{d}{d + \sqrt{a^2 + d^2}}\right)")  # fmt: skip
    def dent(self) -> float:
        return self.dent_to(self.wall)

    @Quantity("δ_Hh", "µm", "local indentation relative to a point half a wall thickness deep",
              role="step",
              source="Hertz's contact, plane stress")  # fmt: skip
    def dent_half(self) -> float:
        return self.dent_to(self.wall / 2)

    @Quantity("δ_tot", "µm", "deflection by Eq. 6 plus the local indentation δ_H")
    def with_dent(self) -> float:
        return self.smeared + self.dent

    @Quantity("δ_tot/δ(0)", "1", "ratio of δ_tot to the deflection under a sprag", role="step")
    def windup(self) -> float:
        return self.with_dent / self.load

    @Quantity(
        "Δδ/δ", "1", "peak-to-peak variation of the deflection, divided by the mean deflection"
    )
    def ripple(self) -> float:
        return (self.load - self.between) / self.smeared

    @Quantity("σ_θ(π/n)", "MPa", "hoop stress of the loaded surface between sprags",
              source="Fourier series of the ring", safe="too high")  # fmt: skip
    def hoop_between(self) -> float:
        return float(self._points.sigma_theta[1])

    @Quantity("σ_far(0)", "MPa", "hoop stress of the unloaded surface at the angle of a sprag",
              source="Fourier series of the ring", safe="too high")  # fmt: skip
    def far_hoop_load(self) -> float:
        return float(self._points.sigma_theta[2])

    @Quantity("σ_far(π/n)", "MPa", "hoop stress of the unloaded surface between sprags",
              source="Fourier series of the ring", safe="too high")  # fmt: skip
    def far_hoop_between(self) -> float:
        return float(self._points.sigma_theta[3])

    @Quantity("N_θ", "N/mm", "hoop force in the cut between sprags", source="statics")
    def hoop_force(self) -> float:
        return race_work.cut_force(self.race())

    @Quantity("U", "J/m", "strain energy of the race", source="Fourier series of the ring")
    def strain_energy(self) -> float:
        return race_work.strain_energy(self.race())

    @shared
    def hertz(self) -> tuple[float, float]:
        """Half-width [m] and peak pressure [Pa] of the contact of a sprag and the race."""
        E_star = hertz_line.contact_modulus(
            E_1=self.E, nu_1=self.nu, E_2=self.E, nu_2=self.nu, assumption="plane strain"
        )
        a = hertz_line.half_width(P=self.P, R=self.R_rel, E_star=E_star)
        return float(a), float(hertz_line.peak_pressure(P=self.P, R=self.R_rel, E_star=E_star))

    @shared
    def _points(self) -> State:
        """Fourier series of the ring on both walls, under a sprag and between sprags."""
        ring, pitch = self.race(), np.pi / self.n
        far_wall = self.r_o if self.loaded == "bore" else self.r_i
        return ring.at([ring.r, ring.r, far_wall, far_wall], [0.0, pitch, 0.0, pitch])

    @property
    def stress_scale(self) -> float:
        """Largest hoop stress [Pa] of those that the rows compare."""
        return float(np.abs(self._points.sigma_theta[1:]).max())

    @property
    def outward(self) -> float:
        """Sign of u_r for a displacement in the direction of the loads: +1 for the bore."""
        return 1.0 if self.loaded == "bore" else -1.0

    def race(self, *, n: int | None = None) -> LoadedRace:
        """The Fourier ring of the inputs, with n loads if n is given."""
        return LoadedRace(
            r_i=self.r_i, r_o=self.r_o, E=self.E, nu=self.nu, assumption="plane stress",
            loaded=self.loaded, n=self.n if n is None else n, P=self.P, a=self.hertz[0],
        )  # fmt: skip

    def by_smearing(self, *, n: int | None = None) -> float:
        """Deflection by Eq. 6 [m], with n loads if n is given."""
        return float(smeared.race_deflection(
            P=self.P, n=self.n if n is None else n, r_i=self.r_i, r_o=self.r_o, E=self.E,
            nu=self.nu, loaded=self.loaded,
        ))  # fmt: skip

    def dent_to(self, depth: float) -> float:
        """Approach [m] of the middle of the patch to a point at `depth` [m] in a half-plane."""
        return float(hertz_line_approach.approach_to_depth(
            depth, P=self.P, a=self.hertz[0], E=self.E, nu=self.nu, assumption="plane stress"
        ))  # fmt: skip
