"""Paths of a compressed frame whose head is guided along x, free, or displaced at an angle to x."""

from collections.abc import Sequence

import numpy as np

from fem.beam.pressed import PressedFrame
from fem.beam.section import Array

CLOSER = 4  # steps to the smallest share
STEPS = np.linspace(0.05, 1.1, 22)  # of a load on a free head
DRIFTING, GUIDED = (0.01, 0.15, 0.18, 0.6), (0.02, 0.7)  # points of a path, relative to the length


class UnstableError(ArithmeticError):
    """The guided frame certainly becomes unstable below its largest prescribed displacement."""


def stable_forces(one: PressedFrame, length: float, shares: Sequence[float]) -> list[float]:
    """Forces on the guided head at the increasing displacements `shares` x `length`.

    Raises UnstableError if a critical point occurs before the last displacement, and
    ArithmeticError if no equilibrium is found.
    """
    first = np.linspace(0, shares[0], CLOSER + 1)[1:]
    U = np.unique([*first, *shares]) * length
    try:
        states = one.compressed(U)
    except ArithmeticError as error:
        until = float(U[-1])
        if (U_cr := one.critical_displacement(until, shares[0] / CLOSER * until)) is None:
            raise
        raise UnstableError(
            f"the guided head becomes unstable at a displacement of {U_cr / length:.1%} of the "
            "length"
        ) from error
    if any(state.negative for state in states):
        raise UnstableError(
            f"the guided head becomes unstable before its displacement is {shares[-1]:.0%} of the "
            "length"
        )
    return [one.force(states[int(np.argmin(abs(U - s * length)))]) for s in shares]


def free_force(one: PressedFrame, U: Array) -> float:
    """Force along x on an otherwise free head at the last of the prescribed displacements `U`."""
    path = one.frame("").displaced({one.head: {"x": 1.0}}, U)
    return float(path.reactions[-1, one.head, 0])


def slanted_force(one: PressedFrame, x: float, y: float) -> tuple[float, float]:
    """Forces along x and along y on a head that is displaced by (x, y) without rotation."""
    moved = {one.head: {"x": x, "y": y}}
    state = one.frame("r").displaced(moved, np.linspace(0.25, 1, 4)).last
    F_x, F_y, _ = state.reactions[one.head]
    return float(F_x), float(F_y)


def drifts(one: PressedFrame, P: float, shares: Sequence[float]) -> list[float]:
    """Displacements along y of a free head, for the fractions `shares` of the load `P` along x."""
    path = one.frame("").under_loads({one.head: (P, 0.0, 0.0)}, STEPS)
    by_share = {round(float(state.factor), 6): state for state in path.states}
    return [by_share[share].u[one.head, 1] for share in shares]


def deflected(one: PressedFrame, u: Array) -> Array:
    """Centre line (elements, 3, 2) of the frame displaced by `u` (nodes, >= 2)."""
    return np.asarray((one.points + u[:, :2])[one.elements[:, [0, 2, 1]]])


def both_paths(one: PressedFrame, length: float, drawn: float) -> dict[str, Array]:
    """Arrays (name: array) that describe the paths of a free head and of a guided head.

    "free" (m, 4): force, displacements along x and y, determinant divided by that of the undeformed
    frame. "guided" (k, 4): displacement, force, lateral stiffness, determinant of a hinged head
    divided by that of the undeformed frame. "free_shape": centre line of the frame at the
    displacement `drawn` x `length` of the free head.
    """
    a, b, c, d = DRIFTING
    U = np.concatenate([np.linspace(a, b, 20), np.linspace(c, d, 10)]) * length
    path = one.frame("").displaced({one.head: {"x": 1.0}}, U)
    rest = {way: one.determinant(one.guided.rest(), way) for way in ("free", "hinged")}
    free = [one.determinant(state, "free") / rest["free"] for state in path.states]
    u = path.u[:, one.head]
    V = np.linspace(*GUIDED, 12) * length
    states = one.compressed(V)
    return {
        "free": np.column_stack([path.reactions[:, one.head, 0], u[:, 0], u[:, 1], free]),
        "guided": np.column_stack([
            V, [one.force(s) for s in states], [one.lateral_stiffness(s)[0] for s in states],
            [one.determinant(s, "hinged") / rest["hinged"] for s in states],
        ]),
        "free_shape": deflected(one, path.u[int(np.argmin(abs(U - drawn * length)))]),
    }  # fmt: skip
