"""The claims that the drawn sprag judges: its rolling, rigid races, Eqs. 9 and 10 as printed."""

from dataclasses import dataclass
from typing import Any

from verify.core.case import Context
from verify.core.results import Row
from verify.judging.checks import Identity

DRAWN = "drawn sprag, same deflections"
SLIPS = 0.01


@dataclass(frozen=True, kw_only=True)
class ByDrawn(Identity):
    """A value beside the drawn sprag's, where the clutch has it."""

    by: str = DRAWN

    def rows(self, context: Context) -> list[Row]:
        sides = (context.analytic, *(level.values for level in context.fem))
        keys = (self.analytic, *[self.fem] * len(context.fem))
        there = all(key in side for key, side in zip(keys, sides, strict=True))
        return super().rows(context) if there else []


def drawn(name: str, symbol: str, unit: str, key: str, residual: str, **more: Any) -> ByDrawn:
    return ByDrawn(name=name, symbol=symbol, unit=unit, analytic=key, fem=key, formal=2,
                   residual=residual, **more)  # fmt: skip


BY_DRAWN = (
    drawn("turn of the races, finite steps of rolling", "θ(T)", "deg", "theta", "law alpha"),
    drawn("normal force with rigid races (Liu)", "N_L", "N", "N Liu", "law"),
    drawn("turn of the sprags with rigid races (Liu)", "α_L", "deg", "alpha Liu", "law alpha"),
    drawn("turn of the races, rigid (Liu), finite steps of rolling", "θ_L", "deg", "theta Liu",
          "law alpha"),
    drawn("turn of the sprags, Eqs. 9 and 10 as printed", "α_9,10", "deg", "alpha printed",
          "law alpha"),
    drawn("torque at which the contacts slip at low friction", "T_μ", "N m", "T slip low",
          "law slip", demand=SLIPS, demand_reason="the spiral hardly changes its wedge angle"),
    drawn("growth of the outer race at 20,000 r/min", "δ_ce", "µm", "d_ce fast", ""),
    drawn("turn of the sprags at 20,000 r/min", "α(n)", "deg", "alpha fast", "law alpha"),
    drawn("turn of the races at 20,000 r/min, by rolling", "θ(n)", "deg", "theta fast",
          "law alpha"),
)  # fmt: skip
