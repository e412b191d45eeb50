"""Finite elements of case spring-buckling: a unit, critical points, drift, other dimensions."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.case import Level
from verify.cases.spring.buckling.inputs import (
    DRIFT,
    KEYS,
    MANY,
    MAP_L1,
    MAP_N,
    RATIO,
    SAME_RATIO,
    TAILS,
    THICKNESSES,
    BucklingInputs,
)
from verify.cases.spring.large_fem import spring_fem
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.beam.pressed import PressedFrame

SWEPT = 8  # the level of sweeps and the map
COARSE = 4  # mesh level of springs with other shapes
SHOWN = 0.1  # compression over the free length for the figure of a free head
LAST = 0.75  # over the free length: the leaves of any spring touch before
UNIT_PIECES = slice(2, 5)  # arc, leaf, arc of the first middle unit


def solve(q: BucklingInputs, level: int) -> Level:
    """Results of a level: stiffnesses of a unit, critical points of the spring with either tail.

    One of the levels also has equilibrium paths, and springs of other dimensions.
    """
    from fem.beam.pressed import PLACES
    from fem.beam.pressed_path import both_paths, deflected, drifts
    from fem.beam.released import buckling_state, linear_load

    values: dict[str, float] = unit_fem(q, level)
    u_it: dict[str, float] = {}
    arrays: dict[str, Any] = {}
    fields: list[Field] = []
    for tail in TAILS:
        one = spring(q, q.path | {"tail": tail}, q.b, level)
        U, u, state = buckling_state(one, LAST * q.length)
        if state is None:  # the elastica has a critical point, else the case refuses the inputs
            raise ArithmeticError(
                "the spring with a free head has no critical point up to a displacement of "
                f"{LAST:.0%} of its length (tail clamped at {tail})"
            )
        F = one.force(state)
        F_lin, u_lin = linear_load(one)
        k_y, u_y = one.lateral_stiffness(one.guided.rest())
        found = {"U_cr": (U, u), "F_cr": (F, u / U * F), "F_lin": (F_lin, u_lin), "k_y": (k_y, u_y)}
        for share, moved in zip(DRIFT, drifts(one, q.P, DRIFT), strict=True):
            found[f"drift_{share}"] = moved, PLACES * abs(moved)
        for name, (value, uncertainty) in found.items():
            values[f"{name}{KEYS[tail]}"], u_it[f"{name}{KEYS[tail]}"] = value, uncertainty
        if level == SWEPT:
            shapes = both_paths(one, q.length, SHOWN) | {"let_go": deflected(one, state.u)}
            arrays |= {f"{name}{KEYS[tail]}": array for name, array in shapes.items()}
            fields.append(shape(one, state, f"let go, {tail}"))
    if level == SWEPT:
        arrays |= swept(q)
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=tuple(fields))


def spring(q: BucklingInputs, path: dict[str, Any], b: float, level: int) -> "PressedFrame":
    return spring_fem(path, b, q.h, q.E, q.nu, per_arc=level, per_leaf=max(1, level // 2))


def swept(q: BucklingInputs) -> dict[str, Any]:
    """Arrays by name: critical points of springs of other dimensions.

    The array "by_b" varies b on the same centre line, "same_ratio" varies n with a constant L_0/b,
    "many" varies n, "map" varies L_1 and n.
    """
    from fem.beam.released import buckling_state

    own = q.path | {"tail": "arc"}
    by_b = []
    for share in THICKNESSES:
        one = spring(q, own, share * q.b, SWEPT)
        U, _, state = buckling_state(one, LAST * q.length)
        by_b.append((share * q.b, U, one.force(state) if state else math.nan))
    ratio = []
    for n in SAME_RATIO:
        length = q.length_of(n, q.L1)
        ratio.append(shortening(spring(q, own | {"n": n}, length / RATIO, COARSE), length))
    found = {"by_b": np.array(by_b), "same_ratio": np.array(ratio)}
    found["many"] = np.array([
        shortening(spring(q, own | {"n": n}, q.b, COARSE), q.length_of(n, q.L1)) for n in MANY
    ])  # fmt: skip
    found["map"] = np.array([
        [shortening(spring(q, own | {"n": n, "L1": k * q.L1}, q.b, COARSE),
                    q.length_of(n, k * q.L1)) for n in MAP_N]
        for k in MAP_L1
    ])  # fmt: skip
    return found


def shortening(one: "PressedFrame", length: float) -> float:
    """Relative shortening at which a spring with a free head buckles; nan if it does not."""
    from fem.beam.released import buckling_state

    return buckling_state(one, LAST * length)[0] / length


def unit_fem(q: BucklingInputs, level: int) -> dict[str, float]:
    """Stiffnesses of a middle unit, by name; one end is clamped, loads act at the unit's centre."""
    from fem.beam.part import part_stiffness
    from meshes.spring.path import accordion

    one = spring(q, q.path | {"tail": "arc"}, q.b, level)
    pieces = list(accordion(**q.path, tail="arc"))[UNIT_PIECES]
    start, end = (pieces[0].x, pieces[0].y), pieces[-1].end
    x = one.points[one.elements[:, 2], 0]
    own = one.elements[(x > start[0]) & (x < end[0])]
    found = part_stiffness(one.points, own, one.section, start, end)
    return {f"unit_{name}": k for name, k in found.items()}


def shape(one: "PressedFrame", state: Any, name: str) -> Field:
    """Displacements of the guided spring at which it buckles if the head is released."""
    return Field(
        name=name, points=one.points, cells=one.elements[:, :2],
        point_data={"displacement": state.u[:, :2]}, units={"displacement": "m"},
    )  # fmt: skip
