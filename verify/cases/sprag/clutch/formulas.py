"""Formulas of a sprag clutch: geometry of its sprags, state under torque, limits."""

import math
from functools import partial

import numpy as np

from analytic.contact.sliced import SlicedContact
from analytic.sprag import crowned
from analytic.sprag.closure import Wedged, at_torque
from analytic.sprag.course import rolled
from analytic.sprag.race_stress import hoop
from analytic.sprag.tolerance import slope
from verify.case import Case, Quantity, shared
from verify.cases.sprag.clutch import bodies, model
from verify.cases.sprag.clutch.limits import as_torque_grows
from verify.cases.sprag.engagement.model import gap, parts
from verify.cases.sprag.inputs import EngagementInputs
from verify.cases.sprag.wedge import model as sprag_wedge_model

Step = partial(Quantity, role="step")
Contacts = tuple[SlicedContact, SlicedContact]  # inner, outer


class ClutchFormulas(EngagementInputs, Case):
    """Quantities of a sprag clutch; forces, rotations, pressures and stresses apply under T.

    A value is nan if no equilibrium exists at T, or if no torque reaches a limit.
    """

    @Step("m", "1", "growth rate of the spiral")
    def m(self) -> float:
        return float(np.asarray(self.sprag.m))

    @Step("ρ_0", "mm", "polar radius at first contact", tex=r"\frac{r_i}{\sqrt{1 + m^2}}")
    def rho_0(self) -> float:
        return float(self.sprag.rho_0)

    @Step("OC_e", "mm", "distance of the spiral's pole from the axis", equation="10",
          tex=r"\sqrt{R_i^2 + \rho_0^2 + \frac{2 R_i \rho_0}{\sqrt{1 + m^2}}}")  # fmt: skip
    def OC_e(self) -> float:
        return float(self.sprag.OC_e)

    @Step("r_e", "mm", "radius of the outer flank", tex="R_e - OC_e")
    def r_e(self) -> float:
        return float(self.sprag.r_e)

    @Step("η_0", "deg", "angle at the pole C_e at first contact", equation="10",
          tex=r"\arcsin\left(\frac{m R_i}{OC_e \sqrt{1 + m^2}}\right)")  # fmt: skip
    def eta_0(self) -> float:
        return float(self.sprag.eta_0)

    @Step("β_0", "deg", "angle between both contacts at first contact", equation="10",
          tex=r"\arctan\left(m\right) - \eta_0")  # fmt: skip
    def beta_0(self) -> float:
        return float(self.sprag.beta_0)

    @Step("ω_0", "deg", "wedge angle at the outer contact, without load", equation="10",
          tex=r"\nu_0 - \beta_0")  # fmt: skip
    def omega_0(self) -> float:
        return float(self.sprag.omega_0)

    @Quantity("N_0", "N", "normal force by the springs alone", source="Eqs. 14, 15")
    def N_0(self) -> float:
        return model.spring_force(self)

    @shared
    def state(self) -> Wedged | None:
        """Equilibrium state of each sprag under T; None if it does not exist."""
        return model.under(self)

    def _in_state(self, name: str) -> float:
        return math.nan if self.state is None else float(getattr(self.state, name))

    @Quantity("N", "N", "normal force on the inner race, without springs", safe="too high",
              source="equilibrium at rest by Eqs. 14 and 16",
              tex=r"\frac{T}{n_s \mu_{req} OA}")  # fmt: skip
    def N(self) -> float:
        return self._in_state("N")

    @Step("OA", "mm", "distance of the inner contact from the axis",
          tex=r"R_i - \delta_{BI} - \frac{\delta_{HI}}{2}")  # fmt: skip
    def OA(self) -> float:
        return self._in_state("OA")

    @Step("OB", "mm", "distance of the outer contact from the axis",
          tex=r"R_e + \delta_{BE} + \frac{\delta_{HE}}{2} + \delta_{ce}")  # fmt: skip
    def OB(self) -> float:
        return self._in_state("OB")

    @Step("ρ_A", "mm", "polar radius at the inner contact")
    def rho(self) -> float:
        return self._in_state("rho")

    @Step("η", "deg", "angle at the pole C_e")
    def eta(self) -> float:
        return self._in_state("eta")

    @Step("β", "deg", "angle between both contacts", equation="10",
          tex=r"\arctan\left(m\right) - \eta")  # fmt: skip
    def beta(self) -> float:
        return self._in_state("beta")

    @Quantity("ν(T)", "deg", "wedge angle under torque, inner contact", equation="10",
              safe="too high", tex=r"\arctan\left(\frac{OB \sin\left(\beta\right)}"
              r"{OB \cos\left(\beta\right) - OA}\right)")  # fmt: skip
    def nu_T(self) -> float:
        return self._in_state("nu")

    @Quantity("ω(T)", "deg", "wedge angle under torque, outer contact", equation="10",
              tex=r"\nu(T) - \beta")  # fmt: skip
    def omega(self) -> float:
        return self._in_state("omega")

    @Quantity("μ_req", "1", "required friction coefficient", safe="too high",
              source="equilibrium at rest by Eqs. 14 and 16",
              tex=r"\tan\left(\nu(T)\right)")  # fmt: skip
    def mu_req(self) -> float:
        return float(np.tan(self.nu_T))

    @Quantity("μ_s/μ_req", "1", "ratio of static to required friction coefficient", safe="too low",
              tex=r"\frac{\mu_s}{\mu_{req}}")  # fmt: skip
    def safety(self) -> float:
        return self.mu_s / self.mu_req

    @Quantity("α(T)", "deg", "rotation of the sprags relative to the radius through the outer "
              "contact",
              equation="10",
              form="corrected", tex=r"\frac{1}{m} \ln\left(\frac{\rho_A}{\rho_0}\right)"
              r" - (\eta - \eta_0)")  # fmt: skip
    def alpha(self) -> float:
        return self._in_state("alpha_b")

    @shared
    def _elastic(self) -> tuple[float, float]:
        """Rotation of the sprags and wind-up of the clutch [rad] with elastic bodies."""
        clutch = sprag_wedge_model.bodies(self).clutch
        found = at_torque(clutch, self.T)
        turn = float(rolled(clutch, float(found.N))) if np.isfinite(found.N) else math.nan
        return float(found.alpha_b), turn

    @Quantity("α_el", "deg", "rotation of the sprags with elastic bodies",
              source="case sprag-wedge")  # fmt: skip
    def alpha_elastic(self) -> float:
        return math.nan if self.state is None else self._elastic[0]

    @Quantity(
        "θ(T)", "deg", "wind-up of the races with rolling contacts", source="rolling contacts"
    )
    def theta(self) -> float:
        return math.nan if self.state is None else float(rolled(model.built(self).clutch, self.N))

    @Quantity("dT/dθ", "N m/rad", "tangent torsional stiffness at T")
    def stiffness(self) -> float:
        clutch = model.built(self).clutch
        return math.nan if self.state is None else crowned.stiffness(clutch, self.N)

    @Quantity("T/θ", "N m/rad", "secant torsional stiffness", tex=r"\frac{T}{\theta(T)}")
    def T_per_theta(self) -> float:
        return self.T / self.theta

    def _deflection(self, name: str) -> float:
        return math.nan if self.state is None else float(getattr(self.state.yields, name))

    @Quantity("δ_HI", "µm", "contact deformation at the inner race, by slices", source="Eqs. 2-5")
    def d_HI(self) -> float:
        return self._deflection("contact_i")

    @Quantity("δ_HE", "µm", "contact deformation at the outer race, by slices", source="Eqs. 2-5")
    def d_HE(self) -> float:
        return self._deflection("contact_e")

    @Quantity("δ_BI", "µm", "deflection of the inner race", equation="6")
    def d_BI(self) -> float:
        return self._deflection("race_i")

    @Quantity("δ_BE", "µm", "deflection of the outer race", equation="6")
    def d_BE(self) -> float:
        return self._deflection("race_e")

    @Quantity("δ_g", "µm", "compression of the sprag", equation="7")
    def d_g(self) -> float:
        return self._deflection("sprag")

    @Quantity("H", "µm", "sum of the five deflections", source="Eqs. 2-7",
              tex=r"\delta_{BI} + \delta_{HI} + \delta_g + \delta_{BE} + \delta_{HE}")  # fmt: skip
    def H(self) -> float:
        return self._deflection("H")

    @Quantity("δ_ce", "µm", "centrifugal growth of the outer race", equation="8")
    def d_ce(self) -> float:
        return float(np.max(model.built(self).parts.d_ce))

    @shared
    def _pressed(self) -> Contacts | None:
        """Inner and outer contact under the normal force; None without equilibrium."""
        return None if self.state is None else model.built(self).pressed(self.N)

    @shared
    def _half_pressed(self) -> Contacts | None:
        """Inner and outer contact under half of N, with unloaded ends of the crown."""
        return None if self.state is None else model.built(self).pressed(model.HALF * self.N)

    def _pressure(self, contact: int, *, mid: bool = False) -> float:
        return _read(self._pressed, contact, mid=mid)

    def half_pressure(self, contact: int, *, mid: bool) -> float:
        """Pressure [Pa] under half of the normal force: the largest or, if `mid`, at mid-length."""
        return _read(self._half_pressed, contact, mid=mid)

    @Quantity("p_i(0)", "MPa", "pressure at mid-length, inner race", safe="too high")
    def p_i_mid(self) -> float:
        return self._pressure(0, mid=True)

    @Quantity("p_o(0)", "MPa", "pressure at mid-length, outer race", safe="too high")
    def p_o_mid(self) -> float:
        return self._pressure(1, mid=True)

    @Quantity("p_i", "MPa", "largest pressure of the slices, inner race", safe="too high")
    def p_i(self) -> float:
        return self._pressure(0)

    @Quantity("p_o", "MPa", "largest pressure of the slices, outer race", safe="too high")
    def p_o(self) -> float:
        return self._pressure(1)

    @Quantity("z_end", "µm", "drop of the crown at the middle of its end slices")
    def z_end(self) -> float:
        return math.nan if self.state is None else float(gap(self)[0])

    @shared
    def hoop(self) -> dict[str, float]:
        """Stresses [Pa] of both races under uniformly distributed forces."""
        if self.state is None:
            return dict.fromkeys(("s_i", "s_id", "s_e"), math.nan)
        return hoop(parts(self), self.N, self._in_state("N_e"))

    @Quantity("σ_θ(R_id)", "MPa", "hoop stress at the bore of the inner race",
              source="Lamé", safe="too high")  # fmt: skip
    def s_id(self) -> float:
        return self.hoop["s_id"]

    @Quantity("σ_θ(R_i)", "MPa", "hoop stress of the inner race at the sprags",
              source="Lamé", safe="too high")  # fmt: skip
    def s_i(self) -> float:
        return self.hoop["s_i"]

    @Quantity("σ_θ(R_e)", "MPa", "hoop stress of the outer race at the sprags",
              source="Lamé", safe="too high")  # fmt: skip
    def s_e(self) -> float:
        return self.hoop["s_e"]

    def _limit(self, key: str) -> float:
        return next((x.at for x in as_torque_grows(self) if x.key == key), math.inf)

    @Quantity("T_μ", "N m", "torque at which the contacts slip", safe="too low")
    def T_slip(self) -> float:
        return float(model.grip(self).slip)

    @Quantity("T_p,i", "N m", "torque at which the inner contacts reach p_lim", safe="too low")
    def T_pressure_inner(self) -> float:
        return self._limit("pressure_inner")

    @Quantity("T_p,o", "N m", "torque at which the outer contacts reach p_lim", safe="too low")
    def T_pressure_outer(self) -> float:
        return self._limit("pressure_outer")

    @Quantity("T_R,i", "N m", "torque at which the inner race reaches R_p", safe="too low")
    def T_yield_inner(self) -> float:
        return self._limit("yield_inner")

    @Quantity("T_R,e", "N m", "torque at which the outer race reaches R_p", safe="too low")
    def T_yield_outer(self) -> float:
        return self._limit("yield_outer")

    @Quantity("T_α", "N m", "torque at which the sprags reach the end of their profile",
              safe="too low")  # fmt: skip
    def T_end(self) -> float:
        return float(model.grip(self).end_of_cam)

    @Quantity("T_w", "N m", "torque at which contacts become too wide for the formulas")
    def T_wide(self) -> float:
        return self._limit("wide")

    @Quantity("dν_0/dR_i", "deg/mm", "sensitivity of the wedge angle to R_i")
    def dnu_0_per_dR_i(self) -> float:
        return slope(self.sprag, "dR_i")[0]

    @Quantity("dν_0/dR_e", "deg/mm", "sensitivity of the wedge angle to R_e")
    def dnu_0_per_dR_e(self) -> float:
        return slope(self.sprag, "dR_e")[0]

    @Quantity("dα_0/dR_i", "deg/mm", "sensitivity of the sprags' rotation without load to R_i")
    def dalpha_per_dR_i(self) -> float:
        return slope(self.sprag, "dR_i")[1]

    @Quantity("dα_0/dR_e", "deg/mm", "sensitivity of the sprags' rotation without load to R_e")
    def dalpha_per_dR_e(self) -> float:
        return slope(self.sprag, "dR_e")[1]

    @Quantity("N_L", "N", "normal force with rigid races", source="Liu")
    def N_Liu(self) -> float:
        return model.normal_force(model.rigid(self))

    @Quantity("α_L", "deg", "rotation of the sprags with rigid races", source="Liu")
    def alpha_Liu(self) -> float:
        return math.nan if (now := model.rigid(self)) is None else float(now.alpha_b)

    @Quantity("θ_L", "deg", "wind-up with rigid races and rolling contacts", source="Liu")
    def theta_Liu(self) -> float:
        if self.state is None:
            return math.nan
        force = model.normal_force(model.rigid(self))
        return float(rolled(model.built(self).clutch.rigid_races(), force))

    @Quantity("α_9,10", "deg", "rotation of the sprags", equation="9, 10", form="as printed")
    def alpha_printed(self) -> float:
        return math.nan if (now := model.literal(self)) is None else float(now.alpha_b)

    @property
    def mu_0(self) -> float:
        """Required friction coefficient at first contact, tan(nu_0)."""
        return float(np.tan(self.sprag.nu_0))

    @property
    def turned(self) -> float:
        """Angle [rad] of the spiral between first contact and the contact under torque."""
        return self._in_state("turned")

    @property
    def tresca(self) -> tuple[float, float]:
        """Largest Tresca stresses [Pa] of the inner and the outer race."""
        return self.hoop["Tresca_i"], self.hoop["Tresca_e"]

    @property
    def theta_elastic(self) -> float:
        """Wind-up of the clutch [rad] with elastic bodies."""
        return math.nan if self.state is None else self._elastic[1]

    @property
    def z_end_deeper(self) -> float:
        """Drop [m] of the crown at the middle of its end slices if z_m is doubled."""
        return float(gap(self.model_copy(update={"z_m": 2 * self.z_m}))[0])

    @property
    def uneven(self) -> tuple[float, float]:
        """Ratios of the deflections of both races under a sprag to those of Eq. 6: inner, outer."""
        if self.state is None:
            return 0.0, 0.0
        N_e = self._in_state("N_e")
        return bodies.uneven(self, self.N, "rim"), bodies.uneven(self, N_e, "bore")


def _read(contacts: Contacts | None, contact: int, *, mid: bool) -> float:
    if contacts is None:
        return math.nan
    found = contacts[contact]
    return crowned.mid(found) if mid else float(found.peak_pressure.max())
