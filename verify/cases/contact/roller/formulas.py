"""What the formulas say of a finite line contact: strips, the paper's slices, uncoupled slices."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.contact import hertz_line, lamina, palmgren, slices, strips
from analytic.contact.crown import slice_centres
from analytic.contact.sliced import SlicedContact
from analytic.contact.strip_error import neglected
from verify.cases.contact.roller.inputs import (
    CrownedInputs,
    Roller,
    RollerInputs,
    SlicedInputs,
    StripInputs,
)
from verify.core.case import Context, Values
from verify.core.figures import Array

LEAST = 1e-4  # of a model error: nothing sharper is claimed
OWN = 1e-3  # nor this at one's own numbers, for which nobody chose strips and grids
LOADED = 3e-3  # nor this, there, where an end carries, of which no expansion speaks
SLENDER = 0.03  # of the length, the half-width up to which the expansion is trusted there
WIDEST = 0.01  # and beyond the suite's demand: an interval that judges nothing
TIMES = 2.0  # within which the strips' own estimate of what they neglect holds


@dataclass(frozen=True)
class Along:
    """Pressure at x = 0 and line load at the centres y of equal parts of the roller (n,)."""

    q: Roller
    y: Array
    p: Array
    line: Array

    @property
    def width(self) -> float:
        """Length of a part [m]."""
        return self.q.L / len(self.y)

    @property
    def peak(self) -> float:
        """Largest pressure at least d away from the ends, of the parabola through three parts."""
        q = self.q
        limit = q.L / 2 - q.d
        inner = np.abs(self.y) <= limit
        at = int(np.argmax(np.where(inner, self.p, -1.0)))
        return float(max(vertex(self.p, at), *np.interp([-limit, limit], self.y, self.p)))

    @property
    def mid(self) -> float:
        """Pressure at mid-length; between two parts the mean of their squares, which are loads."""
        n = len(self.p)
        return float(np.sqrt((self.p[(n - 1) // 2] ** 2 + self.p[n // 2] ** 2) / 2))

    @property
    def ends(self) -> tuple[float, float]:
        """Loads within d of the ends at -l/2 and l/2."""
        share = np.clip(self.q.d / self.width - np.arange(len(self.y)), 0.0, 1.0)
        force = self.line * self.width
        return float(share @ force), float(share[::-1] @ force)

    def values(self, approach: Any, name: str) -> dict[str, float]:
        """Values under their keys, each led by the `name` of the model."""
        q, (low, high) = self.q, self.ends
        mid = float(np.mean(self.line[[(len(self.y) - 1) // 2, len(self.y) // 2]]))
        found = {
            "peak": self.peak,
            "mid": self.mid,
            "q mid": mid,
            "b mid": float(np.sqrt(4 * mid * q.R / (np.pi * q.E_star))),
            "approach": float(approach),
            "low end": low,
            "high end": high,
            "ends": low + high,
            "end pressure": float(np.sqrt(max(low, high) / q.d * q.E_star / (np.pi * q.R))),
            "moment": float(self.line @ self.y * self.width),
            "largest": float(self.p.max()),
            "top": vertex(self.p, int(np.argmax(self.p))),
        }
        return {f"{name} {key}": value for key, value in found.items()}


def vertex(p: Array, at: int) -> float:
    """Top of the parabola through p at `at` and beside it; p itself where that is none."""
    below, top, above = np.pad(p, 1)[at : at + 3]
    bend = below - 2 * top + above
    if min(below, above) <= 0 or top < max(below, above) or bend >= 0:  # it may go on rising
        return float(top)
    return float(top - (above - below) ** 2 / (8 * bend))


Gap = Callable[[Array], Array]
Divided = StripInputs | RollerInputs


def roller(q: Roller, n: int, gap: Gap | None = None) -> dict[str, Any]:
    """What all models are given, for n parts; `gap` (y) replaces the roller's own."""
    z = (gap or q.gap)(slice_centres(length=q.L, slices=n))
    return {"gap": z, "length": q.L, "R": q.R, "E_star": q.E_star, "load": q.F}


def by_strips(q: Roller, n: int, gap: Gap | None = None) -> tuple[strips.Strips, Along]:
    """The strips' solution for n strips."""
    found = strips.press(**roller(q, n, gap))
    y = slice_centres(length=q.L, slices=n)
    return found, Along(q, y, found.pressure, found.q)


def strip_values(q: Divided, name: str = "strips", gap: Gap | None = None) -> dict[str, float]:
    """Values by n strips, those by "twice" as many, and what strips neglect ("left"), by `name`."""
    solved, along = by_strips(q, q.n, gap)
    twice, finer = by_strips(q, 2 * q.n, gap)
    left = {key: value for key, value in left_out(solved, along).items() if np.isfinite(value)}
    return (
        along.values(solved.approach, name)
        | finer.values(twice.approach, f"{name} twice")
        | {f"{name} {key} left": value for key, value in left.items()}
        | {
            f"{name} contact": float(solved.carries.mean() * q.L),
            f"{name} loaded ends": float(solved.carries[0]) + float(solved.carries[-1]),
        }
    )


def sliced(q: SlicedInputs, model: Any) -> tuple[SlicedContact, Along]:
    """The solution of a model of slices, by Palmgren's law for a whole roller of its length."""
    found = model.press(**roller(q, q.slices))
    y = slice_centres(length=q.L, slices=q.slices)
    return found, Along(q, y, found.peak_pressure, found.line_load)


def values(q: CrownedInputs | RollerInputs) -> dict[str, float]:
    """Values of all models under their names, and Hertz's for an even load."""
    found = strip_values(q)
    for name, model in MODELS.items():
        contact, parts = sliced(q, model)
        found |= parts.values(contact.approach, name)
    hertz = {"P": q.F / q.L, "R": q.R, "E_star": q.E_star}
    return found | {
        "F": q.F,
        "F l": q.F * q.L,
        "share of the ends": found["strips ends"] / q.F,
        "Hertz p0": float(hertz_line.peak_pressure(**hertz)),
        "Hertz b": float(hertz_line.half_width(**hertz)),
        "Palmgren": float(palmgren.approach(load=q.F, length=q.L)),
        "E*": q.E_star,
        "R": q.R,
    }


def left_out(solved: strips.Strips, along: Along) -> dict[str, float]:
    """What strips neglect: at the largest pressure beyond d of the ends, at mid-length, of depth.

    As fractions by which a half-space's values are higher; NaN where no estimate is known.
    """
    missing = neglected(solved)
    inner = np.abs(along.y) <= along.q.L / 2 - along.q.d
    at = int(np.argmax(np.where(inner, along.p, -1.0)))
    return {
        "peak": float(missing.pressure[at]),
        "top": float(missing.pressure[int(np.argmax(along.p))]),
        "mid": float(missing.mid),
        "approach": float(missing.approach),
    }


def interval(key: str, name: str = "strips") -> Any:
    """Interval of strips/half-space - 1, from the strips `name` alone.

    From half to twice of what they neglect, and either way what is left of strips whose error is
    of first order, twice what they change as there are twice as many; under a loaded end, where
    more of them need not be better, that change once. None where no estimate is known.
    """

    def found(q: Roller, v: Values) -> tuple[float, float] | None:
        if f"{name} {key} left" not in v or not v[f"{name} {key}"]:
            return None
        if q.own and q.b > SLENDER * q.L:
            return None
        left, loaded = -v[f"{name} {key} left"], v[f"{name} loaded ends"] > 0
        change = abs(v[f"{name} twice {key}"] / v[f"{name} {key}"] - 1)
        least = LEAST if not q.own else LOADED if loaded else OWN
        cut = (1 if loaded else 2) * change + least
        low, high = sorted((left / TIMES, TIMES * left))
        if q.own and high - low + 2 * cut > WIDEST:
            return None
        return low - cut, high + cut

    return found


def apart(context: Context, name: str) -> tuple[float, float, float]:
    """Share of the load that a model puts elsewhere than the half-space, its U, and q's L2 error.

    The share does not care how finely the roller is sliced; the error in L2 is mostly that of the
    slices in which contact ends.
    """
    q = context.inputs
    _, parts = sliced(q, MODELS[name])
    n = len(parts.y)
    edges = np.linspace(-q.L / 2, q.L / 2, n + 1)
    share, error = [], 0.0
    for result in context.fem[-2:]:
        line = result.arrays["q"]
        stations = np.linspace(-q.L / 2, q.L / 2, len(line) + 1)
        total = np.concatenate([[0.0], np.cumsum(line) * (q.L / len(line))])
        reference = np.diff(np.interp(edges, stations, total)) * (n / q.L)
        off = parts.line - reference
        share.append(float(np.abs(off).sum() / reference.sum() / 2))
        error = float(np.linalg.norm(off) / np.linalg.norm(reference))
    return share[-1], 3 * abs(share[-1] - share[-2]), error


MODELS = {"slices": slices, "lamina": lamina}
