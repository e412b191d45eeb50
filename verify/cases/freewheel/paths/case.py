"""A roller freewheel on the load paths of the test rig (Nagler, Lohrengel, Sec. 6).

The paths are series of static equilibria. Inertia would add about (f/f_0)² of the loads, where
f_0 is the natural frequency of the ring alone on the wedged rollers.
"""

import math
from collections.abc import Iterator
from dataclasses import fields
from typing import ClassVar, Self

import numpy as np
from pydantic import model_validator

from analytic.bounds.freewheel import friction
from analytic.bounds.freewheel.intervals import Interval
from analytic.bounds.freewheel.slip_times import Rig
from analytic.freewheel.course import Course, follow
from analytic.freewheel.load_path import AlternatingAxial, AxialRamp, BothAlternating, LoadPath
from analytic.freewheel.state import RollerClutchState, loaded
from verify.case import Comparison, Level, Quantity, Scan, drawn_by, given, shared
from verify.cases.freewheel import pictures, star_sketch
from verify.cases.freewheel.bounds import of_star
from verify.cases.freewheel.paths import comparisons as compared
from verify.cases.freewheel.paths import figures as drawn
from verify.cases.freewheel.pulled import Pulled
from verify.core.case import Check
from verify.core.figures import Picture
from verify.form.adapter import adapted

MOST = 1000  # cycles of a path
CASES = (1, 2, 3)
STEP = 1e-3  # torque step over T for the stiffness
SWAY = 0.01  # inertia over the loads that may be neglected
TIMES = 240  # time steps of a cycle
LEAST = 2000  # time steps of a path, at least
ROUND_OFF = 1e-9  # relative to the number of cycles: avoids an additional time by round-off
CLOSE = 0.02  # friction closer to tan(alpha), relative, leaves too small an axial load
LIGHTEST = 0.05  # least torque of load case 3, over the largest torque
SWINGS = 0.25  # inertia over the loads above which it is not small
WORN = 2.0  # largest mu_req for finite elements
SETTLES = 0.6  # over the limit: lower alternating loads settled for the synthetic clutch


class LoadPaths(Pulled):
    """Roller freewheel that the test rig loads along three paths.

    The axial load grows under constant torque, alternates under constant torque, or alternates in
    phase with the torque. The criterion gives the required friction along each path and the time of
    slip. Finite elements follow the paths with the history of the friction forces. The load at slip
    is the same on every path. Below this load, an alternating axial load rotates the ring further
    with each cycle (ratcheting).
    """

    id = "freewheel-paths"
    title = "Load paths of the test rig"
    source = "nagler2021"
    place = "Secs. 6 and 7, Eqs. 8-10"
    levels: ClassVar = (3, 4, 5)  # cells on the half-width of the fine zones
    scans: ClassVar = (
        Scan(vary=("T=13N m,26N m", "mu=0.07,0.08,0.1"), only=("required friction, load case 3",),
             star=True),
    )  # fmt: skip
    readings: ClassVar = (
        "in load case 2, the axial load alternates about zero. In load case 3, torque and axial "
        "load are in phase. Both are assumed, because Fig. 7 is not in the text of the paper",
        "T is the steady torque of load cases 1 and 2 and the torque amplitude of load case 3. "
        "F_ax is the axial load on the whole clutch at the end of the path, or its amplitude there",
        "amplitudes grow in proportion to time",
        "at T < 0 the clutch overruns, and the criterion does not apply",
        "the class limits 0.8 and 1.0 of μ/μ_req were observed in the test runs of the paper. They "
        "are used as printed and not derived",
    )
    assumptions: ClassVar = (
        "all states are static equilibria: at 30 Hz, the inertia of the ring increases the loads "
        "only by the fraction (f/f_0)² = 0.03 %. Even thirty times this inertia would increase "
        "them only by 1 %. The inertia of rollers and oil is also neglected",
        "rise time, duration, μ and all dimensions are user inputs, because the text of the paper "
        "does not contain the settings of Table 1. The default clutch is synthetic",
        "in the finite elements of load cases 1 and 2, every extreme of the axial load is a load "
        "step that starts from the friction forces of the preceding extreme. The drive holds the "
        "torque constant and rotates the ring as the rollers creep. Fewer cycles than "
        "those of the path are computed, with smaller amplitudes. This is sufficient, because the "
        "load at slip does not depend on the cycles",
        "in load case 3, the rollers travel by more than the width of their contacts between zero "
        "torque and 26 N m. In the finite elements, each torque has a separate position of the "
        "roller, and torque and axial load are applied together",
        "the expected errors have two causes. The first is the error of tan α of one contact: the "
        "compliance of the star is only known to lie between the smallest and the largest "
        "compliance of three bodies (a layer as thick as the star at the flats, and two discs, of "
        "the radius of the flats and of the corners). The second is the tilt of the surfaces "
        "under the normal force. The relative error of the axial load at slip is larger than that "
        "of tan α by the factor 1/(1 − (tan α/μ)²)",
    )

    F_ax: float = given("3 kN", "N", "F_ax", "axial load on the whole clutch, or its "
                        "amplitude, at the end of the path",
                        gt=0, le=1e9, claims="nagler2021:rig-axial-load")  # fmt: skip
    T_m: float = given("0 N m", "N m", "T_m",
                       "mean torque of load case 3; T is the amplitude about this mean",
                       ge=0, le=1e9)  # fmt: skip
    f: float = given("30 Hz", "Hz", "f", "frequency of the alternating loads", gt=0, le=1e5,
                     claims="nagler2021:rig-frequency")  # fmt: skip
    rise: float = given("0.1 s", "s", "t_T", "time in which the torque rises from 0 to T in load "
                        "cases 1 and 2", gt=0, le=1e6)  # fmt: skip
    duration: float = given("0.5 s", "s", "t_end", "time at the end of the path, when the axial "
                            "load or its amplitude is F_ax", gt=0, le=1e6)  # fmt: skip
    rho: float = given("7850 kg/m^3", "kg/m^3", "ρ", "density of the ring", gt=0, le=1e5)

    @model_validator(mode="after")
    def _times(self) -> Self:
        if not self.rise < self.duration:
            raise ValueError(
                "the torque must reach T before the end of the path: rise must be below duration, "
                f"got rise = {self.rise:g} s, duration = {self.duration:g} s"
            )
        if self.f * self.duration > MOST:
            raise ValueError(
                f"a path may have at most {MOST} cycles, got f times duration = "
                f"{self.f * self.duration:g}; reduce f or duration"
            )
        return self

    @Quantity("T_c", "N m", "torque at the instant of slip in load case 3, at the amplitude "
                            "F_lim3 of the axial load",
              role="geometry")  # fmt: skip
    def T_critical(self) -> float:
        # About zero it is the peak, F_ax/T is the same all the time and alpha largest; about a mean
        # that keeps it positive the trough, where F_ax is as large and N least. Between lies a zero
        # under axial load: 0.
        return self.T if self.T_m == 0 else max(self.T_m - self.T, 0.0)

    @Quantity("α_c", "deg", "clamping angle under the torque T_c", role="step",
              when=lambda q: q.T_critical > 0)  # fmt: skip
    def alpha_critical(self) -> float:
        return float(loaded(self.clutch, self.T_critical).alpha)

    @Quantity("F_lim3", "N", "amplitude of the axial load at slip, load case 3", equation="9",
              safe="too low",
              tex=r"\frac{T_c}{R} \sqrt{(\frac{\mu}{\tan\left(\alpha_c\right)})^2 - 1}"
              )  # fmt: skip
    def F_lim_3(self) -> float:
        return self.largest_axial_load(self.T_critical) if self.T_critical else 0.0

    @Quantity("μ_{0}", "1", "largest required friction coefficient, load case {0}",
              source="Eqs. 8 and 9 along the paths of Sec. 6",
              safe="too high").over(CASES)  # fmt: skip
    def peak(self, case: int) -> float:
        return self.courses[case].peak

    @Quantity("t_{0}", "s", "time at which the required friction is largest, load case {0}",
              role="step").over(CASES)  # fmt: skip
    def when(self, case: int) -> float:
        return self.courses[case].when

    @Quantity(
        "μ/μ_{0}", "1", "smallest ratio of available to required friction, load case {0}",
        safe="too low",
    ).over(CASES)  # fmt: skip
    def safety(self, case: int) -> float:
        return self.mu / self.courses[case].peak

    @Quantity("t_s{0}", "s", "first time of slip, load case {0}", safe="too low").over(CASES)
    def slip(self, case: int) -> float:
        return self.courses[case].slips_at

    F_2 = Quantity(
        "F_2", "N", "axial load at the time t_2 of the largest required friction, load case 2",
        role="step",
        tex=r"F_{ax} \frac{t_2 - t_T}{t_{end} - t_T} " r"\sin\left(2 \pi f (t_2 - t_T)\right)",
    ).reads(lambda q: q.paths[2].axial_load(q.courses[2].when))  # fmt: skip
    phi = Quantity(
        "φ", "deg", "wind-up angle under the largest torque", equation="7", form="corrected",
        tex=r"\frac{1}{R} \int \frac{\mathrm{d}d_i + \mathrm{d}d_o}{\tan\alpha}",
    ).reads(lambda q: q._top.phi)  # fmt: skip

    @Quantity("k", "N m/rad", "torsional stiffness of the wedged rollers under T", role="step",
              tex=r"\frac{\mathrm{d}T}{\mathrm{d}\varphi}")  # fmt: skip
    def stiffness(self) -> float:
        phi = loaded(self.clutch, self.T * np.array([1 - STEP, 1 + STEP])).phi
        return float(2 * STEP * self.T / (phi[1] - phi[0]))

    @Quantity("J", "kg m^2", "moment of inertia of the ring", role="step",
              tex=r"\frac{\pi}{2} \rho L (R_a^4 - R^4)")  # fmt: skip
    def inertia(self) -> float:
        return self.rho * math.pi / 2 * (self.R_a**4 - self.R**4) * self.L

    @Quantity("f_0", "Hz", "natural frequency of the ring on the wedged rollers",
              role="step", tex=r"\frac{\sqrt{\frac{k}{J}}}{2 \pi}")  # fmt: skip
    def f_0(self) -> float:
        return math.sqrt(self.stiffness / self.inertia) / (2 * math.pi)

    @Quantity("(f/f_0)²", "1", "approximate ratio of inertia forces to loads", role="step",
              tex=r"(\frac{f}{f_0})^2")  # fmt: skip
    def sway(self) -> float:
        return (self.f / self.f_0) ** 2

    @property
    def T_peak(self) -> float:
        """Largest torque of load case 3 [N m]."""
        return self.T_m + self.T

    @property
    def rig(self) -> Rig:
        """Second implementation of the load paths, for judging times of slip."""
        return Rig(**{f.name: getattr(self, f.name) for f in fields(Rig)})

    @property
    def paths(self) -> dict[int, LoadPath]:
        """The load paths by the numbers of their load cases."""
        ramp = {"T": self.T, "F": self.F_ax, "rise": self.rise, "duration": self.duration}
        return {
            1: AxialRamp(**ramp), 2: AlternatingAxial(**ramp, frequency=self.f),
            3: BothAlternating(T=self.T, F=self.F_ax, frequency=self.f, duration=self.duration,
                               T_m=self.T_m),
        }  # fmt: skip

    @shared
    def courses(self) -> dict[int, Course]:
        """Loads and required friction along the paths, by load case."""
        cycles = self.f * self.duration * (1 - ROUND_OFF)
        t = np.linspace(0, self.duration, 1 + max(LEAST, math.ceil(TIMES * cycles)))
        return {c: follow(self.clutch, path, mu=self.mu, t=t) for c, path in self.paths.items()}

    @shared
    def _top(self) -> RollerClutchState:
        """State under the largest torque."""
        return self.under(self.T_peak)

    def in_phase(self, sine: float) -> Self:
        """The clutch under load case 3 in its last cycle, at the phase whose sine is `sine`."""
        return self.at(T=self.T_m + sine * self.T, F_ax=self.F_ax * sine)

    def limit_of(self, T: float) -> Interval | None:
        """Interval of the error of the axial load at slip under the torque T; None if not known.

        It is not known if T is zero, or if the interval is too wide.
        """
        if not T:
            return None
        return friction.limit_load(of_star(self, loaded(self.clutch, T)), self.mu)

    def reference(self, level: int) -> Level:
        """Finite elements of the paths: static equilibria with the history of friction."""
        from verify.cases.freewheel.paths.reference import solve

        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows on loads and times of slip, required friction, and behaviour before slip."""
        yield from compared.comparisons(self, LoadPaths)

    figures = drawn_by(drawn.figures)

    def pictures(self) -> Iterator[Picture]:
        """Pictures of displacement and shear stress along the axis."""
        yield from pictures.pulled(
            "Axial displacement at the last extreme of the axial load in load case 2",
            "Axial shear stress: the axial load passes through both contacts of the roller",
            window=pictures.around_roller(self),
        )

    tables = drawn.tables
    sketch = star_sketch.sketch

    def warnings(self) -> Iterator[str]:
        """Warnings if the torque alone causes slip or falls to zero, or if inertia matters."""
        if not math.isfinite(self.F_lim):
            yield (
                f"tan α = {self.mu_T:.4g} is not below μ = {self.mu:g} (Eq. 1): the torque alone "
                "releases the rollers, even without axial load"
            )
        if 0 < self.T_m <= self.T:
            yield (
                "load case 3: the torque falls to zero while an axial load acts; without torque, "
                "friction cannot hold the axial load"
            )
        if self.sway > SWAY:
            more = f"adds about {self.sway:.1%} to the loads" if self.sway < SWINGS else "dominates"
            yield (
                f"f = {self.f:g} Hz is {math.sqrt(self.sway):.2g} of the ring's natural frequency "
                f"f_0 = {self.f_0:.4g} Hz: inertia {more}, but the paths are computed as static"
            )

    def advice(self) -> Iterator[str]:
        """Load cases that slip, times of slip, and the limit of the axial load."""
        paths = self.courses
        slips = [case for case, course in paths.items() if math.isfinite(course.slips_at)]
        named = ", ".join(map(str, slips))
        yield (
            f"the clutch slips in load case{'s' * (len(slips) > 1)} {named} (of {len(paths)})"
            if slips
            else f"the clutch holds to the end of all {len(paths)} load cases"
        )
        for case, course in paths.items():
            slip, least = course.slips_at, f"{self.mu / course.peak:.3g} (class {course.light})"
            ends = (
                f"the clutch slips at {slip:.4g} s; the minimum of μ/μ_req is {least} if the path "
                "is continued to its end as if the clutch held"
                if math.isfinite(slip)
                else f"the clutch holds to the end; the minimum of μ/μ_req is {least}"
            )
            yield f"{drawn.NAMES[case]}: {ends}"
        if math.isfinite(self.F_lim):
            yield (
                f"under T = {self.T:g} N m the largest axial load without slip is "
                f"{self.F_lim:.4g} N; an alternating axial load above about {SETTLES:g} of this "
                "limit may rotate the ring further with each cycle (ratcheting), which "
                "check --fem computes"
            )

    def refusal(self) -> str:
        """Reason why finite elements do not cover the inputs; empty if they do."""
        _ = self._top  # ValueError where no equilibrium exists at the largest torque
        if reason := Pulled.refusal(self.model_copy(update={"T": self.T_peak})):
            return reason
        if self.mu_T * (1 + CLOSE) > self.mu or self.limit_of(self.T) is None:
            return (
                f"tan α = {self.mu_T:.4g} is not below μ = {self.mu:g} by {CLOSE:.0%} or more: the "
                "torque alone releases the rollers, or nearly so; run check without --fem"
            )
        if self.T_critical < LIGHTEST * self.T_peak:
            return (
                f"T_m = {self.T_m:g} N m: in load case 3 an axial load acts while the torque is "
                "nearly zero, and the clutch slips; set T_m = 0 or well above T, or run check "
                "without --fem"
            )
        if self.limit_of(self.T_critical) is None:
            return (
                "in load case 3, the smallest torque releases the rollers, even without axial "
                "load; run check without --fem"
            )
        if (asked := self.in_phase(1.0).mu_req) > WORN:
            return (
                f"F_ax = {self.F_ax:g} N requires the friction coefficient {asked:.3g}, but finite "
                f"elements allow at most {WORN:g}; run check without --fem"
            )
        return ""


PATHS = adapted(LoadPaths)
