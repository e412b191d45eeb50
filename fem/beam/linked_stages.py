"""Load stages of a frame with two contacts that close one after the other, by linear theory.

Rigid links represent the closed contacts.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from fem.beam.links import Link
from fem.beam.section import Array, FrameSolution, Indices, Section
from fem.beam.straight import solve_frame

ROUND_OFF = 1e-14  # relative, of sums over hundreds of elements
TOGETHER = 1e-6  # relative: two tips that touch at once


@dataclass
class LinkedFrame:
    """Frame of straight elements `chords`, loaded along x at `head`, with two possible contacts.

    The contacts are `links` between the nodes `ends` (2, 2). `round_off` is the largest relative
    error of the solutions so far.
    """

    points: Array
    chords: Indices
    ends: Indices
    section: Section
    head: int
    supports: dict[int, str]
    links: list[Link]
    round_off: float = ROUND_OFF

    def solve(self, force: float, closed: Sequence[Link] = ()) -> FrameSolution:
        """Solution under `force` at the head, with the links `closed`."""
        solved = solve_frame(
            self.points, self.chords, sections=self.section, supports=self.supports,
            loads={self.head: (force, 0.0, 0.0)}, links=closed,
        )  # fmt: skip
        self.round_off = max(self.round_off, solved.residual**0.5)
        return solved

    def stages(self) -> dict[str, float]:
        """Stiffness [N/m] of each load stage, and force [N] and displacement [m] at its end.

        `k1`, `k2` and `k3` apply with no, one and both contacts closed. The first contact closes at
        A, the second at B. `push` is the force of the first contact at A.
        """
        k1, rates = self.respond(())
        gaps = [-link.value for link in self.links]
        alone = [
            gap / rate if rate > 0 else math.inf for gap, rate in zip(gaps, rates, strict=True)
        ]
        first = int(np.argmin(alone))
        other, F_A = 1 - first, alone[first]
        k2, after = self.respond((first,))
        k3, _ = self.respond((0, 1))
        rest = max(gaps[other] - rates[other] * F_A, 0.0)
        F_B = F_A + (rest / after[other] if after[other] > 0 else math.inf)
        if F_B - F_A <= TOGETHER * F_A:
            F_B, k2 = F_A, k3
        U_A = F_A / k1
        push = self.solve(F_A, [self.links[first]]).link_forces[0]
        return {
            "k1": k1, "F_A": F_A, "U_A": U_A, "k2": k2, "k3": k3, "F_B": F_B,
            "U_B": U_A + (F_B - F_A) / k2, "push": float(push),
        }  # fmt: skip

    def respond(self, touching: tuple[int, ...]) -> tuple[float, list[float]]:
        """Stiffness at the head, and closure of each gap per unit force at the head.

        `touching` are the numbers of the contacts that are closed.
        """
        solved = self.solve(1.0, [replace(self.links[i], value=0.0) for i in touching])
        closing = [
            float((solved.u[tip, :2] - solved.u[leaf, :2]) @ link.direction)
            for (tip, leaf), link in zip(self.ends, self.links, strict=True)
        ]
        return -1 / (2 * solved.potential_energy), closing


@dataclass(frozen=True)
class Opposite:
    """Point of a leaf opposite to a tip: its element and its relative position on the element.

    `direction` is the direction from the tip to the point, `gap` [m] the distance between the
    surfaces along `direction`.
    """

    element: int
    share: float
    direction: tuple[float, float]
    gap: float


def opposite(
    points: Array, leaf: Indices, tip: int, normal: Literal["force", "leaf"], b: float
) -> Opposite:
    """Point of `leaf` (m, 2) opposite to `tip`, the end node of another leaf.

    The other leaf is parallel to y. `b` is the thickness [length]. `normal` is the direction to the
    point: the normal of the unloaded "leaf", or the direction x of the "force".
    """
    starts, steps = points[leaf[:, 0]], points[leaf[:, 1]] - points[leaf[:, 0]]
    along = steps[0] / np.hypot(*steps[0])
    across = np.array([-along[1], along[0]])
    across = across * np.sign((starts[0] - points[tip]) @ across)
    n = across if normal == "leaf" else np.array([np.sign(across[0]), 0.0])
    distance = float((starts[0] - points[tip]) @ across / (n @ across))
    shares = (points[tip] + distance * n - starts) @ along / (steps @ along)
    element = int(np.argmin(abs(shares - 0.5)))
    slope = abs(float(across[0]))  # of the leaf's face: sin(alpha)
    # the tip's corner, half a thickness ahead, to the leaf's face
    thickness = b / 2 * (1 + 1 / slope) * (slope if normal == "leaf" else 1.0)
    return Opposite(
        element, float(shares[element]), (float(n[0]), float(n[1])), distance - thickness
    )
