"""Case spring-width: faults of either side turn rows red; odd springs; what is told and refused."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.spring import frame, wide_leaf
from verify.cases.spring.curve.inputs import CurveInputs
from verify.cases.spring.width import case as spring_width
from verify.cases.spring.width import claims, reference
from verify.cases.spring.width.case import WIDTH, WideSpring
from verify.cases.spring.width.reference import ENDS, LEVELS, fem_spring
from verify.core.case import Context
from verify.core.inputs import InputError, build
from verify.core.results import Status
from verify.judging.claims import rows_of
from verify.judging.judge import fit_limit

pytestmark = pytest.mark.xdist_group("spring-width")

PAPER = {"n": 10, "b": "0.1 mm", "h": "56 mm", "r": "0.45 mm", "L1": "11.6 mm", "alpha": "80 deg",
         "E": "206 GPa", "nu": 0.3}  # fmt: skip
HELD = "shell with held edges, tail held at mid-leaf, head guided"
NARROW = "shell with held edges and plane stress"
SQUARE = "factor of a leaf 1 times as wide as long"
WIDE = "a wide spring is in plane strain but for edges as wide as leaves are long"
TAKEN = "the factor that case spring-curve takes"
MEETS = "k_1 of the shell, head free, tail held at mid-leaf, beside the paper's"
LOOP = "loop as a shell and as solids, 100 times as wide as thick"


def own(**changes):
    return build(WideSpring, PAPER | changes, "my.toml")


def names(rows):
    return {row.quantity for row in rows}


def test_no_row_is_red_and_what_was_fitted_is_calibrated(judged, red):
    result = judged(WIDTH)
    assert not red(result)
    assert {row.quantity for row in result.rows if row.status is Status.CALIBRATED} == {MEETS}


def other_nu(nu):
    return lambda f: lambda *a, **k: f(*a, **k | {"nu": nu})


FORMULA_FAULTS = [
    pytest.param(frame, "SHEAR", lambda f: 100 * f, HELD, id="shear a hundredfold"),
    pytest.param(spring_width, "width_factor", other_nu(0.29), SQUARE, id="another nu"),
    pytest.param(spring_width, "width_factor", lambda f: lambda *a, **k: f(*a, **k) * 0.91, SQUARE,
                 id="1 - nu^2 twice"),
    pytest.param(spring_width, "width_factor", lambda f: lambda h, *a, **k: f(h / 2, *a, **k),
                 SQUARE, id="half the width"),
    pytest.param(wide_leaf, "_parts", lambda f: lambda terms: (*f(terms)[:3], 0.9 * f(terms)[3]),
                 SQUARE, id="a tenth of the twist lost"),
    pytest.param(frame, "stiffness",
                 lambda f: lambda *a, **k: f(*a, **k | {"plane_strain": False}), HELD,
                 id="1 - nu^2 dropped"),
    pytest.param(frame, "stiffness",
                 lambda f: lambda *a, **k: f(*a, **k | {"plane_strain": False}), WIDE,
                 id="1 - nu^2 dropped from the limit"),
    pytest.param(frame, "stiffness",
                 lambda f: lambda *a, **k: f(*a, **k | {"radius": k["radius"] - 5e-5}), NARROW,
                 id="inner radius"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FORMULA_FAULTS)
def test_a_wrong_formula_turns_a_row_red(owner, name, fault, row, levels, monkeypatch):
    assert judge_row(row, levels) is Status.PASS
    monkeypatch.setattr(owner, name, fault(vars(owner)[name]))
    assert judge_row(row, levels) is Status.FAIL


def test_another_default_of_the_curve_turns_its_row_red(levels, monkeypatch):
    monkeypatch.setattr(CurveInputs.model_fields["width_factor"], "default", 1.0989)
    assert judge_row(TAKEN, levels) is Status.FAIL


def without(levels, **changed):
    """Levels with some of their values replaced by what is made of them."""
    return [
        replace(r, values={k: changed[k](v) if k in changed else v for k, v in r.values.items()})
        for r in levels
    ]


def judge_row(name, levels, q=None):
    q = q or WideSpring()
    (check,) = (c for c in WIDTH.checks if c.name == name)
    return check.rows(Context(WIDTH.id, q, WIDTH.analytic(q), levels, True))[0].status


def rows_of_a_shell(change, monkeypatch):
    """The spring's stiffness with held edges, in plane stress too, of shells that `change` wrongs.

    Only they are solved, on all levels.
    """
    right = reference.fem_pulled
    monkeypatch.setattr(reference, "fem_pulled", lambda *a, **k: right(*change(a), **k))
    q = WideSpring()
    solved = fem_spring.__wrapped__  # none that was solved before
    values = [
        {
            "k_wide_mid_leaf_guided": solved(q, q.h, level, "mid-leaf", "guided", held=True),
            "k_narrow": solved(q, q.h, level, "mid-leaf", "guided", held=True, narrow=True),
        }
        for level in LEVELS
    ]
    return [reference.Level(h=1 / level, values=v) for level, v in zip(LEVELS, values, strict=True)]


SHELL_FAULTS = [
    pytest.param(lambda a: (*a[:2], a[2] / 2, *a[3:]), id="half the width's force on all of it"),
    pytest.param(lambda a: (a[0], 1.001 * a[1], *a[2:]), id="a thousandth too thick"),
    pytest.param(lambda a: (*a[:4], "y"), id="a head that may turn"),
    pytest.param(lambda a: (*a[:3], replace(a[3], nu=0.0), a[4]), id="1 - nu^2 dropped"),
]


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize("change", SHELL_FAULTS)
def test_wrong_shells_turn_a_row_red(change, monkeypatch):
    levels = rows_of_a_shell(change, monkeypatch)
    assert judge_row(HELD, levels) is Status.FAIL
    assert judge_row(NARROW, levels) is Status.FAIL


@pytest.mark.soak  # finite elements solved anew, for the faults above
def test_right_shells_turn_none_red(monkeypatch):
    levels = rows_of_a_shell(lambda a: a, monkeypatch)
    assert judge_row(HELD, levels) is Status.PASS
    assert judge_row(NARROW, levels) is Status.PASS


@pytest.fixture
def levels():
    """Of the paper's inputs, from the cache."""
    from tests.conftest import solved

    return [level.result for level in solved(WIDTH, WideSpring())]


def test_edges_held_by_mistake_turn_the_factor_s_rows_red(levels):
    """Where edges are held the factor is that of plane strain: 0.3 % more."""
    wrong = [replace(r, values=r.values | {"f": 1.0989}) for r in levels]
    assert judge_row(TAKEN, wrong) is Status.FAIL
    assert judge_row("one leaf's factor within 0.1 % of the spring's", wrong) is Status.FAIL


def test_solids_a_quarter_per_cent_off_turn_their_row_red(levels):
    assert judge_row(LOOP, without(levels, solid_100=lambda v: 1.0025 * v)) is (Status.FAIL)


def with_arrays(levels, **changed):
    return [
        replace(r, arrays={k: changed[k](v) if k in changed else v for k, v in r.arrays.items()})
        for r in levels
    ]


ARRAY_FAULTS = [
    pytest.param("ends", lambda f: f * [1, 1, 1.02, 1], MEETS, id="other ends"),
    pytest.param("ends", lambda f: f * [1, 1, 1.001, 1],
                 "the factor is the same however the ends are held", id="a thousandth by ends"),
    pytest.param("uniform", lambda f: f * [1, 1.0001],
                 "the factor is the same for a head under a uniform force", id="uniform force"),
    pytest.param("sweep_wide", lambda s: s * [1, 1.001], WIDE, id="a thousandth at wide springs"),
    pytest.param("sweep_wide", lambda s: s * [2, 1.01],
                 "a spring 90 times as wide as its leaves within 0.5 % of plane strain", id="wide"),
    pytest.param("sweep_narrow", lambda s: s * [1, 1.001], "a narrow spring is in plane stress",
                 id="a thousandth at narrow springs"),
    pytest.param("sweep_narrow", lambda s: s * [1, 1.01],
                 "the narrowest spring within 0.5 % of plane stress", id="narrow"),
    pytest.param("sweep_medium", lambda s: s * [2, 1],
                 "one leaf's factor within 0.5 % of the spring's over all widths",
                 id="half the width"),
]  # fmt: skip


@pytest.mark.parametrize(("key", "fault", "row"), ARRAY_FAULTS)
def test_wrong_sweeps_turn_rows_red(key, fault, row, levels):
    assert judge_row(row, levels) is not Status.FAIL
    assert judge_row(row, with_arrays(levels, **{key: fault})) is Status.FAIL


def test_a_free_head_without_its_line_is_a_little_softer_than_with_it():
    """A uniform force bends the line; of a short spring, whose head is free, the most."""
    q = own(n=4)
    line = fem_spring(q, q.h, 2, "arc", "free")
    force = fem_spring(q, q.h, 2, "arc", "free", uniform=True)
    assert force < line
    assert force == pytest.approx(line, rel=2e-4)


def test_what_a_wide_spring_lacks_is_as_wide_as_its_leaves(levels):
    context = Context(WIDTH.id, WideSpring(), WIDTH.analytic(WideSpring()), levels, True)
    fit = fit_limit(*claims.wide(context))
    assert abs(fit.q - 1) < fit.U_q < 0.1
    assert abs(fit.d0) < 1e-4


ODD = [
    pytest.param({"n": 200}, id="many"),
    pytest.param({"alpha": "90 deg", "nu": 0.45}, id="upright leaves, soft material"),
    pytest.param({"alpha": "20 deg", "tail": "arc"}, id="flat leaves"),
    pytest.param({"b": "0.44 mm", "h": "0.1 mm"}, id="narrower than thick"),
    pytest.param({"b": "0.001 mm"}, id="foil"),
    pytest.param({"E": "0.01 GPa", "nu": 0.0}, id="no Poisson's ratio"),
    pytest.param({"r": "4 mm", "L1": "8.1 mm"}, id="round"),
    pytest.param({"h": "10000 mm"}, id="ten metres wide"),
    pytest.param({"h": "0.001 mm"}, id="a thread"),
    pytest.param({"head": "hinged"}, id="hinged"),
]


@pytest.mark.parametrize("change", ODD)
def test_odd_springs_have_finite_values_within_the_bounds(change):
    q = own(**change)
    with np.errstate(over="raise", divide="raise", invalid="raise"):  # as the command does
        v = WIDTH.analytic(q)
    assert all(np.isfinite(x) for x in v.values())
    assert 1 - 1e-12 <= v["f"] <= q.widest * (1 + 1e-12)
    assert v["k_narrow"] * (1 - 1e-12) <= v["k"] <= v["k_wide"] * (1 + 1e-3)


@pytest.mark.slow("the spring of fewest leaves, whose shells are solved for own inputs")
def test_an_own_narrow_spring_passes_and_its_error_is_told():
    q = own(n=4, h="3 mm", head="hinged", tail="arc")
    levels = [WIDTH.reference(q, level) for level in LEVELS]
    context = Context(WIDTH.id, q, WIDTH.analytic(q), levels, False)
    rows = [row for check in WIDTH.checks for row in rows_of(check, context)]
    assert {row.status for row in rows} == {Status.PASS, Status.SHOWN}
    assert not {TAKEN, MEETS} & names(rows)
    assert any("one leaf" in row.quantity and "measured: leaf" in row.reason for row in rows)


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"h": "0.2 mm"}, "a strip 2 times as wide as thick is no plate"),
        ({"h": "3 mm"}, "a strip 0.25 times as wide as a leaf is long: its arcs"),
        ({"r": "4 mm", "L1": "8.1 mm"}, "as long as leaves: a leaf's factor says little"),
    ],
)
def test_warnings_say_where_a_leaf_s_factor_ends(change, word):
    q = own(**change)
    assert any(word in said for said in q.warnings())


def test_the_paper_s_spring_needs_no_warning():
    assert not list(WideSpring().warnings())


def test_many_segments_are_refused_with_what_to_do():
    assert "check it with n = 30" in own(n=31).refusal()
    assert not own(n=30).refusal()


def test_foils_are_refused():
    assert "11938 times as long as thick" in own(b="0.001 mm").refusal()
    assert not own(b="0.005 mm").refusal()


def test_tables_hold_the_printed_stiffness_for_the_paper_s_spring_alone(levels):
    q = WideSpring()
    context = Context(WIDTH.id, q, WIDTH.analytic(q), levels, True)
    readings, widths = WIDTH.tables(context)
    assert [row[:2] for row in readings.rows] == list(ENDS)
    assert readings.rows[2][-2:] == ("+0.1 %", "+0.6 %")
    assert len(widths.rows) == 15
    plain, _ = WIDTH.tables(replace(context, is_paper=False))
    assert len(plain.header) == len(plain.rows[0]) == len(readings.header) - 2
    assert not WIDTH.tables(replace(context, fem=[]))


def test_wrong_input_gets_one_line():
    with pytest.raises(InputError, match=r"inputs.head: needs one of free, hinged, guided"):
        own(head="loose")
