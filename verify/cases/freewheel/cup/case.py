"""A drawn-cup roller clutch under torque: an outer cam, up to pop-through of its rollers."""

import math
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, ClassVar

import numpy as np

from analytic.bounds.freewheel.cup import Approaches, CupBounds
from analytic.bounds.freewheel.intervals import STRAIGHT, Interval, times
from analytic.freewheel import state
from verify.case import (
    Comparison,
    Expected,
    Level,
    Quantity,
    Scan,
    State,
    approximation,
    fact,
    limit,
    solved,
)
from verify.cases.freewheel import pictures, statics
from verify.cases.freewheel.bounds import parts, sizes
from verify.cases.freewheel.cup import figures as drawn
from verify.cases.freewheel.cup.inputs import Cup
from verify.cases.freewheel.steel import FRICTION, pressed
from verify.core.case import Context
from verify.core.figures import Array
from verify.form.adapter import adapted
from verify.judging.judge import DEMAND

THIN = 0.2  # wall at the corners over X_o below which a cup counts as thin
NEAR = 0.9  # over the largest torque: above it, small compliances decide
LITTLE = 0.02  # over the largest torque: nearly no states below it
WIDEST = 0.2  # largest a/r for these meshes
COURSE = 3e-5  # relative error of splines between states
BEGINNING = 1e-4  # relative error of phi by the power law below the first state

BRACKET = (
    "compliance of the cup, which lies between the compliances of two rings: one as thick as the "
    "cup at the flat, and one as thick as the cup at its corners, with an elastic column between "
    "flat and ring; wind-up of shaft and cup; terms of the order (a/r)², which Hertz's "
    "theory omits"
)
TANGENTIAL = (
    f"{BRACKET}; additional rotation of the shaft by the tangential forces, 0.5 tan²α to tan²α "
    "times the wind-up"
)
NOT_LOADED = f"ratio α_0/α, with α under load by Eq. 5 for a cup; {BRACKET}"
ON_FLAT = "factor (R_s + X_o)/(2 X_o): Eq. 7 assumes rolling on a circle instead of on a flat"
ENCLOSED = (
    "two rings bound the compliance of a cup to a few per cent; near the largest torque, an error "
    "of the compliance causes larger errors of the results"
)
FINE, NEARLY, MEDIUM, COARSE = 0.015, 0.02, 0.04, 0.06  # required sensitivities
WIDE = 0.12  # largest a/r at which finite elements (small displacements) are judged at the summit
NAMED = statics.Named(
    cam="cup", race="shaft", race_radius="R_s", flat_distance="X_o", form="Eq. 3 for a cup",
    cam_tilt="the flat tilts under load: error",
    race_tilt="the surface of the shaft tilts under load: error",
    unlike_forces="the surfaces tilt, and the contact forces deviate from the bisector",
    rolling="the contacts and wind up shaft and cup",
)  # fmt: skip
SHARED = (
    "plane strain, small strain, cup and housing as one body, bore of the shaft and rim of the "
    "housing free"
)


class FreewheelCup(Cup):
    """Drawn-cup roller clutch with flats in the cup: load reduces the wedge angle ψ towards 0.

    The torque has a maximum before the rollers pop through between shaft and cup. Finite elements
    of one pitch of shaft, roller and cup, with friction at both contacts of the roller, give the
    torque up to this maximum and beyond. The wind-up follows from the strain energy of the finite
    elements.
    """

    id = "freewheel-cup"
    title = "Drawn-cup roller clutch under torque"
    source = "nagler2021"
    place = "Eqs. 2-7, for an outer cam"
    levels: ClassVar = (4, 7, 10)  # cells on the half-width of the fine zones
    scans: ClassVar = (
        Scan(vary=("T=6N m,12N m,18N m,24N m", "R_a=20mm,30mm", "z=6,8,12"), star=True),
        Scan(vary=("R_a=16.5mm,18mm,20mm,25mm,30mm",), at=("T=9.8N m",), star=True),
    )
    readings: ClassVar = (
        "ψ is the angle at the roller between the normals of flat and shaft, and α is half of it; "
        "load reduces ψ",
        "the round race is the shaft. Its radius R_s is the lever arm of F_t and replaces R in the "
        "formulas of a star",
        "T is the torque of the whole clutch, N the normal force of one roller",
        "the rollers are long, so that the state is plane strain",
    )
    assumptions: ClassVar = (
        "the paper treats only inner cams. This cup is synthetic, with α_0 chosen as 3.5°. The "
        "formulas of the paper are changed for an outer cam: flats outside, round race inside",
        "real drawn cups are thin and are supported by a housing. In the model, cup and housing "
        "are one body with the outer radius R_a; the fit between cup and housing is neglected",
        "no load except the torque acts on shaft and cup. All parts are of one steel, which is "
        "assumed elastic at any pressure: at the largest torque, the pressures exceed the "
        "permissible pressure of steel",
        "the finite-element model is one pitch, with small displacements from a prescribed "
        "position of the roller. At this position, the roller neither creeps nor rotates. The "
        "friction coefficient is twice the required friction coefficient",
        "roller travel and strain energy between the computed states are interpolated by splines "
        "over the normal force",
        "in the formula, a ring replaces the cup; the area of its bore is the area enclosed by the "
        "flats. The expected errors have three causes. The compliance of the cup is only known to "
        "lie between those of two rings: one with the bore radius X_o, the other with the bore "
        "radius X_o/cos(π/z) and a column below the flat. Hertz's theory omits terms of the order "
        "(a/r)². Tangential forces increase the rotation of the shaft by the fraction 0.5 tan²α to "
        "tan²α",
    )

    alpha_0 = Quantity(
        "α_0", "deg", "clamping angle without load, Eq. 4 for a cup",
        tex=r"\frac{1}{2} \arccos\left(\frac{X_o - r}{R_s + r}\right)",
    ).reads(lambda q: q.cam.alpha0)  # fmt: skip
    E_plane = Quantity("E'", "GPa", "Young's modulus for plane strain", role="step",
                       tex=r"\frac{E}{1 - \nu^2}").reads(lambda q: q.bodies.outer.E)  # fmt: skip
    a_i = Quantity(
        "a_i", "µm", "half-width of the contact on the shaft", source="Hertz",
        tex=r"\sqrt{\frac{8 F_n R_s r}{\pi L E' (R_s + r)}}",
    ).reads(lambda q: q.state.a_i)  # fmt: skip
    a_o = Quantity("a_o", "µm", "half-width of the contact on the cup", source="Hertz",
                   tex=r"\sqrt{\frac{8 F_n r}{\pi L E'}}").reads(lambda q: q.state.a_o)  # fmt: skip
    R_m = Quantity(
        "R_m", "mm", "bore radius of the ring of equal area that replaces the cup", role="step",
        tex=r"X_o \sqrt{\frac{\tan\left(\frac{\pi}{z}\right) z}{\pi}}",
    ).reads(lambda q: q.bodies.outer.l)  # fmt: skip
    k_i = Quantity(
        "k_i", "1", "compliance constant of the shaft", role="step",
        source="series over all loads on the shaft",
    ).reads(lambda q: q.bodies.inner.k)  # fmt: skip
    c_i = Quantity("c_i", "1", "coefficient of the curvature term of d_i", role="step",
                   source="series").reads(lambda q: q.bodies.inner.c)  # fmt: skip
    k_o = Quantity(
        "k_o", "1", "compliance constant of a ring that is free at its rim", role="step",
        source="series over all loads on the ring",
    ).reads(lambda q: q.bodies.outer.k)  # fmt: skip
    c_o = Quantity("c_o", "1", "coefficient of the curvature term of d_o", role="step",
                   source="series").reads(lambda q: q.bodies.outer.c)  # fmt: skip
    d_i = Quantity(
        "d_i", "µm", "approach of roller and shaft", source="the bore of the shaft is free",
        tex=r"\frac{F_n}{\pi L E'} (2 \ln\left(\frac{4 r}{a_i}\right) - 1 + "
        r"2 \ln\left(\frac{R_s}{a_i}\right) + k_i + \frac{c_i a_i}{R_s})",
    ).reads(lambda q: q.state.d_i)  # fmt: skip
    d_o = Quantity(
        "d_o", "µm", "approach of roller and cup", source="with the ring that replaces the cup",
        tex=r"\frac{F_n}{\pi L E'} (2 \ln\left(\frac{4 r}{a_o}\right) - 1 + "
        r"2 \ln\left(\frac{R_m}{a_o}\right) + k_o + \frac{c_o a_o}{R_m})",
    ).reads(lambda q: q.state.d_o)  # fmt: skip
    alpha = Quantity(
        "α", "deg", "clamping angle under torque, Eq. 5 for a cup",
        source="changed for a cup, in which load reduces the angle",
        tex=r"\frac{1}{2} \arccos\left(\frac{X_o - r + d_o}{R_s + r - d_i}\right)",
    ).reads(lambda q: q.state.alpha)  # fmt: skip
    alpha_rigid = Quantity(
        "α", "deg", "clamping angle without load, used as the angle under torque",
        equation="4", form="corrected",
        form_of="alpha", safe="too high", tex=r"\alpha_0",
    ).reads(lambda q: q.alpha_0)  # fmt: skip
    F_t = Quantity("F_t", "N", "tangential force at either contact, Eq. 3 for a cup",
                   tex=r"\frac{T}{z R_s}").reads(lambda q: q.state.F_t)  # fmt: skip
    N = Quantity("F_n", "N", "normal force at either contact of a roller", equation="2",
                 tex=r"\frac{F_t}{\tan\left(\alpha\right)}").reads(lambda q: q.state.N)  # fmt: skip

    @Quantity("μ_T", "1", "required friction coefficient under torque alone", equation="1",
              safe="too high", tex=r"\tan\left(\alpha\right) = \frac{F_t}{F_n}")  # fmt: skip
    def mu_T(self) -> float:
        return float(np.tan(self.state.alpha))

    x = Quantity(
        "x", "mm", "distance of the contact point from the middle of the flat", role="step",
        tex=r"(R_s + r - d_i) \sin\left(2 \alpha\right)",
    ).reads(lambda q: q.cam.centre(d_i=q.state.d_i, d_o=q.state.d_o)[0])  # fmt: skip
    torque = Quantity("T", "N m", "torque of the shaft's tangential forces, Eq. 3 for a cup",
                      form="corrected", form_of="T", tex=r"z R_s F_t",
                      safe="too low").reads(lambda q: q.state.T)  # fmt: skip

    @Quantity("T", "N m", "torque of the cup's contact forces, Eq. 3 for a cup", form="corrected",
              form_of="T", tex=r"z (F_n x - F_t X_o)")  # fmt: skip
    def torque_cup(self) -> float:
        return float(self.z * (self.state.N * self.x - self.state.F_t * self.X_o))

    s = Quantity(
        "s", "µm", "travel of the rollers' centres about the axis, Eq. 6 for a cup",
        tex=r"(R_s + r - d_i) 2 (\alpha_0 - \alpha)",
    ).reads(lambda q: q.state.s)  # fmt: skip
    phi = Quantity(
        "φ", "deg", "wind-up angle by exact rolling", equation="7", form="corrected",
        tex=r"\frac{1}{R_s} \int \frac{\mathrm{d}d_i + \mathrm{d}d_o}{\tan\alpha}",
    ).reads(lambda q: q.state.phi)  # fmt: skip
    phi_printed = Quantity(
        "φ", "deg", "wind-up angle with R_s and X_o", equation="7", form="as printed",
        form_of="phi", tex=r"\frac{s}{R_s} + \frac{s}{X_o}",
    ).reads(lambda q: q.state.phi_printed)  # fmt: skip
    p_i = Quantity("p_i", "MPa", "peak pressure on the shaft", source="Hertz", safe="too high",
                   tex=r"\frac{2 F_n}{\pi L a_i}").reads(lambda q: q.state.p_i)  # fmt: skip
    p_o = Quantity("p_o", "MPa", "peak pressure on the cup", source="Hertz", safe="too high",
                   tex=r"\frac{2 F_n}{\pi L a_o}").reads(lambda q: q.state.p_o)  # fmt: skip
    T_max = Quantity(
        "T_max", "N m", "largest torque before the rollers pop through", safe="too low",
        tex=r"\max_{F_n} z R_s F_n \tan\alpha(F_n) = "
        r"z R_s F_{max} \tan\left(\alpha_{max}\right)",
    ).reads(lambda q: q.at_summit.T)  # fmt: skip
    N_max = Quantity("F_max", "N", "normal force at the largest torque",
                     role="step").reads(lambda q: q.at_summit.N)  # fmt: skip
    alpha_max = Quantity("α_max", "deg", "clamping angle at the largest torque",
                         role="step").reads(lambda q: q.at_summit.alpha)  # fmt: skip

    @Quantity(
        "p_max", "MPa", "larger of both peak pressures at the largest torque (Hertz)", role="step"
    )
    def p_max(self) -> float:
        return float(np.maximum(self.at_summit.p_i, self.at_summit.p_o))

    through = Quantity("d_through", "µm", "sum d_i + d_o of the approaches at pop-through of the "
                                          "rollers (α = 0)",
                       role="step",
                       tex=r"R_s + 2 r - X_o").reads(lambda q: q.cam.pop_through)  # fmt: skip

    @Quantity("d_max", "µm", "sum d_i + d_o of the approaches at the largest torque", role="step")
    def d_max(self) -> float:
        return float(self.at_summit.d_i + self.at_summit.d_o)

    @Quantity("δ", "1", "ratio of d_i + d_o at the largest torque to d_i + d_o at pop-through",
              role="step", tex=r"\frac{d_{max}}{d_{through}}")  # fmt: skip
    def share(self) -> float:
        return float((self.at_summit.d_i + self.at_summit.d_o) / self.cam.pop_through)

    def reference(self, level: int) -> Level:
        """Results of one pitch, also beyond the largest torque.

        Half a fine zone has `level` cells.
        """
        from verify.cases.freewheel import reference
        from verify.cases.freewheel.cup.sweep import CupSweep, given_angle

        sweep = CupSweep(self, level)
        N_top, T_top = sweep.summit
        values = reference.under_torque(self, sweep) | {
            "N_angle": sweep.force_at_angle(given_angle(self)),
            "T_max": T_top,
            "alpha_max": sweep.place(N_top, "N").psi / 2,
            "falls": float(-np.diff(sweep.psi).max() / sweep.psi[0]),
            "past_summit": float(1 - sweep.at_states["T"][-1] / T_top),
        }
        unsure = dict.fromkeys(values, reference.SPLINE)
        unsure |= dict.fromkeys(("T_max", "N", "alpha", "s"), COURSE) | {"phi": BEGINNING}
        return solved(1 / level, reference.field(sweep.last), iteration=unsure, **values,
                      **reference.over_torque(self, sweep))  # fmt: skip

    def comparisons(self) -> Iterator[Comparison]:
        """Rows at equal torque, force and angle, at the largest torque and without load.

        The last rows compare the equilibrium of forces.
        """
        cup, rigid = FreewheelCup, self.loaded_by("N_0")
        force = self.within(rigid.state)
        yield from self._at_torque()
        yield from self._at_force(State(rigid, "rigid", "at N = T/(z R_s tan α_0)"), force)
        angle = State(self.loaded_by("ψ"), "angle", "at a given wedge angle ψ")
        yield self._judged(
            cup.N, force.force_at_angle(self.given_angle), MEDIUM, state=angle,
            name="normal force at a given wedge angle ψ", symbol="F_n(ψ)",
        )  # fmt: skip
        yield self._summit()
        yield limit(cup.alpha_0, "F_t/F_n tends to tan α_0 as the load tends to zero (Eq. 4 for a "
                                 "cup)", "α_0",
                    points=partial(statics.no_load, self, self.alpha_0), exponent=1.0)  # fmt: skip
        yield fact("the clamping angle decreases with load", "α", margin("falls"))
        yield fact("the torque falls beyond its maximum while the normal force grows", "T",
                   margin("past_summit"))  # fmt: skip
        yield from statics.balanced(cup, cup.torque_cup, NAMED)

    def within(self, at: state.RollerClutchState) -> CupBounds:
        """Error bounds of the formulas in the state `at`."""

        def approaches(N: Array) -> tuple[Array, Array]:
            d = self.bodies.approaches(N / self.L)
            return d.d_i, d.d_o

        course = Approaches(approaches, float(self.at_summit.N))
        return CupBounds(parts(self), sizes(at), course)

    def _judged(
        self, q: Quantity, interval: Interval, demand: float = DEMAND, source: str = BRACKET,
        **more: Any,
    ) -> Comparison:  # fmt: skip
        """Row on the quantity `q` with the required sensitivity `demand`.

        For a user's cup, the interval may be too wide for judging.
        """
        if demand > NEARLY:
            more["sensitivity"] = demand, ENCLOSED
        elif demand > DEMAND:
            more.update(own=(demand, ENCLOSED))
        low, high = interval
        expected = Expected(low, high, source, sharp=self.is_default or high - low <= demand)
        return approximation(q, expected=expected, order=2, shares=SHARED, **more)

    def _at_torque(self) -> Iterator[Comparison]:
        cup, bounds = FreewheelCup, self.within(self.state)
        yield self._judged(cup.alpha, bounds.under_torque("alpha"), FINE, symbol="α(T)",
                           name="clamping angle under torque (Eq. 5 for a cup)")  # fmt: skip
        unloaded = times(bounds.under_torque("alpha"), self.alpha_0 / self.alpha)
        yield self._judged(
            cup.alpha_rigid, unloaded, COARSE, NOT_LOADED, symbol="α",
            name="clamping angle under torque, taken as α_0 (Eq. 4 for a cup)",
        )  # fmt: skip
        yield self._judged(cup.N, bounds.under_torque("N"), NEARLY, symbol="F_n(T)",
                           name="normal force under torque (Eqs. 2, 3)")  # fmt: skip
        yield self._judged(cup.mu_T, bounds.slope(), FINE, symbol="F_t/F_n",
                           name="F_t/F_n, mean of both contacts (Eqs. 1, 2)")  # fmt: skip
        yield self._judged(cup.s, bounds.under_torque("s"), COARSE, symbol="s(T)",
                           name="travel of the rollers (Eq. 6)")  # fmt: skip
        torsion = bounds.torsion()
        yield self._judged(
            cup.phi, torsion, COARSE, TANGENTIAL, symbol="φ(T)",
            name="wind-up by exact rolling (Eq. 7, corrected), compared with the wind-up from the "
            "strain energy",
        )  # fmt: skip
        on_flat = times(torsion, (self.R_s + self.X_o) / (2 * self.X_o), STRAIGHT)
        yield self._judged(
            cup.phi_printed, on_flat, COARSE, ON_FLAT, symbol="φ(T)",
            name="wind-up, Eq. 7 as printed, with R_s and X_o, compared with the wind-up from the "
            "strain energy",
        )  # fmt: skip

    def _at_force(self, rigid: State, bounds: CupBounds) -> Iterator[Comparison]:
        cup, hertz, where = FreewheelCup, bounds.contact(), rigid.words
        yield self._judged(cup.d_i, bounds.approach("d_i"), FINE, state=rigid, symbol="d_i(N)")
        yield self._judged(cup.d_o, bounds.approach("d_o"), COARSE, state=rigid, symbol="d_o(N)")
        for q, what in ((cup.a_i, "half-width of the contact on the shaft"),
                        (cup.a_o, "half-width of the contact on the cup")):  # fmt: skip
            yield self._judged(q, hertz, FINE, state=rigid, name=f"{what}, {where}")
        for q in (cup.p_i, cup.p_o):
            yield self._judged(q, hertz, FINE, state=rigid)
        yield self._judged(cup.torque, bounds.torque(), FINE, state=rigid, symbol="T(N)",
                           name=f"torque z R_s F_t (Eq. 3 for a cup), {where}")  # fmt: skip

    def _summit(self) -> Comparison:
        """Row of the largest torque; judged only if contacts are narrow at this torque."""
        top = self.at_summit
        wide = max(float(top.a_i), float(top.a_o)) / self.r > WIDE
        interval = (-math.inf, math.inf) if wide else self.within(top).summit()
        return self._judged(FreewheelCup.T_max, interval, COARSE,
                            name="largest torque before the rollers pop through")  # fmt: skip

    figures = drawn.figures
    pictures = pictures.heaviest
    sketch = drawn.sketch

    def warnings(self) -> Iterator[str]:
        """Warnings if friction or pressure exceeds the values of steel, or if the cup is thin."""
        if np.tan(self.alpha_0) > FRICTION:
            yield (
                f"tan α_0 = {np.tan(self.alpha_0):.3g} is more than the friction coefficient "
                f"{FRICTION:g} that oiled steel hardly exceeds: the rollers do not grip"
            )
        yield from pressed(self.p_i, self.p_o)
        wall = self.R_a - self.corner
        if wall < THIN * self.X_o:
            yield (
                f"the wall of the cup is only {wall * 1e3:.3g} mm thick at its corners and bends, "
                "so that the expected errors are large: give as R_a the outer radius of the "
                "housing that supports the cup"
            )

    def refusal(self) -> str:
        """Reason why finite elements do not cover the inputs; empty if they do.

        T near 0 or near its maximum and wide contacts are excluded.
        """
        _ = self.state  # ValueError where no equilibrium exists at T
        top, share = self.at_summit, self.T / self.T_max
        if not LITTLE < share < NEAR:
            return (
                f"T is {share:.3g} of the largest torque {self.T_max:.4g} N m; finite elements "
                f"require {LITTLE:g} to {NEAR:g} of this torque; run check without --fem"
            )
        wide = max(float(top.a_i), float(top.a_o)) / self.r
        if wide > WIDEST:
            return (
                f"at the largest torque, the half-width of a contact is {wide:.3g} r; finite "
                f"elements require at most {WIDEST:g} r; run check without --fem"
            )
        return ""


def margin(key: str) -> Callable[[Context], tuple[float, float]]:
    """Function of the context that returns the value `key` of the finest mesh and its uncertainty.

    The uncertainty is twice the change from the mesh before.
    """

    def of(context: Context) -> tuple[float, float]:
        before, now = (r.values[key] for r in context.fem[-2:])
        return now, 2 * abs(now - before)

    return of


CUP = adapted(FreewheelCup)
