"""Bodies of several materials, weights and smooth walls, where the elements meet closed forms."""

from dataclasses import replace
from math import cos, radians, sin

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import every_case, in_plane, mapped

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


WIDTH, WEIGHT = 3.0, 7.0  # weight per volume, along x


def column(kind):
    """A bar that hangs along x; its body "east" begins at two thirds of its length."""
    s = WIDTH * np.array([0, 1 / 6, 2 / 3, 0.8, 1])
    return mapped(kind, s, np.array([0, 0.3, 1]), split=2 / 3 * WIDTH)


@pytest.mark.parametrize(
    ("kind", "assumption"), [("tri6", "plane strain"), ("quad9", "plane stress")]
)
def test_a_heavy_column_between_smooth_walls_yields_by_a_parabola(kind, assumption):
    solution = solve_plane(
        column(kind), materials=SOFT, assumption=assumption, thickness=2.0,
        supports={"left": "x", "bottom": "n", "top": "n"},
        body_forces={"west": lambda x: np.array([-WEIGHT + 0 * x[0], 0 * x[0]]),
                     "east": (-WEIGHT, 0.0)},
    )  # fmt: skip
    E, nu = in_plane(SOFT, assumption)
    M = E / (1 - nu**2)  # of compression without side strain
    inside = solution.in_body()
    x = inside.x[0]
    np.testing.assert_allclose(inside.u[0], -WEIGHT / M * (WIDTH * x - x**2 / 2), atol=1e-11)
    np.testing.assert_allclose(inside.stress[0], -WEIGHT * (WIDTH - x), atol=1e-11 * WEIGHT)
    energy = 2.0 * WEIGHT**2 * WIDTH**3 / (6 * M)  # int xx^2 / (2 M)
    assert solution.strain_energy == pytest.approx(energy, rel=ROUND_OFF)
    assert solution.potential_energy == pytest.approx(-energy, rel=ROUND_OFF)


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
