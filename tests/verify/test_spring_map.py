"""Where Eqs. 1-9 hold: faults turn rows red; odd springs; what is refused; cells of the maps."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.spring import energy
from fem.beam.pressed import PressedFrame
from fem.beam.pressed_path import UnstableError, stable_forces
from verify.cases.spring.map import fem, formulas
from verify.cases.spring.map.case import DEEP_MAP, MAP, MapSpring
from verify.cases.spring.map.formulas import pressed
from verify.cases.spring.map.inputs import (
    DEEP_LEAVES,
    DEEP_SLENDER,
    SHARES,
    Cell,
    points,
    slender,
)
from verify.core.case import Context
from verify.core.inputs import InputError, build
from verify.core.results import Status

pytestmark = pytest.mark.xdist_group("spring-map")

PAPER = {"n": 10, "b": "0.1 mm", "h": "56 mm", "r": "0.45 mm", "L1": "11.6 mm", "alpha": "80 deg",
         "E": "206 GPa", "nu": 0.3, "x_r": "8.3 mm", "y_r": "0.56 mm",
         "kappa": "0.012 1/mm"}  # fmt: skip
GUIDED = "force of the guided head at 30% of its length"
ACROSS = "force across, where the roller's way ends"
CLAIM = "Eqs. 1-9 are within 10 % from L_0/b = 240 on, n <= 24, small displacement"
FALLS = "error of Eqs. 1-9 at small displacement falls as L_0/b grows on one centre line"
TESTS = "Eq. 9 against Eq. 10 at the tests' largest force"


def own(**changes):
    return build(MapSpring, PAPER | changes, "my.toml")


@pytest.fixture
def fresh():
    """Values of the elastica that a fault may have changed are not kept."""
    pressed.cache_clear()
    yield
    pressed.cache_clear()


def test_no_row_is_red_on_the_paper_s_inputs(judged, red):
    assert not red(judged(MAP))


def stiffer(factor, **changes):
    """Eq. 9 times a factor, or of a geometry that changes follow from."""

    def fault(right):
        def wrong(**k):
            return factor * right(**k | {name: make(k) for name, make in changes.items()})

        return wrong

    return fault


def elastica_of(**changes):
    """The elastica of another strip."""

    def fault(right):
        def wrong(parts, **k):
            return right(parts, **k | {name: make(k) for name, make in changes.items()})

        return wrong

    return fault


FAULTS = [
    pytest.param(formulas, "Elastica", elastica_of(EI=lambda k: 1.003 * k["EI"]), GUIDED,
                 id="E I 0.3 % too large"),
    pytest.param(formulas, "Elastica", elastica_of(EI=lambda k: k["EI"] / 0.91), ACROSS,
                 id="a wide strip"),
    pytest.param(energy, "stiffness", stiffer(1.05), CLAIM, id="Eq. 9 5 % too stiff"),
    pytest.param(energy, "stiffness", stiffer(0.95), FALLS, id="Eq. 9 5 % too soft"),
    pytest.param(energy, "stiffness", stiffer(1.0, alpha=lambda k: np.pi / 2 - k["alpha"]), CLAIM,
                 id="sine for cosine"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FAULTS)
def test_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, judged, red, monkeypatch, fresh
):
    judged(MAP)
    pressed.cache_clear()
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    found = judged(replace(MAP, figures=lambda _: (), tables=lambda _: ()))
    assert row in {r.quantity for r in red(found)}


def test_another_radius_of_the_elastica_is_not_that_of_the_beams(judged, red, monkeypatch, fresh):
    judged(MAP)
    pressed.cache_clear()
    right = formulas.frame.pieces
    monkeypatch.setattr(
        formulas.frame, "pieces", lambda **k: right(**k | {"radius": 0.9 * k["radius"]})
    )
    found = judged(replace(MAP, figures=lambda _: (), tables=lambda _: ()))
    assert GUIDED in {r.quantity for r in red(found)}


def stiffer_section(right):
    def wrong(*shape):
        one = right(*shape)
        return replace(one, section=replace(one.section, EI=1.003 * one.section.EI))

    return wrong


FE_FAULTS = [
    pytest.param(fem, "spring", stiffer_section, GUIDED, id="E I 0.3 % too large"),
    pytest.param(PressedFrame, "frame", lambda f: lambda self, head: f(self, head.strip("r")),
                 ACROSS, id="the guide lets the head turn"),
]  # fmt: skip


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), FE_FAULTS)
def test_wrong_finite_elements_turn_rows_red(owner, name, fault, row, monkeypatch, fresh):
    monkeypatch.setattr(owner, name, fault(vars(owner)[name]))
    monkeypatch.setattr(fem, "MAPPED", 0)  # maps are not asked
    q = MapSpring()
    levels = [MAP.reference(q, level) for level in (4, 8, 16)]
    (check,) = (c for c in MAP.checks if c.name == row)
    assert check.rows(Context(MAP.id, q, MAP.analytic(q), levels, True))[0].status is Status.FAIL


def test_the_printed_six_per_cent_are_noted(judged):
    (row,) = (r for r in judged(MAP).rows if r.quantity == TESTS)
    assert row.status is Status.NOTE
    assert row.analytic == pytest.approx(7.95, abs=0.01)


ODD = [
    pytest.param({"n": 9}, id="odd n"),
    pytest.param({"n": 5, "x_r": "4 mm"}, id="short"),
    pytest.param({"n": 24}, id="long"),
    pytest.param({"n": 200}, id="many"),
    pytest.param({"alpha": "90 deg", "x_r": "4 mm", "y_r": "0 mm"}, id="upright leaves"),
    pytest.param({"b": "0.44 mm"}, id="thick"),
    pytest.param({"b": "0.001 mm"}, id="foil"),
    pytest.param({"r": "4 mm", "L1": "8.1 mm"}, id="round"),
    pytest.param({"E": "0.01 GPa", "nu": 0.0}, id="soft"),
]


@pytest.mark.parametrize("change", ODD)
def test_odd_springs_have_finite_values(change):
    q = own(**change)
    with np.errstate(over="raise", divide="raise", invalid="raise"):  # as the command does
        v = MAP.analytic(q)
        list(q.warnings())
        assert all(len(row) == 4 for row in points(q, deep=False)["slender"])
    assert all(np.isfinite(x) for x in v.values())
    assert MAP.figures(Context(MAP.id, q, v, [], False)) == ()


def test_the_cells_of_a_column_have_its_slenderness():
    for n, ratio in ((4, 60.0), (24, 480.0)):
        cell = slender(MapSpring(), n, ratio)
        assert cell.length / cell.b == pytest.approx(ratio, rel=1e-9)


def test_a_cell_that_is_no_leaf_spring_is_left_out():
    assert fem.measured(MapSpring(), Cell(24, 2e-3, 0.45e-3, 11.6e-3, 1.4)) == (0, 0, 0)


LONG_LEAVES = 18, 8  # of the finer maps: alpha = 70 deg, L_1/r = 60


def test_a_cell_whose_spring_becomes_unstable_has_no_forces():
    """Before 60 % of its length the pivots' sign changes between two equilibria."""
    q = MapSpring()
    rows = [row for grid in points(q, deep=True).values() for row in grid]
    cell = rows[LONG_LEAVES[0]][LONG_LEAVES[1]]
    one = fem.spring(q, cell, 4, 2)
    U_cr = one.critical_displacement(0.6 * cell.length, 0.045 * cell.length)
    assert U_cr == pytest.approx(0.5535 * cell.length, rel=1e-4)
    assert one.critical_displacement(0.55 * cell.length, 0.04 * cell.length) is None
    with pytest.raises(UnstableError, match=r"point at 55\.4% of the length"):
        stable_forces(one, cell.length, SHARES)
    k, *secant = fem.measured(q, cell)
    assert k == pytest.approx(54.9127, rel=1e-5)
    assert secant == [0.0, 0.0]


def test_a_path_that_is_not_found_is_no_critical_point(monkeypatch):
    """The paper's spring is stable: what its solver fails at is no result of the map."""
    q = MapSpring()

    def fails(self, U, since=None):
        raise ArithmeticError("no equilibrium found")

    monkeypatch.setattr(PressedFrame, "compressed", fails)
    with pytest.raises(ArithmeticError, match="no equilibrium found") as error:
        fem.measured(q, Cell(q.n, q.b, q.r, q.L1, q.alpha))
    assert not isinstance(error.value, UnstableError)


def test_an_arc_that_is_not_followed_proves_nothing(monkeypatch):
    q = MapSpring()
    cell = Cell(q.n, q.b, q.r, q.L1, q.alpha)

    def fails(self, *_loads, **_control):
        raise ArithmeticError("no step goes on")

    for name in ("displaced", "along_arc"):
        monkeypatch.setattr("fem.beam.large.LargeFrame." + name, fails)
    with pytest.raises(ArithmeticError, match="no step goes on") as error:
        fem.measured(q, cell)
    assert not isinstance(error.value, UnstableError)


def test_forces_of_unstable_equilibria_are_no_result(monkeypatch):
    q, right = MapSpring(), PressedFrame.compressed

    def crossed(self, U, since=None):
        *before, last = right(self, U, since)
        return [*before, replace(last, negative=1)]

    monkeypatch.setattr(PressedFrame, "compressed", crossed)
    assert fem.measured(q, Cell(q.n, q.b, q.r, q.L1, q.alpha))[1:] == (0, 0)


def test_an_elastica_that_is_not_found_says_nothing_of_stability():
    """Flat leaves: Newton's method fails at these steps, beams are stable all the way."""
    q = own(alpha="30 deg", x_r="2 mm", y_r="0.1 mm")
    assert "F_0_3" not in MAP.analytic(q)
    assert q.refusal() == f"{formulas.NOT_FOUND}: check it without --fem"
    assert list(q.warnings()) == [formulas.NOT_FOUND]
    cell = Cell(q.n, q.b, q.r, q.L1, q.alpha)
    assert len(stable_forces(fem.spring(q, cell, 4, 2), cell.length, SHARES)) == 2


def test_the_finer_map_has_a_part_for_each_of_its_rows():
    rows = [row for grid in points(MapSpring(), deep=True).values() for row in grid]
    assert len(DEEP_MAP.levels) == len(rows)
    part = DEEP_MAP.reference(MapSpring(), 0).arrays["cells"]
    assert part.shape == (len(DEEP_SLENDER), 3)
    assert len(rows[-1]) == len(DEEP_LEAVES)
    assert (part > 0).all()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"x_r": "20 mm"}, r"way must be at most 0.7 of the spring's length = 17.84 mm, got x_r"),
        ({"y_r": "5 mm"}, r"taken for straight needs y_r <= 0.2 x_r, got x_r = 8.3 mm, y_r = 5 mm"),
        ({"kappa": "-1 1/mm"}, r"inputs.kappa = -1 1/mm: must be at least 0 1/mm"),
    ],
)
def test_a_way_that_cannot_be_gets_one_line(change, message):
    with pytest.raises(InputError, match=message) as caught:
        own(**change)
    assert "\n" not in str(caught.value)
