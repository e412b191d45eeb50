"""Formulas of a point contact: Hertz, and the first-order correction for finite spheres."""

from math import pi

from analytic.contact import hertz_point, sphere_series
from verify.case import Quantity, shared
from verify.cases.contact.sphere.inputs import SphereInputs

HERTZ = "Hertz"
FINITE = "first-order correction for the finite size of the spheres"


class SphereFormulas(SphereInputs):
    """Hertz's contact of two spheres; a rigid flat is a sphere with infinite R_2 and E_2."""

    E_star = Quantity(
        "E*", "GPa", "contact modulus", role="step", source=HERTZ,
        tex=r"\frac{1}{\frac{1 - \nu_1^2}{E_1} + \frac{1 - \nu_2^2}{E_2}}",
    ).reads(lambda q: q.hertz["E_star"])  # fmt: skip
    R = Quantity(
        "R", "mm", "relative radius", role="step", source=HERTZ,
        tex=r"\frac{1}{\frac{1}{R_1} + \frac{1}{R_2}}",
    ).reads(lambda q: q.hertz["R"])  # fmt: skip

    @Quantity("a", "mm", "contact radius", source=HERTZ,
              tex=r"\left(\frac{3 P R}{4 E*}\right)^{1/3}")  # fmt: skip
    def a(self) -> float:
        return self.width

    @Quantity("p_0", "MPa", "peak pressure", source=HERTZ, safe="too high",
              tex=r"\frac{3 P}{2 \pi a^2}")  # fmt: skip
    def p_0(self) -> float:
        return float(hertz_point.peak_pressure(**self.hertz))

    @Quantity(
        "δ", "µm", "approach of points far from the contact", source=HERTZ, tex=r"\frac{a^2}{R}"
    )
    def approach(self) -> float:
        return float(hertz_point.approach(**self.hertz))

    @Quantity("P(δ)", "N", "force at Hertz's approach", source=HERTZ,
              tex=r"\frac{4}{3} E* \sqrt{R \delta^3}")  # fmt: skip
    def force(self) -> float:
        return float(hertz_point.load(R=self.R, E_star=self.E_star, delta=self.approach))

    tau_upper = Quantity("τ_1", "MPa", "largest shear stress in the upper body", source=HERTZ,
                         safe="too high").reads(lambda q: q.shear_of("upper")[0])  # fmt: skip
    z_upper = Quantity("z_1", "mm", "depth of τ_1", source=HERTZ,
                       role="step").reads(lambda q: q.shear_of("upper")[1])  # fmt: skip
    tau_lower = Quantity("τ_2", "MPa", "largest shear stress in the lower body", source=HERTZ,
                         safe="too high").reads(lambda q: q.shear_of("lower")[0])  # fmt: skip
    z_lower = Quantity("z_2", "mm", "depth of τ_2", source=HERTZ,
                       role="step").reads(lambda q: q.shear_of("lower")[1])  # fmt: skip

    @Quantity("ε", "1", "factor of the logarithmic term, spheres", source=FINITE, role="step",
              tex=r"a E* \left(\frac{(1 - 2 \nu_1)^2 (1 - \nu_1^2)}{2 (1 - \nu_1) E_1 R_1}"
              r" + \frac{(1 - 2 \nu_2)^2 (1 - \nu_2^2)}{2 (1 - \nu_2) E_2 R_2}\right)")  # fmt: skip
    def epsilon(self) -> float:
        return 2 * pi * self.finite.a_excess

    a_finite = Quantity(
        "a_f", "mm", "contact radius with first-order correction", source=FINITE, role="step",
        tex=r"a (1 + \frac{\varepsilon}{2 \pi})",
    ).reads(lambda q: q.finite.a)  # fmt: skip
    p_0_finite = Quantity(
        "p_f", "MPa", "peak pressure with first-order correction", source=FINITE, role="step",
        tex=r"p_0 (1 - \frac{\pi \varepsilon}{8})",
    ).reads(lambda q: q.finite.p_0)  # fmt: skip
    approach_finite = Quantity(
        "δ_f", "µm", "approach of the equatorial planes with first-order correction",
        source=FINITE, role="step",
    ).reads(lambda q: q.finite.approach)  # fmt: skip

    @shared
    def finite(self) -> sphere_series.PressedSpheres:
        """State of the spheres under the load, corrected for finite size to first order in a/R."""
        return sphere_series.pressed_spheres(*self.spheres, P=self.P)

    @property
    def force_excess(self) -> float:
        """Q/P - 1 to first order in a/R; the load Q causes the approach that Hertz gives for P."""
        return sphere_series.load_excess(*self.spheres, P=self.P)

    def shear_of(self, body: str) -> tuple[float, float]:
        """Largest shear stress [Pa] on the axis of `body`, and its depth [m]."""
        sphere = self.spheres[body == "lower"]
        shear, depth = hertz_point.largest_shear_stress(a=self.a, p_0=self.p_0, nu=sphere.nu)
        return float(shear), float(depth)
