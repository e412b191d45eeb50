"""Force over displacement of the accordion spring by geometrically exact beams that touch."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from analytic.spring.loops import Tail
from analytic.spring.stages import Head

if TYPE_CHECKING:
    from fem.beam.large_state import State
    from fem.beam.touching_record import Record

Array = NDArray[np.float64]

SUPPORTS = {"free": "", "hinged": "y", "guided": "yr"}
STORED = ("U", "F", "side", "press", "depth", "work", "stored", "dissipated", "negative")
TWICE = 2.0  # the force that ends a curve, over that at the end of its stroke


@dataclass(frozen=True)
class Spring:
    """A spring as it is modelled [SI]: centre line, strip with its width factor, ends, friction."""

    line: dict[str, Any]
    b: float
    h: float
    E: float
    nu: float
    factor: float
    head: Head
    tail: Tail
    mu: float = 0.0

    @property
    def EA(self) -> float:
        return self.factor * self.E * self.b * self.h


@dataclass(frozen=True)
class Curve:
    """States (k,) of a spring as its head is pressed: what the head takes, what touches [SI].

    `side` is the force across at the tail's clamp, `press` (k, units - 1) the normal force between
    neighbouring units, `depth` the deepest overlap, `negative` how many ways are unstable;
    `shapes` (k, nodes, 2) and the places that touch in each state.
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
    nodes: NDArray[np.int64]  # in the order of the line

    def arrays(self, name: str) -> dict[str, Any]:
        """What is stored of the curve, under `name`; of its shapes only the centre lines."""
        return {
            **{f"{name} {key}": getattr(self, key) for key in STORED},
            f"{name} shapes": self.shapes[:, self.nodes],
            f"{name} touches": np.array([
                (k, *at) for k, places in enumerate(self.touches) for at in places
            ]).reshape(-1, 3),
        }  # fmt: skip


def fem_compress(
    spring: Spring, U: Sequence[float] | Array, *, per_arc: int, times: float = 1.0,
    beyond: Sequence[float] | Array = (),
) -> Curve:  # fmt: skip
    """The spring with its head moved to each of the displacements U [m] in turn.

    `times` is how much stiffer the contact is than usual. Displacements `beyond` the last of U
    follow until the force is TWICE that at the last of U. Where no equilibrium is found before, the
    curve ends early, which says nothing about the spring.

    Raises ArithmeticError where a state at one of U is not found.
    """
    from fem.beam.large import LargeFrame
    from fem.beam.section import Section
    from fem.beam.touching import SHARE, SelfContact
    from meshes.spring.centre_line import centre_line

    mesh = centre_line(**spring.line, tail=spring.tail, tips=True, per_arc=per_arc,
                       per_leaf=per_arc)  # fmt: skip
    EI, G = spring.EA * spring.b**2 / 12, spring.E / (2 * (1 + spring.nu))
    section = Section(EA=spring.EA, EI=EI, GA=5 / 6 * spring.factor * G * spring.b * spring.h)
    contact = SelfContact(
        mesh.points, mesh.elements, thickness=spring.b, EA=spring.EA, friction=spring.mu,
        share=SHARE * times,
    )  # fmt: skip
    head, tail = mesh.nodes["head"], mesh.nodes["tail"]
    frame = LargeFrame(
        mesh.points, mesh.elements, sections=section, terms=(contact,),
        supports={tail: "xyr", head: SUPPORTS[spring.head]},
    )  # fmt: skip
    states: list[State] = []
    records: list[Record] = []

    def press_to(place: float) -> None:
        since = states[-1] if states else None
        step = place - (float(states[-1].u[head, 0]) if states else 0.0)
        try:
            states.append(frame.displaced({head: {"x": step}}, [1.0], since=since).last)
        except ArithmeticError as error:
            raise ArithmeticError(f"pressed to {place * 1e3:.4g} mm: {error}") from error
        records.append(contact.record)

    for place in U:
        press_to(float(place))
    most = TWICE * states[-1].reactions[head, 0]
    with suppress(ArithmeticError):
        for place in beyond:
            if states[-1].reactions[head, 0] > most:
                break
            press_to(float(place))
    return _curve(mesh, states, records, spring.line["n"])


def _curve(mesh: Any, states: "list[State]", records: "list[Record]", n: int) -> Curve:
    head, tail = mesh.nodes["head"], mesh.nodes["tail"]
    units = {f"unit {i}": mesh.bodies[f"unit {i}"] for i in range(1, n + 1)}
    found = [record.pressing(units) for record in records]
    press = [[one.get((f"unit {i}", f"unit {i + 1}"), 0.0) for i in range(1, n)] for one in found]
    shapes = np.array([mesh.points + state.u[:, :2] for state in states])
    after = {int(first): (int(middle), int(end)) for first, end, middle in mesh.elements}
    order = [int(mesh.nodes["head tip"])]
    while order[-1] in after:
        order += after[order[-1]]
    return Curve(
        U=np.array([state.u[head, 0] for state in states]),
        F=np.array([state.reactions[head, 0] for state in states]),
        side=np.array([state.reactions[tail, 1] for state in states]),
        press=np.array(press),
        depth=np.array([record.penetration for record in records]),
        work=np.array([state.work for state in states]),
        stored=np.array([state.strain_energy + state.term_energy for state in states]),
        dissipated=np.array([state.dissipated for state in states]),
        negative=np.array([state.negative for state in states]),
        shapes=shapes,
        touches=tuple(record.at for record in records),
        nodes=np.array(order),
    )
