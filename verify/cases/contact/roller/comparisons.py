"""Comparisons common to all rollers: strips and slices against the half-space."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields, replace
from functools import partial
from typing import Any, Unpack

from analytic.bounds.contact import roller
from analytic.bounds.contact.line import OnFlat
from analytic.contact.roller_parts import load_elsewhere
from verify.case import (
    Comparison,
    Computed,
    Expected,
    Quantity,
    State,
    approximation,
    balance,
    underived,
)
from verify.cases.contact.expected import expected
from verify.cases.contact.roller.formulas import SlicedRoller, StripRoller
from verify.core.case import Context
from verify.form.comparisons import Options, key_of
from verify.judging.checks import Accepted, Margin
from verify.judging.profile_checks import Estimated
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, demanded

HALF_SPACE = "half-space"
SHARED = "half-spaces with the modulus E*"
ACCEPTED = "accepted error of models of a line contact of finite length"
ESTIMATE = (
    "derived: 0.5 to 2 times the estimated effect of the terms that strips neglect, ± "
    "(first-order discretisation error of the strips + 1e-4, or + 1e-3 for user inputs)"
)
PALMGREN = underived("Palmgren's law was fitted to measured approaches: no error can be derived")
SHARPEST = 3e-3  # acceptance of the strips
SHARE = 0.04  # acceptance of the load share that slices misplace
ENDS = 0.06  # acceptance of loads near the ends
LEAST = 1e-3  # of load, or load times length: less near the ends or about the middle counts as zero
SLICED = 0.02  # acceptance of the slicing technique's pressures

Interval = roller.Interval | None


def of_strips(q: StripRoller, key: str, *, own: bool) -> Interval:
    """Interval of the error of strips against the half-space, derived from strips alone."""
    return roller.of_strips(
        q.neglected[key], value=getattr(q.strips, key), twice=getattr(q.twice, key), b=q.b,
        length=q.L, loaded=q.loaded_ends > 0, user_inputs=own,
    )  # fmt: skip


def of_disc(q: StripRoller, key: str) -> Interval:
    """Interval of the error of Hertz's theory for a disc; None if it is too wide."""
    found = expected(getattr(OnFlat(q.b_mid / q.R), key), "")
    return (found.low, found.high) if found.sharp else None


def estimated(
    q: Quantity, reference: str = "", *, expected: Expected | Computed | None,
    **options: Unpack[Options],
) -> Comparison:  # fmt: skip
    """Row of an approximation; for user inputs it is not judged if the reference is inaccurate."""
    one = approximation(q, reference, expected=expected, **options)
    stated = {f.name: getattr(one.check, f.name) for f in fields(one.check)}  # type: ignore[arg-type]
    return replace(one, check=Estimated(**stated))


def strips_rows(q: StripRoller, *judged: Quantity) -> Iterator[Comparison]:
    """Rows: `judged` quantities of strips against the half-space."""
    for one in judged:
        interval = partial(of_strips, q, one.name, own=not q.is_default)
        yield estimated(one, expected=Computed(interval, ESTIMATE), order=1, by=HALF_SPACE,
                        sensitivity=(SHARPEST, ACCEPTED), shares=SHARED)  # fmt: skip


def sliced_rows(
    q: SlicedRoller, sliced: Sequence[Quantity], independent: Sequence[Quantity]
) -> Iterator[Comparison]:
    """Rows: coupled slices (`sliced`) and independent slices against the half-space.

    Only pressures of coupled slices are judged.
    """
    accepted = Expected(-SLICED, SLICED, ACCEPTED, sharp=q.is_default)
    for one in (*sliced, *independent):
        judged = one in sliced and one is not SlicedRoller.delta_slices
        yield estimated(
            one, expected=accepted if judged else PALMGREN, order=1, by=HALF_SPACE, shares=SHARED,
            sensitivity=(2 * SLICED, "twice the accepted error, which may have either sign"),
        )  # fmt: skip
    load: dict[str, Any] = {"symbol": "ΔF/F", "unit": "1"}
    for check in (
        Accepted(name=f"coupled slices misplace less than {SHARE:.0%} of the load, relative to the "
                 "half-space", margin=misplaced, **load),
        Accepted(name="coupled slices misplace a smaller share of the load than independent slices",
                 margin=nearer, **load),
    ):  # fmt: skip
        yield Comparison(check=check, quantity=SlicedRoller.p_max_slices, shares=SHARED)


def balanced(q: StripRoller) -> Comparison:
    """Row: the pressures on the half-space are in balance with the given load."""
    return balance("balance", "balance of forces, half-space", "ΣF", "N", of={"F": q.F},
                   bound=1e-10, because="every iteration satisfies this balance")  # fmt: skip


def loaded_ends(q: StripRoller) -> Comparison:
    """Row: the load near both ends by strips agrees with that of the half-space."""
    check = Accepted(name="load in both end zones d: strips and half-space agree within "
                     f"{ENDS:.0%}",
                     symbol="F_d", unit="1", margin=within("F_d", ENDS, q.F))  # fmt: skip
    return Comparison(check=check, quantity=StripRoller.F_d, shares=SHARED)


def end_pressure(q: StripRoller) -> Comparison:
    """Row: strips and half-space agree on Hertz's pressure of the load at the more loaded end."""
    check = Accepted(name="Hertz's pressure for the line load averaged over the more loaded end "
                     f"zone d: strips and half-space agree within {ENDS / 2:.0%}",
                     symbol="p_d", unit="1",
                     margin=within("p_d", ENDS / 2, lambda: q.p_0))  # fmt: skip
    return Comparison(check=check, quantity=StripRoller.p_d, shares=SHARED)


def agreeing(
    name: str, judged: Quantity, figure: float, scale: "Scale", source: str = SUBJECT, *,
    symbol: str = "", state: State | None = None,
) -> Comparison:  # fmt: skip
    """Row: the values of strips and half-space agree within `figure`."""
    pair = pair_of(key_of(judged, state), scale)
    check = Agreement(name=name, symbol=symbol or judged.symbol, unit=judged.unit,
                      pair=pair, accepted=figure, source=source, by=HALF_SPACE,
                      **demanded(figure))  # fmt: skip
    return Comparison(check=check, quantity=judged, state=state, shares=SHARED)


Scale = float | Callable[[], float]


def pair_of(key: str, scale: Scale) -> Callable[[Context], Pair]:
    """Function that returns the values of `key` by strips and by the half-space, as a pair.

    The error in the text of the pair is relative to the value of the half-space, or to `scale` if
    this value is nearly zero.
    """

    def pair(context: Context) -> Pair:
        v, strips = context.series(key)[1], context.analytic[key]
        error = (strips - v[-1]) / size(v[-1], scale)
        return Pair(strips, v[-1], 3 * abs(v[-1] - v[-2]), f"error of strips {error:+.2%}")

    return pair


def within(key: str, bound: float, scale: Scale) -> Margin:
    """Function that returns a positive margin if strips compute `key` with an error below `bound`.

    The error is relative to `scale` if the value of the half-space is nearly zero.
    """

    def margin(context: Context) -> tuple[float, float, str]:
        v, strips = context.series(key)[1], context.analytic[key]
        over = size(v[-1], scale)
        error = (strips - v[-1]) / over
        return bound - abs(error), 3 * abs(v[-1] - v[-2]) / over, f"error of strips {error:+.2%}"

    return margin


def size(value: float, scale: Scale) -> float:
    """Denominator of a relative error: the absolute `value`, but at least LEAST times `scale`."""
    return max(abs(value), LEAST * (scale() if callable(scale) else scale))


def misplaced(context: Context) -> tuple[float, float, str]:
    """Margin, positive if coupled slices misplace less than the accepted load fraction."""
    share, U, error = misplaced_load(context, "slices")
    return (
        SHARE - share,
        U,
        f"relative to the half-space, coupled slices misplace {share:.1%} of the load; the L2 "
        f"error of their line load is {error:.1%}",
    )


def nearer(context: Context) -> tuple[float, float, str]:
    """Load fraction that independent slices misplace, minus that of coupled slices."""
    share, U, _ = misplaced_load(context, "slices")
    alone, U_alone, _ = misplaced_load(context, "independent")
    return (
        alone - share,
        U + U_alone,
        f"relative to the half-space, coupled slices misplace {share:.1%} of the load, independent "
        f"slices {alone:.1%}",
    )


def misplaced_load(context: Context, model: str) -> tuple[float, float, float]:
    """Load fraction that `model` misplaces, its uncertainty, and the L2 error of the line load.

    The half-space is the reference for the place of the load.
    """
    q: Any = context.inputs
    line = q.sliced(model).line
    found = [load_elsewhere(line, level.arrays["q"], q.L) for level in context.fem[-2:]]
    (before, _), (share, error) = found[0], found[-1]
    return share, 3 * abs(share - before), error
