"""A user's roller freewheel: whether it holds, its limits and the effect of tolerances."""

import math
from collections.abc import Iterator, Mapping
from typing import Any, ClassVar

import numpy as np

from analytic.freewheel import state, tilt
from analytic.freewheel.scatter import PERCENTILES, deviation
from verify.case import Comparison, Level, Quantity, drawn_by, shared
from verify.cases.freewheel.clutch import comparisons as compared
from verify.cases.freewheel.clutch import figures as drawn
from verify.cases.freewheel.clutch import messages
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.cases.freewheel.clutch.summary import summary
from verify.core.case import Values
from verify.form.adapter import adapted

PERCENTS = tuple(f"{p:g}" for p in PERCENTILES)
BELOW = "({0} % percentile of the random clutches whose rollers can wedge)"
WITHIN = "share of the random clutches that"


class FreewheelClutch(ClutchInputs):
    """A roller freewheel is checked for slip, and for the limit that it reaches first.

    The limits are friction, contact pressure, the ends of the cam flats, pop-through of the rollers
    and their tilt. Deviations of a few micrometres change the clamping angle, on which all limits
    depend.
    """

    id = "freewheel-clutch"
    title = "Roller freewheel under torque and axial load"
    source = "nagler2021"
    place = "Eqs. 1-10, Sec. 7"
    levels: ClassVar = (4, 7, 10)  # cells on the half-width of the fine zones
    readings: ClassVar = (
        "T and F_ax are loads of the whole clutch. F_a = F_ax/z and F_t = T/(z R) are forces at "
        "one contact of one roller",
        "R and r are radii, and X is the distance of a flat from the axis",
        "± is the tolerance of a dimension: three standard deviations of a normal distribution, or "
        "half of the range of a uniform distribution. s_μ is the standard deviation of the "
        "friction coefficient, which has a normal distribution",
        "the rollers are long, so that the state is plane strain",
    )
    assumptions: ClassVar = (
        "the paper prints no dimensions, friction coefficients or tolerances of its clutches: the "
        "default inputs describe a synthetic clutch",
        "the classes green, yellow and red by μ/μ_req follow the paper's observations on its test "
        "rig (Sec. 7). A clutch whose tan α_0 exceeds μ is red at any μ/μ_req",
        "all rollers of a clutch are identical and carry equal loads. Unloading, wear, crowned "
        "rollers, centrifugal forces and springs are neglected",
        "P(slip) is the share of clutches that slip, if all rollers of a clutch are identical. "
        "If r and X differ from roller to roller, the share of clutches in which at least one "
        "roller slips is 1.5 to 2 times P(slip) (computed for this synthetic clutch). The share of "
        "clutches in which all rollers together cannot carry the load is about P(slip)",
        "limits of the torque are computed at constant F_ax, and limits of the axial load at "
        "constant T. The couple of the axial forces makes the line load vary linearly along the "
        "roller",
        "the star of an inner cam is clamped in its bore. The bore of the shaft in an outer cam "
        "and the rim of the outer part are free. Finite elements cover only inner cams with one "
        "material for all parts",
    )

    @Quantity("σ", "1", "sign of the cam: +1 for an inner cam, −1 for an outer cam", role="step")
    def sense(self) -> float:
        return 1.0 if self.is_star else -1.0

    alpha_0 = Quantity(
        "α_0", "deg", "clamping angle without load", equation="4", form="corrected",
        tex=r"\frac{1}{2} \arccos\left(\frac{X + \sigma r}{R - \sigma r}\right)",
    ).reads(lambda q: q.cam.alpha0)  # fmt: skip

    @Quantity("μ_0", "1", "required friction coefficient without load", equation="1",
              safe="too high", tex=r"\tan\left(\alpha_0\right)")  # fmt: skip
    def mu_0(self) -> float:
        return math.tan(self.alpha_0)

    alpha = Quantity("α", "deg", "clamping angle under torque", equation="5",
                     form="corrected").reads(lambda q: q._of_state("alpha"))  # fmt: skip
    F_t = Quantity("F_t", "N", "tangential force of one contact", equation="3", form="corrected",
                   tex=r"\frac{T}{z R}").reads(lambda q: q._of_state("F_t"))  # fmt: skip
    N = Quantity(
        "F_n", "N", "normal force of one contact", equation="2",
        tex=r"\frac{F_t}{\tan\left(\alpha\right)}",
    ).reads(lambda q: q._of_state("N"))  # fmt: skip

    @Quantity("F_a", "N", "axial force of one roller", tex=r"\frac{F_{ax}}{z}")
    def F_a(self) -> float:
        return math.nan if self.duty.under is None else self.F_ax / self.z

    p_i = Quantity("p_i", "MPa", "peak pressure of the inner contacts (Hertz)",
                   safe="too high").reads(lambda q: q._of_state("p_i"))  # fmt: skip
    p_o = Quantity("p_o", "MPa", "peak pressure of the outer contacts (Hertz)",
                   safe="too high").reads(lambda q: q._of_state("p_o"))  # fmt: skip
    d_i = Quantity(
        "d_i", "µm", "elastic approach of roller and inner part",
    ).reads(lambda q: q._of_state("d_i"))  # fmt: skip
    d_o = Quantity(
        "d_o", "µm", "elastic approach of roller and outer part",
    ).reads(lambda q: q._of_state("d_o"))  # fmt: skip
    s = Quantity("s", "µm", "travel of the rollers' centres about the axis",
                 equation="6").reads(lambda q: q._of_state("s"))  # fmt: skip
    phi = Quantity(
        "φ", "deg", "wind-up angle by exact rolling", equation="7", form="corrected",
        tex=r"\frac{1}{R} \int \frac{\mathrm{d}d_i + \mathrm{d}d_o}{\tan\alpha}",
    ).reads(lambda q: q._of_state("phi"))  # fmt: skip
    phi_printed = Quantity(
        "φ", "deg", "wind-up angle", equation="7", form="as printed", form_of="phi",
        tex=r"\frac{s}{R} + \frac{s}{X}",
    ).reads(lambda q: q._of_state("phi_printed"))  # fmt: skip

    @Quantity("μ_req", "1", "required friction coefficient", equation="9", safe="too high",
              source="with F_ax of the whole clutch",
              tex=r"\tan\left(\alpha\right) \sqrt{1 + (\frac{F_{ax} R}{T})^2}")  # fmt: skip
    def mu_req(self) -> float:
        if (now := self.duty.under) is None:
            return math.nan
        return float(self.duty.required(self.T, now.alpha))

    @Quantity("μ/μ_req", "1", "ratio of available to required friction coefficient",
              equation="10", safe="too low", tex=r"\frac{\mu}{\mu_{req}}")  # fmt: skip
    def safety(self) -> float:
        return self.mu / self.mu_req

    F_slip = Quantity(
        "F_lim", "N", "axial load at which the contacts slip", equation="9", safe="too low",
        tex=r"\frac{T}{R} \sqrt{(\frac{\mu}{\tan\left(\alpha\right)})^2 - 1}",
    ).reads(lambda q: q._axial.get("slip", math.nan))  # fmt: skip
    F_tilt_lift = Quantity(
        "F_lift", "N", "axial load at which one end of the rollers lifts off", safe="too low",
    ).reads(lambda q: q._axial.get("tilt_lift", math.nan))  # fmt: skip
    F_tilt = Quantity("F_tilt", "N", "axial load at which e/L is (e/L)_lim",
                      safe="too low").reads(lambda q: q._axial.get("tilt", math.nan))  # fmt: skip
    F_pressure = Quantity(
        "F_p", "N", "axial load at which the peak pressure at the rollers' ends is p_lim",
        safe="too low",
    ).reads(lambda q: q._axial.get("pressure", math.nan))  # fmt: skip

    @Quantity("e", "µm", "axial shift of the normal forces by the tilting couple", role="step",
              tex=r"r (\cos\left(\alpha\right))^2 \frac{F_a}{F_n}")  # fmt: skip
    def e(self) -> float:
        if (now := self.duty.under) is None:
            return math.nan
        return float(tilt.offset(F_a=self.F_a, F_n=now.N, r=self.r, alpha=now.alpha))

    @Quantity(
        "e/L", "1", "ratio of the shift of the normal forces to the length of the rollers",
        tex=r"\frac{e}{L}",
    )  # fmt: skip
    def e_L(self) -> float:
        return self.e / self.L

    @Quantity("q/q_m", "1", "ratio of the maximum line load (at one end of a roller) to the mean")
    def peak(self) -> float:
        if not math.isfinite(self.e):
            return math.nan
        return float(tilt.peak_factor(e=self.e, L=self.L)) if self.e < self.L / 2 else math.inf

    @Quantity("p_end", "MPa", "peak pressure at the rollers' ends", safe="too high")
    def p_end(self) -> float:
        return max(self.p_i, self.p_o) * math.sqrt(self.peak)

    @Quantity("T_min", "N m", "smallest torque at which friction transmits the axial load")
    def T_bears(self) -> float:
        return self.duty.least_torque if self.T >= 0 else math.nan

    T_slip = Quantity("T_μ", "N m", "torque at which the contacts slip",
                      safe="too low").reads(lambda q: q._torques.get("slip", math.nan))  # fmt: skip
    T_pressure_inner = Quantity(
        "T_pi", "N m", "torque at which the peak pressure of the inner contacts is p_lim",
        safe="too low",
    ).reads(lambda q: q._torques.get("pressure_inner", math.nan))  # fmt: skip
    T_pressure_outer = Quantity(
        "T_po", "N m", "torque at which the peak pressure of the outer contacts is p_lim",
        safe="too low",
    ).reads(lambda q: q._torques.get("pressure_outer", math.nan))  # fmt: skip
    T_corner = Quantity(
        "T_c", "N m", "torque at which the rollers reach the ends of the cam flats", safe="too low",
    ).reads(lambda q: q._torques.get("corner", math.nan))  # fmt: skip
    T_pop_through = Quantity(
        "T_pop", "N m", "torque at which the rollers pop through", safe="too low",
    ).reads(lambda q: q._torques.get("pop_through", math.nan))  # fmt: skip

    @Quantity(
        "dα_0/d{0}", "deg/mm", "derivative of the clamping angle without load with respect to {0}"
    ).over(("X", "r", "R"))
    def dalpha_0_d(self, dimension: str) -> float:
        return next(s.slope for s in self.slopes if s.name == dimension)

    @Quantity("dα(T)/dX", "deg/mm", "derivative of the clamping angle under torque with "
                                  "respect to X")  # fmt: skip
    def dalpha_dX(self) -> float:
        if self.duty.under is None:
            return math.nan
        flats = (self.moved(dX) for dX in (-self.off, self.off))
        low, high = (float(state.loaded(clutch, self.T).alpha) for clutch in flats)
        return (high - low) / (2 * self.off)

    @Quantity("s(α_0)", "deg", "standard deviation of the clamping angle without load")
    def s_alpha_0(self) -> float:
        return deviation(self.cam, self.sigma)

    P_slip = Quantity(
        "P(slip)", "%", "share of the random clutches that slip",
    ).reads(lambda q: q._scattered.get("P_slip", math.nan))  # fmt: skip
    P_no_wedge = Quantity(
        "P(gap)", "%", "share of the random clutches whose rollers cannot wedge",
    ).reads(lambda q: q._scattered.get("P_no_wedge", math.nan))  # fmt: skip
    P_no_state = Quantity(
        "P(through)", "%", f"{WITHIN} have no equilibrium: pop-through, or contacts too wide for "
                           "the formulas",
    ).reads(lambda q: q._scattered.get("P_no_state", math.nan))  # fmt: skip
    P_corner = Quantity(
        "P(corner)", "%", "share of the random clutches that have rollers beyond the ends of the "
                          "flats",
    ).reads(lambda q: q._scattered.get("P_corner", math.nan))  # fmt: skip

    @Quantity("{0}", "%", f"{WITHIN} are in class {{0}} by μ/μ_req").over(
        ("green", "yellow", "red")
    )
    def share(self, light: str) -> float:
        return self._scattered.get(f"share_{light}", math.nan)

    @Quantity("α_0,{0}%", "deg", f"clamping angle without load {BELOW}").over(PERCENTS)
    def alpha_0_below(self, percent: str) -> float:
        return self._scattered.get(f"alpha_0_{percent}", math.nan)

    @Quantity("α_T,{0}%", "deg", f"clamping angle under torque {BELOW}").over(PERCENTS)
    def alpha_below(self, percent: str) -> float:
        return self._scattered.get(f"alpha_{percent}", math.nan)

    @Quantity("μ/μ_req,{0}%", "1", f"ratio μ/μ_req {BELOW}").over(PERCENTS)
    def safety_below(self, percent: str) -> float:
        return self._scattered.get(f"safety_{percent}", math.nan)

    def _of_state(self, name: str) -> float:
        now = self.duty.under
        return math.nan if now is None else float(getattr(now, name))

    @shared
    def _axial(self) -> Mapping[str, float]:
        """Limits of the axial load [N] at the given torque, by key."""
        return {limit.key: limit.at for limit in self.duty.of_axial_load}

    @shared
    def _torques(self) -> Mapping[str, float]:
        """Limits of the torque [N m] at the given axial load, by key."""
        return {x.key: x.at for x in self.duty.of_torque} if self.T >= 0 else {}

    @shared
    def _scattered(self) -> Mapping[str, float]:
        """Shares and percentiles over random clutches within the tolerances, by name."""
        return {} if self.scatter is None else self.scatter.values()

    @shared
    def values(self) -> Values:
        """Values in SI units; infinite values and quantities that do not exist are left out."""
        found = {q.name: float(getattr(self, q.name)) for q in self.present()}
        return {name: value for name, value in found.items() if np.isfinite(value)}

    def reference(self, level: int) -> Level:
        """Finite elements: sweep over the torque, states with shifted flats, slip near mu_req."""
        from verify.cases.freewheel.clutch.reference import solve

        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows on results under the torque, with shifted flats, and with friction near mu_req."""
        yield from compared.comparisons(self, FreewheelClutch)

    figures = drawn_by(drawn.figures)
    sketch = drawn.sketch

    def warnings(self) -> Iterator[str]:
        """Warnings on exceeded limits of pressure and tilt, and on large tolerances."""
        yield from messages.warnings(self, self.values)

    def advice(self) -> Iterator[str]:
        """Verdict, limits and recommended changes."""
        yield from messages.findings(self, self.values)

    def summary(self) -> Mapping[str, Any]:
        """Class, friction ratio and limits, for JSON."""
        return summary(self, self.values)

    def refusal(self) -> str:
        """Reason why the finite elements of this case do not cover the clutch; empty if they do."""
        if not self.is_star:
            return (
                "finite elements of this case cover only inner cams (the case freewheel-cup "
                "compares outer cams); run check without --fem"
            )
        if self.T <= 0 or self.duty.under is None:
            return (
                "finite elements require a torque in the locking direction at which an equilibrium "
                "exists; run check without --fem"
            )
        if not self.like:
            return (
                "finite elements require one material for all parts; run check without --fem for "
                "different materials"
            )
        try:
            return self.as_star.refusal()
        except ValueError as error:
            words = str(error).partition("Value error, ")[2].partition(" [type=")[0] or str(error)
            return f"finite elements do not cover these inputs: {words}"


CLUTCH = adapted(FreewheelClutch)
