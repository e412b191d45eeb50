"""Beams at large displacement beside calculix's strips of plane strain.

Solids of thickness b differ from beams by the order of (b/R)^2, and of their strain squared.
"""

from math import pi

import numpy as np
import pytest

from fem.beam.large import LargeFrame
from meshes.spring.path import Piece
from verify.studies.crosscheck.calculix.large import Load, Problem, run
from verify.studies.crosscheck.calculix.running import executable
from verify.studies.crosscheck.calculix.strips import (
    beams,
    plane_strain_section,
    section_held,
    strip,
)

pytestmark = pytest.mark.skipif(executable() is None, reason="calculix (ccx) is not installed")

FACTORS = (0.25, 0.5, 0.75, 1.0)


def tips(pieces, counts, b, radius, force, folder):
    """Movement (k, 2) of the free end under the factors of a dead force, here and in calculix."""
    part = strip(pieces, counts, b)
    tip = part.middle(-1)
    steps = [[Load(tip, i, factor * force[i]) for i in (0, 1)] for factor in FACTORS]
    theirs = run(
        Problem(points=part.points, cells=part.cells, held=section_held(part, 0, 0), steps=steps,
                watched=[tip], increment=0.5),
        folder / "tip.inp",
    )  # fmt: skip
    points, elements = beams(pieces, counts)
    arcs = np.array([bool(piece.turn) for piece in pieces]).repeat(counts)
    frame = LargeFrame(
        points, elements,
        sections={"arcs": plane_strain_section(b, radius), "leaves": plane_strain_section(b)},
        bodies={"arcs": np.flatnonzero(arcs), "leaves": np.flatnonzero(~arcs)},
        supports={0: "xyr"},
    )  # fmt: skip
    path = frame.under_loads({len(points) - 1: (*force, 0.0)}, FACTORS)
    return path.u[:, -1, :2], theirs.u[:, 0]


def test_an_elastica_bends_as_in_calculix(tmp_path):
    # L/b = 100: strains of 1 %, whose squares the two count differently
    L, b = 100.0, 1.0
    force = (0.0, 4 * plane_strain_section(b).EI / L**2)
    ours, theirs = tips([Piece("leaf", 0, 0, 0, L, 0, 1)], [40], b, None, force, tmp_path)
    np.testing.assert_allclose(theirs, ours, atol=1e-4 * np.abs(ours).max())


def test_an_arc_and_a_leaf_bend_as_in_calculix(tmp_path):
    # rotations up to 1.7 rad; b/R of 0.1 and 0.05, of whose squares the difference is made
    R, L = 10.0, 60.0
    pieces = [Piece("arc", 0, 0, 0, R * pi / 2, pi / 2, 1), Piece("leaf", R, R, pi / 2, L, 0, 2)]
    apart = []
    for b in (1.0, 0.5):
        P = 4 * plane_strain_section(b).EI / L**2
        ours, theirs = tips(pieces, [16, 32], b, R, (P, -P / 2), tmp_path)
        apart.append((theirs - ours) / np.abs(ours).max())
    assert np.abs(apart[0]).max() < 4e-4
    assert np.abs(4 * apart[1] - apart[0]).max() / 3 < 1e-6  # calculix prints seven digits
