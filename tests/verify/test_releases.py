"""What changed since a release is reported, and what was loosened needs a reason."""

import json
import math
from dataclasses import replace

import pytest

from reports.records import row_record
from verify.app import commands
from verify.app import release as making
from verify.app.cli import run
from verify.app.up_to_date import STAMP
from verify.audit.releases import changes as since
from verify.audit.releases import digits, reasons
from verify.audit.releases import store as kept
from verify.audit.releases.compare import drift
from verify.audit.releases.reasons import Reason
from verify.audit.releases.row_changes import row_changes
from verify.audit.releases.store import Release, load, newest, store
from verify.cases.ring.lame.case import LAME
from verify.core.inputs import InputError
from verify.core.results import CaseResult, Kind, Partner, Row, Status

ROW = Row(
    case="c", quantity="q", symbol="x", unit="mm", kind=Kind.IDENTITY, status=Status.PASS,
    analytic=2.0, fem=2.001, difference=0.001, scale=2.0, demand=0.01, u_num=0.001, u_ref=0.0,
    tolerance=0.002, detects=0.0015,
)  # fmt: skip
APPROXIMATE = replace(ROW, kind=Kind.APPROXIMATION, interval=(-0.01, 0.03))
BALANCE = replace(
    ROW, kind=Kind.EXACT, analytic=None, fem=1e-13, u_num=None, u_ref=None, difference=1e-13,
    tolerance=2e-9,
)  # fmt: skip
DEVIATION = replace(  # a size of 1e-4, 1e-3 accepted of it, its U 2e-4
    ROW, unit="1", analytic=0.0, fem=1e-4, difference=-1e-4, scale=1.0, u_num=1e-4, tolerance=8e-4,
    detects=9e-4, interval_source="what a balance leaves",
)  # fmt: skip
FACT = Row(
    case="c", quantity="f", symbol="x", unit="1", kind=Kind.FACT, status=Status.PASS,
    difference=0.4, tolerance=0.01, demand=0.01, reason="held: off by +0.07%, 0.2% accepted",
)  # fmt: skip


def result(*rows, case="c", **more):
    return CaseResult(
        id=case, title="", paper="", place="", lead="", inputs=(), equations=(), assumptions=(),
        readings=(), rows=rows, **more,
    )  # fmt: skip


def release(*rows):
    return Release(
        version="0.1.0", date="2026-01-01", commit="abc",
        rows={row.id: kept.kept(row) for row in rows},
    )  # fmt: skip


def found(before, after, why=()):
    """What is said of one row's change."""
    return drift(release(before), [result(after)], why)


def aspects(changed):
    return [(c.aspect, c.loosened) for c in changed.changes]


@pytest.mark.parametrize("row", [ROW, APPROXIMATE, BALANCE, FACT, DEVIATION])
def test_nothing_moved_is_one_line(row):
    same = found(row, row)
    assert (same.compared, same.changes, same.tightened) == (1, (), 0)
    assert since.lines(same) == ["since 0.1.0: 1 rows compared, nothing moved"]


# twice the root of both squares: 2 √2 · 0.001 = 0.00283
@pytest.mark.parametrize(("by", "told"), [(0.0028, []), (0.0029, [("finite elements", False)])])
def test_finite_elements_are_told_beyond_the_error_of_both_runs(by, told):
    changed = found(ROW, replace(ROW, fem=ROW.fem + by))
    assert aspects(changed) == told
    assert not changed.unexplained
    if told:
        assert changed.changes[0].size == "+0.0014 of the scale, 1.03 error bars"


@pytest.mark.parametrize(
    ("key", "by", "reported"),
    [
        ("analytic", 0.9e-10, []),
        ("analytic", 1.1e-10, [("formula", False)]),
        ("fem", 0.9e-6, []),
        ("fem", 1.1e-6, [("finite elements", False)]),
    ],
)
def test_values_without_error_and_band_may_differ_by_round_off(key, by, reported):
    row = replace(ROW, status=Status.SHOWN, fem=2.0, u_num=None, tolerance=None, detects=None)
    assert aspects(found(row, replace(row, **{key: 2.0 + by * 2.0}))) == reported


def test_round_off_of_a_value_near_zero_is_that_of_its_scale():
    row = replace(ROW, analytic=1e-7, scale=2.0, u_num=None, tolerance=None)
    assert aspects(found(row, replace(row, analytic=1e-7 + 1.8e-10))) == []
    assert aspects(found(row, replace(row, analytic=1e-7 + 2.2e-10))) == [("formula", False)]


def test_values_near_zero_may_scatter_within_what_a_balance_allows():
    assert aspects(found(BALANCE, replace(BALANCE, fem=-1e-13))) == []
    beyond = replace(BALANCE, fem=4e-9)
    assert aspects(found(BALANCE, beyond)) == [("finite elements", False)]
    zero = replace(ROW, fem=0.0, u_num=0.0, tolerance=0.0)
    assert aspects(found(zero, replace(zero, fem=1e-13))) == []
    assert aspects(found(zero, replace(zero, fem=1e-9))) == [("finite elements", False)]


@pytest.mark.parametrize("value", [math.nan, math.inf, None])
def test_a_value_that_is_none_or_not_finite_is_told_and_breaks_nothing(value):
    broken = replace(ROW, fem=value)
    assert aspects(found(ROW, broken)) == [("finite elements", False)]
    assert aspects(found(broken, ROW)) == [("finite elements", False)]
    assert aspects(found(broken, broken)) == []


def test_a_partner_s_value_counts_as_the_reference():
    row = replace(ROW, fem=None, partner=Partner(by="strips", value=2.0))
    moved = replace(row, partner=Partner(by="strips", value=2.1))
    assert aspects(found(row, moved)) == [("finite elements", False)]


# both uncertainties: √2 · 0.01 = 0.014; a tenth of the margin: 0.04
@pytest.mark.parametrize(
    ("U", "by", "reported"),
    [
        (0.01, 0.039, []),
        (0.01, 0.041, [("margin", False)]),
        (0.0, -0.039, []),
        (0.0, -0.041, [("margin", False)]),
        (0.03, 0.042, []),
        (0.03, 0.043, [("margin", False)]),
    ],
)
def test_the_margin_of_a_fact_counts_beyond_both_uncertainties_and_a_tenth(U, by, reported):
    row = replace(FACT, tolerance=U)
    assert aspects(found(row, replace(row, difference=0.4 + by))) == reported


def test_a_fact_with_values_counts_by_its_margin():
    row = replace(FACT, analytic=2.0, fem=1.6)
    moved = replace(row, analytic=2.039, difference=0.439)
    assert aspects(found(row, moved)) == []
    moved = replace(row, analytic=2.041, difference=0.441)
    assert aspects(found(row, moved)) == [("formula", False), ("margin", False)]
    wide = replace(row, tolerance=0.01, difference=0.05)  # the uncertainty of both: 0.014
    assert aspects(found(wide, replace(wide, analytic=2.02))) == [("formula", False)]


@pytest.mark.parametrize(("by", "reported"), [(0.9e-4, []), (1.1e-4, [("finite elements", False)])])
def test_the_value_of_a_limit_counts_beyond_a_tenth_of_its_tolerance(by, reported):
    row = replace(
        ROW, kind=Kind.ASYMPTOTIC, analytic=0.0, fem=1e-5, difference=1e-5, scale=1.0, u_num=None,
        u_ref=None, tolerance=1e-3, detects=None,
    )  # fmt: skip
    assert aspects(found(row, replace(row, fem=1e-5 + by))) == reported


def test_a_numerical_error_that_one_run_lacks_is_that_of_the_other():
    other = replace(ROW, u_num=None, detects=None, fem=ROW.fem + 0.0021)
    assert ("finite elements", False) in aspects(found(replace(ROW, detects=None), other))


# numerical error of both runs: 0.00283; a tenth of the band: 0.004, half of the interval being 0.04
@pytest.mark.parametrize(("key", "aspect"), [("analytic", "formula"), ("fem", "finite elements")])
def test_a_value_counts_beyond_its_error_and_a_tenth_of_its_band(key, aspect):
    for by, reported in ((0.0039, []), (0.0041, [(aspect, False)])):
        moved = replace(APPROXIMATE, **{key: getattr(APPROXIMATE, key) + by})
        assert aspects(found(APPROXIMATE, moved)) == reported
    narrow = replace(APPROXIMATE, interval=(-0.01, 0.01))  # a tenth of it is 0.002
    for by, reported in ((0.0027, []), (0.0029, [(aspect, False)])):
        moved = replace(narrow, **{key: getattr(narrow, key) + by})
        assert aspects(found(narrow, moved)) == reported


def test_a_row_of_another_kind_or_unit_is_reported():
    changed = found(ROW, replace(ROW, kind=Kind.TREND))
    assert [(c.aspect, c.was, c.now) for c in changed.changes] == [
        ("kind", "identity [mm]", "trend [mm]")
    ]
    assert aspects(found(ROW, replace(ROW, unit="m"))) == [("kind", False)]


def test_numbers_that_print_alike_are_no_change():
    row = replace(ROW, demand=0.0239411171)
    for demand in (0.0239411999, 0.0239411001):
        same = found(row, replace(row, demand=demand))
        assert (same.changes, same.tightened) == ((), 0)
    assert aspects(found(row, replace(row, demand=0.02395))) == [("demand", True)]
    assert aspects(found(row, replace(row, demand=0.023941))) == []
    assert aspects(found(row, replace(row, demand=0.0239412))) == [("demand", True)]


def test_the_order_of_convergence_may_scatter():
    order = replace(ROW, quantity="q: convergence", kind=Kind.FACT, u_num=None)
    assert aspects(found(order, replace(order, fem=3.0, difference=9.0))) == []


COMPUTED = replace(APPROXIMATE, interval=(-0.00827639401, 0.0249590585))  # a tenth: 0.00166
ABOUT = replace(COMPUTED, interval=(-0.0918544437, -0.0898544437))  # 0.002 about a computed centre
# its tenth is 1e-4, the numerical error of both runs √2 · 0.001
NARROW = replace(COMPUTED, interval=(-0.00100123456, 0.00100234567))
ONE_END = replace(COMPUTED, interval=(-0.02816191, 0.004))
ESTIMATED_BOUND = replace(BALANCE, tolerance=7.19491842e-7)  # a condition number times epsilon
SIX_DIGITS = replace(APPROXIMATE, interval=(-0.0123456, 0.512345678))
TWO_FIGURES = replace(FACT, reason="held: 1% accepted, 5% accepted")
RESIDUAL = replace(ROW, u_num=1e-9, u_ref=1.2587554e-4)

LOOSENED = [
    (ROW, {"demand": 0.02}, "demand", "1 % -> 2 %"),
    (ROW, {"demand": None}, "demand", "1 % -> none"),
    (ROW, {"demand": 0.0101}, "demand", "1 % -> 1.01 %"),
    (replace(ROW, u_ref=0.001), {"u_ref": 0.002}, "reference", "0.05 % -> 0.1 %"),
    (replace(ROW, u_ref=0.001), {"u_ref": 0.00101}, "reference", "0.05 % -> 0.0505 %"),
    # half of the digit 0.01 over √3
    (replace(ROW, u_ref=0.00288675135), {"u_ref": 0.00291561886}, "reference",
     "0.1443 % -> 0.1458 %"),
    (BALANCE, {"tolerance": 2e-8}, "bound", "1e-07 % -> 1e-06 %"),
    (BALANCE, {"tolerance": 2.02e-9}, "bound", "1e-07 % -> 1.01e-07 %"),
    (ESTIMATED_BOUND, {"tolerance": 1.11 * 7.19491842e-7}, "bound", "3.597e-05 % -> 3.993e-05 %"),
    (COMPUTED, {"interval": (-0.00828, 0.0249590585)}, "interval",
     "-0.827639 to +2.49591 % -> -0.828 to +2.49591 %"),  # a literal instead
    (COMPUTED, {"interval": (-0.00827639401, 0.0266590585)}, "interval",
     "-0.827639 to +2.49591 % -> -0.827639 to +2.66591 %"),
    (NARROW, {"interval": (-0.00250123456, -0.00049765433)}, "interval",
     "-0.100123 to +0.100235 % -> -0.2501235 to -0.04976543 %"),
    (ABOUT, {"interval": (-0.0918644437, -0.0898444437)}, "interval",
     "-9.1854444 to -8.9854444 % -> -9.1864444 to -8.9844444 %"),
    (ONE_END, {"interval": (-0.02816191, 0.00404)}, "interval",
     "-2.81619 to +0.4 % -> -2.81619 to +0.404 %"),
    (APPROXIMATE, {"interval": (-0.01, 0.031)}, "interval", "-1 to +3 % -> -1 to +3.1 %"),
    # wider on one side, although narrower on the other
    (APPROXIMATE, {"interval": (-0.011, 0.0)}, "interval", "-1 to +3 % -> -1.1 to +0 %"),
    (APPROXIMATE, {"interval": (-0.01, 0.0304)}, "interval", "-1 to +3 % -> -1 to +3.04 %"),
    (APPROXIMATE, {"interval": None}, "interval", "-1 to +3 % -> none"),
    (FACT, {"reason": "held: off by +0.07%, 0.3% accepted"}, "acceptance",
     "0.2 % accepted -> 0.3 % accepted"),
    (replace(FACT, reason="held: by 7.9% and more, 2% asked"),
     {"reason": "held: by 7.9% and more, 1% asked"}, "acceptance", "2 % asked -> 1 % asked"),
    (DEVIATION, {"tolerance": 8.8e-3, "detects": 8.9e-3}, "acceptance", "0.1 % -> 0.9 %"),
    # as wide as before beside its own U, which is less now
    (DEVIATION, {"tolerance": 1e-3, "u_num": 5e-5, "detects": 1e-3}, "acceptance",
     "0.1 % -> 0.11 %"),
    (DEVIATION, {"interval_source": ""}, "acceptance", "0.1 % -> none"),
    (ROW, {"scale": 200.0, "tolerance": 0.2}, "scale", "2 mm -> 200 mm"),
    (ROW, {"scale": 2.21}, "scale", "2 mm -> 2.21 mm"),
    (replace(ROW, u_ref=None), {"scale": None}, "scale", "2 mm -> none"),
    (FACT, {"reason": "held: off by +0.07%"}, "acceptance", "0.2 % accepted -> none"),
    (FACT, {"reason": "held: off by +0.07%, 50% asked"}, "acceptance",
     "0.2 % accepted -> 50 % asked"),
    (FACT, {"reason": "held: off by +0.07%, 0.3% accepted, 1% asked"}, "acceptance",
     "0.2 % accepted -> 0.3 % accepted, 1 % asked"),
    (TWO_FIGURES, {"reason": "held: 5% accepted"}, "acceptance",
     "1 % accepted, 5 % accepted -> 5 % accepted"),
    # stated numbers are told with the digits that differ
    (replace(ROW, demand=0.02), {"demand": 0.0200006}, "demand", "2 % -> 2.0001 %"),
    (APPROXIMATE, {"interval": (-0.01, 0.030000001)}, "interval",
     "-1 to +3 % -> -1 to +3.0000001 %"),
    # ends of five and six digits, and a zero one, are stated
    (SIX_DIGITS, {"interval": (-0.0123567, 0.512345678)}, "interval",
     "-1.23456 to +51.2346 % -> -1.23567 to +51.2346 %"),
    (replace(APPROXIMATE, interval=(0.0, 0.512345678)), {"interval": (-0.021234567, 0.512345678)},
     "interval", "+0 to +51.2346 % -> -2.12346 to +51.2346 %"),
    (ROW, {"status": Status.SHOWN}, "status", "PASS -> SHOWN"),
    (ROW, {"status": Status.CALIBRATED}, "status", "PASS -> CALIBRATED"),
]  # fmt: skip


@pytest.mark.parametrize(("row", "change", "aspect", "words"), LOOSENED)
def test_what_lets_more_pass_is_red_without_a_reason(row, change, aspect, words):
    changed = found(row, replace(row, **change))
    assert [c.aspect for c in changed.unexplained] == [aspect]
    said = since.lines(changed)
    assert f"{since.WITHOUT}: {row.id}: {aspect} {words}" in said
    why = Reason(rows="c/*", aspect=aspect, what="wider", why="a reason of some length",
                 since="0.1.0")  # fmt: skip
    explained = found(row, replace(row, **change), [why])
    assert not explained.unexplained
    assert not explained.unused
    assert f"  {row.id}: {aspect} {words}; a reason of some length" in since.lines(explained)


@pytest.mark.parametrize(
    "change",
    [{"rows": "d/*"}, {"aspect": "interval"}, {"since": "0.0.9"}, {"rows": "c/q with more"}],
)
def test_a_reason_for_something_else_explains_nothing(change):
    why = Reason(
        **{"rows": "c/q", "aspect": "demand", "what": "w", "why": "a reason of some length",
           "since": "0.1.0"} | change
    )  # fmt: skip
    assert found(ROW, replace(ROW, demand=0.02), [why]).unexplained


def test_a_reason_that_nothing_asks_for_is_told():
    why = Reason(rows="c/q", aspect="demand", what="w", why="a reason of some length",
                 since="0.1.0")  # fmt: skip
    same = found(ROW, ROW, [why])
    assert same.unused == ("c/q: demand: w",)
    assert "a reason that nothing asks for: c/q: demand: w" in since.lines(same)[-1]


@pytest.mark.parametrize(
    ("row", "change"),
    [
        (ROW, {"demand": 0.005}),
        (APPROXIMATE, {"interval": (-0.01, 0.02)}),
        (BALANCE, {"tolerance": 1e-9}),
    ],
)
def test_what_lets_less_pass_is_counted(row, change):
    changed = found(row, replace(row, **change))
    assert (changed.tightened, changed.changes) == (1, ())
    assert since.summary(changed) == "1 rows compared, 1 tightened"
    (what,) = changed.tighter
    assert what.row == row.id
    assert what.was != what.now


def test_what_is_loosened_too_is_not_called_tightened():
    both = replace(APPROXIMATE, interval=(-0.01, 0.02), demand=1.0)
    assert found(replace(APPROXIMATE, demand=0.01), both).tighter == ()


@pytest.mark.parametrize(("key", "aspect"), [("analytic", "formula"), ("fem", "finite elements")])
def test_a_row_that_turned_red_says_which_side_moved_and_by_how_much(key, aspect):
    moved = replace(ROW, status=Status.FAIL, **{key: 1.1 * getattr(ROW, key)})
    status, value = found(ROW, moved).changes
    assert (status.aspect, status.now) == ("status", "FAIL")
    assert value.aspect == aspect
    assert value.size.startswith("+0.1 of the scale")


def test_a_smaller_scale_or_a_new_one_is_told_and_not_red():
    assert aspects(found(ROW, replace(ROW, scale=1.79))) == [("scale", False)]
    assert aspects(found(replace(ROW, scale=None), ROW)) == [("scale", False)]
    shown = replace(ROW, status=Status.SHOWN)  # judges nothing
    assert aspects(found(shown, replace(shown, scale=3.0))) == [("scale", False)]


@pytest.mark.parametrize("scale", [1.81, 2.19])
def test_a_scale_may_move_by_a_tenth_or_the_numerical_error(scale):
    assert aspects(found(ROW, replace(ROW, scale=scale))) == []
    uncertain = replace(ROW, u_num=0.2)  # of both runs: 2 √2 · 0.2 = 0.57
    assert aspects(found(uncertain, replace(uncertain, scale=2.5))) == []


def test_every_judged_row_of_the_release_is_loosened_by_a_larger_scale():
    judged = [row for row in newest().rows.values() if row.status == "PASS" and row.scale]
    for row in judged:
        times = {
            name: 100 * value
            for name in ("scale", "tolerance", "u_ref")
            if (value := getattr(row, name)) is not None
        }
        assert ("scale", True) in changes_of(row, replace(row, **times))
    assert len(judged) > 700


def test_an_additional_figure_is_told_and_not_red():
    more = replace(FACT, reason="held: off by +0.07%, 0.2% accepted, 1% asked")
    assert aspects(found(FACT, more)) == [("acceptance", False)]


@pytest.mark.parametrize(
    ("row", "change", "aspect"),
    [
        (ROW, {"demand": 0.5}, "demand"),
        (DEVIATION, {"tolerance": 8.8e-3}, "acceptance"),
        (FACT, {"reason": "held: off by +0.07%, 0.3% accepted"}, "acceptance"),
        (APPROXIMATE, {"interval": None}, "interval"),
        (ROW, {"scale": 200.0}, "scale"),
    ],
)
def test_a_row_that_holds_again_by_a_looser_band_is_red(row, change, aspect):
    failed = replace(row, status=Status.FAIL)
    assert [c.aspect for c in found(failed, replace(row, **change)).unexplained] == [aspect]
    other = replace(row, kind=Kind.TREND)
    assert aspects(found(failed, other))[:2] == [("status", False), ("kind", False)]


def test_a_row_that_turned_red_without_its_numbers_says_no_more():
    empty = replace(ROW, status=Status.FAIL, analytic=None, fem=None)
    assert aspects(found(ROW, empty)) == [("status", False)]


def test_a_figure_is_the_same_whatever_the_uncertainty_leaves_of_it():
    assert kept.kept(DEVIATION).accepted == pytest.approx(1e-3, rel=1e-9)
    assert kept.kept(ROW).accepted is None
    sharper = replace(DEVIATION, u_num=5e-5, tolerance=9e-4, detects=1e-3)
    assert aspects(found(DEVIATION, sharper)) == []


@pytest.mark.parametrize(
    ("row", "change", "told"),
    [
        (ROW, {"detects": 0.0029}, []),
        (ROW, {"detects": 0.0031, "u_num": 0.0021}, [("detects", False)]),
        (ROW, {"u_num": 0.0019}, []),
        (ROW, {"u_num": 0.0021}, [("uncertainty", False)]),
        (DEVIATION, {"u_num": 3e-4, "tolerance": 4e-4, "detects": 5e-4}, [("uncertainty", False)]),
        (APPROXIMATE, {"detects": None}, [("detects", False)]),
        (FACT, {"tolerance": 0.019}, []),
        (replace(FACT, tolerance=1e-4), {"tolerance": 9e-4}, [("uncertainty", False)]),
        (FACT, {"tolerance": 0.021}, [("uncertainty", False)]),
        (replace(ROW, detects=1e-13, u_num=1e-14), {"detects": 9e-11, "u_num": 9e-11}, []),
        (replace(ROW, detects=1e-4), {"detects": 1.09e-3}, []),  # a tenth of the demand is 1e-3
        (replace(ROW, detects=1e-4), {"detects": 1.11e-3}, [("detects", False)]),
    ],
)  # fmt: skip
def test_what_a_row_no_longer_detects_is_told_and_not_red(row, change, told):
    changed = found(row, replace(row, **change))
    assert aspects(changed) == told
    assert not changed.unexplained


def test_growth_is_told_in_times():
    (change,) = found(ROW, replace(ROW, detects=0.009)).changes
    assert since.line(change) == "c/q: detects 0.15 % -> 0.9 % (6 times)"


@pytest.mark.parametrize(
    ("row", "change"),
    [
        (APPROXIMATE, {"interval": (-0.01 * (1 + 1e-9), 0.03)}),
        (COMPUTED, {"interval": (-0.00827639401 * (1 + 1e-5), 0.0249590585 * (1 + 1e-5))}),
        (COMPUTED, {"interval": (-0.00827639401, 0.0265590585)}),
        (ABOUT, {"interval": (-0.0918554437, -0.0898554437)}),
        (ONE_END, {"interval": (-0.02816191 * (1 + 1e-5), 0.004)}),
        (NARROW, {"interval": (-0.00240123456, -0.00039765433)}),
        (ESTIMATED_BOUND, {"tolerance": 1.09 * 7.19491842e-7}),
        (RESIDUAL, {"u_ref": 1.09 * 1.2587554e-4}),
        # below the numerical error of both runs, √2 · 0.001
        (replace(RESIDUAL, u_num=0.001), {"u_ref": 0.00150123456}),
    ],
)
def test_computed_bands_may_move_within_their_error_and_a_tenth(row, change):
    for was, now in ((row, replace(row, **change)), (replace(row, **change), row)):
        same = found(was, now)
        assert (same.changes, same.tightened) == ((), 0)


def test_a_computed_reference_counts_beyond_a_tenth():
    assert aspects(found(RESIDUAL, replace(RESIDUAL, u_ref=1.11 * 1.2587554e-4))) == [
        ("reference", True)
    ]


@pytest.mark.parametrize(
    ("value", "stated"),
    [(0.01, True), (1e-9, True), (9.999999990157453e-10, True), (0.1234, True), (0.0, False),
     (-0.02, True), (None, False), (0.12345, False), (3.59745921e-07, False)],
)  # fmt: skip
def test_a_stated_number_has_few_digits(value, stated):
    assert digits.is_stated(value) is stated


@pytest.mark.parametrize(
    ("value", "literal"),
    [(0.0, True), (0.12345, True), (-0.00511875, True), (0.1234567, False), (None, False)],
)
def test_a_literal_that_is_stored_itself_has_up_to_six_digits(value, literal):
    assert digits.is_literal(value) is literal


def is_about_stated(interval):
    """Whether an end or the width of an interval is stated."""
    low, high = interval
    rounding = 1e-9 * max(abs(low), abs(high))
    return any(map(digits.is_literal, interval)) or digits.is_stated(high - low, rounding)


def changes_of(was, now):
    return [(c.aspect, c.loosened) for c in row_changes("c/q", was, now)]


def test_every_stated_band_of_the_release_is_loosened_by_one_per_cent():
    widened = 0
    for row in newest().rows.values():
        if row.status in ("PASS", "CALIBRATED") and row.interval and is_about_stated(row.interval):
            low, high = row.interval
            by = 0.005 * (high - low)
            assert ("interval", True) in changes_of(
                row, replace(row, interval=(low - by, high + by))
            )
            widened += 1
        if digits.is_stated(row.bound):
            assert ("bound", True) in changes_of(row, replace(row, tolerance=1.01 * row.tolerance))
            widened += 1
    assert widened > 150


def test_no_computed_number_of_the_release_is_loosened_by_another_processor():
    moved = 0
    for row in newest().rows.values():
        share = 1 + 1e-5
        noisy = {}
        if row.interval and not any(map(digits.is_literal, row.interval)):
            low, high = row.interval
            by = min(1e-5 * max(map(abs, row.interval)), 0.04 * (high - low))  # two are 3e-6 wide
            noisy["interval"] = tuple(end + by for end in row.interval)
        if row.bound and not digits.is_stated(row.bound):
            noisy["tolerance"] = row.tolerance * share
        if row.u_ref and row.u_num:
            noisy["u_ref"] = row.u_ref * share
        assert changes_of(row, replace(row, **noisy)) == []
        moved += len(noisy)
    assert moved > 200


def test_a_row_with_a_new_name_and_the_old_numbers_is_the_same_row():
    renamed = found(ROW, replace(ROW, quantity="p", demand=0.02))
    assert aspects(renamed) == [("name", False), ("demand", True)]
    assert renamed.compared == 1


@pytest.mark.parametrize(
    ("by", "reported"), [(1e-7, [("name", False)]), (1e-5, [("gone", True), ("new", False)])]
)
def test_a_renamed_row_is_found_on_another_processor(by, reported):
    moved = replace(ROW, quantity="p", fem=ROW.fem * (1 + by), difference=0.0011, u_num=0.0012)
    assert aspects(found(ROW, moved)) == reported


def test_renamed_rows_of_nearly_the_same_value_are_distinguished_on_the_same_processor():
    twin = replace(ROW, quantity="twin", fem=ROW.fem * (1 + 1e-7))
    now = [replace(ROW, quantity="p"), replace(twin, quantity="r")]
    changed = drift(release(ROW, twin), [result(*now)], ())
    assert [(c.row, c.was) for c in changed.changes] == [("c/p", "q"), ("c/r", "twin")]


def test_a_new_name_with_another_figure_in_it_needs_a_reason():
    row = replace(FACT, quantity="within 1 % of the best")
    assert aspects(found(row, replace(row, quantity="within 2 % of the best"))) == [("name", True)]


def test_of_two_rows_alike_none_is_taken_for_the_other():
    old = [ROW, replace(ROW, quantity="twin")]
    changed = drift(release(*old), [result(replace(ROW, quantity="p"))], ())
    assert [(c.row, c.aspect) for c in changed.changes] == [
        ("c/q", "gone"), ("c/twin", "gone"), ("c", "new"),
    ]  # fmt: skip


def test_a_row_that_is_gone_needs_a_reason_and_new_ones_are_counted():
    new = [replace(ROW, quantity=name, analytic=value) for name, value in (("a", 5.0), ("b", 6.0))]
    changed = drift(release(ROW, FACT), [result(FACT, *new)], ())
    assert [(c.row, c.aspect, c.loosened, c.now) for c in changed.changes] == [
        ("c/q", "gone", True, "none"), ("c", "new", False, "2 rows"),
    ]  # fmt: skip
    shown = replace(ROW, status=Status.SHOWN)
    assert not drift(release(shown), [result(FACT)], ()).unexplained  # it judged nothing


def test_cases_not_run_and_rows_skipped_are_not_compared():
    other = replace(ROW, case="d")
    skipped = replace(ROW, status=Status.SKIP, analytic=None, fem=None, demand=None)
    changed = drift(release(ROW, FACT, other), [result(skipped)], ())
    assert (changed.compared, changed.changes) == (0, ())


def test_a_failed_row_is_told_as_such_alone():
    failed = replace(ROW, status=Status.FAIL, analytic=None, fem=None, demand=None)
    assert aspects(found(ROW, failed)) == [("status", False)]
    broken = drift(release(ROW, FACT), [result(failed, errors=("trace",))], ())
    assert [c.aspect for c in broken.changes] == ["status"]


def test_a_release_is_read_as_it_was_written(tmp_path, of_paper):
    rows = of_paper(LAME).rows
    path = store(rows, "0.2.0", "abc", tmp_path)
    assert path.read_bytes() == store(rows, "0.2.0", "abc", tmp_path).read_bytes()
    again = load(path)
    assert again.rows == {row.id: kept.kept(row) for row in rows}
    assert drift(again, [of_paper(LAME)], ()).changes == ()


def test_the_newest_release_has_the_highest_version(tmp_path):
    assert newest(tmp_path) is None
    for name in ("0.9.0", "0.10.0", "0.2.1"):
        store([ROW], name, "abc", tmp_path)
    (tmp_path / "notes.json.gz").write_bytes(b"")
    assert newest(tmp_path).version == "0.10.0"


@pytest.mark.parametrize("content", [b"", b"no gzip", b"\x1f\x8b\x08\x00torn"])
def test_a_torn_release_is_one_line(tmp_path, content):
    path = tmp_path / "0.1.0.json.gz"
    path.write_bytes(content)
    with pytest.raises(InputError, match="is no release"):
        load(path)


ENTRY = '[[changes]]\nrows = "c/q"\naspect = "demand"\nwhat = "w"\nsince = "0.1.0"\n'


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (ENTRY, "changes.1..why: Field required"),
        (ENTRY + 'why = "so"', "changes.1..why: String should have at least 20"),
        (ENTRY.replace('"demand"', '"mood"') + f'why = "{"x" * 20}"', "changes.1..aspect"),
        ("changes = 3", "needs tables"),
        ("other = 3", "other: unknown key"),
        ("[[changes", "cannot be read"),
    ],
)
def test_a_reason_that_is_none_is_named_in_one_line(tmp_path, text, said):
    path = tmp_path / "changes.toml"
    path.write_text(text, "utf-8")
    with pytest.raises(InputError, match=said) as error:
        reasons.read(path)
    assert "\n" not in str(error.value)


def test_the_project_s_own_releases_and_reasons_can_be_read():
    reasons.read()
    assert newest().version <= kept.version()
    assert kept.path_of(newest().version).stat().st_size < 150_000


@pytest.fixture
def one_release(tmp_path, monkeypatch, of_paper):
    """A release of ring-lame in a folder of its own, one demand of which was half as large."""
    monkeypatch.setattr(kept, "FOLDER", tmp_path)
    monkeypatch.setattr(reasons, "FILE", tmp_path / "changes.toml")

    def make(factor):
        rows = [
            replace(row, demand=row.demand and row.demand * factor) if i == 0 else row
            for i, row in enumerate(of_paper(LAME).rows)
        ]
        store(rows, "0.1.0", "abc", tmp_path)
        return rows[0].id

    return make


def test_a_run_with_a_loosened_demand_ends_with_one(one_release, tmp_path, capsys):
    row = one_release(0.5)
    out = tmp_path / "out"
    command = ["verify", "ring-lame", "--jobs", "1", "--out", str(out)]
    assert run(command) == 1
    assert f"{since.WITHOUT}: {row}: demand" in capsys.readouterr().out
    record = json.loads((out / "results.json").read_text("utf-8"))["drift"]
    assert (record["unexplained"], record["changes"][0]["row"]) == (1, row)
    why = f'[[changes]]\nrows = "{row}"\naspect = "demand"\nwhat = "w"\nsince = "0.1.0"\n'
    reasons.FILE.write_text(f'{why}why = "a reason of some length"\n', "utf-8")
    (out / STAMP).unlink()  # the file of reasons is not that of the project here
    assert run(command) == 0
    reasons.FILE.write_text("[[", "utf-8")
    (out / STAMP).unlink()
    assert run(command) == 2
    assert "changes.toml: cannot be read" in capsys.readouterr().err


def test_own_parameters_are_compared_with_nothing(one_release, of_paper):
    one_release(0.5)
    assert commands.make_report([of_paper(LAME)], [LAME], 1.0, "mine").drift is None
    assert commands.make_report([of_paper(LAME)], [LAME], 1.0).drift.unexplained


def test_a_release_refuses_red_rows_and_what_is_not_committed(one_release, tmp_path, of_paper):
    one_release(0.5)
    report = commands.make_report([of_paper(LAME)], [LAME], 1.0)
    with pytest.raises(InputError, match=since.WITHOUT):
        making.refuse_red(report)
    failed = replace(report, cases=(result(replace(ROW, status=Status.FAIL)),))
    with pytest.raises(InputError, match="c/q: FAIL"):
        making.refuse_red(failed)
    making.refuse_red(replace(report, drift=None))
    with pytest.raises(InputError, match="needs git"):
        making.refuse_uncommitted(tmp_path)  # no repository
    with pytest.raises(InputError, match="is there already"):
        making.release(kept.ROOT, tmp_path)


def test_what_is_kept_of_a_row_is_what_results_json_says(of_paper):
    for row in of_paper(LAME).rows:
        record, one = row_record(row), kept.kept(row)
        assert (one.kind, one.status) == (record["kind"], record["status"])
        for name in ("analytic", "demand", "u_num", "tolerance", "detects", "scale"):
            known = record[name]
            wanted = None if known is None else pytest.approx(known, rel=1e-8)
            assert getattr(one, name) == wanted
