"""Formulas of partial slip (Cattaneo) and of cycles of a tangential force (Mindlin)."""

from typing import Any, Self

from analytic.contact import hertz_line, partial_slip, tangential_cycle
from verify.case import Quantity
from verify.cases.contact.slip.inputs import CHORD, SlipInputs

CATTANEO, MINDLIN = "Cattaneo", "Mindlin"


class SlipFormulas(SlipInputs):
    """Two rollers under P and a tangential force that alternates between Q_max and -Q_max."""

    E_star = Quantity(
        "E*", "GPa", "contact modulus, plane strain", role="step", source="Hertz",
        tex=r"\frac{E}{2 (1 - \nu^2)}",
    ).reads(lambda q: q.hertz["E_star"])  # fmt: skip

    @Quantity("a", "µm", "half-width of the contact", role="step", source="Hertz",
              tex=r"\sqrt{\frac{4 P \frac{R}{2}}{\pi E*}}")  # fmt: skip
    def a(self) -> float:
        return self.width

    @Quantity("p_0", "MPa", "peak pressure", role="step", source="Hertz", safe="too high",
              tex=r"\frac{2 P}{\pi a}")  # fmt: skip
    def p_0(self) -> float:
        return float(hertz_line.peak_pressure(**self.hertz))

    @Quantity("Q_max", "N/mm", "amplitude of the tangential force", role="step")
    def Q_max(self) -> float:
        return self.share * self.limit

    @Quantity("k", "1", "ratio of the amplitude to the sliding force μP", role="step",
              tex=r"\frac{Q_{max}}{\mu P}")  # fmt: skip
    def k(self) -> float:
        return self.share

    @Quantity("c", "µm", "stick half-width", source=CATTANEO, tex=r"a \sqrt{1 - k}")
    def c(self) -> float:
        return float(partial_slip.stick_half_width(Q=self.Q_max, a=self.a, **self.loads))

    @Quantity("q_1(0)", "MPa", "traction in the middle at Q_max, first loading", source=CATTANEO,
              tex=r"\mu p_0\left[\sqrt{1-\frac{x^2}{a^2}} - \frac{c}{a}\sqrt{1-\frac{x^2}{c^2}}"
              r"\right]_{x=0} = \mu p_0 (1 - \frac{c}{a})")  # fmt: skip
    def q_1(self) -> float:
        return float(self.first_traction(0.0, self.share))

    @Quantity("δ(Q_max)", "nm", "displacement due to slip at Q_max", role="step",
              source="Cattaneo; displacement minus the displacement without slip",
              tex=r"\frac{\mu P}{\pi E*} (k + (1 - k) \ln\left(1 - k\right))")  # fmt: skip
    def delta(self) -> float:
        return float(partial_slip.rigid_displacement_beyond_stick(Q=self.Q_max, **self.moved))

    @Quantity("Δδ", "nm", "displacement minus the chord of the force-displacement curve",
              source=CATTANEO)  # fmt: skip
    def beyond_chord(self) -> float:
        return self.delta - self.share / CHORD * self.at_share(CHORD).delta

    q_0 = Quantity(
        "q(0)", "MPa", "traction in the middle at Q = 0 in unloading", source=MINDLIN,
        tex=r"q_1(x, Q_{max}) - 2\,q_1\left(x, \frac{Q_{max} - Q}{2}\right)"
        r" = \mu p_0 (2 \sqrt{1 - \frac{k}{2}} - 1 - \frac{c}{a})",
    ).reads(lambda q: q.cycle_traction(0.0, 0.0))  # fmt: skip

    @Quantity("δ(0)", "nm", "residual displacement at Q = 0 in unloading", source=MINDLIN,
              tex=r"\delta(Q_{max}) - 2 \frac{\mu P}{\pi E*} "
              r"(\frac{k}{2} + (1 - \frac{k}{2}) \ln\left(1 - \frac{k}{2}\right))")  # fmt: skip
    def delta_0(self) -> float:
        return float(tangential_cycle.rigid_displacement_beyond_stick(
            Q=0.0, Q_max=self.Q_max, branch="unloading", **self.moved
        ))  # fmt: skip

    @Quantity("W", "µJ/m", "energy lost in a cycle, per length", source=MINDLIN,
              tex=r"\frac{2 (\mu P)^2}{\pi E*} (k (2 - k) + 2 (1 - k) \ln\left(1 - k\right))",
              )  # fmt: skip
    def W(self) -> float:
        return float(tangential_cycle.dissipation(Q_max=self.Q_max, **self.moved))

    @property
    def limit(self) -> float:
        """Tangential force per length at which the whole contact slides, μP [N/m]."""
        return self.mu * self.P

    @property
    def loads(self) -> dict[str, float]:
        """Arguments common to the formulas of partial slip."""
        return {"P": self.P, "mu": self.mu}

    @property
    def moved(self) -> dict[str, float]:
        """Arguments common to the formulas of displacements."""
        return {**self.loads, "E_star": self.E_star}

    def at_share(self, k: float) -> Self:
        """The rollers under the amplitude Q_max = k mu P."""
        return self.model_copy(update={"share": k})

    def first_traction(self, x: Any, k: float) -> Any:
        """Cattaneo's traction [Pa] at x [m] under Q = k mu P."""
        return partial_slip.traction(x, Q=k * self.mu * self.P, a=self.a, **self.loads)

    def cycle_traction(self, x: Any, stage: float) -> Any:
        """Mindlin's traction [Pa] at x [m] when Q, falling from Q_max, reaches `stage` Q_max."""
        Q_max = self.share * self.mu * self.P
        return tangential_cycle.traction(
            x, Q=stage * Q_max, Q_max=Q_max, a=self.a, branch="unloading", **self.loads
        )
