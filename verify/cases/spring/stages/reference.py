"""Frames of straight elements of the accordion spring; rigid links model the contact of tips."""

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.case import Level
from verify.cases.spring.stages.ends import ENDS, Ends
from verify.cases.spring.stages.inputs import StagesInputs
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.beam.linked_stages import LinkedFrame
    from fem.beam.section import Section
    from meshes.line import LineMesh

SHARES = np.linspace(0.0625, 0.6875, 11)  # over the length between head and tail
SUPPORTS = {"free": "", "hinged": "y", "guided": "yr"}


def solve(q: StagesInputs, level: int) -> Level:
    """Results of one level of the spring with all end conditions."""
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
            fields.append(field(frame, found["F_A"], q))
            curve = force_over_displacement(found, line.points[line.nodes["tail"], 0])
            u_it["force"] = float(curve[-1]) * frame.round_off
    return Level(
        h=1 / level, values=values, u_it=u_it, arrays={"force": curve}, fields=tuple(fields)
    )


def force_over_displacement(found: dict[str, float], length: float) -> Any:
    """Forces [N], (m,), at the displacements SHARES times `length`; F(U) is piecewise linear."""
    U, A, B = SHARES * length, found["U_A"], found["U_B"]
    second = np.where(U > A, found["F_A"] + found["k2"] * (U - A), found["k1"] * U)
    return np.where(U > B, found["F_B"] + found["k3"] * (U - B), second)


def linked(line: "LineMesh", section: "Section", ends: Ends, q: StagesInputs) -> "LinkedFrame":
    """Frame of the spring, with nodes where its tips will touch the leaves."""
    from fem.beam.linked_stages import LinkedFrame, opposite
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
    return LinkedFrame(
        points=cut.points, chords=cut.elements, ends=cut.ends, section=section, head=head,
        supports=dict.fromkeys(held, "xyr") | {head: SUPPORTS[ends.head]},
        links=[
            replace(link, first=int(i), second=int(j))
            for link, (i, j) in zip(places, cut.ends, strict=True)
        ],
    )  # fmt: skip


def field(frame: "LinkedFrame", force: float, q: StagesInputs) -> Field:
    """Displacements and bending stress of the spring under `force`, before a tip touches."""
    solved = frame.solve(force)
    stress = -6 * solved.section_forces[..., 2].mean(axis=1) / (q.h * q.b**2)
    return Field(
        name="point A", points=frame.points, cells=frame.chords,
        point_data={"displacement": solved.u[:, :2]}, cell_data={"bending_stress": stress},
        units={"displacement": "m", "bending_stress": "Pa"},
    )  # fmt: skip
