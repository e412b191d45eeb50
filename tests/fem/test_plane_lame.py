"""Rings under pressure against Lame's closed form (Timoshenko & Goodier, art. 28).

An error counts as an error of the solver as soon as it stops falling at the element's own rate:
every quantity is followed over three meshes, each twice as fine as the one before.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

R_I, R_O, P_I, P_O = 0.04, 0.06, 90e6, 20e6  # a sleeve [m, Pa]
STEEL = Elastic(E=210e9, nu=0.3)
KINDS = {
    "tri3": (MeshTri1, MeshTri1, 1),
    "tri6": (MeshTri1, MeshTri2, 2),
    "quad4": (MeshQuad1, MeshQuad1, 1),
    "quad9": (MeshQuad1, MeshQuad2, 2),
    "tri6 with straight edges": (MeshTri1, MeshTri1, 2),
    "quad9 with straight edges": (MeshQuad1, MeshQuad1, 2),
}
# u of degree k is off by h^(k+1) in itself and by h^(2k) in energies; chords for arcs cost h^2
ORDER = {"tri3": 2, "quad4": 2, "tri6": 4, "quad9": 4}
ORDER |= {"tri6 with straight edges": 2, "quad9 with straight edges": 2}
SPREAD = 0.25  # of an observed order over two halvings that start with 2 cells through the wall
every_element = pytest.mark.parametrize("kind", ORDER)
both_assumptions = pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])


def exact(r, assumption):
    """Radial displacement, radial and hoop stress."""
    a = (P_I * R_I**2 - P_O * R_O**2) / (R_O**2 - R_I**2)
    b = (P_I - P_O) * R_I**2 * R_O**2 / (R_O**2 - R_I**2)
    E, nu = STEEL.E, STEEL.nu
    if assumption == "plane strain":
        E, nu = E / (1 - nu**2), nu / (1 - nu)
    return ((1 - nu) * a * r + (1 + nu) * b / r) / E, a - b / r**2, a + b / r**2


@cache
def ring(kind, assumption, through):
    straight, shape, degree = KINDS[kind]
    grid = straight.init_tensor(
        np.linspace(R_I, R_O, through + 1), np.linspace(0, np.pi / 2, 4 * through + 1)
    )
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "bore": lambda x: x[0] == R_I,
        "rim": lambda x: x[0] == R_O,
        "y=0": lambda x: x[1] == 0,
        "x=0": lambda x: x[1] == np.pi / 2,
    })  # fmt: skip
    r, phi = mesh.doflocs
    return solve_plane(
        replace(mesh, doflocs=np.array([r * np.cos(phi), r * np.sin(phi)])),
        materials=STEEL, assumption=assumption, degree=degree,
        supports={"x=0": "x", "y=0": "y"}, pressures={"bore": P_I, "rim": P_O},
    )  # fmt: skip


def assert_order(error, order, kind, assumption):
    errors = [abs(error(ring(kind, assumption, through))) for through in (2, 4, 8)]
    observed = np.log2(errors[0] / errors[2]) / 2
    assert observed == pytest.approx(order, abs=SPREAD), errors


@both_assumptions
@every_element
def test_the_energy_converges_at_twice_the_degree(kind, assumption):
    u_i, _, _ = exact(R_I, assumption)
    u_o, _, _ = exact(R_O, assumption)
    # Clapeyron on a quarter: half the pressures' work
    energy = np.pi / 2 * (P_I * R_I * u_i - P_O * R_O * u_o) / 2
    assert_order(lambda s: s.strain_energy / energy - 1, ORDER[kind], kind, assumption)


@both_assumptions
@every_element
def test_bore_and_rim_converge_to_the_closed_form(kind, assumption):
    for wall, radius in (("bore", R_I), ("rim", R_O)):
        u, _, _ = exact(radius, assumption)

        def error(s, wall=wall, u=u):
            return s.mean_displacement(wall, lambda x: x / np.hypot(*x)) / u - 1

        # boundary means of u inherit the order of the energy: the wall's load is uniform, too
        assert_order(error, ORDER[kind], kind, assumption)


@both_assumptions
@pytest.mark.parametrize("kind", [kind for kind in KINDS if "straight" not in kind])
def test_stresses_converge_at_the_degree_everywhere_in_the_wall(kind, assumption):
    def error(s):
        inside = s.in_body()
        _, radial, hoop, shear = inside.polar()
        _, expected_radial, expected_hoop = exact(np.hypot(*inside.x), assumption)
        off = (radial - expected_radial) ** 2 + (hoop - expected_hoop) ** 2 + 2 * shear**2
        return np.sqrt(inside.mean(off)) / P_I

    assert_order(error, KINDS[kind][2], kind, assumption)


@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_the_stress_out_of_the_plane_is_the_one_the_assumption_says(kind):
    # radial + hoop = 2 a all over the wall; its mean is the pressures' virial, exact on any mesh
    a = (P_I * R_I**2 - P_O * R_O**2) / (R_O**2 - R_I**2)
    strain = ring(kind, "plane strain", 8).in_body()
    assert strain.mean(strain.stress[3]) == pytest.approx(STEEL.nu * 2 * a, rel=1e-12)
    assert not ring(kind, "plane stress", 8).in_body().stress[3].any()


@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_a_section_carries_the_pressures_on_its_half(kind):
    # the hoop stress over a cut balances P_I R_I - P_O R_O, on any mesh: equilibrium
    s = ring(kind, "plane strain", 2)
    pull = P_I * R_I - P_O * R_O
    assert s.reaction("y=0")[1] == pytest.approx(-pull, rel=1e-9)
    assert s.reaction("x=0")[0] == pytest.approx(-pull, rel=1e-9)
