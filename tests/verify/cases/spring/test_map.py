"""Case spring-map: values of its cells, and cells without a result."""

from dataclasses import replace

import pytest

from analytic.spring import stability
from fem.beam.large import LargeFrame
from fem.beam.pressed import PressedFrame
from fem.beam.pressed_path import UnstableError, stable_forces
from tests.verify.cases.own import own
from verify.cases.spring.buckling import reference
from verify.cases.spring.buckling.case import BUCKLING, NOT_FOUND
from verify.cases.spring.buckling.formulas import critical_point
from verify.cases.spring.map import fem, formulas
from verify.cases.spring.map.case import MAP, MapSpring
from verify.cases.spring.map.inputs import (
    SHARES,
    Cell,
    points,
    slender,
)


def cell_of(q):
    return Cell(q.n, q.b, q.r, q.L1, q.alpha)


def test_a_cell_whose_spring_becomes_unstable_has_a_stiffness_but_no_forces():
    """Before 60 % of its length the pivots' sign changes between two equilibria."""
    q = MapSpring()
    rows = [row for grid in points(q, deep=True).values() for row in grid]
    cell = rows[18][8]  # alpha = 70 deg, L_1/r = 60
    one = fem.spring(q, cell, 4, 2)
    U_cr = one.critical_displacement(0.6 * cell.length, 0.045 * cell.length)
    assert U_cr == pytest.approx(0.5535 * cell.length, rel=1e-4)
    assert one.critical_displacement(0.55 * cell.length, 0.04 * cell.length) is None
    with pytest.raises(UnstableError, match=r"55\.4% of the length"):
        stable_forces(one, cell.length, SHARES)
    k, *secant = fem.measured(q, cell)
    assert k == pytest.approx(54.9127, rel=1e-5)
    assert secant == [0.0, 0.0]


def fails(self, *_given, **_more):
    raise ArithmeticError("no equilibrium found")


@pytest.mark.parametrize(
    "broken",
    [((PressedFrame, "compressed"),), ((LargeFrame, "displaced"), (LargeFrame, "along_arc"))],
    ids=["path", "arc"],
)
def test_a_path_that_is_not_found_is_no_critical_point(broken, monkeypatch):
    """The paper's spring is stable: what its solver fails at is no result of the map."""
    for owner, name in broken:
        monkeypatch.setattr(owner, name, fails)
    with pytest.raises(ArithmeticError, match="no equilibrium found") as error:
        fem.measured(MapSpring(), cell_of(MapSpring()))
    assert not isinstance(error.value, UnstableError)


def test_forces_of_unstable_equilibria_are_no_result(monkeypatch):
    q, right = MapSpring(), PressedFrame.compressed

    def crossed(self, U, since=None):
        *before, last = right(self, U, since)
        return [*before, replace(last, negative=1)]

    monkeypatch.setattr(PressedFrame, "compressed", crossed)
    assert fem.measured(q, cell_of(q))[1:] == (0, 0)


def test_an_elastica_that_is_not_found_has_no_stability():
    """Flat leaves: Newton's method fails at these steps, beams are stable to the end."""
    q = own(MAP, alpha="30 deg", x_r="2 mm", y_r="0.1 mm")
    assert "F_0_3" not in MAP.analytic(q)
    assert q.refusal() == f"{formulas.NOT_FOUND}: check it without --fem"
    assert list(q.warnings()) == [formulas.NOT_FOUND]
    one = fem.spring(q, cell_of(q), 4, 2)
    assert len(stable_forces(one, cell_of(q).length, SHARES)) == 2


def test_a_critical_point_that_is_not_found_is_no_spring_without_one(monkeypatch):
    monkeypatch.setattr(stability, "critical", fails)
    critical_point.cache_clear()
    q = own(BUCKLING)
    v = BUCKLING.analytic(q)
    assert not [key for key in v if key.startswith("U_cr")]
    assert "column_U" in v
    assert q.refusal() == f"{NOT_FOUND} (no equilibrium found): check it without --fem"
    assert list(q.warnings()) == [
        "no critical point of the elastica was found for tail = arc and mid-leaf"
    ]
    critical_point.cache_clear()
    monkeypatch.setattr(reference, "LAST", 0.01)
    with pytest.raises(ArithmeticError, match="no critical point up to a displacement of 1%"):
        reference.solve(q, 2)


def test_the_cells_of_a_column_have_its_slenderness_and_what_is_no_leaf_spring_is_left_out():
    for n, ratio in ((4, 60.0), (24, 480.0)):
        cell = slender(MapSpring(), n, ratio)
        assert cell.length / cell.b == pytest.approx(ratio, rel=1e-9)
    assert fem.measured(MapSpring(), Cell(24, 2e-3, 0.45e-3, 11.6e-3, 1.4)) == (0, 0, 0)
