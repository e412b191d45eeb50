"""Sketch of the accordion spring with whole end leaves, whose tips may touch."""

import math
from typing import Any

import numpy as np

from analytic.spring import frame
from analytic.spring.stages import stages
from verify.cases.spring.inputs import strip_of
from verify.core.figures import Sketch
from verify.form import sketches
from verify.form.sketches import arrow, leader, shape

mm = 1e-3


def sketch(q: Any) -> Sketch:
    """Sketch of the whole centre line to scale, with the gaps between tips and leaves."""
    line = frame.sections(frame.pieces(**q.path, tail="mid-leaf")).at.T / mm
    x, y = (place / mm for place in frame.end_point(**q.path, tail="mid-leaf"))
    a, toward = q.L1 / 2 / mm, -1.0 if q.n % 2 == 0 else 1.0  # direction of the tail's leaf
    tip, arc_end = y + toward * a, y - toward * a
    line = np.vstack([[[0.0, -a]], [[0.0, 0.0]], line, [[x, y]], [[x, tip]]])
    low, high = line.min(axis=0), line.max(axis=0)
    tall, right = float(high[1] - low[1]), float(high[0])
    wall, edge = 0.08 * tall, right + 0.03 * tall
    facing = (q.L1 + q.R * math.cos(q.alpha)) / math.tan(q.alpha) + q.R * (1 + math.sin(q.alpha))
    facing /= mm
    lower, upper = sorted((arc_end, tip) if q.tail == "arc" else (y - wall, y + wall))
    g_0 = stages(**q.path, **strip_of(q), head=q.head, tail=q.tail, width_factor=q.factor).gap
    below, tail_side = -a - 0.6 * tall, toward * (a + 0.5 * tall)
    return sketches.sketch(
        f"centre line with whole end leaves, head {q.head}, tail clamped at {q.tail}, to scale",
        sketches.room(1.1 * tall, right + 1.1 * tall),
        arrow((-0.1 * tall, 0.0), (right + 0.2 * tall, 0.0), style="axis"),
        shape("line", line),
        arrow((-0.35 * tall, 0.0), (0.0, 0.0), "F"),
        arrow((edge, upper), (edge, lower), style="clamp"),
        (arrow((at, -a), (at, below), style="faint") for at in (0.0, facing)),
        arrow((0.0, below), (facing, below), f"g_0 = {g_0 / mm:.3g} mm", "dimension"),
        leader((-0.3 * tall, -a - 0.15 * tall), (0.0, -a), "free tip"),
        leader((x + 0.25 * tall, tail_side), (x, tip),
               "free tip" if q.tail == "mid-leaf" else "clamped leaf"),
        arrow((-0.5 * tall, -a), (-0.5 * tall, a), f"L_1 = {2 * a:.4g} mm", "dimension"),
    )  # fmt: skip
