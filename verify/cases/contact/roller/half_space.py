"""Reference of finite line contacts: boundary elements on a half-space with refined grids."""

import math
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

import numpy as np

from verify.cases.contact.roller import profiles
from verify.cases.contact.roller.inputs import Design, Roller
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
    """Contact of `q` on the grid of `level`, with the given `crown` or else the gap of `q`.

    `along` is the number of cells along the roller; 0 gives the number that follows from `level`.
    """
    from analytic.contact.half_space_ridge import press_ridge

    return press_ridge(
        crown or profiles.gap(q), across=ACROSS * level, along=along or ALONG * level, load=q.F,
        R=q.R, length=q.L, E_star=q.E_star, d=q.d,
    )  # fmt: skip


def too_short(q: Roller) -> str:
    """Reason for not solving end zones d shorter than eight cells; "" for longer zones."""
    if q.d >= SHORTEST * q.L:
        return ""
    return (
        f"the end zone d = {q.d * 1e3:g} mm is shorter than l/64 = {SHORTEST * q.L * 1e3:.3g} mm, "
        "too short for the cells of the half-space: increase d, or run `check` without --fem"
    )


def grid_scatter(q: Roller, found: "Ridge", level: int, *, crown: Crown = None) -> dict[str, float]:
    """Largest change of each value of `found` on grids one step coarser and one step finer.

    Each cell is completely in or out of contact, so that the edge of the contact follows the cells.
    """
    beside = [pressed(q, level + step, crown=crown).values for step in (-1, 1)]
    return {key: max(abs(v[key] - value) for v in beside) for key, value in found.values.items()}


def result(
    found: "Ridge", level: int, u_it: Mapping[str, float], more: Mapping[str, float] | None = None,
    arrays: Mapping[str, Array] | None = None,
) -> FemResult:  # fmt: skip
    """Result of `level`, with errors of iteration; `more` are further values of the result."""
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
    """Result of `level` for the crown of `q` and the optimal crown `best` for F.

    `more` values and `arrays` are added.
    """
    found = pressed(q, level)
    crown = profiles.gap(q, best)
    other = pressed(q, level, crown=crown)
    u_best = grid_scatter(q, other, level, crown=crown)["p_top"]
    u_it = grid_scatter(q, found, level) | {"p_best": u_best}
    values = {"p_best": other.values["p_top"], **more}
    return result(found, level, u_it, values, arrays)


def along(found: "Ridge") -> dict[str, Array]:
    """Arrays along the roller: coordinates y [m], pressures at x = 0 [Pa], line loads [N/m]."""
    return {"y": found.contact.y, "p": found.pressure, "q": found.contact.line_load}


def patch(found: "Ridge", name: str = "patch") -> Field:
    """Field of the pressure on the contact patch; cells along y are merged."""
    loaded = found.contact.contact
    many = math.gcd(loaded.pressure.shape[1], loaded.pressure.shape[1] // SHOWN or 1)
    p = loaded.pressure.reshape(len(loaded.pressure), -1, many).mean(axis=2)
    x = (np.arange(p.shape[0] + 1) - p.shape[0] / 2) * loaded.cell[0]
    y = (np.arange(p.shape[1] + 1) - p.shape[1] / 2) * loaded.cell[1] * many
    return grid(name, y, x, p.T.ravel())
