"""Uniform turning shaft: three beam theories, two kinds of elements, and the elastic body."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from verify.case import (
    Comparison,
    Drawn,
    Level,
    Quantity,
    Scan,
    State,
    approximation,
    identity,
    limit,
)
from verify.cases.rotor.shaft import bounds
from verify.cases.rotor.shaft import figures as drawn
from verify.cases.rotor.shaft.formulas import BeamTheories
from verify.cases.rotor.shaft.inputs import MODES, RATIOS, THEORIES
from verify.core.case import Check, Context
from verify.core.figures import Sketch, Table
from verify.form.adapter import adapted
from verify.judging.checks import Accepted, Limit, Order
from verify.judging.judge import DEMAND
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, farthest

CEILING = 0.002  # of a uniform tube's frequencies, Timoshenko's beam against the elastic body
FINE = 1e-5  # of a slender shaft's frequency, 32 elements
TOWARDS = (0.0125, 0.025, 0.05, 0.125)  # diameters over lengths of Timoshenko's limit
DIGITS = 2e-12  # of both sides there
FASTEST = 600.0  # rim speed [m/s] that hardly any steel bears
FOUR, TWO = "elements of order four", "elements of order two"
NEIGHBOURS = "tells an order from its neighbours"
BEAM = "Timoshenko's beam with Hutchinson's shear coefficient"
Points = tuple[list[float], list[float], list[float]]


class UniformShaft(BeamTheories):
    """The elements of which the paper's rotors are made, on a shaft with closed forms.

    These are Euler's, Rayleigh's and Timoshenko's. The same shaft as an elastic body, whose whirl
    elasticity gives exactly, says what a beam leaves out. The paper prints no dimension: those are
    this project's.
    """

    id = "rotor-shaft"
    title = "Uniform shaft that turns"
    source = "huang2022"
    place = "Sec. 1: rotors of Timoshenko's beam elements (Nelson)"
    levels: ClassVar = (1, 2, 4, 8)
    scans: ClassVar = (
        Scan(
            vary=(
                "L=200mm,300mm,400mm,600mm,1200mm", "d_i=0mm,30mm,50mm",
                "n=2000r/min,10000r/min,30000r/min",
            ),
            star=True,
        ),
    )  # fmt: skip
    readings: ClassVar = (
        "the shear coefficient is Hutchinson's; with Cowper's the error falls with (d/L)² alone",
        "terms in Ω² and the stiffness of centrifugal stress are left out together: they cancel "
        "where sections turn as if rigid",
    )
    assumptions: ClassVar = (
        "ends held across and free along, bearings rigid",
        "linear elasticity, no damping",
        "critical speeds are those of synchronous forward whirl",
    )

    def reference(self, level: int) -> Level:
        """Closed-form elements, weak forms, and the elastic body."""
        from verify.cases.rotor.shaft.reference import solve

        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Beams beside beams, elasticity beside the body, beams beside the body, limits, orders."""
        yield from self._beams()
        yield from self._bodies()
        yield from self._neglected()
        first = UniformShaft.at_rest(1)
        yield limit(first, "Euler's beam as d/L goes to 0", "ω", points=self._euler_limit,
                    exponent=2)  # fmt: skip
        anew = FormulasLimit(name="Timoshenko's beam as d/L goes to 0", symbol="ω", unit="1",
                             points=lambda _: self._timoshenko_limit(), exponent=4)  # fmt: skip
        yield Comparison(check=anew, quantity=first)
        yield from self._orders()
        stated: dict[str, Any] = {"symbol": "ω", "unit": "rad/s", "source": SUBJECT}
        within = Agreement(name="Timoshenko's beam is within 0.2 % of the elastic body, modes 1 to "
                           "3", pair=self._within_ceiling, accepted=CEILING, **stated)  # fmt: skip
        yield Comparison(check=within, quantity=first)
        fine = Agreement(name="32 elements are within 1e-5 at d/L = 0.03, mode 1",
                         pair=self._fine, accepted=FINE, **stated)  # fmt: skip
        yield Comparison(check=fine, quantity=first, shares=BEAM)
        sense = Accepted(name="turning speeds forward whirl up and slows backward whirl down",
                         symbol="ω", unit="1", margin=_sense)  # fmt: skip
        yield sense

    @property
    def _theories(self) -> tuple[State, ...]:
        """Euler's, Rayleigh's, Timoshenko's."""
        return (State(self.euler, "euler", "Euler", "{}E"),
                State(self.rayleigh, "rayleigh", "Rayleigh", "{}R"),
                State(self, "", "Timoshenko"))  # fmt: skip

    @property
    def _elasticity(self) -> State:
        return State(self.exact, "elasticity", "elasticity", "{}'")

    def _beams(self) -> Iterator[Comparison]:
        """Closed-form elements and weak forms against the same theory."""
        modes = ((1, "forward"), (1, "backward"), (3, "forward"))
        for theory, state in zip(THEORIES, self._theories, strict=True):
            short = theory == "timoshenko"
            for q, words in _named(modes):
                third = short and q == UniformShaft.whirl(3, "forward")
                yield _whirl(
                    q, f"beam_{theory}_{q.name}", f"elements of {state.words}, {words}",
                    order=2 if short else 4, state=state, demand=2e-3 if third else 1e-3,
                )  # fmt: skip
        euler, rayleigh, timoshenko = zip(THEORIES, self._theories, strict=True)
        for (theory, state), j, way in ((euler, 3, "forward"), (rayleigh, 1, "backward"),
                                        (timoshenko, 1, "forward"),
                                        (timoshenko, 3, "forward")):  # fmt: skip
            q = UniformShaft.whirl(j, way)
            yield _whirl(q, f"weak_{theory}_{q.name}",
                         f"weak form of {state.words}, mode {j} {way}", order=4, state=state,
                         by="weak form")  # fmt: skip

    def _bodies(self) -> Iterator[Comparison]:
        """The elastic body against elasticity, and both splittings."""
        shaft, exact = UniformShaft, self._elasticity
        yield _whirl(shaft.pochhammer, "solid_at_rest_1",
                     "elastic body at rest, Pochhammer's equation", order=4)  # fmt: skip
        modes = ((1, "forward"), (1, "backward"), (2, "forward"), (3, "forward"))
        for q, words in _named(modes):
            yield _whirl(q, f"solid_{q.name}", f"elastic body, {words}", order=4, state=exact)
        name = "what turning splits mode 1 by"
        yield _whirl(shaft.split, "beam_timoshenko_split", f"{name}, elements", order=2,
                     state=self._theories[-1])  # fmt: skip
        yield _whirl(shaft.split, "solid_split", f"{name}, elastic body", order=4, state=exact)

    def _neglected(self) -> Iterator[Comparison]:
        """Beams at rest against the body, as Timoshenko's equation says beforehand."""
        fine: dict[str, Any] = {"symbol": "ω", "order": 4}
        for j in MODES:
            expected = bounds.against_elasticity(self, j, self.exact.at_rest(j))
            yield approximation(UniformShaft.at_rest(j), f"solid_at_rest_{j}", expected=expected,
                                name=f"Timoshenko's beam, mode {j}, at rest",
                                sensitivity=(1e-3, FOUR), **fine)  # fmt: skip
        for theory, state in zip(THEORIES[:2], self._theories, strict=False):
            expected = bounds.neglected(theory, self.rotary, self.shear)
            yield approximation(UniformShaft.at_rest(1), "solid_at_rest_1", expected=expected,
                                name=f"{state.words}'s beam, mode 1, at rest", state=state,
                                **fine)  # fmt: skip

    def _orders(self) -> Iterator[Comparison]:
        """How fast each kind of elements converges in mode 1 forward."""
        euler, rayleigh, timoshenko = self._theories
        for words, model, state, order, demand in (
            ("Euler's elements", "beam_euler", euler, 4, DEMAND),
            ("Rayleigh's elements", "beam_rayleigh", rayleigh, 4, DEMAND),
            ("Timoshenko's elements", "beam_timoshenko", timoshenko, 2, 0.1),
            ("the weak form", "weak_timoshenko", timoshenko, 4, DEMAND),
            ("the elastic body", "solid", self._elasticity, 4, 0.03),
        ):
            check = Order(name=f"order of {words}", symbol="p", unit="1", order=order,
                          errors=_errors(f"{model}_whirl_1_forward", state), demand=demand,
                          demand_reason=NEIGHBOURS if demand > DEMAND else "")  # fmt: skip
            yield Comparison(check=check, quantity=UniformShaft.whirl(1, "forward"), state=state)

    def _euler_limit(self, levels: Any) -> Points:
        """Euler's error at rest against the elastic body, as the shaft gets slender.

        Beside the meshes' uncertainty stands that of a first term alone: (k r)^2 of it.
        """
        runs = np.array([r.arrays["limit"] for r in levels])
        formula = [self.shaft(L=self.d_o / x).whirl(1, theory="euler")[0] for x in RATIOS]
        d = formula / runs[-1] - 1
        u = np.abs(runs[-1] / runs[-2] - 1) + np.abs(d) * (np.pi / 2 * np.array(RATIOS)) ** 2
        return list(RATIOS), d.tolist(), u.tolist()

    def _timoshenko_limit(self) -> Points:
        """Timoshenko's error at rest against the cylinder of elasticity, its first term alike."""
        d = []
        for x in TOWARDS:
            exact = self.cylinder().whirl(np.pi * x / self.d_o)[0][0]
            d.append(self.shaft(L=self.d_o / x).whirl(1, theory="timoshenko")[0] / exact - 1)
        u = DIGITS + np.abs(d) * (np.pi / 2 * np.array(TOWARDS)) ** 2
        return list(TOWARDS), d, u.tolist()

    def _within_ceiling(self, context: Context) -> Pair:
        """Timoshenko's beam and the elastic body, of modes 1 to 3 where they differ most."""
        runs = [context.series(f"solid_at_rest_{j}")[1] for j in MODES]
        beams, bodies = (np.array(v) for v in ([self.at_rest(j) for j in MODES],
                                               [v[-1] for v in runs]))  # fmt: skip
        found = farthest(beams, bodies, max(abs(v[-1] / v[-2] - 1) for v in runs))
        return replace(found, words=", ".join(f"{x:+.4%}" for x in beams / bodies - 1))

    def _fine(self, context: Context) -> Pair:
        """The beam and 32 elements, the finest, on a shaft of d/L = 0.03."""
        v, beam = context.series("beam_slender")[1][-1], self.slender.at_rest(1)
        return Pair(beam, v, 1e-9 * abs(v), f"{v / beam - 1:.1e}")

    def warnings(self) -> Iterator[str]:
        """Where a theory is off, and where the speed is critical or bursts the shaft."""
        if (error := self.euler.at_rest(1) / self.exact.at_rest(1) - 1) > 0.02:
            yield f"Euler's beam is {error:+.1%} off at mode 1: take Timoshenko's"
        worst = max((self.at_rest(j) / self.exact.at_rest(j) - 1 for j in MODES), key=abs)
        if abs(worst) > CEILING:
            yield f"Timoshenko's beam is {worst:+.2%} off in modes 1 to 3: too stubby or thin"
        near = min(abs(self.n / self.exact.critical - 1), 1.0)
        if near < 0.1:
            yield f"{self.n * 30 / np.pi:.5g} r/min is within {near:.0%} of the critical speed"
        if (rim := self.n * self.d_o / 2) > FASTEST:
            yield f"its rim runs at {rim:.0f} m/s: steel bursts at some {FASTEST:.0f} m/s"

    def tables(self, context: Context) -> Iterator[Table]:
        """Frequencies of all theories beside the body's."""
        yield drawn.frequencies(context)

    def sketch(self) -> Sketch:
        """The shaft in its bearings."""
        return drawn.sketch(self)

    def figures(self) -> Iterator[Drawn]:
        """Errors over slenderness, the Campbell diagram, refinement."""
        yield Drawn(drawn.figures)


@dataclass(frozen=True, kw_only=True)
class FormulasLimit(Limit):
    """Both sides are formulas: no finite elements."""

    @property
    def needs_fem(self) -> bool:
        return False


def _whirl(
    q: Quantity, reference: str, name: str, *, order: float, demand: float = 1e-3, **more: Any
) -> Comparison:
    """A frequency or a critical speed of elements against the exact one."""
    symbol = "Ω_c" if q == UniformShaft.critical else "ω"
    shares = BEAM if "timoshenko" in reference else ""
    return identity(q, reference, name=name, symbol=symbol, unit="rad/s", order=order,
                    sensitivity=(demand, FOUR if order == 4 else TWO), shares=shares,
                    **more)  # fmt: skip


def _named(modes: tuple[tuple[int, str], ...]) -> Iterator[tuple[Quantity, str]]:
    """Frequencies and the critical speed with their names in rows."""
    yield from ((UniformShaft.whirl(j, way), f"mode {j} {way}") for j, way in modes)
    yield UniformShaft.critical, "critical speed"


def _errors(key: str, state: State) -> Callable[[Context], tuple[list[float], list[float]]]:
    """Signed errors of mode 1 forward against its theory, per level."""

    def found(context: Context) -> tuple[list[float], list[float]]:
        h, v = context.series(key)
        exact = state.case.whirl(1, "forward")  # type: ignore[attr-defined]
        return h, [value / exact - 1 for value in v]

    return found


def _sense(context: Context) -> tuple[float, float, str]:
    """The least share by which forward whirl is faster, where elements name it so."""
    v = context.fem[-1].values
    share = [v[f"{name}_split"] / v[f"{name}_whirl_1_forward"]
             for name in ("beam_timoshenko", "weak_timoshenko", "solid")]  # fmt: skip
    named = v["beam_sense"] == 2  # the faster of the pair is +1, the slower -1
    return min(share) if named else -1.0, 1e-9, f"by {min(share):.2%} of the frequency"


SHAFT = adapted(UniformShaft)
