"""A model beside the half-space whose error nothing bounds beforehand for inputs of the user."""

from dataclasses import dataclass, fields, replace
from typing import Unpack

from verify.case import Comparison, Computed, Expected, Quantity, approximation
from verify.core.case import Context
from verify.core.results import Row, Status
from verify.form.comparisons import Options
from verify.judging.checks import Approximation


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


def estimated(
    q: Quantity, reference: str = "", *, expected: Expected | Computed | None,
    **options: Unpack[Options],
) -> Comparison:  # fmt: skip
    """An approximation whose reference may stay open for inputs of the user."""
    one = approximation(q, reference, expected=expected, **options)
    stated = {f.name: getattr(one.check, f.name) for f in fields(one.check)}  # type: ignore[arg-type]
    return replace(one, check=Estimated(**stated))
