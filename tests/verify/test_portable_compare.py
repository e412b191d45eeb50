"""What counts as a difference between two machines, on planted ones."""

import math
from dataclasses import replace

import pytest

from verify.audit.portable import reasons
from verify.audit.portable.compare import Kind, differences
from verify.audit.portable.moving import Record, move
from verify.core.inputs import InputError

ROW = Record(
    id="ring/bore", kind="identity", status="PASS", values={"formula": 2.0, "reference": 2.001},
    difference=-0.001, tolerance=0.01, scale=2.0,
)  # fmt: skip
# an order of 2 against 0.5, of which 1e-9 is uncertain: the margin is 1.5
FACT = replace(ROW, kind="fact", values={"reference": 2.0}, difference=1.5, tolerance=1e-9)
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


def test_a_status_that_differs_is_reported_with_both_reasons():
    (one,) = compared(replace(ROW, status="FAIL", reason="not converged"))
    assert (one.kind, one.row, one.variant) == (Kind.STATUS, ROW.id, "there")
    assert (one.was, one.now) == ("PASS", "FAIL (not converged)")


@pytest.mark.parametrize("by", [-0.2, 0.1 + 1e-6, 3.0])
def test_a_value_that_moves_by_more_than_a_tenth_of_the_tolerance_is_reported(by):
    (one,) = compared(moved(by))
    assert one.kind is Kind.VALUE
    assert one.move == pytest.approx(abs(by))
    assert compared(moved(0.1 - 1e-6)) == []


@pytest.mark.parametrize(
    ("was", "now", "size"),
    [
        # without a finite tolerance: shares of 1e-5 of the scale
        (replace(ROW, tolerance=math.nan), {"values": {**ROW.values, "reference": 7.0}}, 249950),
        (replace(ROW, values={}), {"difference": 0.001}, 0.2),
        (FACT, {"values": {"reference": 1.85}, "difference": 1.35}, 0.1),
        (FACT, {"values": {"reference": 0.5}, "difference": 0.0}, 1.0),
        (replace(ROW, values={"formula": math.nan}), {"values": {"formula": 2.0}}, math.inf),
        (replace(ROW, tolerance=None, scale=None, difference=None, values={"formula": 50.0}),
         {"values": {"formula": 50.0005}}, 1.0),
    ],
)  # fmt: skip
def test_the_size_of_a_move(was, now, size):
    assert move(was, replace(was, **now), perturbed=False) == pytest.approx(size, rel=1e-4)


@pytest.mark.parametrize(("tolerance", "words"), [(0.0201, "0.0201"), (0.0049, "0.0049"),
                                                  (None, "none")])  # fmt: skip
def test_another_tolerance_is_a_difference_with_both_in_words(tolerance, words):
    (one,) = compared(replace(ROW, tolerance=tolerance))
    assert (one.kind, one.move) == (Kind.VALUE, 0.0)
    assert one.was.endswith(", tolerance 0.01")
    assert one.now.endswith(f", tolerance {words}")


def test_a_tolerance_that_is_estimated_may_differ_by_a_factor_of_two():
    assert compared(replace(ROW, tolerance=0.0199)) == []
    assert compared(replace(ROW, tolerance=0.0051)) == []
    for U, kinds in ((0.14, []), (0.16, [Kind.VALUE])):  # a tenth of a fact's margin
        rows = [FACT], [replace(FACT, tolerance=U)]
        assert [one.kind for one in differences(*rows, "there", perturbed=False)] == kinds


def test_both_sides_that_move_alike_count_on_the_same_inputs_and_not_on_perturbed_ones():
    values = {name: value + 0.2 * ROW.tolerance for name, value in ROW.values.items()}
    together = replace(ROW, values=values)
    assert [one.kind for one in compared(together)] == [Kind.VALUE]
    alike = replace(together, values={n: v * (1 + 1e-7) for n, v in ROW.values.items()})
    assert compared(alike, perturbed=True) == []
    assert [one.kind for one in compared(moved(0.2), perturbed=True)] == [Kind.VALUE]


@pytest.mark.parametrize("value", [None, math.nan])
def test_a_number_that_is_there_or_finite_on_one_machine_only_moves_without_bound(value):
    other = replace(ROW, values={**ROW.values, "reference": value}, difference=value)
    assert [(one.kind, one.move) for one in compared(other)] == [(Kind.VALUE, math.inf)]
    assert differences([other], [other], "there", perturbed=False) == []


@pytest.mark.parametrize(
    ("here", "there", "kind", "words"),
    [
        (ROWS, ROWS[1:], Kind.MISSING, None),
        (ROWS[1:], ROWS, Kind.ADDED, None),
        (ROWS, (ROWS[1], ROWS[0], *ROWS[2:]), Kind.ORDER, ("ring/bore", "ring/rim")),
        (ROWS, (ROW, *ROWS), Kind.DUPLICATE, ("1 times", "2 times")),
    ],
)
def test_other_rows_are_reported(here, there, kind, words):
    (one,) = (o for o in differences(here, there, "x", perturbed=False) if o.kind is kind)
    if words:
        assert (one.was, one.now) == words
    else:
        assert one.row == ROW.id


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
        ("moves = 1\n", r"needs tables \[\[moves\]\]"),
        ("[[moves", "cannot be read"),
    ],
)
def test_a_wrong_file_of_reasons_is_refused(text, words, tmp_path):
    with pytest.raises(InputError, match=words):
        stated(text, tmp_path)
