"""Sketch of the accordion spring with whole end leaves, whose tips may touch."""

import math
from typing import Any

import numpy as np

from analytic.spring import frame
from analytic.spring.stages import stages
from verify.cases.spring.inputs import strip_of
from verify.core.figures import Shape, Sketch

mm = 1e-3


def sketch(q: Any) -> Sketch:
    """The whole centre line to scale, with the gaps that the tips close."""
    line = frame.sections(frame.pieces(**q.path, tail="mid-leaf")).at.T / mm
    end = np.array(frame.end_point(**q.path, tail="mid-leaf")) / mm
    a, toward = q.L1 / 2 / mm, -1.0 if q.n % 2 == 0 else 1.0  # the tail's leaf runs this way
    tip = end + np.array([0.0, toward * a])
    line = np.vstack([[[0.0, -a]], [[0.0, 0.0]], line, [end], [tip]])
    low, high = line.min(axis=0), line.max(axis=0)
    tall, right = float(high[1] - low[1]), float(high[0])
    wall, edge = 0.08 * tall, 0.03 * tall
    facing = (q.L1 + q.R * math.cos(q.alpha)) / math.tan(q.alpha) + q.R * (1 + math.sin(q.alpha))
    facing /= mm
    arc_end = end - np.array([0.0, toward * a])
    held = sorted([arc_end[1], tip[1]] if q.tail == "arc" else [end[1] - wall, end[1] + wall])
    g_0 = stages(**q.path, **strip_of(q), head=q.head, tail=q.tail, width_factor=q.factor).gap
    below, tail_side = -a - 0.6 * tall, toward * (a + 0.5 * tall)
    shapes = (
        Shape(style="text", points=np.array([[-1.1 * tall, 0.0]])),
        Shape(style="text", points=np.array([[right + 1.1 * tall, 0.0]])),
        Shape(style="axis", points=np.array([[-0.1 * tall, 0.0], [right + 0.2 * tall, 0.0]])),
        Shape(style="line", points=line),
        Shape(style="load", points=np.array([[-0.35 * tall, 0.0], [0.0, 0.0]]), label="F"),
        Shape(style="clamp", points=np.array([[right + edge, held[1]], [right + edge, held[0]]])),
        Shape(style="faint", points=np.array([[0.0, -a], [0.0, below]])),
        Shape(style="faint", points=np.array([[facing, -a], [facing, below]])),
        Shape(style="dimension", label=f"g_0 = {g_0 / mm:.3g} mm",
              points=np.array([[0.0, below], [facing, below]])),
        Shape(style="leader", label="free tip",
              points=np.array([[-0.3 * tall, -a - 0.15 * tall], [0.0, -a]])),
        Shape(style="leader", label="free tip" if q.tail == "mid-leaf" else "clamped leaf",
              points=np.array([[tip[0] + 0.25 * tall, tail_side], tip])),
        Shape(style="dimension", label=f"L_1 = {2 * a:.4g} mm",
              points=np.array([[-0.5 * tall, -a], [-0.5 * tall, a]])),
    )  # fmt: skip
    return Sketch(
        title=f"centre line with whole end leaves, head {q.head}, tail held at {q.tail}, to scale",
        shapes=shapes,
    )
