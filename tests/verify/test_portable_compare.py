"""What counts as a difference between two machines, on planted ones."""

import math
from dataclasses import replace

import pytest

from verify.audit.portable import reasons
from verify.audit.portable.compare import Kind, differences, moves
from verify.audit.portable.moving import Record, move, record
from verify.audit.portable.store import KIND, MACHINE, CaseRecord, Place, Results
from verify.core.inputs import InputError
from verify.core.results import Kind as RowKind
from verify.core.results import Partner, Row, Status
from verify.core.store import Store

ROW = Record(
    id="ring/bore", kind="identity", status="PASS", values={"formula": 2.0, "reference": 2.001},
    difference=-0.001, tolerance=0.01, scale=2.0,
)  # fmt: skip
OTHERS = tuple(replace(ROW, id=f"ring/{name}") for name in ("rim", "hoop", "radial"))
ROWS = (ROW, *OTHERS)


def compared(first, *, perturbed=False):
    """Differences of the first row of four."""
    return differences(ROWS, (first, *OTHERS), "there", perturbed=perturbed)


def moved(by, row=ROW):
    """The row with its reference moved by so many tolerances, its formula staying."""
    step = by * row.tolerance
    values = {**row.values, "reference": row.values["reference"] + step}
    return replace(row, values=values, difference=row.difference - step)


def test_equal_rows_differ_in_nothing():
    assert compared(ROW) == []


def test_a_status_that_differs_is_reported_with_both_reasons():
    (one,) = compared(replace(ROW, status="FAIL", reason="not converged"))
    assert (one.kind, one.row, one.variant) == (Kind.STATUS, ROW.id, "there")
    assert (one.was, one.now) == ("PASS", "FAIL (not converged)")


@pytest.mark.parametrize("by", [-0.2, 0.11, 0.2, 3.0])
def test_a_value_that_moves_by_more_than_a_tenth_of_the_tolerance_is_reported(by):
    (one,) = compared(moved(by))
    assert one.kind is Kind.VALUE
    assert one.move == pytest.approx(abs(by))


@pytest.mark.parametrize("by", [-0.09, 0.0, 0.05])
def test_a_smaller_move_is_none(by):
    assert compared(moved(by)) == []


def test_the_limit_is_a_tenth_of_the_tolerance():
    assert compared(moved(0.1 - 1e-6)) == []
    assert [one.kind for one in compared(moved(0.1 + 1e-6))] == [Kind.VALUE]


@pytest.mark.parametrize("tolerance", [math.nan, math.inf, None, 0.0])
def test_a_tolerance_that_is_not_finite_is_none(tolerance):
    row = replace(ROW, tolerance=tolerance)
    far = {**row.values, "reference": 7.0}
    for other in (far, {**far, "formula": None}):
        rows = [row], [replace(row, values=other)]
        assert [one.kind for one in differences(*rows, "there", perturbed=False)] == [Kind.VALUE]
    assert move(row, replace(row, values=far), perturbed=False) == pytest.approx(4.999 / 2e-5)
    fact = replace(row, kind="fact", difference=1.5)
    assert move(fact, replace(fact, difference=1.2), perturbed=False) == pytest.approx(0.2)


@pytest.mark.parametrize("difference", [math.nan, math.inf])
def test_a_margin_that_is_not_finite_hides_no_value(difference):
    fact = replace(ROW, kind="fact", difference=difference)
    other = replace(fact, values={**fact.values, "formula": 2.1})
    assert move(fact, other, perturbed=False) == pytest.approx(10)


def test_nan_is_no_move_where_both_have_it_and_one_where_not():
    row = replace(ROW, values={"formula": math.nan, "reference": 2.001})
    assert differences([row], [row], "there", perturbed=False) == []
    for pair in ((row, ROW), (ROW, row)):
        assert move(*pair, perturbed=False) == math.inf


def test_a_row_without_values_moves_by_its_difference():
    row = replace(ROW, values={})
    assert move(row, replace(row, difference=0.001), perturbed=False) == pytest.approx(0.2)


@pytest.mark.parametrize(
    ("tolerance", "told"), [(0.0201, "0.0201"), (0.0049, "0.0049"), (1e9, "1000000000"),
                            (None, "none"), (math.inf, "inf"), (math.nan, "nan")],
)  # fmt: skip
def test_another_tolerance_is_a_difference_with_both_in_words(tolerance, told):
    (one,) = compared(replace(ROW, tolerance=tolerance))
    assert (one.kind, one.move) == (Kind.VALUE, 0.0)
    assert one.was.endswith(", tolerance 0.01")
    assert one.now.endswith(f", tolerance {told}")
    (both,) = compared(replace(moved(0.5), tolerance=tolerance))
    assert both.move == pytest.approx(0.5)


@pytest.mark.parametrize("tolerance", [0.0199, 0.0051])
def test_a_tolerance_that_is_estimated_may_differ_by_a_factor_of_two(tolerance):
    assert compared(replace(ROW, tolerance=tolerance)) == []


def test_the_uncertainty_of_a_fact_counts_by_the_share_of_its_margin():
    row = replace(ROW, kind="fact", difference=1.5, tolerance=1e-9)
    for U, kinds in ((1e-7, []), (0.14, []), (0.16, [Kind.VALUE])):
        rows = [row], [replace(row, tolerance=U)]
        assert [one.kind for one in differences(*rows, "there", perturbed=False)] == kinds


def test_rows_of_the_same_name_are_reported():
    twice = [ROW, replace(ROW, values={"formula": 9.0}), *OTHERS]
    for rows, times in (((twice, twice), ("2 times", "2 times")),
                        ((ROWS, twice), ("1 times", "2 times")),
                        ((twice, ROWS), ("2 times", "1 times"))):  # fmt: skip
        told = differences(*rows, "there", perturbed=False)
        (one,) = (one for one in told if one.kind is Kind.DUPLICATE)
        assert (one.row, one.was, one.now) == (ROW.id, *times)


def test_both_sides_that_move_alike_count_on_the_same_inputs_and_not_on_perturbed_ones():
    values = {name: value + 0.2 * ROW.tolerance for name, value in ROW.values.items()}
    together = replace(ROW, values=values)
    assert [one.kind for one in compared(together)] == [Kind.VALUE]
    large = replace(together, values={n: v * (1 + 1e-7) for n, v in ROW.values.items()})
    assert compared(large, perturbed=True) == []
    assert [one.kind for one in compared(moved(0.2), perturbed=True)] == [Kind.VALUE]


@pytest.mark.parametrize("difference", [None, -0.001])
def test_without_a_tolerance_a_millionth_of_the_scale_is_the_limit(difference):
    row = replace(ROW, tolerance=None, difference=difference, status="SHOWN")
    others = {"variant": [replace(row, values={**row.values, "formula": 2.0 + 4.1e-6})],
              "name": "there", "perturbed": False}  # fmt: skip
    assert [one.kind for one in differences([row], **others)] == [Kind.VALUE]
    others["variant"] = [replace(row, values={**row.values, "formula": 2.0 + 1.9e-6})]
    assert differences([row], **others) == []


@pytest.mark.parametrize(("now", "size"), [(1.35, 0.1), (0.0, 1.0)])
def test_a_fact_moves_by_a_share_of_the_margin_that_it_may_lose(now, size):
    # an order of 2 against 0.5, of which 1e-9 is uncertain: the margin is 1.5
    row = replace(ROW, kind="fact", values={"reference": 2.0}, difference=1.5, tolerance=1e-9)
    other = replace(row, values={"reference": 0.5 + now}, difference=now)
    assert move(row, other, perturbed=False) == pytest.approx(size, rel=1e-6)


def test_a_row_without_a_scale_takes_its_largest_number():
    row = replace(ROW, tolerance=None, scale=None, difference=None, values={"formula": 50.0})
    assert move(row, replace(row, values={"formula": 50.0005}), perturbed=False) == pytest.approx(1)


@pytest.mark.parametrize("value", [None, math.nan, math.inf])
def test_a_number_that_is_there_or_finite_on_one_machine_only_moves_without_bound(value):
    other = replace(ROW, values={**ROW.values, "reference": value}, difference=value)
    assert [(one.kind, one.move) for one in compared(other)] == [(Kind.VALUE, math.inf)]
    assert differences([other], [other], "there", perturbed=False) == []


def test_a_missing_row_and_an_additional_one_are_reported():
    (missing,) = differences(ROWS, ROWS[1:], "there", perturbed=False)
    assert (missing.kind, missing.row) == (Kind.MISSING, ROW.id)
    (added,) = differences(ROWS[1:], ROWS, "there", perturbed=False)
    assert (added.kind, added.row) == (Kind.ADDED, ROW.id)


def test_another_order_is_reported():
    (one,) = differences(ROWS, (ROWS[1], ROWS[0], *ROWS[2:]), "there", perturbed=False)
    assert (one.kind, one.was, one.now) == (Kind.ORDER, "ring/bore", "ring/rim")


def test_every_move_is_measured_however_small():
    (one,) = moves([ROW], [moved(0.02)], "there", perturbed=False)
    assert one.move == pytest.approx(0.02)


def test_a_partner_s_value_is_compared_too():
    row = Row(
        case="ring", quantity="bore", symbol="u", unit="mm", kind=RowKind.IDENTITY,
        status=Status.PASS, analytic=2.0, partner=Partner(by="series", value=2.0),
        tolerance=0.01,
    )  # fmt: skip
    other = replace(row, partner=Partner(by="series", value=2.002))
    assert move(record(row), record(other), perturbed=False) == pytest.approx(0.2)


def stated(text, tmp_path):
    path = tmp_path / "reasons.toml"
    path.write_text(text, "utf-8")
    return reasons.read(path)


ENTRY = """[[moves]]
rows = "ring/*"
kind = "{kind}"
why = "the residual is round-off, which differs"
"""


def test_a_reason_explains_values_of_its_kind_and_nothing_else(tmp_path):
    found = compared(moved(0.5)) + compared(replace(ROW, status="FAIL"))
    explained, unused = reasons.explained(found, stated(ENTRY.format(kind="identity"), tmp_path))
    assert [bool(one.reason) for one in explained] == [True, False]
    assert unused == []
    explained, unused = reasons.explained(found, stated(ENTRY.format(kind="exact"), tmp_path))
    assert not any(one.reason for one in explained)
    assert [reason.rows for reason in unused] == ["ring/*"]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[[moves]]\nrows = 'a'\nwhy = 'short'\n", r"moves\[1\]\.why"),
        ("[[moves]]\nrows = 'a'\n", r"moves\[1\]\.why"),
        ("[[moved]]\n", "moved: unknown key"),
        ("moves = 1\n", r"needs tables \[\[moves\]\]"),
        ("[[moves", "cannot be read"),
    ],
)
def test_a_wrong_file_of_reasons_is_refused(text, words, tmp_path):
    with pytest.raises(InputError, match=words):
        stated(text, tmp_path)


def test_the_project_s_own_reasons_are_readable():
    reasons.read()


def test_results_are_stored_whole_and_count_for_their_key_only(tmp_path):
    odd = replace(ROW, difference=math.nan, tolerance=None, reason="µ ≥ tan α")
    case = CaseRecord(rows=(ROW, odd), seconds=1.5, fixed=("ratio",))
    place = Place(Store(tmp_path), "there", "key")
    place.keep("ring", case)
    place.keep(MACHINE, {"numba": "host"})
    again = place.results()
    assert again.cases["ring"].rows[0] == ROW
    assert differences(case.rows[1:], again.cases["ring"].rows[1:], "x", perturbed=False) == []
    assert (again.cases["ring"].fixed, again.effective) == (("ratio",), {"numba": "host"})
    for other in (replace(place, key="another"), replace(place, variant="elsewhere")):
        assert other.results() == Results()
    place.store.store(KIND, "there", {"there key ring": b"3", "there key torn": b"{"})
    assert place.results().cases == {}
