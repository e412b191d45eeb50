"""Beam mesh of a candidate along the true centre line, and the cross-section of the beam."""

from typing import TYPE_CHECKING

import numpy as np

from verify.studies.design.inputs import Demands
from verify.studies.design.springs import Springs, width_factors

if TYPE_CHECKING:
    from fem.beam.section import Section
    from meshes.line import LineMesh

HEAD_HELD = {"guided": "yr", "free": ""}


def strip(
    s: Springs, i: int, q: Demands, per_arc: int, *, tips: bool = False
) -> "tuple[LineMesh, Section]":
    """Mesh of candidate `i` with `per_arc` elements on each arc, and its cross-section.

    `tips` adds the free ends of the leaves to the mesh.
    """
    from fem.beam.section import Section
    from meshes.spring.centre_line import centre_line

    b = float(s.b[i])
    line = centre_line(
        n=int(s.n[i]), L1=float(s.L1[i]), radius=float(s.r[i]) + b / 2, alpha=float(s.alpha[i]),
        tail=q.tail, tips=tips, per_arc=per_arc, per_leaf=max(2, per_arc // 2),
    )  # fmt: skip
    factor = float(width_factors(s[np.array([i])], q)[0])
    E, G, A = q.E * factor, q.E / (2 * (1 + q.nu)), b * q.h
    return line, Section(EA=E * A, EI=E * A * b**2 / 12, GA=G * A * 5 / 6)
