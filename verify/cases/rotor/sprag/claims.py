"""Claims about the system with sprag clutch: identities, what is fitted, what holds in shares."""

from dataclasses import replace

import numpy as np

from verify.cases.rotor.sprag.assertions import STATEMENTS, Statement
from verify.cases.rotor.sprag.check_types import COARSE, FittedTo, Rounded, Share, Told, arrays
from verify.cases.rotor.sprag.inputs import PRINTED
from verify.cases.rotor.sprag.model import MODES, ORDERS
from verify.core.case import Context
from verify.judging.checks import Accepted, Identity
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, farthest

BEAMS = 5e-6  # acceptance figure of 8 beams in each of the paper's elements
BARS = 1e-5  # the same for elements of torsion, whose twist is linear
WITHIN_PRINTED = 3e-3


def largest_error(context: Context, level: int, keys: tuple[str, ...]) -> float:
    v = context.fem[level].values
    return max(abs(v[key] / context.analytic[key] - 1) for key in keys)


FREQUENCIES = tuple(f"natural frequency {i + 1}" for i in range(MODES))


def printed_bound(context: Context) -> tuple[float, float, str]:
    """The paper's own mesh against the exact model."""
    error = largest_error(context, 0, FREQUENCIES)
    return WITHIN_PRINTED - error, 0.0, f"20 elements err by {error:.1e} at most"


def coarse(context: Context) -> Pair:
    """The exact model and 20 elements where they are farthest apart."""
    keys = (*FREQUENCIES, *(f"forward critical {k}" for k in ORDERS))
    v = context.fem[0].values
    exact = np.array([context.analytic[key] for key in keys])
    found = farthest(exact, np.array([v[key] for key in keys]), 0.0)
    return replace(found, words=f"at most {abs(found.value / found.reference - 1):.1e}")


def identity(name: str, symbol: str, unit: str, key: str, demand: float = BEAMS) -> Identity:
    return Identity(
        name=name, symbol=symbol, unit=unit, fem=key, analytic=key, formal=2, demand=demand,
        demand_reason="acceptance figure of beams against transfer matrices, 8 in each element",
    )  # fmt: skip


def shares(statement: Statement) -> Told:
    return Told(
        name=statement.name, symbol=statement.symbol, unit="%", holds=statement.holds,
        printed=statement.printed, statement=statement,
    )  # fmt: skip


def hit(context: Context) -> float:
    speeds = arrays(context)["critical, forward"]
    return float(np.abs(speeds / np.array(PRINTED) - 1).max(initial=0.0))


IDENTITIES = (
    *(identity(f"natural frequency {i + 1}, beams", f"f_{i + 1}", "Hz", key)
      for i, key in enumerate(FREQUENCIES)),
    *(identity(f"{whirl} critical speed {k}, beams", f"n_{k}", "r/min", f"{whirl} critical {k}")
      for whirl in ("forward", "backward") for k in ORDERS),
    *(identity(f"amplitude of node {n} at the rig's speed, no damping", f"x_{n}", "µm",
               f"amplitude {n}") for n in (4, 19)),
    identity("torsional frequency of the clutch", "f_c", "Hz", "torsion, clutch"),
    identity("torsional frequency of the inner shaft", "f_t", "Hz", "torsion, shaft", BARS),
    Identity(name="coupling of bending and torsion by the offset", symbol="K_xz", unit="N",
             fem="coupling", analytic="coupling", demand=1e-9,
             demand_reason="the same sums on both sides"),
    Accepted(name="20 elements against the exact model, frequencies 1 to 6", symbol="Δf/f",
             unit="1", margin=printed_bound, fitted="on a fitted system",
             printed=("huang2022:frequency-deviation-bound", "huang2022:compared-frequencies")),
    Agreement(name="20 elements against the exact model within 2e-4", symbol="ω", unit="rad/s",
              pair=coarse, accepted=COARSE,
              source=SUBJECT),
)  # fmt: skip
FITTED_SPEEDS = (
    *(FittedTo(name=f"critical speed {k}, central system", symbol=f"n_{k}", unit="r/min",
               analytic=f"forward critical {k}", printed=(f"huang2022:critical-speed-{k}",))
      for k in ORDERS),
    Rounded(name="every set of parameters has the three printed speeds", symbol="Δn/n", unit="1",
            residual=hit, bound=1.1e-8, scale_name="printed speed",
            bound_reason="where sets are accepted, and round-off of another assembly"),
    Share(name="starts of the fit that meet all three speeds", symbol="", unit="%", of="starts",
          holds=lambda a: a["start met"] > 0),
    Share(name="starts of the fit that meet them inside the ranges", symbol="", unit="%",
          of="starts",
          holds=lambda a: a["start kept"] > 0),
)  # fmt: skip
SHARES = tuple(map(shares, STATEMENTS))
