"""What a body of revolution has exactly on any mesh: constant stress, weak forms, no strain."""

import numpy as np
import pytest
from skfem import BilinearForm
from skfem.helpers import ddot, div, sym_grad

from fem.plane.cells import Cells
from fem.plane.discretisation import vector_basis
from fem.plane.loads import moduli
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import KINDS, degree, mapped

E, NU = 210e9, 0.3
ROUND_OFF = 1e-12  # relative
BORES = dict(zip(KINDS, (0.0, 0.5, 0.0, 0.5, 0.0, 0.5), strict=True))  # solid and hollow in turn
every_body = pytest.mark.parametrize(("kind", "bore"), BORES.items())


@BilinearForm
def stiffness(u, v, w):
    r = w.x[0]
    hoop, trace = u[0] / r, div(u) + u[0] / r
    inner = ddot(2 * w.mu * sym_grad(u), sym_grad(v)) + 2 * w.mu * hoop * v[0] / r
    return 2 * np.pi * r * (inner + w.lam * trace * (div(v) + v[0] / r))


def tube(kind, bore):
    """A tube or a bar of outer radius 2 and length 1: wavy cells within, two bodies."""

    def place(s, t):
        wave = np.sin(np.pi * s) * np.sin(np.pi * t)
        s = s + 0.06 * wave * np.cos(5 * t)
        return bore + (2 - bore) * s, t + 0.08 * np.sin(np.pi * t) * np.cos(4 * s)

    names = ("bore", "rim", "bottom", "top")
    return mapped(kind, np.linspace(0, 1, 7), np.linspace(0, 1, 4), place, names, split=0.5)


@every_body
def test_stiffness_forces_and_energy_are_those_of_the_weak_form(kind, bore):
    mesh = tube(kind, bore)
    materials = {"west": Elastic(E=3.0, nu=0.1), "east": Elastic(E=200.0, nu=0.45)}
    basis = vector_basis(mesh, degree(kind), turn=True)
    lam, mu, _ = moduli(mesh, materials, "axisymmetric")
    points = (1, basis.X.shape[-1])
    K = stiffness.assemble(
        basis, lam=np.tile(lam[:, None], points), mu=np.tile(mu[:, None], points)
    )
    cells = Cells.of(basis, lam, mu, turn=True)
    scale = abs(K).max()
    np.testing.assert_allclose(cells.stiffness().toarray(), K.toarray(), atol=ROUND_OFF * scale)
    u = np.random.default_rng(3).standard_normal(basis.N)
    np.testing.assert_allclose(cells.internal_forces(u), K @ u, atol=10 * ROUND_OFF * scale)
    assert cells.strain_energy(u) == pytest.approx(u @ (K @ u) / 2, rel=ROUND_OFF)
    along = np.zeros(basis.N)
    along[basis.element_dofs[1::2]] = 1e9  # a motion along the axis, however large
    assert not np.any(cells.internal_forces(along))
    assert cells.strain_energy(along) == 0


@every_body
def test_constant_stress_is_exact_on_wavy_cells(kind, bore):
    pressure, pull = 70e6, 40e6
    s = solve_plane(
        tube(kind, bore), materials=Elastic(E=E, nu=NU), assumption="axisymmetric",
        degree=degree(kind), supports={"bottom": "y"}, tractions={"top": (0.0, pull)},
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
