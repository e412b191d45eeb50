"""Stiffness of a part of a frame, clamped at one end, for loads at its centre."""

import numpy as np

from fem.beam.curved import solve_curved_frame
from fem.beam.section import Array, Indices, Section

Point = tuple[float, float]


def part_stiffness(
    points: Array, elements: Indices, section: Section, start: Point, end: Point
) -> dict[str, float]:
    """Stiffnesses of a part clamped at `start`, for loads midway between `start` and `end`.

    The loads are a couple ("turn"), a force along x ("axial") and a force along y ("lateral"). A
    rigid arm transmits them from the centre to `end`. `elements` (m, 3) are the elements of the
    part only.
    """
    nodes, own = np.unique(elements, return_inverse=True)
    places = points[nodes]
    first, last = (int(np.hypot(*(places - at).T).argmin()) for at in (start, end))
    p, y = end[0] - start[0], (end[1] - start[1]) / 2
    loads = {"turn": (0, 0, 1.0), "axial": (1.0, 0, y), "lateral": (0, 1.0, -p / 2)}
    found = {}
    for name, load in loads.items():
        solved = solve_curved_frame(
            places, own.reshape(elements.shape), sections=section, supports={first: "xyr"},
            loads={last: load},
        )  # fmt: skip
        found[name] = -1 / (2 * solved.potential_energy)
    return found
