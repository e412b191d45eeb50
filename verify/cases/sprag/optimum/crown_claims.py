"""Claims about the contact of a crown at N_max: slices, strips and a half-space."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from analytic.sprag.crowned import mid
from verify.case import Comparison
from verify.cases.sprag.engagement.model import gap, in_slices
from verify.cases.sprag.optimum.surrogate_claims import Displayed
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
    measured,
)
from verify.core.case import Context, FemResult
from verify.core.figures import Array
from verify.core.results import Row, Status
from verify.judging import judge
from verify.judging.profile_checks import Estimated

STRIPPED, CELLS = (41, 81, 161), (384, 512, 768)  # number of strips and cells along a sprag
HALF_SPACE = "half-space"
EDGE = 1e-4  # relative effect on a pressure of the position of the cells at the edge of the contact
SPREAD = 3.0  # ratio of the uncertainty to the last difference between meshes
GROWS = 0.02  # least relative increase per refinement of a pressure without a finite limit
NONE_FREE = "no crown with unloaded ends was found: surrogate and strips give different optima"


def series(context: Context, crown: str, by: str, what: str) -> list[float]:
    """Largest ("peak") or mid-length ("mid") pressures [Pa] of a crown, coarse to fine meshes."""
    found = measured(context)
    counts = STRIPPED if by == "strips" else CELLS
    if what == "mid":
        return [float(found[f"{crown}: {by} mid {n}"]) for n in counts]
    return [float(found[f"{crown}: {by} {n}"].max()) for n in counts]


def by_slices(context: Context, crown: str, what: str) -> float:
    """Largest pressure or pressure at mid-length [Pa] by slices."""
    found, q = measured(context), with_crown(context.inputs, measured(context)[f"{crown}: crown"])
    contact = in_slices(q, gap(q), float(found[f"{crown}: R"]), float(found[f"{crown}: N_max"][0]))
    return mid(contact) if what == "mid" else float(contact.peak_pressure.max())


@dataclass(frozen=True, kw_only=True)
class AtCrown(Estimated):
    """Row that compares a pressure of the crown with unloaded ends under N_max by two models."""

    what: str
    beside: str  # "slices" or "strips"
    against: str  # "strips" or "cells"

    def rows(self, context: Context) -> list[Row]:
        if "free: R" not in measured(context):
            verdict = judge.Verdict(Status.FAIL if context.is_paper else Status.SHOWN, NONE_FREE)
            return [self._row(context.case, self.kind, verdict)]
        v = series(context, "free", self.against, self.what)
        counts = STRIPPED if self.against == "strips" else CELLS
        u = EDGE if self.against == "cells" else 0.0
        levels = [
            FemResult(h=1 / n, values={self.fem: p}, u_it={self.fem: u * p})
            for n, p in zip(counts, v, strict=True)
        ]
        own = (
            by_slices(context, "free", self.what) if self.beside == "slices"
            else series(context, "free", "strips", self.what)[-1]
        )  # fmt: skip
        return super().rows(replace(context, fem=levels, analytic={self.analytic: own}))


def within(share: float) -> Any:
    """Function that returns the interval ±`share` for the paper's inputs, and None for others."""

    def interval(q: Any, _values: Any) -> tuple[float, float] | None:
        return (-share, share) if q == type(q)() else None

    return interval


def at_crown(name: str, what: str, beside: str, against: str, share: float, demand: float) -> Any:
    return AtCrown(
        name=f"{name}, crown with unloaded ends", symbol="p", unit="MPa", analytic=what, fem=what,
        what=what, beside=beside, against=against, by=BY_STRIPS if against == "strips"
        else HALF_SPACE, interval=within(share), source=PLACE, demand=demand,
        demand_reason="about twice the accepted difference between the compared models",
    )  # fmt: skip


def refined(context: Context, crown: str) -> tuple[float, float]:
    """Largest pressure [Pa] on the half-space and its uncertainty."""
    v = series(context, crown, "cells", "peak")
    return v[-1], SPREAD * abs(v[-1] - v[-2])


def higher(context: Context) -> tuple[float, float, str]:
    """Ratio of the printed crown's largest pressure on a half-space to that by slices, minus 1."""
    p, U = refined(context, "at hand")
    sliced = by_slices(context, "at hand", "peak")
    v = series(context, "at hand", "cells", "peak")
    words = (
        f"on a half-space, p_max of the printed crown is {', '.join(f'{x / 1e6:.0f}' for x in v)} "
        f"MPa with {CELLS[0]}, {CELLS[1]} and {CELLS[2]} cells along the sprag; by slices, it is "
        f"{sliced / 1e6:.0f} MPa"
    )
    return p / sliced - 1, U / sliced, words


def endless(context: Context) -> tuple[float, float, str]:
    """Positive margin if every refinement raises p_max by more than the fraction GROWS.

    The crown is the optimal crown by slices. The uncertainty and the text of the row are also
    returned.
    """
    v = [series(context, "best", by, "peak") for by in ("strips", "cells")]
    grows = min(float(np.min(np.diff(one) / one[:-1])) for one in v)
    words = "; ".join(
        f"{', '.join(f'{x / 1e6:.0f}' for x in one)} MPa with {', '.join(map(str, counts))} {by}"
        for one, counts, by in zip(v, (STRIPPED, CELLS), ("strips", "cells"), strict=True)
    )
    return (
        grows - GROWS,
        0.0,
        f"p_max is {words}; each refinement increases p_max by at least {grows:.1%}, {GROWS:.0%} "
        "required",
    )


def to_make(context: Context) -> str:
    """Text on half-space pressures of the crown with unloaded ends and of the given crown."""
    if "free: R" not in measured(context):
        return NONE_FREE
    K_1, K_2, z_m = measured(context)["free"]
    free, hand = (series(context, name, "cells", "peak") for name in ("free", "at hand"))
    return (
        f"K_1 = {K_1:.2f}, K_2 = {K_2:.3f}, z_m = {z_m * 1e6:.1f} µm of the crown with unloaded "
        f"ends; on a half-space, p_max of this crown is {free[-1] / 1e6:.0f} MPa with {CELLS[-1]} "
        f"cells and {free[0] / 1e6:.0f} MPa with {CELLS[0]} cells; p_max of the given crown is "
        f"{hand[-1] / 1e6:.0f} MPa with {CELLS[-1]} cells and {hand[0] / 1e6:.0f} MPa with "
        f"{CELLS[0]} cells"
    )


def lower(context: Context) -> tuple[float, float, str]:
    """Relative reduction of the largest half-space pressure by the crown with unloaded ends.

    The reduction is relative to the printed crown. The uncertainty and the text of the row are also
    returned.
    """
    free, u = refined(context, "free")
    hand, U = refined(context, "at hand")
    paper = by_slices(context, "free", "peak") / float(measured(context)["best true"][0]) - 1
    crown: Array = measured(context)["free"]
    words = (
        f"on a half-space, p_max is {free / 1e6:.0f} MPa with K_1 = {crown[0]:.2f}, K_2 = "
        f"{crown[1]:.3f}, z_m = {crown[2] * 1e6:.1f} µm and {hand / 1e6:.0f} MPa with the printed "
        f"crown; by slices, p_max of the crown with unloaded ends differs by {paper:+.1%} from "
        "that of the optimal crown by slices"
    )
    return 1 - free / hand, (u + U) / hand, words


def at_rest(q: Any, name: str) -> Comparison:
    """Row that compares, for the given crown at rest, a pressure by slices with that by strips."""
    check = Estimated(
        name=f"{name} of the given crown at rest, by slices", symbol="p", unit="MPa",
        analytic=q.name, fem=q.name, by=BY_STRIPS, interval=within(SLICED + STRIPS), source=PLACE,
        demand=WIDER,
        demand_reason="about twice the sum of the accepted errors of slices (2 %) and of strips "
        "(0.3 %)",
    )  # fmt: skip
    return Comparison(check=check, quantity=q, shares="line contacts, radius of the inner contact")


def pressed(T: int) -> tuple[Any, ...]:
    """Claims on contact pressures of the printed crown at T [N m] and of the optimal crowns."""
    both = SLICED + STRIPS
    return (
        at_crown("largest pressure by slices", "peak", "slices", "strips", both, WIDER),
        at_crown("pressure at mid-length by slices", "mid", "slices", "strips", both, WIDER),
        at_crown("largest pressure by strips", "peak", "strips", "cells", STRIPS, 2 * STRIPS),
        at_crown("pressure at mid-length by strips", "mid", "strips", "cells", STRIPS, 2 * STRIPS),
        Displayed(name="optimal crown with unloaded ends", symbol="p_max", unit="1", words=to_make),
        Noted(name="the printed crown has a higher pressure on a half-space than by slices",
              symbol="p_max", unit="1", erratum="huang2018:eq-21-22-ends", margin=higher,
              printed=(f"huang2018:stress-{T}nm-optimised",)),
        OfPaper(name="the optimal crown by slices has no finite largest pressure on a half-space",
                symbol="p_max", unit="1", margin=endless, fitted=FITTED),
        OfPaper(name="a crown with unloaded ends has a lower pressure on a half-space than the "
                "printed crown",
                symbol="p_max", unit="1", margin=lower, fitted=FITTED),
    )  # fmt: skip
