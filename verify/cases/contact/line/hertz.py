"""Hertz's line contact: what the cases of a roller on a flat, on a roller and in a race share."""

import math
from collections.abc import Callable, Iterator
from typing import Any, ClassVar, Self

from analytic.contact import hertz_line, hertz_line_stress
from verify.case import Case, Comparison, Quantity, balance, given
from verify.core.case import Context
from verify.core.figures import Array
from verify.judging.profile_checks import Within, l2_error

NARROWEST = 1e-4  # smallest a/R for which round-off is negligible
WIDEST = 0.3  # largest a over the smallest radius for which finite elements are used
STATIC_RATING = 4.0e9  # Pa, ISO 76: pressure of roller bearings at their static load rating
HERTZ = "Hertz; basis of Eqs. 2-5"
PROFILE = 0.03  # accepted error of q(x) in L2
ROUND = "direct solution; the load is reached within 1e-12 of its value"


class LineContact(Case):
    """Line contact of long bodies in plane strain, with the load F on the length L."""

    source = "huang2018"
    place = "Eqs. 2-5, based on Hertz's line contact"
    levels: ClassVar = (2, 3, 4, 6)

    F: float = given("3407 N", "N", "F", "normal load", gt=0, le=1e9)
    L: float = given("9 mm", "mm", "L", "length of the contact", gt=0, le=1e4)
    R_p: float | None = given(
        None, "MPa", "R_p", "yield strength", omitted=None, gt=0,
        example="2000 MPa",
    )  # fmt: skip

    line_load: ClassVar[float | None] = None  # [N/m], in place of F/L

    @Quantity("P", "N/mm", "load per length", role="geometry", tex=r"\frac{F}{L}")
    def P(self) -> float:
        return self.F / self.L if self.line_load is None else self.line_load

    @Quantity("E*", "GPa", "contact modulus, plane strain", role="step", source="Hertz")
    def E_star(self) -> float:
        raise NotImplementedError

    @Quantity("a", "µm", "half-width, Hertz", source=HERTZ,
              tex=r"\sqrt{\frac{4 P R}{\pi E*}}")  # fmt: skip
    def a(self) -> float:
        return float(hertz_line.half_width(P=self.P, R=self.relative, E_star=self.E_star))

    @Quantity("p_0", "MPa", "peak pressure, Hertz", source=HERTZ, safe="too high",
              tex=r"\frac{2 P}{\pi a}")  # fmt: skip
    def p_0(self) -> float:
        return float(hertz_line.peak_pressure(P=self.P, R=self.relative, E_star=self.E_star))

    @Quantity("z", "µm", "depth of the largest shear stress, Hertz", source="Hertz: 0.786 a",
              role="step", tex=r"\frac{a}{\sqrt{\frac{1 + \sqrt{5}}{2}}}")  # fmt: skip
    def z(self) -> float:
        return float(hertz_line_stress.largest_shear_stress(a=self.a, p_0=self.p_0)[1])

    @Quantity("τ_max", "MPa", "largest shear stress, Hertz", source="Hertz: 0.300 p_0",
              safe="too high",
              tex=r"p_0 \left(\frac{z}{a} - \frac{z^2}{a \sqrt{a^2 + z^2}}\right)")  # fmt: skip
    def tau_max(self) -> float:
        return float(hertz_line_stress.largest_shear_stress(a=self.a, p_0=self.p_0)[0])

    @property
    def relative(self) -> float:
        """Relative radius of the surfaces in Hertz's theory [m]."""
        raise NotImplementedError

    @property
    def radii(self) -> tuple[float, float]:
        """Radii of the upper body and of the lower body [m], negative for a bore."""
        raise NotImplementedError

    @property
    def curvature(self) -> float:
        """Relative curvature of the surfaces [1/m]."""
        one, other = self.radii
        return 1 / one + 1 / other

    @property
    def softness(self) -> float:
        """Sum of (1 - nu^2)/E of both bodies [1/Pa]."""
        raise NotImplementedError

    @property
    def smallest(self) -> float:
        """Smallest dimension of the bodies [m]; Hertz's theory requires that a is much smaller."""
        raise NotImplementedError

    @property
    def smallest_name(self) -> str:
        """Name of the smallest dimension of the bodies."""
        return "the roller's radius"

    @property
    def guess(self) -> float:
        """Estimate of the half-width [m]; it sets the size of the finest cells only."""
        return math.sqrt(4 * self.P * self.softness / (math.pi * self.curvature))

    def under(self, P: float) -> Self:
        """The bodies under the load per length P [N/m]."""
        return self.variant(line_load=P)

    def check_load(self, sizes: str) -> None:
        """Raise ValueError if the contact is too wide for bodies; the message states `sizes`."""
        if self.guess > WIDEST * self.smallest:
            raise ValueError(
                f"F = {self.F:g} N on L = {self.L * 1e3:g} mm: the half-width of the contact, "
                f"{self.guess * 1e3:.3g} mm, must not exceed {WIDEST:g} times the smallest "
                f"dimension of the bodies ({sizes}): reduce F or increase L"
            )

    def pressure(self, x: Any) -> Array:
        """Hertz's pressure [Pa] at x [m]."""
        return hertz_line.pressure(x, a=self.a, p_0=self.p_0)

    def near_hertz(self, pressure: Callable[[Any], Array]) -> Comparison:
        """Row: the pressure profile by finite elements agrees with `pressure` within `PROFILE`."""

        def margin(context: Context) -> tuple[float, float]:
            errors = l2_errors(pressure)(context)
            return PROFILE - errors[-1], abs(errors[-1] - errors[-2])

        name = f"L2 error of the pressure profile relative to Hertz below {PROFILE:.0%}"
        check = Within(name=name, symbol="e_2", unit="1", margin=margin, accepted=PROFILE)
        return Comparison(check=check, quantity=type(self).p_0)

    def balances(self) -> Iterator[Comparison]:
        """Rows: balances of forces and moments on the upper roller."""
        force, moment = {"P": self.P}, {"P R": self.P * self.radii[0]}
        for name, key, symbol, unit, scale in (
            ("forces perpendicular to the load", "balance_x", "ΣF_x", "N/mm", force),
            ("forces parallel to the load", "balance_y", "ΣF_y", "N/mm", force),
            ("moments", "moment", "ΣM", "N", moment),
        ):
            yield balance(key, f"balance of {name}", symbol, unit, of=scale, bound=1e-8,
                          because=ROUND)  # fmt: skip

    def refusal(self) -> str:
        """Reason for not solving very narrow contacts (round-off); "" for wider contacts."""
        ratio = self.guess / self.smallest
        if ratio >= NARROWEST:
            return ""
        return (
            f"half-width a = {self.guess * 1e3:.3g} mm is {ratio:.1g} of the smallest dimension of "
            f"the bodies; finite elements require at least {NARROWEST:g} because of round-off: run "
            "`check` without --fem"
        )

    def warnings(self) -> Iterator[str]:
        """Warnings if Hertz's formulas are not valid for these inputs."""
        ratio = self.a / self.smallest
        if ratio > 0.05:
            yield (
                f"half-width a = {self.a * 1e3:.4g} mm is {ratio:.1%} of {self.smallest_name} "
                f"({self.smallest * 1e3:.4g} mm), more than 5 %: Hertz's theory, which replaces "
                "the body by a half-plane, becomes inaccurate"
            )
        if self.R_p is not None and 2 * self.tau_max > self.R_p:
            yield (
                f"Tresca stress 2 τ_max = {2 * self.tau_max / 1e6:.4g} MPa below the surface "
                f"exceeds R_p = {self.shown('R_p')}: the roller yields, Hertz's theory is invalid"
            )
        if self.R_p is None and self.p_0 > STATIC_RATING:
            yield (
                f"p_0 = {self.shown('p_0')} exceeds 4000 MPa, the static load rating of hardened "
                "rollers (ISO 76): permanent indentations are expected; enter R_p"
            )
        if self.a > self.L / 10:
            yield (
                f"L = {self.shown('L')} is only {self.L / self.a:.3g} times a (at least 10 "
                "required): the ends change the pressure, so that this is no line contact"
            )


def at(q: Quantity, where: str) -> str:
    """Name of the row on `q` in the state `where`, for example "half-width, a/R = 0.15, Hertz"."""
    name, theory = q.what.rsplit(", ", 1)
    return f"{name}, {where}, {theory}" if where else q.what


def l2_errors(pressure: Callable[[Array], Array]) -> Callable[[Context], list[float]]:
    """Function that returns, for each level, the relative L2 error of the contact pressure."""

    def errors(context: Context) -> list[float]:
        found = []
        for result in context.fem:
            x, p, weight = (result.arrays[key] for key in ("x", "p", "weight"))
            exact = pressure(x)
            found.append(l2_error(p - exact, exact, weight))
        return found

    return errors
