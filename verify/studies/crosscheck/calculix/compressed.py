"""Complete accordion spring as a plane-strain strip that is compressed until leaves touch."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from fem.plane.material import Elastic
from meshes.spring.path import accordion
from verify.studies.crosscheck.calculix.keywords import Side
from verify.studies.crosscheck.calculix.large import (
    END,
    LEFT,
    RIGHT,
    START,
    STEEL,
    Held,
    Problem,
    Touching,
    faces,
)
from verify.studies.crosscheck.calculix.strips import section_held, strip


def compressed(
    line: Mapping[str, Any], b: float, moves: Sequence[float], *, per_arc: int = 6,
    per_leaf: int = 12, material: Elastic = STEEL,
) -> Problem:  # fmt: skip
    """Problem of a spring with a guided head and a tail that is fixed at mid-leaf.

    Each step displaces the head along x by one of the `moves`. `line` contains the arguments n, L1,
    radius and alpha of `meshes.spring.path.accordion`; the end leaves are complete. Any two
    neighbouring units may touch.
    """
    pieces = list(accordion(**line, tail="mid-leaf", tips=True))
    counts = [per_arc if piece.turn else per_leaf for piece in pieces]
    part = strip(pieces, counts, b)
    head, tail, n = counts[0], sum(counts[:-1]), line["n"]
    units: dict[int, list[int]] = {
        i: [
            cell
            for piece, own in zip(pieces, part.pieces, strict=True)
            for cell in own
            if piece.unit == i and piece.kind != "tip"
        ]
        for i in range(2, n)
    }
    units |= {1: list(part.pieces[0]), n: list(part.pieces[-1])}
    pairs = [Touching(_facing(i, units[i]), _facing(i, units[i + 1])) for i in range(1, n)]
    pairs[0].slave.append((0, START))
    pairs[-1].master.append((len(part.cells) - 1, END))
    pairs[-1] = Touching(*pairs[-1][::-1])
    return Problem(
        points=part.points, cells=part.cells, material=material,
        held=[*section_held(part, tail, 1), Held(part.across[head].tolist(), 1)],
        steps=[[Held([part.middle(head)], 0, move)] for move in moves],
        watched=[part.middle(head)], touching=pairs, stiffness=material.E / b,
    )  # fmt: skip


def _facing(unit: int, cells: Iterable[int]) -> list[Side]:
    """Faces of unit number `unit` that may touch the next unit."""
    return faces(cells, RIGHT if unit % 2 else LEFT)
