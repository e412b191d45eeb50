"""Common to spring cases: ratios as indices, and limits for slender strips."""

from verify.cases.spring.inputs import SpringInputs

MOST_SLENDER = 16_000  # unfolded length over thickness


class Share(float):
    """A ratio as an index of quantities."""

    def __str__(self) -> str:
        return f"{self:g}".replace(".", "_")


def too_slender(q: SpringInputs) -> str:
    """Elements of a frame this slender bend by less than the round-off of its movement."""
    slender = q.n * (q.leaf + 2 * q.R * q.alpha) / q.b
    if slender <= MOST_SLENDER:
        return ""
    return (
        f"n = {q.n} segments unfold to {slender:,.0f} times the thickness, more than "
        f"{MOST_SLENDER:,}: finite elements lose too many digits there, check it without --fem"
    )
