"""Springs at large displacement for the cases: frames, and where a released head would buckle."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.optimize import brentq
from scipy.sparse.linalg import splu

from verify.cases.spring.linear_fem import AtRest

if TYPE_CHECKING:
    from fem.beam.large import LargeFrame
    from fem.beam.large_state import State

LOCATED = 1e-13  # of the displacement
ITERATIONS = 3  # inverse ones from a mode of six digits: each gains two digits and more of its load
PLACES = 1e-11  # of a load, displacement or stiffness: nodes' places, rounded in double precision
NEAR, STEP = 0.85, 1.25  # of the linear load's displacement; from one displacement to the next


@dataclass(frozen=True)
class Spring:
    """A centre line `path` (as `meshes.spring.centre_line` takes it) of a strip, tail clamped."""

    path: dict[str, Any]
    b: float
    h: float
    E: float
    nu: float
    per_arc: int
    per_leaf: int

    @cached_property
    def line(self) -> Any:
        return line_fem(self.path, self.per_arc, self.per_leaf)

    @property
    def head(self) -> int:
        return int(self.line.nodes["head"])

    @cached_property
    def section(self) -> Any:
        A, G = self.b * self.h, self.E / (2 * (1 + self.nu))
        return section_fem(EA=self.E * A, EI=self.E * A * self.b**2 / 12, GA=5 / 6 * G * A)

    @property
    def stiffness(self) -> float:
        """Of a free head along x, at small displacement [force/length]."""
        push = {self.head: (1.0, 0.0, 0.0)}
        return stiffness_fem(self.line, self.section, {self.line.nodes["tail"]: "xyr"}, push)

    def frame(self, head: str) -> "LargeFrame":
        """A frame whose head's components in `head` are held ("yr": guided along x)."""
        supports = {self.line.nodes["tail"]: "xyr", self.head: head}
        return frame_fem(self.line, self.section, supports)

    @cached_property
    def guided(self) -> "LargeFrame":
        return self.frame("yr")

    def compressed(self, U: Iterable[float], since: "State | None" = None) -> "list[State]":
        """States of the guided spring at the displacements `U` since rest, or since a state."""
        one = {self.head: {"x": 1.0}}
        return list(self.guided.displaced(one, U, since=since).states)

    def force(self, state: "State") -> float:
        """What presses the head along x."""
        return float(state.reactions[self.head, 0])

    def head_stiffness(self, state: "State") -> tuple[Any, Any]:
        """Force and couple (3, 3) on the head per small movement of it, let go from a state.

        And its rounding (3, 3), by what it lacks in symmetry and what the last correction changed.
        Only the rest of the spring is solved
        for, so that nothing is singular where the spring buckles; what is left comes from strains
        in extended precision, since K u would round in thin strips.
        """
        e = self.guided.elements
        strain, _, t = e.strains(state.exact)
        S, stress = e.increments(strain, t), e.moduli * strain
        size = 3 * e.count
        head, tail = (3 * node + np.arange(3) for node in (self.head, self.line.nodes["tail"]))
        free = np.ones(size, bool)
        free[[*head, *tail]] = False
        symmetric = {"diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}
        K = e.tangent_stiffness(S, strain, t, stress)[free][:, free]
        factor = splu(K.tocsc(), permc_spec="MMD_AT_PLUS_A", **symmetric)
        moved = np.zeros((3, size), np.longdouble)
        moved[range(3), head] = 1.0
        forces, smallest = np.zeros((3, size)), np.inf
        while True:
            before = forces[:, head]
            forces = np.array([
                e.change_of_forces(S, strain, t, stress, u.reshape(-1, 3)) for u in moved
            ])  # fmt: skip
            step = factor.solve(-forces[:, free].T).T
            change = float(abs(step).max())
            if not change < smallest / 2:
                return self._rounded(forces[:, head], before)
            smallest = change
            moved[:, free] += step

    def _rounded(self, S: Any, before: Any) -> tuple[Any, Any]:
        """A stiffness (3, 3) and its rounding, the worst of its parts in every one."""
        size = np.sqrt(abs(np.outer(np.diag(S), np.diag(S))))
        worst = float((np.maximum(abs(S - S.T), abs(S - before)) / size).max())
        return (S + S.T) / 2, worst * size

    def determinant(self, state: "State", head: str) -> float:
        """Of the stiffness that a head of this freedom has under the loads it bears."""
        S, _ = self.head_stiffness(state)
        moving = [0, 2] if head == "hinged" else [0, 1, 2]
        return float(np.linalg.det(S[np.ix_(moving, moving)]))

    def lateral_stiffness(self, state: "State") -> tuple[float, float]:
        """Of the guided head against a movement along y, and its rounding [force/length]."""
        S, rounding = self.head_stiffness(state)
        return float(S[1, 1]), float(rounding[1, 1]) + PLACES * abs(float(S[1, 1]))

    def linear_load(self) -> tuple[float, float]:
        """Force at which a free head's spring buckles if it does not deform before [force].

        And its rounding: what the last step of inverse iteration changes of it, and nodes' places.
        """
        frame = self.frame("")
        rest, e = frame.rest(), frame.elements
        at_rest = AtRest(e, *e.strains(rest.exact), ~rest.held)
        push = (np.arange(rest.held.size) == 3 * self.head).astype(float)
        stress = e.moduli * at_rest.strains(at_rest.solve(push))
        G = at_rest.stiffness(stress, replace(e, moduli=0 * e.moduli))
        mode = at_rest.lowest(G, push)
        loads = [at_rest.load(mode, G)]
        for _ in range(ITERATIONS):
            mode = at_rest.solve(-(G @ mode.astype(float)))
            mode /= abs(mode).max()
            loads.append(at_rest.load(mode, G))
        return loads[-1], abs(loads[-1] - loads[-2]) + PLACES * loads[-1]

    def gives_way(self, until: float) -> "tuple[float, float, State | None]":
        """Where a guided head, released, first buckles: displacement, its rounding, and state.

        NaN and None where it does not up to `until`.

        The linear buckling load tells where to look first, and a lower one would be found: from
        rest on, the determinant changes its sign at the first such point.
        """
        load, _ = self.linear_load()
        before, at = self.guided.rest(), 0.0
        S, _ = self.head_stiffness(before)
        u = min(NEAR * load * float(np.linalg.inv(S)[0, 0]), until / STEP)
        while at < until:
            here = self.compressed([u - at], before)[0]
            if self.determinant(here, "free") <= 0:
                return self._located(before, at, u)
            before, at, u = here, u, min(STEP * u, until)
        return math.nan, 0.0, None

    def _located(self, before: "State", at: float, u: float) -> "tuple[float, float, State]":
        """Between the displacement `at` of a state before and `u` beyond.

        The determinant is as good as round-off there, so that its root is one number.
        """
        found = {0.0: before}

        def beyond(step: float) -> float:
            if step not in found:
                near = min(found, key=lambda known: abs(known - step))
                found[step] = self.compressed([step - near], found[near])[0]
            return self.determinant(found[step], "free")

        step = float(brentq(beyond, 0.0, u - at, xtol=LOCATED * u, rtol=1e-13))
        here = found[step]
        slope = self.determinant(before, "free") / step
        S, rounding = self.head_stiffness(here)
        lost = abs(np.linalg.det(S + rounding) - np.linalg.det(S))
        return at + step, float(lost) / slope + (LOCATED + PLACES) * u, here


def line_fem(path: dict[str, Any], per_arc: int, per_leaf: int) -> Any:
    from meshes.spring.centre_line import centre_line

    return centre_line(**path, per_arc=per_arc, per_leaf=per_leaf)


def section_fem(*, EA: float, EI: float, GA: float) -> Any:
    from fem.beam.section import Section

    return Section(EA=EA, EI=EI, GA=GA)


def frame_fem(line: Any, section: Any, supports: Mapping[int, str]) -> "LargeFrame":
    from fem.beam.large import LargeFrame

    return LargeFrame(line.points, line.elements, sections=section, supports=supports)


def stiffness_fem(
    line: Any,
    section: Any,
    supports: Mapping[int, str],
    push: Mapping[int, tuple[float, float, float]],
) -> float:
    """Of small displacements against a unit force `push` [force/length]."""
    from fem.beam.curved import solve_curved_frame

    solved = solve_curved_frame(
        line.points, line.elements, sections=section, supports=supports, loads=push
    )
    return -1 / (2 * solved.potential_energy)
