"""Steps of the geometric closure of a wedged sprag (Eqs. 9, 10): deflections, lengths, angles.

The values of the steps are displayed, but not compared with a reference.
"""

from functools import partial

import numpy as np

from verify.case import Quantity
from verify.cases.sprag.wedge.formulas import INNER, OUTER, WedgeFormulas, mean_of

step = partial(Quantity, role="step")


class WedgeSteps(WedgeFormulas):
    """Quantities of a wedged sprag, and the steps of their computation."""

    @step("E'", "GPa", "modulus of plane strain", tex=r"\frac{E}{1 - \nu^2}",
          source="Eq. 6 as printed (plane stress) contains E and ν instead")  # fmt: skip
    def E_plane(self) -> float:
        return self.bodies.E_plane

    @step("ν'", "1", "Poisson's ratio of plane strain", tex=r"\frac{\nu}{1 - \nu}",
          source="Eq. 6 as printed (plane stress) contains E and ν instead")  # fmt: skip
    def nu_plane(self) -> float:
        return self.nu / (1 - self.nu)

    @step("m", "1", "growth rate of the spiral")
    def m(self) -> float:
        return float(np.asarray(self.sprag.m))

    @step("ρ_0", "mm", "polar radius at first contact", tex=r"\frac{r_i}{\sqrt{1 + m^2}}")
    def rho_0(self) -> float:
        return float(self.sprag.rho_0)

    @step("r_e", "mm", "radius of the outer flank",
          tex=r"R_e - \sqrt{R_i^2 + \rho_0^2 + \frac{2 R_i \rho_0}{\sqrt{1 + m^2}}}")  # fmt: skip
    def r_e(self) -> float:
        return float(self.sprag.r_e)

    @step("η_0", "deg", "angle at the pole C_e at first contact",
          tex=r"\arcsin\left(\frac{m R_i}{(R_e - r_e) \sqrt{1 + m^2}}\right)")  # fmt: skip
    def eta_0(self) -> float:
        return float(self.sprag.eta_0)

    @step("δ_BI", "µm", "deflection of the inner race as a ring", equation="6",
          tex=mean_of("E'", "N", INNER, r"- \nu'"))  # fmt: skip
    def delta_BI(self) -> float:
        return float(self.state.yields.race_i)

    @step("δ_HI", "µm", "deflection of the inner contact and of half of the sprag")
    def delta_HI(self) -> float:
        return float(self.state.yields.contact_i)

    @step("δ_g", "µm", "deflection of the sprag, if not included in that of its contacts")
    def delta_g(self) -> float:
        return float(self.state.yields.sprag)

    @step("δ_HE", "µm", "deflection of the outer contact and of half of the sprag")
    def delta_HE(self) -> float:
        return float(self.state.yields.contact_e)

    @step("δ_BE", "µm", "deflection of the outer race as a ring", equation="6",
          tex=mean_of("E'", "N", OUTER, r"+ \nu'"))  # fmt: skip
    def delta_BE(self) -> float:
        return float(self.state.yields.race_e)

    @step("OA", "mm", "radius at which the inner contact's force acts", equation="9",
          tex=r"R_i - \delta_{BI} - \frac{\delta_{HI}}{2}")  # fmt: skip
    def OA(self) -> float:
        return float(self.state.OA)

    @step("OB", "mm", "radius at which the outer contact's force acts", equation="9",
          tex=r"R_e + \delta_{BE} + \frac{\delta_{HE}}{2}")  # fmt: skip
    def OB(self) -> float:
        return float(self.state.OB)

    @step("OA_s", "mm", "distance of the undeformed spiral's contact from the axis",
          source="Eq. 9 with all deflections of the inner side", form="corrected",
          tex=r"R_i - \delta_{BI} - \delta_{HI} - \frac{\delta_g}{2}")  # fmt: skip
    def OA_s(self) -> float:
        return float(self.state.OA_s)

    @step("OC_e", "mm", "distance of the pole C_e from the axis", source="Eqs. 9, 10 with OA_s",
          tex=r"R_e - r_e + \delta_{BE} + \delta_{HE} + \frac{\delta_g}{2}"
          r" = \sqrt{OA_s^2 + \rho^2 + \frac{2 OA_s \rho}{\sqrt{1 + m^2}}}")  # fmt: skip
    def OC_e(self) -> float:
        return float(self.state.OC_e)

    @step("ρ", "mm", "polar radius at the inner contact", source="Eq. 10, solved for ρ",
          tex=r"\sqrt{OC_e^2 - \frac{m^2 OA_s^2}{1 + m^2}}"
          r" - \frac{OA_s}{\sqrt{1 + m^2}}")  # fmt: skip
    def rho(self) -> float:
        return float(self.state.rho)

    @step("η", "deg", "angle at the pole C_e", source="Eq. 10, with OA_s",
          tex=r"\arcsin\left(\frac{m OA_s}{OC_e \sqrt{1 + m^2}}\right)")  # fmt: skip
    def eta(self) -> float:
        return float(self.state.eta)

    @step("β", "deg", "angle between the radii of both contacts", source="Eq. 10, with OA_s",
          tex=r"\arctan\left(m\right) - \eta")  # fmt: skip
    def beta(self) -> float:
        return float(self.state.beta)
