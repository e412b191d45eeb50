"""Claims about the system with sprag clutch: identities, fitted values, shares of members."""

from dataclasses import replace

import numpy as np

from verify.case import Comparison, Quantity, identity
from verify.cases.rotor.sprag.assertions import STATEMENTS, Statement
from verify.cases.rotor.sprag.check_types import COARSE, Claimed, FittedTo, Rounded, Share, arrays
from verify.cases.rotor.sprag.formulas import MODES, ORDERS, CentralSystem
from verify.cases.rotor.sprag.inputs import PRINTED
from verify.cases.rotor.sprag.layout import DISCS
from verify.core.case import Check, Context
from verify.judging.checks import Accepted
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, farthest

BEAMS = 5e-6  # accepted error of 8 beam elements in each element of the paper
BARS = 1e-5  # tolerance for torsion elements, with linear twist
WITHIN_PRINTED = 3e-3
EIGHT = "accepted error of 8 beam elements in each segment against transfer matrices"
BEAM = "Timoshenko's beam with Hutchinson's shear coefficient"
system = CentralSystem


def largest_error(context: Context, level: int, keys: tuple[str, ...]) -> float:
    v = context.fem[level].values
    return max(abs(v[key] / context.analytic[key] - 1) for key in keys)


FREQUENCIES = tuple(f"frequency_{i + 1}" for i in range(MODES))


def printed_bound(context: Context) -> tuple[float, float, str]:
    """Positive margin if the error of 20 elements is below `WITHIN_PRINTED`.

    The uncertainty and the text of the row are also returned.
    """
    error = largest_error(context, 0, FREQUENCIES)
    return WITHIN_PRINTED - error, 0.0, f"the relative error of 20 elements is at most {error:.1e}"


def coarse(context: Context) -> Pair:
    """Frequency or critical speed with the largest error, by the exact model and 20 elements."""
    keys = (*FREQUENCIES, *(f"critical_forward_{k}" for k in ORDERS))
    v = context.fem[0].values
    exact = np.array([context.analytic[key] for key in keys])
    found = farthest(exact, np.array([v[key] for key in keys]), 0.0)
    return replace(found, words=f"largest error {abs(found.value / found.reference - 1):.1e}")


def identical(
    q: Quantity, name: str, symbol: str = "", demand: float = BEAMS, reason: str = EIGHT
) -> Comparison:
    return identity(q, name=name, symbol=symbol or q.symbol, order=2, sensitivity=(demand, reason),
                    shares=BEAM)  # fmt: skip


def shares(statement: Statement) -> Claimed:
    return Claimed(
        name=statement.name, symbol=statement.symbol, unit="%",
        holds=lambda context: statement.holds(arrays(context)),
        printed=statement.printed, statement=statement,
    )  # fmt: skip


def hit(context: Context) -> float:
    speeds = arrays(context)["critical, forward"]
    return float(np.abs(speeds / np.array(PRINTED) - 1).max(initial=0.0))


IDENTITIES = (
    *(identical(system.frequency(k), f"natural frequency {k}, beam elements")
      for k in range(1, MODES + 1)),
    *(identical(critical(k), f"{whirl} critical speed {k}, beam elements", f"n_{k}")
      for whirl, critical in (("forward", system.critical_forward),
                              ("backward", system.critical_backward)) for k in ORDERS),
    *(identical(system.amplitude(n), system.amplitude(n).what) for n in DISCS),
    identical(system.torsion_clutch, "torsional frequency of the clutch"),
    identical(system.torsion_shaft, "torsional frequency of the inner shaft", demand=BARS),
    identity(system.coupling, sensitivity=(1e-9, "formula and reference compute the same sums")),
    Comparison(
        check=Accepted(
            name="largest error of natural frequencies 1 to 6 with 20 beam elements",
            symbol="Δf/f", unit="1", margin=printed_bound, fitted="computed for a fitted system",
            printed=("huang2022:frequency-deviation-bound", "huang2022:compared-frequencies"),
        ),
        quantity=system.frequency(1), shares=BEAM,
    ),
    Comparison(
        check=Agreement(name="frequency or critical speed with the largest error, 20 beam "
                             "elements", symbol="ω", unit="rad/s", pair=coarse, accepted=COARSE,
                        source=SUBJECT),
        quantity=system.critical_forward(1), shares=BEAM,
    ),
)  # fmt: skip
FITTED_SPEEDS: tuple[Comparison | Check, ...] = (
    *(Comparison(
        check=FittedTo(name=f"critical speed {k} of the system fitted from mid-range parameters",
                       symbol=f"n_{k}", unit="r/min", analytic=f"critical_forward_{k}",
                       printed=(f"huang2022:critical-speed-{k}",)),
        quantity=system.critical_forward(k),
      ) for k in ORDERS),
    Rounded(name="every set of parameters gives the three printed critical speeds",
            symbol="Δn/n", unit="1", residual=hit, bound=1.1e-8, scale_name="printed speed",
            bound_reason="tolerance of the fit, and round-off of matrices assembled twice"),
    Share(name="share of initial values of the fit that lead to all three critical speeds",
          symbol="", unit="%", of="initial values of the fit",
          holds=lambda c: arrays(c)["start met"] > 0),
    Share(name="share of initial values of the fit that lead to all three critical speeds and to "
               "parameters within their ranges",
          symbol="", unit="%", of="initial values of the fit",
          holds=lambda c: arrays(c)["start in range"] > 0),
)  # fmt: skip
SHARES: tuple[Check, ...] = tuple(map(shares, STATEMENTS))
