"""The reference of finite line contacts: boundary elements on a half-space, refined like a mesh.

What is compared does not depend on the mesh: the pressure of a loaded end has no limit, so the
largest pressure is that farther than d from the ends, and ends are told by their load.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.contact.roller.inputs import STRETCH
from verify.core.case import FemResult
from verify.core.figures import Array, Field

if TYPE_CHECKING:
    from analytic.contact.half_space_roller import RollerContact
    from verify.cases.contact.roller.inputs import Roller

ACROSS, ALONG = 2, 32  # cells on the half-width and along the roller, a level
SCOUT = (32, 256)
BEYOND = 1.1  # of the widest contact, which the patch covers
NEAR = 0.7  # of the half-width, within which p² over x² gives the pressure at x = 0
SHOWN = 256  # cells along the roller in pictures
SHORTEST = 1 / 64  # of the roller's length that d may be: eight cells of the coarsest grid


@dataclass(frozen=True)
class Pressed:
    """The roller of `q` on the half-space, on the grid of one level."""

    q: "Roller"
    contact: "RollerContact"

    @property
    def ridge(self) -> Array:
        """Pressure at x = 0 along the roller (ny,) [Pa]: p² is a line over x² there."""
        field, x = self.contact.contact.pressure, self.contact.contact.x
        b = np.maximum(self.contact.half_width, 4 * self.contact.contact.cell[0])
        w = np.abs(x)[:, None] < NEAR * b
        t, v = x[:, None] ** 2 / b**2, field**2
        n, s, r = w.sum(0), (w * t).sum(0), (w * t**2).sum(0)
        f, g = (w * v).sum(0), (w * t * v).sum(0)
        return np.asarray(np.sqrt(np.maximum((r * f - s * g) / (n * r - s**2), 0.0)))

    @property
    def values(self) -> dict[str, float]:
        """What does not depend on the mesh, SI; "p_largest" is what does."""
        q, found = self.q, self.contact
        y, ridge, line = found.y, self.ridge, found.line_load
        limits = np.array([-1.0, 1.0]) * (q.L / 2 - q.d)
        inner = np.abs(y) <= limits[1]
        low, high = found.end_load(q.d)
        loaded = found.contact
        return {
            "p_max": max(_top(np.where(inner, ridge, 0.0)), *np.interp(limits, y, ridge)),
            "p_mid": float(_middle(ridge)),
            "q_mid": float(_middle(line)),
            "b_mid": float(_middle(found.half_width)),
            "delta": loaded.approach,
            "F_low": low,
            "F_high": high,
            "F_d": low + high,
            "p_d": math.sqrt(max(low, high) / q.d * q.E_star / (math.pi * q.R)),
            "M": loaded.moments[0],
            "p_largest": float(loaded.pressure.max()),
            "p_top": _top(ridge),
            "balance": loaded.load - q.F,
        }

    @property
    def arrays(self) -> dict[str, Array]:
        """Pressure at x = 0 and line load along the roller."""
        return {"y": self.contact.y, "p": self.ridge, "q": self.contact.line_load}

    @property
    def field(self) -> Field:
        """The patch with its pressure, stretched across; cells along it put together."""
        loaded = self.contact.contact
        many = math.gcd(loaded.pressure.shape[1], loaded.pressure.shape[1] // SHOWN or 1)
        p = loaded.pressure.reshape(len(loaded.pressure), -1, many).mean(axis=2)
        x = (np.arange(p.shape[0] + 1) - p.shape[0] / 2) * loaded.cell[0] * STRETCH
        y = (np.arange(p.shape[1] + 1) - p.shape[1] / 2) * loaded.cell[1] * many
        points = np.column_stack([a.ravel() for a in np.meshgrid(y, x, indexing="ij")])
        i = np.arange(p.shape[1])[:, None] * x.size + np.arange(p.shape[0])
        cells = np.stack([i, i + 1, i + x.size + 1, i + x.size], axis=-1).reshape(-1, 4)
        return Field(
            name="patch", points=points, cells=cells.astype(np.int64),
            cell_data={"pressure": p.T.ravel()}, units={"pressure": "Pa"},
        )  # fmt: skip


def pressed(q: "Roller", level: int, **how: Any) -> Pressed:
    """The contact on a grid with a line of cells along each edge of the contact at its middle.

    `how` replaces the crown, the load or the cells along. A coarse solution says how wide the
    contact is.
    """
    from analytic.contact.half_space_roller import press_roller
    from verify.cases.contact.roller.profiles import gap

    roller: dict[str, Any] = {"crown": gap(q), "load": q.F} | how
    roller |= {"R": q.R, "length": q.L, "E_star": q.E_star}
    along = roller.pop("along", ALONG * level)
    b = press_roller(**roller, cells=SCOUT).half_width
    middle = float(_middle(b)) or float(b.max())
    cells = ACROSS * level
    half = math.ceil(BEYOND * float(b.max()) / middle * cells) + 1
    width = 2 * half * middle / cells
    return Pressed(q, press_roller(**roller, cells=(2 * half, along), width=width))


def too_short(q: "Roller") -> str:
    """Why the half-space cannot tell what d asks."""
    if q.d >= SHORTEST * q.L:
        return ""
    return (
        f"the end d = {q.d * 1e3:g} mm is shorter than {SHORTEST * q.L * 1e3:.3g} mm, a 64th of l, "
        "too few cells of the half-space: take a longer d, or check without --fem"
    )


def stair(found: Pressed, level: int, **how: Any) -> dict[str, float]:
    """What the values of `found` differ by on the grids next to its own.

    Cells are whole inside the contact or outside: its rim is a stair, other on every grid.
    """
    beside = [pressed(found.q, level + step, **how).values for step in (-1, 1)]
    here = found.values
    return {key: max(abs(v[key] - value) for v in beside) for key, value in here.items()}


def result(
    found: Pressed, level: int, u_it: Mapping[str, float], more: Mapping[str, float] | None = None,
    arrays: Mapping[str, Array] | None = None,
) -> FemResult:  # fmt: skip
    """All of it for one level, with what is left uncertain on it; `more` values and `arrays`."""
    residual = found.contact.contact.residual
    least = {key: 10 * residual * abs(value) for key, value in found.values.items()}
    return FemResult(
        h=1 / level, values=found.values | dict(more or {}),
        u_it={key: max(least.get(key, 0.0), u_it.get(key, 0.0)) for key in {*least, *u_it}},
        arrays=found.arrays | dict(arrays or {}), fields=(found.field,),
    )  # fmt: skip


def _middle(values: Array) -> Any:
    n = len(values)
    return (values[(n - 1) // 2] + values[n // 2]) / 2


def _top(values: Array) -> float:
    """Largest value, of the parabola through it and its neighbours."""
    i = int(np.argmax(values))
    if not 0 < i < len(values) - 1 or min(values[i - 1], values[i + 1]) <= 0:
        return float(values[i])
    below, at, above = values[i - 1 : i + 2]
    bend = below - 2 * at + above
    return float(at - (above - below) ** 2 / (8 * bend)) if bend < 0 else float(at)
