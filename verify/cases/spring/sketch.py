"""Sketch of an accordion spring: centre line, force, clamp and lengths."""

import math
from typing import Any

import numpy as np

from analytic.spring import frame
from verify.core.figures import Shape, Sketch

mm = 1e-3


def sketch(q: Any) -> Sketch:
    """The centre line to scale, with force, clamp and the lengths that the formulas name."""
    line = frame.sections(frame.pieces(**q.path, tail="arc")).at.T / mm
    end = np.array(frame.end_point(**q.path, tail="arc")) / mm
    line = np.vstack([[[0.0, 0.0]], line, [end]])
    low, high = line.min(axis=0), line.max(axis=0)
    L1, tall = q.L1 / mm, float(high[1] - low[1])
    left, right = float(low[0]), float(high[0])
    wall = 0.06 * tall
    top, foot = high[1] + 0.16 * tall, low[1]
    leaf = line[int(0.5 * len(line)) + np.argmin(abs(line[int(0.5 * len(line)) :, 1]))]
    L0 = frame.free_length(n=q.n, b=q.b, r=q.r, L1=q.L1, alpha=q.alpha) / mm
    shapes = (
        # room on both sides for the labels
        Shape(style="text", points=np.array([[left - 0.6 * tall, 0.0]])),
        Shape(style="text", points=np.array([[right + 0.5 * tall, 0.0]])),
        Shape(style="axis", points=np.array([[left - 0.1 * tall, 0.0], [right + 0.2 * tall, 0.0]])),
        Shape(style="line", points=line),
        Shape(style="load", points=np.array([[-0.3 * tall, 0.0], [0.0, 0.0]]), label="F"),
        Shape(style="clamp", points=np.array([[end[0] + wall, end[1]], [end[0] - wall, end[1]]])),
        Shape(style="leader", label="tail clamped",
              points=np.array([[end[0] + 0.2 * tall, end[1] + 0.45 * tall], end])),
        Shape(style="dimension", label=f"L_1/2 = {L1 / 2:.4g} mm",
              points=np.array([[-0.12 * tall, 0.0], [-0.12 * tall, L1 / 2]])),
        Shape(style="dimension", label=f"L_0 = {L0:.4g} mm, n = {q.n}",
              points=np.array([[left, top], [right, top]])),
        Shape(style="leader", label=f"r = {q.r / mm:.4g} mm inside",
              points=np.array([[0.2 * (left + right), foot - 0.25 * tall], _bottom(line)])),
        Shape(style="leader", label=f"leaves at α = {math.degrees(q.alpha):.4g}°",
              points=np.array([[leaf[0] + 0.35 * tall, foot - 0.25 * tall], leaf])),
    )  # fmt: skip
    strip = f"strip {q.b / mm:.4g} mm × {q.h / mm:.4g} mm"
    return Sketch(title=f"centre line of the spring, to scale; {strip}", shapes=shapes)


def _bottom(line: Any) -> Any:
    return line[int(np.argmin(line[:, 1]))]
