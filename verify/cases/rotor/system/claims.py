"""What transfer matrices and beams say of one rotor, side by side."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from verify.cases.rotor.system.companion import JUDGED, NAMED
from verify.cases.rotor.system.model import CRITICALS, FREQUENCIES
from verify.core.case import Context
from verify.core.results import Row
from verify.judging.checks import Fact, Identity, Order
from verify.judging.claims import Claim
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, farthest

SHARP = "both sides solve the same beam: only the elements' size lies between them"
COARSE, FINE = 2e-4, 5e-6
FINER = 8
SPOKEN = {
    **{f"critical {g}.{k}": f"critical speed {k}, the {shaft} shaft's unbalance"
       for g, shaft in ((1, "outer"), (2, "inner")) for k in (1, 2)},
    "support load": "load of the first support", "link load": "load of the link",
}  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Present(Identity):
    """An identity of rotors that have the quantity: a critical speed, a link, an unbalance."""

    def rows(self, context: Context) -> list[Row]:
        return super().rows(context) if self.analytic in context.analytic else []


def identity(key: str, name: str, symbol: str, unit: str, demand: float = 1e-5) -> Present:
    return Present(
        name=name, symbol=symbol, unit=unit, fem=key, analytic=key, formal=2, demand=demand,
        demand_reason=SHARP,
    )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Companion(Present):
    """An identity of the companion, which is judged beside the default rotor alone."""

    paper_only = True


def companion_claims() -> list[Claim]:
    """Every judged value of the companion."""
    found: list[Claim] = []
    for key in JUDGED:
        what, _, number = key.partition(" ")
        symbol, unit = {"frequency": (f"f_{number}", "Hz"), "critical": ("n_c", "r/min"),
                        "amplitude": ("|r|", "µm")}.get(what, ("F", "N"))  # fmt: skip
        found.append(
            Companion(
                name=f"companion with unlike bearings: {SPOKEN.get(key, key)}", symbol=symbol,
                unit=unit, fem=f"{NAMED} {key}", analytic=f"{NAMED} {key}", formal=2,
                demand=1e-5 if what in ("frequency", "critical") else 1e-4, demand_reason=SHARP,
            )
        )  # fmt: skip
    return found


def frequency_keys(context: Context) -> list[str]:
    """Undamped frequencies and critical speeds that both sides have."""
    return [k for k in context.analytic if k.startswith(("frequency", "critical"))]


def accepted(name: str, level: int, figure: float) -> Agreement:
    """Of all frequencies and critical speeds on a level the one that is farthest off."""

    def pair(context: Context) -> Pair:
        keys = frequency_keys(context)
        v = context.fem[level].values
        exact = np.array([context.analytic[k] for k in keys])
        found = farthest(exact, np.array([v[k] for k in keys]), 0.0)
        off = abs(found.value / found.reference - 1)
        return replace(found, words=f"at most {off:.1e} apart, {figure:.0e} accepted")

    return Agreement(name=name, symbol="ω", unit="rad/s", pair=pair, accepted=figure,
                     source=SUBJECT)  # fmt: skip


def senses(context: Context) -> tuple[float, float]:
    """Positive where both sides name the whirl of each mode alike."""
    keys = [k for k in context.analytic if k.startswith("whirl")]
    alike = all(context.fem[-1].values[k] == context.analytic[k] for k in keys)
    return (1.0 if alike else -1.0), 0.0


def slender_errors(context: Context) -> tuple[list[float], list[float]]:
    """Relative errors of the highest frequency by Euler's theory, per level."""
    key = f"euler {FREQUENCIES}"
    h, v = context.series(key)
    return h, [abs(value / context.analytic[key] - 1) for value in v]


def _criticals() -> list[Claim]:
    which = {1: "the first shaft's unbalance", 2: "unbalance of another speed"}
    return [
        identity(f"critical {g}.{k}", f"critical speed {k}, {what}", "n_c", "r/min")
        for g, what in which.items()
        for k in range(1, CRITICALS + 1)
    ]


CHECKS: tuple[Any, ...] = (
    *(
        identity(f"frequency {k}", f"natural frequency {k} at the speed", f"f_{k}", "Hz")
        for k in range(1, FREQUENCIES + 1)
    ),
    Fact(name="sense of each whirl", symbol="", unit="1", margin=senses),
    *_criticals(),
    identity("torsion", "torsional frequency", "f_t", "Hz"),
    identity("amplitude", "amplitude at the probe", "|r|", "µm", 1e-4),
    identity("support load", "load of the first support", "F", "N", 1e-4),
    identity("link load", "load of the first link", "F", "N", 1e-4),
    *companion_claims(),
    accepted("frequencies with an element a segment", 0, COARSE),
    accepted(f"frequencies with {FINER} elements a segment", -1, FINE),
    Order(
        name="order of a frequency by Euler's theory", symbol="p", unit="1",
        errors=slender_errors, order=4, demand=0.05,
        demand_reason="the coarsest level still has terms of higher order",
    ),
)  # fmt: skip
