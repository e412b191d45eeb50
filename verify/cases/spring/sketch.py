"""Sketch of an accordion spring with centre line, force, clamp and lengths."""

import math
from typing import Any

import numpy as np

from analytic.spring import frame
from verify.core.figures import Sketch
from verify.form import sketches
from verify.form.sketches import arrow, leader, shape

mm = 1e-3


def sketch(q: Any) -> Sketch:
    """Sketch of the centre line to scale, with force, clamp and the lengths of the formulas."""
    line = frame.sections(frame.pieces(**q.path, tail="arc")).at.T / mm
    x, y = (place / mm for place in frame.end_point(**q.path, tail="arc"))
    line = np.vstack([[[0.0, 0.0]], line, [[x, y]]])
    (left, low), (right, high) = line.min(axis=0).tolist(), line.max(axis=0).tolist()
    L1, tall = q.L1 / mm, high - low
    wall, top, below = 0.06 * tall, high + 0.16 * tall, low - 0.25 * tall
    half = int(0.5 * len(line))
    leaf, bottom = line[half + np.argmin(abs(line[half:, 1]))], line[np.argmin(line[:, 1])]
    L0 = frame.free_length(n=q.n, b=q.b, r=q.r, L1=q.L1, alpha=q.alpha) / mm
    return sketches.sketch(
        f"centre line of the spring, to scale; section {q.b / mm:.4g} mm × {q.h / mm:.4g} mm",
        sketches.room(0.6 * tall - left, right + 0.5 * tall),
        arrow((left - 0.1 * tall, 0.0), (right + 0.2 * tall, 0.0), style="axis"),
        shape("line", line),
        arrow((-0.3 * tall, 0.0), (0.0, 0.0), "F"),
        arrow((x + wall, y), (x - wall, y), style="clamp"),
        leader((x + 0.2 * tall, y + 0.45 * tall), (x, y), "tail clamped"),
        arrow((-0.12 * tall, 0.0), (-0.12 * tall, L1 / 2), f"L_1/2 = {L1 / 2:.4g} mm", "dimension"),
        arrow((left, top), (right, top), f"L_0 = {L0:.4g} mm, n = {q.n}", "dimension"),
        leader((0.2 * (left + right), below), bottom, f"r = {q.r / mm:.4g} mm inside"),
        leader((leaf[0] + 0.35 * tall, below), leaf,
               f"leaves at α = {math.degrees(q.alpha):.4g}°"),
    )  # fmt: skip
