"""Rows of a uniform rotating shaft: beams and finite elements against exact solutions."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from analytic.bounds.rotor import shaft as bounds
from verify.case import (
    Comparison,
    Expected,
    Quantity,
    State,
    about,
    approximation,
    identity,
    limit,
    underived,
)
from verify.cases.rotor.shaft.formulas import BeamTheories
from verify.cases.rotor.shaft.inputs import MODES, RATIOS, THEORIES
from verify.core.case import Check, Context
from verify.judging.checks import Accepted, Limit, Order
from verify.judging.judge import DEMAND
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, farthest

CEILING = 0.002  # frequencies of a uniform tube, Timoshenko's beam against the elastic body
NEAR = 5e-5  # uncertainty of the predicted error of a formula
FINE = 1e-5  # relative to a slender shaft's frequency, 32 elements
TOWARDS = (0.0125, 0.025, 0.05, 0.125)  # diameters over lengths of Timoshenko's limit
DIGITS = 2e-12  # relative accuracy of both sides for this quantity
FOUR, TWO = "the elements have convergence order four", "the elements have convergence order two"
SOLVED = "derived: relative difference of the exact frequency by Timoshenko's equation from the "\
         "frequency of the elastic cylinder; uncertainty: ± 5e-5"  # fmt: skip
SERIES = "derived: terms of Timoshenko's equation that the formula neglects, to second order"
NEIGHBOURS = "sufficient to distinguish this order from the next integer"
BEAM = "Timoshenko's beam with Hutchinson's shear coefficient"
Points = tuple[list[float], list[float], list[float]]


def rows(beam: BeamTheories) -> Iterator[Comparison | Check]:
    """All rows of the case, in the order of the report page."""
    yield from _beams(beam)
    yield from _bodies(beam)
    yield from _neglected(beam)
    first = BeamTheories.at_rest(1)
    yield limit(first, "frequency of Euler's beam as d_o/L goes to 0", "ω",
                points=partial(_euler_limit, beam), exponent=2)  # fmt: skip
    limit_check = FormulasLimit(name="frequency of Timoshenko's beam as d_o/L goes to 0",
                         symbol="ω", unit="1", points=lambda _: _timoshenko_limit(beam),
                         exponent=4)  # fmt: skip
    yield Comparison(check=limit_check, quantity=first)
    yield from _orders(beam)
    stated: dict[str, Any] = {"symbol": "ω", "unit": "rad/s", "source": SUBJECT}
    within = Agreement(name="frequencies of modes 1 to 3 at rest: Timoshenko's beam is within "
                            "0.2 % of the elastic body",
                       pair=partial(_within_ceiling, beam), accepted=CEILING,
                       **stated)  # fmt: skip
    yield Comparison(check=within, quantity=first)
    fine = Agreement(name="frequency of mode 1 at rest for d_o/L = 0.03: 32 elements of "
                          "Timoshenko's beam are within 1e-5 of the exact value",
                     pair=partial(_fine, beam), accepted=FINE, **stated)  # fmt: skip
    yield Comparison(check=fine, quantity=first, shares=BEAM)
    sense = Accepted(name="rotation increases the forward and decreases the backward whirl "
                          "frequencies",
                     symbol="ω", unit="1", margin=_sense)  # fmt: skip
    yield sense


def _theories(beam: BeamTheories) -> tuple[State, ...]:
    """States of Euler's, Rayleigh's and Timoshenko's theory."""
    return (State(beam.euler, "euler", "Euler", "{}E"),
            State(beam.rayleigh, "rayleigh", "Rayleigh", "{}R"),
            State(beam, "", "Timoshenko"))  # fmt: skip


def _elasticity(beam: BeamTheories) -> State:
    return State(beam.exact, "elasticity", "elastic body", "{}'")


def _beams(beam: BeamTheories) -> Iterator[Comparison]:
    """Rows of beam elements and weak forms against closed forms of the same theory."""
    modes = ((1, "forward"), (1, "backward"), (3, "forward"))
    for theory, state in zip(THEORIES, _theories(beam), strict=True):
        short = theory == "timoshenko"
        for q, words in _named(modes):
            third = short and q == BeamTheories.whirl(3, "forward")
            yield _whirl(
                q, f"beam_{theory}_{q.name}", f"elements of {state.words}'s beam: {words}",
                order=2 if short else 4, state=state, demand=2e-3 if third else 1e-3,
            )  # fmt: skip
    euler, rayleigh, timoshenko = zip(THEORIES, _theories(beam), strict=True)
    for (theory, state), j, sense in ((euler, 3, "forward"), (rayleigh, 1, "backward"),
                                    (timoshenko, 1, "forward"),
                                    (timoshenko, 3, "forward")):  # fmt: skip
        q = BeamTheories.whirl(j, sense)
        yield _whirl(q, f"weak_{theory}_{q.name}",
                     f"weak form of {state.words}'s beam: whirl frequency of mode {j} {sense}",
                     order=4, state=state, by="weak form")  # fmt: skip


def _bodies(beam: BeamTheories) -> Iterator[Comparison]:
    """Rows of the body against exact elasticity; splitting of mode 1 by beam and by body."""
    shaft, exact = BeamTheories, _elasticity(beam)
    yield _whirl(shaft.pochhammer, "solid_at_rest_1",
                 "elastic body: frequency of mode 1 at rest (Pochhammer's equation)",
                 order=4)  # fmt: skip
    modes = ((1, "forward"), (1, "backward"), (2, "forward"), (3, "forward"))
    for q, words in _named(modes):
        yield _whirl(q, f"solid_{q.name}", f"elastic body: {words}", order=4, state=exact)
    name = "gyroscopic splitting of mode 1"
    yield _whirl(shaft.split, "beam_timoshenko_split", f"{name}, beam elements", order=2,
                 state=_theories(beam)[-1])  # fmt: skip
    yield _whirl(shaft.split, "solid_split", f"{name}, elastic body", order=4, state=exact)


def _neglected(beam: BeamTheories) -> Iterator[Comparison]:
    """Rows of beams at rest against the body, with the error predicted by Timoshenko's equation."""
    fine: dict[str, Any] = {"symbol": "ω", "order": 4}
    shape = {name: getattr(beam, name) for name in ("L", "d_o", "d_i", "E", "nu", "rho")}
    for j in MODES:
        error = bounds.frequency(j, **shape) / beam.exact.at_rest(j) - 1
        yield approximation(BeamTheories.at_rest(j), f"solid_at_rest_{j}",
                            expected=about(error, NEAR, SOLVED),
                            name=f"frequency of Timoshenko's beam at rest, mode {j}",
                            sensitivity=(1e-3, FOUR), **fine)  # fmt: skip
    for theory, state in zip(THEORIES[:2], _theories(beam), strict=False):
        interval = bounds.neglected(theory, beam.rotary, beam.shear)  # type: ignore[arg-type]
        expected = Expected(*interval, SERIES) if interval else underived(SERIES)
        yield approximation(BeamTheories.at_rest(1), "solid_at_rest_1", expected=expected,
                            name=f"frequency of {state.words}'s beam at rest, mode 1", state=state,
                            **fine)  # fmt: skip


def _orders(beam: BeamTheories) -> Iterator[Comparison]:
    """Rows of the convergence order of each kind of elements in mode 1 forward."""
    euler, rayleigh, timoshenko = _theories(beam)
    for words, model, state, order, demand in (
        ("Euler's elements", "beam_euler", euler, 4, DEMAND),
        ("Rayleigh's elements", "beam_rayleigh", rayleigh, 4, DEMAND),
        ("Timoshenko's elements", "beam_timoshenko", timoshenko, 2, 0.1),
        ("Timoshenko's beam in weak form", "weak_timoshenko", timoshenko, 4, DEMAND),
        ("the elastic body", "solid", _elasticity(beam), 4, 0.03),
    ):
        check = Order(name=f"convergence order of {words}", symbol="p", unit="1", order=order,
                      errors=_errors(f"{model}_whirl_1_forward", state), demand=demand,
                      demand_reason=NEIGHBOURS if demand > DEMAND else "")  # fmt: skip
        yield Comparison(check=check, quantity=BeamTheories.whirl(1, "forward"), state=state)


def _euler_limit(beam: BeamTheories, levels: Any) -> Points:
    """Error of Euler's beam at rest against the elastic body, for increasing slenderness.

    The uncertainty includes the change on the last refinement of the mesh, and the neglected
    terms, (pi/2 d/L)^2 of the error.
    """
    runs = np.array([r.arrays["limit"] for r in levels])
    formula = [beam.shaft(L=beam.d_o / x).whirl(1, theory="euler")[0] for x in RATIOS]
    d = formula / runs[-1] - 1
    u = np.abs(runs[-1] / runs[-2] - 1) + np.abs(d) * (np.pi / 2 * np.array(RATIOS)) ** 2
    return list(RATIOS), d.tolist(), u.tolist()


def _timoshenko_limit(beam: BeamTheories) -> Points:
    """Error of Timoshenko's beam at rest against the elastic cylinder, over d/L."""
    d = []
    for x in TOWARDS:
        exact = beam.cylinder().whirl(np.pi * x / beam.d_o)[0][0]
        d.append(beam.shaft(L=beam.d_o / x).whirl(1, theory="timoshenko")[0] / exact - 1)
    u = DIGITS + np.abs(d) * (np.pi / 2 * np.array(TOWARDS)) ** 2
    return list(TOWARDS), d, u.tolist()


def _within_ceiling(beam: BeamTheories, context: Context) -> Pair:
    """Frequencies of Timoshenko's beam and the body, for the mode (1 to 3) that differs most."""
    runs = [context.series(f"solid_at_rest_{j}")[1] for j in MODES]
    beams, bodies = (np.array(v) for v in ([beam.at_rest(j) for j in MODES],
                                           [v[-1] for v in runs]))  # fmt: skip
    found = farthest(beams, bodies, max(abs(v[-1] / v[-2] - 1) for v in runs))
    return replace(found, words=", ".join(f"{x:+.4%}" for x in beams / bodies - 1))


def _fine(beam: BeamTheories, context: Context) -> Pair:
    """Frequencies of the exact beam and of the finest mesh, 32 elements, at d/L = 0.03."""
    v, exact = context.series("beam_slender")[1][-1], beam.slender.at_rest(1)
    return Pair(exact, v, 1e-9 * abs(v), f"{v / exact - 1:.1e}")


@dataclass(frozen=True, kw_only=True)
class FormulasLimit(Limit):
    """A limit in which a formula is compared with another formula, without finite elements."""

    @property
    def needs_fem(self) -> bool:
        return False


def _whirl(
    q: Quantity, reference: str, name: str, *, order: float, demand: float = 1e-3, **more: Any
) -> Comparison:
    """Row of a frequency or a critical speed of elements against the exact value."""
    symbol = "Ω_c" if q == BeamTheories.critical else "ω"
    shares = BEAM if "timoshenko" in reference else ""
    return identity(q, reference, name=name, symbol=symbol, unit="rad/s", order=order,
                    sensitivity=(demand, FOUR if order == 4 else TWO), shares=shares,
                    **more)  # fmt: skip


def _named(modes: tuple[tuple[int, str], ...]) -> Iterator[tuple[Quantity, str]]:
    """Quantities of the frequencies and the critical speed, with their names in rows."""
    yield from (
        (BeamTheories.whirl(j, sense), f"whirl frequency of mode {j} {sense}") for j, sense in modes
    )
    yield BeamTheories.critical, "first critical speed"


def _errors(key: str, state: State) -> Callable[[Context], tuple[list[float], list[float]]]:
    """Signed errors of mode 1 forward against the exact value of its theory, for each level."""

    def found(context: Context) -> tuple[list[float], list[float]]:
        h, v = context.series(key)
        beam: Any = state.case
        exact = beam.whirl(1, "forward")
        return h, [value / exact - 1 for value in v]

    return found


def _sense(context: Context) -> tuple[float, float, str]:
    """Smallest ratio of splitting to forward frequency, mode 1; -1 if senses of whirl are wrong."""
    v = context.fem[-1].values
    share = [v[f"{name}_split"] / v[f"{name}_whirl_1_forward"]
             for name in ("beam_timoshenko", "weak_timoshenko", "solid")]  # fmt: skip
    named = v["beam_sense"] == 2  # the faster of the pair is +1, the slower -1
    words = (
        "the forward and the backward frequency of mode 1 differ by at least "
        f"{min(share):.2%} of the forward frequency"
    )
    return min(share) if named else -1.0, 1e-9, words
