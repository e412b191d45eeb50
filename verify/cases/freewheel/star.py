"""A roller freewheel with flats on a star, under torque: inputs, clutch, state and results.

The paper prints no dimensions of its two clutches. They cannot be estimated, because a change of X
by 5 µm changes the clamping angle by 0.08 deg. Therefore, the default clutch is synthetic.
"""

import math
from typing import Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from analytic.freewheel.cam import Cam
from analytic.freewheel.clutch import ContactMaterial, RollerClutch
from analytic.freewheel.compliance import Compliance, compliance
from analytic.freewheel.geometry import InnerCam
from analytic.freewheel.state import RollerClutchState, at_angle, at_normal_force, loaded
from verify.case import Case, Quantity, count, given, shared
from verify.cases.freewheel.bodies import OneClutch
from verify.cases.freewheel.inputs import in_millimetres

LARGEST_ANGLE = math.radians(15)
GIVEN = 10.0  # N_0/(L E'): both approaches together at the angle that is given
WIDE = 0.12  # largest a/r for finite elements with small displacements
BENT = 0.1  # deflection over the ring's wall above which forces shift along it
BEYOND, EDGE = 1.1, 4.0  # times the approaches; least distance to the flat's corner in half-widths

Load = Literal["T", "N_0", "ψ"]


def of_one_steel(q: OneClutch, cam: Cam) -> RollerClutch:
    """Elastic clutch with all parts of one material."""
    steel = ContactMaterial(E=q.E, nu=q.nu)
    return RollerClutch(
        cam=cam, L=q.L, r_b=q.r_b, R_a=q.R_a, roller=steel, inner=steel, outer=steel
    )  # fmt: skip


class Rollers(Case):
    """Base class of stars and cups: elastic clutch, and normal force of a rigid clutch."""

    load: ClassVar[Load] = "T"  # load that defines the state of the formulas

    @shared
    def clutch(self: Any) -> RollerClutch:
        """The clutch of elastic bodies, for the formulas."""
        return of_one_steel(self, self.cam)

    @shared
    def bodies(self: Any) -> Compliance:
        """Compliance constants of both parts, each with half a roller."""
        return compliance(self.clutch)

    @property
    def rigid_force(self: Any) -> float:
        """Normal force N_0 [N] at the constant angle alpha_0."""
        return float(self.T / (self.z * self.race * np.tan(self.cam.alpha0)))

    def loaded_by(self, load: Load) -> Self:
        """The clutch in the state named by `load`: under T, at N = N_0, or at the angle psi."""
        return self.variant(load=load)


class Star(Rollers):
    """z rollers between the flats of a star and the bore of a ring, under a torque."""

    R: float = given("16.5 mm", "mm", "R", "bore radius of the outer ring", gt=1e-3, le=1e5)
    r: float = given("2.5 mm", "mm", "r", "radius of the rollers", gt=1e-4, le=1e5)
    X: float = given("11.39565 mm", "mm", "X", "distance of the star's flats from the axis",
                     gt=1e-4, le=1e5)  # fmt: skip
    R_a: float = given("21 mm", "mm", "R_a", "outer radius of the outer ring", gt=1e-3, le=1e5)
    r_b: float = given("7.5 mm", "mm", "r_b", "bore radius of the star, clamped on its shaft",
                       gt=1e-4, le=1e5)  # fmt: skip
    z: int = count(8, "z", "number of rollers", ge=3, le=100)
    L: float = given("10 mm", "mm", "L", "length of the rollers", gt=1e-3, le=1e6)
    T: float = given("26 N m", "N m", "T", "torque in the locking direction", gt=0, le=1e9,
                     claims="nagler2021:rig-torque")  # fmt: skip
    E: float = given("206 GPa", "GPa", "E", "Young's modulus of all parts", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)

    @model_validator(mode="after")
    def _fits(self) -> Self:
        for low, high, rule in (
            ("r_b", "X", "the star must have a wall"), ("R", "R_a", "the ring must have a wall"),
        ):  # fmt: skip
            inner, outer = getattr(self, low), getattr(self, high)
            if not inner < outer:
                raise ValueError(
                    f"{rule}: {low} < {high}, got {low} = {inner * 1e3:g} mm, "
                    f"{high} = {outer * 1e3:g} mm"
                )
        try:
            _ = self.cam
        except ValueError as error:
            raise ValueError(in_millimetres(str(error))) from error
        if self.cam.alpha0 > LARGEST_ANGLE:
            raise ValueError(
                f"α_0 = {math.degrees(float(self.cam.alpha0)):.4g}° is too large: friction holds "
                f"rollers only below about {math.degrees(LARGEST_ANGLE):g}°; increase X or "
                "r, or reduce R"
            )
        return self

    # common to sectors of stars and cups: see `verify.cases.freewheel.bodies`
    @property
    def sense(self) -> int:
        """+1: load increases the angle."""
        return 1

    @property
    def race(self) -> float:
        """Radius [m] of the round race."""
        return self.R

    @property
    def flat(self) -> float:
        """Distance [m] of the flats from the axis."""
        return self.X

    @property
    def cam(self) -> InnerCam:
        """The cam; raises ValueError if rollers and races form no wedge."""
        return InnerCam(R=self.R, r=self.r, X=self.X, z=self.z)

    @shared
    def state(self) -> RollerClutchState:
        """State under the load named by `load`; raises ValueError if no equilibrium exists."""
        if self.load == "T":
            return self.under(self.T)
        if self.load == "N_0":
            return self._known(at_normal_force(self.clutch, self.rigid_force))
        d = GIVEN * self.rigid_force / self.L * (1 - self.nu**2) / self.E
        y = self.X + self.r - d / 2
        return self._known(at_angle(self.clutch, math.acos(y / (self.R - self.r + d / 2))))

    def under(self, T: float) -> RollerClutchState:
        """State under T [N m]; raises ValueError for too wide contacts, or rollers beyond flats."""
        state = loaded(self.clutch, T)
        if not np.isfinite(state.N):
            raise ValueError(
                f"under T = {T:g} N m the contacts are wider than half the roller radius, beyond "
                "the range of these formulas; reduce T"
            )
        x, half = float(self.cam.centre(d_i=state.d_i, d_o=state.d_o)[0]), float(self.cam.corner)
        if x >= half:
            raise ValueError(
                f"under T = {T:g} N m the rollers are beyond the ends of their flats: "
                f"{x * 1e3:.4g} mm from the middle of the flats, which end at {half * 1e3:.4g} mm; "
                "reduce T"
            )
        return state

    def _known(self, state: RollerClutchState) -> RollerClutchState:
        if not np.isfinite(state.N):
            raise ValueError(
                "under the normal force of a rigid clutch, N = T/(z R tan α_0) = "
                f"{self.rigid_force:.4g} N, the contacts are wider than half the roller radius, "
                "beyond the range of these formulas; reduce T"
            )
        return state

    alpha_0 = Quantity(
        "α_0", "deg", "clamping angle without load", equation="4", form="corrected",
        source="with R instead of r_RO in the numerator",
        tex=r"\arccos\left(\sqrt{\frac{R + X}{2 (R - r)}}\right) = "
        r"\frac{1}{2} \arccos\left(\frac{X + r}{R - r}\right)",
    ).reads(lambda q: q.cam.alpha0)  # fmt: skip
    E_plane = Quantity("E'", "GPa", "Young's modulus for plane strain", role="step",
                       tex=r"\frac{E}{1 - \nu^2}").reads(lambda q: q.bodies.inner.E)  # fmt: skip
    a_i = Quantity("a_i", "µm", "half-width of the contact on the star", source="Hertz",
                   tex=r"\sqrt{\frac{8 F_n r}{\pi L E'}}").reads(lambda q: q.state.a_i)  # fmt: skip
    a_o = Quantity(
        "a_o", "µm", "half-width of the contact on the ring", source="Hertz",
        tex=r"\sqrt{\frac{8 F_n R r}{\pi L E' (R - r)}}",
    ).reads(lambda q: q.state.a_o)  # fmt: skip
    l = Quantity(  # noqa: E741
        "l", "mm", "distance from the axis to the undeformed contact point on the flat",
        role="step",
        tex=r"\sqrt{X^2 + (R - r)^2 - (X + r)^2}",
    ).reads(lambda q: q.bodies.inner.l)  # fmt: skip
    k_i = Quantity(
        "k_i", "1", "compliance constant of a disc that is clamped in its bore", role="step",
        source="series over all loads on the star",
    ).reads(lambda q: q.bodies.inner.k)  # fmt: skip
    k_o = Quantity(
        "k_o", "1", "compliance constant of a ring that is free at its rim", role="step",
        source="series over all loads on the ring",
    ).reads(lambda q: q.bodies.outer.k)  # fmt: skip
    c_o = Quantity("c_o", "1", "coefficient of the curvature term of d_o", role="step",
                   source="series").reads(lambda q: q.bodies.outer.c)  # fmt: skip
    d_i = Quantity(
        "d_i", "µm", "approach of roller and star", source="the star is clamped in its bore",
        tex=r"\frac{F_n}{\pi L E'} (2 \ln\left(\frac{4 r}{a_i}\right) - 1 + "
        r"2 \ln\left(\frac{l}{a_i}\right) + k_i)",
    ).reads(lambda q: q.state.d_i)  # fmt: skip
    d_o = Quantity(
        "d_o", "µm", "approach of roller and ring", source="the rim of the ring is free",
        tex=r"\frac{F_n}{\pi L E'} (2 \ln\left(\frac{4 r}{a_o}\right) - 1 + "
        r"2 \ln\left(\frac{R}{a_o}\right) + k_o + \frac{c_o a_o}{R})",
    ).reads(lambda q: q.state.d_o)  # fmt: skip
    alpha = Quantity(
        "α", "deg", "clamping angle under torque", equation="5", form="corrected",
        tex=r"\frac{1}{2} \arccos\left(\frac{X + r - d_i}{R - r + d_o}\right)",
    ).reads(lambda q: q.state.alpha)  # fmt: skip
    F_t = Quantity("F_t", "N", "tangential force at either contact of a roller", equation="3",
                   form="corrected", tex=r"\frac{T}{z R}").reads(lambda q: q.state.F_t)  # fmt: skip
    N = Quantity("F_n", "N", "normal force at either contact of a roller", equation="2",
                 tex=r"\frac{F_t}{\tan\left(\alpha\right)}").reads(lambda q: q.state.N)  # fmt: skip

    @Quantity("μ_T", "1", "required friction coefficient under torque alone", equation="1",
              safe="too high",
              tex=r"\tan\left(\alpha\right) = \frac{F_t}{F_n}")  # fmt: skip
    def mu_T(self) -> float:
        return float(np.tan(self.state.alpha))

    def refusal(self) -> str:
        """Reason why finite elements do not cover the inputs; empty if they do.

        Displacements under N_0 must be small.
        """
        same, under = self.loaded_by("N_0"), "under N = T/(z R tan α_0)"
        for one in (self, same, self.loaded_by("ψ")):
            _ = one.state  # ValueError if it has none
        wide = max(same.a_i, same.a_o) / self.r
        if wide > WIDE:
            return (
                f"the half-width of a contact is {wide:.3g} r {under}, more than {WIDE:g} r: "
                "displacements are not small; run check without --fem"
            )
        wall = self.R_a - self.R
        if same.d_o > BENT * wall:
            return (
                f"the ring deflects by {same.d_o * 1e6:.4g} µm {under}, more than {BENT:g} of its "
                f"wall thickness of {wall * 1e3:.4g} mm: displacements are not small; run check "
                "without --fem"
            )
        x = float(self.cam.centre(d_i=BEYOND * same.d_i, d_o=BEYOND * same.d_o)[0])
        left = float(self.cam.corner) - x
        if left < EDGE * same.a_i:
            return (
                f"{under}, the rollers come within {left * 1e3:.3g} mm of the ends of the flats; "
                "run check without --fem"
            )
        return ""
