"""Straight-element frames of the accordion spring whose tips touch, by rigid links."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from analytic.spring.loops import Normal
from verify.case import Level
from verify.cases.spring.stages.ends import ENDS, Ends
from verify.cases.spring.stages.inputs import StagesInputs
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.beam.links import Link
    from fem.beam.section import FrameSolution, Section
    from meshes.line import LineMesh

SHARES = np.linspace(0.0625, 0.6875, 11)  # of the length between head and tail
SUPPORTS = {"free": "", "hinged": "y", "guided": "yr"}
ROUND_OFF = 1e-14  # relative, of sums over hundreds of elements
TOGETHER = 1e-6  # relative: two tips that touch at once


def solve(q: StagesInputs, level: int) -> Level:
    """One level of the spring with all ends."""
    from fem.beam.section import Section
    from meshes.spring.centre_line import centre_line

    E = q.E * q.factor
    section = Section(EA=E * q.b * q.h, EI=E * q.h * q.b**3 / 12)
    values: dict[str, float] = {}
    u_it: dict[str, float] = {}
    fields = []
    for ends in ENDS:
        line = centre_line(
            **q.path, tail=ends.tail, tips=True, per_arc=level, per_leaf=max(1, level // 2)
        )
        frame = linked(line, section, ends, q)
        found = frame.stages()
        values |= {f"{name}_{ends.key}": value for name, value in found.items()}
        u_it |= {f"{name}_{ends.key}": abs(v) * frame.round_off for name, v in found.items()}
        if (ends.head, ends.tail, ends.normal) == (q.head, q.tail, "force"):
            fields.append(frame.field(found["F_A"], q))
            curve = force_over_displacement(found, line.points[line.nodes["tail"], 0])
            u_it["force"] = float(curve[-1]) * frame.round_off
    return Level(
        h=1 / level, values=values, u_it=u_it, arrays={"force": curve}, fields=tuple(fields)
    )


def force_over_displacement(found: dict[str, float], length: float) -> Any:
    """Forces (m,) at the displacements SHARES x `length`, straight between the points."""
    U, A, B = SHARES * length, found["U_A"], found["U_B"]
    second = np.where(U > A, found["F_A"] + found["k2"] * (U - A), found["k1"] * U)
    return np.where(U > B, found["F_B"] + found["k3"] * (U - B), second)


def linked(line: "LineMesh", section: "Section", ends: Ends, q: StagesInputs) -> "Spring":
    """The spring on a mesh with tips, cut where they will touch."""
    from fem.beam.links import Link, divide

    points, chords = line.chords
    held = {line.nodes["tail"]}
    if ends.tail == "arc":  # the tail's whole leaf is clamped
        rest = np.intersect1d(line.bodies["tips"], line.bodies[f"unit {q.n}"])
        held |= set(chords[rest].ravel().tolist())
    places = []
    for tip, unit in (("head tip", 2), ("tail tip", q.n - 1)):
        leaf = np.intersect1d(line.bodies["leaves"], line.bodies[f"unit {unit}"])
        pair = opposite(points, chords[leaf], line.nodes[tip], ends.normal, q.b)
        second = int(leaf[pair.element]), pair.share
        places.append(Link(first=line.nodes[tip], second=second, direction=pair.direction,
                           value=-pair.gap))  # fmt: skip
    cut, head = divide(points, chords, places), line.nodes["head"]
    return Spring(
        points=cut.points, chords=cut.elements, ends=cut.ends, section=section, head=head,
        supports=dict.fromkeys(held, "xyr") | {head: SUPPORTS[ends.head]},
        links=[
            replace(link, first=int(i), second=int(j))
            for link, (i, j) in zip(places, cut.ends, strict=True)
        ],
    )  # fmt: skip


@dataclass
class Spring:
    """One spring, its supports and both pairs of tip and leaf as links that may be closed.

    `ends` (2, 2) are the pairs' nodes; `round_off` grows with what the solver leaves.
    """

    points: Any
    chords: Any
    ends: Any
    section: "Section"
    head: int
    supports: dict[int, str]
    links: "list[Link]"
    round_off: float = ROUND_OFF

    def solve(self, force: float, closed: "Sequence[Link]" = ()) -> "FrameSolution":
        """Under `force` at the head, with `closed` links."""
        from fem.beam.straight import solve_frame

        solved = solve_frame(
            self.points, self.chords, sections=self.section, supports=self.supports,
            loads={self.head: (force, 0.0, 0.0)}, links=closed,
        )  # fmt: skip
        self.round_off = max(self.round_off, solved.residual**0.5)
        return solved

    def stages(self) -> dict[str, float]:
        """Stiffnesses [N/m], forces [N] and displacements [m] of the stages."""
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
        """Stiffness, and how fast both gaps close per force, while pairs are `touching`."""
        solved = self.solve(1.0, [replace(self.links[i], value=0.0) for i in touching])
        closing = [
            float((solved.u[tip, :2] - solved.u[leaf, :2]) @ link.direction)
            for (tip, leaf), link in zip(self.ends, self.links, strict=True)
        ]
        return -1 / (2 * solved.potential_energy), closing

    def field(self, force: float, q: StagesInputs) -> Field:
        """The spring under `force` before any tip has touched, and its bending stress."""
        solved = self.solve(force)
        stress = -6 * solved.section_forces[..., 2].mean(axis=1) / (q.h * q.b**2)
        return Field(
            name="point A", points=self.points, cells=self.chords,
            point_data={"displacement": solved.u[:, :2]}, cell_data={"bending_stress": stress},
            units={"displacement": "m", "bending_stress": "Pa"},
        )  # fmt: skip


@dataclass(frozen=True)
class Opposite:
    """Where the normal through a tip meets a leaf: on which of its elements, and how far along.

    `direction` is the normal, `gap` [m] what the thickness leaves of the distance.
    """

    element: int
    share: float
    direction: tuple[float, float]
    gap: float


def opposite(points: Any, leaf: Any, tip: int, normal: Normal, b: float) -> Opposite:
    """The place of `leaf` (m, 2) that faces the node `tip` of a leaf along y, b thick."""
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
