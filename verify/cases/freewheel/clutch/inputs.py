"""Inputs of a roller freewheel of either kind: dimensions, loads, materials and tolerances."""

import math
import re
from collections.abc import Mapping
from typing import Any, ClassVar, Literal, Self

from pydantic import model_validator

from analytic.freewheel.cam import Cam
from analytic.freewheel.clutch import ContactMaterial, RollerClutch
from analytic.freewheel.duty import Duty
from analytic.freewheel.geometry import InnerCam, OuterCam
from analytic.freewheel.remedies import shifted
from analytic.freewheel.scatter import Scatter, Slope, scatter, slopes
from verify.case import Case, count, given, shared, word
from verify.cases.freewheel.inputs import in_millimetres
from verify.cases.freewheel.star import Star

Kind = Literal["inner cam", "outer cam"]
Spread = Literal["normal", "uniform"]

OFF = 5e-6  # change of X [m] in both directions, if the wedges permit it
TURNED = 0.05  # largest relative change of the angle that counts as small
DEVIATIONS = {"normal": 3.0, "uniform": math.sqrt(3)}  # tolerance over standard deviation of a part


def in_terms_of_inputs(rule: str) -> str:
    """Text of the violated rule of a formula, with the names of the inputs and lengths in mm."""
    named = re.sub(r"\b(R_s|X_o)\b", lambda m: m[1][0], rule)
    return in_millimetres(named)


def other_modulus(part: str, what: str, example: str) -> Any:
    """Optional input: Young's modulus of a part, if it differs from the common modulus E."""
    what = f"Young's modulus of {what}, if different from E; if ν_{part} is not given, ν is used"
    return given(None, "GPa", f"E_{part}", what, omitted=None, gt=0.1, le=1e5, example=example)


def other_poisson(part: str, what: str, example: str) -> Any:
    """Optional input: Poisson's ratio of a part, if it differs from the common ratio ν."""
    return given(None, "1", f"ν_{part}", f"Poisson's ratio of {what}, if different from ν",
                 omitted=None,
                 ge=0, le=0.45, example=example)  # fmt: skip


class ClutchInputs(Case):
    """z rollers between flats and a circular race, under a torque and an axial load."""

    instead: ClassVar[tuple[str, Mapping[str, str]]] = (
        "for an outer cam, replace the lines above that have the same names by these lines",
        {"kind": '"outer cam"', "R": '"10 mm"', "r": '"2 mm"', "X": '"13.88322 mm"',
         "R_a": '"17.5 mm"', "r_b": '"0 mm"', "L": '"10 mm"', "T": '"20 N m"'},
    )  # fmt: skip

    kind: Kind = word(
        "inner cam",
        "inner cam: star with flats, in a ring with the bore radius R; outer cam: cup with flats, "
        "on a shaft with the radius R",
    )
    R: float = given("16.5 mm", "mm", "R", "radius of the circular race: bore of the "
                        "outer ring (inner cam) or shaft (outer cam)", gt=0.1, le=1e5)  # fmt: skip
    r: float = given("2.5 mm", "mm", "r", "radius of the rollers", gt=0.01, le=1e5)
    X: float = given("11.39565 mm", "mm", "X", "distance of the flats from the axis", ge=-1e5,
                        le=1e5)  # fmt: skip
    R_a: float = given("21 mm", "mm", "R_a", "outer radius of the outer part; for a "
                          "drawn cup, of the housing into which it is pressed", gt=0.1,
                          le=1e5)  # fmt: skip
    r_b: float = given("7.5 mm", "mm", "r_b", "bore radius of the inner part; 0 for a solid "
                          "shaft in an outer cam", ge=0, le=1e5)  # fmt: skip
    z: int = count(8, "z", "number of rollers", ge=3, le=100)
    L: float = given("10 mm", "mm", "L", "length of the rollers", gt=0.01, le=1e6)
    T: float = given("26 N m", "N m", "T", "torque, positive in the locking direction", ge=-1e9,
                        le=1e9, claims="nagler2021:rig-torque")  # fmt: skip
    F_ax: float = given("600 N", "N", "F_ax", "axial load on the whole clutch", ge=0, le=1e9)
    mu: float = given(0.08, "1", "μ", "coefficient of friction, equal at all contacts", ge=1e-3,
                         le=2)  # fmt: skip
    E: float = given("206 GPa", "GPa", "E", "Young's modulus", gt=0.1, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    E_r: float | None = other_modulus("r", "the rollers", "310 GPa")
    nu_r: float | None = other_poisson("r", "the rollers", "0.27")
    E_i: float | None = other_modulus("i", "the inner part", "206 GPa")
    nu_i: float | None = other_poisson("i", "the inner part", "0.3")
    E_o: float | None = other_modulus("o", "the outer part", "206 GPa")
    nu_o: float | None = other_poisson("o", "the outer part", "0.3")
    p_lim: float | None = given(
        "4000 MPa", "MPa", "p_lim", "permissible contact pressure", omitted=None, gt=0, le=1e6,
    )  # fmt: skip
    e_lim: float | None = given(
        None, "1", "(e/L)_lim", "permissible ratio of the shift e of the contact forces along the "
                                "rollers to L; default 1/6, at which one end lifts off",
                                omitted=None, gt=0, lt=0.5,
        example="0.1",
    )  # fmt: skip
    X_tol: float = given("5 µm", "µm", "t_X", "tolerance ± of X", omitted=0.0, ge=0, le=1e4)
    r_tol: float = given("2 µm", "µm", "t_r", "tolerance ± of r", omitted=0.0, ge=0, le=1e4)
    R_tol: float = given("5 µm", "µm", "t_R", "tolerance ± of R", omitted=0.0, ge=0, le=1e4)
    s_mu: float = given(0.004, "1", "s_μ", "standard deviation of μ", omitted=0.0, ge=0, lt=1)
    spread: Spread = word(
        "normal",
        "distribution of the dimensions: normal (a tolerance is three standard deviations) or "
        "uniform",
    )

    @model_validator(mode="after")
    def _fits(self) -> Self:
        try:
            _ = self.clutch
        except ValueError as error:
            raise ValueError(in_terms_of_inputs(str(error))) from error
        for name in ("X_tol", "r_tol", "R_tol"):
            if not getattr(self, name) < 0.1 * self.r:
                raise ValueError(
                    f"each tolerance must be small: {name} must be below r/10, got {name} = "
                    f"{getattr(self, name) * 1e6:.6g} µm, r = {self.r * 1e3:.6g} mm"
                )
        for wall, thick, t in self._walls():
            if not thick > 2 * t:
                raise ValueError(
                    f"each wall must be thicker than twice its tolerance, got {wall} = "
                    f"{thick * 1e6:.4g} µm, tolerance ±{t * 1e6:.4g} µm"
                )
        if not self.s_mu < 0.5 * self.mu:
            raise ValueError(
                "s_mu must be below μ/2, so that μ - 2 s_mu is positive, got s_mu = "
                f"{self.s_mu:g}, μ = {self.mu:g}"
            )
        return self

    def _walls(self) -> tuple[tuple[str, float, float], ...]:
        """Name, thickness [m] and tolerance [m] of the thinnest wall, for inner and outer part."""
        if self.is_star:
            return ("X - r_b", self.X - self.r_b, self.X_tol), ("R_a - R", self.R_a - self.R,
                                                                self.R_tol)  # fmt: skip
        far = 1 / math.cos(math.pi / self.z)
        return (
            ("R - r_b", self.R - self.r_b, self.R_tol),
            ("R_a - X/cos(π/z)", self.R_a - far * self.X, far * self.X_tol),
        )

    @property
    def is_star(self) -> bool:
        return self.kind == "inner cam"

    @property
    def cam(self) -> Cam:
        """The cam; raises ValueError if rollers and races form no wedge."""
        if self.is_star:
            return InnerCam(R=self.R, r=self.r, X=self.X, z=self.z)
        return OuterCam(R_s=self.R, r=self.r, X_o=self.X, z=self.z)

    def moved(self, dX: float) -> RollerClutch:
        """The clutch with its flats `dX` [m] farther from the axis."""
        return shifted(self.clutch, "X", dX)

    @property
    def off(self) -> float:
        """Shift [m] of the flats with which the derivative dalpha/dX under torque is computed."""
        x, _ = self.cam.centre(d_i=0.0, d_o=0.0)
        return min(OFF, TURNED * float(x) * 2 * float(self.cam.alpha0))

    @property
    def as_star(self) -> Star:
        """The clutch as an inner cam of one material; raises ValueError if that is impossible."""
        names = ("R", "r", "X", "R_a", "r_b", "z", "L", "T", "E", "nu")
        return Star(**{name: getattr(self, name) for name in names})

    @property
    def clutch(self) -> RollerClutch:
        """The clutch with its materials; raises ValueError if a part has no wall."""
        return RollerClutch(
            cam=self.cam, L=self.L, r_b=self.r_b, R_a=self.R_a, roller=self._material("r"),
            inner=self._material("i"), outer=self._material("o"),
        )  # fmt: skip

    @shared
    def duty(self) -> Duty:
        """The clutch with its loads, friction and limits."""
        return Duty(clutch=self.clutch, T=self.T, F_ax=self.F_ax, mu=self.mu, p_lim=self.p_lim,
                    e_lim=self.e_lim)  # fmt: skip

    @shared
    def scatter(self) -> Scatter | None:
        """Random clutches under the loads of this clutch; None without tolerances."""
        return scatter(self.duty, self.deviations, self.spread)

    @property
    def sigma(self) -> dict[str, float]:
        """Standard deviations [m] of the cam's dimensions, by name."""
        return {name: s for name, s in self.deviations.items() if name != "mu"}

    @property
    def slopes(self) -> list[Slope]:
        """Derivatives of alpha_0 with respect to X, r and R."""
        return slopes(self.cam, self.sigma)

    @property
    def like(self) -> bool:
        """Whether all parts have the same material."""
        return all(self._constants(part) == (self.E, self.nu) for part in "rio")

    @property
    def deviations(self) -> dict[str, float]:
        """Standard deviations of the cam's dimensions [m] and of mu, by name; zeros are omitted."""
        over = DEVIATIONS[self.spread]
        names = ("X", "R") if self.is_star else ("X_o", "R_s")
        found = {names[0]: self.X_tol, "r": self.r_tol, names[1]: self.R_tol}
        found = {name: t / over for name, t in found.items()} | {"mu": self.s_mu}
        return {name: s for name, s in found.items() if s > 0}

    def _material(self, part: str) -> ContactMaterial:
        E, nu = self._constants(part)
        return ContactMaterial(E=E, nu=nu)

    def _constants(self, part: str) -> tuple[float, float]:
        E, nu = getattr(self, f"E_{part}"), getattr(self, f"nu_{part}")
        return self.E if E is None else E, self.nu if nu is None else nu
