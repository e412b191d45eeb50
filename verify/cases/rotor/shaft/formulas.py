"""Whirl and critical speeds of a uniform shaft by beam theories and by elasticity."""

from typing import ClassVar, Literal, Self

import numpy as np

from analytic.rotor.pochhammer import bending_frequency
from analytic.rotor.shafts import Theory
from verify.case import Quantity, shared
from verify.cases.rotor.shaft.inputs import MODES, SLENDER, TurningShaft

Sense = Literal["forward", "backward"]
SENSES: tuple[Sense, ...] = ("forward", "backward")


class BeamTheories(TurningShaft):
    """Frequencies by Timoshenko's theory; the other theories are states of the case."""

    theory: ClassVar[Theory | Literal["elasticity"]] = "timoshenko"

    @Quantity("A", "mm^2", "area of the cross-section", role="geometry",
              tex=r"\frac{\pi}{4} (d_o^2 - d_i^2)")  # fmt: skip
    def A(self) -> float:
        return self.shaft().A

    @Quantity("I", "mm^4", "second moment of area of the cross-section", role="geometry",
              tex=r"\frac{\pi}{64} (d_o^4 - d_i^4)")  # fmt: skip
    def I(self) -> float:  # noqa: E743 - what the books call it
        return self.shaft().I

    @Quantity("κ", "1", "shear coefficient", role="step", source="Hutchinson 2001, Eqs. 43 and 45",
              tex=r"\frac{6 (1 + \nu)^2 (1 + m^2)^2}{(7 + 12 \nu + 4 \nu^2) (1 + m^2)^2 + "
              r"4 (5 + 6 \nu + 2 \nu^2) m^2}")  # fmt: skip
    def kappa(self) -> float:
        return self.shaft().kappa

    @Quantity("G", "GPa", "shear modulus", role="step")
    def G(self) -> float:
        return self.E / (2 * (1 + self.nu))

    @Quantity("k", "1/m", "wave number of mode 1", role="step")
    def k(self) -> float:
        return np.pi / self.L

    @Quantity("e", "1", "ratio of the rotary to the translational inertia, mode 1", role="step",
              tex=r"\frac{I}{A} k^2")  # fmt: skip
    def rotary(self) -> float:
        return self.I / self.A * (np.pi / self.L) ** 2

    @Quantity(
        "s",
        "1",
        "ratio of the shear term to the rotary inertia term of the frequency equation",
        role="step",
        tex=r"\frac{E}{\kappa G}",
    )
    def shear(self) -> float:
        return self.E * self.A / self.shaft().S

    @Quantity("ω_{0}{1[0]}", "rad/s", "whirl frequency, mode {0} {1}").over(MODES, SENSES)
    def whirl(self, j: int, sense: Sense) -> float:
        return self._pairs[j][SENSES.index(sense)]

    @Quantity("ω_{0}", "rad/s", "frequency at rest, mode {0}").over(MODES)
    def at_rest(self, j: int) -> float:
        return self._pair(j, 0.0)[0]

    @Quantity("Ω_c", "r/min", "first critical speed", safe="too low")
    def critical(self) -> float:
        if self.theory == "elasticity":
            return float(self.cylinder().critical_speeds(np.pi / self.L)[0])
        return self.shaft().critical_speed(1, theory=self.theory)

    @Quantity("Δω_1", "rad/s", "gyroscopic splitting of mode 1", tex=r"\omega_{1f} - \omega_{1b}")
    def split(self) -> float:
        return self.whirl(1, "forward") - self.whirl(1, "backward")

    @Quantity("ω_P", "rad/s", "frequency at rest, mode 1, Pochhammer's equation",
              source="Pochhammer")  # fmt: skip
    def pochhammer(self) -> float:
        return float(
            bending_frequency(k=np.pi / self.L, r_o=self.d_o / 2, r_i=self.d_i / 2, E=self.E,
                              nu=self.nu, rho=self.rho)
        )  # fmt: skip

    @Quantity("EIk^4", "MPa", "stiffness term of Rayleigh's frequency equation, mode 1 forward",
              role="step",
              tex=r"\omega_{1fR}^2 (\rho A + \rho I k^2) - 2 n \omega_{1fR} \rho I k^2",
              source="Rayleigh, mode 1")  # fmt: skip
    def rayleigh_equation(self) -> float:
        return self.E * self.I * self.k**4

    @Quantity("κGAk", "N/mm", "shear term of Timoshenko's frequency equation, mode 1 forward",
              role="step",
              tex=r"\sqrt{(\kappa G A k^2 - \rho A \omega_{1f}^2) (\kappa G A + E I k^2 + "
              r"2 n \omega_{1f} \rho I - \rho I \omega_{1f}^2)}",
              source="Timoshenko, mode 1")  # fmt: skip
    def timoshenko_equation(self) -> float:
        return self.kappa * self.G * self.A * self.k

    @shared
    def _pairs(self) -> dict[int, tuple[float, float]]:
        return {j: self._pair(j, self.n) for j in MODES}

    def _pair(self, j: int, Omega: float) -> tuple[float, float]:
        """Forward and backward whirl frequency [rad/s] of mode j at a speed."""
        if self.theory == "elasticity":
            ahead, behind = self.cylinder().whirl(j * np.pi / self.L, Omega=Omega)
            return float(ahead[0]), float(behind[0])
        return self.shaft().whirl(j, Omega=Omega, theory=self.theory)

    @shared
    def euler(self) -> Self:
        """The beam without rotary inertia and shear."""
        return self.variant(theory="euler")

    @shared
    def rayleigh(self) -> Self:
        """The beam with rotary inertia, without shear."""
        return self.variant(theory="rayleigh")

    @shared
    def exact(self) -> Self:
        """The shaft by three-dimensional elasticity."""
        return self.variant(theory="elasticity")

    @shared
    def slender(self) -> Self:
        """The shaft with its length changed to d_o/SLENDER."""
        return self.model_copy(update={"L": self.d_o / SLENDER})
