"""The sketch of a race under its sprags."""

import numpy as np

from verify.cases.ring.loads.inputs import LoadsInputs
from verify.core.figures import Array, Shape, Sketch

mm = 1e-3


def arc(r: float, start: float = 0.0, end: float = 2 * np.pi) -> Array:
    """Points (m, 2) on a circle; angles [rad]."""
    t = np.linspace(start, end, 73)
    return np.asarray(r * np.column_stack([np.cos(t), np.sin(t)]))


def ray(angle: float, start: float, end: float) -> Array:
    return np.outer([start, end], [np.cos(angle), np.sin(angle)])


def sketch(q: LoadsInputs) -> Sketch:
    inner, pitch = q.r_i / q.r_o, np.pi / q.n
    wall = inner if q.loaded == "bore" else 1.0
    behind = -0.22 if q.loaded == "bore" else 0.22
    sector = np.vstack([arc(1.0, 0, pitch), arc(inner, pitch, 0)])
    shapes = [
        Shape(style="text", points=np.array([[-2.4, 0.0]])),  # room for the labels
        Shape(style="text", points=np.array([[2.2, 0.0]])),
        Shape(style="body", points=arc(1.0)),
        Shape(style="hole", points=arc(inner)),
        Shape(style="modelled", points=sector),
    ]
    shapes += [
        Shape(style="load", points=ray(2 * k * pitch, wall + behind, wall))
        for k in range(min(q.n, 48))
    ]
    for name, r, degrees, at in (
        (q.names[1], q.r_o, 141, 1.0), (q.names[0], q.r_i, 159, inner),
    ):  # fmt: skip
        shapes.append(
            Shape(style="leader", points=ray(np.radians(degrees), 1.5, at),
                  label=f"{name} = {r / mm:.4g} mm")
        )  # fmt: skip
    shapes.append(
        Shape(style="leader", label="FE: half a pitch",
              points=np.vstack([[1.35, 0.95], ray(pitch / 2, (1 + inner) / 2, 1.0)[0]]))
    )  # fmt: skip
    title = f"{q.n} sprags of {q.F:.4g} N on {q.L / mm:.4g} mm {_where(q)}"
    return Sketch(title=title, shapes=tuple(shapes))


def _where(q: LoadsInputs) -> str:
    return "push the bore out" if q.loaded == "bore" else "push the rim in"
