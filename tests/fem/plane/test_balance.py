"""Reactions balance loads, and bodies of several materials agree with closed forms."""

from dataclasses import replace
from math import cos, radians, sin

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import every_case, in_plane, mapped, trapezoid

MATERIAL = Elastic(E=1000.0, nu=0.3)
BALANCE = 1e-9  # of the loads; the refined solve leaves about 1e-13


def moment(at, force):
    return at[0] * force[1] - at[1] * force[0]


@every_case
def test_a_clamped_side_answers_every_kind_of_load_at_once(kind, assumption):
    p, t, w, P, thickness = 3.0, (0.5, -1.2), (0.7, -2.0), (1.1, 0.4), 0.02
    s = solve_plane(
        trapezoid(kind), materials=MATERIAL, assumption=assumption, thickness=thickness,
        supports={"left": "xy"}, pressures={"top": p}, tractions={"right": t},
        body_forces={"west": lambda x: np.array([w[0] + 0 * x[0], w[1] + 0 * x[0]]), "east": w},
        point_forces={(4, 0): P},
    )  # fmt: skip
    # by hand: the top runs from (0, 1) to (4, 3), which turned inwards is (2, -4) p; the right side
    # is 3 long; the area int (1 + x/2) dx = 8 has its centroid at (56/3, 26/3) / 8
    loads = [
        ((2.0, 2.0), (2 * p * thickness, -4 * p * thickness)),
        ((4.0, 1.5), (3 * t[0] * thickness, 3 * t[1] * thickness)),
        ((7 / 3, 13 / 12), (8 * w[0] * thickness, 8 * w[1] * thickness)),
        ((4.0, 0.0), P),
    ]
    f_x, f_y = (sum(force[i] for _, force in loads) for i in (0, 1))
    couple = sum(moment(at, force) for at, force in loads)
    assert s.reaction("left") == pytest.approx((-f_x, -f_y, -couple), rel=BALANCE)
    assert s.potential_energy == pytest.approx(-s.strain_energy, rel=BALANCE)  # Clapeyron


@every_case
def test_anchors_answer_like_a_beam_on_two_supports(kind, assumption):
    four = 10 * (0.1 + 0.2) + 1  # 4.000000000000001: found by its place, not by its last digit
    s = solve_plane(
        trapezoid(kind), materials=MATERIAL, assumption=assumption, supports={},
        anchors={(0, 0): "xy", (four, 0): {"y": 0.0}}, point_forces={(0, 1): (2.0, -10.0)},
    )  # fmt: skip
    # moments about (0, 0): 4 R - 1 * 2 = 0, as the force is 2 along x at a height of 1
    assert s.reaction_at((4, 0)) == pytest.approx((0, 2 / 4), abs=10 * BALANCE)
    assert s.reaction_at((0, 0)) == pytest.approx((-2, 10 - 2 / 4), abs=10 * BALANCE)


SOFT, HARD = Elastic(E=10.0, nu=0.35), Elastic(E=70.0, nu=0.2)  # any two
BODIES = {"west": SOFT, "east": HARD}
ROUND_OFF = 1e-12  # relative, condition number times 1e-16
AXIS = np.array([0, 0.15, 0.4, 0.6, 1.0])


def strip(kind):
    """The unit square of two bodies welded at x = 0.4, its cells sheared along the weld."""
    mesh = mapped(kind, AXIS, AXIS, split=0.4)
    mesh = mesh.with_boundaries({"weld": lambda x: x[0] == 0.4}, boundaries_only=False)
    x, y = mesh.doflocs
    return replace(mesh, doflocs=np.array([x, y + 0.2 * y * (1 - y) * x]))


@every_case
def test_layers_in_series_between_smooth_walls_share_the_stress(kind, assumption):
    p = 2.0
    solution = solve_plane(
        strip(kind), materials=BODIES, assumption=assumption,
        supports={"left": "x", "bottom": "n", "top": "n"}, tractions={"right": (p, 0)},
    )  # fmt: skip
    # no strain across: E' / (1 - nu'^2), and the wall pushes nu' p back
    (E1, nu1), (E2, nu2) = (in_plane(m, assumption) for m in (SOFT, HARD))
    stretch = p * (0.4 * (1 - nu1**2) / E1 + 0.6 * (1 - nu2**2) / E2)
    assert solution.mean_displacement("right", (1, 0)) == pytest.approx(stretch, rel=ROUND_OFF)
    assert solution.strain_energy == pytest.approx(p * stretch / 2, rel=ROUND_OFF)
    for body, nu in (("west", nu1), ("east", nu2)):
        stress = solution.in_body(body).stress
        np.testing.assert_allclose(stress[0], p, rtol=1e-11)
        np.testing.assert_allclose(stress[1], nu * p, rtol=1e-11)
    weld = solution.on_boundary("weld")
    np.testing.assert_allclose(weld.stress[0], p, rtol=1e-11)
    np.testing.assert_allclose(weld.stress[1], (nu1 + nu2) / 2 * p, rtol=1e-11)  # mean of both


def block(kind, tilt, mirror=1.0):
    """2 x 1, turned by `tilt` about the origin at its corner."""
    turn = np.array([[cos(tilt), -sin(tilt)], [sin(tilt), cos(tilt)]])
    return mapped(kind, [0, 0.6, 1.3, 2], [0, 0.4, 1], lambda x, y: turn @ [mirror * x, y])


@pytest.mark.parametrize("mirror", [1.0, -1.0], ids=["", "mirrored"])
@every_case
def test_a_tilted_block_between_two_smooth_walls_is_in_uniaxial_stress(kind, assumption, mirror):
    # mirrored its cells run clockwise
    p, tilt = 3.0, radians(135)
    s = solve_plane(
        block(kind, tilt, mirror), materials=SOFT, assumption=assumption,
        supports={"left": "n", "bottom": "n"}, pressures={"right": p},
    )  # fmt: skip
    c, n = cos(tilt), sin(tilt)
    expected = np.reshape([-p * c * c, -p * n * n, -p * c * n], (3, 1))  # -p along the block
    found = s.in_body().stress[:3]
    np.testing.assert_allclose(found, np.broadcast_to(expected, found.shape), atol=1e-11 * p)
    # the far corner moves by the strains -p / E' and nu' p / E' of lengths 2 and 1
    E, nu = in_plane(SOFT, assumption)
    along, up = mirror * -2 * p / E, nu * p / E
    x, y = s.displacement_at((mirror * 2 * c - n, mirror * 2 * n + c))
    assert (x, y) == pytest.approx((along * c - up * n, along * n + up * c), abs=1e-11)
    assert s.displacement_at((0, 0)) == pytest.approx((0, 0), abs=1e-15)
