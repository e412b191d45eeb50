"""Beams that touch beside calculix's strips of plane strain, surface to surface by a penalty.

Its contact turns with the surfaces from one increment to the next only.
"""

from math import pi

import numpy as np
import pytest

from fem.beam.large import LargeFrame
from fem.beam.touching import SelfContact
from meshes.spring.path import Piece
from tests.fem.beam.touching_shapes import together
from verify.studies.crosscheck.calculix.large import (
    LEFT,
    RIGHT,
    STEEL,
    Held,
    Problem,
    Touching,
    faces,
    run,
)
from verify.studies.crosscheck.calculix.running import executable
from verify.studies.crosscheck.calculix.strips import (
    beams,
    plane_strain_section,
    section_held,
    strip,
)

pytestmark = pytest.mark.skipif(executable() is None, reason="calculix (ccx) is not installed")

B, R, REACH, GAP = 1.0, 10.0, 60.0, 0.5
MOVES = (2.5, 5.0, 7.5)


def loop_and_leaf():
    """A leaf clamped at the left, and above it a half circle that hangs open to the top."""
    top = R + B + GAP
    quarters = [
        Piece("arc", 40 - R, top, -pi / 2, R * pi / 2, pi / 2, 2),
        Piece("arc", 40, top - R, 0, R * pi / 2, pi / 2, 2),
    ]
    return [Piece("leaf", 0, 0, 0, REACH, 0, 1)], quarters


def loop_pressed_in_calculix(moves, friction, increment, folder):
    """Forces (k, 2) on the loop's ends, movement (k, 2) of the leaf's tip."""
    leaf, quarters = loop_and_leaf()
    below, above = strip(leaf, [24], B), strip(quarters, [12, 12], B)
    n, m = len(below.points), len(below.cells)
    ends = [above.across[0] + n, above.across[-1] + n]
    middles = [above.middle(0) + n, above.middle(-1) + n]
    answer = run(
        Problem(
            points=np.vstack([below.points, above.points]),
            cells=np.vstack([below.cells, above.cells + n]),
            held=section_held(below, 0, 0),
            steps=[[*(Held(end, 1, -move) for end in ends), Held(middles, 0)] for move in moves],
            watched=[below.middle(-1)],
            touching=[Touching(faces(range(m, m + 24), RIGHT), faces(range(m), LEFT))],
            stiffness=STEEL.E / B, friction=friction, increment=increment,
        ),
        folder / "loop.inp",
    )  # fmt: skip
    return answer.reaction, answer.u[:, 0]


@pytest.mark.parametrize(
    ("friction", "moves"),
    [
        pytest.param(0.0, MOVES, marks=pytest.mark.soak),  # calculix takes seconds
        (0.15, MOVES[:2]),
    ],
)
def test_a_loop_slides_along_the_leaf_that_it_bends_as_in_calculix(friction, moves, tmp_path):
    # their normals lag by one increment (up to 4 % of the force): order one, so that two sizes of
    # it lead to none, but for where the cells' integration points begin to touch
    coarse, fine = (
        loop_pressed_in_calculix(moves, friction, size, tmp_path) for size in (0.25, 0.125)
    )
    force, moved = (2 * np.array(f) - c for f, c in zip(fine, coarse, strict=True))
    leaf, quarters = loop_and_leaf()
    points, elements, (_, first) = together(beams(leaf, [24]), beams(quarters, [12, 12]))
    contact = SelfContact(
        points, elements, thickness=B, EA=plane_strain_section(B).EA, friction=friction
    )
    ends = [first, len(points) - 1]
    frame = LargeFrame(
        points, elements,
        sections={"leaf": plane_strain_section(B), "loop": plane_strain_section(B, R)},
        bodies={"leaf": np.arange(24), "loop": np.arange(24, 48)},
        supports={0: "xyr"} | dict.fromkeys(ends, "xr"), terms=[contact],
    )  # fmt: skip
    steps = np.arange(0.5, moves[-1] + 0.25, 0.5)
    path = frame.displaced({end: {"y": -1.0} for end in ends}, steps)
    u, own = path.u[4::5, first - 1, :2], path.reactions[4::5, ends, :2].sum(axis=1)
    np.testing.assert_allclose(force, own, atol=5e-3 * np.abs(own).max())
    np.testing.assert_allclose(moved, u, atol=5e-4 * moves[-1])
