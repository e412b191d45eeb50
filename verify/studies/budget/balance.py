"""Arithmetic of a budget: contribution of each cause, remainder, and their uncertainty.

The error of a row is m = (formula - FE)/scale, for most rows formula/FE - 1. The contribution of a
cause is c = m - m', where m' is the error if only this cause is removed. The remainder is m minus
the sum of all contributions.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from verify.judging.convergence import grid_convergence

COVERAGE = 2.0  # half-widths up to which a remainder counts as zero
LARGE = 0.2  # of the total: from there on two causes are removed together as well


@dataclass(frozen=True)
class Part:
    """Contribution of a cause to the relative error; `u` is the uncertainty (half-width).

    `note` gives the reason if there is no number. A cause that is `shared` by formula and finite
    elements is not subtracted.
    """

    name: str
    contribution: float | None
    u: float | None
    shared: bool = False
    note: str = ""

    @property
    def counts(self) -> bool:
        """Whether the contribution is subtracted from the total error."""
        return self.contribution is not None and not self.shared


@dataclass(frozen=True)
class Joint:
    """Effect of removing two causes together, minus the sum of their effects if removed alone."""

    names: tuple[str, str]
    value: float | None
    note: str = ""


@dataclass(frozen=True)
class Balance:
    """Total error of a row, contributions, and remainder with the uncertainty `u` (half-width)."""

    total: float
    parts: tuple[Part, ...]
    remainder: float
    u: float

    @property
    def large(self) -> tuple[str, ...]:
        """Names of the causes that each contribute more than LARGE times the total error."""
        return tuple(
            part.name for part in self.parts
            if part.counts and abs(part.contribution or 0.0) > LARGE * abs(self.total)
        )  # fmt: skip


def balance(total: float, parts: Sequence[Part]) -> Balance:
    """Budget of the error `total`: contributions, remainder, and its uncertainty."""
    mine = [part for part in parts if part.counts]
    left = total - math.fsum(part.contribution or 0.0 for part in mine)
    return Balance(total, tuple(parts), left, math.hypot(*(part.u or 0.0 for part in mine)))


def removed(
    name: str, pairs: Sequence[tuple[float, float]], *, finest: float, shared: bool
) -> Part:
    """Contribution of a cause, from errors (with it, without it) on meshes from coarse to fine.

    The contribution is that on the finest of these meshes. Its uncertainty is the change of the
    contribution between the two finest meshes. If there is one mesh only, the uncertainty is the
    difference between the error on this mesh and the error `finest` on the finest mesh of the case.
    """
    found = [with_it - without for with_it, without in pairs]
    if not found or not all(map(math.isfinite, found)):
        return Part(name, None, None, shared, "no value without it")
    u = abs(found[-1] - found[-2]) if len(found) > 1 else abs(pairs[0][0] - finest)
    return Part(name, found[-1], u, shared)


def finer(name: str, finest: float, beyond: float, h: tuple[float, float], order: float) -> Part:
    """Contribution of the discretisation: change of the error on a mesh finer than all others.

    The uncertainty is the remaining error on this mesh, estimated by the order of convergence. `h`
    contains both mesh sizes. `order` is the order of convergence, NaN if it is unknown.
    """
    change = finest - beyond
    if not math.isfinite(change):
        return Part(name, None, None, note="the row has no value on the finer mesh")
    left = 1.0
    if math.isfinite(order) and h[0] > h[1]:
        left = min(1.0, 1 / ((h[0] / h[1]) ** order - 1))
    return Part(name, change, left * abs(change))


def extrapolated(name: str, errors: Sequence[float], h: Sequence[float], order: float) -> Part:
    """Contribution of the discretisation by extrapolation to zero cell size.

    The extrapolation uses the order of convergence of the three finest meshes.
    """
    if not all(map(math.isfinite, errors[-3:])):
        return Part(name, None, None, note="the row has no value on the coarser meshes")
    if not math.isfinite(order):
        spread = max(errors[-3:]) - min(errors[-3:])
        return Part(
            name,
            0.0,
            spread,
            note="no order of convergence: the uncertainty is the spread of three meshes",
        )
    change = (errors[-1] - errors[-2]) / ((h[-2] / h[-1]) ** order - 1)
    return Part(name, -change, abs(change))


def observed(h: Sequence[float], v: Sequence[float], formal: float | None, scale: float) -> float:
    """Order of convergence of `v` on three meshes, at most the formal order; NaN if unknown."""
    if len(v) < 3 or not all(map(math.isfinite, v)) or not scale > 0:
        return math.nan
    grid = grid_convergence(h, v, formal=formal, scale=scale)
    return math.nan if grid.used is None else grid.used
