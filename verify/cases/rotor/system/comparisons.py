"""Rows of a rotor: transfer matrices against beam elements."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from verify.case import Comparison, Quantity, State, errors_of
from verify.cases.rotor.system.companion import companion
from verify.cases.rotor.system.formulas import TransferRotor
from verify.cases.rotor.system.inputs import CRITICALS, FREQUENCIES
from verify.core.case import Check, Context
from verify.core.results import Row
from verify.judging.checks import Fact, Identity, Order
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, farthest

SHARP = "both methods solve the same equations: only the element size causes a difference"
BEAM = "Timoshenko's beam with Hutchinson's shear coefficient"
COARSE, FINE = 2e-4, 5e-6
FINER = 8
LOADS = 1e-4  # tolerance of a load or an amplitude
rotor = TransferRotor


@dataclass(frozen=True, kw_only=True)
class Present(Identity):
    """A row that exists only if the rotor has the compared critical speed, link or unbalance."""

    def rows(self, context: Context) -> list[Row]:
        return super().rows(context) if self.analytic in context.analytic else []


@dataclass(frozen=True, kw_only=True)
class Companion(Present):
    """A row on the second test rotor; it exists only if the inputs are the default rotor."""

    paper_only: bool = True


def rows(q: TransferRotor) -> Iterator[Comparison | Check]:
    """All rows of a rotor, in the order of the report page."""
    for k in range(1, FREQUENCIES + 1):
        yield _identical(rotor.frequency(k))
    yield Fact(name="sense of whirl of each mode", symbol="", unit="1", margin=_senses)
    for criticals in (rotor.critical_first, rotor.critical_other):
        for k in range(1, CRITICALS + 1):
            yield _identical(criticals(k), symbol="n_c")
    yield _identical(rotor.torsion, name="lowest torsional frequency")
    yield _identical(rotor.amplitude, name="amplitude of the probe node", demand=LOADS)
    for one, words in ((rotor.support_load, "bearing to the ground"),
                       (rotor.link_load, "bearing between shafts")):  # fmt: skip
        yield _identical(one, name=f"load of the first {words}", symbol="F", demand=LOADS)
    if q.is_default:
        yield from _of_companion()
    for name, level, figure in (
        ("frequency or critical speed with the largest error, one element per segment", 0, COARSE),
        (
            f"frequency or critical speed with the largest error, {FINER} elements per segment",
            -1,
            FINE,
        ),
    ):
        yield _accepted(q, name, level, figure)
    last = rotor.euler(FREQUENCIES)
    order = Order(name="Euler's theory: convergence order of the highest compared frequency",
                  symbol="p", unit="1", errors=errors_of(last), order=4, demand=0.05,
                  demand_reason="terms of higher order affect the error of the coarsest "
                                "mesh")  # fmt: skip
    yield Comparison(check=order, quantity=last)


def _identical(
    q: Quantity, state: State | None = None, *, name: str = "", symbol: str = "",
    demand: float = 1e-5,
) -> Comparison:  # fmt: skip
    key = f"{q.name}_{state.key}" if state else q.name
    kind = Companion if state else Present
    check = kind(name=name or q.what, symbol=symbol or q.symbol, unit=q.unit, fem=key,
                 analytic=key, formal=2, demand=demand, demand_reason=SHARP)  # fmt: skip
    return Comparison(check=check, quantity=q, state=state, shares=BEAM)


def _of_companion() -> Iterator[Comparison]:
    """Rows of all judged values of the second test rotor."""
    built = State(
        companion(TransferRotor),
        "companion",
        "second test rotor (anisotropic bearings)",
        displayed=False,
    )
    for k in (1, 2, 3, 4):
        yield _identical(rotor.frequency(k), built, name=f"{built.words}: natural frequency {k}")
    for criticals, shaft in ((rotor.critical_first, "outer"), (rotor.critical_other, "inner")):
        for k in (1, 2):
            words = (
                f"{built.words}: critical speed {k} excited by the unbalance of the {shaft} shaft"
            )
            yield _identical(criticals(k), built, name=words, symbol="n_c")
    for one, words in ((rotor.amplitude, "amplitude of the probe node"),
                       (rotor.support_load, "load of the first bearing to the ground"),
                       (rotor.link_load, "load of the bearing between shafts")):  # fmt: skip
        symbol = "F" if one is not rotor.amplitude else ""
        yield _identical(one, built, name=f"{built.words}: {words}", symbol=symbol, demand=LOADS)


def _accepted(q: TransferRotor, name: str, level: int, figure: float) -> Comparison:
    """Row of the frequency or critical speed with the largest error on a level."""

    def pair(context: Context) -> Pair:
        exact, v = q.undamped, context.fem[level].values
        found = farthest(np.array(list(exact.values())), np.array([v[key] for key in exact]), 0.0)
        off = abs(found.value / found.reference - 1)
        return replace(
            found,
            words=f"largest error of frequencies and critical speeds {off:.1e}, accepted "
            f"{figure:.0e}",
        )

    check = Agreement(name=name, symbol="ω", unit="rad/s", pair=pair, accepted=figure,
                      source=SUBJECT)  # fmt: skip
    return Comparison(check=check, quantity=rotor.frequency(1), shares=BEAM)


def _senses(context: Context) -> tuple[float, float]:
    """Positive margin if transfer matrices and beams give the same sense of whirl for each mode."""
    v = context.fem[-1].values
    keys = [k for k in context.analytic if k.startswith("sense_")]
    equal = all(v[k] == context.analytic[k] for k in keys)
    return (1.0 if equal else -1.0), 0.0
