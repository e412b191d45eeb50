"""Candidates of a search and their formula results, as arrays over all candidates."""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from analytic.spring import energy
from analytic.spring.column import critical_shortening
from analytic.spring.column import free_length as centre_length
from analytic.spring.stages import stages
from analytic.spring.wide_leaf import width_factor
from verify.studies.design.inputs import Demands

Array = NDArray[np.float64]

SAMPLED = 0.1  # steps of ln(h/l) between width factors; in between they err by 1e-5


@dataclass(frozen=True)
class Springs:
    """Geometry of N candidates in SI units, arrays (N,); `n` are integers."""

    n: NDArray[np.int64]
    b: Array
    L1: Array
    r: Array
    alpha: Array

    def __len__(self) -> int:
        return len(self.b)

    def __getitem__(self, which: NDArray[np.bool_] | NDArray[np.int64]) -> "Springs":
        return Springs(*(getattr(self, f.name)[which] for f in fields(self)))

    @cached_property
    def possible(self) -> NDArray[np.bool_]:
        """Whether a strip can be bent to this shape: b < r and 2 r < L1."""
        return (self.b < self.r) & (2 * self.r < self.L1)


def candidates(ranges: Mapping[str, tuple[float, ...]]) -> Springs:
    """Springs of all combinations of the values; springs with equal n are adjacent."""
    names = ("n", "b", "alpha", "r", "L1")
    grid = np.meshgrid(*(np.array(ranges[name], dtype=float) for name in names), indexing="ij")
    flat = {name: values.ravel() for name, values in zip(names, grid, strict=True)}
    return Springs(np.round(flat.pop("n")).astype(np.int64), **flat)


@dataclass(frozen=True)
class Formulas:
    """Results of the formulas for N springs in SI units, (N,); NaN if the shape is impossible.

    `f` is the width factor on E I. `k1_eqs_1_9` is the stiffness as in the paper, independent of
    the inputs `arcs`, `head` and `tail`. `U_cr` is inf if the spring does not buckle.
    """

    L0: Array
    U_w: Array
    f: Array
    k1: Array
    k1_eqs_1_9: Array
    U_A: Array
    F_A: Array
    k2: Array
    U_cr: Array
    stress: Array

    def delta(self, F_w: float) -> Array:
        """Displacement [m] under the working force, F_w/k_1, as in Eq. 11."""
        return F_w / self.k1


def width_factors(springs: Springs, demands: Demands) -> Array:
    """Width factor on the stiffness of each spring, as given or computed from its leaf length.

    The factor depends only on the ratio of the width h to the length of a leaf. It is interpolated
    between computed values.
    """
    if demands.width_factor is not None:
        return np.full(len(springs), demands.width_factor)
    leaf = energy.leaf_length(L1=springs.L1, r=springs.r, b=springs.b, alpha=springs.alpha)
    low, high = np.log(demands.h / leaf.max()), np.log(demands.h / leaf.min())
    at = np.linspace(low, high, max(2, int(np.ceil((high - low) / SAMPLED)) + 1))
    f = width_factor(np.exp(at), 1.0, nu=demands.nu)
    return np.asarray(np.interp(np.log(demands.h / leaf), at, f))


def formulas(springs: Springs, demands: Demands) -> Formulas:
    """Lengths, stages of the curve, and stress at the working force of all candidates."""
    found = {f.name: np.full(len(springs), np.nan) for f in fields(Formulas)}
    for n in np.unique(springs.n):
        which = np.flatnonzero((springs.n == n) & springs.possible)
        if which.size:
            for name, values in _of_one_n(int(n), springs[which], demands).items():
                found[name][which] = values
    return Formulas(**found)


def _of_one_n(n: int, s: Springs, q: Demands) -> Mapping[str, Array]:
    leaf = energy.leaf_length(L1=s.L1, r=s.r, b=s.b, alpha=s.alpha)
    L0 = centre_length(n=n, L1=s.L1, radius=s.r + s.b / 2, alpha=s.alpha) + s.b
    f = width_factors(s, q)
    staged = stages(
        n=n, b=s.b, h=q.h, radius=s.r if q.arcs == "inner" else s.r + s.b / 2, L1=s.L1,
        alpha=s.alpha, E=q.E, nu=q.nu, width_factor=f, head=q.head, tail=q.tail,
        leaf=leaf,
    )  # fmt: skip
    sways = critical_shortening(
        q.head, n=n, L1=s.L1, radius=s.r + s.b / 2, alpha=s.alpha, b=s.b, nu=q.nu
    )
    couple = q.F_w * staged.top_couple / staged.F_A
    return {
        "L0": L0,
        "U_w": L0 - q.L_w if q.L_w is not None else np.full(len(s), q.U_w),
        "f": f,
        "k1": staged.k1,
        "k1_eqs_1_9": energy.stiffness(n=n, b=s.b, h=q.h, r=s.r, L1=s.L1, alpha=s.alpha, E=q.E),
        "U_A": staged.U_A,
        "F_A": staged.F_A,
        "k2": staged.k2,
        "U_cr": np.where(np.isnan(sways), np.inf, sways * (L0 - s.b)),
        "stress": energy.curvature_factor(b=s.b, r=s.r) * 6 * couple / (q.h * s.b**2),
    }
