"""A roller freewheel with flats on a star, under torque (Nagler, Lohrengel, Eqs. 2 to 7)."""

from collections.abc import Iterator
from functools import partial
from typing import Any, ClassVar

from analytic.bounds.freewheel.intervals import STRAIGHT, times
from analytic.freewheel import printed
from verify.case import (
    AlongLine,
    Comparison,
    Drawn,
    Level,
    Quantity,
    Scan,
    State,
    approximation,
    converged,
    limit,
    solved,
)
from verify.cases.freewheel import over_torque, pictures, star_sketch, statics
from verify.cases.freewheel.bounds import TANGENTIAL, known, of_star
from verify.cases.freewheel.star import Star
from verify.cases.freewheel.steel import FRICTION, pressed
from verify.form.adapter import adapted

SHARP = "accepted error of this quantity"
ENCLOSED = (
    "the compliance of the star is only known to lie between the smallest and the largest "
    "compliance of a layer and two discs"
)
PRINTED_ERROR = "the error of the formula is 22 %, so that a sensitivity of 3 % is sufficient"
ON_FLAT = "factor (R + X)/(2X), because Eq. 7 assumes rolling on a circle instead of on a flat"
NOT_LOADED = "ratio of the clamping angle without load to the angle under torque (Eq. 5, corrected)"
NOT_RIGHT = "ratio of the clamping angle by the printed equation to that by the corrected equation"
MANY_TIMES = "the error of the formula exceeds 9 %, so that a sensitivity of 5 % is sufficient"
NO_LEVER = (
    "factor X/R, because the formula omits the torque of F_n, whose line of action passes the axis "
    "at the distance x"
)
ROOM = (
    "the theory of small displacements applies the forces to the undeformed mesh, beside the "
    "middle of the contacts: error"
)
NAMED = statics.Named(
    cam="star", race="ring", race_radius="R", flat_distance="X", form="Eq. 3, corrected",
    cam_tilt=ROOM, race_tilt=ROOM,
    unlike_forces="the contact forces deviate from the bisector by equal and opposite angles",
    rolling="the contacts",
)  # fmt: skip
SHARED = "plane strain, small strain, the star clamped in its bore"
ROLLED = (
    "In the finite elements, the wind-up follows from the strain energy of all states, without the "
    "assumption of rolling. Eq. 7 as printed replaces the flat by a circle of radius X."
)
LEAVES = (
    "The deviation grows with the normal force for two reasons: the surfaces tilt, and the "
    "theory of small displacements applies the forces to the undeformed mesh. The deviations at "
    "both contacts are equal and opposite: the mean of F_t/F_n is tan(ψ/2)."
)


class FreewheelTorque(Star):
    """Roller freewheel under torque: the load moves the rollers between star and ring.

    The corrected Eqs. 3 to 7 of the paper give clamping angle, normal force, roller travel and
    wind-up over torque. They agree with finite elements of one pitch of star, roller and ring, with
    friction at both contacts of the roller. In the finite elements, the wind-up follows from the
    strain energy, without the assumption of rolling.
    """

    id = "freewheel-torque"
    title = "Roller freewheel under torque"
    source = "nagler2021"
    place = "Eqs. 2-7"
    levels: ClassVar = (4, 7, 10)  # cells on the half-width of the fine zones
    scans: ClassVar = (
        Scan(vary=("T=6.5N m,13N m,26N m,32N m,39N m,52N m", "R_a=19mm,20mm,21mm,30mm",
                   "X=11.33mm,11.39565mm,11.42mm,11.44mm", "z=6,7,8,12"), star=True),
        Scan(vary=("T=20N m,52N m", "X=11.39565mm,11.44mm"), at=("R_a=19mm", "z=6")),
    )  # fmt: skip
    readings: ClassVar = (
        "ψ is the angle at the roller between the normals of flat and ring, and α is half of it",
        "R is the bore radius of the outer ring, for which the paper writes r_OR",
        "d = f + u is the approach of a contact: local flattening f plus structural deflection u. "
        "Only this sum can be compared with finite elements",
        "T is the torque of the whole clutch, N the normal force of one roller",
        "the rollers are long, so that the state is plane strain",
    )
    assumptions: ClassVar = (
        "the paper prints no dimensions of its clutches A and B. They cannot be estimated, because "
        "a change of X by 5 µm changes α_0 by 0.08°. The clutch of this case is synthetic, with "
        "α_0 chosen as 3.5°",
        "the star is clamped in its bore, and no load except the torque acts on the ring. All "
        "parts are of one steel",
        "the finite-element model is one pitch, with small displacements from a prescribed "
        "position of the roller. At this position, the roller neither creeps nor rotates. The "
        "friction coefficient is twice the required friction coefficient",
        "roller travel and strain energy are interpolated by splines between six computed states, "
        "and by a power law below the first state",
        "the expected errors have three causes. The compliance of the star is only known to lie "
        "between the smallest and the largest compliance of three bodies (a layer as thick as the "
        "star at the flats, and two discs, of the radius of the flats and of the corners), and "
        "the torque twists the star. Hertz's theory "
        "omits terms of the order (a/r)². Tangential forces increase the rotation of the ring by "
        "the fraction 0.5 tan²α to tan²α",
    )

    x = Quantity(
        "x", "mm", "distance of the contact point from the middle of the flat", role="step",
        tex=r"(R - r + d_o) \sin\left(2 \alpha\right)",
    ).reads(lambda q: q.cam.centre(d_i=q.state.d_i, d_o=q.state.d_o)[0])  # fmt: skip
    torque = Quantity("T", "N m", "torque of the ring's tangential forces", equation="3",
                      form="corrected", form_of="T", tex=r"z R F_t",
                      safe="too low").reads(lambda q: q.state.T)  # fmt: skip

    @Quantity("T", "N m", "torque of the star's contact forces", equation="3", form="corrected",
              form_of="T", tex=r"z (F_n x - F_t X)")  # fmt: skip
    def torque_star(self) -> float:
        return float(self.z * (self.state.N * self.x - self.state.F_t * self.X))

    @Quantity("T", "N m", "torque of the star's tangential forces", equation="3",
              form="as printed", form_of="T", tex=r"z X F_t", safe="too low")  # fmt: skip
    def torque_printed(self) -> float:
        return float(printed.torque_on_cam(self.cam, F_t=self.state.F_t))

    alpha_rigid = Quantity(
        "α", "deg", "clamping angle without load, used as the angle under torque",
        equation="4", form="corrected",
        form_of="alpha", safe="too high", tex=r"\alpha_0",
    ).reads(lambda q: q.alpha_0)  # fmt: skip
    alpha_0_printed = Quantity(
        "α", "deg", "clamping angle without load, used as the angle under torque",
        equation="4", form="as printed",
        form_of="alpha", safe="too high",
        tex=r"\arccos\left(\sqrt{\frac{r + X}{2 (R - r)}}\right)",
    ).reads(lambda q: printed.alpha0(q.cam))  # fmt: skip
    alpha_printed = Quantity(
        "α", "deg", "clamping angle under torque", equation="5", form="as printed",
        form_of="alpha", safe="too high",
        tex=r"\frac{1}{2} \arccos\left(\frac{X - d_i + r}{R - d_o + r}\right)",
    ).reads(lambda q: printed.alpha_1(q.cam, d_i=q.state.d_i, d_o=q.state.d_o))  # fmt: skip
    s = Quantity("s", "µm", "travel of the rollers' centres about the axis", equation="6",
                 tex=r"(R - r + d_o) 2 (\alpha - \alpha_0)").reads(lambda q: q.state.s)  # fmt: skip
    phi = Quantity(
        "φ", "deg", "wind-up angle by exact rolling", equation="7", form="corrected",
        tex=r"\frac{1}{R} \int \frac{\mathrm{d}d_i + \mathrm{d}d_o}{\tan\alpha}",
    ).reads(lambda q: q.state.phi)  # fmt: skip
    phi_printed = Quantity(
        "φ", "deg", "wind-up angle", equation="7", form="as printed", form_of="phi",
        tex=r"\frac{s}{R} + \frac{s}{X}",
    ).reads(lambda q: q.state.phi_printed)  # fmt: skip
    phi_small = Quantity("φ", "deg", "wind-up angle, approximation for small angles",
                         form="small angles",
                         form_of="phi", role="step",
                         tex=r"\frac{2 s}{R}").reads(lambda q: q.state.phi_small)  # fmt: skip
    p_i = Quantity("p_i", "MPa", "peak pressure on the star", source="Hertz", safe="too high",
                   tex=r"\frac{2 F_n}{\pi L a_i}").reads(lambda q: q.state.p_i)  # fmt: skip
    p_o = Quantity("p_o", "MPa", "peak pressure on the ring", source="Hertz", safe="too high",
                   tex=r"\frac{2 F_n}{\pi L a_o}").reads(lambda q: q.state.p_o)  # fmt: skip

    def reference(self, level: int) -> Level:
        """Finite elements: all states of a pitch; half a fine zone has `level` cells."""
        from verify.cases.freewheel import reference
        from verify.cases.freewheel.sweep import given_angle, sweep

        states = sweep(self, level)
        values = reference.under_torque(self, states)
        values["N_angle"] = states.force_at_angle(given_angle(self))
        unsure = dict.fromkeys(values, reference.SPLINE) | {"phi": 2 * reference.SPLINE}
        return solved(1 / level, reference.field(states.last), iteration=unsure, **values,
                      **reference.over_torque(self, states))  # fmt: skip

    def comparisons(self) -> Iterator[Comparison]:
        """Rows at equal torque, force and angle, without load, and on the equilibrium of forces."""
        yield from self._at_torque()
        yield from self._at_force()
        angle = State(self.loaded_by("ψ"), "angle", "at a given wedge angle ψ")
        force = of_star(self, self.loaded_by("N_0").state).force_at_angle()
        yield approximation(
            FreewheelTorque.N, name="normal force at a given wedge angle ψ", symbol="F_n(ψ)",
            order=2, state=angle, expected=known(self, force), own=(0.02, SHARP), shares=SHARED,
        )  # fmt: skip
        yield limit(FreewheelTorque.alpha_0, symbol="α_0", exponent=1.0,
                    name="F_t/F_n tends to tan α_0 as the load tends to zero (Eqs. 1, 4)",
                    points=partial(statics.no_load, self, self.alpha_0))  # fmt: skip
        yield from statics.balanced(FreewheelTorque, FreewheelTorque.torque_star, NAMED)

    def _at_torque(self) -> Iterator[Comparison]:
        star, bounds = FreewheelTorque, of_star(self, self.state)
        more: dict[str, Any] = {"order": 2, "shares": SHARED}
        yield approximation(star.alpha, name="clamping angle under torque (Eqs. 4, 5)",
                            symbol="α(T)", expected=known(self, bounds.angle()),
                            sensitivity=(0.002, SHARP), **more)  # fmt: skip
        for q, name, interval, why in (
            (star.alpha_rigid, "taken as α_0 (Eq. 4)", bounds.unloaded(), NOT_LOADED),
            (star.alpha_0_printed, "Eq. 4 as printed", bounds.unloaded_as_printed(), NOT_RIGHT),
            (star.alpha_printed, "Eq. 5 as printed", bounds.as_printed(), NOT_RIGHT),
        ):
            yield approximation(
                q, name=f"clamping angle under torque, {name}", symbol="α",
                sensitivity=(0.05, MANY_TIMES), expected=known(self, interval, why), **more,
            )  # fmt: skip
        yield approximation(star.N, name="normal force under torque (Eqs. 2, 3)", symbol="F_n(T)",
                            expected=known(self, bounds.force()), **more)  # fmt: skip
        yield approximation(star.s, name="travel of the rollers (Eq. 6)", symbol="s(T)",
                            expected=known(self, bounds.travel()), **more)  # fmt: skip
        torsion = bounds.torsion()
        yield approximation(
            star.phi, name="wind-up by exact rolling (Eq. 7, corrected), compared with the wind-up "
            "from the strain energy",
            symbol="φ(T)", expected=known(self, torsion, TANGENTIAL), **more,
        )  # fmt: skip
        on_flat = times(torsion, (self.R + self.X) / (2 * self.X), STRAIGHT)
        yield approximation(
            star.phi_printed, name="wind-up, Eq. 7 as printed, compared with the wind-up from the "
            "strain energy", symbol="φ(T)",
            expected=known(self, on_flat, ON_FLAT), sensitivity=(0.03, PRINTED_ERROR), **more,
        )  # fmt: skip

    def _at_force(self) -> Iterator[Comparison]:
        star, rigid = FreewheelTorque, self.loaded_by("N_0")
        bounds, where = of_star(self, rigid.state), "at N = T/(z R tan α_0)"
        more: dict[str, Any] = {"order": 2, "shares": SHARED, "state": State(rigid, "rigid", where)}
        yield approximation(star.d_i, symbol="d_i(N)", expected=known(self, bounds.approach("d_i")),
                            sensitivity=(0.025, ENCLOSED), **more)  # fmt: skip
        yield approximation(star.d_o, symbol="d_o(N)", expected=known(self, bounds.approach("d_o")),
                            **more)  # fmt: skip
        hertz = known(self, bounds.contact())
        for q, what in ((star.a_i, "half-width of the contact on the star"),
                        (star.a_o, "half-width of the contact on the ring")):  # fmt: skip
            yield approximation(q, name=f"{what}, {where}", expected=hertz, **more)
        for q in (star.p_i, star.p_o):
            yield approximation(q, expected=hertz, **more)
        slope = bounds.slope(tilted=True)
        yield approximation(star.torque, name=f"torque z R F_t (Eq. 3, corrected), {where}",
                            symbol="T(N)", expected=known(self, slope), **more)  # fmt: skip
        yield approximation(
            star.torque_printed, symbol="T(N)",
            name=f"torque z X F_t of the star, Eq. 3 as printed, {where}",
            expected=known(self, times(slope, self.X / self.R), NO_LEVER), **more,
        )  # fmt: skip

    def figures(self) -> Iterator[AlongLine | Drawn]:
        """Figures: angle, wind-up and travel over torque; forces; pressures of both contacts."""
        yield over_torque.angle(self, ends=".")
        yield converged(partial(over_torque.torsion, printed="s/R + s/X", note=ROLLED))
        yield over_torque.travel(self)
        yield converged(partial(over_torque.bisector, x="T [N m]", cam="star", race="ring",
                            note=LEAVES))  # fmt: skip
        yield over_torque.pressure("star")
        yield over_torque.pressure("ring")

    pictures = pictures.heaviest
    sketch = star_sketch.sketch

    def warnings(self) -> Iterator[str]:
        """Warnings if the friction of oiled steel or its permissible pressure is exceeded."""
        if self.mu_T > FRICTION:
            yield (
                f"tan α(T) = {self.mu_T:.3g} is more than the friction coefficient {FRICTION:g} "
                "that oiled steel hardly exceeds: the clutch slips"
            )
        yield from pressed(self.p_i, self.p_o)


TORQUE = adapted(FreewheelTorque)
