"""Frames of straight and of curved elements of the accordion spring under 1 N."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.case import Level
from verify.cases.spring.inputs import SpringInputs
from verify.core.figures import Array, Field

if TYPE_CHECKING:
    from fem.beam.section import FrameSolution, Section
    from meshes.line import LineMesh

HEAD_SUPPORTS = {"free": "", "hinged": "y", "guided": "yr"}
TAIL_SUPPORTS = {"clamped": "xyr", "hinged": "xy"}


def solve(springs: Iterable[Any], level: int) -> Level:
    """Stiffnesses of all `springs` on one level; bending moments of the first spring."""
    from fem.beam.straight import solve_frame
    from fem.unit_load import stiffness

    values: dict[str, float] = {}
    u_it: dict[str, float] = {}
    arrays: dict[str, Array] = {}
    fields = []
    for q in springs:
        line = line_of(q, level)
        points, chords = line.chords
        thin, _ = sections(q)
        straight = solve_frame(points, chords, sections=thin, **held_and_pulled(q, line))
        curved = curved_frame(q, line)
        for name, solved in ((q.ends.named("k_N"), straight), (q.ends.named("k_V"), curved)):
            values[name], u_it[name] = stiffness(solved)
        if not arrays:
            moments = moments_at(apexes(q), straight)
            arrays["moments"] = moments
            u_it["moments"] = float(abs(moments).max()) * straight.residual**0.5
        fields.append(bending_field(q, line, curved))
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=tuple(fields[:2]))


def solve_curved(q: Any, level: int) -> Level:
    """Stiffness of a spring by curved elements."""
    from fem.unit_load import stiffness

    key = q.ends.named("k_V")
    k, u_it = stiffness(curved_frame(q, line_of(q, level)))
    return Level(h=1 / level, values={key: k}, u_it={key: u_it})


def line_of(q: Any, level: int) -> "LineMesh":
    """Mesh of the centre line of `q` with `level` quadratic elements along each arc."""
    from meshes.spring.centre_line import centre_line

    ends = q.ends
    return centre_line(**q.lengths, tail=ends.tail, per_arc=level, per_leaf=max(1, level // 2))


def curved_frame(q: Any, line: "LineMesh") -> "FrameSolution":
    """Solution of the frame of curved elements under 1 N."""
    from fem.beam.curved import solve_curved_frame

    _, stubby = sections(q)
    held = held_and_pulled(q, line)
    return solve_curved_frame(line.points, line.elements, sections=stubby, **held)


def sections(q: SpringInputs) -> tuple["Section", "Section"]:
    """Two sections of the strip: rigid in shear, and with shear flexibility."""
    from fem.beam.section import Section

    A, I = q.b * q.h, q.h * q.b**3 / 12  # noqa: E741
    G = q.E / (2 * (1 + q.nu))
    return Section(EA=q.E * A, EI=q.E * I), Section(EA=q.E * A, EI=q.E * I, GA=G * A * 5 / 6)


def held_and_pulled(q: Any, line: "LineMesh") -> dict[str, Any]:
    """Keyword arguments: supports at head and tail of `line`, and 1 N on the head."""
    tail, head = line.nodes["tail"], line.nodes["head"]
    supports = {tail: TAIL_SUPPORTS[q.ends.hold], head: HEAD_SUPPORTS[q.ends.head]}
    return {"supports": supports, "loads": {head: (1.0, 0.0, 0.0)}}


def apexes(q: Any) -> list[tuple[float, float]]:
    """End points [m] of all pieces (leaves and arcs) of the centre line."""
    from meshes.spring.path import accordion

    return [piece.end for piece in accordion(**q.lengths, tail=q.ends.tail)]


def moments_at(places: Sequence[tuple[float, float]], solved: Any) -> Array:
    """Bending moments [N m] under 1 N at the element ends nearest to `places`, shape (m,).

    The signs are those of Eqs. 1-5: a clockwise moment, in the sense of the force, is positive.
    """
    ends, moments = solved.stations[:, 1], -solved.section_forces[:, 1, 2]
    return np.array([moments[np.hypot(*(ends - at).T).argmin()] for at in places])


def bending_field(q: Any, line: "LineMesh", solved: "FrameSolution") -> Field:
    """Field of displacements and bending stress along the centre line."""
    stress = -6 * solved.section_forces[..., 2].mean(axis=1) / (q.h * q.b**2)
    return Field(
        name=q.ends.words, points=line.points, cells=line.elements[:, :2],
        point_data={"displacement": solved.u[:, :2]}, cell_data={"bending_stress": stress},
        units={"displacement": "m", "bending_stress": "Pa"},
    )  # fmt: skip
