"""Cells with a projected dilatation: fields that they hold exactly, and their inf-sup constant."""

import numpy as np
import pytest
from scipy.linalg import eigh

from fem.plane.discretisation import vector_basis
from fem.plane.material import Elastic
from fem.plane.mixed import MixedCells
from fem.plane.solve import solve_plane
from tests.fem.plane.models import mapped

RUBBER = Elastic(E=1.0, nu=0.4999)
EXACT = 1e-10  # of lambda times a strain of 1
SIDES = ("left", "right", "bottom", "top")
a, b, c, d, e, f = 0.3, -0.2, 0.5, 0.4, -0.7, 0.6  # any


def quadrilateral(s, t):
    return 0.5 + 2 * s + 0.5 * t, t + 0.4 * s * t - 0.3 * s


def around_the_axis(s, t):  # from r = 0 on
    return s * (1 + 0.3 * t), t + 0.4 * s * t - 0.3 * s


def in_plane(lam, mu):
    """A quadratic field u(x), its stresses and the force per volume that it needs."""

    def u(x):
        return np.array([a * x[0] ** 2 + b * x[0] * x[1] + c * x[1] ** 2,
                         d * x[0] ** 2 + e * x[0] * x[1] + f * x[1] ** 2])  # fmt: skip

    def stress(x):
        xx, yy = 2 * a * x[0] + b * x[1], e * x[0] + 2 * f * x[1]
        xy = (b * x[0] + 2 * c * x[1] + 2 * d * x[0] + e * x[1]) / 2
        p = lam * (xx + yy)
        return np.array([p + 2 * mu * xx, p + 2 * mu * yy, 2 * mu * xy, p])

    force = (-(lam + mu) * (2 * a + e) - 2 * mu * (a + c),
             -(lam + mu) * (b + 2 * f) - 2 * mu * (d + f))  # fmt: skip
    return u, stress, force


def in_meridian(lam, mu):
    """The same in a body of revolution; u_r vanishes on the axis."""

    def u(x):
        return np.array([a * x[0] ** 2 + b * x[0] * x[1], c * x[0] ** 2 + d * x[1] ** 2])

    def stress(x):
        rr, zz, hoop = 2 * a * x[0] + b * x[1], 2 * d * x[1], a * x[0] + b * x[1]
        p, rz = lam * (rr + zz + hoop), (b + 2 * c) * x[0] / 2
        return np.array([p + 2 * mu * rr, p + 2 * mu * zz, 2 * mu * rz, p + 2 * mu * hoop])

    force = (-(lam + mu) * 3 * a - mu * 3 * a, -(lam + mu) * 2 * (b + d) - mu * (4 * c + 2 * d))
    return u, stress, force


@pytest.mark.parametrize("kind", ["quad9, straight", "tri6, straight"])
@pytest.mark.parametrize(("assumption", "place", "field"), [
    ("plane strain", quadrilateral, in_plane), ("axisymmetric", around_the_axis, in_meridian),
])  # fmt: skip
def test_quadratic_displacements_are_exact_in_straight_cells(kind, assumption, place, field):
    lam, mu = RUBBER.lame_constants(assumption)
    u, stress, force = field(lam, mu)
    mesh = mapped(kind, [0, 0.3, 0.6, 1], [0, 0.45, 1], place)
    held = {"x": lambda x: u(x)[0], "y": lambda x: u(x)[1]}
    s = solve_plane(mesh, materials=RUBBER, assumption=assumption, degree=2, body_forces=force,
                    supports=dict.fromkeys(SIDES, held))  # fmt: skip
    for samples in (s.in_body(), s.on_boundary("top"), s.at(mesh.p.mean(axis=1)[:, None])):
        np.testing.assert_allclose(samples.u, u(samples.x), atol=EXACT)
        np.testing.assert_allclose(samples.stress, stress(samples.x), atol=EXACT * lam)
    inside = s.in_body()
    xx, yy, xy, zz = inside.stress
    p = (xx + yy + zz) / 3
    shear = ((xx - p) ** 2 + (yy - p) ** 2 + (zz - p) ** 2 + 2 * xy**2) / (2 * mu)
    density = shear + p**2 / (lam + 2 * mu / 3)
    assert s.strain_energy == pytest.approx(inside.weight @ density / 2, rel=1e-9)


def inf_sup(kind, cells, turn, mixed=True):
    """Smallest sup of int q div v over the norms of linear pressures q and of displacements v.

    On a waved unit square that is held on three sides; with `turn` the left one is the axis.
    """

    def place(s, t):
        wave = 0.05 * np.sin(2 * np.pi * s) * np.sin(2 * np.pi * t)
        return s + wave, t + wave

    grid = np.linspace(0, 1, cells + 1)
    basis = vector_basis(mapped(kind, grid, grid, place), 2, turn=turn, mixed=mixed)
    held = [basis.get_dofs(("right", "bottom")).all()]
    held.append(basis.get_dofs("left").all(["u^1"] if turn else None))
    free = np.setdiff1d(np.arange(basis.N), np.concatenate(held))
    one = np.ones(basis.mesh.nelements)
    shear, both = (
        MixedCells.of(basis, lam * one, one, turn=turn).stiffness().toarray()[np.ix_(free, free)]
        for lam in (0.0, 1.0)
    )
    pressures = 3 * basis.mesh.nelements
    return np.sqrt(max(eigh(both - shear, shear, eigvals_only=True)[-pressures], 0.0))


@pytest.mark.parametrize("turn", [False, True])
@pytest.mark.parametrize("kind", ["quad9", "tri6"])
def test_the_inf_sup_constant_does_not_fall_with_the_mesh(kind, turn):
    coarse, fine = (inf_sup(kind, n, turn) for n in (2, 8))
    assert coarse > 0.3
    assert fine > 0.95 * coarse


def test_six_nodes_are_too_few_for_linear_pressures():
    assert inf_sup("tri6", 4, turn=False, mixed=False) < 1e-6
