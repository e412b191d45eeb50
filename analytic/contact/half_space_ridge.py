"""Roller on a half-space: results that converge if the cells are refined, and a grid for them.

The pressure at a loaded end is unbounded. Therefore, the results are the largest pressure outside
the end zones of length d and the load of the end zones.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.contact.checks import Array
from analytic.contact.half_space_roller import RollerContact, press_roller

SCOUT = (32, 256)  # cells of the grid that finds the contact's width
BEYOND = 1.1  # width of the patch over the widest contact
NEAR = 0.7  # part of the half-width for the fit of p² over x², which gives p at x = 0


@dataclass(frozen=True, kw_only=True)
class Ridge:
    """Roller of relative radius R pressed on a half-space by `load`, with end zones of length d.

    Any consistent units.
    """

    contact: RollerContact
    R: float
    E_star: float
    load: float
    d: float

    @property
    def pressure(self) -> Array:
        """Pressure [stress] at x = 0 along the roller, (ny,); p² is fitted by a line over x²."""
        field, x = self.contact.contact.pressure, self.contact.contact.x
        b = np.maximum(self.contact.half_width, 4 * self.contact.contact.cell[0])
        w = np.abs(x)[:, None] < NEAR * b
        t, v = x[:, None] ** 2 / b**2, field**2
        n, s, r = w.sum(0), (w * t).sum(0), (w * t**2).sum(0)
        f, g = (w * v).sum(0), (w * t * v).sum(0)
        return np.asarray(np.sqrt(np.maximum((r * f - s * g) / (n * r - s**2), 0.0)))

    @property
    def values(self) -> dict[str, float]:
        """Results by name; `p_largest`, the largest pressure of a cell, depends on the cell size.

        Largest pressures are p_max outside the end zones of length d and p_top on the whole roller.
        p_mid is the pressure at mid-length, p_d Hertz's pressure under the mean line load of the
        more loaded end zone. q_mid is the line load and b_mid the half-width at mid-length, delta
        the approach, F_low and F_high are the loads of the end zones, F_d is the sum of both. M is
        the tilting moment, `balance` the error of the load.
        """
        found, ridge = self.contact, self.pressure
        limits = np.array([-1.0, 1.0]) * self.inner(self.d)
        inner = np.abs(found.y) <= limits[1]
        low, high = found.end_load(self.d)
        loaded = found.contact
        return {
            "p_max": max(_top(np.where(inner, ridge, 0.0)), *np.interp(limits, found.y, ridge)),
            "p_mid": float(_middle(ridge)),
            "q_mid": float(_middle(found.line_load)),
            "b_mid": float(_middle(found.half_width)),
            "delta": loaded.approach,
            "F_low": low,
            "F_high": high,
            "F_d": low + high,
            "p_d": math.sqrt(max(low, high) / self.d * self.E_star / (math.pi * self.R)),
            "M": loaded.moments[0],
            "p_largest": float(loaded.pressure.max()),
            "p_top": _top(ridge),
            "balance": loaded.load - self.load,
        }

    @property
    def unevenness(self) -> float:
        """Fraction of the load that must be redistributed to make the line load uniform.

        It depends neither on a peak value nor on the mesh.
        """
        line = self.contact.line_load
        return float(np.abs(line / line.mean() - 1).mean() / 2)

    def inner(self, end: float) -> float:
        """Position y > 0 [length] at the distance `end` from the end of the roller."""
        return self.contact.length / 2 - end

    def beyond(self, end: float) -> Array:
        """Pressures at x = 0 along the roller, outside the end zones of length `end`."""
        return np.asarray(self.pressure[np.abs(self.contact.y) <= self.inner(end)])


def press_ridge(
    crown: Callable[[Array], Array], *, across: int, along: int, load: float, R: float,
    length: float, E_star: float, d: float,
) -> Ridge:  # fmt: skip
    """Contact on a grid that has a grid line at each edge of the contact at mid-length.

    `across` is the number of cells on the half-width, `along` the number of cells on the length of
    the roller, `crown` the function of its profile. A coarse solution gives the width of the
    contact.
    """
    roller: dict[str, Any] = {"crown": crown, "load": load, "R": R, "length": length,
                              "E_star": E_star}  # fmt: skip
    b = press_roller(**roller, cells=SCOUT).half_width
    middle = float(_middle(b)) or float(b.max())
    half = math.ceil(BEYOND * float(b.max()) / middle * across) + 1
    width = 2 * half * middle / across
    found = press_roller(**roller, cells=(2 * half, along), width=width)
    return Ridge(contact=found, R=R, E_star=E_star, load=load, d=d)


def _middle(values: Array) -> Any:
    n = len(values)
    return (values[(n - 1) // 2] + values[n // 2]) / 2


def _top(values: Array) -> float:
    """Largest value, from the parabola through the largest element and its two neighbours."""
    i = int(np.argmax(values))
    if not 0 < i < len(values) - 1 or min(values[i - 1], values[i + 1]) <= 0:
        return float(values[i])
    below, at, above = values[i - 1 : i + 2]
    bend = below - 2 * at + above
    return float(at - (above - below) ** 2 / (8 * bend)) if bend < 0 else float(at)
