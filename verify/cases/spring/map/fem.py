"""Finite elements of case spring-map: one spring on every level, maps on one of them."""

from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.spring.large_fem import spring_fem
from verify.cases.spring.limits import Share
from verify.cases.spring.map.inputs import SHARES, Cell, MapInputs, points
from verify.core.case import FemResult

if TYPE_CHECKING:
    from fem.beam.pressed import PressedFrame

MAPPED = 8  # the level of the maps
PER_ARC, PER_LEAF = 4, 2  # of the cells of a map
ON_LINE = (0.25, 0.5, 1.0, 1.5, 2.0)  # of b, on one centre line
CLOSER = 4  # steps to the smallest share


class UnstableError(ArithmeticError):
    """Proven: the path of the guided spring has a critical point before the largest share."""


def solve(q: MapInputs, level: int) -> FemResult:
    """One level of the spring; on one of them the maps, too."""
    here = Cell(q.n, q.b, q.r, q.L1, q.alpha)
    one = spring(q, here, level, max(1, level // 2))
    values = {
        f"F_{share}": F for share, F in zip(map(Share, SHARES), pressed(one, here), strict=True)
    }
    values["F_free"] = free(one, here)
    values |= dict(zip(("F_x", "F_y"), aside(q, one), strict=True))
    values["F_x_straight"] = one.force(one.compressed(np.linspace(0.25, 1, 4) * q.x_r)[-1])
    arrays: dict[str, Any] = {}
    if level == MAPPED:
        for name, cells in points(q, deep=False).items():
            arrays[name] = np.array([[measured(q, cell) for cell in row] for row in cells])
        arrays["on_line"] = np.array([on_line(q, share * q.b) for share in ON_LINE])
    return FemResult(h=1 / level, values=values, arrays=arrays)


def deep_fem(q: MapInputs, row: int) -> FemResult:
    """One row of the finer maps, those of the first map before those of the second."""
    rows = [cells for grid in points(q, deep=True).values() for cells in grid]
    return FemResult(
        h=1.0, values={}, arrays={"cells": np.array([measured(q, cell) for cell in rows[row]])}
    )


def spring(q: MapInputs, cell: Cell, per_arc: int, per_leaf: int) -> "PressedFrame":
    return spring_fem(cell.path, cell.b, q.h, q.E, q.nu, per_arc=per_arc, per_leaf=per_leaf)


def measured(q: MapInputs, cell: Cell) -> tuple[float, ...]:
    """Stiffness of a free head at small displacement, and secant ones of a guided head.

    Zero where the strip is no leaf spring (b >= r), and the secant ones where the guided spring
    becomes unstable before the largest share. A path that is not found raises ArithmeticError: it
    says nothing about the spring.
    """
    if cell.b >= cell.r:
        return (0.0,) * (1 + len(SHARES))
    one = spring(q, cell, PER_ARC, PER_LEAF)
    try:
        forces = pressed(one, cell)
    except UnstableError:
        return (one.stiffness, *(0.0,) * len(SHARES))
    secant = (F / (share * cell.length) for share, F in zip(SHARES, forces, strict=True))
    return (one.stiffness, *secant)


def pressed(one: "PressedFrame", cell: Cell) -> list[float]:
    """Forces of the guided head at the shares of its length, all of stable equilibria.

    UnstableError where there is a critical point before, ArithmeticError where nothing is found.
    """
    first = np.linspace(0, SHARES[0], CLOSER + 1)[1:]
    U = np.unique([*first, *SHARES]) * cell.length
    try:
        states = one.compressed(U)
    except ArithmeticError as error:
        until = float(U[-1])
        if (U_cr := one.critical_displacement(until, SHARES[0] / CLOSER * until)) is None:
            raise
        raise UnstableError(f"critical point at {U_cr / cell.length:.1%} of the length") from error
    if any(state.negative for state in states):
        raise UnstableError(f"unstable before {SHARES[-1]:.0%} of the length")
    return [one.force(states[int(np.argmin(abs(U - s * cell.length)))]) for s in SHARES]


def free(one: "PressedFrame", cell: Cell) -> float:
    """Force of a free head that came as far as the first share, drifting on its way."""
    U = np.linspace(0, SHARES[0], 31)[1:] * cell.length
    path = one.frame("").displaced({one.head: {"x": 1.0}}, U)
    return float(path.reactions[-1, one.head, 0])


def aside(q: MapInputs, one: "PressedFrame") -> tuple[float, float]:
    """Force along and across of a head that went the roller's way, without turning."""
    way = {one.head: {"x": q.x_r, "y": q.y_r}}
    state = one.frame("r").displaced(way, np.linspace(0.25, 1, 4)).last
    x, y, _ = state.reactions[one.head]
    return float(x), float(y)


def on_line(q: MapInputs, b: float) -> tuple[float, float, float]:
    """b, L_0/b and the stiffness on the centre line of the inputs."""
    R = q.r + q.b / 2
    cell = Cell(q.n, b, R - b / 2, q.L1, q.alpha)
    return b, cell.length / b, spring(q, cell, PER_ARC, PER_LEAF).stiffness
