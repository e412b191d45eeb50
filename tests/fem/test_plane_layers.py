"""Bodies of different materials in one mesh, against closed forms that the elements meet exactly.

Throughout E1, nu1 and E2, nu2 on a strip of unit height or length; M = lambda + 2 mu.
"""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

SOFT, HARD = Elastic(E=10.0, nu=0.35), Elastic(E=70.0, nu=0.2)  # any two
ROUND_OFF = 1e-12  # relative, condition number times 1e-16
KINDS = {
    "tri3": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad4": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}
every_element = pytest.mark.parametrize("kind", KINDS)
both_assumptions = pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])


def strip(kind, interface):
    """The unit square with cells of unequal size; `interface` 0 splits x, 1 splits y, at 0.4."""
    straight, shape = KINDS[kind]
    axis = np.array([0, 0.15, 0.4, 0.6, 1.0])
    grid = straight.init_tensor(axis, axis)
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "left": lambda x: x[0] == 0,
        "right": lambda x: x[0] == 1,
        "bottom": lambda x: x[1] == 0,
        "top": lambda x: x[1] == 1,
    })  # fmt: skip
    mesh = mesh.with_boundaries({"weld": lambda x: x[interface] == 0.4}, boundaries_only=False)
    mesh = mesh.with_subdomains({
        "soft": lambda x: x[interface] < 0.4, "hard": lambda x: x[interface] > 0.4
    })  # fmt: skip
    x = mesh.doflocs.copy()  # sheared along the interface, which stays straight
    x[1 - interface] += 0.2 * x[1 - interface] * (1 - x[1 - interface]) * x[interface]
    return replace(mesh, doflocs=x)


def in_plane(material, assumption):
    """E' and nu' of sigma = E' eps along a free strip: plane stress as they are."""
    E, nu = material.E, material.nu
    return (E, nu) if assumption == "plane stress" else (E / (1 - nu**2), nu / (1 - nu))


@both_assumptions
@every_element
def test_layers_in_series_between_smooth_walls_share_the_stress(kind, assumption):
    p = 2.0
    solution = solve_plane(
        strip(kind, 0), materials={"soft": SOFT, "hard": HARD}, assumption=assumption,
        supports={"left": "x", "bottom": "n", "top": "n"}, tractions={"right": (p, 0)},
    )  # fmt: skip
    # no strain across: M = E' / (1 - nu'^2) and the wall pushes nu' p back
    (E1, nu1), (E2, nu2) = (in_plane(m, assumption) for m in (SOFT, HARD))
    stretch = p * (0.4 * (1 - nu1**2) / E1 + 0.6 * (1 - nu2**2) / E2)
    assert solution.mean_displacement("right", (1, 0)) == pytest.approx(stretch, rel=ROUND_OFF)
    assert solution.strain_energy == pytest.approx(p * stretch / 2, rel=ROUND_OFF)
    for body, nu in (("soft", nu1), ("hard", nu2)):
        stress = solution.in_body(body).stress
        np.testing.assert_allclose(stress[0], p, rtol=1e-11)
        np.testing.assert_allclose(stress[1], nu * p, rtol=1e-11)
    weld = solution.on_boundary("weld")
    np.testing.assert_allclose(weld.stress[0], p, rtol=1e-11)
    np.testing.assert_allclose(weld.stress[1], (nu1 + nu2) / 2 * p, rtol=1e-11)  # mean of both


@both_assumptions
@every_element
def test_layers_side_by_side_share_the_strain(kind, assumption):
    eps = 1e-3
    solution = solve_plane(
        strip(kind, 1), materials={"soft": SOFT, "hard": HARD}, assumption=assumption,
        supports={"left": "x", "right": {"x": eps}, "bottom": "y"}, thickness=3.0,
    )  # fmt: skip
    (E1, nu1), (E2, nu2) = (in_plane(m, assumption) for m in (SOFT, HARD))
    for body, E in (("soft", E1), ("hard", E2)):
        stress = solution.in_body(body).stress
        nu = {"soft": SOFT.nu, "hard": HARD.nu}[body] * (assumption == "plane strain")
        np.testing.assert_allclose(stress[0], E * eps, rtol=1e-11)
        np.testing.assert_allclose(stress[1:3], 0.0, atol=1e-11 * E * eps)
        np.testing.assert_allclose(stress[3], nu * E * eps, rtol=1e-11)
    pull, side, _ = solution.reaction("right")
    assert pull == pytest.approx(3.0 * (0.4 * E1 + 0.6 * E2) * eps, rel=ROUND_OFF)
    assert side == pytest.approx(0.0, abs=ROUND_OFF * pull)
    assert solution.strain_energy == pytest.approx(pull * eps / 2, rel=ROUND_OFF)
    sink = (0.4 * nu1 + 0.6 * nu2) * eps
    assert solution.mean_displacement("top", (0, -1)) == pytest.approx(sink, rel=ROUND_OFF)


@every_element
def test_cells_keep_their_material_whatever_the_order_of_the_bodies(kind):
    mesh = strip(kind, 0)
    solution = solve_plane(
        mesh, materials={"hard": HARD, "soft": SOFT}, assumption="plane stress",
        supports={"left": "x", "right": {"x": 1.0}, "bottom": "n", "top": "n"},
    )  # fmt: skip
    (E1, nu1), (E2, nu2) = (in_plane(m, "plane stress") for m in (SOFT, HARD))
    soft, hard = 0.4 * (1 - nu1**2) / E1, 0.6 * (1 - nu2**2) / E2  # compliances in series
    cut = solution.on_boundary("weld")
    assert cut.mean(cut.u[0]) == pytest.approx(soft / (soft + hard), rel=ROUND_OFF)


@both_assumptions
@every_element
def test_a_traction_on_the_weld_is_shared_by_the_springs_on_both_sides(kind, assumption):
    t = 1.5
    s = solve_plane(
        strip(kind, 0), materials={"soft": SOFT, "hard": HARD}, assumption=assumption,
        supports={"left": "x", "right": "x", "bottom": "n", "top": "n"},
        tractions={"weld": (t, 0.0)},
    )  # fmt: skip
    (E1, nu1), (E2, nu2) = (in_plane(m, assumption) for m in (SOFT, HARD))
    soft, hard = E1 / (0.4 * (1 - nu1**2)), E2 / (0.6 * (1 - nu2**2))  # stiffnesses per area
    assert s.mean_displacement("weld", (1, 0)) == pytest.approx(t / (soft + hard), rel=ROUND_OFF)
    assert s.reaction("left")[0] == pytest.approx(-t * soft / (soft + hard), rel=1e-11)
    assert s.reaction("right")[0] == pytest.approx(-t * hard / (soft + hard), rel=1e-11)
