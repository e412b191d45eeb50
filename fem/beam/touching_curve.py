"""Force-displacement curve of a compressed line of beams with self-contact."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from fem.beam.large import LargeFrame
from fem.beam.large_state import BeamState
from fem.beam.section import Array, Indices, Section
from fem.beam.touching import SHARE, SelfContact
from fem.beam.touching_record import Record
from fem.beam.two_lines import TWICE

STORED = ("U", "F", "side", "press", "depth", "work", "stored", "dissipated", "negative")


@dataclass(frozen=True)
class TouchingLine:
    """Line of quadratic `elements` (m, 3: ends and middle) that may touch itself.

    All elements have the same `section`. `thickness` and the coefficient `friction` are those of
    the strip. `units` are the elements of each part of the line; each part may touch the next. The
    line begins at the node `start`, is clamped at `tail` and is displaced along x at `head`; the
    components `held` ("yr") of the head are fixed.
    """

    points: Array
    elements: Indices
    section: Section
    thickness: float
    friction: float
    units: tuple[Indices, ...]
    start: int
    head: int
    tail: int
    held: str

    @property
    def order(self) -> Indices:
        """Nodes in their order along the line."""
        after = {int(first): (int(middle), int(end)) for first, end, middle in self.elements}
        order = [self.start]
        while order[-1] in after:
            order += after[order[-1]]
        return np.array(order)


@dataclass(frozen=True)
class Curve:
    """States (k,) of a line while its head is displaced, with forces and contacts in SI units.

    `side` is the transverse force at the clamped tail, `press` (k, units - 1) the normal force
    between neighbouring units, `depth` the largest overlap, `negative` the number of unstable
    directions. `shapes` (k, nodes, 2) are deformed shapes, `touches` the contact points in each
    state.
    """

    U: Array
    F: Array
    side: Array
    press: Array
    depth: Array
    work: Array
    stored: Array
    dissipated: Array
    negative: Array
    shapes: Array
    touches: tuple[Array, ...]
    nodes: Indices  # in the order of the line

    def arrays(self, name: str) -> dict[str, Array]:
        """Arrays of the curve, with names that begin with `name`.

        The nodes of the deformed shapes have the order of the line.
        """
        return {
            **{f"{name} {key}": getattr(self, key) for key in STORED},
            f"{name} shapes": self.shapes[:, self.nodes],
            f"{name} touches": np.array([
                (k, *at) for k, places in enumerate(self.touches) for at in places
            ]).reshape(-1, 3),
        }  # fmt: skip

    @property
    def forces(self) -> Array:
        """U, F and the sum of the normal forces (3, k)."""
        return np.array([self.U, self.F, self.press.sum(axis=1)])


def compress(
    line: TouchingLine, U: Sequence[float] | Array, *, times: float = 1.0,
    beyond: Sequence[float] | Array = (),
) -> Curve:  # fmt: skip
    """Curve of the line while its head is displaced to each of the displacements `U` [m] in turn.

    `times` is a factor of the default contact stiffness. After the last `U`, the curve continues
    with the displacements `beyond` until the force is twice the force at the last `U`. If no
    equilibrium is found at a displacement in `beyond`, the curve ends before it; this end is not a
    property of the line.

    Raises ArithmeticError if no equilibrium is found at a displacement in `U`.
    """
    contact = SelfContact(
        line.points, line.elements, thickness=line.thickness, EA=line.section.EA,
        friction=line.friction, share=SHARE * times,
    )  # fmt: skip
    head = line.head
    frame = LargeFrame(
        line.points, line.elements, sections=line.section, terms=(contact,),
        supports={line.tail: "xyr", head: line.held},
    )  # fmt: skip
    states: list[BeamState] = []
    records: list[Record] = []

    def press_to(place: float) -> None:
        since = states[-1] if states else None
        step = place - (float(states[-1].u[head, 0]) if states else 0.0)
        try:
            states.append(frame.displaced({head: {"x": step}}, [1.0], since=since).last)
        except ArithmeticError as error:
            raise ArithmeticError(f"at a displacement of {place * 1e3:.4g} mm: {error}") from error
        records.append(contact.record)

    for place in U:
        press_to(float(place))
    most = TWICE * states[-1].reactions[head, 0]
    with suppress(ArithmeticError):
        for place in beyond:
            if states[-1].reactions[head, 0] > most:
                break
            press_to(float(place))
    return _curve(line, states, records)


def _curve(line: TouchingLine, states: list[BeamState], records: list[Record]) -> Curve:
    names = [str(i) for i in range(len(line.units))]
    units = dict(zip(names, line.units, strict=True))
    found = [record.pressing(units) for record in records]
    pairs = list(pairwise(names))
    return Curve(
        U=np.array([state.u[line.head, 0] for state in states]),
        F=np.array([state.reactions[line.head, 0] for state in states]),
        side=np.array([state.reactions[line.tail, 1] for state in states]),
        press=np.array([[one.get(pair, 0.0) for pair in pairs] for one in found]),
        depth=np.array([record.penetration for record in records]),
        work=np.array([state.work for state in states]),
        stored=np.array([state.strain_energy + state.term_energy for state in states]),
        dissipated=np.array([state.dissipated for state in states]),
        negative=np.array([state.negative for state in states]),
        shapes=np.array([line.points + state.u[:, :2] for state in states]),
        touches=tuple(record.at for record in records),
        nodes=line.order,
    )
