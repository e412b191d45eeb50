"""Frames of the centre lines of springs, for large displacements."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from fem.beam.pressed import PressedFrame


def spring_fem(
    path: dict[str, Any], b: float, h: float, E: float, nu: float, *, per_arc: int, per_leaf: int
) -> "PressedFrame":
    """Frame of a strip with a clamped tail; `path` are arguments of `meshes.spring.centre_line`."""
    from fem.beam.pressed import PressedFrame
    from fem.beam.section import Section
    from meshes.spring.centre_line import centre_line

    line = centre_line(**path, per_arc=per_arc, per_leaf=per_leaf)
    A, G = b * h, E / (2 * (1 + nu))
    section = Section(EA=E * A, EI=E * A * b**2 / 12, GA=5 / 6 * G * A)
    head, tail = int(line.nodes["head"]), int(line.nodes["tail"])
    return PressedFrame(line.points, line.elements, section, head, tail)
