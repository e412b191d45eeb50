"""The reference of finite line contacts: boundary elements on a half-space, refined like a mesh."""

import math
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

import numpy as np

from verify.cases.contact.roller import profiles
from verify.cases.contact.roller.inputs import STRETCH, Design, Roller
from verify.cases.contact.window import grid
from verify.core.case import FemResult
from verify.core.figures import Array, Field

if TYPE_CHECKING:
    from analytic.contact.half_space_ridge import Ridge

LEVELS = (16, 24, 32)
ACROSS, ALONG = 2, 32  # cells on the half-width and along the roller, a level
SHOWN = 256  # cells along the roller in pictures
SHORTEST = 1 / 64  # least d over the roller's length: eight cells of the coarsest grid

Crown = Callable[[Array], Array] | None


def pressed(q: Roller, level: int, *, crown: Crown = None, along: int = 0) -> "Ridge":
    """The contact of `q` on the grid of a level; another `crown` or cells `along` the roller."""
    from analytic.contact.half_space_ridge import press_ridge

    return press_ridge(
        crown or profiles.gap(q), across=ACROSS * level, along=along or ALONG * level, load=q.F,
        R=q.R, length=q.L, E_star=q.E_star, d=q.d,
    )  # fmt: skip


def too_short(q: Roller) -> str:
    """Reason if the grid is too coarse for an end zone of length d; empty otherwise."""
    if q.d >= SHORTEST * q.L:
        return ""
    return (
        f"the end d = {q.d * 1e3:g} mm is shorter than {SHORTEST * q.L * 1e3:.3g} mm, a 64th of l, "
        "too few cells of the half-space: take a longer d, or check without --fem"
    )


def grid_scatter(q: Roller, found: "Ridge", level: int, *, crown: Crown = None) -> dict[str, float]:
    """Largest change of each value of `found` on the two neighbouring grids.

    Each cell is wholly in or out of contact, so that the contact's edge follows the cells.
    """
    beside = [pressed(q, level + step, crown=crown).values for step in (-1, 1)]
    return {key: max(abs(v[key] - value) for v in beside) for key, value in found.values.items()}


def result(
    found: "Ridge", level: int, u_it: Mapping[str, float], more: Mapping[str, float] | None = None,
    arrays: Mapping[str, Array] | None = None,
) -> FemResult:  # fmt: skip
    """Result of a level with its uncertainty; `more` values and `arrays` are added."""
    residual, values = found.contact.contact.residual, found.values
    least = {key: 10 * residual * abs(value) for key, value in values.items()}
    return FemResult(
        h=1 / level, values=values | dict(more or {}),
        u_it={key: max(least.get(key, 0.0), u_it.get(key, 0.0)) for key in {*least, *u_it}},
        arrays=along(found) | dict(arrays or {}), fields=(patch(found),),
    )  # fmt: skip


def solve_crowns(
    q: Roller, level: int, best: Design, *, more: Mapping[str, float], arrays: Mapping[str, Array]
) -> FemResult:  # fmt: skip
    """One level, with `more` values and `arrays`; the optimal crown is made for F."""
    found = pressed(q, level)
    crown = profiles.gap(q, best)
    other = pressed(q, level, crown=crown)
    u_best = grid_scatter(q, other, level, crown=crown)["p_top"]
    u_it = grid_scatter(q, found, level) | {"p_best": u_best}
    values = {"p_best": other.values["p_top"], **more}
    return result(found, level, u_it, values, arrays)


def along(found: "Ridge") -> dict[str, Array]:
    """Pressure at x = 0 and line load along the roller."""
    return {"y": found.contact.y, "p": found.pressure, "q": found.contact.line_load}


def patch(found: "Ridge", name: str = "patch") -> Field:
    """Picture of the patch with its pressure, stretched across; cells along it are merged."""
    loaded = found.contact.contact
    many = math.gcd(loaded.pressure.shape[1], loaded.pressure.shape[1] // SHOWN or 1)
    p = loaded.pressure.reshape(len(loaded.pressure), -1, many).mean(axis=2)
    x = (np.arange(p.shape[0] + 1) - p.shape[0] / 2) * loaded.cell[0]
    y = (np.arange(p.shape[1] + 1) - p.shape[1] / 2) * loaded.cell[1] * many
    return grid(name, y, x * STRETCH, p.T.ravel())
