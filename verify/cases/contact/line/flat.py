"""Case of a roller between rigid flats: Hertz's line contact and the exact solution of the disc."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, ClassVar, Self

import numpy as np

from analytic.bounds.contact.line import PRESSURE, WIDTH, OnFlat
from analytic.contact import disc_stress, hertz_line_approach
from analytic.contact.disc import PressedDisc, disc_under_load
from verify.case import (
    AlongLine,
    Comparison,
    Drawn,
    Level,
    Quantity,
    Scan,
    State,
    approximation,
    identity,
    limit,
    shared,
)
from verify.cases.contact.expected import BLUNT, FLOOR, expected
from verify.cases.contact.line import figures, sketches
from verify.cases.contact.line.hertz import PROFILE, at, l2_errors
from verify.cases.contact.line.inputs import FlatInputs
from verify.cases.contact.line.reference import disc_fem, result
from verify.core.case import Context
from verify.core.figures import Array, Picture
from verify.form.adapter import adapted
from verify.judging import judge
from verify.judging.checks import Fact
from verify.judging.convergence import grid_convergence
from verify.judging.profile_checks import Coefficient, Points, ProfileError

SWEEP = (0.015, 0.03, 0.06, 0.1, 0.15)  # Hertz's a/R
WIDEST = SWEEP[-1]
WIDE = f"a/R = {WIDEST:g}"
LIMITS = "accepted error of this quantity"
DEPTH = 5e-3  # relative to the depth of the largest shear stress
DISC = "elastic disc between flats"
SERIES = (
    "derived series of the disc, ± (a/R)⁴ as an estimate of the next term; under the load F, at "
    "least ± 3e-4"
)
SHEAR = (
    "derived: −0.693 a/R due to the opposite flat and the round surface, "
    "± (a/R)² as an estimate of the next term, at least 1e-3"
)
DERIVED = 0.2, "sufficient to detect that a third of the derived coefficient is missing"


def key(ratio: float) -> str:
    """Suffix of the keys of results at the contact width a/R = `ratio`: "r150" for 0.15."""
    return f"r{round(1000 * ratio)}"


def relative_uncertainty(levels: Sequence[Level], key: str) -> float:
    """Relative standard uncertainty of `key` on the finest mesh; infinite without convergence."""
    h, v = [r.h for r in levels], [r.values[key] for r in levels]
    u_it = max(r.u_it.get(key, 0.0) for r in levels)
    grid = grid_convergence(h, v, formal=2.0, scale=abs(v[-1]), u_it=u_it)
    return judge.numerical_uncertainty(grid, u_it) / abs(v[-1])


class RollerOnFlat(FlatInputs):
    """Hertz's theory replaces the roller by a half-plane and the circular profile by a parabola.

    Finite elements must agree with the exact solution of an elastic disc, which does not contain
    these simplifications. A sweep over a/R measures the error of Hertz's theory. The measured error
    of p_0 confirms the derived error, −3/16 (a/R)².
    """

    id = "contact-flat"
    title = "Roller between rigid flats"
    scans: ClassVar = (Scan(vary=("F=100N:30000N:6:log", "nu=0,0.3,0.45"), star=True),)
    readings: ClassVar = (
        "the roller is long: plane strain with the modulus E/(1 − ν²)",
        "the load per length is F/L; R is the radius of the roller, not its diameter",
        "δ is the approach of one flat and the centre of the roller; the two flats approach by 2 δ",
    )
    assumptions: ClassVar = (
        "linear elasticity, no friction; the ends of the roller are not modelled",
        "the load acts on both flats: a quarter of the roller is modelled, and its horizontal cut "
        "stays straight",
        "the half-width is computed from moments of the pressure, 2 √(∫p x²/∫p); for Hertz's "
        "pressure, this equals Hertz's a",
        "each mesh has a node at the edge of the contact; a coarse solution locates this edge",
    )

    @Quantity("δ", "µm", "approach of flat and roller centre, Hertz", source="Hertz, "
              "approach of flat and roller "
              "centre", tex=r"\frac{P}{\pi E*} (2 \ln\left(\frac{4 R}{a}\right) - 1)")  # fmt: skip
    def approach(self) -> float:
        sizes = {"P": self.P, "a": self.a, "R": self.R}
        return float(hertz_line_approach.approach_to_centre(**sizes, E_plane=self.E_star))

    @Quantity("a/R", "1", "ratio of half-width to radius", role="step", tex=r"\frac{a}{R}")
    def ratio(self) -> float:
        return self.a / self.R

    @Quantity("e_p", "1", "relative excess of the disc's peak pressure over Hertz's peak "
              "pressure, first term of the series", role="step",
              source="derived", tex=r"\frac{3}{16} \frac{a^2}{R^2}")  # fmt: skip
    def excess(self) -> float:
        return -PRESSURE * self.ratio**2

    p_0_disc = Quantity("p_0", "MPa", "peak pressure, disc", source=DISC, form_of="p_0",
                        safe="too high").reads(lambda q: q.disc.p_0)  # fmt: skip
    a_disc = Quantity("a", "µm", "half-width, disc", source=f"{DISC}, by moments of the pressure",
                      form_of="a").reads(lambda q: q.disc.moment_width)  # fmt: skip
    approach_disc = Quantity("δ", "µm", "approach of flat and roller centre, disc", source=DISC,
                             form_of="approach").reads(lambda q: q.disc.approach)  # fmt: skip
    tau_max_disc = Quantity("τ_max", "MPa", "largest shear stress, disc", source=DISC,
                            form_of="tau_max",
                            safe="too high").reads(lambda q: q.disc_shear[0])  # fmt: skip
    z_disc = Quantity("z", "µm", "depth of the largest shear stress, disc", source=DISC,
                      form_of="z").reads(lambda q: q.disc_shear[1])  # fmt: skip

    @shared
    def disc(self) -> PressedDisc:
        """Exact solution of the elastic disc under the load."""
        return disc_under_load(P=self.P, R=self.R, E_plane=self.E_star)

    @shared
    def disc_shear(self) -> tuple[float, float]:
        """Largest shear stress [Pa] in the disc and its depth [m]."""
        return disc_stress.largest_shear_stress(disc=self.disc)

    def disc_pressure(self, x: Any) -> Array:
        """Pressure [Pa] at x [m] by the exact solution: force per area of the round surface."""
        return np.asarray(self.disc.pressure(x) * np.sqrt(1 - (x / self.R) ** 2))

    def at_ratio(self, ratio: float) -> Self:
        """The roller under the load for which Hertz's a/R equals `ratio`."""
        return self.under(float(np.pi / 4 * ratio**2 * self.R / self.softness))

    def reference(self, level: int) -> Level:
        """Results of the quarter disc under the load and under the loads of the sweep."""
        swept = {f"_{key(e)}": disc_fem(self, self.at_ratio(e).P, e * self.R, level) for e in SWEEP}
        found = disc_fem(self, self.P, self.guess, level)
        return result(found, level, ("axis", "middle"), swept)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: exact disc; expected errors of Hertz's theory; limit of narrow contacts."""
        by = RollerOnFlat
        wide = State(self.at_ratio(WIDEST), key(WIDEST), WIDE, displayed=False)
        places = (("", None), (WIDE, wide))
        exact = ((by.p_0_disc, 5e-4), (by.a_disc, 1e-3), (by.approach_disc, 1e-3))
        for where, state in places:
            for q, sharp in exact:
                yield identity(q, state=state, name=at(q, where), order=2,
                               sensitivity=(sharp, LIMITS))  # fmt: skip
        yield self.profile()
        yield identity(by.tau_max_disc, order=2)
        name = (
            "depth of the largest shear stress: finite elements and elastic disc agree within "
            f"{DEPTH:.1%}"
        )
        depth = Fact(name=name, symbol="z", unit="1", margin=self.depth_margin)
        yield Comparison(check=depth, quantity=by.z_disc)
        narrow = OnFlat(self.ratio)
        for (where, state), known, least in zip(places, (narrow, OnFlat(WIDEST)), (FLOOR, 0.0),
                                                strict=True):  # fmt: skip
            for q, one in ((by.p_0, known.pressure), (by.a, known.width),
                           (by.approach, known.approach)):  # fmt: skip
                yield approximation(q, state=state, name=at(q, where), order=2,
                                    expected=expected(one, SERIES, least=least))  # fmt: skip
        yield approximation(by.tau_max, order=2,
                            expected=expected(narrow.shear, SHEAR, least=BLUNT))  # fmt: skip
        for q, sharp in ((by.p_0, 5e-4), (by.a, 1e-3)):
            yield limit(q, f"error in the limit a/R → 0: {q.what}", "d_0",
                        points=self.deviations(q), exponent=2,
                        sensitivity=(sharp, LIMITS))  # fmt: skip
        for q, theory in ((by.p_0, PRESSURE), (by.a, WIDTH)):
            yield self.coefficient(q, theory)
        yield from self.balances()

    def coefficient(self, q: Quantity, theory: float) -> Comparison:
        """Row: coefficient of (a/R)^2 in the error of Hertz's `q`, judged against `theory`."""
        points = self.deviations(q)
        check = Coefficient(
            name=f"coefficient of (a/R)² in the error: {q.what}", symbol="c", unit="1",
            theory=theory,
            points=lambda context: points(context.fem), demand=DERIVED[0], demand_reason=DERIVED[1],
        )  # fmt: skip
        return Comparison(check=check, quantity=q)

    def profile(self) -> Comparison:
        """Row: L2 difference between the pressure profiles of finite elements and exact disc."""
        check = ProfileError(
            name="L2 error of the pressure profile relative to the exact disc", symbol="e_2",
            unit="1", fem="L2", analytic="zero", scale="one", formal=1, demand=PROFILE,
            demand_reason=LIMITS, errors=l2_errors(self.disc_pressure),
        )  # fmt: skip
        numbers = {"zero": 0.0, "one": 1.0}
        return Comparison(check=check, quantity=RollerOnFlat.p_0_disc, numbers=numbers)

    def depth_margin(self, context: Context) -> tuple[float, float]:
        """Margin, positive if the depth of the largest shear stress is accurate; its uncertainty.

        Stresses jump between cells, so that the depth converges without an order. The uncertainty
        is therefore three times the spread of the last three levels.
        """
        depths = np.array(context.series("z")[1][-3:]) / self.z_disc
        return DEPTH - float(abs(depths[-1] - 1)), 3 * float(np.ptp(depths))

    def deviations(self, q: Quantity) -> Callable[[Sequence[Level]], Points]:
        """Function of levels that returns a/R, errors of Hertz's theory and their uncertainties."""

        def points(levels: Sequence[Level]) -> Points:
            d, u = [], []
            for e in SWEEP:
                name = f"{q.name}_{key(e)}"
                d.append(getattr(self.at_ratio(e), q.name) / levels[-1].values[name] - 1)
                u.append(relative_uncertainty(levels, name))
            return list(SWEEP), d, u

        return points

    def figures(self) -> Iterator[AlongLine | Drawn]:
        """Figures: computed and exact pressure, error of Hertz's theory over a/R, convergence."""
        note = (
            "Line: exact solution of the disc, as force per area of the round surface; dots: "
            "finite elements, finest mesh, up to x = 0.85 a. Lower diagram: line minus dots; band: "
            "uncertainty of the whole profile."
        )
        yield figures.pressure(self, self.disc_pressure, "the exact disc", note)
        for q, theory, words in (
            (RollerOnFlat.p_0, PRESSURE, "−3/16"), (RollerOnFlat.a, WIDTH, "+1/4"),
        ):  # fmt: skip
            yield figures.neglected(q.symbol, theory, words, self.deviations(q))
        limits = {"p_0": self.p_0_disc, "a": self.a_disc, "approach": self.approach_disc}
        yield figures.refinement(lambda _: limits, "the limit is the value of the exact disc")

    def pictures(self) -> Iterator[Picture]:
        """Pictures of stresses near the contact, in the roller only; the flat is rigid."""
        yield from figures.pictures(self.guess, below=0.05)

    sketch = sketches.flat


FLAT = adapted(RollerOnFlat)
