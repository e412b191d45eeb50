"""Rows of a crown: its profile, its pressures, and statements of the paper on its crowns."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.contact.crown_mean import z_m_share
from verify.case import Comparison, State, identity
from verify.cases.sprag.clutch.drawn_fem import crowned
from verify.cases.sprag.crown.formulas import DEEP, factorial, label, unit
from verify.cases.sprag.crown.measured_figures import (
    first_and_trough,
    grows_with_torque,
    highest_and_lowest,
    in_other_order,
    lowest_at_10,
    more_even,
    not_lowest_at_30,
    order_at,
)
from verify.cases.sprag.crown.slices import hardly_by_slices
from verify.cases.sprag.crown.table2 import TABLE_2
from verify.cases.sprag.inputs import EngagementInputs
from verify.cases.sprag.peaks import with_crown
from verify.cases.sprag.statements import (
    BY_STRIPS,
    FITTED,
    PLACE,
    SLICED,
    STRIPS,
    WIDER,
    Noted,
    OfPaper,
)
from verify.core.case import Check, Context
from verify.core.figures import Array
from verify.core.results import Row
from verify.form.comparisons import key_of
from verify.judging.checks import Accepted, Fact
from verify.judging.profile_checks import Estimated

DRAWN = "numerical profile"
BOTH = "strips, at the force of computed engagements"
UNEQUAL = (
    "half of the errors of N by two assumptions, N_e = N_i (Eqs. 14-16) and massless sprags, "
    "because p is proportional to √N"
)
HERTZ = "line contacts, radius of the inner contact"
MEAN_OF = 4000  # places of a profile
EQUAL = 1e-9
MOST = 0.5  # per cent above which z_m would have a larger effect than K_1


def near(q: Any, _values: Any) -> tuple[float, float] | None:
    """Interval of the relative error of pressures (proportional to √N); None for user inputs.

    The interval includes the differences between slices and strips, and between a model of two
    races on a spring and the equations of motion with all sprags. No tolerance is stated for a
    user's inputs.
    """
    if not q.is_default:
        return None
    low, high = (-q.unequal - q.inertia) / 2, q.inertia / 2
    return low - SLICED - STRIPS, high + SLICED + STRIPS


@dataclass(frozen=True, kw_only=True)
class OfPaperEstimated(Estimated):
    """Estimated row that exists only for the clutch of the paper."""

    paper_only: bool = True

    def rows(self, context: Context) -> list[Row]:
        return super().rows(context) if context.is_paper else []


def drops(q: EngagementInputs, crowns: Array) -> Array:
    """Drops [m] of the crowns (n, 3) at MEAN_OF positions, shape (n, MEAN_OF)."""
    return np.array([crowned(with_crown(q, crown), MEAN_OF) for crown in crowns])


def straight_and_ends(context: Context) -> tuple[float, float]:
    """Smallest of three margins on the drops of the crowns of Eq. 19, and its uncertainty.

    1. The straight length differs from (1 - K_2) l by less than 2.5 l/MEAN_OF.
    2. The drop does not exceed z_m.
    3. The drop does not decrease if K_1, K_2 or z_m increases.
    """
    q = context.inputs
    crowns = factorial(q, 5)
    z = drops(q, crowns)
    off = np.abs((z == 0).mean(axis=1) - (1 - crowns[:, 1])).max()
    cube = z.reshape(5, 5, 5, MEAN_OF)
    deeper = min(float(np.diff(cube, axis=k).min()) for k in (0, 1, 2)) / float(z.max())
    below = float((1 - z.max(axis=1) / crowns[:, 2]).min())
    return min(2.5 / MEAN_OF - float(off), below, deeper + EQUAL), 0.0


def z_m_is_not_the_mean(context: Context) -> tuple[float, float, str]:
    """Amount [%] by which the effect of 1 % more z_m on the mean drop is below 0.5 %."""
    q = context.inputs
    printed = {c: z_m_share(c[0] * unit(q), c[2]) for c in ((1.0, 0.7, 1e-5), *DEEP)}
    box = np.array([z_m_share(x[0] * unit(q), x[2]) for x in factorial(q, 5)])
    most = max(printed, key=lambda c: printed[c])
    words = (
        f"with 1 % more z_m, the mean drop increases by {printed[most]:.2f} % for crown "
        f"{label(most)}, the largest increase of the compared printed crowns, and by "
        f"{printed[(1.0, 0.7, 1e-5)]:.3f} % for crown (1, 0.7, 10 µm); the increase with 1 % more "
        "K_1 is 1 % minus the increase with 1 % more z_m; z_m has a larger effect than K_1 for "
        f"{int((box > MOST).sum())} of {len(box)} crowns of Eq. 19"
    )
    return MOST - printed[most], 0.0, words


def inner_above(context: Context) -> tuple[float, float]:
    """Ratio of p_max of the inner to that of the outer contact, minus 1; smallest of all crowns."""
    return float(context.fem[-1].arrays["inner/outer"].min()) - 1, 1e-6


def in_the_box(context: Context) -> tuple[float, float, str]:
    """Relative reduction of p_max from the given crown to the optimal crown of Eq. 19.

    The uncertainty and the text of the row are also returned.
    """
    q, found = context.inputs, context.fem[-1].arrays
    k = int(found["box p"].argmin())
    p, given = float(found["box p"][k]), q.p_peak
    off = float(np.abs(found["by contacts"] / found["engaged p"] - 1).max())
    words = (
        f"crown {label(tuple(found['box'][k]))} has p_max = {p / 1e6:.0f} MPa, "
        f"{p / given - 1:+.1%} relative to {given / 1e6:.0f} MPa of the given crown; the highest "
        f"p_max of {len(found['box p'])} crowns is {found['box p'].max() / 1e6:.0f} MPa"
    )
    return 1 - p / given, off + 0.01, words


def stated(crown: Any) -> Iterator[Comparison | Check]:
    """Rows on the profile, the pressures, and the paper's figures and Table 2."""
    c = type(crown)
    drawn: dict[str, Any] = {"order": 1, "by": DRAWN}
    yield identity(c.mean, name="mean drop of the crown", symbol="z̄", **drawn)
    yield identity(c.share, name="ratio of the relative change of the mean drop to that of z_m",
                   **drawn)  # fmt: skip
    estimate: dict[str, Any] = {
        "unit": "MPa", "interval": near, "source": f"{PLACE}; {UNEQUAL}", "demand": WIDER,
        "demand_reason": "about twice the sum of the accepted errors of slices (2 %) and of strips "
        "(0.3 %)",
    }  # fmt: skip
    check = Estimated(name="pressure at mid-length at the first force peak",
                      symbol="p_mid", analytic="p_mid_peak", fem="p_mid_peak", by=BOTH,
                      **estimate)  # fmt: skip
    yield Comparison(check=check, quantity=c.p_mid_peak, shares=HERTZ)
    for k, other in enumerate(DEEP):
        state = State(None, f"deep_{k}", f"of crown {label(other)}")
        key = key_of(c.p_peak, state)
        largest = OfPaperEstimated(
            name=f"largest pressure of crown {label(other)} at the first force peak",
            symbol="p_max", analytic=key, fem=key, by=BY_STRIPS, **estimate,
        )  # fmt: skip
        numbers = {key: crown.peak_of(other)} if crown.is_default else {}
        yield Comparison(check=largest, quantity=c.p_peak, state=state, numbers=numbers,
                         shares=HERTZ)  # fmt: skip
    yield from OF_FIGURES
    yield Comparison(check=LOWER, quantity=c.p_peak)
    yield from TABLE_2


OF_FIGURES: tuple[Check, ...] = (
    Fact(name="Fig. 11: straight length is (1 - K_2) l, largest drop is z_m; the drop increases "
         "with K_1, K_2 and z_m",
         symbol="z", unit="1", margin=straight_and_ends, fem_needed=False),
    Noted(name="Fig. 11: mean drop depends more on K_1 than on z_m", symbol="e_z", unit="1",
          erratum="huang2018:sec-4-1-overall-drop", margin=z_m_is_not_the_mean),
    Fact(name="pressure at the inner contact exceeds that at the outer, for all crowns of Eq. 19",
         symbol="p_i/p_o", unit="1", margin=inner_above),
    OfPaper(name="Fig. 12: under the static load, its optimal crown has the lowest p_max of all "
            "printed crowns and its worst crown the highest",
            symbol="p_max", unit="1", margin=highest_and_lowest, fitted=FITTED,
            printed=("huang2018:fig12-best-k1", "huang2018:fig12-best-k2",
                     "huang2018:fig12-best-zm", "huang2018:fig12-worst-k1",
                     "huang2018:fig12-worst-k2", "huang2018:fig12-worst-zm")),
    Noted(name="Fig. 12: largest pressure of its optimal crown exceeds that of its worst crown at "
          "the first force peak of the engagement with 25 N m", symbol="p_max",
          unit="1", erratum="huang2018:fig-12-load", margin=in_other_order),
    OfPaper(name="Fig. 13: pressure at the ends is higher than at mid-length at the first force "
            "peak, and lower at the next force minimum",
            symbol="p", unit="1", margin=first_and_trough, fitted=FITTED,
            printed=("huang2018:fig13a-k2", "huang2018:fig13a-zm")),
    OfPaper(name="Fig. 13: load along the sprag at the first force peak is more uniform with "
            "K_1 = 3 than with K_1 = 1", symbol="q", unit="1", margin=more_even, fitted=FITTED,
            printed=("huang2018:fig13b-k2", "huang2018:fig13b-zm")),
    *(
        OfPaper(name=f"Fig. 14: of its two crowns, {words} has the lower pressure at {T} N m",
                symbol="p_max", unit="1", margin=order_at(k), fitted=FITTED,
                printed=(f"huang2018:fig14-torque-{T}",
                         *(f"huang2018:fig14-{T}nm-{x}" for x in ("k1", "k2", "zm"))))
        for k, T, words in ((0, 10, "(1, 0.5, 8 µm)"), (1, 30, "(5, 0.5, 15 µm)"))
    ),
    OfPaper(name="Fig. 14: largest pressure of its crown for 10 N m is within 1 % of the lowest of "
            "all crowns of Eq. 19",
            symbol="p_max", unit="1", margin=lowest_at_10, fitted=FITTED),
    Noted(name="Fig. 14: K_1 = 5 does not give the lowest pressure at 30 N m", symbol="p_max",
          unit="1", erratum="huang2018:fig-14-k1", margin=not_lowest_at_30),
    OfPaper(name="Fig. 14: K_1 of the crown with the lowest pressure increases with the torque",
            symbol="K_1", unit="1", margin=grows_with_torque, fitted=FITTED),
    OfPaper(name="p_max of the crown of Eq. 21 changes by less than 0.5 % from 21 to 161 slices",
            symbol="p_max", unit="1", margin=hardly_by_slices, fitted=FITTED),
)  # fmt: skip
LOWER = Accepted(
    name="a crown of Eq. 19 has a lower p_max than the given crown", symbol="p_max", unit="1",
    margin=in_the_box, fitted=FITTED,
)  # fmt: skip
