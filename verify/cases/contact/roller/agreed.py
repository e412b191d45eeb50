"""Strips beside the half-space within an acceptance figure, as comparisons."""

from collections.abc import Callable

from verify.cases.contact.roller.accepted import LEAST
from verify.cases.contact.roller.case import HALF_SPACE
from verify.core.case import Context
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, demanded


def within(
    name: str, symbol: str, unit: str, key: str, figure: float, scale: str, source: str = SUBJECT
) -> Agreement:
    """The strips within `figure` of the half-space in `key`."""
    return Agreement(name=name, symbol=symbol, unit=unit, pair=of_strips(key, scale),
                     accepted=figure,
                     source=source, by=HALF_SPACE, **demanded(figure))  # fmt: skip


def of_strips(key: str, scale: str) -> Callable[[Context], Pair]:
    """Their error in words is over the half-space's or, where that is nothing, over `scale`."""

    def pair(context: Context) -> Pair:
        v, strips = context.series(key)[1], context.analytic[f"strips {key}"]
        error = (strips - v[-1]) / max(abs(v[-1]), LEAST * context.analytic[scale])
        return Pair(strips, v[-1], 3 * abs(v[-1] - v[-2]), f"strips {error:+.2%}")

    return pair
