"""What a body of revolution has exactly on any mesh: constant stress, weak forms, no strain."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from skfem import BilinearForm, LinearForm, MeshQuad1, MeshQuad2, MeshTri1, MeshTri2
from skfem.helpers import ddot, div, sym_grad

from fem.plane.cells import Cells
from fem.plane.discretisation import vector_basis
from fem.plane.loads import moduli
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

E, NU = 210e9, 0.3
ROUND_OFF = 1e-12  # relative
KINDS = {
    "tri3": (MeshTri1, MeshTri1, 1),
    "tri6, straight": (MeshTri1, MeshTri1, 2),
    "tri6": (MeshTri1, MeshTri2, 2),
    "quad4": (MeshQuad1, MeshQuad1, 1),
    "quad9, straight": (MeshQuad1, MeshQuad1, 2),
    "quad9": (MeshQuad1, MeshQuad2, 2),
}
# Linear displacements on curved cells hold no constant stress, but their matrices are tested.
MIXED = {"tri3 on curved": (MeshTri1, MeshTri2, 1), "quad4 on curved": (MeshQuad1, MeshQuad2, 1)}
every_cell = pytest.mark.parametrize("kind", KINDS)
also_mixed = pytest.mark.parametrize("kind", KINDS | MIXED)
any_bore = pytest.mark.parametrize("bore", [0.0, 0.5], ids=["solid", "hollow"])


@BilinearForm
def stiffness(u, v, w):
    r = w.x[0]
    hoop, trace = u[0] / r, div(u) + u[0] / r
    inner = ddot(2 * w.mu * sym_grad(u), sym_grad(v)) + 2 * w.mu * hoop * v[0] / r
    return 2 * np.pi * r * (inner + w.lam * trace * (div(v) + v[0] / r))


@LinearForm
def stress_work(v, w):
    r, u = w.x[0], w.u
    grad = u.grad
    hoop, trace = u[0] / r, grad[0, 0] + grad[1, 1] + u[0] / r
    inner = ddot(w.mu * (grad + grad.swapaxes(0, 1)), sym_grad(v)) + 2 * w.mu * hoop * v[0] / r
    return 2 * np.pi * r * (inner + w.lam * trace * (div(v) + v[0] / r))


def tube(kind, bore):
    """A tube or a bar of outer radius 2 and length 1: wavy cells within, two bodies."""
    straight, shape, _ = (KINDS | MIXED)[kind]
    grid = straight.init_tensor(np.linspace(0, 1, 7), np.linspace(0, 1, 4))
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "bore": lambda x: x[0] == 0,
        "rim": lambda x: x[0] == 1,
        "bottom": lambda x: x[1] == 0,
        "top": lambda x: x[1] == 1,
    }).with_subdomains({"west": lambda x: x[0] < 0.5, "east": lambda x: x[0] > 0.5})  # fmt: skip
    s, t = mesh.doflocs
    wave = np.sin(np.pi * s) * np.sin(np.pi * t)
    s, t = s + 0.06 * wave * np.cos(5 * t), t + 0.08 * np.sin(np.pi * t) * np.cos(4 * s)
    return replace(mesh, doflocs=np.array([bore + (2 - bore) * s, t]))


@cache
def basis_and_moduli(kind, bore):
    mesh = tube(kind, bore)
    materials = {"west": Elastic(E=3.0, nu=0.1), "east": Elastic(E=200.0, nu=0.45)}
    basis = vector_basis(mesh, (KINDS | MIXED)[kind][2], turn=True)
    lam, mu, _ = moduli(mesh, materials, "axisymmetric")
    return basis, lam, mu


def per_point(values, basis):
    return np.repeat(values[:, None], basis.X.shape[-1], axis=1)


@also_mixed
@any_bore
def test_stiffness_is_that_of_the_weak_form(kind, bore):
    basis, lam, mu = basis_and_moduli(kind, bore)
    expected = stiffness.assemble(basis, lam=per_point(lam, basis), mu=per_point(mu, basis))
    found = Cells.of(basis, lam, mu, turn=True).stiffness()
    np.testing.assert_allclose(
        found.toarray(), expected.toarray(), atol=ROUND_OFF * abs(expected).max()
    )


@also_mixed
@any_bore
def test_internal_forces_and_energy_are_those_of_the_weak_form(kind, bore):
    basis, lam, mu = basis_and_moduli(kind, bore)
    u = np.random.default_rng(3).standard_normal(basis.N)
    expected = stress_work.assemble(
        basis, u=basis.interpolate(u), lam=per_point(lam, basis), mu=per_point(mu, basis)
    )
    cells = Cells.of(basis, lam, mu, turn=True)
    np.testing.assert_allclose(
        cells.internal_forces(u), expected, atol=ROUND_OFF * abs(expected).max()
    )
    assert cells.strain_energy(u) == pytest.approx(u @ expected / 2, rel=ROUND_OFF)


@every_cell
@any_bore
def test_constant_stress_is_exact_on_wavy_cells(kind, bore):
    pressure, pull = 70e6, 40e6
    s = solve_plane(
        tube(kind, bore), materials=Elastic(E=E, nu=NU), assumption="axisymmetric",
        degree=KINDS[kind][2], supports={"bottom": "y"}, tractions={"top": (0.0, pull)},
        pressures={"rim": pressure} | ({"bore": pressure} if bore else {}),
    )  # fmt: skip
    expected = np.array([[-pressure], [pull], [0.0], [-pressure]])
    strains = (-(1 - NU) * pressure - NU * pull) / E, (pull + 2 * NU * pressure) / E
    for some in (s.in_body(), *(s.on_boundary(name) for name in ("bore", "rim", "top"))):
        np.testing.assert_allclose(
            some.stress, np.broadcast_to(expected, some.stress.shape), atol=ROUND_OFF * E * 1e-3
        )
        np.testing.assert_allclose(some.u, some.x * np.reshape(strains, (2, 1)), atol=1e-15)
    # energy is half the stress times strain on the volume 2 pi, less that of the bore
    density = (-2 * pressure * strains[0] + pull * strains[1]) / 2
    volume = np.pi * (2**2 - bore**2)
    assert s.strain_energy == pytest.approx(density * volume, rel=ROUND_OFF)
    assert s.in_body().weight.sum() == pytest.approx(volume, rel=ROUND_OFF)


@every_cell
@any_bore
def test_prescribed_movements_leave_linear_displacements_exact(kind, bore):
    s = solve_plane(
        tube(kind, bore), materials=Elastic(E=E, nu=NU), assumption="axisymmetric",
        degree=KINDS[kind][2],
        supports={
            wall: {"x": lambda x: 2e-3 * x[0], "y": lambda x: 0.1 - 1e-3 * x[1]}
            for wall in ("rim", "bottom", "top", *(["bore"] if bore else []))
        },
    )  # fmt: skip
    inside = s.in_body()
    np.testing.assert_allclose(
        inside.u, [2e-3 * inside.x[0], 0.1 - 1e-3 * inside.x[1]], rtol=0, atol=1e-14
    )


@every_cell
@any_bore
def test_a_motion_along_the_axis_however_large_gives_no_forces(kind, bore):
    basis, lam, mu = basis_and_moduli(kind, bore)
    u = np.zeros(basis.N)
    u[basis.element_dofs[1::2]] = 1e9
    cells = Cells.of(basis, lam, mu, turn=True)
    assert not np.any(cells.internal_forces(u))
    assert cells.strain_energy(u) == 0


@every_cell
def test_a_radial_shift_does_strain_a_hollow_body(kind):
    # u_r = 1: the hoop strain 1/r alone, energy = (lam + 2 mu)/2 int 2 pi / r dA = (..) pi ln 4
    mesh = tube(kind, 0.5)
    basis = vector_basis(mesh, KINDS[kind][2], turn=True)
    one = np.ones(mesh.nelements)
    u = np.zeros(basis.N)
    u[basis.element_dofs[0::2]] = 1.0
    energy = Cells.of(basis, one, one, turn=True).strain_energy(u)
    # 1/r is not exact by Gauss points: six cells over a radius that quadruples
    assert energy == pytest.approx(3 * np.pi * np.log(4), rel=2e-3)
