"""Comparisons of partial slip: half-planes against discs, tractions, energies, number of steps."""

import math
from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any

from analytic.bounds.contact import slip
from verify.cases.contact.slip.inputs import SlipInputs
from verify.core.case import Context, Values
from verify.core.results import Kind, Row
from verify.judging.checks import Approximation, Identity
from verify.judging.claims import FemClaim
from verify.judging.profile_checks import l2_error
from verify.judging.tolerance_checks import Pair

HALF_PLANES = 2e-4  # largest error for which half planes count as equal to discs
AGREE = 1e-3  # tolerance between two methods for the energy
L2 = 0.03  # acceptance of tractions


def neglected(q: SlipInputs) -> float:
    """Bound of the relative error of formulas that replace discs by half-planes."""
    return slip.neglected(a=q.width, R=q.R)


@dataclass(frozen=True, kw_only=True)
class HalfPlanes(FemClaim):
    """Comparison of half-planes with discs.

    It is an identity if the error of half-planes is below HALF_PLANES, else an approximation.
    """

    kind = Kind.IDENTITY

    analytic: str

    def rows(self, context: Context) -> list[Row]:
        stated = {f.name: getattr(self, f.name) for f in fields(self)}
        if neglected(context.inputs) <= HALF_PLANES:
            return Identity(**stated).rows(context)
        demand = self.demanded(context)

        def interval(q: SlipInputs, _values: Values) -> tuple[float, float] | None:
            bound = neglected(q) + demand / 2  # the least slack of wide contacts
            return (-bound, bound) if neglected(q) <= demand / 4 else None

        source = f"derived: ± ({slip.MODEL:g} (a/R)² + half of the required sensitivity)"
        return Approximation(**stated, interval=interval, source=source).rows(context)


def l2_margin(
    name: str, formula: Callable[[Any, float], Any], at: float, scale_at: float
) -> Callable[[Context], tuple[float, float]]:
    """Function that returns a positive margin if the L2 error of the array `name` is below `L2`.

    The error is the difference between the array and the values of `formula` with the argument
    `at`. It is relative to the norm of the values with the argument `scale_at`.
    """

    def margin(context: Context) -> tuple[float, float]:
        x, found, weight = context.fem[-1].arrays[f"points, {name}"]
        error, norm = found - formula(x, at), formula(x, scale_at)
        return L2 - l2_error(error, norm, weight), 0.0

    return margin


def two_ways(context: Context) -> Pair:
    """Pair: area of the loop of force over displacement, and work of friction [J/m]."""
    area, work = (context.series(key)[1][-1] for key in ("area", "work"))
    u = context.fem[-1].u_it["area_by_steps"]
    return Pair(area, work, 2 * u, f"relative difference {area / work - 1:+.2g}")


def step_order_fem(context: Context) -> tuple[float, float]:
    """Order of convergence of the loop's area with the number of steps, minus 1.8; its uncertainty.

    The area is computed with straight lines between steps. The difference between work and the
    area by Simpson's rule is mesh scatter and counts as uncertainty.
    """
    from fem.contact.partial_slip import order_in_steps

    result = context.fem[-1]
    x, Q = result.arrays["loop, x"], result.arrays["loop, Q"]
    work, area = result.values["work"], result.values["area"]
    order, fine = order_in_steps(x, Q, work)
    return order - 1.8, float(2 * abs(area - work) / fine / math.log(2))
