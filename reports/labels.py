"""Placement of names without overlap."""

from collections.abc import Sequence

import numpy as np

Box = tuple[float, float, float, float]  # left, top, right, bottom
Place = tuple[float, float, str]  # of a text's start or end, and which of them
TALL = 12.0


def spread(
    targets: Sequence[float], room: Sequence[float], within: tuple[float, float] | None = None
) -> list[float]:
    """Centres of names in the order of `targets`, as close to the targets as possible.

    `room` contains the widths of the names, which do not overlap. The solution is by least squares:
    neighbours that would overlap form blocks, which are at the mean of their targets. `within`
    limits the centres if there is enough space.
    """
    if not len(targets):
        return []
    half = np.asarray(room, dtype=float) / 2
    offsets = np.concatenate([[0.0], np.cumsum(half[:-1] + half[1:])])
    blocks: list[list[float]] = []  # means of wishes less offsets, and how many
    for target in np.asarray(targets, dtype=float) - offsets:
        blocks.append([float(target), 1])
        while len(blocks) > 1 and blocks[-2][0] >= blocks[-1][0]:
            mean, count = blocks.pop()
            before, more = blocks[-1]
            blocks[-1] = [(mean * count + before * more) / (count + more), count + more]
    found = np.concatenate([np.full(int(count), mean) for mean, count in blocks])
    if within is not None:
        found = np.maximum(np.minimum(found, within[1] - offsets[-1]), within[0])
    return [float(v) for v in found + offsets]


def beside(x: float, y: float, wide: float, frame: Box, taken: Sequence[Box]) -> tuple[Place, Box]:
    """Place for a name beside a point, inside `frame` and, if possible, outside `taken`."""
    best: tuple[float, Place, Box] | None = None
    for down in (-6.0, 14.0, 4.0, -18.0, 26.0):
        for anchor, left in (("end", x - 7 - wide), ("start", x + 7)):
            base = y + down
            box = left, base - TALL + 2, left + wide, base + 2
            out = max(frame[0] - box[0], box[2] - frame[2], frame[1] - box[1], box[3] - frame[3], 0)
            worse = 10 * out + sum(_shared(box, other) for other in taken)
            place = x - 7 if anchor == "end" else x + 7, base, anchor
            if best is None or worse < best[0] - 1e-9:
                best = worse, place, box
    assert best is not None
    return best[1:]


def _shared(a: Box, b: Box) -> float:
    """Area that two boxes share."""
    wide, tall = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
    return max(wide, 0.0) * max(tall, 0.0)
