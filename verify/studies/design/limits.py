"""Limits of a spring design: Eqs. 11-13 of Wang et al. 2023, and further limits."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from verify.studies.design.inputs import Demands
from verify.studies.design.springs import Formulas, Springs

Array = NDArray[np.float64]
ROUND_OFF = 1e-12  # a limit that is reached exactly is not violated


@dataclass(frozen=True, kw_only=True)
class Limit:
    """A limit on one quantity of all candidates.

    `value` (N,) [SI] must be at most `bound`, or at least `bound` if `least` is set. `key` is the
    name of the input that sets the limit. The value of this input is `bound` - `offset`: for a
    margin, `bound` is 1 + margin and `offset` is 1.
    """

    key: str
    what: str
    symbol: str
    unit: str
    value: Array
    bound: float
    source: str
    least: bool = False
    offset: float = 0.0

    @cached_property
    def excess(self) -> Array:
        """Relative difference of value and bound, (N,); positive if the limit is violated."""
        beyond = self.bound - self.value if self.least else self.value - self.bound
        return np.where(np.isnan(self.value), np.inf, beyond / abs(self.bound))

    @cached_property
    def violated(self) -> NDArray[np.bool_]:
        """Whether each candidate violates the limit, (N,)."""
        return np.asarray(self.excess > ROUND_OFF)

    @property
    def sign(self) -> str:
        """Sign of the required relation between value and bound: "≥" or "≤"."""
        return "≥" if self.least else "≤"


@dataclass(frozen=True)
class Judged:
    """Limits on N candidates; `possible` marks the candidates that can be made as a spring."""

    limits: Sequence[Limit]
    possible: NDArray[np.bool_]

    @cached_property
    def feasible(self) -> NDArray[np.bool_]:
        """Whether each candidate is within every limit, (N,)."""
        return np.asarray(self.possible & ~self.violations.any(axis=0))

    @cached_property
    def violations(self) -> NDArray[np.bool_]:
        """Whether each candidate violates each limit, (limits, N); False for impossible shapes."""
        return np.array([limit.violated for limit in self.limits]) & self.possible

    def reasons(self, i: int) -> tuple[str, ...]:
        """Keys of the limits that candidate `i` violates; ("shape",) if its shape is impossible."""
        if not self.possible[i]:
            return ("shape",)
        return tuple(
            limit.key for limit, bad in zip(self.limits, self.violations[:, i], strict=True) if bad
        )


def limits(s: Springs, f: Formulas, q: Demands) -> Judged:
    """Every limit of the demands, evaluated for all candidates."""
    delta = f.delta(q.F_w)
    found = [
        Limit(key="e_max", what="deviation from computed displacement", symbol="|U_w − Δ|/Δ",
              unit="%", value=np.abs(f.U_w - delta) / delta, bound=q.e_max, source="Eq. 11"),
        Limit(key="ratio_min", what="working displacement over free length", symbol="U_w/L_0",
              unit="1", value=f.U_w / f.L0, bound=q.ratio_min, source="Eq. 12", least=True),
        Limit(key="ratio_max", what="working displacement over free length", symbol="U_w/L_0",
              unit="1", value=f.U_w / f.L0, bound=q.ratio_max, source="Eq. 12"),
        Limit(key="wedge", what="free length in the wedge", symbol="L_0", unit="mm",
              value=f.L0, bound=q.wedge, source="Fig. 12"),
        Limit(key="margin", what="margin to point A, where leaves touch", symbol="U_A/U_w − 1",
              unit="%", value=_over(f.U_A, f.U_w), bound=1 + q.margin,
              source="closed form", least=True, offset=1.0),
        Limit(key="sigma", what="bending stress at F_w", symbol="σ", unit="MPa",
              value=f.stress, bound=q.sigma, source="curved bar"),
    ]  # fmt: skip
    if q.sway is not None:
        found.append(
            Limit(key="sway", what="margin to lateral buckling", symbol="U_cr/U_w − 1", unit="%",
                  value=_over(f.U_cr, f.U_w), bound=1 + q.sway, source="Haringx's column",
                  least=True, offset=1.0)
        )  # fmt: skip
    if q.z_max is not None:
        found.append(
            Limit(key="z_max", what="free length over thickness", symbol="L_0/b", unit="1",
                  value=f.L0 / s.b, bound=q.z_max, source="Eq. 13")
        )  # fmt: skip
    if q.room is not None:
        found.append(
            Limit(key="room", what="transverse height", symbol="2 (L_1/2 + r + b)", unit="mm",
                  value=_where(s, s.L1 + 2 * (s.r + s.b)), bound=q.room, source="geometry")
        )  # fmt: skip
    if q.b_tolerance is not None and q.k_band is not None:
        found.append(
            Limit(key="k_band", what="change of stiffness with the strip's tolerance",
                  symbol="(1 + t_b/b)^3 − 1", unit="%",
                  value=_where(s, (1 + q.b_tolerance / s.b) ** 3 - 1), bound=q.k_band,
                  source="k ~ b^3")
        )  # fmt: skip
    return Judged(found, s.possible)


def _where(s: Springs, values: Array) -> Array:
    return np.where(s.possible, values, np.nan)


def _over(room: Array, U_w: Array) -> Array:
    """Ratio of the available displacement to U_w; infinite if U_w <= 0."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(U_w <= 0, np.inf, room / U_w)
