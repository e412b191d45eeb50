"""Lateral buckling of springs: faults turn rows red; odd springs; what is refused."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.spring import column, stability
from analytic.spring.elastica import Elastica
from verify.cases.spring.buckling import formulas, reference
from verify.cases.spring.buckling.case import BUCKLING, NOT_FOUND, BucklingSpring
from verify.cases.spring.buckling.formulas import critical_point
from verify.core.case import Context
from verify.core.inputs import InputError, build
from verify.core.results import Status

pytestmark = pytest.mark.xdist_group("spring-buckling")

PAPER = {"n": 10, "b": "0.1 mm", "h": "56 mm", "r": "0.45 mm", "L1": "11.6 mm", "alpha": "80 deg",
         "E": "206 GPa", "nu": 0.3}  # fmt: skip
U_CR = "displacement at which the spring with a free head buckles, tail held at its arc"
F_CR = "force at which the spring with a free head buckles, tail held at its arc"
COLUMN = "Haringx's column, tail held at its arc"
MANY = "Haringx's column with ever more units, tail held at its arc"


def own(**changes):
    return build(BucklingSpring, PAPER | changes, "my.toml")


def names(rows):
    return {row.quantity for row in rows}


@pytest.fixture
def fresh():
    """Values of the elastica that a fault may have changed are not kept."""
    critical_point.cache_clear()
    yield
    critical_point.cache_clear()


def test_no_row_is_red_on_the_paper_s_inputs(judged, red):
    assert not red(judged(BUCKLING))


def unit_with(**parts):
    """Units with some of their flexibilities replaced by what is made of them."""

    def fault(right):
        def wrong(**k):
            found = right(**k)
            return replace(found, **{name: make(found) for name, make in parts.items()})

        return wrong

    return fault


FAULTS = [
    pytest.param(column, "unit", unit_with(axial=lambda u: 1.001 * u.axial),
                 "stiffness of a middle unit, along", id="a unit 0.1 % too soft along"),
    pytest.param(column, "unit", unit_with(turn=lambda u: u.turn * 1.001),
                 "stiffness of a middle unit, against a couple", id="a unit 0.1 % too soft"),
    pytest.param(column, "unit", lambda f: lambda **k: f(**k | {"alpha": np.pi / 2 - k["alpha"]}),
                 "stiffness of a middle unit, across", id="sine for cosine"),
    pytest.param(column, "free_length", lambda f: lambda **k: 2 * f(**k), MANY,
                 id="twice the column's length"),
    pytest.param(column, "WAVES", lambda w: w | {"free": np.pi}, MANY, id="hinged at both ends"),
    pytest.param(column, "unit", unit_with(turn=lambda u: u.turn * 1.02), MANY,
                 id="bending 2 % too soft"),
    pytest.param(formulas, "elastica",
                 lambda f: lambda q, tail: Elastica(_parts(q, tail), EI=_EI(q) ** 2), F_CR,
                 id="E I squared"),
    pytest.param(formulas, "elastica",
                 lambda f: lambda q, tail: Elastica(_parts(q, tail), EI=_EI(q) / (1 - q.nu**2)),
                 F_CR, id="a wide strip"),
    pytest.param(formulas, "elastica",
                 lambda f: lambda q, tail: f(q.model_copy(update={"r": q.r - q.b / 2}), tail),
                 U_CR, id="the inner radius"),
    pytest.param(stability, "FREEDOM", lambda f: f | {"free": f["hinged"]}, U_CR,
                 id="a hinge for a free head"),
]  # fmt: skip


def _parts(q, tail):
    return formulas.frame.pieces(**q.path, tail=tail)


def _EI(q):
    return q.E * q.h * q.b**3 / 12


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FAULTS)
def test_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, judged, red, monkeypatch, fresh
):
    judged(BUCKLING)
    critical_point.cache_clear()
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    bare = replace(BUCKLING, figures=lambda _: (), tables=lambda _: ())
    found = judged(bare)
    assert found.errors or row in names(red(found))  # missing values are an error of the case


def test_shear_of_the_column_counts(monkeypatch):
    """Without its shear the column of ten units is 0.1 % off: the elastica tells, no interval."""
    shape = {"n": 10, "L1": 11.6, "radius": 0.5, "alpha": np.radians(80), "b": 0.1}
    whole = column.critical_shortening("free", **shape)
    no_shear = unit_with(lateral=lambda u: u.pitch**2 * u.turn / 12)
    monkeypatch.setattr(column, "unit", no_shear(column.unit))
    apart = column.critical_shortening("free", **shape) / whole - 1
    assert apart == pytest.approx(-1.35e-3, rel=0.05)


def wrong_section(right):
    """Sections without shear stiffness enough: ten thousand times too soft."""

    def wrong(*shape):
        one = right(*shape)
        return replace(one, section=replace(one.section, GA=one.section.GA / 1e4))

    return wrong


FE_FAULTS = [
    pytest.param(reference, "spring", wrong_section, U_CR, id="shear ten thousand times too soft"),
    pytest.param(reference, "spring",
                 lambda f: lambda q, p, b, level: f(q, p | {"L1": 1.002 * p["L1"]}, b, level),
                 U_CR, id="leaves 0.2 % too long"),
]  # fmt: skip


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), FE_FAULTS)
def test_wrong_finite_elements_turn_rows_red(owner, name, fault, row, monkeypatch, fresh):
    monkeypatch.setattr(owner, name, fault(vars(owner)[name]))
    monkeypatch.setattr(reference, "SWEPT", 0)  # sweeps are not asked
    q = BucklingSpring()
    levels = [reference.solve(q, level) for level in (2, 4, 8)]
    (check,) = (c for c in BUCKLING.checks if c.name == row)
    rows = check.rows(Context(BUCKLING.id, q, BUCKLING.analytic(q), levels, True))
    assert rows[0].status is Status.FAIL


ODD = [
    pytest.param({"n": 9}, id="odd n"),
    pytest.param({"n": 24, "L1": "3 mm"}, id="slender"),
    pytest.param({"alpha": "90 deg"}, id="upright leaves"),
    pytest.param({"alpha": "30 deg"}, id="flat leaves"),
    pytest.param({"b": "0.44 mm"}, id="thick"),
    pytest.param({"b": "0.001 mm"}, id="foil"),
    pytest.param({"n": 200}, id="many"),
    pytest.param({"n": 4}, id="short"),
    pytest.param({"E": "0.01 GPa", "nu": 0.0}, id="soft"),
    pytest.param({"r": "4 mm", "L1": "8.1 mm"}, id="round"),
]


@pytest.mark.parametrize("change", ODD)
def test_odd_springs_have_finite_values(change):
    q = own(**change)
    with np.errstate(over="raise", divide="raise", invalid="raise"):  # as the command does
        v = BUCKLING.analytic(q)
        assert isinstance(q.refusal(), str)
    assert all(np.isfinite(x) for x in v.values())


def test_the_displacement_of_giving_way_has_no_size():
    v = BUCKLING.analytic(own())
    small = BUCKLING.analytic(own(b="0.001 mm", h="0.56 mm", r="0.0045 mm", L1="0.116 mm"))
    for key in ("U_cr", "column_U"):
        assert small[key] == pytest.approx(0.01 * v[key], rel=1e-8)


def test_a_free_head_beyond_its_force_is_told_of():
    q = own(F="2 N")
    found = list(q.warnings())
    assert len(found) == 1
    assert "with a free head the spring buckles at 1.46 mm: the head needs a guide" in found[0]
    assert not list(own(F="0.5 N").warnings())


@pytest.mark.parametrize(
    ("change", "said"),
    [({"n": 30}, "n = 30 segments are more than 24"), ({"n": 4}, "too short to buckle sideways")],
)
def test_springs_without_a_comparison_say_so(change, said):
    assert said in own(**change).refusal()
    assert not own().refusal()


def test_an_elastica_that_is_not_found_is_no_spring_without_a_critical_point(monkeypatch, fresh):
    def fails(*_given, **_more):
        raise ArithmeticError("take smaller steps")

    monkeypatch.setattr(stability, "critical", fails)
    q = own()
    with pytest.raises(ArithmeticError, match="take smaller steps"):
        critical_point(q, "arc")
    v = BUCKLING.analytic(q)
    assert not [key for key in v if key.startswith("U_cr")]
    assert "column_U" in v
    assert q.refusal() == f"{NOT_FOUND} (take smaller steps): check it without --fem"
    assert list(q.warnings()) == [
        "no critical point of the elastica was found, tail arc and mid-leaf"
    ]


def test_a_critical_point_that_beams_do_not_have_is_an_error(monkeypatch):
    monkeypatch.setattr(reference, "LAST", 0.01)
    with pytest.raises(ArithmeticError, match="no critical point of the free head up to 1%"):
        reference.solve(own(), 2)


def test_wrong_input_gets_one_line():
    with pytest.raises(InputError, match=r"inputs.F = -1 N: must be greater than 0 N"):
        own(F="-1 N")
