"""Acceptance figures of finite line contacts: judged at the paper's numbers, told at one's own."""

from dataclasses import dataclass, replace

from verify.cases.contact.roller.formulas import apart
from verify.core.case import Context
from verify.core.results import Row, Status
from verify.judging.checks import Approximation, Margin

SHARE = 0.04  # of the load that slices may put elsewhere
ENDS = 0.06  # of loads near the ends
LEAST = 1e-3  # of load, or load times length: less near the ends or about the middle is none


@dataclass(frozen=True, kw_only=True)
class Estimated(Approximation):
    """A model beside the half-space; at one's own numbers convergence counts where the model does.

    Where nothing says beforehand how far the two may be apart, what the half-space leaves open is
    told with the difference, and is no failure.
    """

    def rows(self, context: Context) -> list[Row]:
        rows = super().rows(context)
        judged = self.interval and self.interval(context.inputs, context.analytic)
        if context.is_paper or judged:
            return rows
        return [
            replace(row, status=Status.SHOWN, reason=f"cannot be judged: {row.reason}")
            if row.status is Status.FAIL
            else row
            for row in rows
        ]


def elsewhere(model: str) -> Margin:
    """The share of the load that a model puts elsewhere than the half-space."""

    def margin(context: Context) -> tuple[float, float, str]:
        share, U, error = apart(context, model)
        return SHARE - share, U, f"{share:.1%} elsewhere; line load off by {error:.1%} in L2"

    return margin


def nearer(context: Context) -> tuple[float, float, str]:
    """How much less of the load slices put elsewhere than uncoupled ones do."""
    coupled, U, _ = apart(context, "slices")
    alone, U_alone, _ = apart(context, "lamina")
    return alone - coupled, U + U_alone, f"{coupled:.1%} against {alone:.1%} elsewhere"


def within(key: str, bound: float, scale: str) -> Margin:
    """The strips' error in `key`, over itself or, where it is next to nothing, over `scale`."""

    def margin(context: Context) -> tuple[float, float, str]:
        v, strips = context.series(key)[1], context.analytic[f"strips {key}"]
        size = max(abs(v[-1]), LEAST * context.analytic[scale])
        error = (strips - v[-1]) / size
        return bound - abs(error), 3 * abs(v[-1] - v[-2]) / size, f"strips {error:+.2%}"

    return margin


ends = within("ends", ENDS, "F")
