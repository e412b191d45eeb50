"""Case of a rotating outer race: centrifugal growth (Eq. 8) against deflection by sprags."""

from collections.abc import Iterator
from typing import Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from analytic.ring import rotating
from analytic.ring.smeared import race_deflection
from verify.case import (
    AlongLine,
    Case,
    Comparison,
    Drawn,
    Level,
    Quantity,
    Scan,
    State,
    balance,
    count,
    errors_of,
    given,
    identity,
    picture,
    plane_field,
    sketches,
)
from verify.cases.ring import walls
from verify.core.case import Check, Context
from verify.core.figures import Curve, Curves, Picture, Shape, Sketch
from verify.core.results import Kind, Row, Status
from verify.form.adapter import adapted
from verify.form.sketches import polar
from verify.judging import judge
from verify.judging.checks import Order
from verify.judging.claims import Claim

Ends = Literal["plane stress", "plane strain"]
FASTEST = 0.05  # strain beyond which small-strain elasticity is no model
PARABOLAS = "parabolas replace circles: error of their first moment below (angle of a cell)^4"
RPM = np.pi / 30


class RotatingRace(Case):
    """Centrifugal force widens the outer race, so that the race can separate from the sprags.

    Formula and finite elements solve the same problem. The growth of the bore is compared with its
    deflection under the sprags. The paper prints neither speed nor density: both are assumed.
    """

    id = "ring-rotation"
    title = "Rotating race"
    source = "huang2018"
    place = "Eq. 8; Table 1, radii of the outer race"
    levels: ClassVar = (2, 4, 8, 12)
    ends: ClassVar[Ends] = "plane stress"  # ends for the quantities below
    scans: ClassVar = (Scan(vary=("r_i=5mm,12mm,19.44mm,24mm", "nu=0.1,0.3,0.45"), star=True),)
    readings: ClassVar = (
        "n of Eq. 8 is a speed in r/min, so that πn/30 is the angular speed; ρ is the density",
        "Eq. 8 gives the growth of the bore of an axially short ring (plane stress); the growth of "
        "an axially long ring (plane strain) differs",
    )
    assumptions: ClassVar = (
        "linear elasticity, small strain",
        "steady rotation; bore and rim are unloaded",
        "a quarter is modelled, with symmetry on both cuts",
    )

    r_i: float = given(
        "19.44 mm", "mm", "R_e", "bore radius", gt=0, le=1e5, claims="huang2018:table1-r-e"
    )
    r_o: float = given(
        "26.23 mm", "mm", "R_ed", "outer radius", gt=0, le=1e5, claims="huang2018:table1-r-ed"
    )
    omega: float = given("3000 r/min", "r/min", "n", "speed (assumed, not printed)", gt=0, le=1e7)
    rho: float = given("7850 kg/m^3", "kg/m^3", "ρ", "density (assumed, not printed)", gt=0, le=1e5)
    E: float = given("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    n: int = count(
        12, "n_s", "number of sprags", ge=1, le=10_000, claims="huang2018:table1-number-of-sprags"
    )
    F: float = given(
        "3407 N", "N", "N_be", "force of a sprag (identified, not printed)", gt=0, le=1e9
    )
    L: float = given(
        "9 mm", "mm", "l", "length of the sprags (identified, not printed)", gt=0, le=1e4
    )
    R_p: float | None = given(
        None, "MPa", "R_p", "yield strength", omitted=None, gt=0,
        example="1200 MPa",
    )  # fmt: skip

    @model_validator(mode="after")
    def _ring(self) -> Self:
        walls.check_wall(self.r_i, self.r_o, ("R_e", "R_ed"))
        strain = self.rho * (self.omega * self.r_o) ** 2 / self.E
        if strain > FASTEST:
            raise ValueError(
                f"{self.omega * 30 / np.pi:.6g} r/min strains the ring by {strain:.0%}, more "
                "than 5 %: the ring bursts; reduce the speed"
            )
        return self

    @Quantity("δ_ce", "µm", "bore growth", equation="8",
              tex=r"\frac{R_e}{E} \frac{(3 + \nu) \rho}{4} n^2 "
              r"(R_{ed}^2 + R_e^2 \frac{1 - \nu}{3 + \nu})")  # fmt: skip
    def growth(self) -> float:
        return self._displacement(self.r_i)

    @Quantity("u_r(R_ed)", "µm", "rim growth", source="rotating disc")
    def growth_rim(self) -> float:
        return self._displacement(self.r_o)

    @Quantity("U", "J/m", "strain energy", source="rotating disc")
    def U(self) -> float:
        return float(rotating.strain_energy(E=self.E, assumption=self.ends, **self._race))

    @Quantity("σ_θ(R_e)", "MPa", "bore hoop stress", source="rotating disc")
    def hoop_bore(self) -> float:
        return float(self._stresses[1][0])

    @Quantity("σ_θ(R_ed)", "MPa", "rim hoop stress", source="rotating disc")
    def hoop_rim(self) -> float:
        return float(self._stresses[1][2])

    @Quantity("σ_r(r_m)", "MPa", "mid-wall radial stress", source="rotating disc")
    def radial_mid(self) -> float:
        return float(self._stresses[0][1])

    @Quantity("δ_BE", "µm", "deflection of the bore under the sprags", equation="6",
              role="step")  # fmt: skip
    def under_sprags(self) -> float:
        return float(race_deflection(P=self.F / self.L, n=self.n, r_i=self.r_i, r_o=self.r_o,
                                     E=self.E, nu=self.nu, loaded="bore"))  # fmt: skip

    @Quantity("δ_ce/δ_BE", "1",
              "ratio of the bore growth by Eq. 8 to the deflection of the race by Eq. 6",
              source="Eq. 8 over Eq. 6",
              tex=r"\frac{\delta_{ce}}{\delta_{BE}}", role="step")  # fmt: skip
    def ratio(self) -> float:
        return self.growth / self.under_sprags

    @Quantity("n_1", "r/min", "speed at which δ_ce/δ_BE is 1 %", role="step")
    def n_1(self) -> float:
        return self.omega * float(np.sqrt(0.01 / self.ratio))

    @Quantity("n_10", "r/min", "speed at which δ_ce/δ_BE is 10 %", role="step")
    def n_10(self) -> float:
        return self.omega * float(np.sqrt(0.1 / self.ratio))

    @property
    def _race(self) -> dict[str, float]:
        return {"r_i": self.r_i, "r_o": self.r_o, "rho": self.rho, "omega": self.omega,
                "nu": self.nu}  # fmt: skip

    @property
    def _stresses(self) -> tuple[Any, Any]:
        """Radial and hoop stresses [Pa] at bore, mid-wall and rim, each of shape (3,)."""
        radii = [self.r_i, (self.r_i + self.r_o) / 2, self.r_o]
        return rotating.stresses(radii, assumption=self.ends, **self._race)

    def _displacement(self, r: float) -> float:
        race = self._race
        return float(rotating.radial_displacement(r, E=self.E, assumption=self.ends, **race))

    def as_long(self) -> Self:
        """The race in plane strain."""
        return self.variant(ends="plane strain")

    def reference(self, level: int) -> Level:
        """Results of a quarter of the race under centrifugal forces: plane stress, plane strain."""
        pull = self.rho * self.omega**2

        def read(race: Any) -> dict[str, float]:
            bore, rim, middle = (race.on_boundary(name) for name in ("bore", "rim", "middle"))
            return {
                "growth": bore.mean(bore.polar()[0]), "growth_rim": rim.mean(rim.polar()[0]),
                "hoop_bore": bore.mean(bore.polar()[2]), "hoop_rim": rim.mean(rim.polar()[2]),
                "radial_mid": middle.mean(middle.polar()[1]), "U": 4 * race.strain_energy,
                # force on a quarter along x: rho omega² times the integral of x
                "balance": race.reaction("x=0")[0] + pull * (self.r_o**3 - self.r_i**3) / 3,
            }  # fmt: skip

        thin, long = (
            walls.quarter_fem(self, self.r_i, self.r_o, ends, level, body_forces=lambda x: pull * x)
            for ends in ("plane stress", "plane strain")
        )
        values = read(thin) | {f"{name}_strain": value for name, value in read(long).items()}
        profiles = dict(walls.across(self, thin))
        round_off = max(race.residual**0.5 for race in (thin, long))
        u_it = {key: round_off * abs(value) for key, value in values.items()}
        u_it |= {key: round_off * float(np.abs(array).max()) for key, array in profiles.items()}
        field = plane_field(thin, "stress", "von_mises", "hoop_stress", name="plane stress")
        return Level(h=1 / level, values=values, u_it=u_it, arrays=profiles, fields=(field,))

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows: thin and long race against the formulas of the rotating disc."""
        race = RotatingRace
        states = (State(self, "", "plane stress"), State(self.as_long(), "strain", "plane strain"))
        for q in (race.growth, race.growth_rim, race.U):
            for state in states:
                name = f"{q.what}, {state.words}"
                yield identity(q, state=state, name=name, order=4, sensitivity=walls.FAST)
        for q in (race.hoop_bore, race.hoop_rim, race.radial_mid):
            for state in states:
                at: Any = state.case
                scale = {f"bore hoop stress, {state.words}": at.hoop_bore}
                yield identity(q, state=state, scale=scale, order=2, sensitivity=walls.FAST)
        load = self.rho * self.omega**2 * (self.r_o**3 - self.r_i**3) / 3
        for state in states:
            residual = "balance_strain" if state.key else "balance"
            yield balance(residual, f"balance of forces, {state.words}", "ΣF_x", "N/mm",
                          of={"centrifugal force": load}, bound=1e-9,
                          because=PARABOLAS)  # fmt: skip
        for state in states:
            yield Order(name=f"order of convergence of the strain energy, {state.words}",
                        symbol="p", unit="1", errors=errors_of(race.U, state=state), order=4,
                        **walls.SQUARED)  # fmt: skip
        name = "ratio of the bore growth by Eq. 8 to the deflection of the race by Eq. 6"
        yield Comparison(check=Small(name=name, symbol="δ_ce/δ_BE", unit="1"), quantity=race.ratio)

    def figures(self) -> Iterator[AlongLine | Drawn]:
        """Figures: profiles across the wall; growth over speed with the deflection under sprags."""
        thin: dict[str, Any] = self._race | {"assumption": "plane stress"}
        yield from walls.profiles(
            self, "plane stress", lambda r: rotating.stresses(r, **thin),
            lambda r: rotating.radial_displacement(r, E=self.E, **thin), stress=self.hoop_bore,
            moved=self.growth,
        )  # fmt: skip
        yield Drawn(lambda _: (self._over_speed(),))

    def _over_speed(self) -> Curves:
        top = 1.1 * max(self.n_10, self.omega)
        speed = np.linspace(0, top, 81)
        shares = (
            Curve(name=f"{part:.0%} of the deflection under the sprags, Eq. 6",
                  x=np.array([0.0, top]) / RPM, y=np.full(2, part * self.under_sprags * 1e6),
                  style="dashes", colour=k)
            for k, part in enumerate((0.01, 0.1), start=1)
        )  # fmt: skip
        return Curves(
            title="Growth of the bore over speed", x_label="n [r/min]", y_label="u_r(R_e) [µm]",
            curves=(
                Curve(name="growth, Eq. 8", x=speed / RPM,
                      y=self.growth * 1e6 * (speed / self.omega) ** 2),
                *shares,
                Curve(name="assumed speed", x=np.array([self.omega / RPM]),
                      y=np.array([self.growth * 1e6]), style="dots"),
            ),
            note="The paper prints no speed: the operating point of its clutch on this curve is "
            "unknown.",
        )  # fmt: skip

    def pictures(self) -> Iterator[Picture]:
        """Picture of the hoop stress of the race in plane stress."""
        yield picture("plane stress", "hoop_stress", "Hoop stress, plane stress, element averages",
                      mirror="xy")  # fmt: skip

    def sketch(self) -> Sketch:
        """Sketch of the race with its speed."""
        inner, speed = self.r_i / self.r_o, f"{self.omega / RPM:.5g}"
        turn = np.array([polar(inner - 0.15, d) for d in np.linspace(200, 340, 73)])
        return sketches.sketch(
            f"race at {speed} r/min, density {self.rho:.5g} kg/m³", walls.quarter(inner),
            (Shape(style="faint", points=turn), Shape(style="load", points=turn[-2:]),
             Shape(style="text", points=np.array([[0.0, -inner / 2]]), label=f"n = {speed}")),
            walls.radii(((f"R_ed = {self.shown('r_o')}", 140, 1.0),
                         (f"R_e = {self.shown('r_i')}", 160, inner))),
        )  # fmt: skip

    def warnings(self) -> Iterator[str]:
        """Warnings if the race yields, or grows by more than 1 % of its deflection under sprags."""
        stress = self.hoop_bore
        if self.R_p is not None and stress > self.R_p:
            yield (
                f"hoop stress {stress / 1e6:.4g} MPa at the bore exceeds R_p = "
                f"{self.shown('R_p')}: the race yields"
            )
        if self.R_p is None and stress / self.E > 2e-3:
            yield f"strain reaches {stress / self.E:.2%} at the bore: most steels yield; enter R_p"
        if self.ratio > 0.01:
            yield (
                f"the growth of the bore is {self.ratio:.2%} of its deflection under the sprags: "
                f"Eq. 8 is relevant from {self.n_1 / RPM:.5g} r/min (1 %)"
            )


class Small(Claim):
    """Ratio of the growth by Eq. 8 to the deflection by Eq. 6; not judged.

    The paper prints neither speed nor density.
    """

    kind = Kind.FACT

    @property
    def needs_fem(self) -> bool:
        return False

    def rows(self, context: Context) -> list[Row]:
        q = context.inputs
        words = (
            f"δ_ce/δ_BE is {q.ratio:.2%} at {q.omega * 30 / np.pi:.6g} r/min, 1 % at "
            f"{q.n_1 * 30 / np.pi:.5g} r/min and 10 % at {q.n_10 * 30 / np.pi:.5g} r/min"
        )
        verdict = judge.Verdict(
            Status.SHOWN,
            f"the paper prints neither speed nor density; with ρ of the inputs, {words}",
        )
        return [self._row(context.case, Kind.FACT, verdict, analytic=q.ratio)]


ROTATION = adapted(RotatingRace)
