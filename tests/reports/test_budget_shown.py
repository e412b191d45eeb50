"""Error budgets on the page, in the data of the PDF, in results.json and as a table."""

import csv
import io
import re
from dataclasses import replace

import jsonschema
import pytest

from reports.budget import (
    compact,
    headline,
    identities,
    left,
    lines,
    outside,
    percent,
    steps,
    waterfall,
)
from reports.budget_table import budget_csv
from reports.records import report_record
from tests.reports.conftest import section
from verify.core.results import BudgetJoint, BudgetPart, CaseBudget, Kind, RowBudget

ROW = RowBudget(
    quantity="K of <the> paper", symbol="K", kind=Kind.APPROXIMATION, total=-0.08, U=1e-3,
    parts=(
        BudgetPart(cause="discretisation", what="level 8 after 6", contribution=0.01, u=0.002),
        BudgetPart(cause="contact law", what="no contact in it", contribution=None, u=None,
                   note="no contact in it"),
        BudgetPart(cause="finite geometry", what="four times as many flats", contribution=-0.07,
                   u=1e-6),
        BudgetPart(cause="plane assumption", what="plane strain", contribution=0.09, u=1e-6,
                   shared=True),
    ),
    joints=(BudgetJoint(causes=("finite geometry: a", "small displacement: b"), value=0.003),),
    remainder=-0.02, u=0.002, headline=True,
)  # fmt: skip
SAME = replace(ROW, quantity="same", kind=Kind.IDENTITY, headline=False, within=True, joints=())
OTHER = replace(ROW, quantity="another", headline=False, joints=())
BUDGET = CaseBudget(
    case="polyhedral-ring", title="Ring", date="2026-11-23", seconds=12.5, rows=(ROW, OTHER, SAME)
)
MISSING = CaseBudget(
    case="ring-lame", title="Lamé",
    missing="not measured for the present code: run `freewheel deep budget:ring-lame`",
)  # fmt: skip


def test_bars_continue_the_difference_from_one_to_the_next_with_the_length_of_their_numbers():
    bars = steps(ROW)
    assert [bar.name for bar in bars] == [
        "difference", "discretisation", "finite geometry", "remainder"
    ]  # fmt: skip
    assert [(bar.start, bar.end) for bar in bars] == [
        (0, -8), (-8, pytest.approx(-9)), (pytest.approx(-9), pytest.approx(-2)),
        (0, pytest.approx(-2)),  # what the last part leaves is the remainder, drawn from zero
    ]  # fmt: skip
    svg = str(waterfall(ROW))
    found = re.findall(r'<rect class="(\w+)" x="([\d.]+)" y="[\d.]+" width="([\d.]+)"', svg)
    assert [css for css, *_ in found] == ["total", "part", "part", "rest"]
    (x, w), (x_1, w_1), (x_2, w_2), (_, w_3) = (tuple(map(float, one[1:])) for one in found)
    unit = w / 8.0  # of a per cent, of the bar of the difference
    assert [v / unit for v in (w_1, w_2, w_3)] == pytest.approx([1.0, 7.0, 2.0], abs=0.02)
    # the first part's bar ends to the left of the difference, where the next begins
    assert x_1 + w_1 == pytest.approx(x, abs=0.15)
    assert x_2 == pytest.approx(x_1, abs=0.15)
    assert "&lt;the&gt;" in svg


def test_lines_name_each_cause_and_what_is_not_subtracted_last():
    found = lines(ROW)
    assert found[0] == (
        "difference",
        "formula and finite elements, all causes included",
        "−8.00 ± 0.1 %",
    )
    assert ("contact law", "no contact in it", "–") in found
    assert ("finite geometry", "four times as many flats", "−7.00 ± 1·10⁻⁴ %") in found
    assert found[-2][::2] == ("remainder", "−2.00 ± 0.2 %")
    assert found[-1][1] == "plane strain (assumption of both sides, not part of the sum)"
    assert any(cause == "both causes" and label.startswith("+0.300 %") for cause, _, label in found)


def test_shares_have_as_many_digits_as_their_uncertainty_allows():
    for value, u, label in (
        (-0.24834, 3.6e-7, "−24.8 ± 4·10⁻⁵ %"), (0.0, None, "0 %"),
        (7.2e-8, 7e-8, "+7·10⁻⁶ ± 7·10⁻⁶ %"), (None, None, "–"),
        (0.00018, 1.2e-4, "+0.0180 ± 0.01 %"), (0.003, 9.96e-3, "+0.300 ± 1 %"),
        (9.9996, 0.2, "+1000 ± 20 %"), (-0.1596, 0.0, "−16.0 %"),
    ):  # fmt: skip
        assert percent(value, u) == label


def test_the_others_stand_side_by_side_and_identities_are_one_sentence():
    found = compact(BUDGET)
    assert found.header == ["numerical", "finite geometry"]
    assert [(row.quantity, cells) for row, cells in found.rows] == [
        ("another", ["+1.00 %", "−7.00 %"])
    ]
    assert (headline(BUDGET), compact(MISSING)) == (ROW, None)
    assert identities(BUDGET).startswith("For 1 of 1 identities")
    bad = replace(SAME, within=False)
    assert (outside(BUDGET), outside(replace(BUDGET, rows=(bad,)))) == ([], [bad])
    assert identities(replace(BUDGET, rows=(bad,))).startswith("For 0 of 1 identities")


def test_page_table_and_records_have_budgets_and_what_is_not_measured_or_decomposed(alone, schema):
    bad = replace(OTHER, apart=False, why="no rerun")
    rows = (ROW, bad, replace(bad, quantity="a third"), replace(bad, quantity="last", why=""))
    budget = replace(BUDGET, rows=rows)
    report = replace(alone, budgets=(budget, MISSING))
    text, notes = section(report, "budget"), left(budget)
    assert notes == (
        "The differences of these rows are not decomposed (no rerun): “another”; “a third”. The "
        "differences of these rows are not decomposed (no cause is known that would explain the "
        "difference): “last”."
    )
    assert left(BUDGET) == ""
    for words in (
        notes, "measured 2026-11-23",
        "Not measured for the present code: run `freewheel deep budget:ring-lame`.",
    ):  # fmt: skip
        assert words in text
    assert text.count("chart waterfall") == 1

    table = budget_csv(report.budgets)
    assert "not decomposed: no rerun" in table
    *mine, last = csv.DictReader(io.StringIO(table.removeprefix("\ufeff")))
    assert "not measured" in last["note"]
    mine = [row for row in mine if row["quantity"] == ROW.quantity]
    assert [row["part"] for row in mine] == [
        "difference", "discretisation", "contact law", "finite geometry", "plane assumption",
        "both causes", "remainder",
    ]  # fmt: skip
    total, *_, remainder = (float(row["contribution_relative"] or 0) for row in mine)
    counted = [float(row["contribution_relative"] or 0) for row in mine if row["counts"] == "yes"]
    assert total - sum(counted) == pytest.approx(remainder)

    record = report_record(report)["budgets"]
    own = schema["properties"]["budgets"] | {"$defs": schema["$defs"]}
    jsonschema.validate(record, own)
    record[0]["rows"][0]["parts"][0]["cause"] = "magic"
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(record, own)
