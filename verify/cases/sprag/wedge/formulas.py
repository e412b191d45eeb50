"""Formulas of a wedged logarithmic sprag (Huang, Zhao, Liu, Eqs. 6, 7, 9, 10).

The clutches are built in `model`. The quantities apply under the torque T. After `at_share`, they
apply under a given multiple of N_0, the normal force of a rigid clutch.
"""

from collections.abc import Mapping
from types import MappingProxyType
from typing import ClassVar, Self

import numpy as np

from analytic.sprag import printed
from analytic.sprag.closure import Wedged, at_torque, wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.course import rolled
from analytic.sprag.elastic import ElasticSpragClutch
from analytic.sprag.limits import pressures
from verify.case import Case, Quantity, State, shared
from verify.cases.sprag.inputs import WedgeInputs
from verify.cases.sprag.wedge import model
from verify.core.figures import Array

STROKE = MappingProxyType({"N_0/4": 0.25, "N_0/2": 0.5, "N_0": 1.0, "1.8 N_0": 1.8})
KEYS = dict(zip(STROKE, ("quarter", "half", "rigid", "most"), strict=True))
INNER, OUTER = ("R_i", "R_{id}"), ("R_{ed}", "R_e")  # radii of the races as TeX


def mean_of(E: str, N: str, radii: tuple[str, str], nu: str) -> str:
    """TeX of Eq. 6 for a race of the radii r_o, r_i."""
    r_o, r_i = radii
    ratio = rf"\frac{{{r_o}^2 + {r_i}^2}}{{{r_o}^2 - {r_i}^2}} {nu}"
    return rf"\frac{{n_s {N}}}{{2 \pi l {E}}} ({ratio})"


class WedgeFormulas(WedgeInputs, Case):
    """Quantities of a sprag between two races; contacts, sprag and races are elastic bodies."""

    share: ClassVar[float | None] = None  # load of the quantities over N_0; None means the torque T

    def at_share(self, share: float) -> Self:
        """The clutch with the normal force `share` N_0 as its load, in place of the torque T."""
        return self.variant(share=share)

    @shared
    def part(self) -> WedgeInputs:
        """The inputs without `share`, so that all states use the same clutches built by `model`."""
        return WedgeInputs(**{name: getattr(self, name) for name in WedgeInputs.model_fields})

    @shared
    def stroke(self) -> Mapping[str, State]:
        """The states at which formulas and finite elements are compared."""
        return {
            point: State(self.at_share(share), KEYS[point], f"at {point}")
            for point, share in STROKE.items()
        }

    @shared
    def bodies(self) -> ElasticSpragClutch:
        """The parts of the clutch as elastic bodies, and a clutch for each law of deflections."""
        return model.bodies(self.part)

    @shared
    def clutch(self) -> SpragClutch:
        """The clutch whose parts deflect as elastic bodies."""
        return self.bodies.clutch

    @shared
    def state(self) -> Wedged:
        """Equilibrium state of the clutch.

        Raises ValueError if no equilibrium exists at the torque T.
        """
        found = self.state_of(self.clutch)
        if self.share is None and not np.isfinite(found.N):
            raise ValueError(
                f"no equilibrium exists at T = {self.T:g} N m: the sprags cannot transmit this "
                "torque; reduce T"
            )
        return found

    def state_of(self, clutch: SpragClutch) -> Wedged:
        """Equilibrium state of `clutch` under the load of this case."""
        if self.share is None:
            return at_torque(clutch, self.T)
        return wedged(clutch, self.N)

    def printed_state_of(self, clutch: SpragClutch) -> Wedged:
        """State of `clutch` under the load of this case, with Eqs. 9 and 10 as printed."""
        if self.share is None:
            return printed.at_torque(clutch, self.T)
        return printed.wedged(clutch, self.N)

    @shared
    def widths(self) -> tuple[Array, Array]:
        """Half-widths [m] of both contacts."""
        return self.bodies.half_widths(np.asarray(self.N))

    @property
    def unit(self) -> float:
        """1/(l E') [m/N]: a force times this factor is the ratio of force per length to E'."""
        return 1 / (self.l * self.bodies.E_plane)

    @Quantity("N_0", "N", "normal force of a rigid clutch", role="step",
              tex=r"\frac{T}{n_s R_i \tan\left(\nu_0\right)}")  # fmt: skip
    def N_0(self) -> float:
        return model.rigid_force(self.part)

    @Quantity("N", "N", "normal force of a sprag on the inner race", equation="10",
              tex=r"\frac{T}{n_s \tan\left(\nu_T\right) OA}")  # fmt: skip
    def N(self) -> float:
        return float(self.state.N) if self.share is None else self.share * self.N_0

    @Quantity("μ_i", "1", "required friction coefficient of the inner race, T_i/N", equation="10",
              safe="too high", tex=r"\tan\left(\nu_T\right)")  # fmt: skip
    def mu_i(self) -> float:
        return float(np.tan(self.state.nu))

    @Quantity("μ_e", "1", "required friction coefficient of the outer race, T_e/N_e",
              equation="10", safe="too high", tex=r"\tan\left(\omega_T\right)")  # fmt: skip
    def mu_e(self) -> float:
        return float(np.tan(self.state.omega))

    @Quantity("ν_T", "deg", "wedge angle at the inner contact", equation="10", role="step",
              tex=r"\arctan\left(\frac{OB \sin\left(\beta\right)}"
              r"{OB \cos\left(\beta\right) - OA}\right)")  # fmt: skip
    def nu_T(self) -> float:
        return float(self.state.nu)

    @Quantity("ω_T", "deg", "wedge angle at the outer contact", equation="10", role="step",
              tex=r"\nu_T - \beta")  # fmt: skip
    def omega_T(self) -> float:
        return float(self.state.omega)

    @Quantity("T", "N m", "torque n_s N tan(ν) OA", equation="10", form_of="T",
              source="equilibrium of two forces",
              tex=r"n_s N \tan\left(\nu_T\right) OA")  # fmt: skip
    def torque(self) -> float:
        return float(self.state.T)

    @Quantity("T", "N m", "torque with the lever arm", equation="16",
              form="as printed", form_of="T")  # fmt: skip
    def torque_printed(self) -> float:
        inner, _ = printed.lever_arms(self.clutch.sprag, self.state.yields)
        return float(self.z * self.N * np.tan(self.state.nu) * inner)

    @Quantity("T_i", "N", "tangential force of a sprag on the inner race", role="step",
              tex=r"N \mu_i")  # fmt: skip
    def T_i(self) -> float:
        return float(self.state.T_i)

    @Quantity("N_e", "N", "normal force on the outer race", role="step",
              source="equilibrium of two forces; in the paper, N_e equals N",
              tex=r"N \frac{\cos\left(\omega_T\right)}{\cos\left(\nu_T\right)}")  # fmt: skip
    def N_e(self) -> float:
        return float(self.state.N_e)

    @Quantity("N_e/N − 1", "1", "excess of the outer normal force over the inner",
              source="equilibrium of two forces", tex=r"\frac{N_e}{N} - 1")  # fmt: skip
    def excess(self) -> float:
        return float(self.state.N_e / self.N - 1)

    @Quantity("α", "deg", "rotation of the sprags", equation="10",
              tex=r"\frac{1}{m} \ln\left(\frac{\rho}{\rho_0}\right) - (\eta - \eta_0)")  # fmt: skip
    def alpha(self) -> float:
        return float(self.state.alpha_b)

    @Quantity("α", "deg", "rotation of the sprags with half planes and Eq. 6 for plane strain",
              form_of="alpha",
              source="Eqs. 6, 10")  # fmt: skip
    def alpha_plane(self) -> float:
        return float(self.state_of(self.bodies.plane).alpha_b)

    @Quantity("α", "deg", "rotation of the sprags with elastic deflections and Eqs. 9, 10",
              form_of="alpha", form="as printed", source="Eqs. 9, 10")  # fmt: skip
    def alpha_printed(self) -> float:
        return float(self.printed_state_of(self.clutch).alpha_b)

    @Quantity("α", "deg", "rotation of the sprags with Palmgren's law, Eqs. 6 and 7",
              form_of="alpha", source="Eqs. 6, 7, 10")  # fmt: skip
    def alpha_composite(self) -> float:
        return float(self.state_of(self.bodies.composite).alpha_b)

    @Quantity("α", "deg", "rotation of the sprags with Palmgren's law and Eq. 6, without Eq. 7",
              form_of="alpha", source="Eqs. 6, 10")  # fmt: skip
    def alpha_contacts(self) -> float:
        return float(self.state_of(self.bodies.by_contacts_and_races).alpha_b)

    @Quantity("α", "deg", "rotation of the sprags as in the paper, with Palmgren's law in "
              "Eqs. 9, 10",
              form_of="alpha", form="as printed", source="Eqs. 6, 7, 9, 10")  # fmt: skip
    def alpha_paper(self) -> float:
        return float(self.printed_state_of(self.bodies.composite).alpha_b)

    @Quantity("θ", "deg", "wind-up of the races with rolling contacts",
              source="work of T and N; valid with OA_s in Eq. 10, not with the printed OA",
              tex=r"\int \frac{n_s N}{T} \mathrm{d}H")  # fmt: skip
    def theta(self) -> float:
        return float(rolled(self.clutch, np.asarray(self.N)))

    @Quantity("θ", "deg", "wind-up of a clutch with rigid races by Palmgren's law", form_of="theta",
              source="Huang 2022, Eqs. 2 and 4")  # fmt: skip
    def theta_rigid_races(self) -> float:
        found = self.bodies.composite.compliance.yields(self.N)
        lever = self.T / (self.z * self.N_0)  # R_i tan(nu_0)
        return float((found.contact_i + found.contact_e) / lever)

    @Quantity(
        "T/θ",
        "N m/rad",
        "torsional secant stiffness of a clutch with rigid races by Palmgren's law",
        source="Huang 2022, Eq. 11",
    )
    def secant(self) -> float:
        return self.T * self.N / self.N_0 / self.theta_rigid_races

    @Quantity("H", "µm", "total deflection at a sprag, elastic bodies", source="Eqs. 6, 9",
              tex=r"\delta_{BI} + \delta_{HI} + \delta_g + \delta_{HE} + \delta_{BE}")  # fmt: skip
    def H(self) -> float:
        return float(self.state.yields.H)

    @Quantity("H", "µm", "total deflection by Palmgren's law, Eqs. 6 and 7", form_of="H",
              role="step", source="Eqs. 6, 7")  # fmt: skip
    def H_composite(self) -> float:
        return float(self.bodies.composite.compliance.yields(self.N).H)

    @Quantity("T_r", "N m", "torque at which a contact reaches a flank of the sprag", role="step",
              safe="too low")  # fmt: skip
    def T_roll(self) -> float:
        return self.bodies.rolls_over_at

    @Quantity("p_i", "MPa", "peak pressure on the inner race", source="Hertz", safe="too high",
              tex=r"\sqrt{\frac{N E'}{2 \pi l} (\frac{1}{\rho \sqrt{1 + m^2}} + "
              r"\frac{1}{R_i})}")  # fmt: skip
    def p_i(self) -> float:
        return float(pressures(self.bodies.parts, self.state)[0])

    @Quantity("p_o", "MPa", "peak pressure on the outer race", source="Hertz", safe="too high",
              tex=r"\sqrt{\frac{N_e E'}{2 \pi l} (\frac{1}{r_e} - \frac{1}{R_e})}")  # fmt: skip
    def p_e(self) -> float:
        return float(pressures(self.bodies.parts, self.state)[1])

    @Quantity("a_i", "µm", "half-width of the contact on the inner race", source="Hertz",
              tex=r"\sqrt{\frac{8 N r_i R_i}{\pi l E' (r_i + R_i)}}")  # fmt: skip
    def a_i(self) -> float:
        return float(self.widths[0])

    @Quantity("a_o", "µm", "half-width of the contact on the outer race", source="Hertz",
              tex=r"\sqrt{\frac{8 N r_e R_e}{\pi l E' (R_e - r_e)}}")  # fmt: skip
    def a_e(self) -> float:
        return float(self.widths[1])

    @Quantity("u_i", "µm", "mean displacement of the inner race in plane strain", equation="6",
              tex=mean_of("E'", "N", INNER, r"- \nu'"))  # fmt: skip
    def mean_i(self) -> float:
        return float(self.unit * self.bodies.races[0].mean * self.N)

    @Quantity("u_e", "µm", "mean displacement of the outer race in plane strain", equation="6",
              tex=mean_of("E'", "N_e", OUTER, r"+ \nu'"))  # fmt: skip
    def mean_e(self) -> float:
        return float(self.unit * self.bodies.races[1].mean * self.state.N_e)

    @Quantity("u_i", "µm", "mean displacement of the inner race in plane stress", equation="6",
              form_of="mean_i", form="as printed",
              tex=mean_of("E", "N", INNER, r"- \nu"))  # fmt: skip
    def thin_i(self) -> float:
        return float(self.bodies.composite.compliance.yields(self.N).race_i)

    @Quantity("u_e", "µm", "mean displacement of the outer race in plane stress", equation="6",
              form_of="mean_e", form="as printed",
              tex=mean_of("E", "N", OUTER, r"+ \nu"))  # fmt: skip
    def thin_e(self) -> float:
        return float(self.bodies.composite.compliance.yields(self.N).race_e)

    @Quantity("u_is", "µm", "displacement of the inner race under a sprag",
              source="ring under concentrated forces")  # fmt: skip
    def race_i(self) -> float:
        return float(self.unit * self.bodies.races[0].under(self.widths[0]) * self.N)

    @Quantity("u_es", "µm", "displacement of the outer race under a sprag",
              source="ring under concentrated forces")  # fmt: skip
    def race_e(self) -> float:
        return float(self.unit * self.bodies.races[1].under(self.widths[1]) * self.state.N_e)
