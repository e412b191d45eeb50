"""Springs at large displacement for the cases: frames, and where a head let go would give way."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.optimize import brentq
from scipy.sparse.linalg import LinearOperator, eigsh, splu

if TYPE_CHECKING:
    from fem.beam.large import LargeFrame
    from fem.beam.large_state import State

LOCATED = 1e-10  # of the displacement
ORDERS = ("MMD_AT_PLUS_A", "COLAMD", "NATURAL")
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

    def flexibility(self, state: "State", order: str = ORDERS[0]) -> Any:
        """Movement (3, 3) of the head under small loads added to those it bears, if let go.

        The `order` of elimination changes it by its rounding alone.
        """
        e = self.guided.elements
        strain, _, t = e.strains(state.exact)
        K = e.tangent_stiffness(e.increments(strain, t), strain, t, e.moduli * strain)
        free = np.ones(K.shape[0], bool)
        free[3 * self.line.nodes["tail"] + np.arange(3)] = False
        head = np.flatnonzero(np.repeat(np.arange(len(free) // 3) == self.head, 3)[free])
        loads = np.zeros((int(free.sum()), 3))
        loads[head, range(3)] = 1.0
        symmetric = {"diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}
        return splu(K[free][:, free].tocsc(), permc_spec=order, **symmetric).solve(loads)[head]

    def determinant(self, state: "State", head: str, order: str = ORDERS[0]) -> float:
        """Of the stiffness that a head of this freedom has under the loads it bears."""
        try:
            C = self.flexibility(state, order)
        except RuntimeError:  # SuperLU's word for a zero pivot: the point itself
            return 0.0
        held = C[1, 1] if head == "hinged" else 1.0  # of the rest, where y is held
        return float(held / np.linalg.det(C))

    def lateral_stiffness(self, state: "State", order: str = ORDERS[0]) -> float:
        """Of the guided head against a movement along y [force/length]."""
        return float(np.linalg.inv(self.flexibility(state, order))[1, 1])

    def linear_load(self) -> tuple[float, float]:
        """Force at which a free head's spring buckles if it does not deform before [force].

        And how much the eigenvalue of the rounded matrices differs from that of the mode's strains.
        """
        frame = self.frame("")
        e = frame.elements
        rest = frame.rest()
        strain, _, t = e.strains(rest.exact)
        S = e.increments(strain, t)
        free = ~rest.held
        K = e.tangent_stiffness(S, strain, t, 0 * strain)
        factor = splu(K[free][:, free].tocsc())
        u = np.zeros(free.size)
        u[free] = factor.solve((np.arange(free.size) == 3 * self.head)[free].astype(float))
        no_moduli = replace(e, moduli=0 * e.moduli)
        stress = e.moduli * e.change(S, u.reshape(-1, 3))
        G = no_moduli.tangent_stiffness(S, strain, t, stress)[free][:, free]
        inverse = LinearOperator(G.shape, factor.solve)
        largest, mode = eigsh(-G, 1, K[free][:, free], which="LA", Minv=inverse)
        u[free] = mode[:, 0]
        bent = e.change(S, u.reshape(-1, 3))  # the mode's own strains: K u would round
        energy = ((e.moduli * bent**2).sum(axis=-1) * e.weight).sum()
        load = float(-energy / (u[free] @ G @ u[free]))
        return load, abs(load - 1 / float(largest[0]))

    def gives_way(self, until: float) -> "tuple[float, float, State | None]":
        """Where a guided head, let go, first gives way: displacement, its rounding, and state.

        NaN and None where it does not up to `until`.

        The linear buckling load tells where to look first, and a lower one would be found: from
        rest on, the determinant changes its sign at the first such point.
        """
        load, _ = self.linear_load()
        before, at = self.guided.rest(), 0.0
        u = min(NEAR * load * float(self.flexibility(before)[0, 0]), until / STEP)
        while at < until:
            here = self.compressed([u - at], before)[0]
            if self.determinant(here, "free") <= 0:
                return self._located(before, at, u)
            before, at, u = here, u, min(STEP * u, until)
        return math.nan, 0.0, None

    def _located(self, before: "State", at: float, u: float) -> "tuple[float, float, State]":
        """Between the displacement `at` of a state before and `u` beyond."""
        found = {0.0: before}

        def beyond(step: float) -> float:
            if step not in found:
                found[step] = self.compressed([step], before)[0]
            return self.determinant(found[step], "free")

        step = float(brentq(beyond, 0.0, u - at, xtol=LOCATED * u, rtol=1e-12))
        here = found[step]
        zeros = [self.determinant(here, "free", order) for order in ORDERS]
        slope = self.determinant(before, "free") / step
        return at + step, max(map(abs, zeros)) / slope, here


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
