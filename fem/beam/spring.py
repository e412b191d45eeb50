"""Strip spring that is compressed until it touches itself, solved with finite elements."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from fem.beam.section import Array, Section
from fem.beam.touching_curve import Curve, TouchingLine, compress

HEADS = {"free": "", "hinged": "y", "guided": "yr"}


def compress_spring(
    line: Any, U: Sequence[float] | Array, *, b: float, h: float, E: float, nu: float,
    mu: float = 0.0, head: str = "free",
) -> Curve:  # fmt: skip
    """Force-displacement curve of an accordion spring, for head displacements `U` [m] in turn.

    `line` is the centre line with free tips, `meshes.spring.spring_centre_line(tips=True)`. The
    strip has the thickness `b` and the width `h` [m], E [Pa], nu and the friction coefficient `mu`.
    The head is "free", "hinged" (no transverse displacement) or "guided" (also no rotation). The
    curve contains forces `F` [N] for `U` [m], contact forces `press` [N] between neighbouring
    units, and deformed shapes.

    For a wide strip, E/(1 - nu^2) can be used for E. Raises ValueError for an unknown head, a line
    without tips, or `U` that does not increase; ArithmeticError if no equilibrium is found.

    >>> from math import radians
    >>> from meshes.spring import spring_centre_line
    >>> path = {"n": 2, "L1": 11.6e-3, "radius": 0.5e-3, "alpha": radians(80), "tail": "arc"}
    >>> line = spring_centre_line(**path, tips=True, per_arc=2, per_leaf=2)
    >>> curve = compress_spring(line, [0.2e-3, 2.2e-3], b=0.1e-3, h=56e-3, E=206e9, nu=0.3)
    >>> bool(curve.F[1] / curve.U[1] > curve.F[0] / curve.U[0])  # the leaves support each other
    True
    """
    if head not in HEADS:
        raise ValueError(f"head must be one of {', '.join(HEADS)}, got {head!r}")
    if "head tip" not in line.nodes:
        raise ValueError("the centre line must have free tips that can touch: use tips=True")
    if not np.all(np.diff([0.0, *U]) > 0):
        raise ValueError(f"displacements U [m] must be positive and ascending, got {list(U)}")
    A, G = b * h, E / (2 * (1 + nu))
    units = sorted((n for n in line.bodies if n.startswith("unit ")), key=lambda n: int(n[5:]))
    return compress(
        TouchingLine(
            line.points, line.elements, Section(EA=E * A, EI=E * A * b**2 / 12, GA=5 / 6 * G * A),
            thickness=b, friction=mu, units=tuple(line.bodies[name] for name in units),
            start=int(line.nodes["head tip"]), head=int(line.nodes["head"]),
            tail=int(line.nodes["tail"]), held=HEADS[head],
        ), U,
    )  # fmt: skip
