"""Ratios in names of quantities, and limit of slenderness, for all cases of springs."""

from verify.cases.spring.inputs import SpringInputs

MOST_SLENDER = 16_000  # unfolded length over thickness


class Share(float):
    """Ratio whose text can be part of the name of a quantity: 0.3 as 0_3."""

    def __str__(self) -> str:
        return f"{self:g}".replace(".", "_")


def too_slender(q: SpringInputs) -> str:
    """Reason why the strip is too slender for finite elements; empty if it is not.

    The bending of an element of a very slender frame is less than the round-off error of its
    displacement.
    """
    slender = q.n * (q.leaf + 2 * q.R * q.alpha) / q.b
    if slender <= MOST_SLENDER:
        return ""
    return (
        f"the unfolded length of n = {q.n} segments is {slender:,.0f} times the thickness, above "
        f"the limit of {MOST_SLENDER:,} by round-off errors of finite elements, check it without "
        "--fem"
    )
