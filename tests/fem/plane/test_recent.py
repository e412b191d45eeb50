"""What is kept between solves is found by its content, changes no result, and stays small."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2

from fem.plane import discretisation, factors
from fem.plane.factors import FACTORS
from fem.plane.material import Elastic
from fem.plane.recent import Recent
from fem.plane.solve import solve_plane

STEEL = Elastic(E=210e9, nu=0.3)


@pytest.fixture(autouse=True)
def forgotten():
    """Nothing kept from other tests."""
    FACTORS.clear()
    discretisation.NUMBERS.clear()


@pytest.fixture
def factorisations(monkeypatch):
    """The matrices that are factorised."""
    seen = []
    own = factors.Cholesky

    def counting(A, **options):
        seen.append(A)
        return own(A, **options)

    monkeypatch.setattr(factors, "Cholesky", counting)
    return seen


def plate(bend=0.0, n=6):
    """A plate on curved cells, wavy by `bend`."""
    grid = MeshQuad1.init_tensor(np.linspace(0, 2, n), np.linspace(0, 1, 4)).with_boundaries({
        "foot": lambda x: x[1] == 0, "top": lambda x: x[1] == 1
    })  # fmt: skip
    mesh = replace(MeshQuad2.from_mesh(grid), _boundaries=grid.boundaries)
    x, y = mesh.doflocs
    return replace(mesh, doflocs=np.array([x + bend * y**2, y + bend * np.sin(2 * x)]))


def pressed(mesh, material=STEEL, p=1e6, **more):
    given = {"assumption": "plane stress", "supports": {"foot": "xy"}, "pressures": {"top": p}}
    return solve_plane(mesh, materials=material, **given | more)


def same(one, other):
    return np.array_equal(one.u, other.u) and np.array_equal(one.internal, other.internal)


@pytest.mark.parametrize(
    ("other", "count"),
    [
        (lambda: pressed(plate(), p=2.5e6), 1),
        (lambda: pressed(plate(), Elastic(E=123.4e9, nu=0.3), thickness=3.0), 1),
        (lambda: pressed(plate(), Elastic(E=210e9, nu=0.3 + 1e-9)), 2),
        (lambda: pressed(plate(1e-9)), 2),
        (lambda: pressed(plate(n=7)), 2),
        (lambda: pressed(plate(), supports={"foot": "y"}, anchors={(0.0, 0.0): "x"}), 2),
    ],
    ids=["load", "modulus, thickness", "nu", "a node that moved", "more cells", "supports"],
)
def test_only_another_matrix_is_factorised_again(other, count, factorisations):
    pressed(plate())
    after = other()
    assert len(factorisations) == count
    FACTORS.clear()
    assert same(after, other())
    assert len(factorisations) == count + 1
    assert after.residual < 1e-20


def test_what_takes_too_much_room_is_not_stored_and_displaces_nothing():
    recent = Recent(most=9, room=10)
    for k, size in ((1, 4), (2, 5), (3, 11), (4, 3)):
        recent.get((k,), lambda k=k: k, lambda _, size=size: size)
    assert [entry[1] for entry in recent.kept] == [4, 2]
