"""Inputs of a clutch with logarithmic sprags: geometry of the wedge, contacts, engagement.

Table 1 of the paper gives some of the inputs. The missing inputs are identified (`IDENTIFIED`) or
assumed (`ASSUMED`). Rows that depend on an identified input have the status CALIBRATED.
"""

import math
from collections.abc import Iterable

from pydantic import model_validator

from analytic.sprag.geometry import LogSprag
from verify.cases.freewheel.inputs import in_millimetres
from verify.core.inputs import Inputs, count, meta, quantity

IDENTIFIED = {
    "l": "length of the sprags. A rectangular sprag with m_g and I_g of Table 1 has the length "
    "9.04 mm",
    "b": "width of the sprags. A rectangular sprag with m_g and I_g of Table 1 has the width "
    "3.05 mm, which would change forces by 0.3 %",
    "nu_0": "wedge angle. It gives the pressure printed for 25 N m with the optimised crown",
    "k_out": "stiffness of the support of the outer race. The paper prints only that it is large",
    "Q": "design load of the crown. It is the static load at 25 N m",
}
ASSUMED = {
    "E": "steel",
    "nu": "steel",
    "density": "steel",
    "mu_s": "dry to mixed friction of rolling steel",
    "mu_c": "dry to mixed friction of rolling steel",
    "gamma_b": "friction decreases within sliding speeds of a few m/s",
    "alpha_max": "half of the angle subtended by the width b of a sprag",
    "n": "the outer race is initially at rest",
}
LARGEST_WEDGE = 12.0  # deg: tan is 0.21, beyond friction


class WedgeInputs(Inputs):
    """Inputs of z logarithmic sprags between two round races, under a torque."""

    R_id: float = quantity("7.21 mm", "mm", "R_id", "bore radius of the inner race", gt=0.1,
                           le=1e5, claims="huang2018:table1-r-id")  # fmt: skip
    R_i: float = quantity("11.11 mm", "mm", "R_i", "outer radius of the inner race, where sprags "
                          "touch", gt=0.1, le=1e5, claims="huang2018:table1-r-i")  # fmt: skip
    R_e: float = quantity("19.44 mm", "mm", "R_e", "bore radius of the outer race, where sprags "
                          "touch", gt=0.1, le=1e5, claims="huang2018:table1-r-e")  # fmt: skip
    R_ed: float = quantity("26.23 mm", "mm", "R_ed", "outer radius of the outer race", gt=0.1,
                           le=1e5, claims="huang2018:table1-r-ed")  # fmt: skip
    r_i: float = quantity("4.02 mm", "mm", "r_i", "radius of curvature of the spiral at the "
                          "inner contact without load", gt=0.01, le=1e5,
                          claims="huang2018:table1-r-i1")  # fmt: skip
    nu_0: float = quantity("3.15 deg", "deg", "ν_0", "wedge angle at the inner contact, without "
                           "load", gt=0, le=LARGEST_WEDGE)  # fmt: skip
    z: int = count(12, "n_s", "number of sprags", ge=3, le=200,
                   claims="huang2018:table1-number-of-sprags")  # fmt: skip
    l: float = quantity("9 mm", "mm", "l", "length of the sprags along the axis", gt=0.01, le=1e5)  # noqa: E741
    b: float = quantity("4 mm", "mm", "b", "width of the sprags", gt=0.01, le=1e5)
    T: float = quantity("25 N m", "N m", "T", "torque in the locking direction", gt=0, le=1e9,
                        claims="huang2018:torque-25")  # fmt: skip
    E: float = quantity("206 GPa", "GPa", "E", "Young's modulus of all bodies", gt=0.1, le=1e5)
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)

    @model_validator(mode="after")
    def _fits(self) -> "WedgeInputs":
        for low, high, rule in (
            ("R_id", "R_i", "the bore of the inner race must be smaller than its outer radius"),
            ("R_i", "R_e", "the inner race must be smaller than the bore of the outer race"),
            ("R_e", "R_ed", "the bore of the outer race must be smaller than its outer radius"),
        ):
            inner, outer = getattr(self, low), getattr(self, high)
            if not inner < outer:
                raise ValueError(
                    f"{rule}: {low} < {high}, got {low} = {inner * 1e3:g} mm, "
                    f"{high} = {outer * 1e3:g} mm"
                )
        try:
            _ = self.sprag
        except ValueError as error:
            raise ValueError(in_millimetres(str(error))) from error
        pitch = 2 * self.R_i * math.sin(math.pi / self.z)
        if not self.b < pitch:
            raise ValueError(
                f"sprags must not overlap on the inner race: b < 2 R_i sin(π/n_s) = "
                f"{pitch * 1e3:.4g} mm, got b = {self.b * 1e3:g} mm"
            )
        return self

    @property
    def sprag(self) -> LogSprag:
        """The sprag between its races. Raises ValueError if sprag and races do not form a wedge."""
        return LogSprag.from_wedge_angle(R_i=self.R_i, R_e=self.R_e, r_i=self.r_i, nu_0=self.nu_0)


class SpragInputs(WedgeInputs):
    """Inputs of the wedge, and friction, crown and speed of the clutch."""

    mu_s: float = quantity(0.12, "1", "μ_s", "coefficient of static friction", gt=0, lt=1)
    mu_c: float = quantity(0.08, "1", "μ_c", "coefficient of Coulomb friction at fast sliding",
                           gt=0, lt=1)  # fmt: skip
    gamma_b: float = quantity("1 s/m", "s/m", "γ_b", "decay constant of friction with the sliding "
                              "speed (Eq. 13)", gt=0, le=1e6)  # fmt: skip
    K_1: float = quantity(1.0, "1", "K_1", "depth factor of the crown: load that gives "
                          "uniform pressure, divided by Q", omitted=1.0, gt=0, le=100,
                          claims="huang2018:fig12-best-k1")  # fmt: skip
    K_2: float = quantity(0.7, "1", "K_2", "crowned fraction of the length", omitted=0.7, gt=0,
                          le=1, claims="huang2018:fig12-best-k2")  # fmt: skip
    z_m: float = quantity("0.01 mm", "mm", "z_m", "drop of the crown at the ends; 0 for none",
                          omitted=0.0, ge=0, le=10, claims="huang2018:fig12-best-zm")  # fmt: skip
    Q: float | None = quantity("3407 N", "N", "Q", "design load of the crown; if omitted, the "
                               "static load of a sprag", omitted=None, gt=0, le=1e9)  # fmt: skip
    slices: int = count(41, "", "number of slices along the sprag", ge=5, le=161)
    n: float = quantity("0 r/min", "r/min", "n", "speed of the outer race; it only causes the "
                        "centrifugal growth of this race", omitted=0.0, ge=0, le=1e6)  # fmt: skip
    density: float = quantity("7850 kg/m^3", "kg/m^3", "ρ", "density of the outer race",
                              omitted=7850.0, gt=0, le=1e5)  # fmt: skip
    alpha_max: float = quantity("0.5 rad", "rad", "α_max", "rotation of the sprags at which the "
                                "profile ends and the springs are slack", gt=0, le=3)  # fmt: skip
    p_lim: float | None = quantity("4500 MPa", "MPa", "p_lim", "permissible contact pressure",
                                   omitted=None, gt=0, le=1e6)  # fmt: skip
    R_p: float | None = quantity(None, "MPa", "R_p", "yield strength of both races; if omitted, "
                                 "that of quenched and tempered steel", omitted=None, gt=0, le=1e5,
                                 example="1500 MPa")  # fmt: skip

    @model_validator(mode="after")
    def _rubs(self) -> "SpragInputs":
        if not self.mu_c <= self.mu_s:
            raise ValueError(
                f"mu_c must not exceed mu_s: mu_c <= mu_s, got mu_c = {self.mu_c:g}, "
                f"mu_s = {self.mu_s:g}"
            )
        return self


class EngagementInputs(SpragInputs):
    """Inputs of the clutch, and inertias, springs, damping and time integration."""

    m_g: float = quantity("1.8e-3 kg", "kg", "m_g", "mass of a sprag", gt=0, le=1e6,
                          claims="huang2018:table1-m-g")  # fmt: skip
    I_g: float = quantity("1.18e-8 kg m^2", "kg m^2", "I_g", "inertia of a sprag about its "
                          "centroid", gt=0, le=1e9, claims="huang2018:table1-i-g")  # fmt: skip
    I_bi: float = quantity("1.41e-3 kg m^2", "kg m^2", "I_bi", "inertia of the inner race and "
                           "all parts fixed to it", gt=0, le=1e9,
                           claims="huang2018:table1-i-bi")  # fmt: skip
    I_be: float = quantity("1.41e-3 kg m^2", "kg m^2", "I_be", "inertia of the outer race and "
                           "all parts fixed to it", gt=0, le=1e9,
                           claims="huang2018:table1-i-be")  # fmt: skip
    K_r: float = quantity("0.01 N m/rad", "N m/rad", "K_r", "stiffness of the energising spring of "
                          "a sprag", gt=0, le=1e6, claims="huang2018:table1-k-r")  # fmt: skip
    C_rl: float = quantity("0.1 N m s/rad", "N m s/rad", "C_rl", "damping between the races", ge=0,
                           le=1e9, claims="huang2018:table1-c-rl")  # fmt: skip
    k_out: float = quantity("1e5 N m/rad", "N m/rad", "k_out", "torsional stiffness of the support "
                            "of the outer race", gt=0, le=1e12)  # fmt: skip
    dt: float = quantity("1e-5 s", "s", "Δt", "time step of the integration", gt=1e-9, le=1e-2,
                         claims="huang2018:time-step")  # fmt: skip
    t_end: float = quantity("0.06 s", "s", "t_e", "end time of the integration", gt=0, le=10)
    t_ramp: float = quantity("0 s", "s", "t_r", "rise time of the torque; 0 for a step",
                             omitted=0.0, ge=0, le=10)  # fmt: skip
    D_V: float | None = quantity(None, "m/s", "D_V", "sliding speed below which a contact can "
                                 "stick; if omitted, the value required by the time step",
                                 omitted=None, gt=0, le=1e3, example="0.05 m/s")  # fmt: skip
    w_i: float = quantity("0 rad/s", "rad/s", "ω_i", "initial speed of the inner race "
                          "relative to the outer race", omitted=0.0, ge=-1e5, le=1e5)  # fmt: skip

    @model_validator(mode="after")
    def _steps(self) -> "EngagementInputs":
        steps = self.t_end / self.dt
        if not 10 <= steps <= 2_000_000:
            raise ValueError(
                f"the number of time steps must be between 10 and 2,000,000: t_end/dt = "
                f"{steps:.4g}, got t_end = {self.t_end:g} s, dt = {self.dt:g} s"
            )
        if not self.t_ramp <= self.t_end:
            raise ValueError(
                f"the ramp of the torque must end by t_end: t_ramp <= t_end, got t_ramp = "
                f"{self.t_ramp:g} s, t_end = {self.t_end:g} s"
            )
        return self


def named(inputs: Iterable[str]) -> str:
    """Symbols of the named inputs, separated by commas."""
    fields = EngagementInputs.model_fields
    return ", ".join(str(meta(fields[name])["symbol"] or name) for name in inputs)
