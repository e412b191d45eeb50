"""Model of the accordion spring for the whole curve: geometrically exact beams with contact."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from analytic.spring.loops import Tail
from analytic.spring.stages import Head
from verify.core.figures import Array

if TYPE_CHECKING:
    from fem.beam.touching_curve import Curve

SUPPORTS = {"free": "", "hinged": "y", "guided": "yr"}


@dataclass(frozen=True)
class Spring:
    """Data of the modelled spring [SI]: centre line, strip, width factor, ends, friction."""

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


def fem_compress(
    spring: Spring, U: Sequence[float] | Array, *, per_arc: int, times: float = 1.0,
    beyond: Sequence[float] | Array = (),
) -> "Curve":  # fmt: skip
    """Curve of the spring whose head is displaced to each value of U [m]; see `compress`."""
    from fem.beam.section import Section
    from fem.beam.touching_curve import TouchingLine, compress
    from meshes.spring.centre_line import centre_line

    mesh = centre_line(**spring.line, tail=spring.tail, tips=True, per_arc=per_arc,
                       per_leaf=per_arc)  # fmt: skip
    EI, G = spring.EA * spring.b**2 / 12, spring.E / (2 * (1 + spring.nu))
    section = Section(EA=spring.EA, EI=EI, GA=5 / 6 * spring.factor * G * spring.b * spring.h)
    line = TouchingLine(
        mesh.points, mesh.elements, section, thickness=spring.b, friction=spring.mu,
        units=tuple(mesh.bodies[f"unit {i}"] for i in range(1, spring.line["n"] + 1)),
        start=int(mesh.nodes["head tip"]), head=int(mesh.nodes["head"]),
        tail=int(mesh.nodes["tail"]), held=SUPPORTS[spring.head],
    )  # fmt: skip
    return compress(line, U, times=times, beyond=beyond)
