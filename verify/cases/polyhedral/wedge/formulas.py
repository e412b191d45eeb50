"""Formulas of a wedged roller: free, caged at the limit of friction, released."""

import math

from analytic.contact import partial_slip
from analytic.polyhedral import wedging
from verify.case import Quantity
from verify.cases.polyhedral.wedge.inputs import WedgeInputs
from verify.cases.polyhedral.wedge.stick import SHARES, Share, small


def stays(q: "WedgeFormulas") -> bool:
    """Whether a free roller stays in its wedge (Eq. 2)."""
    return bool(wedging.holds(alpha=q.alpha, mu=q.mu))


class WedgeFormulas(WedgeInputs):
    """Eqs. 1 to 5; values of a free roller exist only if it stays in its wedge."""

    @Quantity("M_t", "N m", "torque of free rollers", equation="3", form="corrected", when=stays,
              safe="too low",
              tex=r"N \tan\left(\frac{\alpha}{2}\right) z \frac{D_i}{2}")  # fmt: skip
    def M_free(self) -> float:
        torque = wedging.torque(N=self.N, alpha=self.alpha, z=self.z, D_i=self.D_i)
        return float(torque)

    @Quantity("M_t", "N m", "torque of caged rollers", equation="3", form="as printed",
              form_of="M_free", safe="too low", tex=r"\mu N z \frac{D_i}{2}")  # fmt: skip
    def M_caged(self) -> float:
        return float(wedging.largest_torque(N=self.N, mu=self.mu, z=self.z, D_i=self.D_i))

    @Quantity("T", "N", "friction force of a free roller at either contact", when=stays,
              tex=r"N \tan\left(\frac{\alpha}{2}\right)")  # fmt: skip
    def T(self) -> float:
        return float(wedging.tangential_force(N=self.N, alpha=self.alpha))

    @Quantity("tan(α/2)/μ", "1", "friction force of a free roller, divided by its limit μN",
              role="step", tex=r"\frac{\tan\left(\frac{\alpha}{2}\right)}{\mu}")  # fmt: skip
    def wedged(self) -> float:
        return math.tan(self.half) / self.mu

    @Quantity("α_max", "deg", "largest wedge angle of a free roller", equation="2",
              role="step", tex=r"2 \arctan\left(\mu\right)")  # fmt: skip
    def alpha_max(self) -> float:
        return float(wedging.largest_angle(mu=self.mu))

    @Quantity("μ_c", "1", "least coefficient of friction that holds a free roller", equation="2",
              safe="too high",
              tex=r"\tan\left(\frac{\alpha}{2}\right)")  # fmt: skip
    def mu_c(self) -> float:
        return wedging.least_friction(N=self.N, alpha=self.alpha)

    @Quantity("C", "N", "cage force that pulls a roller out of the wedge", equation="1",
              tex=r"2 N \left(\mu \cos\left(\frac{\alpha}{2}\right) "
              r"- \sin\left(\frac{\alpha}{2}\right)\right)")  # fmt: skip
    def C(self) -> float:
        return float(wedging.cage_force(N=self.N, mu=self.mu, alpha=self.alpha))

    @Quantity("N/M_t", "1/m", "normal force per torque of free rollers", equation="5",
              form="corrected", when=stays, safe="too high",
              tex=r"\frac{2}{z D_i \tan\left(\frac{\alpha}{2}\right)}")  # fmt: skip
    def N_per_M(self) -> float:
        clutch = {"z": self.z, "D_i": self.D_i}
        return float(wedging.normal_force(M_t=1.0, alpha=self.alpha, **clutch))

    @Quantity("N/M_t", "1/m", "normal force per torque of caged rollers", equation="4",
              form="as printed", form_of="N_per_M", safe="too high",
              tex=r"\frac{2}{\mu z D_i}")  # fmt: skip
    def N_per_M_caged(self) -> float:
        return float(wedging.least_normal_force(M_t=1.0, mu=self.mu, z=self.z, D_i=self.D_i))

    @Quantity("c/a", "1",
              "stick half-width at the friction force T of a free roller (roller pressed without "
              "friction, then loaded tangentially)",
              role="step", source="Cattaneo", when=stays,
              tex=r"\sqrt{1 - \frac{T}{\mu N}}")  # fmt: skip
    def stick_free(self) -> float:
        load = {"Q": self.T, "P": self.N, "mu": self.mu, "a": self.a}
        return float(partial_slip.stick_half_width(**load) / self.a)

    @Quantity("c/a({0:g})", "1", "stick half-width at T/(μN) = {0:g} (roller pressed "
              "without friction, then loaded tangentially)",
              source="Cattaneo").over(SHARES)  # fmt: skip
    def stick(self, k: Share) -> float:
        a = small(self)
        return float(partial_slip.stick_half_width(Q=k, P=1.0, mu=1.0, a=a) / a)
