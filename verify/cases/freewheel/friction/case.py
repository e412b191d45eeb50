"""Friction criterion of a freewheel with axial load (Nagler, Lohrengel, Eqs. 1, 2, 8 to 10)."""

from collections.abc import Iterator
from typing import Any, ClassVar

from analytic.bounds.freewheel.friction import FrictionBounds
from analytic.bounds.freewheel.intervals import Interval
from analytic.freewheel import criterion, tilt
from analytic.freewheel.let_out import let_out
from verify.case import (
    Comparison,
    Expected,
    Level,
    Quantity,
    Scan,
    approximation,
    balance,
    drawn_by,
    identity,
    underived,
)
from verify.cases.freewheel import pictures
from verify.cases.freewheel.bounds import of_star
from verify.cases.freewheel.friction import figures as drawn
from verify.cases.freewheel.friction.comparisons import at_slip
from verify.cases.freewheel.pulled import Pulled
from verify.core.figures import Array, Picture
from verify.form.adapter import adapted
from verify.form.comparisons import Options

CLOSE = 0.02  # friction closer to tan(alpha), relative, leaves too small an axial load
ANGLE = (
    "compliance of the star, which lies between the smallest and the largest compliance of three "
    "bodies: a layer as thick as the star at the flats, a disc of the radius of the flats, and a "
    "disc of the radius of the corners; effect of the friction forces on α"
)
TILTED = f"{ANGLE}; tilt of the surfaces under the normal force"
HEAVY: Any = Options(own=(0.03, "the tilt of the surfaces increases with the load"))
LIMITED = "an error of tan α causes a larger error of the load, which contains √((μ/tan α)² − 1)"
CREEPS = "an error of tan α causes a larger error of the ratio, which contains 1/√((μ/tan α)² − 1)"
ROOT = 0.015, 0.05  # required of a root of a small difference, by default and for user inputs
STATICS: Any = {"sensitivity": (1e-6, "equilibrium of forces is satisfied on any mesh")}
SHARED = "Coulomb's law of friction, plane strain, load uniform along the rollers"


class FreewheelFriction(Pulled):
    """Friction criterion: torque alone requires μ = tan α, and an axial load requires a larger μ.

    In finite elements of the elastic clutch, slip begins at the limit of this criterion, under
    torque alone and with an axial load. Beyond the limit, the ring also rotates, because the slip
    has the direction of the resultant friction force.
    """

    id = "freewheel-friction"
    title = "Friction criterion of a freewheel with axial load"
    source = "nagler2021"
    place = "Eqs. 1, 2, 8-10"
    levels: ClassVar = (4, 6, 8)  # cells on the half-width of the fine zones
    scans: ClassVar = (
        Scan(vary=("T=13N m,26N m", "F_ax=300N,600N,1200N", "mu=0.07,0.08,0.1"), star=True),
    )
    readings: ClassVar = (
        "T and F_ax are loads of the whole clutch. F_n, F_t and F_a are forces at one contact of "
        "one roller. Therefore, Eq. 8 contains F_a = F_ax/z, and Eq. 9 contains F_ax",
        "α is half of the angle at the roller between the normals of flat and ring, under load",
        "the lever arm of F_t is the bore radius R of the ring",
        "the required friction coefficient has the symbol μ_req. Eq. 8 as printed contains tan α "
        "instead, but tan α is F_t/F_n (Eq. 1)",
        "at μ = μ_req the clutch holds by Eqs. 1 and 8 and by the classes of Sec. 7, but not by "
        "Eqs. 9 and 10",
    )
    assumptions: ClassVar = (
        "dimensions, μ and F_ax are user inputs, because the paper prints none for its clutches. "
        "The default clutch is synthetic and carries the largest torque of the test rig",
        "the finite elements combine plane strain with an axial displacement u_z(x, y) that is "
        "uniform along the axis (long rollers). The axial load is uniform on the rim of the ring, "
        "only friction acts on the rollers along the axis, and the star is clamped in its bore",
        "the axial forces on a roller form a couple 2 r cos α F_a, which tilts the roller: F_n "
        "shifts by e along the roller, in opposite directions at star and ring. The criterion and "
        "the finite elements do not include this shift. The values of e and of the maximum "
        "line load on this page are computed for a line load that varies linearly; they are not "
        "judged",
        "positions and normals of the contacts are fixed, because displacements are small compared "
        "with the radii. In computations of slip, the position of the roller is prescribed",
        "beyond the limit, the ring is driven along its axis, either under constant torque or held "
        "against rotation. Both results are reported",
        "the friction coefficient is equal at all contacts and independent of the sliding speed. "
        "Oil films are neglected. On star and ring, the tilting couples of all rollers cancel",
    )

    @Quantity("μ_req", "1", "required friction coefficient with F_ax in place of F_a",
              equation="8", form="as printed", form_of="mu_req", safe="too high",
              tex=r"\frac{\sqrt{F_t^2 + F_{ax}^2}}{F_n}")  # fmt: skip
    def mu_req_printed(self) -> float:
        found = criterion.required_friction_of_contact(
            F_n=self.state.N, F_t=self.F_t, F_a=self.F_ax
        )  # fmt: skip
        return float(found)

    @Quantity("μ/μ_req", "1", "ratio of available to required friction coefficient; the clutch "
                              "holds if it is 1 or more",
              equation="10", safe="too low", tex=r"\frac{\mu}{\mu_{req}}")  # fmt: skip
    def safety(self) -> float:
        return float(criterion.safety(mu=self.mu, mu_req=self.mu_req))

    @Quantity("R dφ/du_z", "1", "ratio of the circumferential creep of the ring's bore to its "
                                "axial slip at the limit, F_t/F_a",
              source="slip in the direction of the friction force", tex=r"\frac{T}{R F_{lim}}",
              when=lambda q: q.bears_axial_load)  # fmt: skip
    def creep(self) -> float:
        return self.T / (self.R * self.F_lim)

    u_out = Quantity(
        "u_out", "mm", "axial slip after which the torque is zero, with the ring held against "
                       "rotation",
        role="step", when=lambda q: q.bears_axial_load,
    ).reads(lambda q: q.slipped()[0][0])  # fmt: skip

    @Quantity("e", "mm", "axial shift of F_n along the roller due to the tilting couple",
              source="tilt of the roller, which criterion and finite elements neglect",
              role="step",
              tex=r"r (\cos\left(\alpha\right))^2 \frac{F_a}{F_n}")  # fmt: skip
    def e(self) -> float:
        state = self.state
        return float(tilt.offset(F_a=self.F_a, F_n=state.N, r=self.r, alpha=state.alpha))

    @Quantity("q/q_m", "1", "ratio of maximum to mean line load due to the shift e", role="step",
              source="one end lifts off if e exceeds L/6", tex=r"1 + \frac{6 e}{L}")  # fmt: skip
    def peak(self) -> float:
        return float(tilt.peak_factor(e=self.e, L=self.L))

    @Quantity("p_1/p", "1",
              "ratio of the peak pressure at the maximum line load to that at the mean line load "
              "(Hertz)",
              role="step",
              tex=r"\sqrt{1 + \frac{6 e}{L}}")  # fmt: skip
    def pressure(self) -> float:
        return float(tilt.pressure_factor(e=self.e, L=self.L))

    def slipped(self) -> tuple[Array, Array]:
        """Axial slip [m] of a ring held against rotation, and remaining torque/T, shapes (m,)."""
        return let_out(self.clutch, T=self.T, mu=self.mu)

    def reference(self, level: int) -> Level:
        """Finite elements of the sector: under torque only, with axial load, beyond slip."""
        from verify.cases.freewheel.friction.reference import solve

        return solve(self, level)

    @property
    def within(self) -> FrictionBounds:
        """Error bounds of the criterion under the loads of the inputs."""
        return FrictionBounds(of_star(self, self.state), mu=self.mu, lever=self.lever)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows on forces, required friction, axial load at slip, and onset of slip."""
        law, bounds = FreewheelFriction, self.within
        more: Any = {"order": 2, "shares": SHARED}
        yield identity(law.F_t, name="tangential force of a roller (Eq. 3, corrected)", **STATICS)
        yield identity(law.F_a, name="axial force of a roller, F_ax/z", scale=law.F_t, **STATICS)
        yield approximation(law.N, name="normal force under torque",
                            expected=expected(bounds.normal_force()), **HEAVY, **more)  # fmt: skip
        yield approximation(
            law.mu_T, name="required friction, torque alone (Eqs. 1, 2)", symbol="μ_req",
            expected=expected(bounds.both_contacts(), ANGLE), **more,
        )  # fmt: skip
        yield approximation(law.mu_req, name="required friction (Eqs. 8, 9)",
                            expected=expected(bounds.one_contact()), **HEAVY, **more)  # fmt: skip
        whole = expected(
            bounds.whole_load(),
            f"{TILTED}; axial force z times too large, because F_ax acts on the whole clutch",
        )
        yield approximation(
            law.mu_req_printed, expected=whole, **HEAVY, **more,
            name="required friction, Eq. 8 as printed, with F_ax in place of F_a",
        )  # fmt: skip
        tangent = f"{ANGLE}; factor √(1 + (F_ax R/T)²), because Eq. 8 gives μ_req, not tan α"
        yield approximation(law.mu_req, "mu_T", name="tan α, Eq. 8 as printed", symbol="tan α",
                            expected=expected(bounds.two_tangents(), tangent), **more)  # fmt: skip
        least, own = ROOT
        yield approximation(
            law.F_lim, name="axial load at slip (Eq. 9)", symbol="F_ax,lim",
            expected=expected(bounds.limit_load()), sensitivity=(least, LIMITED),
            own=(own, LIMITED), **more,
        )  # fmt: skip
        along = f"Coulomb's law: slip has the direction of the friction force; {TILTED}"
        yield approximation(
            law.creep, name="ratio of circumferential creep of the ring to its axial slip, F_t/F_a",
            expected=expected(bounds.limit_creep(), along), sensitivity=(least, CREEPS),
            own=(own, CREEPS), **more,
        )  # fmt: skip
        yield from at_slip(law.mu_T, law.mu_req)
        yield balance("balance", "balance of the axial forces on a roller", "ΣF_a", "N",
                      of={"F_t": self.F_t}, bound=1e-9,
                      because="equilibrium of a body that is held only by contact")  # fmt: skip

    figures = drawn_by(drawn.figures)

    def pictures(self) -> Iterator[Picture]:
        """Pictures of displacement and shear stress along the axis."""
        yield from pictures.pulled(
            "Axial displacement under torque and axial load: the ring moves most, the rollers move "
            "less, and the star is clamped in its bore",
            "Axial shear stress: the axial load passes through both contacts of the roller",
        )

    tables = drawn.tables
    sketch = drawn.sketch

    def warnings(self) -> Iterator[str]:
        """Warnings on slip, and on axial forces that tilt the rollers so that one end lifts off."""
        light = str(criterion.traffic_light(self.safety))
        if not self.bears_axial_load:
            yield (
                f"tan α = {self.mu_T:.4g} is not below μ = {self.mu:g} (Eq. 1): the torque alone "
                "releases the rollers, even without axial load"
            )
        elif light != "green":
            yield (
                f"μ/μ_req = {self.safety:.3g}, class {light}: the clutch slips along its axis; the "
                f"limit is F_ax = {self.F_lim:.4g} N"
            )
        if self.e * 6 > self.L:
            yield (
                f"the axial forces tilt the rollers: e = {self.e * 1e3:.3g} mm exceeds L/6, so "
                "that one end lifts off"
            )

    def advice(self) -> Iterator[str]:
        """Whether the clutch holds, and its behaviour beyond the limit."""
        if not self.bears_axial_load:
            yield "the clutch slips under the torque alone, because μ does not exceed tan α"
            return
        verdict = "the clutch holds" if self.safety >= 1 else "the clutch slips"
        yield (
            f"{verdict}: μ/μ_req = {self.safety:.4g}, class {criterion.traffic_light(self.safety)}"
        )
        yield (
            f"beyond F_ax = {self.F_lim:.4g} N the ring slips along the axis and also rotates; the "
            f"circumferential slip at its bore is {self.creep:.3g} times the axial slip; if the "
            f"ring cannot rotate, the rollers are released after {self.u_out * 1e3:.2g} mm of "
            "axial slip"
        )

    def refusal(self) -> str:
        """Reason why finite elements do not cover the inputs; empty if they do."""
        low, _ = self.within.both_contacts()
        if self.mu_T * (1 + CLOSE) / (1 + low) < self.mu:
            return super().refusal()
        return (
            f"tan α = {self.mu_T:.4g} is not below μ = {self.mu:g} by {CLOSE:.0%} or more: the "
            "torque alone releases the rollers, or nearly so; run check without --fem"
        )


def expected(interval: Interval | None, source: str = TILTED) -> Expected:
    """Expected error due to `source`: `interval`, or unknown if `interval` is None."""
    return underived(source) if interval is None else Expected(*interval, source)


FRICTION = adapted(FreewheelFriction)
