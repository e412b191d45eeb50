"""Batched cells equal the weak forms they stand for, to round-off."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import BilinearForm, LinearForm, MeshQuad1, MeshQuad2, MeshTri1, MeshTri2
from skfem.helpers import ddot, eye, sym_grad, trace

from fem.plane.cells import Cells
from fem.plane.discretisation import vector_basis
from fem.plane.material import Elastic

KINDS = {
    "tri3": (MeshTri1, MeshTri1, 1),
    "tri6, straight": (MeshTri1, MeshTri1, 2),
    "tri6": (MeshTri1, MeshTri2, 2),
    "tri3 on curved cells": (MeshTri1, MeshTri2, 1),
    "quad4": (MeshQuad1, MeshQuad1, 1),
    "quad9, straight": (MeshQuad1, MeshQuad1, 2),
    "quad9": (MeshQuad1, MeshQuad2, 2),
}
ROUND_OFF = 1e-13  # of the largest entry
every_cell = pytest.mark.parametrize("kind", KINDS)
both = pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])


@BilinearForm
def stiffness(u, v, w):
    eps = sym_grad(u)
    return ddot(w.lam * eye(trace(eps), 2) + 2 * w.mu * eps, sym_grad(v))


@LinearForm
def stress_work(v, w):
    eps = sym_grad(w.u)
    return ddot(w.lam * eye(trace(eps), 2) + 2 * w.mu * eps, sym_grad(v))


def body(kind, assumption, far=0.0):
    """Basis of wavy cells, and lambda and mu of two materials, one per cell."""
    straight, shape, degree = KINDS[kind]
    grid = straight.init_tensor(np.linspace(0, 2, 6), np.linspace(0, 1, 4))
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    x, y = mesh.doflocs
    wavy = np.array([x + 0.06 * np.sin(5 * y + x) + far, y + 0.07 * np.cos(6 * x) - far])
    soft, hard = (
        Elastic(E=E, nu=nu).lame_constants(assumption) for E, nu in ((3.0, 0.1), (200.0, 0.45))
    )
    odd = np.arange(mesh.nelements) % 2 == 1
    lam, mu = np.where(odd, np.array(soft)[:, None], np.array(hard)[:, None])
    return vector_basis(replace(mesh, doflocs=wavy), degree), lam, mu


def per_point(values, basis):
    return np.repeat(values[:, None], basis.X.shape[-1], axis=1)


@every_cell
@both
def test_stiffness_is_that_of_the_weak_form(kind, assumption):
    basis, lam, mu = body(kind, assumption)
    expected = stiffness.assemble(basis, lam=per_point(lam, basis), mu=per_point(mu, basis))
    found = Cells.of(basis, lam, mu).stiffness()
    np.testing.assert_allclose(
        found.toarray(), expected.toarray(), atol=ROUND_OFF * abs(expected).max()
    )


@every_cell
@both
def test_internal_forces_are_those_of_the_weak_form(kind, assumption):
    basis, lam, mu = body(kind, assumption)
    u = np.random.default_rng(3).standard_normal(basis.N)
    expected = stress_work.assemble(
        basis, u=basis.interpolate(u), lam=per_point(lam, basis), mu=per_point(mu, basis)
    )
    found = Cells.of(basis, lam, mu).internal_forces(u)
    np.testing.assert_allclose(found, expected, atol=ROUND_OFF * abs(expected).max())


@every_cell
def test_a_translation_however_large_gives_no_forces_at_all(kind):
    basis, lam, mu = body(kind, "plane stress")
    assert not np.any(Cells.of(basis, lam, mu).internal_forces(np.full(basis.N, 1e9)))


@every_cell
def test_cells_far_from_the_origin_are_as_stiff_as_near_it(kind):
    far, lam, mu = body(kind, "plane strain", far=1e6)
    back = far.mesh.doflocs - np.array([[1e6], [-1e6]])  # without rounding
    near = vector_basis(replace(far.mesh, doflocs=back), KINDS[kind][2])
    K, k = (Cells.of(basis, lam, mu).stiffness().toarray() for basis in (near, far))
    np.testing.assert_allclose(k, K, atol=ROUND_OFF * abs(K).max())


def test_assembly_repeats_to_the_last_bit():
    basis, lam, mu = body("quad9", "plane strain")
    first, again = (Cells.of(basis, lam, mu).stiffness() for _ in range(2))
    np.testing.assert_array_equal(first.data, again.data)
    np.testing.assert_array_equal(first.indices, again.indices)
