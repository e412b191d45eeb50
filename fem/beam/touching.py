"""Contact of beams of finite thickness with each other and with rigid obstacles, with friction.

The classes are terms of `fem.beam.large.LargeFrame`. Surfaces are at half a thickness from the
centre line. The free end of a line is a half circle around its last node.
"""

import math
from abc import ABC, abstractmethod
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike
from scipy.sparse import csc_array

from fem.beam.large_balance import ConvergenceError
from fem.beam.section import Array, Indices
from fem.beam.terms import Positions, Term
from fem.beam.touching_law import Answer, Law
from fem.beam.touching_lines import past, touch
from fem.beam.touching_neighbours import Apart, arcs
from fem.beam.touching_pairs import Meeting, Pairs
from fem.beam.touching_passing import Passing
from fem.beam.touching_points import Probes, places, probes
from fem.beam.touching_record import OBSTACLE, Record
from fem.beam.touching_rigid import Body, Shape
from fem.beam.touching_touch import Touch, scatter

SHARE = 0.1  # contact stiffness over E h, the stiffness of a strip of h x 1 under pressure
SOFTER = 6.0  # thicknesses: longer cells bend so easily that less stiffness is enough
PROBES = 2  # of an element
NEIGHBOURS = 3.0  # thicknesses along the line within which it cannot meet itself


class Touching(Term, ABC):
    """Contact of lines with other lines or an obstacle, tested at points (probes) of the lines.

    `record` contains the contacts of the accepted state; `records` contains those of all states
    since the start of the path, beginning with the reference state.
    """

    def __init__(
        self, points: Array, elements: Indices, probes: Probes, slots: int, thickness: float,
        EA: float, friction: float, share: float,
    ) -> None:  # fmt: skip
        self.points, self.elements, self.probes = points, elements, probes
        softer = np.minimum(1.0, (SOFTER * thickness / probes.length) ** 4)
        stiffness = np.repeat(share * EA / thickness**2 * probes.length, slots)
        self.law = Law(stiffness * np.repeat(softer, slots), stiffness, friction, thickness)
        self.dissipated = 0.0
        self.records: list[Record] = []

    @property
    def record(self) -> Record:
        """Contacts of the accepted state."""
        return self.records[-1]

    def start(self, x: Array) -> None:
        self.law.start()
        self.dissipated, self.records = 0.0, []
        self._start(x)
        self.accept(x)

    def evaluate(self, x: Positions) -> tuple[float, Array, csc_array]:
        found, answer = self._answer(x)
        return answer.energy, *scatter(x.size, found.dofs, answer.force, answer.tangent)

    def settle(self, x: Positions) -> bool:
        if self.law.settle(*self._answer(x)):
            return True
        if self._passed(x.astype(float)):
            raise ConvergenceError("the step moves parts of the frame through each other")
        return False

    def accept(self, x: Positions) -> None:
        found, answer = self._answer(x)
        self.dissipated += self.law.accept(found, answer)
        near = x.astype(float)
        self.records.append(self._record(near, found, answer))
        self._keep(near)

    def reject(self) -> None:
        self.law.reject()

    def _answer(self, x: Positions) -> tuple[Touch, Answer]:
        found = self._touch(x)
        return found, self.law.answer(found)

    @abstractmethod
    def _start(self, x: Array) -> None:
        """Store the reference state `x`, at which a path begins."""

    @abstractmethod
    def _keep(self, x: Array) -> None:
        """Store the accepted state `x`, from which sides and slip are measured."""

    @abstractmethod
    def _passed(self, x: Array) -> bool:
        """True if parts passed through each other since the accepted state."""

    @abstractmethod
    def _touch(self, x: Positions) -> Touch:
        """Contacts with a normal force at `x`."""

    @abstractmethod
    def _record(self, x: Array, found: Touch, answer: Answer) -> Record:
        """Record of the contacts `found` in the accepted state."""


class SelfContact(Touching):
    """Contact between the elements of one frame.

    Parameters
    ----------
    points, elements
        Nodes (n, 2) [length] and elements (m, 2) or (m, 3) of the frame.
    thickness
        Thickness b [length]: two lines touch at the distance b.
    EA
        Axial stiffness [force] of the lines, which scales the contact stiffness.
    friction
        Coulomb's coefficient.
    apart : optional
        Points of one line are not tested for contact if the arc length between them is less than
        this [length]; by default 3 b. Elements with a common node are never tested.
    share
        Contact stiffness. The contact force per length is share x EA/b^2 x overlap; the force at
        free ends is share x EA/b x overlap. The stiffness affects the iterations, but not the
        results.
    per_element
        Number of probes per element. Each probe searches for the smallest gap in its part of the
        element.

    Raises
    ------
    ValueError
        For unknown nodes, and for values that must be positive but are not.
    """

    def __init__(
        self,
        points: ArrayLike,
        elements: ArrayLike,
        *,
        thickness: float,
        EA: float,
        friction: float = 0.0,
        apart: float | None = None,
        share: float = SHARE,
        per_element: int = PROBES,
    ) -> None:
        lines, nodes = _checked(points, elements, thickness, EA, friction, share, per_element)
        if apart is not None and not 0 <= apart < math.inf:
            raise ValueError(f"apart must be a finite length of 0 or more, got {apart}")
        own = probes(lines, nodes, thickness, per_element)
        super().__init__(lines, nodes, own, 2, thickness, EA, friction, share)
        self.thickness = thickness
        least = NEIGHBOURS * thickness if apart is None else apart
        far = Apart(lines, nodes, own, least)
        self.pairs = Pairs(nodes, own, far, thickness)
        self.arcs = arcs(lines, nodes)
        self.passing = Passing(self.arcs, far, per_element, thickness)

    def _start(self, x: Array) -> None:
        self.pairs.accept(x)
        self.passing.start(x)
        self._keep(x)

    def _keep(self, x: Array) -> None:
        self.pairs.accept(x)
        self.passing.accept(x)
        self.past = past(x, self.pairs.nearest(x), self.probes, self.arcs)

    def _passed(self, x: Array) -> bool:
        return self.passing.passed(x)

    def _touch(self, x: Positions) -> Touch:
        near = x.astype(float)
        met = self._met(near).sharpened(x, self.probes, self.elements)
        return touch(near, met, self.probes, self.arcs, self.thickness, self.past)

    def _met(self, x: Array) -> Meeting:
        met = self.pairs.nearest(x)
        return met.chosen(self.law.pressing(met.slot, met.distance + met.eased - self.thickness))

    def _record(self, x: Array, found: Touch, answer: Answer) -> Record:
        met = self._met(x)
        own = self.probes.element[met.slot // 2]
        there = places(x, self.elements[met.element], met.xi).position
        at = there + met.n * met.distance[:, None] / 2
        return Record(own, met.element, at, met.n, found.gap, answer.normal, answer.tangential,
                      answer.sticking)  # fmt: skip


class BeamObstacle(Touching):
    """Contact of lines with a rigid `shape`, a `FlatObstacle` or `DiscObstacle`.

    With a `carrier`, the shape moves and rotates with this node of the frame. Supports or
    prescribed displacements of the node then move the shape, and the reaction at the node is the
    contact force. The carrier is an end of a separate short element, because every node must belong
    to an element. `elements` may be some of the elements of the frame. For other parameters see
    `SelfContact`.

    Raises
    ------
    ValueError
        See `SelfContact`.
    """

    def __init__(
        self,
        points: ArrayLike,
        elements: ArrayLike,
        shape: Shape,
        *,
        thickness: float,
        EA: float,
        carrier: int | None = None,
        friction: float = 0.0,
        share: float = SHARE,
        per_element: int = PROBES,
    ) -> None:
        lines, nodes = _checked(points, elements, thickness, EA, friction, share, per_element)
        if carrier is not None and not 0 <= carrier < len(lines):
            raise ValueError(f"no node {carrier}: the frame has nodes 0 to {len(lines) - 1}")
        own = probes(lines, nodes, thickness, per_element)
        super().__init__(lines, nodes, own, 1, thickness, EA, friction, share)
        self.body = Body(shape, carrier, lines, own, thickness)

    def _start(self, x: Array) -> None:
        self.body.start(x)

    def _keep(self, x: Array) -> None:
        self.body.accept(x)

    def _passed(self, x: Array) -> bool:
        return self.body.passed(x)

    def _touch(self, x: Positions) -> Touch:
        near = x.astype(float)
        eta, surface = self.body.nearest(near)
        probe = np.arange(len(self.probes.length))
        pressing = self.law.pressing(
            probe, surface.distance + self.body.eased(eta) - self.body.b / 2
        )
        probe = probe[pressing]
        touch = self.body.touch(near, probe, eta, surface)
        return replace(touch, gap=self.body.gap(x, probe, eta[probe]))

    def _record(self, x: Array, found: Touch, answer: Answer) -> Record:
        eta, surface = self.body.nearest(x)
        probe, n = found.slot, self.body.normals(x, surface)[found.slot]
        here = places(x, self.probes.nodes[probe], eta[probe]).position
        at = here - n * (found.gap[:, None] + self.body.b / 2)
        none = np.full(probe.shape, OBSTACLE)
        return Record(self.probes.element[probe], none, at, n, found.gap, answer.normal,
                      answer.tangential, answer.sticking)  # fmt: skip


Obstacle = BeamObstacle  # its name in version 0.1


def _checked(
    points: ArrayLike, elements: ArrayLike, thickness: float, EA: float, friction: float,
    share: float, per_element: int,
) -> tuple[Array, Indices]:  # fmt: skip
    """Points and elements as arrays. Raises ValueError for values out of range."""
    lines, nodes = np.asarray(points, float), np.asarray(elements, int)
    if nodes.ndim != 2 or nodes.shape[1] not in (2, 3):
        raise ValueError(f"elements must have 2 or 3 nodes each, got an array {nodes.shape}")
    if unknown := sorted(set(nodes.ravel().tolist()) - set(range(len(lines)))):
        raise ValueError(f"no node {unknown[0]}: the frame has nodes 0 to {len(lines) - 1}")
    for name, value in {"thickness": thickness, "EA": EA, "share": share}.items():
        if not 0 < value < math.inf:
            raise ValueError(f"{name} must be positive and finite, got {value}")
    if not 0 <= friction < math.inf:
        raise ValueError(f"friction must be finite and 0 or more, got {friction}")
    if per_element < 1:
        raise ValueError(f"per_element, the number of probes, must be 1 or more, got {per_element}")
    return lines, nodes
