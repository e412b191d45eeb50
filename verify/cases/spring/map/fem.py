"""Finite elements of case spring-map: the spring on every level, the maps on one level."""

from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.spring.large_fem import spring_fem
from verify.cases.spring.limits import Share
from verify.cases.spring.map.inputs import SHARES, Cell, MapInputs, points
from verify.core.case import FemResult

if TYPE_CHECKING:
    from fem.beam.pressed import PressedFrame

MAPPED = 8  # the level of the maps
PER_ARC, PER_LEAF = 4, 2  # elements for the cells of a map
ON_LINE = (0.25, 0.5, 1.0, 1.5, 2.0)  # thicknesses over b, on the same centre line


def solve(q: MapInputs, level: int) -> FemResult:
    """Results of one level of the spring; one level also has the maps."""
    from fem.beam.pressed_path import free_force, slanted_force, stable_forces

    here = Cell(q.n, q.b, q.r, q.L1, q.alpha)
    one = spring(q, here, level, max(1, level // 2))
    forces = stable_forces(one, here.length, SHARES)
    values = {f"F_{share}": F for share, F in zip(map(Share, SHARES), forces, strict=True)}
    values["F_free"] = free_force(one, np.linspace(0, SHARES[0], 31)[1:] * here.length)
    values["F_x"], values["F_y"] = slanted_force(one, q.x_r, q.y_r)
    values["F_x_straight"] = one.force(one.compressed(np.linspace(0.25, 1, 4) * q.x_r)[-1])
    arrays: dict[str, Any] = {}
    if level == MAPPED:
        for name, cells in points(q, deep=False).items():
            arrays[name] = np.array([[measured(q, cell) for cell in row] for row in cells])
        arrays["on_line"] = np.array([on_line(q, share * q.b) for share in ON_LINE])
    return FemResult(h=1 / level, values=values, arrays=arrays)


def deep_fem(q: MapInputs, row: int) -> FemResult:
    """Results of one row of the finer maps; rows of the first map precede those of the second."""
    rows = [cells for grid in points(q, deep=True).values() for cells in grid]
    return FemResult(
        h=1.0, values={}, arrays={"cells": np.array([measured(q, cell) for cell in rows[row]])}
    )


def spring(q: MapInputs, cell: Cell, per_arc: int, per_leaf: int) -> "PressedFrame":
    return spring_fem(cell.path, cell.b, q.h, q.E, q.nu, per_arc=per_arc, per_leaf=per_leaf)


def measured(q: MapInputs, cell: Cell) -> tuple[float, ...]:
    """Initial stiffness with a free head, and secant stiffnesses [N/m] with a guided head.

    All values are zero if b >= r. The secant stiffnesses are zero if the guided spring becomes
    unstable before the largest displacement.
    Raises ArithmeticError if an equilibrium path is not found; this does not mean that the spring
    is unstable.
    """
    from fem.beam.pressed_path import UnstableError, stable_forces

    if cell.b >= cell.r:
        return (0.0,) * (1 + len(SHARES))
    one = spring(q, cell, PER_ARC, PER_LEAF)
    try:
        forces = stable_forces(one, cell.length, SHARES)
    except UnstableError:
        return (one.stiffness, *(0.0,) * len(SHARES))
    secant = (F / (share * cell.length) for share, F in zip(SHARES, forces, strict=True))
    return (one.stiffness, *secant)


def on_line(q: MapInputs, b: float) -> tuple[float, float, float]:
    """Thickness b, ratio L_0/b and initial stiffness of a spring with the inputs' centre line."""
    R = q.r + q.b / 2
    cell = Cell(q.n, b, R - b / 2, q.L1, q.alpha)
    return b, cell.length / b, spring(q, cell, PER_ARC, PER_LEAF).stiffness
